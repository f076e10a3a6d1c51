"""Checks, tables and plots of one group of the verification."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from importlib import import_module

    module = import_module(f"verification.{snakemake.wildcards.group}")
    module.run(snakemake.output[0])
