rule claims:
    input:
        states=PATHS.pattern("summary", "states"),
        stability=PATHS.pattern("summary", "stability"),
        peaks=PATHS.pattern("summary", "peaks"),
        materials=[PATHS.of("material", material=name) for name in sorted(STUDY.materials)],
    output:
        csv=report(
            PATHS.pattern("claims", "csv"),
            caption="../report/claims.rst",
            category=config_figures.TABLES,
            labels={"figure": "", "shows": "claims (CSV)"},
        ),
        page=report(
            PATHS.pattern("claims", "page"),
            caption="../report/claims.rst",
            category=config_figures.TABLES,
            labels={"figure": "", "shows": "claims"},
        ),
        table=report(
            PATHS.pattern("claims", "table"),
            caption="../report/table1.rst",
            category=config_figures.TABLES,
            labels={"figure": "", "shows": "Table I with computed values (CSV)"},
        ),
    log:
        PATHS.log("claims"),
    threads: 1
    resources:
        mem_mb=500,
    params:
        sheet=astuple(STUDY.figure_sheet),
        code=code("claims"),
    script:
        "../scripts/stage.py"
