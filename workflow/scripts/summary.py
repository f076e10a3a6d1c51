"""Tables of all states, of all sheets and of their peaks."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import summary

    summary.run(
        metrics=list(snakemake.input.metrics),
        stability=list(snakemake.input.stability),
        output=dict(snakemake.output.items()),
    )
