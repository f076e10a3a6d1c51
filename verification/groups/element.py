"""Group 1: the Hermite element reproduces polynomials on fine meshes."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from skfem import Basis, ElementQuadBFS

from verification.checks import Check, Group, Table, conclusion, write
from wrinklestudy.fem.element import ElementQuadHermite
from wrinklestudy.fem.grid import Grid
from wrinklestudy.fem.space import DERIVATIVES, Space
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath, Array

Function = Callable[[Array, Array, int, int], Array]

SIDES = (2.5, 1.0)
CELLS = (160, 64)
GRADINGS = {"uniform": 1.0, "graded": 1.5}
NAMES = ("x,1", "x,2", "x,11", "x,22", "x,12")
BOUND = 1e-10
# Rounding of nodal values, in units of eps max|u| / h^k, that a derivative of order k may show: the
# moduli of the second derivatives of the two functions of value dofs add up to 12.
_ROUNDING = 12.0
SINGULAR = "no number (singular on this processor)"
_SWEEP = ((20, 8), (40, 16), (80, 32), (120, 48))
_ORDER_CELLS = ((10, 4), (20, 8))


def _space(cells: tuple[int, int], grading: float) -> Space:
    s = np.linspace(0.0, 1.0, cells[0] + 1)
    x = SIDES[0] * (1.0 - (1.0 - s) ** grading)
    return Space(Grid(x, np.linspace(0.0, SIDES[1], cells[1] + 1)))


def _bicubic(x: Array, y: Array, dx: int = 0, dy: int = 0) -> Array:
    """Return a polynomial with all 16 monomials, or a derivative of it."""
    total = np.zeros(np.broadcast(x, y).shape)
    for i in range(4):
        for j in range(4):
            p = np.polynomial.Polynomial.basis(i).deriv(dx)
            q = np.polynomial.Polynomial.basis(j).deriv(dy)
            total += (1 + i + 2 * j) / 7 * p(x - 0.3) * q(y + 0.1)
    return total


def _wave(x: Array, y: Array, dx: int = 0, dy: int = 0) -> Array:
    """Return sin(3 x + 0.3) sin(3 y + 1.1), or a derivative of it."""
    along = np.sin(3.0 * x + 0.3 + 0.5 * np.pi * dx)
    across = np.sin(3.0 * y + 1.1 + 0.5 * np.pi * dy)
    result: Array = 3.0 ** (dx + dy) * along * across
    return result


def _interpolant(space: Space, function: Function) -> Array:
    x, y = space.grid.x[:, None], space.grid.y[None, :]
    values = [function(x, y, dx, dy) for dx, dy in ((0, 0), (1, 0), (0, 1), (1, 1))]
    return space.field_from_nodes(np.array(values))


def _points(space: Space) -> tuple[Array, Array]:
    """Return the Gauss points of all cells, (nq, ne) each."""
    local, _ = space.quadrature
    corner = np.meshgrid(space.grid.x[:-1], space.grid.y[:-1], indexing="ij")
    x, y = (
        c.ravel() + np.outer(p, h) for c, p, h in zip(corner, local, space.cell_sizes, strict=True)
    )
    return x, y


def _errors(space: Space, function: Function) -> Array:
    """Return the largest error of each derivative, in parts of its largest value."""
    derivatives = space.derivatives(_interpolant(space, function)[None])[:, 0]
    x, y = _points(space)
    errors = []
    for value, (dx, dy) in zip(derivatives, DERIVATIVES, strict=True):
        exact = function(x, y, dx, dy)
        errors.append(np.abs(value - exact).max() / np.abs(exact).max())
    return np.array(errors)


def _in_basis(space: Space, element: object) -> Array:
    """Return the same errors for an element in scikit-fem's own basis."""
    basis = Basis(space.mesh, element, quadrature=space.quadrature)
    field = basis.interpolate(_interpolant(space, _bicubic))
    x, y = np.asarray(basis.global_coordinates())
    derivatives = (*field.grad, field.hess[0, 0], field.hess[1, 1], field.hess[0, 1])
    errors = []
    for value, (dx, dy) in zip(derivatives, DERIVATIVES, strict=True):
        exact = _bicubic(x, y, dx, dy)
        errors.append(np.abs(value - exact).max() / np.abs(exact).max())
    return np.array(errors)


