"""The made-up measurements of docs/tutorial.md: a tensile test and a scan of one rubber.

    python data/tutorial/make.py FOLDER

A Mooney-Rivlin rubber of known constants is pulled as a strip, and as a sheet whose computed
wrinkles are scanned; noise, tilt and lost points are added, the same at every run.
"""

import sys
from pathlib import Path

import numpy as np

from wrinklestudy import Sheet, mooney_rivlin
from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.profile import profile_from_state

RUBBER = mooney_rivlin(c10=0.08e6, c01=0.12e6)
GAUGE, WIDTH, THICKNESS = 80.0, 10.0, 1.0  # of the strip, mm
SHEET_WIDTH, STRAIN = 140.0, 0.12  # of the sheet, mm; where it was scanned
MADE_UP = "# made up for the tutorial by data/tutorial/make.py: no measurement\n"


def tensile(rng: np.random.Generator) -> str:
    """Return the export of a testing machine: force against extension of a strip."""
    extension = np.arange(0.0, 60.1, 1.0)
    stress = nominal_stress(RUBBER, 1.0 + extension / GAUGE)
    force = 1e-6 * stress * WIDTH * THICKNESS
    force += 2e-3 * rng.standard_normal(len(force)) * (extension > 0.0)
    rows = "".join(f"{e:.3f},{f:.4f}\n" for e, f in zip(extension, force, strict=True))
    header = f"# gauge length: {GAUGE:g} mm\n# width: {WIDTH:g} mm\n# thickness: {THICKNESS:g} mm\n"
    return f"{MADE_UP}{header}Extension,Load\n(mm),(N)\n{rows}"


def scan(rng: np.random.Generator) -> str:
    """Return a scan across the middle of the wrinkled sheet, in mm."""
    sheet = Sheet(aspect=2.0, thickness=1e-3, material=RUBBER)
    state = sheet.solve(STRAIN)
    position = state.equilibrium.position
    if position is None:
        raise RuntimeError(f"strain {STRAIN:g}: {state.status}")
    nodes = sheet.space.nodes_from_field(position)
    profile = profile_from_state(DeformedSheet(sheet.space.grid, nodes, sheet.settings.symmetry))
    y = np.linspace(profile.y[0], profile.y[-1], 700)
    w = SHEET_WIDTH * np.interp(y, profile.y, profile.z)
    y = SHEET_WIDTH * y
    w += 1.7 - 0.004 * y + 0.01 * rng.standard_normal(len(y))
    w[rng.integers(0, len(w), 12)] = -9999.0
    header = f"# aspect: 2\n# thickness: 0.001\n# strain: {STRAIN:g}\n# width: {SHEET_WIDTH:g}\n"
    rows = "".join(f"{a:.3f},{b:.4f}\n" for a, b in zip(y, w, strict=True))
    return f"{MADE_UP}{header}y,w\n{rows}"


def main(folder: Path) -> None:
    """Write both files."""
    rng = np.random.default_rng(2019)
    (folder / "experiment" / "profiles").mkdir(parents=True, exist_ok=True)
    (folder / "tensile.csv").write_text(tensile(rng), encoding="utf-8")
    profile = folder / "experiment" / "profiles" / f"strain{STRAIN:g}.csv"
    profile.write_text(scan(rng), encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python data/tutorial/make.py FOLDER")
    main(Path(sys.argv[1]))
