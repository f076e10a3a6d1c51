"""The energy of the sheet over its free unknowns, as Newton's method sees it."""

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.fem.assembly import Assembler, shared_assembler
from wrinklestudy.mechanics import plate
from wrinklestudy.mechanics.section import Section, SectionDerivatives
from wrinklestudy.typing import Array


class PlateEnergy:
    """Energy of any sheet over its free dofs, in units of mu W^3.

    Parameters
    ----------
    section : Section
    assembler : Assembler
        Of the space and the free dofs.
    position : (3, size) array
        Its values at the other dofs are prescribed.
    """

    def __init__(self, section: Section, assembler: Assembler, position: Array) -> None:
        self.section = section
        self.assembler = assembler
        self._prescribed = position.copy()

    def position(self, unknowns: Array) -> Array:
        """Return the dof vectors (3, size) with the prescribed values in place."""
        field = self._prescribed.copy()
        field[self.assembler.free] = unknowns
        return field

    def prescribe(self, component: int, dofs: NDArray[np.int64], values: Array) -> None:
        """Set prescribed values of one component of the position."""
        self._prescribed[component, dofs] = values

    def energy(self, unknowns: Array) -> float:
        """Return the energy, infinite where the surface or its thickness degenerates."""
        space = self.assembler.space
        with np.errstate(all="ignore"):
            density = plate.energy(self.section, space.derivatives(self.position(unknowns)))
        total = float((density * space.measure).sum())
        return total if np.isfinite(total) else np.inf

    def derivatives(self, unknowns: Array) -> tuple[float, Array, sparse.csr_array]:
        """Return the energy, the residual and the upper triangle of the tangent."""
        surface, section = plate.respond(self.section, self.gradients(unknowns))
        return self.assemble(surface, section, section)

    def gradients(self, unknowns: Array) -> Array:
        """Return x,1 x,2 x,11 x,22 x,12 at the Gauss points."""
        return self.assembler.space.derivatives(self.position(unknowns))

    def assemble(
        self,
        surface: plate.SurfaceGeometry,
        section: SectionDerivatives,
        of_tangent: SectionDerivatives,
    ) -> tuple[float, Array, sparse.csr_array]:
        """Return energy, residual and tangent, the latter from a section of its own."""
        assembler = self.assembler
        density = self.section.energy(surface.metric, surface.curvature)
        residual = assembler.residual(plate.gradient(surface, section))[assembler.free]
        tangent = assembler.tangent(plate.hessian(surface, of_tangent))
        return float((density * assembler.space.measure).sum()), residual, tangent

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone."""
        return self.reactions(unknowns)[self.assembler.free]

    def reactions(self, unknowns: Array) -> Array:
        """Return the residual at every dof, (3, size); the reactions are at the prescribed ones."""
        surface, section = plate.respond(self.section, self.gradients(unknowns))
        return self.assembler.residual(plate.gradient(surface, section))


class PlateProblem(PlateEnergy):
    """Energy of the quarter sheet between its clamps, from its flat state, in units of mu W^3."""

    def __init__(self, flat: Flat, modes: Modes, thickness: float) -> None:
        position = np.zeros((3, flat.space.size))
        position[:2] = flat.position
        assembler = shared_assembler(flat.space, flat.space.free(modes.parity))
        super().__init__(Section(flat.law, thickness, modes.bending), assembler, position)
        self.flat = flat
        self.modes = modes
        self._shift: sparse.csr_array | None = None

    def shift(self) -> sparse.csr_array:
        """Return t B on the deflection: it lifts all modes of the flat state by the same amount."""
        if self._shift is None:
            space = self.assembler.space
            _, bent = plate.deflection(
                self.flat.law, self.section.bending, space.derivatives(self._prescribed)
            )
            blocks = [
                np.zeros((len(self.assembler.entries(c == d)), *space.measure.shape))
                for c, d in self.assembler.pairs
            ]
            blocks[-1] = self.section.thickness * bent
            self._shift = self.assembler.tangent(blocks)
        return self._shift


class Predicting:
    """A plate problem whose tangent has the stresses that the last step predicted.

    The geometric part of the tangent takes force and moment from the state before, to first order
    in the step, instead of from the displacements. In thin sheets a step that is right for the
    wrinkles stretches the sheet at second order, and such false stresses, t^-2 times stiffer than
    bending, ruin the next tangent. Energy and residual are the true ones, so that the equilibrium
    is the same, and near it the tangent is too: the prediction is off by the square of the step.

    Source: Magisano, Leonetti and Garcea, Comput. Methods Appl. Mech. Engrg. 313, 986 (2017),
    Newton's method with mixed integration points.

    Parameters
    ----------
    problem : PlateProblem
        The exact one.
    """

    def __init__(self, problem: PlateProblem) -> None:
        self.problem = problem
        self.energy, self.residual, self.shift = problem.energy, problem.residual, problem.shift
        self._last: tuple[Array, plate.SurfaceGeometry, SectionDerivatives] | None = None

    def derivatives(self, unknowns: Array) -> tuple[float, Array, sparse.csr_array]:
        """Return the energy, the residual and the upper triangle of the predicted tangent."""
        gradients = self.problem.gradients(unknowns)
        surface, section = plate.respond(self.problem.section, gradients)
        predicted = section
        if self._last is not None:
            before, shape, known = self._last
            force, moment = plate.predict(shape, known, gradients - before)
            predicted = section._replace(force=force, moment=moment)
        self._last = gradients, surface, section
        return self.problem.assemble(surface, section, predicted)
