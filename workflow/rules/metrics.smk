rule metrics:
    input:
        wrinkle=wrinkle_of_sheet,
    output:
        PATHS.pattern("metrics"),
    log:
        PATHS.log("metrics"),
        *PATHS.records("metrics"),
    threads: 1
    resources:
        mem_mb=500,
    params:
        code=code("metrics"),
    script:
        "../scripts/stage.py"
