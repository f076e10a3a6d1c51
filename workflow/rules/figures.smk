# Figures are drawn from the tables of the sheets that they show, from states, or from materials.
rule figures:
    input:
        unpack(inputs_of_figure),
    output:
        PATHS.figure(".pdf"),
        report(
            PATHS.figure(".png"),
            caption="../report/figures.rst",
            category=lambda wildcards: CATALOGUE.figure(wildcards.figure).part,
            labels=lambda wildcards: figure_contents.labels(CATALOGUE.figure(wildcards.figure)),
        ),
    log:
        PATHS.log("figures"),
    threads: 1
    resources:
        mem_mb=1000,
    params:
        study=STUDY.study,
        # for the caption
        caption=of_figure(figure_contents.caption_text),
        cases=of_figure(figure_contents.cases_text),
        mesh=of_figure(figure_contents.mesh_text),
        code=lambda wildcards: code_of_figure(wildcards.figure),
    script:
        "../scripts/figures.py"
