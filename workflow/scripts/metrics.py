"""Tables of all cases and of all sheets."""

from typing import TYPE_CHECKING

from wrinklestudy.joblog import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy import metrics

    metrics.run(
        wrinkle=list(snakemake.input.wrinkle),
        stability=list(snakemake.input.stability),
        output=snakemake.output.metrics,
        stability_output=snakemake.output.stability,
    )
