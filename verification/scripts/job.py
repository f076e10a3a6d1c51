"""Every job of the verification: ``run`` of the module that the rule names.

The function gets the named inputs and outputs of the rule as arguments.
"""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from importlib import import_module

    files = {**dict(snakemake.input.items()), **dict(snakemake.output.items())}
    import_module(snakemake.params.module).run(**files)
