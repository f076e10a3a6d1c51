"""The energy of the sheet as a function of its free unknowns, as Newton's method sees it."""

from dataclasses import replace
from typing import NamedTuple, Self

import numpy as np
from scipy import sparse

from wrinklestudy.equilibrium.energy import EnergyExpansion
from wrinklestudy.equilibrium.flat import Flat
from wrinklestudy.equilibrium.modes import Modes
from wrinklestudy.fem.assembly import shared_assembler
from wrinklestudy.fem.slopes import TiedSlopes
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics import plate
from wrinklestudy.mechanics.bending import SectionDerivatives
from wrinklestudy.mechanics.section import Section
from wrinklestudy.mechanics.surface import SurfaceGeometry
from wrinklestudy.typing import Array, Mask


class PlateProblem:
    """Energy of the sheet over its free dofs, in units of mu W^3.

    Parameters
    ----------
    space : Space
    section : Section
        Law, thickness and bending law.
    free : (3, size) array of bool
        The unknowns.
    position : (3, size) array
        Gives the prescribed values of all other dofs.
    flat : (3, size) array, optional
        The flat state of `shift`; without it the position, which then has z = 0.
    slopes : TiedSlopes, optional
        The slope condition of clamps that are turned.
    weight : float
        rho g W/mu of a sheet under its own weight, which pulls toward -z.
    """

    def __init__(
        self,
        space: Space,
        section: Section,
        free: Mask,
        position: Array,
        flat: Array | None = None,
        slopes: TiedSlopes | None = None,
        weight: float = 0.0,
    ) -> None:
        relative, thickness = space.relative_thickness, float(section.thickness)
        self.uniform = section  # of the mean thickness
        self.section = replace(section, thickness=section.thickness * relative)
        self.assembler = shared_assembler(space, free, slopes=slopes)
        self.thickness = thickness
        self.load = _self_weight(space, weight * thickness) if weight else None
        self.prescribed = position.copy()
        self._flat = flat
        self._shift: sparse.csr_array | None = None

    @classmethod
    def of_flat(cls, flat: Flat, modes: Modes, thickness: float) -> Self:
        """Return the problem of a clamped sheet with the mirrors and the bending law of its modes.

        Parameters
        ----------
        flat : Flat
        modes : Modes
        thickness : float
            t/W.
        """
        section = Section(flat.law, thickness, modes.bending)
        return cls(flat.space, section, modes.symmetry.free(flat.space), flat.sheet_position)

    def position(self, unknowns: Array) -> Array:
        """Return the dof vectors (3, size) with the prescribed values in place."""
        return self.assembler.filled(self.prescribed, unknowns)

    def prescribe(self, position: Array) -> None:
        """Prescribe the values of a position (3, size) at the dofs that are not free."""
        held = ~self.assembler.free
        self.prescribed[held] = position[held]

    def energy(self, unknowns: Array) -> float:
        """Return the energy, infinite where the surface or its thickness degenerates."""
        space = self.assembler.space
        with np.errstate(all="ignore"):
            density = plate.energy(self.section, space.derivatives(self.position(unknowns)))
        total = float((density * space.measure).sum()) + self._raised(unknowns)
        return total if np.isfinite(total) else np.inf

    def derivatives(self, unknowns: Array) -> EnergyExpansion:
        """Return the energy, the residual and the upper triangle of the tangent."""
        surface, section = plate.respond(self.section, self.gradients(unknowns))
        return self.assemble(unknowns, surface, section, section)

    def gradients(self, unknowns: Array) -> Array:
        """Return x,1 x,2 x,11 x,22 x,12 at the Gauss points."""
        return self.assembler.space.derivatives(self.position(unknowns))

    def assemble(
        self,
        unknowns: Array,
        surface: SurfaceGeometry,
        section: SectionDerivatives,
        of_tangent: SectionDerivatives,
    ) -> EnergyExpansion:
        """Return energy, residual and tangent; the tangent may come from another section."""
        assembler = self.assembler
        density = self.section.energy(surface.metric, surface.curvature)
        residual = assembler.reduced(self._loaded(plate.gradient(surface, section)))
        tangent = assembler.tangent(plate.hessian(surface, of_tangent))
        energy = float((density * assembler.space.measure).sum()) + self._raised(unknowns)
        return EnergyExpansion(energy, residual, tangent)

    def residual(self, unknowns: Array) -> Array:
        """Return the residual alone."""
        return self.assembler.reduced(self.reactions(unknowns))

    def reactions(self, unknowns: Array) -> Array:
        """Return the residual at every dof, (3, size); the reactions are at the prescribed ones."""
        surface, section = plate.respond(self.section, self.gradients(unknowns))
        return self._loaded(plate.gradient(surface, section))

    def _loaded(self, gradient: Array) -> Array:
        """Return the residual (3, size) of the section and of the weight."""
        residual = self.assembler.residual(gradient)
        if self.load is not None:
            residual[2] += self.load
        return residual

    def _raised(self, unknowns: Array) -> float:
        """Return the potential energy of the weight."""
        return 0.0 if self.load is None else float(self.load @ self.position(unknowns)[2])

    def shift(self) -> sparse.csr_array:
        """Return t B, acting on the deflection: it lifts all modes of the flat state alike."""
        if self._shift is None:
            space = self.assembler.space
            flat = self.prescribed if self._flat is None else self._flat
            _, bent = plate.deflection(
                self.section.law,
                self.section.bending,
                space.derivatives(flat),
                space.relative_thickness,
            )
            blocks = [
                np.zeros((len(self.assembler.entries(c == d)), *space.measure.shape))
                for c, d in self.assembler.pairs
            ]
            blocks[-1] = self.thickness * bent
            self._shift = self.assembler.tangent(blocks)
        return self._shift


