"""The rows of imperfect sheets, apart from how they are made: a table needs no finite elements."""

from dataclasses import dataclass

from wrinklestudy.results.rows import Row, described
from wrinklestudy.vocabulary import WHOLE_STATUSES


@dataclass(frozen=True)
class ImperfectionRow(Row):
    """An imperfect sheet at one strain."""

    material: str = described("name of the material, or of a variant of one", identifies=True)
    bending: str = described("bending law", identifies=True)
    aspect: float = described("L/W", identifies=True)
    thickness: float = described("t/W, mean", identifies=True)
    imperfection: str = described("name of the imperfect sheet: what and how much", identifies=True)
    strain: float = described("eps = (L' - L)/L of the middles of the clamps", identifies=True)
    kind: str = described("what is imperfect")
    size: float | None = described(
        "how much: in units of W, in radians, in parts of the thickness, or in kg/m^3"
    )
    symmetry: str = described("part of the sheet that was solved")
    parity: str = described("of the pattern at the centre: antisymmetric or symmetric")
    status: str = described(
        "wrinkled, unwrinkled (not flat, but too thick to wrinkle), flat or not-converged",
        allowed=WHOLE_STATUSES,
    )
    amplitude_low: float | None = described("least A/t over the phase of the pattern")
    amplitude_high: float | None = described("largest A/t over the phase of the pattern")
    envelope_amplitude: float | None = described("A/t of the envelope, at any phase")
    tilt: float | None = described("angle of the crests with the pull at the centre, in radians")
    shift_along: float | None = described("x/W of the middle of the wrinkles")
    shift_across: float | None = described("y/W of the middle of the wrinkles")
    pin_reaction: float | None = described(
        "what the pin against sliding carries, over its stiffness and t"
    )
    softest_eigenvalue: float | None = described(
        "smallest eigenvalue without the pin, in units of the bending stiffness"
    )
    parity_energy: float | None = described(
        "energy of the antisymmetric state less that of the symmetric one, over the energy of "
        "bending of the wrinkles"
    )
    newton_iterations: int = described("Newton iterations of the state and of the other parity")
    residual: float | None = described(
        "last Newton decrement of the solve, as a fraction of the energy"
    )
    decrements: str = described("Newton decrements of a state that did not converge")
    birth_strain: float | None = described(
        "strain above which it wrinkles; empty if from the least strain on"
    )
    decay_strain: float | None = described("strain above which it wrinkles no more")
    windows: str = described("all ranges of strain with wrinkles")
    bifurcation: str = described(
        "sharp if the wrinkles break a symmetry of the sheet, else rounded"
    )
    cells_along: int = described("cells along the pull, of the part that was solved")
    cells_across: int = described("cells across, of the part that was solved")
    reason: str = described("why something is not known; empty if all is")
