"""Figures stage: one module per figure of the paper, one shared style.

A module has one function ``draw(inputs)`` that returns a matplotlib figure of whatever sheets and
states it is given. No point is drawn that was not computed or measured; a state that did
not converge is a gap. Importing this package loads no plotting library.
"""

from collections.abc import Sequence

# Name of each figure, numbered as in the paper, and the strains of the states that it shows: a
# sequence of wanted strains, "all", or () for a figure of tables only.
FIGURES: dict[str, tuple[float, ...] | str] = {
    "fig01_stress": (),
    "fig02_sheet": (0.0, 0.1, 0.2, 0.32, 0.46),
    "fig03_surface": (0.06, 0.12),
    "fig04_profiles": "all",
    "fig05_amplitude": (),
    "fig05_wavelength": (),
    "fig06_aspect": (),
    "fig06_thickness": (),
    "fig07_width": (),
    "fig07_confinement": (),
    "fig07_slaving": (),
    "fig07_collapse": (),
}

# Measured data that a figure lays over what is computed: see `study.measurements`.
MEASURED: dict[str, tuple[str, ...]] = {
    "fig01_stress": ("stress",),
    "fig04_profiles": ("profiles",),
    "fig05_amplitude": ("amplitude", "profiles"),
    "fig05_wavelength": ("wavelength", "profiles"),
    "fig06_aspect": ("amplitude", "profiles"),
    "fig06_thickness": ("amplitude", "profiles"),
    "fig07_confinement": ("profiles",),
    "fig07_slaving": ("profiles",),
    "fig07_collapse": ("profiles",),
}


def state_strains(name: str, available: Sequence[float]) -> list[float]:
    """Return the strains whose states a figure shows, out of those that a study has.

    For each strain that the paper shows the nearest one of the study is taken, once; a
    figure is labelled with what it shows. The undeformed sheet (strain 0) needs no state.

    Parameters
    ----------
    name : str
        Figure.
    available : sequence of float
        Strains of the study.

    Returns
    -------
    list of float
        Increasing; empty if the figure shows no state.

    Raises
    ------
    ValueError
        If there is no such figure.
    """
    wanted = FIGURES[_known(name)]
    if isinstance(wanted, str):
        return sorted(available)
    tensile = [strain for strain in wanted if strain > 0.0]
    if not available:
        return []
    return sorted({min(available, key=lambda one: (abs(one - want), one)) for want in tensile})


def _known(name: str) -> str:
    if name not in FIGURES:
        raise ValueError(f"figure {name!r}: must be one of {', '.join(FIGURES)}")
    return name
