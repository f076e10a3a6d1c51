"""The paper's latex sheet on the default mesh: refinement, independent data, birth and decay."""

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from wrinklestudy import MeshSettings, Sheet, mooney_rivlin

LATEX = mooney_rivlin(c10=6.21e4, c01=1.58e5)
REFERENCE = pd.read_csv(
    Path(__file__).parents[2] / "data/isogeometric_fixed_thickness.csv",
    comment="#",
    index_col="eps",
)

# A prototype's values, converged to 0.2%: strain, A/t, Phi^2, and W_act/W to the last digit given
PROTOTYPE = [
    (0.06, 2.609, 6.73e-4, 0.9700),
    (0.12, 3.148, 1.238e-3, 0.9426),
    (0.20, 2.907, 1.215e-3, 0.9092),
    (0.30, 2.066, 6.72e-4, 0.8718),
    (0.37, 1.090, 1.95e-4, 0.8480),
]


@pytest.fixture(scope="module")
def sheet():
    return Sheet(aspect=2, thickness=1e-3, material=LATEX)


@pytest.mark.parametrize(("strain", "amplitude", "phi_squared", "arc_width"), PROTOTYPE)
def test_amplitude_and_confinement(sheet, strain, amplitude, phi_squared, arc_width):
    found = sheet.solve(strain)
    assert found.status == "wrinkled"
    assert found.equilibrium.unstable_directions == 0
    assert found.measures.amplitude / 1e-3 == pytest.approx(amplitude, rel=0.007)
    assert found.measures.phi_squared == pytest.approx(phi_squared, rel=0.015)
    assert found.measures.arc_width == pytest.approx(arc_width, abs=1.5e-4)


@pytest.mark.parametrize("strain", [0.12, 0.37])
def test_twice_the_cells_move_the_amplitude_little(sheet, strain):
    fine = Sheet(aspect=2, thickness=1e-3, material=LATEX, mesh=MeshSettings(48, 72))
    coarse_amplitude = sheet.solve(strain).measures.amplitude
    assert coarse_amplitude == pytest.approx(fine.solve(strain).measures.amplitude, rel=0.007)


@pytest.fixture(scope="module")
def stability(sheet):
    return sheet.stability()


def test_birth_and_decay(sheet, stability):
    found = stability
    assert found.birth_strain == pytest.approx(0.0247, abs=0.0007)
    assert found.decay_strain == pytest.approx(0.398, abs=0.003)
    assert sheet.solve(found.birth_strain - 0.001).status == "flat"
    assert sheet.solve(found.birth_strain + 0.001).status == "wrinkled"
    assert sheet.solve(found.decay_strain - 0.002).status == "wrinkled"
    assert sheet.solve(found.decay_strain + 0.002).status == "flat"


@pytest.mark.parametrize("strain", [0.06, 0.12, 0.17, 0.23])
def test_fixed_thickness_agrees_with_an_isogeometric_code(strain):
    """Amplitude, projected width and clamp force of an independent shell code."""
    found = Sheet(2, 1e-3, LATEX, bending="fixed-thickness").solve(strain)
    expected = REFERENCE.loc[strain]
    assert found.measures.amplitude / 1e-3 == pytest.approx(expected.A_over_t, rel=0.002)
    width = found.measures.projected_width
    assert width == pytest.approx(expected.projected_width_ratio, abs=2e-5)
    force = found.equilibrium.nominal_stress * LATEX.shear_modulus * 0.14 * 0.14e-3
    assert force == pytest.approx(expected.clamp_force_N, rel=1e-5)


def test_fixed_thickness_birth_and_decay():
    found = Sheet(2, 1e-3, LATEX, bending="fixed-thickness").stability()
    assert found.birth_strain == pytest.approx(0.0250, abs=0.0007)
    assert found.decay_strain == pytest.approx(0.3247, abs=0.0025)


def test_amplitude_grows_again_from_zero_like_a_square_root(sheet, stability):
    """A^2 is linear in the distance from the decay strain: the state does not jump."""
    decay = stability.decay_strain
    squares = [sheet.solve(decay - d).measures.amplitude ** 2 for d in (0.002, 0.004)]
    assert squares[1] / squares[0] == pytest.approx(2.0, rel=0.05)
    assert np.sqrt(squares[0]) < 0.5e-3
