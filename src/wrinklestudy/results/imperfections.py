"""The rows of imperfect sheets: a state, and between which strains its sheet wrinkles."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from wrinklestudy.results.imperfect_sheets import ImperfectSheet
from wrinklestudy.results.rows import Row, described

if TYPE_CHECKING:  # to read a table needs no finite elements
    from wrinklestudy.equilibrium.ranges import Stability
    from wrinklestudy.results.whole import WholeState

_STATUSES = ("wrinkled", "unwrinkled", "flat", "not-converged")


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
        allowed=_STATUSES,
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


def imperfection_row(
    state: "WholeState",
    imperfect: ImperfectSheet,
    bending: str,
    cells: tuple[int, int],
    stability: "Stability | None",
    reason: str = "",
) -> ImperfectionRow:
    """Return what is known of an imperfect sheet at one strain as a row.

    Parameters
    ----------
    state : WholeState
    imperfect : ImperfectSheet
    bending : str
        Its bending law.
    cells : (int, int)
        Of the part that was solved.
    stability : Stability or None
        None if it could not be computed.
    reason : str
        Why not.
    """
    from wrinklestudy.equilibrium.parity_energy import parity_energy

    row, solved = state.row(), state.equilibrium
    failed = solved is not None and solved.status == "not-converged"
    partner = None if solved is None else solved.partner
    middle = _middle(state)
    sheet = imperfect.sheet
    return ImperfectionRow(
        material=sheet.material,
        bending=bending,
        aspect=sheet.aspect,
        thickness=sheet.thickness,
        imperfection=imperfect.name,
        strain=state.strain,
        kind=imperfect.kind,
        size=imperfect.size,
        symmetry=row.symmetry,
        parity=row.parity,
        status=row.status,
        amplitude_low=row.amplitude_low,
        amplitude_high=row.amplitude_high,
        envelope_amplitude=row.envelope_amplitude,
        tilt=row.tilt,
        shift_along=None if middle is None else middle[0],
        shift_across=None if middle is None else middle[1],
        pin_reaction=row.pin_reaction,
        softest_eigenvalue=row.softest_eigenvalue,
        parity_energy=None if solved is None else parity_energy(solved, bending, state.parity),
        newton_iterations=row.newton_iterations + (0 if partner is None else len(partner.history)),
        residual=row.residual,
        decrements=" ".join(f"{step.decrement:.2e}" for step in solved.history)
        if failed and solved is not None
        else "",
        birth_strain=None if stability is None else stability.birth_strain,
        decay_strain=None if stability is None else stability.decay_strain,
        windows="" if stability is None else windows_text(stability),
        bifurcation=row.bifurcation,
        cells_along=cells[0],
        cells_across=cells[1],
        reason="; ".join(filter(None, [row.reason, reason])),
    )


def _middle(state: "WholeState") -> tuple[float, float] | None:
    """Return the middle of the wrinkles; None where the two parities are not both known."""
    from wrinklestudy.metrics.phase_band import envelope_middle
    from wrinklestudy.results.whole import whole_wrinkles

    solved = state.equilibrium
    if solved is None or solved.status != "wrinkled" or solved.partner is None:
        return None
    if solved.partner.status != "wrinkled":
        return None
    first, second = (whole_wrinkles(one) for one in (solved, solved.partner))
    return envelope_middle(first.grid, first.nodes[2], second.nodes[2])


def windows_text(stability: "Stability") -> str:
    """Return the ranges of strain with wrinkles as text; one without an end stays open."""
    return "; ".join(
        f"{birth:.5g} to {'' if decay is None else f'{decay:.5g}'}".rstrip()
        for birth, decay in stability.ranges
    )
