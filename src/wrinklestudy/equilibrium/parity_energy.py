"""How much lower one parity of the wrinkles lies than the other, where the pattern may slide."""

from wrinklestudy.equilibrium.deflections import deflection_forms
from wrinklestudy.equilibrium.whole import WholeEquilibrium
from wrinklestudy.fem.upper_triangle import symmetric
from wrinklestudy.vocabulary import Parity


def parity_energy(state: WholeEquilibrium, bending: str, parity: Parity) -> float | None:
    """Return (E_antisymmetric - E_symmetric)/E_b of a wrinkled sheet.

    E_b = t^3/2 w.B w is what it takes to bend the flat sheet into the wrinkles w. None where not
    both states are known.

    Parameters
    ----------
    state : WholeEquilibrium
        With its partner.
    bending : str
        The bending law, a name in `mechanics.bending.BENDING_LAWS`.
    parity : {'antisymmetric', 'symmetric'}
        Of the state.
    """
    partner = state.partner
    if state.status != "wrinkled" or partner is None or partner.status != "wrinkled":
        return None
    forms = deflection_forms(state.flat, bending, state.flat.symmetry)
    shape = state.wrinkles[forms.assembler.free[0]]
    bent = 0.5 * state.thickness**3 * float(shape @ (symmetric(forms.bending) @ shape))
    sign = 1.0 if parity == "antisymmetric" else -1.0
    return sign * (state.energy - partner.energy) / bent
