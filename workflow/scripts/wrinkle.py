"""Wrinkled equilibrium of one sheet at one strain."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import wrinkle

    wrinkle.run(
        planar=snakemake.input[0],
        thickness=snakemake.params.thickness,
        settings=snakemake.params.settings,
        output=snakemake.output[0],
    )
