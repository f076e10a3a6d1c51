"""Item 8: whether wrinkles are born and vanish gradually or with a jump."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.beyond import maps
from wrinklestudy.study.claims.finding import Finding, Value, claim, verdict_across, verdict_of
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.study.figures import strain_map
from wrinklestudy.typing import Array, Mask

LOW = 0.1  # of (tau_1/t)^2 - 1: low wrinkles
HEIGHT = 0.02  # of their height
_READING = (
    f"Sheets of t/W = {maps.THICKNESSES[0]:g} to {maps.THICKNESSES[-1]:g} on the maps, "
    "antisymmetric wrinkles. With (A/t)² = ((τ₁/t)² - 1)/(2 g), A the largest height over the "
    "sheet, wrinkles grow gradually where g > 0. g is interpolated in strain; the part of bending "
    "in it, smaller by the square of t over the wavelength, is left out."
)


@dataclass(frozen=True, eq=False)
class Coefficients:
    """g of one model along one end of the range of wrinkles, NaN where there is none.

    Parameters
    ----------
    aspects : ndarray, shape (n,)
    values : ndarray, shape (m, n)
        For `maps.THICKNESSES`.
    """

    aspects: Array
    values: Array

    @property
    def known(self) -> Array:
        """The coefficients that are known."""
        return np.asarray(self.values[np.isfinite(self.values)])

    def place(self, k: int) -> str:
        """Return in words where a coefficient, counted over all, belongs."""
        row, column = np.unravel_index(k, self.values.shape)
        return f"L/W = {self.aspects[column]:g}, t/W = {maps.THICKNESSES[row]:.2g}"


def coefficients(study: StudyTables, end: int) -> dict[str, Coefficients]:
    """Return g by model at birth (end 0) or at decay (1).

    Raises
    ------
    MissingError
        If no sheet of a map has that end.
    """
    found = {}
    for _, rows in maps.by_model(study.table("map")):
        odd = rows[rows["parity"] == "antisymmetric"]
        tau, quartic = strain_map.of_table(odd), strain_map.of_table(odd, "quartic")
        values = maps.along_boundary(tau, quartic, maps.THICKNESSES)[end]
        found[str(rows.iloc[0].material)] = Coefficients(tau.aspects, values)
    found = {model: g for model, g in found.items() if g.known.size}
    if not found:
        raise MissingError(f"a sheet with its {('birth', 'decay')[end]} on a map")
    return found


def gradual(study: StudyTables, end: int) -> Finding:
    """Judge whether g > 0 along one end of the range of wrinkles."""
    found = coefficients(study, end)
    outcomes = {model: bool((g.known > 0.0).all()) for model, g in found.items()}
    verdict, depends = verdict_across(outcomes, "the model")
    values, texts = [], []
    for model, g in found.items():
        least = int(np.nanargmin(g.values))
        negative = int((g.known < 0.0).sum())
        smallest = float(g.values.flat[least])
        values += [
            Value(f"smallest g, {model}", smallest),
            Value(f"largest g, {model}", float(g.known.max())),
        ]
        texts.append(
            f"{model}: g = {smallest:.3g} (at {g.place(least)}) to {g.known.max():.3g}, negative "
            f"at {negative} of {g.known.size} points"
        )
    return Finding(verdict, tuple(values), f"{'; '.join(texts)}.", depends)


@claim(
    order=(8, 0, 1),
    place="birth, all lengths and thicknesses of the maps",
    statement="Wrinkles are born gradually, whatever the length, the thickness and the law.",
    reading=_READING,
    tolerance="g > 0 at every birth",
)
def birth_is_gradual(study: StudyTables) -> Finding:
    """Look for subcritical births."""
    return gradual(study, 0)


@claim(
    order=(8, 0, 2),
    place="decay, all lengths and thicknesses of the maps",
    statement="Wrinkles vanish gradually, whatever the length, the thickness and the law.",
    reading="As above, for sheets whose wrinkles end on the map.",
    tolerance="g > 0 at every decay",
)
def decay_is_gradual(study: StudyTables) -> Finding:
    """Look for subcritical decays."""
    return gradual(study, 1)


@dataclass(frozen=True, eq=False)
class LowWrinkles:
    """Heights of low wrinkles of one sheet: solved, and foretold by the quartic coefficient.

    Parameters
    ----------
    sheet : SheetStates
    strain, solved, foretold : ndarray, shape (n,)
        A/t over the whole sheet.
    late : ndarray of bool
        Whether the critical thickness falls there: near decay, not near birth.
    """

    sheet: SheetStates
    strain: Array
    solved: Array
    foretold: Array
    late: Mask


def low_wrinkles(study: StudyTables) -> list[LowWrinkles]:
    """Return the low wrinkles of all sheets whose model and L/W are on a map."""
    table, found = study.table("map"), []
    for sheet in study.sheets:
        rows = table[
            (table["material"] == sheet.material)
            & (table["aspect"] == sheet.aspect)
            & (table["parity"] == sheet.parity)
            & table["quartic"].notna()
        ].sort_values("strain")
        names = ("strain", "critical_thickness", "sheet_amplitude_over_thickness")
        strain, tau, solved = (sheet.columns[name] for name in names)
        excess = (tau / sheet.thickness) ** 2 - 1.0
        low = sheet.of_status("wrinkled") & (excess > 0.0) & (excess <= LOW)
        if rows.empty or not low.any():
            continue
        strain, solved, excess = strain[low], solved[low], excess[low]
        inside = (strain >= rows["strain"].min()) & (strain <= rows["strain"].max())
        g = np.interp(strain, rows["strain"], rows["quartic"])
        with np.errstate(invalid="ignore"):
            foretold = np.where(inside, np.sqrt(excess / (2.0 * g)), np.nan)
        late = strain > float(rows["strain"].iloc[int(rows["critical_thickness"].argmax())])
        found.append(LowWrinkles(sheet, strain, solved, foretold, late))
    return found


@claim(
    order=(8, 0, 3),
    place="low wrinkles near birth and near decay",
    statement="The quartic coefficient foretells how high wrinkles are near birth and decay.",
    reading=f"Against minimised wrinkles with (τ₁/t)² - 1 up to {LOW:g}, A/t over the whole sheet.",
    tolerance=f"each height within {HEIGHT:.0%}",
)
def height_from_quartic(study: StudyTables) -> Finding:
    """Compare heights of low wrinkles with those that the coefficient gives."""
    found = low_wrinkles(study)
    late = np.concatenate([low.late for low in found]) if found else np.zeros(0, dtype=bool)
    if late.all() or not late.any():
        raise MissingError("low wrinkles near birth and near decay, with a map of their L/W")
    off = np.concatenate([low.foretold / low.solved - 1.0 for low in found])
    texts = [
        f"{low.sheet.label}: "
        + ", ".join(
            f"{a:.3f} against {b:.3f} at ε = {e:g}"
            for e, a, b in zip(low.strain, low.foretold, low.solved, strict=True)
        )
        for low in found
    ]
    return Finding(
        verdict_of(bool((np.abs(off) <= HEIGHT).all())),
        (
            Value("states near birth", int((~late).sum())),
            Value("states near decay", int(late.sum())),
            Value("largest error near birth", float(np.abs(off[~late]).max()), digits=2),
            Value("largest error near decay", float(np.abs(off[late]).max()), digits=2),
        ),
        f"A/t foretold against solved: {'; '.join(texts)}.",
        sheets=tuple(low.sheet for low in found),
    )
