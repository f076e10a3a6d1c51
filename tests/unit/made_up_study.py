"""A made-up study of sheets as the paper describes them, for the tests of the claims."""

import numpy as np
import pandas as pd
from made_up_rows import limits_row, state_row

from wrinklestudy.material.result import Fit
from wrinklestudy.results.rows import SheetRow
from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.studies.panaitescu2019 import theory
from wrinklestudy.study.claims.tables import FittedMaterial, StudyTables

STRAIN = np.round(np.arange(0.02, 0.501, 0.02), 12)
NEVER = {"birth": np.nan, "decay": np.nan}
CONSTANTS = {
    "mooney-rivlin": {"c10": 0.03e6, "c01": 1e6 / 6.0 - 0.03e6},
    "neo-hookean": {"c10": 0.15e6},
    "svk": {"young": 1e6},
}


def material(name="latex", law="mooney-rivlin", constants=None, rms=100.0, note="", source="m.csv"):
    constants = constants or CONSTANTS[law]
    count = len(constants)
    fit = Fit(
        law,
        constants,
        np.zeros((count, count)),
        (),
        rms,
        51,
        (1.0, 1.5),
        ("uniaxial",),
        1.0,
        source,
        3.5e5,
        0.0,
    )
    return FittedMaterial(name, fit, note)


def shape(strain, birth, peak, decay):
    """Rise from 0 at birth to 1 at the peak and fall to 0 at decay."""
    up = np.sin(0.5 * np.pi * (strain - birth) / (peak - birth)) ** 2
    down = np.cos(0.5 * np.pi * (strain - peak) / (decay - peak)) ** 2
    inside = (strain > birth) & (strain < decay)
    return np.where(inside, np.where(strain < peak, up, down), 0.0)


def sheet(
    material="latex",
    law="mooney-rivlin",
    bending="thinning",
    parity="antisymmetric",
    aspect=2.0,
    thickness=1e-3,
    birth=0.025,
    decay=0.4,
    peak=0.06,
    phi_max=1.25e-3,
    scale=1.0,
    excess=0.06,
    constants=(0.8, 0.1),
    central=(0.33, 0.015),
    limits=None,
    critical=1.5e-3,
    energy=-1.0,
    modulus=1e6,
    **columns,
):
    """Return a sheet whose wrinkles follow the paper: 0.8 x CM, A = C lambda Phi, C a + b eps."""
    never = not np.isfinite(birth)
    phi = np.zeros_like(STRAIN) if never else phi_max * shape(STRAIN, birth, peak, decay)
    on = phi > 0.0
    length = 0.8 * scale * theory.cm_wavelength(STRAIN, aspect, thickness)
    if not never:
        length = length * (1.0 + excess * np.exp(-(STRAIN - birth) / 0.02))
    c, c_central = (a + b * STRAIN for a, b in (constants, central))
    height = c * length * np.sqrt(phi)
    arc = 1.0 - 0.5 * STRAIN + 0.4 * np.maximum(STRAIN - 0.1, 0.0) ** 2
    table = {
        "strain": STRAIN,
        "amplitude_over_thickness": height / thickness,
        "wavelength_over_width": np.where(on, length, np.nan),
        "arc_width_over_width": arc,
        "projected_width_over_width": arc / (1.0 + phi),
        "planar_width_over_width": arc,
        "phi_squared": phi,
        "phi_squared_central": (height / (c_central * length)) ** 2,
        "shape_constant": np.where(on, c, np.nan),
        "shape_constant_central": np.where(on, c_central, np.nan),
        "young_modulus_pa": np.full_like(STRAIN, modulus),
        "flat_energy": STRAIN**2,
        "energy": STRAIN**2 + energy * phi**2,
        "sheet_amplitude_x_over_length": np.where(on, 0.0, np.nan),
        "envelope_amplitude_x_over_length": np.where(on, 0.0, np.nan),
        "sheet_amplitude_y_over_width": np.where(on, 0.03, np.nan),
    } | {name: np.broadcast_to(value, STRAIN.shape) for name, value in columns.items()}
    identity = {"material": material, "law": law, "bending": bending, "parity": parity}
    identity |= {"aspect": aspect, "thickness": thickness}
    rows = [dict(zip(table, numbers, strict=True)) for numbers in zip(*table.values(), strict=True)]
    states = tuple(
        state_row(**identity, status="wrinkled" if wrinkled else "flat", **numbers)
        for wrinkled, numbers in zip(on, rows, strict=True)
    )
    row = limits_row(
        *(limits or (birth, decay)),
        **identity,
        max_critical_thickness=critical if not never else min(critical, 0.9 * thickness),
        strain_at_max=0.12,
    )
    return SheetStates(SheetRow(**vars(row), **reached(table, never), **COUNTS), states)


