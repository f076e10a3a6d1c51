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
            category=CATALOGUE.tables_part,
            labels={"figure": "", "shows": "claims (CSV)"},
        ),
        page=report(
            PATHS.pattern("claims_page"),
            caption="../report/claims.rst",
            category=CATALOGUE.tables_part,
            labels={"figure": "", "shows": "claims"},
        ),
        tables=[
            report(
                PATHS.of("claims_table", table=entry.name),
                caption="../report/tables.rst",
                category=CATALOGUE.tables_part,
                labels={"figure": "", "shows": f"{entry.title} (CSV)"},
            )
            for entry in CATALOGUE.tables
        ],
    log:
        PATHS.log("claims"),
    threads: 1
    resources:
        mem_mb=500,
    params:
        study=STUDY.study,
        # for the caption
        captions=[entry.caption for entry in CATALOGUE.tables],
        sheet=list(astuple(STUDY.figure_sheet)),
        code=code_of_claims(),
    script:
        "../scripts/claims.py"
