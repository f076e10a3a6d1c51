rule material:
    input:
        unpack(data_of_material),
    output:
        PATHS.pattern("material"),
    log:
        PATHS.log("material"),
        *PATHS.records("material"),
    wildcard_constraints:
        material="|".join(map(re.escape, STUDY.materials)),
    threads: 1
    resources:
        mem_mb=500,
    params:
        name=wildcard("material"),
        law=material_setting("law"),
        constants=material_setting("constants"),
        stretch=material_setting("stretch"),
        modes=material_setting("modes"),
        branch=material_setting("branch"),
        cycle=material_setting("cycle"),
        preload=material_setting("preload"),
        code=code("material"),
    script:
        "../scripts/stage.py"
