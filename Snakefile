# The study from measured stress-strain curves to figures and claims. What is computed stands in
# config.yaml, how to compute it in src/wrinklestudy; here is only what depends on what.
from snakemake.utils import min_version

min_version("9.20")


configfile: "config.yaml"


report: "workflow/report/study.rst"


include: "workflow/rules/common.smk"
include: "workflow/rules/material.smk"
include: "workflow/rules/mesh.smk"
include: "workflow/rules/planar.smk"
include: "workflow/rules/stability.smk"
include: "workflow/rules/wrinkle.smk"
include: "workflow/rules/metrics.smk"
include: "workflow/rules/summary.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/claims.smk"
include: "workflow/rules/gate.smk"


rule all:
    default_target: True
    input:
        targets,


# Snakemake 9 limits the jobs per second by default, and then every job that ends leaves a timer
# that wakes the scheduler each second up to the end: with hundreds of jobs, a core does little else.
onstart:
    if workflow.local_exec:
        workflow.scheduler.job_rate_limiter = None
