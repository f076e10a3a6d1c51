rule wrinkle:
    input:
        planar=planar_of_case,
    output:
        PATHS.pattern("wrinkle"),
    log:
        PATHS.log("wrinkle"),
        *PATHS.records("wrinkle"),
    benchmark:
        PATHS.benchmark("wrinkle")
    threads: 1
    resources:
        mem_mb=1500,
    params:
        thickness=value("thickness"),
        settings=STUDY.settings("wrinkle"),
        code=code("wrinkle"),
    script:
        "../scripts/stage.py"
