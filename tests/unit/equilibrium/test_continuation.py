"""Branches against states found one by one, birth and decay of the flat state, made-up points."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from verification.tools.sheets import LATEX, THICKNESS, quarter, wrinkled
from wrinklestudy.equilibrium import continuation, stability
from wrinklestudy.equilibrium.continuation import (
    BranchPoint,
    ContinuationOptions,
    ExtendedSystem,
    PathPoint,
)
from wrinklestudy.equilibrium.critical_curve import critical_curve
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.equilibrium.planar import solve as solve_planar
from wrinklestudy.equilibrium.wrinkled import solve

SPACE = quarter(10, 14)


def state(strain):
    return wrinkled(solve_planar(SPACE, LATEX, strain, PlanarSettings(modes=4)), THICKNESS)


def distance(position, other):
    """Largest difference of the deformed nodes in units of t, whatever the sign of the wrinkles."""
    a, b = (SPACE.nodes_from_field(p)[:, 0] for p in (position, other))
    sign = np.sign((a[2] * b[2]).sum())
    return np.abs(a - b * np.array([1.0, 1.0, sign])[:, None, None]).max() / THICKNESS


@pytest.fixture(scope="module")
def start():
    return state(0.12)


@pytest.fixture(scope="module")
def short(start):
    return continuation.trace(
        start, (0.0, 1.0), options=ContinuationOptions(step=0.3, max_points=5)
    )


@pytest.fixture(scope="module")
def ends():
    return stability.find(critical_curve(SPACE, LATEX, PlanarSettings()), THICKNESS)


def test_points_are_the_states_found_on_their_own(short):
    assert short.reason == "5 points"
    for point, position in zip(short.points, short.positions, strict=True):
        alone = state(point.strain)
        assert point.energy == pytest.approx(alone.energy, rel=1e-12)
        assert distance(position, alone.position) < 1e-7
        assert point.unstable == 0


def test_strains_go_in_the_chosen_direction(start, short):
    assert np.all(np.diff([p.strain for p in short.points]) > 0)
    down = continuation.trace(
        start, (0.0, 1.0), upward=False, options=ContinuationOptions(max_points=3)
    )
    assert np.all(np.diff([p.strain for p in down.points]) < 0)


def test_neighbours_are_at_most_a_step_apart(start):
    """Mean square of the deflection in t and strain in its scale; the arc bends a little."""
    options = ContinuationOptions(step=0.2, largest_step=0.2, max_points=4)
    branch = continuation.trace(start, (0.0, 1.0), options=options)
    system = ExtendedSystem(start.planar, THICKNESS, options)
    points = [
        PathPoint(position[system.free], row.strain)
        for position, row in zip(branch.positions, branch.points, strict=True)
    ]
    changes = [b.minus(a) for a, b in pairwise(points)]
    steps = [np.sqrt(system.product(change, change)) for change in changes]
    assert steps[0] == pytest.approx(0.2, rel=0.01)
    assert max(steps) <= 0.2 * 1.01


def test_tangent_is_the_slope_of_the_states_over_strain(start):
    system = ExtendedSystem(start.planar, THICKNESS, ContinuationOptions())
    unknowns = start.position[system.free]
    along = system.tangent(PathPoint(unknowns, 0.12), upward=True)
    assert system.product(along, along) == pytest.approx(1.0, rel=1e-12)
    step = 1e-3
    beside = [state(0.12 + k * step).position[system.free] for k in (-1, 1)]
    w = system.deflections
    signs = [np.where(w, np.sign(b[w] @ unknowns[w]), 1.0) for b in beside]
    slope = (signs[1] * beside[1] - signs[0] * beside[0])[w] / (2 * step)
    assert (along.unknowns / along.strain)[w] == pytest.approx(
        slope, abs=1e-3 * np.abs(slope).max()
    )


@pytest.mark.parametrize("upward", [True, False])
def test_ends_where_the_flat_state_becomes_stable(ends, upward):
    """The amplitude passes zero at a pitchfork, where the strain of the branch turns back."""
    root, inside = (ends.decay_strain, -6e-3) if upward else (ends.birth_strain, 2e-3)
    branch = continuation.trace(state(root + inside), (0.0, 1.0), upward)
    assert branch.reason == "the amplitude vanishes"
    assert dict(branch.special)["vanishing"] == pytest.approx(root, abs=2e-5)
    assert [kind for kind, _ in branch.special] == ["vanishing"]
    assert branch.points[-1].amplitude <= 1e-3
    outward = 1 if upward else -1
    beyond = [(p.strain - root) * outward for p in branch.points if abs(p.amplitude) > 1e-3]
    assert max(beyond) < 2e-5


def test_ends_at_the_range_of_strains(start):
    branch = continuation.trace(start, (0.1, 0.13), options=ContinuationOptions(step=0.3))
    assert branch.reason == "end of the range of strains"
    assert branch.points[-2].strain <= 0.13 < branch.points[-1].strain


def test_refuses_a_flat_state():
    sheet = solve(solve_planar(SPACE, LATEX, 0.12), 2e-3)
    with pytest.raises(ValueError, match="start: status 'flat', must be a wrinkled state"):
        continuation.trace(sheet, (0.0, 1.0))


def point(strain, amplitude, unstable=0):
    return BranchPoint(strain, amplitude, 0.0, unstable, 1)


def test_folds_and_changes_of_stability_of_a_table():
    points = [point(0.1, 1.0), point(0.2, 1.5), point(0.25, 2.0), point(0.22, 2.5, 1)]
    assert continuation.special_points(points) == (
        ("fold", 0.25),
        ("stability", pytest.approx(0.235)),
    )


@given(
    root=st.floats(0.02, 0.5),
    slope=st.floats(5.0, 500.0),
    sides=st.tuples(st.floats(0.002, 0.01), st.floats(1e-4, 1e-3)),
    sign=st.sampled_from([-1, 1]),
)
def test_amplitude_vanishes_where_its_square_does(root, slope, sides, sign):
    points = [point(root + sign * d, np.sqrt(slope * d)) for d in sides]
    special = continuation.special_points([*points, point(root, 0.0)])
    assert special == (("vanishing", pytest.approx(root, abs=1e-9)),)
