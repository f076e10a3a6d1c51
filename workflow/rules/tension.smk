# All strains in one job: they share the mesh.
rule tension:
    input:
        material=material_of_model,
    output:
        table=PATHS.pattern("tension"),
        fields=PATHS.pattern("tension", "fields"),
    log:
        PATHS.log("tension"),
        *PATHS.records("tension"),
    benchmark:
        PATHS.benchmark("tension")
    threads: 1
    resources:
        mem_mb=1500,
    params:
        name=wildcard("material"),
        aspect=value("aspect"),
        strains=strains_of("tension"),
        mesh=STUDY.settings("mesh"),
        code=code("tension"),
    script:
        "../scripts/stage.py"
