"""Mutations of the code, and which checks catch them."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from verification import mutations

    mutations.run(snakemake.output[0])
