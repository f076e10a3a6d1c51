"""The page of the verification."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from verification import page

    page.run(
        groups=list(snakemake.input.groups),
        mutations=snakemake.input.mutations,
        output=snakemake.output.page,
    )
