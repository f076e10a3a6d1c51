"""What is claimed against what is computed."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import claims

    claims.run(
        study=snakemake.params.study,
        states=snakemake.input.states,
        stability=snakemake.input.stability,
        peaks=snakemake.input.peaks,
        materials=list(snakemake.input.materials),
        sheet=tuple(snakemake.params.sheet),
        output=snakemake.output.csv,
        page=snakemake.output.page,
        tables=list(snakemake.output.tables),
    )