def _monomials(space: Space) -> Array:
    """Return the errors of scikit-fem's `ElementQuadBFS`; NaN where its matrix is singular.

    It inverts a matrix of global monomials that is so ill-conditioned that the rounding of the
    processor's BLAS decides whether the inversion ends with numbers at all. It is shown for
    information and must not stop the checks.
    """
    try:
        with np.errstate(all="ignore"):
            return _in_basis(space, ElementQuadBFS())
    except np.linalg.LinAlgError:
        return np.full(len(DERIVATIVES), np.nan)


def _rounding(space: Space) -> Array:
    """Return the error that rounding of the nodal values alone may cause, 12 eps max|u| / h^k."""
    x, y = _points(space)
    largest = np.abs(_bicubic(x, y)).max()
    wide, high = space.cell_sizes.min(axis=1)
    scale = [np.abs(_bicubic(x, y, dx, dy)).max() * wide**dx * high**dy for dx, dy in DERIVATIVES]
    bound: Array = _ROUNDING * np.finfo(float).eps * largest / np.array(scale)
    return bound


def _reproduction(label: str, space: Space, errors: Array) -> list[Check]:
    rounding = _rounding(space)
    reason = (
        "a bicubic lies in the space; a derivative of order k of nodal values with relative "
        "rounding eps cannot be better than eps/h^k"
    )
    return [
        Check(
            f"bicubic, {label} {CELLS[0]} x {CELLS[1]}, {name}",
            float(error),
            max(BOUND, float(bound)),
            kind="at most",
            reason=reason,
        )
        for name, error, bound in zip(NAMES, errors, rounding, strict=True)
    ]


def _orders() -> list[Check]:
    """Return the observed orders of the interpolation error of a smooth function."""
    coarse, fine = (_errors(_space(cells, 1.0), _wave) for cells in _ORDER_CELLS)
    orders = np.log2(coarse / fine)
    return [
        Check(
            f"order of the interpolation error of a sine, {name}",
            float(order),
            4.0 - max(derivative),
            0.2,
            "absolute",
            "a product of cubics has order 4 - k, k the higher of the two orders of derivation; "
            f"{_ORDER_CELLS[0]} to {_ORDER_CELLS[1]} cells",
        )
        for name, order, derivative in zip(NAMES, orders, DERIVATIVES, strict=True)
    ]


def quick() -> list[Check]:
    """Return the checks of the group; they are cheap."""
    checks = []
    for label, grading in GRADINGS.items():
        space = _space(CELLS, grading)
        checks += _reproduction(label, space, _errors(space, _bicubic))
    return checks + _orders()


class ErrorOnMesh(NamedTuple):
    """Errors of x,11 on one uniform mesh."""

    cells: int
    own: float
    monomials: float  # of ElementQuadBFS; NaN where it is singular


def _sweep() -> list[ErrorOnMesh]:
    """Return the errors of both elements from coarse to fine meshes."""
    rows = []
    for cells in (*_SWEEP, CELLS):
        space = _space(cells, GRADINGS["uniform"])
        errors = (_errors(space, _bicubic), _monomials(space))
        rows.append(ErrorOnMesh(cells[0] * cells[1], *(float(error[2]) for error in errors)))
    return rows


def _plot(sweep: Sequence[ErrorOnMesh], path: Path) -> None:
    cells, own, other = np.array(sweep).T
    lost = cells[np.isnan(other)]
    with style.applied():
        figure, axes = style.panel()
        axes.loglog(cells, other, "s--", color=style.VERMILLION, label="scikit-fem ElementQuadBFS")
        axes.loglog(cells, own, "o-", color=style.BLUE, label="ElementQuadHermite")
        axes.axhline(BOUND, color=style.GREY, ls=":", lw=0.8)
        if len(lost):
            where = ", ".join(f"{count:.0f}" for count in lost)
            axes.set_title(f"BFS, {where} cells:\n{SINGULAR}", fontsize="small")
        axes.set_xlabel("cells")
        axes.set_ylabel("largest relative error of x,11")
        axes.legend()
        style.save(figure, path)


