"""Made-up sheets for the tests of the figures: tables and states whose numbers are known."""

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from made_up_rows import limits_row, state_row

from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.grid import Grid
from wrinklestudy.files.storage import write_h5
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.results.tables import write_states
from wrinklestudy.study.figures.inputs import Inputs

STRAINS = (0.02, 0.06, 0.1, 0.12, 0.2, 0.32, 0.36, 0.46)
BIRTH, DECAY, HOLE = 0.03, 0.4, 0.2
GRID_X, GRID_Y = np.linspace(0.0, 1.0, 7), np.linspace(0.0, 0.5, 21)


@dataclass(frozen=True)
class MadeUp:
    """A sheet with A/t = 100 scale (eps - birth)(decay - eps) and A = 0.7 lambda Phi.

    Phi over the central wrinkle is twice Phi over the full width. Without a birth strain the sheet
    is flat throughout; ``holes`` did not converge.
    """

    material: str = "latex"
    law: str = "mooney-rivlin"
    bending: str = "thinning"
    aspect: float = 2.0
    thickness: float = 1e-3
    scale: float = 1.0
    birth: float | None = BIRTH
    decay: float | None = DECAY
    holes: tuple[float, ...] = (HOLE,)
    cells_per_wavelength: float = 9.0

    def amplitude(self, strain):
        """A/t where the sheet is wrinkled."""
        return 100.0 * self.scale * (strain - self.birth) * (self.decay - strain)

    def status(self, strain):
        if strain in self.holes:
            return "not-converged"
        return "wrinkled" if self.birth and self.birth < strain < self.decay else "flat"

    @property
    def identity(self):
        names = ("material", "law", "bending", "aspect", "thickness")
        return {name: getattr(self, name) for name in names}

    def row(self, strain):
        status, width = self.status(strain), (1.0 + strain) ** -0.5
        values = {}
        if status == "flat":
            zeros = ("amplitude_over_thickness", "phi_squared", "phi_squared_central")
            values = dict.fromkeys(zeros, 0.0) | {"arc_width_over_width": width}
        if status == "wrinkled":
            amplitude, wavelength = self.amplitude(strain), 0.14 - 0.1 * strain
            phi_squared = (amplitude * self.thickness / (0.7 * wavelength)) ** 2
            values = {"amplitude_over_thickness": amplitude, "wavelength_over_width": wavelength}
            values |= {"phi_squared": phi_squared, "phi_squared_central": 4.0 * phi_squared}
            values |= {"arc_width_over_width": width}
            values |= {"cells_per_wavelength": self.cells_per_wavelength}
        return state_row(strain, status, **self.identity, **values)

    def write(self, folder, strains=STRAINS):
        """Write table and stability file and return their paths."""
        stem = f"{self.material}{self.aspect:g}_{self.thickness:g}"
        table, limits = folder / f"{stem}.csv", folder / f"{stem}.json"
        write_states([self.row(strain) for strain in strains], table)
        row = limits_row(self.birth, self.decay, max_critical_thickness=1.5e-3, **self.identity)
        limits.write_text(json.dumps(vars(row)))
        return table, limits

    def position(self, strain):
        """A stretched sheet with z = A sin(k Y) exp(-(Y/0.2)^2) cos^2(pi X / 2)."""
        wrinkled = self.status(strain) == "wrinkled"
        amplitude = self.thickness * self.amplitude(strain) if wrinkled else 0.0
        k = 2.0 * np.pi / (0.14 - 0.1 * strain)
        f, df = np.cos(0.5 * np.pi * GRID_X) ** 2, -0.5 * np.pi * np.sin(np.pi * GRID_X)
        packet = np.exp(-((GRID_Y / 0.2) ** 2))
        g = np.sin(k * GRID_Y) * packet
        dg = (k * np.cos(k * GRID_Y) - 50.0 * GRID_Y * np.sin(k * GRID_Y)) * packet
        field = np.zeros((3, 4, 7, 21))
        field[0, 0], field[0, 1] = (1.0 + strain) * GRID_X[:, None], 1.0 + strain
        narrow = (1.0 + strain) ** -0.5
        field[1, 0], field[1, 2] = narrow * GRID_Y, narrow
        field[2] = amplitude * np.stack([np.outer(a, b) for b in (g, dg) for a in (f, df)])
        return field

    def shape(self, strain):
        """The state as it is read back; None where it did not converge."""
        if self.status(strain) == "not-converged":
            return None
        return DeformedSheet(Grid(GRID_X, GRID_Y), self.position(strain), Symmetry.mirrored())

    def write_state(self, folder, strain):
        """Write a wrinkle file without history and return its path."""
        path = folder / f"{self.material}{strain}.h5"
        datasets = {"grid/x": GRID_X, "grid/y": GRID_Y, "position": self.position(strain)}
        write_h5(path, datasets, vars(self.row(strain)))
        return path


