"""What this study shows: statements of others by subject, each beside what is computed here."""

from wrinklestudy.studies.literature.membranes import membranes
from wrinklestudy.study.catalogue import Catalogue, FigureEntry, SectionEntry, TableEntry

_HERE = "wrinklestudy.studies.literature"

_FIGURES = (
    FigureEntry(
        name="membranes",
        title="amplitude with small and with finite strain in the plane",
        caption="Amplitude over thickness against strain of one sheet, bending law fvk: with the "
        "membrane of Föppl and von Kármán, whose strain is small, it grows with every strain; "
        "with finite strain wrinkles vanish.",
        part="1 Small and finite strain",
        module=f"{_HERE}.figures.membranes",
        sheets=membranes,
    ),
    FigureEntry(
        name="lengths",
        title="which lengths wrinkle, with t/W held and with t/L held",
        caption="Inside its line a model wrinkles. Left: width and thickness are held while the "
        "length varies. Right: length and thickness are held while the width varies, as in "
        "published boundaries; which t/L these have is inferred.",
        part="2 Lengths",
        module=f"{_HERE}.figures.lengths",
        analyses=("map",),
    ),
)

_TABLES = (
    TableEntry(
        name="statements",
        title="Statements",
        caption="Published statements with their sources, what is computed here, and verdicts.",
        module=f"{_HERE}.tables.statements",
    ),
    TableEntry(
        name="sources",
        title="Sources",
        caption="The sources of the statements, and how each is known.",
        module=f"{_HERE}.tables.sources",
    ),
)

_SECTIONS = (
    SectionEntry(
        number=1,
        title="1. Birth, height and decay",
        asked="At which strains do wrinkles come, are they highest, and go?",
    ),
    SectionEntry(
        number=2,
        title="2. Small and finite strain in the plane",
        asked="Why do wrinkles vanish at all? In 2013 the field learned that it takes finite "
        "strain in the plane: with the small strain of Föppl and von Kármán they grow without "
        "end.",
        figures=("membranes",),
    ),
    SectionEntry(
        number=3,
        title="3. Which lengths wrinkle",
        asked="Published boundaries hold length and thickness; experiments hold width and "
        "thickness. Inferred: the t/L of the boundaries. Computed: everything else.",
        figures=("lengths",),
    ),
    SectionEntry(
        number=4,
        title="4. The critical stretch",
        asked="From which stretch on do sheets of a length wrinkle?",
    ),
    SectionEntry(
        number=5,
        title="5. Shape and cause",
        asked="Wavelength, parity, and what compresses the sheet.",
    ),
    SectionEntry(
        number=6,
        title="6. Other codes",
        asked="Benchmarks and examples whose set-up, or whose numbers, are public.",
    ),
    SectionEntry(
        number=7,
        title="7. All statements",
        asked="Verdicts follow from the computed numbers by the rule of each statement.",
        tables=("statements", "sources"),
    ),
)

CATALOGUE = Catalogue(
    name="literature",
    title="What others published",
    figures=_FIGURES,
    claims=f"{_HERE}.claims",
    tables=_TABLES,
    sections=_SECTIONS,
    tables_part="3 Statements",
)
