"""What this study shows: a section for each question that the paper leaves open."""

from wrinklestudy.studies.beyond.selections import own_rubber, rubbers, same_length, thinnest
from wrinklestudy.study.catalogue import Catalogue, FigureEntry, SectionEntry, TableEntry

_HERE = "wrinklestudy.studies.beyond"
_FIELD = "1 Tension field"
_MAPS, _QUARTIC = "4 Maps", "8 Quartic coefficients"
_SCALES, _BIRTH, _RUBBER = "5 Wavelength and length", "6 Thresholds", "7 The rubber"

_FIGURES = (
    FigureEntry(
        name="thin_limit",
        title="hidden width of ever thinner sheets and of the tension field",
        caption="Left: Φ² against strain of the tension field, the sheet without thickness, and of "
        "sheets. Right: what the sheets lack of the field, against thickness; the line is "
        "proportional to t.",
        part=_FIELD,
        module=f"{_HERE}.figures.thin_limit",
        sheets=same_length,
        analyses=("tension",),
    ),
    FigureEntry(
        name="side_by_side",
        title="the wrinkled region of the tension field and of the thinnest sheet",
        caption="A quarter of the undeformed sheet, its centre at the lower left. Left: wrinkled "
        "region of the tension field (shaded) with its fibres, along which wrinkles run. Right: "
        "deflection of the thinnest sheet. The line in both is the edge of the field's region, "
        "where the excess of width is 1% of its largest.",
        part=_FIELD,
        module=f"{_HERE}.figures.side_by_side",
        strains=(0.1,),
        states_of=thinnest,
        analyses=("tension",),
    ),
    FigureEntry(
        name="field_curves",
        title="force, widths and hidden width on the way to the tension field",
        caption="Force, arc width and projected width of sheets relative to those of the tension "
        "field, over strain; and Φ² on lines across the sheet, from the centre to the clamp.",
        part=_FIELD,
        module=f"{_HERE}.figures.field_curves",
        sheets=same_length,
        strains=(0.12,),
        states_of=same_length,
        analyses=("tension",),
    ),
    FigureEntry(
        name="map_thickness",
        title="the thickest sheet that wrinkles, over strain and L/W",
        caption="Contours of the critical thickness τ₁/W: at each point sheets thinner than it "
        "wrinkle. Filled and open circles: the paper's sheets, wrinkled and flat, as computed. "
        "Stars: first and last L/W that wrinkles at t/W = 1e-3, between the L/W of the map.",
        part=_MAPS,
        module=f"{_HERE}.figures.map_thickness",
        analyses=("map",),
    ),
    FigureEntry(
        name="map_length",
        title="the same in units of the length",
        caption="Contours of τ₁/L. Published boundaries hold t/L in place of t/W, and long sheets "
        "are then thicker. Stars: first and last L/W that wrinkles at t/L = 5e-4.",
        part=_MAPS,
        module=f"{_HERE}.figures.map_length",
        analyses=("map",),
    ),
    FigureEntry(
        name="map_modes",
        title="the critical mode over strain and L/W",
        caption="For each model: crests and troughs across the width; the place along the sheet "
        "where the mode is largest, 0 at the centre and 0.5 at the clamp; and by how much the "
        "critical thicknesses of antisymmetric and symmetric wrinkles differ. Grey: no "
        "thickness wrinkles.",
        part=_MAPS,
        module=f"{_HERE}.figures.map_modes",
        analyses=("map",),
    ),
    FigureEntry(
        name="map_quartic",
        title="birth and decay, gradual or with a jump, over L/W and t/W",
        caption="The quartic coefficient g of small wrinkles along the boundary, at birth and at "
        "decay. Where g > 0 wrinkles grow and vanish gradually, where g < 0 with a jump. White: no "
        "wrinkles, or none that end on the map.",
        part=_QUARTIC,
        module=f"{_HERE}.figures.map_quartic",
        analyses=("map",),
    ),
    FigureEntry(
        name="scales",
        title="wavelength and length of the wrinkles against L/W",
        caption="Left: wavelength over 0.8 times that of Cerda and Mahadevan; within the band they "
        "agree to 10%. Right: length of the wrinkles at half of their height, on the undeformed "
        "sheet; open where there are two zones with lower wrinkles between, their lengths added. "
        "The power law goes through all filled points, the line through those of long sheets. "
        "Larger markers: larger strain.",
        part=_SCALES,
        module=f"{_HERE}.figures.scales",
        sheets=own_rubber,
    ),
    FigureEntry(
        name="birth",
        title="strain of birth against thickness",
        caption="Left: the strain at which wrinkles are born against t/W, on the mesh of the study "
        "and on finer ones, with the power law fitted at small strain. Right: the same over that "
        "power law.",
        part=_BIRTH,
        module=f"{_HERE}.figures.birth",
        sheets=same_length,
    ),
    FigureEntry(
        name="compression",
        title="the strain at which compression at the centre ends, as the thickness vanishes",
        caption="Left: the strain at which the centre of the flat sheet is compressed no more, "
        "against C01/C10; the thinnest sheets have no wrinkles there beyond it. Bars: what half "
        "the cells in each direction and half the strains change, added. Bands: between these "
        "ratios the end goes to infinity, in all strains that were looked at. Right: how much the "
        "natural width exceeds the actual one at the centre; compressed above zero.",
        part=_BIRTH,
        module=f"{_HERE}.figures.compression",
        analyses=("compression",),
        constants=True,
    ),
    FigureEntry(
        name="rubber",
        title="birth, decay and height against the constants of the rubber",
        caption="Left: birth and decay strain and largest amplitude against C01/C10, with the "
        "curves through computed ratios, ratios left out of them (open), the ratios that two fits "
        "to one rubber allow, and a measured decay strain of the paper's sheet with its error. "
        "Right: the same for Saint Venant-Kirchhoff sheets against Poisson's ratio.",
        part=_RUBBER,
        module=f"{_HERE}.figures.rubber",
        sheets=rubbers,
        constants=True,
    ),
)

