# All strains in one job: each flat state starts from those before it.
rule map:
    input:
        material=material_of_model,
    output:
        table=PATHS.pattern("map"),
    log:
        PATHS.log("map"),
        *PATHS.records("map"),
    benchmark:
        PATHS.benchmark("map")
    threads: 1
    resources:
        mem_mb=1500,
    params:
        name=wildcard("material"),
        aspect=value("aspect"),
        strains=strains_of("map"),
        mesh=STUDY.settings("mesh"),
        settings=settings("map"),
        code=code("map"),
    script:
        "../scripts/stage.py"
