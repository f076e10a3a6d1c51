# Figures are drawn from the tables of the sheets that they show, from states, or from materials.
rule figures:
    input:
        unpack(inputs_of_figure),
    output:
        pdf=PATHS.pattern("figures", "pdf"),
        png=report(
            PATHS.pattern("figures", "png"),
            caption="../report/figures.rst",
            category=lambda wildcards: CATALOGUE.figure(wildcards.figure).part,
            labels=lambda wildcards: figure_contents.labels(CATALOGUE.figure(wildcards.figure)),
        ),
        csv=PATHS.pattern("figures", "csv"),
    log:
        PATHS.log("figures"),
        *PATHS.records("figures"),
    threads: 1
    resources:
        mem_mb=1000,
    params:
        study=STUDY.study,
        name=wildcard("figure"),
        caption=of_figure(
            lambda *shown: {
                "text": figure_contents.caption_text(*shown),
                "cases": figure_contents.cases_text(*shown),
                "mesh": figure_contents.mesh_text(*shown),
            }
        ),
        code=lambda wildcards: code_of_figure(wildcards.figure),
    script:
        "../scripts/stage.py"
