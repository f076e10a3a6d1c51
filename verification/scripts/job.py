"""Whether all checks passed and all mutations were caught."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from verification import gate

    gate.run(
        groups=list(snakemake.input.groups),
        output=snakemake.output[0],
        mutations=snakemake.input.mutations,
    )
