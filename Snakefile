# The study from measured stress-strain curves to figures and claims. What to compute is in
# config.yaml, how to compute it in src/wrinklestudy; the rules say what depends on what.
from snakemake.utils import min_version

min_version("9.20")


configfile: "config.yaml"


report: "workflow/report/study.rst"


include: "workflow/rules/common.smk"


for stage in STAGES:

    include: f"workflow/rules/{stage}.smk"


rule all:
    default_target: True
    input:
        all_targets,


# Snakemake 9 limits the jobs per second by default, and then every job that ends leaves a timer
# that wakes the scheduler every second until the end; no option turns that off, and a longer time
# span keeps Snakemake from ending. For 300 jobs of 0.6 s on two cores, it takes 10 s of CPU with the
# timers, 3 s without (Snakemake 9.27).
onstart:
    if (
        workflow.local_exec
        and getattr(workflow.scheduler, "job_rate_limiter", None) is not None
    ):
        workflow.scheduler.job_rate_limiter = None


# After all that Snakemake says: what it means.
onerror:
    print(reason_of_stop(log), file=sys.stderr)
