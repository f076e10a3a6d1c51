# The study from measured stress-strain curves to figures. What is computed stands in config.yaml,
# how to compute it in src/wrinklestudy; here is only what depends on what.
from snakemake.utils import min_version

min_version("9.20")


configfile: "config.yaml"


include: "workflow/rules/common.smk"
include: "workflow/rules/material.smk"
include: "workflow/rules/mesh.smk"
include: "workflow/rules/planar.smk"
include: "workflow/rules/stability.smk"
include: "workflow/rules/wrinkle.smk"
include: "workflow/rules/metrics.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/gate.smk"


rule all:
    default_target: True
    input:
        all_figures(),
        PATHS.pattern("gate"),
