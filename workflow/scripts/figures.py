"""One figure of the paper, in each of its formats."""

from typing import TYPE_CHECKING

from wrinklestudy.joblog import log_to

if TYPE_CHECKING:
    from snakemake.iocontainers import snakemake

with log_to(snakemake.log[0]):
    from wrinklestudy import figures

    figures.run(
        name=snakemake.wildcards.figure,
        metrics=snakemake.input.get("metrics", ""),
        stability=snakemake.input.get("stability", ""),
        materials=snakemake.input.get("materials", []),
        states=snakemake.input.get("states", []),
        data=snakemake.input.get("data", []),
        output=list(snakemake.output),
    )