COUNTS = {"wrinkled": 0, "flat": 0, "not_converged": 0, "cells_along": 6, "cells_across": 12}


def reached(table, never):
    """Return the largest samples of a sheet and where they are."""
    height, phi = table["amplitude_over_thickness"], table["phi_squared"]
    wavelengths = ("wavelength_over_width_at_max_amplitude",)
    wavelengths += ("min_wavelength_over_width", "max_wavelength_over_width")
    return dict.fromkeys(wavelengths) | {
        "max_amplitude_over_thickness": float(height.max()),
        "strain_at_max_amplitude": None if never else float(STRAIN[np.argmax(height)]),
        "max_phi_squared": float(phi.max()),
        "strain_at_max_phi_squared": None if never else float(STRAIN[np.argmax(phi)]),
    }


SHEETS = {
    "base": {},
    "fixed": {"material": "latex-fixed", "bending": "fixed-thickness"},
    "fvk": {"material": "latex-fvk", "bending": "fvk"},
    "even": {"material": "latex-symmetric", "parity": "symmetric", "energy": -0.9},
    "nh": {"material": "nh", "law": "neo-hookean", "decay": 0.26, "phi_max": 8e-4, "modulus": 9e5},
    "svk": {"material": "svk", "law": "svk", "decay": 0.13, "phi_max": 5e-4},
    "short": {"aspect": 1.5, **NEVER},
    "a18": {"aspect": 1.8, "critical": 1.4e-3},
    "a25": {"aspect": 2.5, "decay": 0.3, "critical": 1.3e-3},
    "a30": {"aspect": 3.0, "birth": 0.07, "peak": 0.1, "decay": 0.185, "critical": 1.1e-3},
    "a35": {"aspect": 3.5, **NEVER},
    "thin": {"thickness": 5e-4, "birth": 0.005, "decay": 0.7},
    "thick": {"thickness": 1.4e-3, "birth": 0.07, "peak": 0.09, "decay": 0.21},
    "thickest": {"thickness": 1.6e-3, **NEVER},
}
MATERIALS = (material(), material("nh", "neo-hookean"), material("svk", "svk"))


def world(materials=MATERIALS, wanted=("latex", 2.0, 1e-3), **changes):
    """Return a study as the paper has it, with changes of single sheets; None leaves one out."""
    assert changes.keys() <= SHEETS.keys()
    kept = {name: SHEETS[name] | (changes.get(name) or {}) for name in SHEETS}
    sheets = tuple(sheet(**kept[name]) for name in kept if changes.get(name, {}) is not None)
    return StudyTables(sheets, materials, wanted)


def field_table(factor=1.0, **columns):
    """Return a tension field with the sheet's arc width and a multiple of its Phi^2."""
    own = world().sheet.columns
    arc, phi_squared = own["arc_width_over_width"], factor * own["phi_squared"]
    table = {
        "material": "latex",
        "aspect": 2.0,
        "strain": STRAIN,
        "status": "wrinkled",
        "remainder": 0.0,
        "arc_width_over_width": arc,
        "projected_width_over_width": arc / (1.0 + phi_squared),
        "phi_squared": phi_squared,
    }
    return pd.DataFrame(table | columns)


def all_bending(**changes):
    return world(base=changes, fixed=changes, fvk=changes)


def lengths(**changes):
    return world(**dict.fromkeys(("base", "a18", "a25", "a30"), changes))
