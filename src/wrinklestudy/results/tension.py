"""What is kept of tension fields: a row for each strain, and the fields at all strains."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from wrinklestudy.files.storage import read_h5, write_h5
from wrinklestudy.mechanics import laws
from wrinklestudy.results.rows import Row, columns, described
from wrinklestudy.typing import AnyPath, Array
from wrinklestudy.vocabulary import STATUSES, Status

if TYPE_CHECKING:  # to read a table needs no finite elements
    from wrinklestudy.equilibrium.tension_field import TensionField

_LINES = 101  # lines X = const on which the widths are kept


@dataclass(frozen=True)
class TensionRow(Row):
    """The tension field of one material, L/W and strain: the sheet without thickness."""

    material: str = described("name of the material", identifies=True)
    law: str = described("law of the strain energy", identifies=True)
    aspect: float = described("L/W", identifies=True)
    strain: float = described("eps = (L' - L)/L of the clamps", identifies=True, shown=True)
    status: Status = described(  # noqa: RUF009 (a field with metadata, like all the others)
        "wrinkled, flat (taut everywhere on X = 0 and Y = 0) or not-converged",
        allowed=STATUSES,
        shown=True,
    )
    phi_squared: float | None = described("Phi^2 = (W_arc - W_proj)/W_proj on X = 0", shown=True)
    phi_squared_error: float | None = described(
        "its largest difference from a mesh with half the cells in each direction, |X| <= W/4",
        shown=True,
    )
    phi_squared_central: float | None = described(
        "Phi^2 at the centre: natural over actual width, less one; 0 if taut", shown=True
    )
    arc_width_over_width: float | None = described(
        "W_arc/W, length of X = 0 with what the wrinkles hide", shown=True
    )
    projected_width_over_width: float | None = described(
        "W_proj/W, distance of the free edges on X = 0", shown=True
    )
    wrinkled_width_over_width: float | None = described(
        "wrinkled part of X = 0 in the undeformed sheet, to about a cell", shown=True
    )
    wrinkled_length_over_length: float | None = described(
        "wrinkled part of Y = 0 over L in the undeformed sheet", shown=True
    )
    nominal_stress_pa: float | None = described(
        "clamp force over undeformed cross-section", "Pa", shown=True
    )
    remainder: float = described(
        "delta, part of the law itself that is left in the relaxed energy: 0 unless Newton's "
        "method failed on the way there",
        shown=True,
    )
    newton_iterations: int = described("Newton iterations on the mesh", shown=True)
    cells_along: int = described("cells of the quarter along the pull")
    cells_across: int = described("cells of the quarter across")
    reason: str = described("why it did not converge; empty if it did", shown=True)


def tension_row(field: "TensionField", material: laws.Material, name: str) -> TensionRow:
    """Return what is measured on a tension field as a row.

    Parameters
    ----------
    field : TensionField
    material : Material
    name : str
        Name of the material.
    """
    from wrinklestudy.metrics.confinement import confinement, mesh_error

    along, across = field.space.grid.cells
    row: dict[str, Any] = {
        "material": name,
        "law": str(laws.describe(material)["law"]),
        "aspect": field.space.grid.aspect,
        "strain": field.strain,
        "status": "not-converged",
        "remainder": field.remainder,
        "newton_iterations": len(field.history),
        "cells_along": along,
        "cells_across": across,
        "reason": field.reason,
    }
    missing = dict.fromkeys(columns(TensionRow).keys() - row.keys())
    if not field.converged:
        return TensionRow(**row | missing)
    measured = confinement(field)
    coarser = field.coarser
    error = None
    if coarser is not None and coarser.converged and coarser.remainder == field.remainder:
        error = mesh_error(field, coarser)
    wrinkled = max(measured.wrinkled_width, measured.wrinkled_length_over_length) > 0.0
    return TensionRow(
        **row
        | missing
        | {
            "status": "wrinkled" if wrinkled else "flat",
            "phi_squared": measured.phi_squared,
            "phi_squared_error": error,
            "phi_squared_central": measured.phi_squared_central,
            "arc_width_over_width": measured.arc_width,
            "projected_width_over_width": measured.projected_width,
            "wrinkled_width_over_width": measured.wrinkled_width,
            "wrinkled_length_over_length": measured.wrinkled_length_over_length,
            "nominal_stress_pa": field.force * material.shear_modulus,
        }
    )


@dataclass(frozen=True, eq=False)
class FieldLines:
    """Widths of one tension field along the sheet.

    Parameters
    ----------
    material : str
        Name of the material.
    aspect, strain : float
    x : (m,) array
        Material coordinate of lines X = const over W, from the middle to the clamp.
    arc_width, projected_width : (m,) arrays
        Of each line over W.
    excess : (m, n) array
        Natural over actual width, less one, on a grid of points.
    y : (n,) array
        Material coordinate of these points over W, from the mid-line to the free edge.
    direction : (m, n) array
        Angle of the fibre, the line of the larger stretch, with the x axis of the undeformed sheet.
    """

    material: str
    aspect: float
    strain: float
    x: Array
    arc_width: Array
    projected_width: Array
    excess: Array
    y: Array
    direction: Array

    @property
    def phi_squared(self) -> Array:
        """(W_arc - W_proj)/W_proj of each line, (m,)."""
        return self.arc_width / self.projected_width - 1.0


def write_tension(
    fields: Sequence["TensionField"], material: laws.Material, name: str, output: AnyPath
) -> None:
    """Write the fields of one sheet at all strains as an HDF5 file, those that converged."""
    from wrinklestudy.metrics.confinement import confined_widths, sample

    grid = fields[0].space.grid
    x = np.linspace(0.0, grid.x[-1], _LINES)
    y = np.linspace(0.0, grid.y[-1], _LINES)
    converged = [field for field in fields if field.converged]
    widths = np.array([confined_widths(field, x) for field in converged]).reshape(-1, 2, _LINES)
    points = [sample(field, x, y) for field in converged]
    excess = np.array([point.excess for point in points])
    direction = np.array([point.direction for point in points])
    datasets = {
        "grid/x": grid.x,
        "grid/y": grid.y,
        "strain": np.array([field.strain for field in converged]),
        "position": np.array([field.nodes for field in converged]),
        "lines/x": x,
        "lines/y": y,
        "lines/arc_width": widths[:, 0],
        "lines/projected_width": widths[:, 1],
        "lines/excess": excess.reshape(-1, _LINES, _LINES).astype(np.float32),
        "lines/direction": direction.reshape(-1, _LINES, _LINES).astype(np.float32),
    }
    attrs = {
        "units": "lengths in W",
        "material": name,
        **laws.describe(material),
        "aspect": grid.aspect,
    }
    write_h5(output, datasets, attrs)


def read_lines(path: AnyPath) -> list[FieldLines]:
    """Return the widths of all tension fields of a file, by strain."""
    data, attrs = read_h5(path)
    return [
        FieldLines(
            attrs["material"],
            attrs["aspect"],
            float(data["strain"][k]),
            data["lines/x"],
            data["lines/arc_width"][k],
            data["lines/projected_width"][k],
            data["lines/excess"][k],
            data["lines/y"],
            data["lines/direction"][k],
        )
        for k in range(len(data["strain"]))
    ]
