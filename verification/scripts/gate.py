"""Whether all checks passed and all mutations were caught."""

from typing import TYPE_CHECKING

from wrinklestudy.joblog import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.verification import gate

    gate.run(
        groups=list(snakemake.input.groups),
        output=snakemake.output[0],
        mutations=snakemake.input.mutations,
    )