_TABLES = (
    TableEntry(
        name="tips",
        title="First and last L/W that wrinkles",
        caption="Tips of the islands of each model at fixed t/W and at fixed t/L.",
        module=f"{_HERE}.tables.tips",
    ),
    TableEntry(
        name="scales",
        title="Wavelength and length of every wrinkled state",
        caption="Wavelength and length of the wrinkles in both coordinates.",
        module=f"{_HERE}.tables.scales",
    ),
    TableEntry(
        name="birth",
        title="Strain of birth against thickness",
        caption="Critical thickness at small strains.",
        module=f"{_HERE}.tables.birth",
    ),
    TableEntry(
        name="compression",
        title="Where compression at the centre ends",
        caption="Strain at which the centre of the flat sheet is compressed no more.",
        module=f"{_HERE}.tables.compression",
    ),
    TableEntry(
        name="rubber",
        title="Birth, decay and height of each rubber",
        caption="Birth, decay and largest amplitude against the constants of the rubber.",
        module=f"{_HERE}.tables.rubber",
    ),
)

_SECTIONS = (
    SectionEntry(
        number=1,
        title="1. Tension field theory",
        asked="What does tension field theory say of the clamped sheet, where wrinkles cost "
        "nothing?",
        figures=(),
        tables=(),
    ),
    SectionEntry(
        number=2,
        title="2. The thin limit",
        asked="How do sheets come to the tension field as they get thinner?",
        figures=("thin_limit", "side_by_side", "field_curves"),
        tables=(),
    ),
    SectionEntry(
        number=4,
        title="4. Maps of the critical thickness",
        asked="Which sheets wrinkle at some strain, and with which mode? At a strain and L/W, "
        "sheets thinner than the critical thickness τ₁ wrinkle; a map of it serves all "
        "thicknesses. The first and last L/W at which sheets of one thickness wrinkle are the "
        "tips of an island, which differ with the ratio held, t/W or t/L.",
        figures=("map_thickness", "map_length", "map_modes"),
        tables=("tips",),
    ),
    SectionEntry(
        number=5,
        title="5. Wavelength and length of the wrinkles",
        asked="How do the wavelength λ and the length l of the wrinkles along the pull depend on "
        "thickness, strain and length of the sheet? l is the length over which the wrinkles are "
        "above half of their height.",
        figures=("scales",),
        tables=("scales",),
    ),
    SectionEntry(
        number=6,
        title="6. Thresholds of thin sheets",
        asked="How does the strain of birth vanish with the thickness? And up to which strain do "
        "the thinnest sheets wrinkle?",
        figures=("birth", "compression"),
        tables=("birth", "compression"),
    ),
    SectionEntry(
        number=7,
        title="7. How well the rubber must be known",
        asked="Birth, decay and largest amplitude against C01/C10 and Poisson's ratio, with the "
        "error of a uniaxial fit carried through; and the ratio that a measured decay strain "
        "tells.",
        figures=("rubber",),
        tables=("rubber",),
    ),
    SectionEntry(
        number=8,
        title="8. Quartic coefficients",
        asked="Do wrinkles grow from nothing and shrink to nothing, or do they jump, along the "
        "boundary of stability?",
        figures=("map_quartic",),
    ),
)

CATALOGUE = Catalogue(
    name="beyond",
    title="Beyond the paper: thin sheets, other rubbers, other lengths",
    figures=_FIGURES,
    claims=f"{_HERE}.claims",
    tables=_TABLES,
    sections=_SECTIONS,
    tables_part="9 Tables and claims",
)
