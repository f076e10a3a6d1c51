"""From a state of an imperfect sheet, and where its sheet wrinkles, to the row of a table."""

from typing import TYPE_CHECKING

from wrinklestudy.results.imperfect_sheets import ImperfectSheet
from wrinklestudy.results.imperfection_rows import ImperfectionRow

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.ranges import Stability
    from wrinklestudy.results.whole import WholeState


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
        Why not, or not at all strains.
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
