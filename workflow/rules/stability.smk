rule stability:
    input:
        planar=planar_of_sheet,
        mesh=mesh_of_sheet,
        material=material_of_model,
    output:
        PATHS.pattern("stability"),
    log:
        PATHS.log("stability"),
        *PATHS.records("stability"),
    benchmark:
        PATHS.benchmark("stability")
    threads: 1
    resources:
        mem_mb=1500,
    params:
        name=wildcard("material"),
        thickness=value("thickness"),
        settings=settings("stability"),
        code=code("stability"),
    script:
        "../scripts/stage.py"
