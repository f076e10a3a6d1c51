rule compression:
    input:
        material=material_of_model,
    output:
        PATHS.pattern("compression"),
    log:
        PATHS.log("compression"),
        *PATHS.records("compression"),
    benchmark:
        PATHS.benchmark("compression")
    threads: 1
    resources:
        mem_mb=1500,
    params:
        name=wildcard("material"),
        aspect=value("aspect"),
        mesh=STUDY.settings("mesh"),
        code=code("compression"),
    script:
        "../scripts/stage.py"
