"""Times of the solver's parts on one thread, on meshes with 1 to 16 times the default cells.

Run by `make bench`, which prints medians, ratios to the factorisation of the same mesh and growth
with the number of cells (`report.py`). The sheet: L/W = 2, t/W = 1e-3, the paper's constants.
"""

import math
import os
from dataclasses import dataclass
from typing import Any

import pytest

for _name in ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[_name] = "1"

from wrinklestudy.equilibrium import flat, modes, newton, planar, wrinkled  # noqa: E402
from wrinklestudy.equilibrium.problem import PlateProblem, Predicting  # noqa: E402
from wrinklestudy.fem.factorisation import make_solver  # noqa: E402
from wrinklestudy.fem.grid import MeshSettings, make_grid  # noqa: E402
from wrinklestudy.fem.space import Space  # noqa: E402
from wrinklestudy.mechanics import plate  # noqa: E402
from wrinklestudy.mechanics.bending import SectionDerivatives  # noqa: E402
from wrinklestudy.mechanics.laws import mooney_rivlin  # noqa: E402
from wrinklestudy.mechanics.surface import SurfaceGeometry  # noqa: E402

LATEX = mooney_rivlin(6.21e4, 1.58e5)
STRAIN, THICKNESS = 0.12, 1.0e-3
CELLS = (1, 2, 4, 8, 16)


@dataclass(frozen=True)
class Setup:
    """A solved case and what its parts need."""

    planar: planar.Planar
    problem: PlateProblem
    unknowns: Any
    tangent: Any


@pytest.fixture(scope="module", params=CELLS, ids=[f"{n}x" for n in CELLS])
def setup(request: pytest.FixtureRequest) -> Setup:
    """Solve the case once on each mesh."""
    factor = math.sqrt(request.param)
    settings = MeshSettings(round(24 * factor), round(36 * factor))
    space = Space(make_grid(2.0, settings=settings))
    start = planar.solve(space, LATEX, STRAIN)
    state = wrinkled.solve(start, THICKNESS)
    assert state.status == "wrinkled"
    problem = PlateProblem.of_flat(start.flat, start.modes, THICKNESS)
    unknowns = state.position[problem.assembler.free]
    return Setup(start, problem, unknowns, problem.derivatives(unknowns)[2])


@pytest.fixture
def timed(benchmark: Any, setup: Setup) -> Any:
    """Note the number of cells beside each time."""
    along, across = setup.planar.grid.cells
    benchmark.extra_info["cells"] = along * across
    benchmark.extra_info["unknowns"] = setup.problem.assembler.size
    return benchmark


def rounds(setup: Setup) -> int:
    """Return how often what takes seconds is timed."""
    return 5 if setup.problem.assembler.size < 50000 else 2


def surface_of(setup: Setup) -> tuple[SurfaceGeometry, SectionDerivatives]:
    """Return the geometry and the section at the Gauss points."""
    position = setup.problem.position(setup.unknowns)
    return plate.respond(setup.problem.section, setup.planar.flat.space.derivatives(position))


def test_point_kernel(timed: Any, setup: Setup) -> None:
    """Geometry, section, gradient and Hessian at the Gauss points."""

    def kernel() -> None:
        shape, section = surface_of(setup)
        plate.gradient(shape, section)
        plate.hessian(shape, section)

    timed(kernel)


def test_element_tangent(timed: Any, setup: Setup) -> None:
    """B^T D B of all elements."""
    assembler = setup.problem.assembler
    blocks = plate.hessian(*surface_of(setup))
    timed.pedantic(assembler.element_tangents, (blocks,), rounds=7, iterations=1)


def test_scatter(timed: Any, setup: Setup) -> None:
    """Element tangents into the sparse matrix."""
    assembler = setup.problem.assembler
    elements = assembler.element_tangents(plate.hessian(*surface_of(setup)))
    timed(assembler.scatter, elements)


def test_tangent_and_residual(timed: Any, setup: Setup) -> None:
    """All of the assembly for one Newton iteration."""
    problem = Predicting(setup.problem)
    problem.derivatives(setup.unknowns)  # so that there is a last step
    timed(problem.derivatives, setup.unknowns)


def test_factorisation(timed: Any, setup: Setup) -> None:
    """Numeric factorisation; the ordering is there."""
    solver = setup.problem.assembler.solver
    solver.factorise(setup.tangent)
    timed(solver.factorise, setup.tangent)


def test_newton_iteration(timed: Any, setup: Setup) -> None:
    """Assembly, factorisation, solution and the energy that decides on the step."""
    problem, solver = Predicting(setup.problem), setup.problem.assembler.solver
    problem.derivatives(setup.unknowns)

    def iteration() -> None:
        _, residual, tangent = problem.derivatives(setup.unknowns)
        solver.factorise(tangent)
        step = solver.solve(residual)
        problem.energy(setup.unknowns - step)

    timed(iteration)


def test_flat_state(timed: Any, setup: Setup) -> None:
    """One flat state from nothing."""
    timed.pedantic(flat.solve, (setup.planar.flat.space, LATEX.law, STRAIN), rounds=rounds(setup))


def test_critical_modes(timed: Any, setup: Setup) -> None:
    """Eight critical thicknesses with their modes and the reduced energy."""
    timed.pedantic(modes.critical_modes, (setup.planar.flat,), rounds=rounds(setup))


def test_wrinkled_state(timed: Any, setup: Setup) -> None:
    """One wrinkled state from its planar state."""
    state = timed.pedantic(wrinkled.solve, (setup.planar, THICKNESS), rounds=rounds(setup))
    timed.extra_info["newton_iterations"] = newton.count(state.history)


def test_branch_of_20_strains(timed: Any, setup: Setup) -> None:
    """Strains 0.02 to 0.40 with flat states and modes, nothing kept between runs but the mesh."""
    if setup.problem.assembler.size > 15000:
        pytest.skip("the branch is timed on the default mesh")

    def branch() -> list[int]:
        space = Space(setup.planar.grid)
        states = [
            wrinkled.solve(planar.solve(space, LATEX, 0.02 * k), THICKNESS) for k in range(1, 21)
        ]
        assert all(state.status != "not-converged" for state in states)
        return [newton.count(state.history) for state in states]

    timed.extra_info["newton_iterations"] = timed.pedantic(branch, rounds=3)


def test_ordering(timed: Any, setup: Setup) -> None:
    """Symbolic and numeric factorisation of a new pattern."""

    def both() -> None:
        make_solver().factorise(setup.tangent)

    timed.pedantic(both, rounds=3)
