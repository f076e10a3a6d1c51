"""Law fitted to the measured stress-strain curve of one material."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import material

    material.run(
        csv=snakemake.input.csv,
        law=snakemake.params.law,
        name=snakemake.wildcards.material,
        stretch=snakemake.params.stretch,
        modes=snakemake.params.modes,
        output=snakemake.output[0],
    )
