rule metrics:
    input:
        wrinkle=[PATHS.wrinkle(case) for case in CASES],
        stability=[PATHS.stability(sheet) for sheet in SHEETS],
    output:
        metrics=PATHS.pattern("metrics"),
        stability=PATHS.pattern("metrics_stability"),
    log:
        PATHS.log("metrics"),
    threads: 1
    resources:
        mem_mb=500,
    params:
        code=code("metrics"),
    script:
        "../scripts/metrics.py"
