"""Files of flat states: what is read is what was written, also where a sheet has no mode."""

import numpy as np
import pytest

from wrinklestudy.equilibrium import planar, wrinkled
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.mechanics.laws import mooney_rivlin, saint_venant_kirchhoff
from wrinklestudy.results.fields import read_planar, write_planar


@pytest.mark.parametrize(
    ("material", "has_modes"),
    [(mooney_rivlin(6.21e4, 1.58e5), True), (saint_venant_kirchhoff(1e6, 0.0), False)],
    ids=["rubber", "cork"],
)
def test_a_planar_state_is_read_back(tmp_path, material, has_modes):
    """Cork does not narrow as it is stretched, so that it wrinkles at no thickness."""
    grid = make_grid(2.0, settings=MeshSettings(8, 12))
    state = planar.solve(grid, material, 0.12, name="mine")
    write_planar(state, tmp_path / "planar.h5")
    again = read_planar(tmp_path / "planar.h5")
    assert (len(state.modes.squared) > 0) is has_modes
    assert np.array_equal(again.flat.position, state.flat.position)
    assert again.flat.history == state.flat.history
    assert again.settings == state.settings
    for name in ("squared", "corner", "quartic", "shapes", "relaxation"):
        stored, original = getattr(again.modes, name), getattr(state.modes, name)
        assert stored.shape == original.shape
        # shapes and relaxation are stored in single precision
        assert stored == pytest.approx(
            original, rel=1e-6, abs=1e-6 * np.abs(original).max(initial=0)
        )
    assert again.modes.critical_thickness == state.modes.critical_thickness
    assert wrinkled.solve(again, 1e-3).status == ("wrinkled" if has_modes else "flat")
