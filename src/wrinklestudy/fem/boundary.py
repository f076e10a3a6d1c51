"""Boundary conditions of the sheet: the mirrors it is solved with, and what its clamps hold.

Whatever depends on these choices is here: free degrees of freedom, prescribed values, the force on
the whole clamp, and how the whole sheet follows from the part that is solved.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from wrinklestudy.fem.clamps import Clamps
from wrinklestudy.fem.grid import Edge, Grid
from wrinklestudy.fem.slopes import TiedSlopes
from wrinklestudy.typing import Array, Mask
from wrinklestudy.vocabulary import PARITIES, PARTS

if TYPE_CHECKING:  # the metrics need mirrors, but no finite element space
    from wrinklestudy.fem.space import Space

_VALUE_AND_SLOPE_ALONG_X = ("u", "u_x")
_VALUE_AND_SLOPE_ALONG_Y = ("u", "u_y")
PERFECT = Clamps()


class HeldDofs(NamedTuple):
    """Degrees of freedom of one component that an edge of the grid holds."""

    component: int
    edge: Edge
    names: tuple[str, ...]


@dataclass(frozen=True)
class Clamp:
    """Clamped ends: x, y, z and the slope are held with all their derivatives along the edge.

    The sheet leaves a clamp within the plane of the clamp: x,1 . n = 0 with its normal n. For
    perfect clamps that is z,1 = 0; for others z,1 follows from x,1 and y,1, see `slopes`.

    Parameters
    ----------
    ends : tuple of Edge
        Edges of the grid that are clamped; the force is measured at the last of them.
    force_factor : float
        Force on the whole end, divided by the force on the part of it within the grid.
    clamps : Clamps
        How the clamps are shifted and turned.
    """

    ends: tuple[Edge, ...] = ("right",)
    force_factor: float = 1.0
    clamps: Clamps = PERFECT

    @property
    def held(self) -> tuple[HeldDofs, ...]:
        """What the clamp holds."""
        names = (_VALUE_AND_SLOPE_ALONG_Y, _VALUE_AND_SLOPE_ALONG_Y, ("u", "u_x", "u_y", "u_xy"))
        return tuple(
            HeldDofs(component, end, names[component])
            for end in self.ends
            for component in range(3)
        )

    def position(self, space: "Space", strain: float) -> Array:
        """Return a position (3, size) with the values that the clamps prescribe.

        In between it is the ruled surface from end to end: x = (1 + eps) X, y = Y, z = 0 for
        perfect clamps.
        """
        position = space.coordinates.copy()
        position[0] *= 1.0 + strain
        if self.clamps.perfect:
            return position
        x, y, length = space.grid.x[:, None], space.grid.y, space.grid.aspect
        left, right = (self.clamps.end(side, (1.0 + strain) * length) for side in (-1.0, 1.0))
        share = x / length + 0.5
        nodes = np.empty((3, 4, len(space.grid.x), len(space.grid.y)))
        for component, node in enumerate(nodes):
            first, last = (end.centre[component] for end in (left, right))
            slant, twist = (end.line[component] for end in (left, right))
            node[0] = first + slant * y + share * (last - first + (twist - slant) * y)
            node[1] = (last - first + (twist - slant) * y) / length
            node[2] = slant + share * (twist - slant)
            node[3] = (twist - slant) / length
        position = space.field_from_nodes(nodes)
        slopes = self.slopes(space)
        return position if slopes is None else slopes.complete(position)

    def slopes(self, space: "Space") -> TiedSlopes | None:
        """Return how z,1 and z,12 follow from those of x and y; None where they are zero."""
        if self.clamps.planar:
            return None
        dofs, factors = [], []
        for end in self.ends:
            n = self.clamps.end(-1.0 if end == "left" else 1.0, 1.0).normal
            tied = space.edge_dofs(end, ["u_x", "u_xy"])
            dofs.append(tied)
            factors.append(np.repeat([[-n[0] / n[2]], [-n[1] / n[2]]], len(tied), axis=1))
        return TiedSlopes(np.concatenate(dofs), np.concatenate(factors, axis=1))

    def force(self, space: "Space", reactions: Array) -> float:
        """Return the force on the whole end.

        Parameters
        ----------
        space : Space
        reactions : (2 or 3, size) array
            Residual at every degree of freedom.
        """
        end = space.edge_dofs(self.ends[-1], ["u"])
        return self.force_factor * float(reactions[0, end].sum())


@dataclass(frozen=True)
class Symmetry:
    """Mirrors of the sheet, with the parity of the deformed x, y, z across each of them.

    On a mirror line an odd component vanishes and an even one has no normal slope. Without a mirror
    the grid reaches over the whole length or width.

    Parameters
    ----------
    odd_along : (bool, bool, bool) or None
        Which of x, y, z change sign under X -> -X; None without a mirror at X = 0.
    odd_across : (bool, bool, bool) or None
        The same under Y -> -Y; None without a mirror at Y = 0.
    clamps : Clamps
        How the clamps are shifted and turned; those of a sheet with mirrors are perfect.
    """

    odd_along: tuple[bool, bool, bool] | None = (True, False, False)
    odd_across: tuple[bool, bool, bool] | None = (False, True, True)
    clamps: Clamps = PERFECT

    @classmethod
    def mirrored(cls, parity: str = "antisymmetric") -> "Symmetry":
        """Return the symmetry of a state with both mirrors, solved on a quarter of the sheet.

        Parameters
        ----------
        parity : {'antisymmetric', 'symmetric'}
            Of the deflection across Y = 0.

        Raises
        ------
        ValueError
            If there is no such parity.
        """
        if parity not in PARITIES:
            raise ValueError(f"parity = {parity!r}: must be one of {', '.join(PARITIES)}")
        return cls(odd_across=(False, True, parity == "antisymmetric"))

    @classmethod
    def of_part(
        cls, part: str, parity: str = "antisymmetric", clamps: Clamps = PERFECT
    ) -> "Symmetry":
        """Return the symmetry with which a part of the sheet is solved.

        Parameters
        ----------
        part : {'quarter', 'half', 'half-width', 'whole'}
            With both mirrors; with that at X = 0 alone; with that at Y = 0 alone; with none.
        parity : {'antisymmetric', 'symmetric'}
            Of the deflection across Y = 0, where there is a mirror.
        clamps : Clamps

        Raises
        ------
        ValueError
            If there is no such part or parity, or a mirror does not go with the clamps.
        """
        if part not in PARTS:
            raise ValueError(f"symmetry = {part!r}: must be one of {', '.join(PARTS)}")
        if part != "whole" and not clamps.perfect:
            raise ValueError(f"symmetry = {part!r}: clamps that are off need 'whole'")
        both = cls.mirrored(parity)
        along = both.odd_along if part in ("quarter", "half") else None
        across = both.odd_across if part in ("quarter", "half-width") else None
        return cls(along, across, clamps)

    def broken(self, keeps_x: bool, keeps_y: bool) -> "Symmetry":
        """Return the symmetry of perturbations that keep or break each mirror of the state.

        Across a mirror that they break, all parities are reversed.
        """
        return Symmetry(
            self.odd_along if keeps_x else _opposite(self.odd_along),
            self.odd_across if keeps_y else _opposite(self.odd_across),
            self.clamps,
        )

    @property
    def clamp(self) -> Clamp:
        """The clamped ends of the part that is solved."""
        ends: tuple[Edge, ...] = ("left", "right") if self.odd_along is None else ("right",)
        factor = 1.0 if self.odd_across is None else 2.0
        return Clamp(ends, force_factor=factor, clamps=self.clamps)

    @property
    def held(self) -> tuple[HeldDofs, ...]:
        """What the mirrors hold."""
        held = []
        for component, odd in enumerate(self.odd_along or ()):
            names = _VALUE_AND_SLOPE_ALONG_Y if odd else ("u_x", "u_xy")
            held.append(HeldDofs(component, "left", names))
        for component, odd in enumerate(self.odd_across or ()):
            names = _VALUE_AND_SLOPE_ALONG_X if odd else ("u_y", "u_xy")
            held.append(HeldDofs(component, "lower", names))
        return tuple(held)

    def free(self, space: "Space") -> Mask:
        """Mark the degrees of freedom that neither mirrors nor clamps hold, (3, size)."""
        free = np.ones((3, space.size), dtype=bool)
        for component, edge, names in (*self.held, *self.clamp.held):
            free[component, space.edge_dofs(edge, names)] = False
        return free

    def lines(self, quarter: Grid) -> Grid:
        """Return the grid lines of the part that is solved from those of the quarter."""
        return Grid(
            _reflected(quarter.x) if self.odd_along is None else quarter.x,
            _reflected(quarter.y) if self.odd_across is None else quarter.y,
        )

    def unfold_along(self, lines: Array, nodes: Array) -> tuple[Array, Array]:
        """Return grid lines along X and nodes of the whole length from those of the part X >= 0.

        Parameters
        ----------
        lines : (nx + 1,) array
        nodes : (3, 4, nx + 1, ny + 1) array
            Deformed x, y, z with d/dX, d/dY, d2/dXdY.

        Returns
        -------
        (2 nx + 1,) and (3, 4, 2 nx + 1, ny + 1) arrays
            The same arrays as given if there is no mirror.
        """
        if self.odd_along is None:
            return lines, nodes
        mirrored = _signs(self.odd_along, (1.0, -1.0, 1.0, -1.0)) * nodes[:, :, :0:-1]
        return _reflected(lines), np.concatenate([mirrored, nodes], axis=2)

    def unfold_across(self, lines: Array, nodes: Array) -> tuple[Array, Array]:
        """Return grid lines along Y and nodes of the whole width, see `unfold_along`."""
        if self.odd_across is None:
            return lines, nodes
        mirrored = _signs(self.odd_across, (1.0, 1.0, -1.0, -1.0)) * nodes[..., :0:-1]
        return _reflected(lines), np.concatenate([mirrored, nodes], axis=3)


QUARTER = Symmetry()
NO_MIRRORS = Symmetry(None, None)


def _opposite(odd: tuple[bool, bool, bool] | None) -> tuple[bool, bool, bool] | None:
    return None if odd is None else (not odd[0], not odd[1], not odd[2])


def _signs(odd: tuple[bool, bool, bool], of_dofs: tuple[float, ...]) -> Array:
    """Return the signs that a mirror gives the four dofs of x, y, z, shape (3, 4, 1, 1)."""
    return np.multiply.outer(np.where(odd, -1.0, 1.0), of_dofs)[:, :, None, None]


def _reflected(lines: Array) -> Array:
    return np.concatenate([-lines[:0:-1], lines])
