rule claims:
    input:
        unpack(tables_of_analyses),
        states=PATHS.pattern("summary", "states"),
        stability=PATHS.pattern("summary", "stability"),
        peaks=PATHS.pattern("summary", "peaks"),
        materials=[PATHS.of("material", material=name) for name in sorted(STUDY.materials)],
    output:
        csv=report(
            PATHS.pattern("claims", "csv"),
            caption="../report/claims.rst",
            category=CATALOGUE.tables_part,
            labels={"figure": "", "shows": "claims (CSV)"},
        ),
        page=report(
            PATHS.pattern("claims", "page"),
            caption="../report/claims.rst",
            category=CATALOGUE.tables_part,
            labels={"figure": "", "shows": "claims"},
        ),
        markdown=PATHS.pattern("claims", "markdown"),
        tables=[
            report(
                filled(PATHS.pattern("claims", "tables"), {"table": entry.name}),
                caption="../report/tables.rst",
                category=CATALOGUE.tables_part,
                labels={"figure": "", "shows": f"{entry.title} (CSV)"},
            )
            for entry in CATALOGUE.tables
        ],
    log:
        PATHS.log("claims"),
        *[PATHS.record(file) for file in plan.files_of(STUDY, PATHS, "claims")],
    threads: 1
    resources:
        mem_mb=500,
    params:
        study=STUDY.study,
        sheet=astuple(STUDY.figure_sheet),
        # captions of the further tables
        caption=[entry.caption for entry in CATALOGUE.tables],
        code=code_of_claims(),
    script:
        "../scripts/stage.py"
