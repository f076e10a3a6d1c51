"""One figure of the study, in each of its formats."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import figures

    figures.run(
        study=snakemake.params.study,
        name=snakemake.wildcards.figure,
        metrics=list(snakemake.input.metrics),
        stability=list(snakemake.input.stability),
        materials=list(snakemake.input.materials),
        states=list(snakemake.input.states),
        data=list(snakemake.input.data),
        experiment=list(snakemake.input.experiment),
        output=list(snakemake.output),
    )
