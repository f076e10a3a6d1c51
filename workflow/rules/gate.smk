# Last of all, so that the figures are there when it fails.
rule gate:
    input:
        plan.wanted_files(STUDY, PATHS),  # to be there when it fails
        states=PATHS.pattern("summary", "states"),
    output:
        PATHS.pattern("gate"),
    log:
        PATHS.log("gate"),
        *PATHS.records("gate"),
    threads: 1
    resources:
        mem_mb=200,
    params:
        study=study_digest(),
        allow_not_converged=STUDY.gate.allow_not_converged,
        code=code("gate"),
    script:
        "../scripts/stage.py"
