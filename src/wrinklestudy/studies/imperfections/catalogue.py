"""What this study shows: how well an experiment must be set up, and what decides what it sees."""

from wrinklestudy.study.catalogue import Catalogue, FigureEntry, SectionEntry, TableEntry

_HERE = "wrinklestudy.studies.imperfections"
_PART = "Imperfections"

_FIGURES = (
    FigureEntry(
        name="tolerances",
        title="what clamps that are off and uneven rubber change",
        caption="Change of the amplitude and of the decay strain against the size of each "
        "imperfection, in units of W (shifts), radians (turns) or parts of the thickness. Filled: "
        "it grows; open: it falls. Amplitude of the envelope, at the smaller strain "
        "(solid) and the larger one (dashed). Grey lines: what an experiment can tell.",
        part=_PART,
        module=f"{_HERE}.figures.tolerances",
        analyses=("imperfection",),
    ),
)

_TABLES = (
    TableEntry(
        name="tolerances",
        title="How well clamps must be aligned and how even the rubber must be",
        caption="The size of each imperfection at which amplitude and decay strain change by what "
        "an experiment can tell.",
        module=f"{_HERE}.tables.tolerances",
    ),
    TableEntry(
        name="states",
        title="Every state",
        caption="State of each imperfect sheet at each strain.",
        module=f"{_HERE}.tables.states",
    ),
    TableEntry(
        name="windows",
        title="Strains with wrinkles",
        caption="Ranges of strain in which each imperfect sheet wrinkles.",
        module=f"{_HERE}.tables.windows",
    ),
    TableEntry(
        name="budget",
        title="Error of a measured decay strain",
        caption="What a measured decay strain is uncertain by.",
        module=f"{_HERE}.tables.budget",
    ),
)

_SECTIONS = (
    SectionEntry(
        number=1,
        title="1. Clamps and thickness",
        asked="How well must clamps be aligned, and how even must the rubber be, for an experiment "
        "to see the wrinkles of a perfect sheet?",
        figures=("tolerances",),
        tables=("tolerances", "states", "windows"),
    ),
    SectionEntry(
        number=2,
        title="2. Parity",
        asked="Antisymmetric and symmetric wrinkles of a perfect sheet have the same energy. Does "
        "an imperfection choose?",
    ),
    SectionEntry(
        number=3,
        title="3. Gravity",
        asked="What does the weight of a sheet change that is stretched level?",
    ),
    SectionEntry(
        number=4,
        title="4. Error of the decay strain",
        asked="How well can a measured decay strain agree with a computed one? Each imperfection "
        "at the size of a careful set-up, the rubber, and the steps between strains.",
        tables=("budget",),
    ),
)

CATALOGUE = Catalogue(
    name="imperfections",
    title="Imperfections: clamps, thickness and gravity",
    figures=_FIGURES,
    claims=f"{_HERE}.claims",
    tables=_TABLES,
    sections=_SECTIONS,
    tables_part=_PART,
)
