rule planar:
    input:
        mesh=PATHS.pattern("mesh"),
        material=material_of_model,
    output:
        PATHS.pattern("planar"),
    log:
        PATHS.log("planar"),
        *PATHS.records("planar"),
    benchmark:
        PATHS.benchmark("planar")
    threads: 1
    resources:
        mem_mb=1500,
    params:
        name=wildcard("material"),
        strain=value("strain"),
        settings=settings("planar"),
        code=code("planar"),
    script:
        "../scripts/stage.py"
