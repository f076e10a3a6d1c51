"""Flat state of one model, L/W and strain, with its critical thicknesses."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import planar

    planar.run(
        mesh=snakemake.input.mesh,
        material=snakemake.input.material,
        strain=snakemake.params.strain,
        settings=snakemake.params.settings,
        output=snakemake.output[0],
        name=snakemake.wildcards.material,
    )
