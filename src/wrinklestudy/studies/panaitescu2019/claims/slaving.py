"""Claims on the slaving condition A = C lambda Phi and its constant."""

import numpy as np

from wrinklestudy.metrics.measure import measure
from wrinklestudy.metrics.profile import Profile
from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.studies.panaitescu2019.claims.confinement import AVERAGES, AVERAGING
from wrinklestudy.study.claims.finding import (
    Finding,
    Value,
    claim,
    listed,
    verdict_across,
    verdict_of,
)
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

SCATTER = 0.1  # of the largest amplitude
ONE_DIGIT = (0.5, 1.5)  # what is written as 1 with one digit
CLOSE = 0.1  # of 1, for the explanation
SINUSOID = 0.01  # of 1/pi
SHAPE = 0.1  # of 1/pi
WEAK = (0.005, 0.25)  # of C: more than the error of the mesh, less than strong
COLLAPSE = 0.1  # of C
CAPTION = 0.05  # of C
LARGE_STRAIN = 0.15

_CONSTANTS = {"full width": "shape_constant", "central wavelength": "shape_constant_central"}


def _points(sheet: SheetStates, average: str, above: float = 0.0) -> tuple[Array, Array]:
    """Return lambda Phi/t and A/t of the wrinkled states."""
    height, wavelength, phi = sheet.wrinkled(
        "amplitude_over_thickness", "wavelength_over_width", AVERAGES[average], above=above
    )
    return wavelength * np.sqrt(phi) / sheet.thickness, height


def _slope(points: tuple[Array, Array]) -> float:
    """Return C of the best straight line A = C lambda Phi through the origin."""
    product, height = points
    return float(height @ product / (product @ product))


@claim(
    order=(4, 3, 10),
    place="Sec. IV.C, Fig. 7c",
    statement="Experiment and simulation follow A = C λ Φ with one constant C.",
    reading="A is proportional to λ Φ over the whole range of strain.",
    tolerance=f"every wrinkled state within {SCATTER:.0%} of the largest amplitude of the straight "
    "line through the origin, for both averages of Φ²",
)
def single_constant(study: StudyTables) -> Finding:
    """Fit A = C lambda Phi and compute the largest distance from the line."""
    sheet = study.sheet
    scatter = {}
    for name in AVERAGES:
        product, height = points = _points(sheet, name)
        scatter[name] = float(np.abs(height - _slope(points) * product).max() / height.max())
    outcomes = {name: value <= SCATTER for name, value in scatter.items()}
    verdict, what = verdict_across(outcomes, AVERAGING)
    return Finding(
        verdict,
        tuple(Value(f"largest distance from the line, {n}", v) for n, v in scatter.items()),
        f"Largest distance from the line over the largest amplitude: {listed(scatter)}.",
        what,
        (sheet,),
    )


@claim(
    order=(4, 3, 11),
    place="Sec. IV.C, Figs. 7c and 7d",
    statement="C is 1, at large strains too.",
    reading="C = A/(λ Φ) is 1, given to one digit. A sinusoid has C = 1/π (Sec. IV.A); what C is "
    "depends on the width over which Φ² is averaged.",
    tolerance=f"slope of A against λ Φ from {ONE_DIGIT[0]:g} to {ONE_DIGIT[1]:g}, for both "
    "averages",
)
def constant_is_one(study: StudyTables) -> Finding:
    """Compute C by regression through the origin, for both averages."""
    sheet = study.sheet
    fitted = {name: _slope(_points(sheet, name)) for name in AVERAGES}
    outcomes = {name: ONE_DIGIT[0] <= C < ONE_DIGIT[1] for name, C in fitted.items()}
    verdict, what = verdict_across(outcomes, AVERAGING)
    close = [name for name, C in fitted.items() if abs(C - 1.0) <= CLOSE]
    last = {name: float(sheet.wrinkled(column)[0][-1]) for name, column in _CONSTANTS.items()}
    return Finding(
        verdict,
        (
            *(Value(f"C, {name}", C) for name, C in fitted.items()),
            *(Value(f"C at the largest wrinkled strain, {name}", C) for name, C in last.items()),
            Value("C of a sinusoid", theory.SINUSOID_CONSTANT),
        ),
        f"C = {listed(fitted)}; within {CLOSE:.0%} of 1 is {' and '.join(close) or 'neither'}. "
        + _why(fitted["full width"], fitted["central wavelength"]),
        what,
        (sheet,),
    )


def _why(full: float, central: float) -> str:
    """Return why the two averages differ, if the wrinkles fade towards the edges."""
    if full <= central:
        return "The wrinkles do not fade towards the edges."
    return (
        f"A sinusoid has C = {theory.SINUSOID_CONSTANT:.3f}; over the full width Φ² is lower than "
        "over the central crest, because the wrinkles fade toward the edges, and C is higher."
    )


def _sinusoid_constant() -> float:
    """Return C/(1/pi) as the program measures it on A sin(2 pi y/lambda) of small slope."""
    y = np.linspace(-0.5, 0.5, 2001)
    measures = measure(Profile(y, 1e-3 * np.sin(2.0 * np.pi * y / 0.125)))
    return measures.shape_constant / theory.SINUSOID_CONSTANT


