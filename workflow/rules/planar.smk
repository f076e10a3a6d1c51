rule planar:
    input:
        mesh=PATHS.pattern("mesh"),
        material=PATHS.pattern("material"),
    output:
        PATHS.pattern("planar"),
    log:
        PATHS.log("planar"),
    benchmark:
        PATHS.benchmark("planar")
    threads: 1
    resources:
        mem_mb=1500,
    params:
        strain=value("strain"),
        settings=STUDY.settings("planar"),
        code=code("planar"),
    script:
        "../scripts/planar.py"
