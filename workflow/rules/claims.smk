rule claims:
    input:
        states=PATHS.pattern("summary"),
        stability=PATHS.pattern("summary_stability"),
        peaks=PATHS.pattern("summary_peaks"),
        materials=[PATHS.of("material", material=name) for name in sorted(STUDY.materials)],
    output:
        csv=report(
            PATHS.pattern("claims"),
            caption="../report/claims.rst",
            category=config_figures.TABLES,
            labels={"figure": "", "shows": "claims (CSV)"},
        ),
        page=report(
            PATHS.pattern("claims_page"),
            caption="../report/claims.rst",
            category=config_figures.TABLES,
            labels={"figure": "", "shows": "claims"},
        ),
        table=report(
            PATHS.pattern("claims_table"),
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
        sheet=list(astuple(STUDY.figure_sheet)),
        code=code("claims"),
    script:
        "../scripts/claims.py"
