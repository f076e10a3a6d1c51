# All strains of an imperfect sheet in one job, with the strains at which it begins and ends to wrinkle.
rule imperfection:
    input:
        unpack(thickness_table_of_imperfect),
        material=material_of_model,
    output:
        PATHS.pattern("imperfection"),
    log:
        PATHS.log("imperfection"),
        *PATHS.records("imperfection"),
    benchmark:
        PATHS.benchmark("imperfection")
    threads: 1
    resources:
        mem_mb=2500,
    params:
        name=wildcard("material"),
        aspect=value("aspect"),
        thickness=value("thickness"),
        strains=lambda wildcards: STUDY.imperfect_sheets[imperfect_of(wildcards)],
        symmetry=lambda wildcards: imperfect_of(wildcards).symmetry,
        given=lambda wildcards: imperfect_of(wildcards).given,
        mesh=STUDY.settings("mesh"),
        settings=settings("imperfection"),
        code=code("imperfection"),
    script:
        "../scripts/stage.py"