@claim(
    order=(4, 1, 3),
    place="Sec. IV.A, below Eq. (4)",
    statement="C is 1/π for a sinusoidal profile.",
    reading="C of an exact sinusoid, measured as all profiles are, is 1/π; so is C of the "
    "central crest of the computed profiles as far as that is a sinusoid.",
    tolerance=f"exact sinusoid within {SINUSOID:.0%} of 1/π, central wavelength of every wrinkled "
    f"state within {SHAPE:.0%}",
)
def sinusoid(study: StudyTables) -> Finding:
    """Measure an exact sinusoid and compare the central crest of the profiles."""
    exact = _sinusoid_constant()
    (central,) = study.sheet.wrinkled("shape_constant_central")
    ratio = central / theory.SINUSOID_CONSTANT
    off = float(np.abs(ratio - 1.0).max())
    return Finding(
        verdict_of(abs(exact - 1.0) <= SINUSOID and off <= SHAPE),
        (
            Value("C π of an exact sinusoid", exact, digits=5),
            Value("smallest C π, central wavelength", float(ratio.min())),
            Value("largest C π, central wavelength", float(ratio.max())),
        ),
        f"The exact sinusoid gives C = {exact * theory.SINUSOID_CONSTANT:.5f}; the central "
        f"crests are up to {off:.1%} off 1/π.",
        sheets=(study.sheet,),
    )


@claim(
    order=(4, 3, 13),
    place="Sec. IV.C, Fig. 7d",
    statement="C depends on ε, but weakly: the shape of the wrinkles changes a little under load.",
    tolerance=f"range of C over the wrinkled states from {WEAK[0]:.1%} to {WEAK[1]:.0%} of its "
    "mean, for both averages",
)
def weak_dependence(study: StudyTables) -> Finding:
    """Compute the range of C over the wrinkled states."""
    sheet = study.sheet
    spread, words = {}, []
    for name, column in _CONSTANTS.items():
        strain, constant = sheet.wrinkled("strain", column)
        spread[name] = float(np.ptp(constant) / constant.mean())
        words.append(
            f"from {constant[0]:.3f} at ε = {strain[0]:g} to {constant[-1]:.3f} at "
            f"ε = {strain[-1]:g} ({name})"
        )
    outcomes = {name: WEAK[0] <= value <= WEAK[1] for name, value in spread.items()}
    verdict, what = verdict_across(outcomes, AVERAGING)
    return Finding(
        verdict,
        tuple(Value(f"range of C over its mean, {name}", v) for name, v in spread.items()),
        f"C goes {' and '.join(words)}.",
        what,
        (sheet,),
    )


@claim(
    order=(4, 3, 12),
    place="Sec. IV.C, Fig. 7d",
    statement="The data of three L/W fall on one line.",
    reading=f"Beyond ε = {LARGE_STRAIN:g} one constant C serves sheets of different L/W.",
    tolerance=f"C of the sheets differ by at most {COLLAPSE:.0%} of their mean, for both averages",
)
def collapse(study: StudyTables) -> Finding:
    """Compare C of the sheets of the L/W series at large strain."""
    sheets = _wrinkled_beyond(study)
    if len(sheets) < 2:
        raise MissingError(f"two values of L/W with wrinkled states beyond strain {LARGE_STRAIN:g}")
    values, spread = [], {}
    for name in AVERAGES:
        fitted = [_slope(_points(sheet, name, LARGE_STRAIN)) for sheet in sheets]
        spread[name] = float(np.ptp(fitted) / np.mean(fitted))
        values += [
            Value(f"C, L/W = {sheet.aspect:g}, {name}", C)
            for sheet, C in zip(sheets, fitted, strict=True)
        ]
    values += [Value(f"range of C over its mean, {name}", v) for name, v in spread.items()]
    outcomes = {name: value <= COLLAPSE for name, value in spread.items()}
    verdict, what = verdict_across(outcomes, AVERAGING)
    return Finding(
        verdict,
        tuple(values),
        f"Range of C over its mean, L/W = {sheets[0].aspect:g} to {sheets[-1].aspect:g}: "
        f"{listed(spread)}.",
        what,
        tuple(sheets),
    )


def _wrinkled_beyond(study: StudyTables) -> list[SheetStates]:
    """Return the sheets of the L/W series with wrinkled states at large strain."""
    return [
        sheet
        for sheet in study.sheets_by("aspect").values()
        if sheet.wrinkled_above(LARGE_STRAIN).any()
    ]


@claim(
    order=(4, 3, 14),
    place="Caption of Fig. 7d",
    statement="The caption limits the data twice, to ε > 0 and to ε > 0.15.",
    reading=f"ε > {LARGE_STRAIN:g} is taken. Tested: whether the choice matters for C.",
    tolerance=f"C over both ranges within {CAPTION:.0%} of each other, for both averages",
)
def caption_ranges(study: StudyTables) -> Finding:
    """Compare C over all strains with C over large strains, the L/W series taken together."""
    sheets = _wrinkled_beyond(study)
    if not sheets:
        raise MissingError(f"a wrinkled state beyond strain {LARGE_STRAIN:g}")
    values, change = [], {}
    for name in AVERAGES:
        fitted = [_slope(_pooled(sheets, name, above)) for above in (0.0, LARGE_STRAIN)]
        change[name] = fitted[1] / fitted[0] - 1.0
        values += [
            Value(f"C, ε > {above:g}, {name}", C)
            for above, C in zip((0.0, LARGE_STRAIN), fitted, strict=True)
        ]
    outcomes = {name: abs(value) <= CAPTION for name, value in change.items()}
    verdict, what = verdict_across(outcomes, AVERAGING)
    return Finding(
        verdict,
        tuple(values),
        f"Leaving out ε up to {LARGE_STRAIN:g} changes C by "
        + ", ".join(f"{value:+.1%} ({name})" for name, value in change.items())
        + ".",
        what,
        tuple(sheets),
    )


def _pooled(sheets: list[SheetStates], average: str, above: float) -> tuple[Array, Array]:
    points = [_points(sheet, average, above) for sheet in sheets]
    product, height = (np.concatenate(columns) for columns in zip(*points, strict=True))
    return product, height