def _self_weight(space: Space, weight: float) -> Array:
    """Return the derivative (size,) of the integral of a weight for each area, times z."""
    density = weight * space.relative_thickness * space.measure
    local = (space.values.T @ density) * space.dof_scale
    load = np.zeros(space.size)
    np.add.at(load, space.dofs.element_dofs, local)
    return load


class _Response(NamedTuple):
    """State of the Gauss points where a tangent was taken."""

    gradients: Array  # x,1 x,2 x,11 x,22 x,12
    surface: SurfaceGeometry
    section: SectionDerivatives


class Predicting:
    """A plate problem whose tangent takes the stresses that the last step predicted.

    The geometric part of the tangent takes force and moment from the state before the step, to
    first order in the step, rather than from the displacements after it. In thin sheets a step that
    is right for the wrinkles stretches the sheet at second order, and such false stresses, t^-2
    times stiffer than bending, spoil the next tangent. Energy and residual stay exact, so that the
    equilibrium is the same; near it so is the tangent, as the error of the prediction is of the
    second order in the step.

    Source: Magisano, Leonetti and Garcea, Comput. Methods Appl. Mech. Engrg. 313, 986 (2017),
    Newton's method with mixed integration points.

    Parameters
    ----------
    problem : PlateProblem
        The exact problem.
    """

    def __init__(self, problem: PlateProblem) -> None:
        self.problem = problem
        self.energy, self.residual, self.shift = problem.energy, problem.residual, problem.shift
        self._last: _Response | None = None

    def derivatives(self, unknowns: Array) -> EnergyExpansion:
        """Return the energy, the residual and the upper triangle of the predicted tangent."""
        gradients = self.problem.gradients(unknowns)
        surface, section = plate.respond(self.problem.section, gradients)
        predicted = section
        if self._last is not None:
            step = gradients - self._last.gradients
            force, moment = plate.predict(self._last.surface, self._last.section, step)
            predicted = section._replace(force=force, moment=moment)
        self._last = _Response(gradients, surface, section)
        return self.problem.assemble(unknowns, surface, section, predicted)
