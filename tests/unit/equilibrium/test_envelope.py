"""The envelope of thin wrinkles: scaling, the width it hides, and its deflection on a mesh."""

import numpy as np
import pytest

from wrinklestudy.equilibrium import tension_field
from wrinklestudy.equilibrium.envelope import envelope
from wrinklestudy.fem.grid import MeshSettings, make_grid
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import mooney_rivlin, saint_venant_kirchhoff
from wrinklestudy.metrics.confinement import confined_widths

LATEX = mooney_rivlin(6.21e4, 1.58e5)


@pytest.fixture(scope="module")
def field():
    grid = tension_field.tension_grid(2.0, MeshSettings(14, 24))
    return tension_field.solve(grid, LATEX.law, 0.12)


def test_the_wavelength_goes_like_the_root_of_the_thickness(field):
    """Bending against tension: k^4 ~ T/(t^2 B) over one and the same field."""
    thin, thinner = (envelope(field, thickness, "thinning") for thickness in (1e-5, 1e-6))
    assert thinner.wave_number / thin.wave_number == pytest.approx(10**0.5, rel=0.03)


def test_thin_wrinkles_hide_the_width_of_the_tension_field(field):
    """(k a)^2/4 is the hidden length of an inextensible line in units of its width."""
    wrinkles = envelope(field, 1e-6, "thinning")
    arc, projected = confined_widths(field, np.zeros(1))
    y, slope = wrinkles.space.grid.y, wrinkles.wave_number * wrinkles.amplitude[0]
    hidden = np.trapezoid(0.25 * slope**2, y) / np.hypot(*field.nodes[:, 2, 0, 0])
    assert 2.0 * hidden == pytest.approx(arc[0] - projected[0], rel=0.02)


def test_stiffer_bending_gives_longer_wrinkles(field):
    """At this stretch bending with the undeformed thickness is the stiffer one."""
    thinning, fixed = (envelope(field, 1e-4, law) for law in ("thinning", "fixed-thickness"))
    assert fixed.wavelength > thinning.wavelength


@pytest.mark.parametrize("odd", [True, False])
def test_the_deflection_keeps_mirrors_and_clamp(field, odd):
    space = Space(make_grid(2.0, 1e-4, MeshSettings(14, 24)))
    wrinkles = envelope(field, 1e-4, "thinning")
    value, slope_x, slope_y, mixed = space.nodes_from_field(wrinkles.deflection(space, odd))
    for held in (value[-1], slope_x[-1], slope_y[-1], mixed[-1], slope_x[0], mixed[0]):
        assert np.abs(held).max() <= 1e-12
    on_axis = value[:, 0] if odd else slope_y[:, 0]
    assert np.abs(on_axis).max() <= 1e-2 * np.abs(slope_y if not odd else value).max()
    assert np.abs(value).max() == pytest.approx(wrinkles.largest_amplitude, rel=0.05)


def test_a_thick_sheet_has_no_wrinkles(field):
    """Bending costs more than the hidden width would save: far above the critical thickness."""
    assert envelope(field, 2e-2, "thinning") is None


def test_a_taut_field_has_no_wrinkles():
    """Where Poisson's ratio is zero nothing narrows, and nothing is hidden."""
    law = saint_venant_kirchhoff(poisson=0.0).law
    taut = tension_field.solve(make_grid(2.0, settings=MeshSettings(8, 8)), law, 0.05)
    assert taut.converged
    assert envelope(taut, 1e-4, "thinning") is None
