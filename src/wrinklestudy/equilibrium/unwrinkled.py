"""The state of a sheet before it wrinkles, where its clamps or its weight leave it not flat.

The flat state is that of the same clamps put back into their plane. What lifts the sheet out of it,
twist, pitch, lift or weight, is small, and the sheet answers as to any small load: with the
stiffness t S + t^3 B of `modes`.
"""

from dataclasses import replace

from wrinklestudy.equilibrium import newton
from wrinklestudy.equilibrium.deflections import DeflectionForms, deflection_forms
from wrinklestudy.equilibrium.flat import ROUNDING, Flat, NotConvergedError
from wrinklestudy.equilibrium.problem import PlateProblem
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.factorisation import NotPositiveDefiniteError
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

_MAX_RISES, _RISE = 20, 1.5


def planar_symmetry(symmetry: Symmetry) -> Symmetry:
    """Return the same symmetry with clamps that are put back into the plane."""
    return replace(symmetry, clamps=symmetry.clamps.in_plane())


def plate_problem(
    flat: Flat, symmetry: Symmetry, bending: str, thickness: float, weight: float
) -> PlateProblem:
    """Return the energy of a sheet whose clamps need not be perfect, see `PlateProblem`.

    Parameters
    ----------
    flat : Flat
        With the clamps in their plane.
    symmetry : Symmetry
        With the clamps as they are.
    bending : str
    thickness : float
        t/W, of an uneven sheet its mean.
    weight : float
        rho g W/mu.
    """
    space = flat.space
    position = symmetry.clamp.position(space, flat.strain)
    return PlateProblem(
        space,
        Section(flat.law, thickness, bending),
        symmetry.free(space),
        position,
        flat.sheet_position,
        symmetry.clamp.slopes(space),
        weight,
    )


def lifted(flat: Flat, problem: PlateProblem, bending: str, stiffness: float) -> Array:
    """Return the position (3, size) to which clamps and weight lift a flat sheet, to first order.

    Parameters
    ----------
    flat : Flat
    problem : PlateProblem
        The sheet with its clamps and its weight.
    bending : str
    stiffness : float
        t of the bending stiffness t^3 B. At the thickness of a sheet that wrinkles the answer would
        be one of its wrinkles, at one above the critical thickness it has none. It is raised where
        the corners need more.
    """
    position = problem.prescribed.copy()
    position[:2] = flat.position
    free = problem.assembler.free
    unknowns = position[free]
    forms = deflection_forms(flat, bending, flat.symmetry)
    solver, thickness = forms.assembler.solver, problem.thickness
    _factorise(forms, stiffness)
    load = problem.residual(unknowns)[-forms.assembler.size :]
    unknowns[-forms.assembler.size :] -= solver.solve(load) / thickness
    return problem.position(unknowns)


def _factorise(forms: DeflectionForms, stiffness: float) -> None:
    """Factorise S + t^2 B at the first thickness, from one on, at which it is definite."""
    for _ in range(_MAX_RISES):
        try:
            forms.assembler.solver.factorise(forms.shifted(stiffness**2))
        except NotPositiveDefiniteError:
            stiffness *= _RISE
        else:
            return
    raise NotConvergedError("the flat sheet is unstable at any thickness")


def relaxed(flat: Flat, problem: PlateProblem, position: Array) -> Array:
    """Return a lifted position in equilibrium in its plane: what the lift stretches gives way.

    Raises
    ------
    ArithmeticError
        If that is not found; one line.
    """
    free = problem.assembler.free.copy()
    free[2] = False
    planes = PlateProblem(
        flat.space,
        problem.uniform,
        free,
        position,
        flat.sheet_position,
        problem.assembler.slopes,
    )
    options = newton.NewtonOptions(noise=ROUNDING * problem.thickness)
    minimum = newton.minimise(planes, position[free], planes.assembler.solver, options)
    if not minimum.converged:
        raise NotConvergedError(f"lifted sheet at strain {flat.strain:g}: {minimum.reason}")
    return planes.position(minimum.unknowns)
