"""Table of the states of one sheet."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import metrics

    metrics.run(wrinkle=list(snakemake.input), output=snakemake.output[0])
