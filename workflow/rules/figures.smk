# Figures are drawn from the tables of the sheets that they show, from states, or from materials.
rule figures:
    input:
        unpack(inputs_of_figure),
    output:
        pdf=PATHS.pattern("figures", "pdf"),
        png=report(
            PATHS.pattern("figures", "png"),
            caption="../report/figures.rst",
            category=lambda wildcards: config_figures.CONTENTS[wildcards.figure].part,
            labels=lambda wildcards: config_figures.labels(wildcards.figure),
        ),
    log:
        PATHS.log("figures"),
    threads: 1
    resources:
        mem_mb=1000,
    params:
        name=wildcard("figure"),
        caption=of_figure(
            lambda *shown: {
                "cases": config_figures.cases_text(*shown),
                "mesh": config_figures.mesh_text(*shown),
            }
        ),
        code=lambda wildcards: code(
            "figures", f"wrinklestudy.studies.panaitescu2019.figures.{wildcards.figure}"
        ),
    script:
        "../scripts/stage.py"
