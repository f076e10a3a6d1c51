"""Whether enough of the cases have converged."""

from typing import TYPE_CHECKING

from wrinklestudy.stages.log import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy.stages import gate

    gate.run(
        states=snakemake.input.states,
        allow_not_converged=snakemake.params.allow_not_converged,
        study=snakemake.params.study,
        output=snakemake.output[0],
    )
