"""Birth and decay strain of one sheet."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import stability

    stability.run(
        planar=list(snakemake.input.planar),
        mesh=snakemake.input.mesh,
        material=snakemake.input.material,
        thickness=snakemake.params.thickness,
        settings=snakemake.params.settings,
        output=snakemake.output[0],
        name=snakemake.wildcards.material,
    )
