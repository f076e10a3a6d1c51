"""What this study shows: the figures of the paper that can be computed, the claims, Table I."""

from wrinklestudy.study.catalogue import Catalogue, FigureEntry, TableEntry
from wrinklestudy.study.selections import (
    compared_models,
    figure_sheet,
    figure_sheet_then_lengths,
    same_aspect,
    same_but_one,
    same_thickness,
)

_HERE = "wrinklestudy.studies.panaitescu2019"
_MATERIAL, _WRINKLES = "1 Material", "2 Wrinkles"
_SIZES, _FAR = "3 Aspect and thickness", "4 Far from threshold"

_FIGURES = (
    FigureEntry(
        name="fig01_stress",
        panel="1",
        title="stress",
        caption="Nominal stress over initial Young's modulus against strain: the fitted laws and "
        "the measurements that they are fitted to.",
        part=_MATERIAL,
        module=f"{_HERE}.figures.fig01_stress",
        materials=True,
        measured=("stress",),
    ),
    FigureEntry(
        name="fig02_sheet",
        panel="2",
        title="sheet from above",
        caption="The sheet from above, lit from the side, in its true deformed shape.",
        part=_WRINKLES,
        module=f"{_HERE}.figures.fig02_sheet",
        strains=(0.0, 0.1, 0.2, 0.32, 0.46),
    ),
    FigureEntry(
        name="fig03_surface",
        panel="3c",
        title="surface",
        caption="Deflection of the whole sheet in units of W.",
        part=_WRINKLES,
        module=f"{_HERE}.figures.fig03_surface",
        strains=(0.06, 0.12),
    ),
    FigureEntry(
        name="fig04_profiles",
        panel="4b",
        title="profiles",
        caption="Deflection half-way between the clamps; each profile is shifted by its strain.",
        part=_WRINKLES,
        module=f"{_HERE}.figures.fig04_profiles",
        strains="all",
        measured=("profiles",),
    ),
    FigureEntry(
        name="fig05_amplitude",
        panel="5a",
        title="amplitude",
        caption="Amplitude over thickness against strain. Birth and decay of the wrinkles come "
        "from the eigenproblem of the flat sheet.",
        part=_WRINKLES,
        module=f"{_HERE}.figures.fig05_amplitude",
        sheets=compared_models,
        measured=("amplitude", "profiles"),
    ),
    FigureEntry(
        name="fig05_wavelength",
        panel="5b",
        title="wavelength",
        caption="Wavelength over width against strain.",
        part=_WRINKLES,
        module=f"{_HERE}.figures.fig05_wavelength",
        sheets=compared_models,
        measured=("wavelength", "profiles"),
    ),
    FigureEntry(
        name="fig05_page",
        panel="5",
        title="amplitude and wavelength",
        caption="Figure 5 whole: (a) amplitude over thickness and (b) wavelength over width "
        "against strain.",
        part=_WRINKLES,
        module=f"{_HERE}.figures.fig05_page",
        sheets=compared_models,
        measured=("amplitude", "wavelength", "profiles"),
    ),
    FigureEntry(
        name="fig06_aspect",
        panel="6a",
        title="amplitude against L/W",
        caption="The largest amplitude over strain against L/W, and the amplitude curves.",
        part=_SIZES,
        module=f"{_HERE}.figures.fig06_aspect",
        sheets=same_thickness,
        measured=("amplitude", "profiles"),
    ),
    FigureEntry(
        name="fig06_thickness",
        panel="6b",
        title="amplitude against W/t",
        caption="The largest amplitude over strain against W/t, and the amplitude curves.",
        part=_SIZES,
        module=f"{_HERE}.figures.fig06_thickness",
        sheets=same_aspect,
        measured=("amplitude", "profiles"),
    ),
    FigureEntry(
        name="fig06_labelled",
        panel="6, labelled",
        title="amplitude of all sheets",
        caption="A second form of figure 6: amplitude against strain, every curve with its "
        "label beside it.",
        part=_SIZES,
        module=f"{_HERE}.figures.fig06_labelled",
        sheets=same_but_one,
    ),
    FigureEntry(
        name="fig06_page",
        panel="6",
        title="amplitude against L/W and W/t",
        caption="Figure 6 whole: the largest amplitude over strain against (a) L/W and (b) W/t, "
        "each beside the amplitude curves.",
        part=_SIZES,
        module=f"{_HERE}.figures.fig06_page",
        sheets=same_but_one,
        measured=("amplitude", "profiles"),
    ),
    FigureEntry(
        name="fig07_width",
        panel="7a",
        title="width",
        caption="Arc width half-way between the clamps against strain.",
        part=_FAR,
        module=f"{_HERE}.figures.fig07_width",
        sheets=figure_sheet,
    ),
    FigureEntry(
        name="fig07_confinement",
        panel="7b",
        title="confinement",
        caption="Confinement, the excess of arc width over projected width, against strain.",
        part=_FAR,
        module=f"{_HERE}.figures.fig07_confinement",
        sheets=figure_sheet,
        measured=("profiles",),
    ),
    FigureEntry(
        name="fig07_slaving",
        panel="7c",
        title="slaving",
        caption="Amplitude against wavelength times square root of the confinement; arrows point "
        "along increasing strain.",
        part=_FAR,
        module=f"{_HERE}.figures.fig07_slaving",
        sheets=figure_sheet,
        measured=("profiles",),
    ),
    FigureEntry(
        name="fig07_collapse",
        panel="7d",
        title="collapse",
        caption="Amplitude against wavelength times square root of the confinement for every "
        "aspect of the study.",
        part=_FAR,
        module=f"{_HERE}.figures.fig07_collapse",
        sheets=same_thickness,
        measured=("profiles",),
    ),
    FigureEntry(
        name="fig07_page",
        panel="7",
        title="far from threshold",
        caption="Figure 7 whole, against strain: (a) arc width half-way between the clamps and "
        "(b) confinement; (c) amplitude against wavelength times square root of the confinement, "
        "and (d) the same for every aspect of the study.",
        part=_FAR,
        module=f"{_HERE}.figures.fig07_page",
        sheets=figure_sheet_then_lengths,
        measured=("profiles",),
    ),
)

CATALOGUE = Catalogue(
    name="panaitescu2019",
    title="Birth and decay of tensional wrinkles in hyperelastic sheets",
    citation="A. Panaitescu, M. Xin, B. Davidovitch, J. Chopin, A. Kudrolli, Phys. Rev. E 100, "
    "053003 (2019).",
    figures=_FIGURES,
    claims=f"{_HERE}.claims",
    tables=(
        TableEntry(
            name="table1",
            title="Table I with computed values",
            caption="Table I of the paper with the computed values beside it.",
            module=f"{_HERE}.table1",
        ),
    ),
    tables_part="5 Tables and claims",
)