def monomials_text(sweep: Sequence[ErrorOnMesh], others: Sequence[str] = ()) -> str:
    """Say how scikit-fem's own element does.

    Parameters
    ----------
    sweep : sequence of ErrorOnMesh
        From coarse to fine uniform meshes.
    others : sequence of str
        Other meshes on which it is singular.
    """
    known = [row for row in sweep if np.isfinite(row.monomials)]
    lost = [f"{row.cells} cells" for row in sweep if not np.isfinite(row.monomials)]
    lost += [f"the {mesh}" for mesh in others]
    singular = f"It has {SINGULAR} on {', '.join(lost)}" if lost else ""
    if len(known) < 2:
        return f"{singular}."
    first, last = known[0], known[-1]
    compared = conclusion(
        last.monomials > first.monomials,
        "its error grows with the mesh",
        "its error does not grow with the mesh",
    )
    numbers = (
        f"{compared}, from {first.monomials:.0e} on {first.cells} cells to {last.monomials:.0e} "
        f"on {last.cells}"
    )
    return f"{singular}; {numbers}." if singular else f"{numbers[0].upper()}{numbers[1:]}."


def _rounding_text(names: Sequence[str]) -> str:
    """Say for which derivatives and meshes the rounding of nodal values exceeds the bound."""
    where = f"it exceeds the {BOUND:g} for {', '.join(names)}"
    return conclusion(bool(names), where, f"it stays below the {BOUND:g}")


def _text(beyond: Sequence[str], sweep: Sequence[ErrorOnMesh], others: Sequence[str]) -> str:
    return (
        f"The bicubic Hermite element is fed with the nodal values of a polynomial that has all "
        f"16 monomials, on [0, {SIDES[0]:g}] x [0, {SIDES[1]:g}]. Its derivatives at the Gauss "
        f"points must be those of the polynomial to {BOUND:g}, or to what rounding of the nodal "
        f"values leaves: a derivative of order k is a k-th difference over cells of size h and "
        f"cannot be better than about {_ROUNDING:g} eps max|u|/h^k (column *rounding*; "
        f"{_rounding_text(beyond)}). The fourth column is the same element used through "
        f"scikit-fem's `Basis`. scikit-fem's own `ElementQuadBFS`, which inverts a matrix of "
        f"global monomials, is shown for information. {monomials_text(sweep, others)}"
    )


def run(output: AnyPath) -> None:
    """Write the group: reproduction of a bicubic, orders, comparison with scikit-fem's element."""
    output = Path(output)
    rows: list[list[str]] = []
    checks: list[Check] = []
    beyond, others = [], []
    for label, grading in GRADINGS.items():
        space = _space(CELLS, grading)
        own, rounding = _errors(space, _bicubic), _rounding(space)
        checks += _reproduction(label, space, own)
        monomials = _monomials(space)
        if grading != GRADINGS["uniform"] and np.isnan(monomials).any():
            others.append(f"{label} mesh")
        columns = (own, _in_basis(space, ElementQuadHermite()), monomials, rounding)
        for name, *values in zip(NAMES, *columns, strict=True):
            numbers = [f"{value:.1e}" if np.isfinite(value) else SINGULAR for value in values]
            rows.append([f"{label} {CELLS[0]} x {CELLS[1]}", name, *numbers])
            beyond += [f"{name} on the {label} mesh"] if values[-1] > BOUND else []
    sweep = _sweep()
    _plot(sweep, output.with_name("element_reproduction.png"))
    table = Table(
        "Largest error of the derivatives of a bicubic, in parts of their largest value",
        ("mesh", "derivative", "library", "in scikit-fem's basis", "ElementQuadBFS", "rounding"),
        rows,
    )
    caption = "Error of x,11 of a bicubic against the number of cells (uniform); dotted: the bound."
    plots = [("element_reproduction.png", caption)]
    text = _text(beyond, sweep, others)
    write(Group("element", "Element", text, checks + _orders(), [table], plots), output)
