"""What the tables of the solid say: limits in mesh and K/mu, and what the rest is made of."""

from typing import NamedTuple

import numpy as np
import pandas as pd

from verification.tools import solid_table as solid
from verification.tools.solid_table import SolidCase, case
from wrinklestudy.sheet import Sheet

_ORDER = 4  # of convergence
PAPER = ("paper", 1.0e-3)


class Estimate(NamedTuple):
    """A strain of the solid, extrapolated in the mesh and in K/mu."""

    strain: float
    bar: float
    finest: float
    mesh_step: float  # what extrapolation in the mesh adds
    bulk_step: float  # what extrapolation in K/mu adds


class Pieces(NamedTuple):
    """What the difference of the decay strains of solid and plate is made of."""

    difference: float
    shear: float
    clamp: float
    layers: float


def extrapolated(coarse: float, fine: float, ratio: float) -> float:
    """Return the limit of a sequence whose error falls with the fourth power of the cell size.

    Parameters
    ----------
    coarse, fine : float
    ratio : float
        Cells of the finer mesh over those of the coarser.
    """
    return fine + (fine - coarse) / (ratio**_ORDER - 1.0)


def strain_of(ends: pd.DataFrame, end: str, wanted: SolidCase) -> float:
    """Return the birth or decay strain of a case from the table."""
    return float(solid.rows_of(ends, wanted)[end].iloc[0])


def bulk_step(ends: pd.DataFrame, end: str) -> float:
    """Return what is lacking at K/mu = 1e4: the error falls like mu/K from K/mu = 1000 on."""
    soft, stiff = (
        strain_of(ends, end, case("paper", 1.0e-3, solid.FINE, bulk))
        for bulk in (1.0e3, solid.STIFF)
    )
    return (stiff - soft) / (solid.STIFF / 1.0e3 - 1.0)


def clamp_step(ends: pd.DataFrame, end: str, cells: tuple[int, int]) -> float:
    """Return what holding the whole face at the clamp adds on a mesh."""
    line, face = (
        strain_of(ends, end, case("paper", 1.0e-3, cells, clamp=clamp))
        for clamp in ("line", "face")
    )
    return face - line


def estimate(ends: pd.DataFrame, end: str, sheet: tuple[str, float]) -> Estimate:
    """Return the best value of a strain, with what both extrapolations add as its error bar."""
    is_paper = sheet == PAPER
    meshes = (solid.FINE, solid.FINEST) if is_paper else (solid.MIDDLE, solid.FINE)
    coarse, fine = (strain_of(ends, end, case(*sheet, cells)) for cells in meshes)
    limit = extrapolated(coarse, fine, meshes[1][0] / meshes[0][0])
    more = bulk_step(ends, end)
    return Estimate(limit + more, abs(limit - fine) + abs(more), fine, limit - fine, more)


def pieces_of(ends: pd.DataFrame, best: Estimate) -> Pieces:
    """Return what the difference of the decay strains is made of.

    Transverse shear makes a plate softer by 2/5 (k t)^2 with the wave number k (nu = 1/2, shear
    factor 5/6), so that tau_1 grows by half of that and the decay strain by its slope.
    """
    plate = solid.plate_ends("paper", 1.0e-3)[1]
    sheet = Sheet(2.0, 1.0e-3, solid.MATERIALS["paper"])
    below, above = (sheet.mode(plate + step).critical_thickness for step in (-0.005, 0.005))
    y = np.linspace(0.0, 0.5, 4001)
    across = sheet.mode(plate).deflection(0.0, y)
    turning = y[np.flatnonzero(np.diff(np.sign(np.diff(across)))) + 1]
    wave_number = np.pi / float(turning[1] - turning[0])
    softer = 0.4 * (wave_number * 1.0e-3) ** 2
    usual, two = (
        strain_of(ends, "decay", case("paper", 1.0e-3, solid.FINE, layers=layers))
        for layers in (1, 2)
    )
    clamp = clamp_step(ends, "decay", solid.FINEST)
    shear = 0.5 * softer * 1.0e-3 * 0.01 / (below - above)
    return Pieces(best.strain - plate, shear, clamp, two - usual)
