"""Unknowns and memory before anything is built."""

import pytest

from wrinklestudy import MeshSettings, Sheet, neo_hookean
from wrinklestudy.fem import size
from wrinklestudy.fem.size import ProblemSize


@pytest.mark.parametrize(("aspect", "thickness"), [(2.0, 1e-3), (3.3, 4e-4), (0.7, 0.02)])
def test_the_unknowns_are_those_of_the_space(aspect, thickness):
    sheet = Sheet(aspect, thickness, neo_hookean(1e5), mesh=MeshSettings(5, 7))
    assert sheet.size.unknowns == 3 * sheet.space.size


# Peak memory that solves took, in bytes for each unknown.
MEASURED = {(24, 36): 17.3e3, (24, 144): 18.2e3, (24, 408): 17.4e3, (96, 144): 20.6e3}


@pytest.mark.parametrize("cells", MEASURED)
def test_the_estimate_is_near_what_was_measured_and_hardly_below(cells):
    needed = ProblemSize(*cells)
    ratio = needed.memory() / (MEASURED[cells] * needed.unknowns)
    assert 0.98 < ratio < 1.25


def test_limits_of_the_machine_count(monkeypatch, tmp_path):
    assert 0.0 < size.available_memory() < float("inf")
    limit = tmp_path / "memory.max"
    limit.write_text("1000000\n")
    monkeypatch.setattr(size, "_CGROUP_LIMIT", limit)
    assert size.available_memory() == 1e6
    limit.write_text("max\n")
    assert size.available_memory() > 1e6
