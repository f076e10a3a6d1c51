"""What this study shows: a section for each question that the paper leaves open."""

from wrinklestudy.studies.beyond.selections import rubbers
from wrinklestudy.study.catalogue import Catalogue, FigureEntry, SectionEntry

_HERE = "wrinklestudy.studies.beyond"
_RUBBER = "7 The rubber"

_FIGURES = (
    FigureEntry(
        name="rubber",
        title="birth, decay and height against the constants of the rubber",
        caption="Left: the strains between which the sheet is wrinkled against C01/C10. "
        "Right: the same against Poisson's ratio. Below: the largest amplitude.",
        part=_RUBBER,
        module="wrinklestudy.studies.panaitescu2019.figures.fig05_amplitude",
        sheets=rubbers,
        constants=True,
    ),
)

_SECTIONS = (
    SectionEntry(
        number=7,
        title="How well the rubber must be known",
        asked="Birth, decay and largest amplitude against C01/C10 and Poisson's ratio, with the "
        "error of a uniaxial fit carried through; and the ratio that a measured decay strain "
        "tells.",
        figures=("rubber",),
    ),
)

CATALOGUE = Catalogue(
    name="beyond",
    title="Beyond the paper: thin sheets, other rubbers, other lengths",
    figures=_FIGURES,
    claims=f"{_HERE}.claims",
    sections=_SECTIONS,
    tables_part="9 Tables and claims",
)
