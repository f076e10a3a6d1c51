"""The thickness of an uneven sheet over its mean thickness, as a function of the place."""

import math
from dataclasses import dataclass, field

import numpy as np

from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import RELATIVE_THICKNESS, UNEVENNESS, WAVELENGTH


@dataclass(frozen=True)
class Ripple:
    """A wave of the thickness, amplitude cos(2 pi (x cos a + y sin a)/wavelength + phase).

    Parameters
    ----------
    amplitude : float
        In parts of the mean thickness.
    wavelength : float
        In units of W.
    direction : float
        Angle a of its crests' normal with the pull, in radians: pi/2 for a wave across.
    phase : float
        In radians; 0 puts a crest at the centre of the sheet.
    """

    amplitude: float
    wavelength: float
    direction: float = math.pi / 2
    phase: float = 0.0

    def __post_init__(self) -> None:
        for name, limits in (("amplitude", UNEVENNESS), ("wavelength", WAVELENGTH)):
            if (value := getattr(self, name)) not in limits:
                raise ValueError(f"ripple {name} = {value:g}: must be {limits}")

    def values(self, x: Array, y: Array) -> Array:
        """Return the wave at points."""
        along = x * math.cos(self.direction) + y * math.sin(self.direction)
        wave: Array = self.amplitude * np.cos(2.0 * math.pi * along / self.wavelength + self.phase)
        return wave


@dataclass(frozen=True)
class ThicknessTable:
    """Measured thicknesses on a tensor grid of places, with the cubic spline through them.

    Parameters
    ----------
    x, y : tuple of float
        Places along and across from the centre, in units of W, increasing; they must reach from
        end to end and from edge to edge.
    thickness : tuple of tuples of float
        One row for each x, in any unit: what counts is the ratio to the mean over the sheet.

    Raises
    ------
    ValueError
        If the table is no such grid; one line.
    """

    x: tuple[float, ...]
    y: tuple[float, ...]
    thickness: tuple[tuple[float, ...], ...]

    def __post_init__(self) -> None:
        for name in ("x", "y"):
            places = np.array(getattr(self, name))
            if len(places) < 2 or not np.all(np.diff(places) > 0.0):
                raise ValueError(f"thickness table, {name}: needs two or more places, increasing")
        values = self._values
        if values.shape != (len(self.x), len(self.y)):
            raise ValueError(
                f"thickness table: needs {len(self.x)} x {len(self.y)} values, one for each place"
            )
        if not (np.isfinite(values).all() and values.min() > 0.0):
            raise ValueError("thickness table: each thickness must be > 0")

    @property
    def _values(self) -> Array:
        if len({len(row) for row in self.thickness}) != 1:
            return np.empty((0, 0))
        return np.array(self.thickness, dtype=np.float64)

    def check_reach(self, aspect: float) -> None:
        """Raise a ValueError of one line if the table does not reach over a sheet of this L/W."""
        for name, places, half in (("x", self.x, 0.5 * aspect), ("y", self.y, 0.5)):
            if places[0] > -half * (1.0 - 1e-9) or places[-1] < half * (1.0 - 1e-9):
                raise ValueError(
                    f"thickness table, {name}: reaches from {places[0]:g} to {places[-1]:g}, the "
                    f"sheet from {-half:g} to {half:g} (in units of W)"
                )

    def values(self, x: Array, y: Array) -> Array:
        """Return the thickness at points, in the unit of the table."""
        from scipy.interpolate import RectBivariateSpline

        orders = (min(3, len(self.x) - 1), min(3, len(self.y) - 1))
        spline = RectBivariateSpline(self.x, self.y, self._values, kx=orders[0], ky=orders[1])
        values: Array = spline.ev(x, y)
        return values


@dataclass(frozen=True)
class ThicknessField:
    """How the thickness of a sheet varies: t(x, y) over the mean t.

    Parameters
    ----------
    along : float
        Difference between right and left end in parts of t, linear in between.
    across : float
        Difference between the edges y = W/2 and y = -W/2 in parts of t, linear in between.
    ripples : tuple of Ripple
    table : ThicknessTable, optional
        Measured values, in place of a uniform sheet; gradients and ripples come on top.

    Raises
    ------
    ValueError
        If a number is not allowed; one line.
    """

    along: float = 0.0
    across: float = 0.0
    ripples: tuple[Ripple, ...] = field(default=())
    table: ThicknessTable | None = None

    def __post_init__(self) -> None:
        for name in ("along", "across"):
            if (value := getattr(self, name)) not in UNEVENNESS:
                raise ValueError(f"thickness {name} = {value:g}: must be {UNEVENNESS}")

    @property
    def uniform(self) -> bool:
        """Whether the thickness is the same everywhere."""
        return self == ThicknessField()

    def relative(self, x: Array, y: Array, aspect: float) -> Array:
        """Return t(x, y) over the mean at points.

        Parameters
        ----------
        x, y : arrays
            From the centre, in units of W.
        aspect : float
            L/W.

        Raises
        ------
        ValueError
            If it is nowhere near 1 somewhere; one line.
        """
        values = 1.0 + self.along * x / aspect + self.across * y
        if self.table is not None:
            self.table.check_reach(aspect)
            values += self.table.values(x, y) / _mean(self.table, aspect) - 1.0
        for ripple in self.ripples:
            values = values + ripple.values(x, y)
        for extreme in (float(values.min()), float(values.max())):
            if extreme not in RELATIVE_THICKNESS:
                raise ValueError(
                    f"thickness over its mean = {extreme:g}: must be {RELATIVE_THICKNESS}"
                )
        return values

    def keeps(self, mirror_x: bool, mirror_y: bool, aspect: float) -> bool:
        """Return whether the thickness is the same after x -> -x, y -> -y or both."""
        x, y = np.meshgrid(*_samples(aspect), indexing="ij")
        here = self.relative(x, y, aspect)
        there = self.relative(-x if mirror_x else x, -y if mirror_y else y, aspect)
        return bool(np.abs(there - here).max() < _SAME)


UNIFORM = ThicknessField()
_SAMPLES = (41, 41)
_SAME = 1e-9


def _samples(aspect: float) -> tuple[Array, Array]:
    """Return places over the sheet, along and across."""
    along, across = (np.linspace(-0.5, 0.5, count) for count in _SAMPLES)
    return aspect * along, across


def _mean(table: ThicknessTable, aspect: float) -> float:
    """Return the mean thickness of a table over the sheet."""
    points, weights = np.polynomial.legendre.leggauss(64)
    x, y = np.meshgrid(0.5 * aspect * points, 0.5 * points, indexing="ij")
    return float(0.25 * weights @ table.values(x, y) @ weights)
