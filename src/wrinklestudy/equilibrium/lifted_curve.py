"""The curve of the critical thickness of a sheet that clamps or weight lift out of its plane.

Such a sheet has no flat state. The tangent K of the unwrinkled state takes its place: with the
smallest mu of K v = mu t^3 B v the number t sqrt(1 - mu) exceeds t exactly where that state is
unstable, and is tau_1 where it is flat.
"""

from dataclasses import dataclass

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.critical_curve import CriticalCurve
from wrinklestudy.equilibrium.deflections import CORNER_PART, corner_part, deflection_forms
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.mirror_stability import softest_modes
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.equilibrium.unwrinkled import lifted, plate_problem, relaxed
from wrinklestudy.fem.boundary import NO_MIRRORS, Symmetry
from wrinklestudy.fem.factorisation import NotPositiveDefiniteError
from wrinklestudy.typing import Array

_ABOVE = 1.2  # thickness, over tau_1 of the flat sheet, at which it is lifted
_MAX_SHIFTS = 12
_MODES = 8  # four of the corners, and the first two wrinkles in both parities


@dataclass(frozen=True, eq=False)
class LiftedCurve(CriticalCurve):
    """t sqrt(1 - mu) over strain, see above; the settings have the clamps in their plane.

    Parameters
    ----------
    thickness : float
        t/W, of an uneven sheet its mean.
    lifting : Symmetry
        With the clamps as they are.
    weight : float
        rho g W/mu.
    """

    thickness: float = 1.0e-3
    lifting: Symmetry = NO_MIRRORS
    weight: float = 0.0

    def _critical(self, flat: Flat, near: float | None) -> float:
        flat_thickness = super()._critical(flat, near)
        stiff = _ABOVE * max(flat_thickness, self.thickness)
        bending, thickness = self.settings.bending, self.thickness
        problem = plate_problem(flat, self.lifting, bending, thickness, self.weight)
        position = relaxed(flat, problem, lifted(flat, problem, bending, stiff))
        return thickness * float(np.sqrt(max(1.0 - _softest(flat, problem, position, stiff), 0.0)))


def _softest(flat: Flat, problem: PlateProblem, position: Array, stiff: float) -> float:
    """Return the smallest eigenvalue mu of a wrinkle of the tangent at a position.

    Modes of the four corners are passed over, as in `modes`.

    Parameters
    ----------
    flat : Flat
    problem : PlateProblem
    position : (3, size) array
        The unwrinkled state.
    stiff : float
        A thickness at which the sheet would be stable.
    """
    thickness, solver = problem.thickness, problem.assembler.solver
    tangent = problem.derivatives(position[problem.assembler.free]).tangent
    lift = problem.shift()  # t B
    for _ in range(_MAX_SHIFTS):
        data = tangent.data + (stiff**2 - thickness**2) * lift.data
        try:
            solver.factorise(
                sparse.csr_array((data, tangent.indices, tangent.indptr), tangent.shape)
            )
            break
        except NotPositiveDefiniteError:
            stiff *= _ABOVE
    else:
        raise ArithmeticError("the unwrinkled sheet is unstable at any thickness")
    forms = deflection_forms(flat, problem.section.bending, flat.symmetry)
    bent, shift = thickness**3 * forms.bending, 1.0 - (stiff / thickness) ** 2
    start = np.random.default_rng(0).standard_normal(tangent.shape[0])
    values, vectors = softest_modes(tangent, bent, solver.solve, _MODES, shift, start)
    shapes = np.zeros((_MODES, flat.space.size))
    shapes[:, forms.assembler.free[0]] = vectors[-forms.assembler.size :].T
    wrinkles = corner_part(flat, forms.points, shapes) < CORNER_PART
    if not wrinkles.any():  # then all wrinkles are stiffer than these
        return 1.0
    return float(values[wrinkles].min())
