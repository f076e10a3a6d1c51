"""Statements without a verdict: from memory only, or without a number that was read.

Each says what would have to be read, and shows what is computed here. A statement moves to
`studies.literature.claims` once it was read somewhere.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.literature import sources
from wrinklestudy.studies.literature.claims.lengths import TEN_TO_ONE
from wrinklestudy.studies.literature.claims.shapes import relative_force
from wrinklestudy.studies.literature.claims.strains import LONG, NAYYAR, THIN, birth_and_decay
from wrinklestudy.studies.literature.islands import HELD, largest_at
from wrinklestudy.studies.literature.statement import (
    Published,
    under_each_bending_law,
)
from wrinklestudy.studies.panaitescu2019.claims.dimensions import EARLIER_ISLAND
from wrinklestudy.study.claims.finding import Value
from wrinklestudy.study.claims.tables import StudyTables

OPEN = "open"


@dataclass(frozen=True)
class OpenStatement:
    """A statement that is not judged.

    Parameters
    ----------
    published : Published
    says : str
        What is stated, after the name of its source.
    why : str
        Why there is no verdict.
    compute : callable, optional
        What is computed here beside it.
    """

    published: Published
    says: str
    why: str
    compute: Callable[[StudyTables], tuple[Value, ...]] | None = None

    @property
    def text(self) -> str:
        """The statement with the name of its source."""
        return f"{self.published.source.name}: {self.says}"

    def values(self, study: StudyTables) -> tuple[Value, ...]:
        """Return what is computed here; nothing where the study lacks it."""
        try:
            return self.compute(study) if self.compute else ()
        except MissingError:
            return ()


def _nayyar(study: StudyTables) -> tuple[Value, ...]:
    return birth_and_decay(under_each_bending_law(study, "nayyar", LONG, THIN))


def _benchmark(study: StudyTables) -> tuple[Value, ...]:
    return birth_and_decay(under_each_bending_law(study, "gismo-nh", 2.0, THIN))


def _force(study: StudyTables) -> tuple[Value, ...]:
    force = relative_force(study)
    return (Value("largest relative difference of the force of both parities", force, digits=2),)


def _ratio(study: StudyTables) -> tuple[Value, ...]:
    highest = largest_at(study.table("map"), EARLIER_ISLAND)
    return tuple(
        Value(
            f"t/L at which the last L/W is {EARLIER_ISLAND:g}, {bending}",
            highest[model] / EARLIER_ISLAND,
        )
        for model, bending in TEN_TO_ONE.items()
        if model in highest
    )


_MEMORY = "from memory; to be read"

OPEN_STATEMENTS = (
    OpenStatement(
        replace(NAYYAR, where="a figure", reliability="M", said="flat beyond about 0.30"),
        "the sheet is flat again beyond a strain of about 0.3.",
        _MEMORY,
        _nayyar,
    ),
    OpenStatement(
        Published(
            source=sources.HEALEY_2013,
            where="abstract",
            reliability="M",
            said="an orbit of neutrally stable patterns",
            law="Saint Venant-Kirchhoff membrane; here Mooney-Rivlin C10 = 10 C01",
            aspect="here 2",
            thickness="here t/W = 1e-3",
        ),
        "wrinkles of both parities lie on one orbit of neutral equilibria, with one force.",
        f"{_MEMORY}; for critical strains a source that was read says the same (Martins et al. "
        "2020)",
        _force,
    ),
    OpenStatement(
        Published(
            source=sources.LI_2016,
            where="the paper",
            reliability="M",
            said=f"length and thickness held; t/L not known, here {HELD['t/L']:g}",
            law="four membranes, plate of Föppl and von Kármán",
            aspect="varied",
            thickness="t/L held",
        ),
        "boundaries are drawn for given length and thickness, over L/W and strain.",
        f"{_MEMORY}; that it is this t/L is inferred from the end of the range of L/W",
        _ratio,
    ),
    OpenStatement(
        Published(
            source=sources.CERDA_2002,
            where="a figure",
            reliability="M",
            said="polyethylene, L near 25 cm, ε near 0.10",
            law="polyethylene, an experiment",
            aspect="near 2.5",
            thickness="near t/W = 1e-3",
        ),
        "wavelength and amplitude of a polyethylene sheet follow the scaling laws.",
        f"{_MEMORY}: numbers of the experiment",
    ),
    OpenStatement(
        Published(
            source=sources.FRIEDL_2000,
            where="the paper",
            reliability="M",
            said="buckling coefficient over L/W and Poisson's ratio",
            law="Hookean",
            aspect="varied",
            thickness="any",
        ),
        "a buckling coefficient gives the critical stress over L/W and Poisson's ratio.",
        f"{_MEMORY}: no number is remembered safely",
    ),
    OpenStatement(
        Published(
            source=sources.SILVESTRE_2016,
            where="abstract",
            reliability="B",
            said="warping shear is a second cause",
            law="Hookean",
        ),
        "warping shear is a second cause of the compression, besides the Poisson effect.",
        "no computed number tells the two apart: without Poisson's contraction both are gone",
    ),
    OpenStatement(
        Published(
            source=sources.GISMO,
            where="benchmarks/benchmark_Wrinkling.cpp",
            reliability="A",
            said="no number; C10 = 191010.178 Pa",
            law="neo-Hookean",
            aspect="2",
            thickness="t/W = 1e-3",
            clamps="no displacement across, no slope",
        ),
        "the same sheet with a neo-Hookean law.",
        "a set-up; the numbers are in a figure that was not read",
        _benchmark,
    ),
)
