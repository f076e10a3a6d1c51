rule summary:
    input:
        metrics=all_sheets("metrics"),
        stability=all_sheets("stability"),
    output:
        states=PATHS.pattern("summary", "states"),
        stability=PATHS.pattern("summary", "stability"),
        peaks=report(
            PATHS.pattern("summary", "peaks"),
            caption="../report/peaks.rst",
            category=CATALOGUE.tables_part,
            labels={"figure": "", "shows": "peak of each sheet (CSV)"},
        ),
    log:
        PATHS.log("summary"),
        *PATHS.records("summary"),
    threads: 1
    resources:
        mem_mb=500,
    params:
        code=code("summary"),
    script:
        "../scripts/stage.py"
