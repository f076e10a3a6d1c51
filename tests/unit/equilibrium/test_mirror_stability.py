"""Stability in the whole sheet: the classes against the flat state, the whole sheet and energy."""

from dataclasses import replace

import numpy as np
import pytest

from verification.tools.mirrors import whole_sheet_inertia
from verification.tools.sheets import (
    LATEX,
    PARITIES,
    bending_square,
    both_parities,
    energy_below,
    planar_state,
    quarter,
)
from wrinklestudy.equilibrium import flat, mirror_stability, modes, wrinkled
from wrinklestudy.equilibrium.mirror_stability import MirrorClass
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.fem.boundary import Symmetry
from wrinklestudy.fem.factorisation import SuperLUIndefinite

OWN, SLIDING = MirrorClass(True, True), MirrorClass(True, False)


@pytest.fixture(scope="module")
def space():
    return quarter(8, 20)


@pytest.fixture(scope="module")
def known(space):
    return flat.solve(space, LATEX.law, 0.03)


@pytest.fixture(scope="module")
def states(space):
    """Both parities where the mesh resolves the difference of their energies."""
    return both_parities(space, 0.03)


@pytest.fixture(scope="module")
def stability(states):
    return [mirror_stability.classes(state) for state in states]


def of_class(classes, kind):
    return next(c for c in classes if c[:2] == kind)


@pytest.mark.parametrize("parity", PARITIES)
def test_softest_eigenvalue_of_the_flat_sheet_is_its_distance_to_tau(known, parity):
    """K = t S + t^3 B, so that the smallest eigenvalue against t^3 B is 1 - (tau_1/t)^2.

    Breaking the mirror y = 0 of one parity leads to the deflections of the other.
    """
    other = PARITIES[1 - PARITIES.index(parity)]
    thickness = 2e-3
    state = wrinkled.solve(planar_state(known, LATEX, PlanarSettings(parity=parity)), thickness)
    assert state.status == "flat"
    classes = mirror_stability.classes(state)
    for kind, which in ((OWN, parity), (SLIDING, other)):
        squared = modes.spectrum(known, symmetry=Symmetry.mirrored(which), count=1).squared[0]
        found = of_class(classes, kind)
        assert found.softest == pytest.approx(1 - squared / thickness**2, rel=1e-8)
        assert found.unstable == 0


def test_unstable_directions_of_a_thin_flat_sheet_are_its_modes(known):
    planar = planar_state(known, LATEX, PlanarSettings(modes=8))
    thickness = 0.5 * (planar.modes.thickness[2] + planar.modes.thickness[3])
    state = replace(wrinkled.solve(planar, 2e-3), thickness=thickness)
    assert of_class(mirror_stability.classes(state, eigenvalues=()), OWN).unstable == 3


def test_the_classes_are_all_perturbations_of_the_whole_sheet(states):
    """Their negative eigenvalues add up to those of the tangent without mirrors.

    The wrinkled shape with the stiffness of a thinner sheet has many.
    """
    for state in states:
        probe = replace(state, thickness=4e-4)
        counts = [c.unstable for c in mirror_stability.classes(probe, eigenvalues=())]
        assert min(counts) > 0
        assert sum(counts) == whole_sheet_inertia(probe)


def test_a_wrinkled_state_is_a_minimum_within_its_own_class(stability):
    for classes in stability:
        own = of_class(classes, OWN)
        assert own.unstable == 0
        assert own.softest > 0.1


def test_sliding_leads_from_the_higher_parity_to_the_lower(states, stability):
    """E_s - E_a = mu_a t^3 w_s.B w_s / 2 = -mu_s t^3 w_a.B w_a / 2 for one harmonic."""
    found = [of_class(classes, SLIDING) for classes in stability]
    difference = energy_below(states[0], states[1])  # E_s - E_a
    assert found[0].softest * found[1].softest < 0
    assert [c.unstable for c in found] == [int(c.softest < 0) for c in found]
    assert [c.unstable for c in found] == [int(difference < 0), int(difference > 0)]
    squares = [bending_square(state) for state in states]
    assert 0.5 * found[0].softest * squares[1] == pytest.approx(difference, rel=0.02)
    assert -0.5 * found[1].softest * squares[0] == pytest.approx(difference, rel=0.02)
    assert np.abs(difference) < 1e-4 * energy_below(states[0])


def test_another_factorisation_tells_the_same(states, stability, monkeypatch):
    monkeypatch.setattr(mirror_stability, "make_indefinite_solver", SuperLUIndefinite)
    for a, b in zip(mirror_stability.classes(states[0]), stability[0], strict=True):
        assert a[:3] == b[:3]
        assert a.softest == pytest.approx(b.softest, rel=1e-3)


def test_eigenvalues_are_left_out_on_demand(states):
    classes = mirror_stability.classes(states[0], eigenvalues=())
    assert np.isnan([c.softest for c in classes]).all()


def test_refuses_a_state_that_did_not_converge(states):
    with pytest.raises(ValueError, match="status 'not-converged': only a converged state"):
        mirror_stability.classes(replace(states[0], status="not-converged"))
