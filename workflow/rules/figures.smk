# Figures are drawn from the tables, from a few states, or (the first) from the materials.
rule figures:
    input:
        unpack(inputs_of_figure),
    output:
        PATHS.figure(".pdf"),
        PATHS.figure(".png"),
    log:
        PATHS.log("figures"),
    threads: 1
    resources:
        mem_mb=1000,
    params:
        code=lambda wildcards: code("figures", f"wrinklestudy.figures.{wildcards.figure}"),
    script:
        "../scripts/figures.py"
