"""Mesh of the sheets of one L/W and design thickness."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import mesh

    mesh.run(
        aspect=snakemake.params.aspect,
        resolved=snakemake.params.resolved,
        settings=snakemake.params.settings,
        output=snakemake.output[0],
    )
