"""The deformed sheet with its stresses as a VTU file, which ParaView opens."""

from dataclasses import dataclass

import numpy as np

from wrinklestudy.files.origin import append_comment
from wrinklestudy.files.storage import atomic_path
from wrinklestudy.metrics.stress import SampledStress
from wrinklestudy.typing import AnyPath, Array

SUFFIXES = (".vtu",)


@dataclass(frozen=True)
class LengthUnit:
    """The unit in which lengths are given.

    Parameters
    ----------
    name : str
        As in the names of fields: 'mm', or 'over_width' for lengths in units of W.
    width : float
        W in that unit.
    """

    name: str = "over_width"
    width: float = 1.0


IN_WIDTHS = LengthUnit()


def write_vtu(
    sampled: SampledStress, shear_modulus: float, output: AnyPath, unit: LengthUnit = IN_WIDTHS
) -> None:
    """Write the deformed surface as quadrilaterals with fields at their corners.

    Points are the deformed positions. Fields, with the unit in their names:

    - ``displacement``, ``reference_position``: lengths;
    - ``stretch_1``, ``stretch_2``: principal stretches of the mid-surface, the larger first;
      ``stretch_thickness``: thickness over thickness at rest;
    - ``cauchy_xx_pa``, ``cauchy_yy_pa``, ``cauchy_xy_pa``: true stress in the tangent plane, x
      along the material lines of the pull; ``cauchy_1_pa``, ``cauchy_2_pa``: its principal values;
    - ``bending_energy_density_pa``: energy of bending per volume at rest (J/m^3 = Pa).

    Parameters
    ----------
    sampled : SampledStress
    shear_modulus : float
        mu in Pa.
    output : path-like
        File to write, whole or not at all.
    unit : LengthUnit
        Of lengths.
    """
    import meshio

    x, y = sampled.reference_x, sampled.reference_y
    reference = np.stack([*np.meshgrid(x, y, indexing="ij"), np.zeros((len(x), len(y)))])
    points = unit.width * _rows(sampled.position)
    rest = unit.width * _rows(reference)
    fields = {
        f"displacement_{unit.name}": points - rest,
        f"reference_position_{unit.name}": rest,
        "stretch_1": sampled.principal_stretches[0],
        "stretch_2": sampled.principal_stretches[1],
        "stretch_thickness": sampled.thickness_stretch,
        "cauchy_xx_pa": shear_modulus * sampled.cauchy[0],
        "cauchy_yy_pa": shear_modulus * sampled.cauchy[1],
        "cauchy_xy_pa": shear_modulus * sampled.cauchy[2],
        "cauchy_1_pa": shear_modulus * sampled.principal_cauchy[0],
        "cauchy_2_pa": shear_modulus * sampled.principal_cauchy[1],
        "bending_energy_density_pa": shear_modulus * sampled.bending_energy,
    }
    point_data = {
        name: values if values.shape == points.shape else values.ravel()
        for name, values in fields.items()
    }
    mesh = meshio.Mesh(points, [("quad", _quads(len(x), len(y)))], point_data=point_data)
    with atomic_path(output) as path:
        meshio.write(path, mesh)
        append_comment(path)


def _rows(field: Array) -> Array:
    """Return vectors (3, m, n) as rows (m n, 3)."""
    return np.ascontiguousarray(field.reshape(3, -1).T)


def _quads(m: int, n: int) -> Array:
    """Return the corners of the cells of an m x n grid of points, counterclockwise, (cells, 4)."""
    numbers = np.arange(m * n).reshape(m, n)
    corners = (numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:])
    return np.stack([corner.ravel() for corner in corners], axis=1)