def inputs_of(folder, sheets, states=(), **files):
    """Inputs of some sheets, with the states of the first of them."""
    tables, limits = zip(*(sheet.write(folder) for sheet in sheets), strict=True)
    paths = tuple(sheets[0].write_state(folder, strain) for strain in states)
    return Inputs(metrics=tables, stability=limits, states=paths, **files)


@pytest.fixture(scope="session")
def made_up():
    """The class of made-up sheets."""
    return MadeUp


@pytest.fixture
def inputs_with(tmp_path):
    """Make the inputs of a figure of made-up sheets."""
    return lambda *sheets, **options: inputs_of(tmp_path, sheets, **options)


@pytest.fixture(scope="session")
def inputs(tmp_path_factory) -> Inputs:
    """The inputs of the figures of a single sheet."""
    return inputs_of(tmp_path_factory.mktemp("study"), [MadeUp()], STRAINS)


@pytest.fixture(scope="session")
def materials(tmp_path_factory) -> Inputs:
    """The inputs of the figure of materials."""
    from wrinklestudy.stages import material

    data = Path(__file__).parents[2] / "data"
    folder = tmp_path_factory.mktemp("materials")
    latex, rubber = data / "latex_panaitescu2019.csv", data / "treloar1944.csv"
    material.run("mooney-rivlin", "latex", folder / "latex.json", csv=latex)
    material.run("neo-hookean", "nh", folder / "nh.json", csv=latex)
    material.run("svk", "svk", folder / "svk.json", csv=latex)
    material.run(
        "mooney-rivlin",
        "uni",
        folder / "uni.json",
        csv=rubber,
        stretch=(1, 1.65),
        modes=["uniaxial"],
    )
    material.run("mooney-rivlin", "all", folder / "all.json", csv=rubber, stretch=(1, 1.65))
    names = ("latex", "nh", "svk", "uni", "all")
    return Inputs(materials=tuple(folder / f"{name}.json" for name in names), data=(latex, rubber))


@pytest.fixture
def experiment(tmp_path):
    """Write measured data of a sheet of L/W = 2, t/W = 1e-3 and return its paths."""
    folder = tmp_path / "experiment"
    (folder / "profiles").mkdir(parents=True)
    (folder / "stress.csv").write_text("strain,stress_pa,error_pa\n0.1,1.1e5,5e3\n0.6,4e5,\n")
    (folder / "amplitude.csv").write_text(
        "aspect,thickness,strain,amplitude_over_thickness,error\n"
        "2,1e-3,0.1,2.5,0.2\n2,0.001,0.3,4.5,0.3\n2.0,1e-3,0.55,0,0.1\n3,1e-3,0.1,1.5,0.2\n"
        "2,7e-4,0.1,5,\n"
    )
    (folder / "wavelength.csv").write_text(
        "aspect,thickness,strain,wavelength_over_width\n2,1e-3,0.1,0.15\n"
    )
    for strain in (0.1, 0.2):
        write_scan(folder / "profiles" / f"{strain}.csv", strain)
    return tuple(sorted(folder.rglob("*.csv")))


# Deflection in mm of the scans, and their wavelength in the middle.
SCAN = {"width": 140.0, "amplitude": 0.35, "wavelength": 17.0, "noise": 0.004}


def write_scan(path, strain, aspect=2.0, thickness=1e-3, points=1200, extra=""):
    """Write a scan in mm with an offset, a tilt and noise; y runs down, from the right edge."""
    rng = np.random.default_rng(round(1000 * strain))
    half = 0.5 * SCAN["width"] * (1.0 + strain) ** -0.5
    y = np.linspace(-half, half, points)
    wave = np.sin(2.0 * np.pi * y / SCAN["wavelength"]) * np.exp(-((y / 40.0) ** 4))
    noise = SCAN["noise"] * rng.standard_normal(points)
    w = 3.0 + 0.01 * y + SCAN["amplitude"] * wave + noise
    header = f"# made up\n# aspect: {aspect}\n# thickness: {thickness}\n# strain: {strain}\n"
    rows = "".join(f"{a:.5f},{b:.5f},7\n" for a, b in zip(y[::-1] + 200.0, w[::-1], strict=True))
    path.write_text(f"{header}# width: {SCAN['width']}\n{extra}y,w,brightness\n{rows}")
    return path
