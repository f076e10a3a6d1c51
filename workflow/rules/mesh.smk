rule mesh:
    output:
        PATHS.pattern("mesh"),
    log:
        PATHS.log("mesh"),
        *PATHS.records("mesh"),
    threads: 1
    resources:
        mem_mb=500,
    params:
        aspect=value("aspect"),
        resolved=value("resolved"),
        settings=STUDY.settings("mesh"),
        code=code("mesh"),
    script:
        "../scripts/stage.py"
