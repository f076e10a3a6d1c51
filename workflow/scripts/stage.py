"""Run the stage of a rule: `run` gets named inputs and params under their names in the rule.

`output` is a path, or a mapping where the outputs have names. The first log is that of the job, the
others are the records of its outputs, in their order. Inputs without a name are only waited
for; `code` and `caption` are for Snakemake and the report.
"""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to
from wrinklestudy.stages.memory import no_garbage_collection
from wrinklestudy.stages.recording import recorded

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with no_garbage_collection(), log_to(snakemake.log[0]):
    from importlib import import_module

    stage = import_module(f"wrinklestudy.stages.{snakemake.rule}")
    inputs = {
        name: file if isinstance(file, str) else list(file)
        for name, file in snakemake.input.items()
    }
    params = {
        name: value for name, value in snakemake.params.items() if name not in ("code", "caption")
    }
    with recorded(
        snakemake.config["program"],
        snakemake.rule,
        dict(snakemake.params.items()),
        inputs,
        list(snakemake.output),
        list(snakemake.log)[1:],
    ):
        stage.run(**inputs, **params, output=dict(snakemake.output.items()) or snakemake.output[0])
