"""Group 2: the wrinkled sheet on finer and finer meshes, observed orders and limits."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools.singularity import williams
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.sheet import Sheet
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath, Array

MATERIAL = mooney_rivlin(6.21e4, 1.58e5)
ASPECT, THICKNESS = 2.0, 1.0e-3
STRAINS = (0.06, 0.2, 0.37)
DEFAULT = (MeshSettings().cells_along, MeshSettings().cells_across)
MESHES = ((12, 18), (16, 24), DEFAULT, (36, 54), (48, 72))
FITTED = 4  # the finest meshes that a limit is fitted to
# Largest relative error of the default mesh
BARS = {
    "energy": (2e-5, "the energy is nearly all that of the flat state"),
    "relief": (0.02, "energy that wrinkles save, a difference of 1e-5 of the energies"),
    "tau_1": (1e-3, "0.1%: what the default mesh is chosen for"),
    "A": (5e-3, "0.5%: what the default mesh is chosen for"),
    "Phi^2": (0.015, "1.5%"),
}
_ORDERS = (0.5, 8.0)
LABELS = {"tau_1": r"$\tau_1$", "A": "$A$", "Phi^2": r"$\Phi^2$"}


class Limit(NamedTuple):
    """Limit and order of a sequence q(h) = q0 + c h^p."""

    value: float
    order: float


def limit(sizes: Array, values: Array) -> Limit:
    """Return limit and order of values on meshes, by least squares in q0, c and p.

    Richardson's extrapolation; with three meshes the fit is exact.

    Parameters
    ----------
    sizes, values : (n,) arrays
        Cell size and quantity of at least three meshes.
    """

    def fit(order: float) -> tuple[float, float]:
        matrix = np.stack([np.ones_like(sizes), (sizes / sizes.max()) ** order], axis=1)
        answer, *_ = np.linalg.lstsq(matrix, values, rcond=None)
        return float(answer[0]), float(np.linalg.norm(matrix @ answer - values))

    best = minimize_scalar(lambda p: fit(p)[1], bounds=_ORDERS, method="bounded")
    return Limit(fit(float(best.x))[0], float(best.x))


def sheet_on(cells: tuple[int, int]) -> Sheet:
    """Return the latex sheet on a mesh."""
    return Sheet(ASPECT, THICKNESS, MATERIAL, mesh=MeshSettings(*cells))


def quantities(sheet: Sheet, strain: float) -> dict[str, float]:
    """Return the keys of `BARS` at a strain: the quarter's energies in mu W^3, lengths in W."""
    state = sheet.solve(strain)
    equilibrium = state.equilibrium
    modes = equilibrium.planar.modes
    if state.status != "wrinkled" or state.measures is None or modes is None:
        raise ArithmeticError(f"{sheet}, strain {strain:g}: {state.status} {equilibrium.reason}")
    return {
        "energy": equilibrium.energy,
        "relief": equilibrium.flat_energy - equilibrium.energy,
        "tau_1": modes.critical_thickness,
        "A": state.measures.amplitude,
        "Phi^2": state.measures.phi_squared,
    }


Columns = dict[str, list[float]]  # the values of each quantity on all meshes


def _sweep() -> dict[float, tuple[Columns, dict[str, Limit]]]:
    """Return for each strain the values on all meshes and their limits."""
    columns: dict[float, Columns] = {strain: {name: [] for name in BARS} for strain in STRAINS}
    for cells in MESHES:
        sheet = sheet_on(cells)
        for strain in STRAINS:
            for name, value in quantities(sheet, strain).items():
                columns[strain][name].append(value)
    sizes = np.array([1.0 / across for _, across in MESHES[-FITTED:]])
    return {
        strain: (known, {name: limit(sizes, np.array(v[-FITTED:])) for name, v in known.items()})
        for strain, known in columns.items()
    }


def _checks(strain: float, columns: Columns, limits: dict[str, Limit]) -> list[Check]:
    checks = []
    default = MESHES.index(DEFAULT)
    for name, (bar, reason) in BARS.items():
        error = columns[name][default] / limits[name].value - 1.0
        case = f"strain {strain:g}, {name}"
        checks += [
            Check(f"{case}: error of the default mesh", error, 0.0, bar, "absolute", reason),
            Check(
                f"{case}: observed order",
                limits[name].order,
                2.0 * williams(MATERIAL.law.poisson),
                kind="at least",
                reason="twice the exponent of the corner's singularity, what a uniform mesh has",
            ),
        ]
    return checks


def _table(strain: float, columns: Columns, limits: dict[str, Limit]) -> Table:
    default = MESHES.index(DEFAULT)
    rows = []
    for name, values in columns.items():
        end = limits[name]
        error = values[default] / end.value - 1.0
        numbers = [f"{value:.7g}" for value in [*values, end.value]]
        rows.append([name, *numbers, f"{end.order:.1f}", f"{100 * error:.2g}%"])
    meshes = [f"{along} x {across}" for along, across in MESHES]
    title = f"Strain {strain:g}: quantities on meshes of the quarter"
    return Table(title, ("quantity", *meshes, "limit", "order", "default's error"), rows)


def _plot(results: dict[float, tuple[Columns, dict[str, Limit]]], path: Path) -> None:
    """Draw the errors against the cells across, one panel for each strain."""
    across = np.array([cells[1] for cells in MESHES])
    with style.applied():
        figure = style.new(style.WIDE, 5.0)
        panels = figure.subplots(1, len(results), sharey=True)
        for axes, (strain, (columns, limits)) in zip(panels, results.items(), strict=True):
            for name, look in zip(columns, style.ordered(len(BARS)), strict=True):
                label = LABELS.get(name, name)
                errors = np.abs(np.array(columns[name]) / limits[name].value - 1.0)
                axes.loglog(across, errors, look.marker + look.line, color=look.color, label=label)
            axes.axvline(DEFAULT[1], color=style.GREY, ls=":", lw=0.8)
            axes.set(xlabel="cells across", title=rf"$\varepsilon = {strain:g}$")
            axes.set_xticks(across, [str(count) for count in across])
            axes.minorticks_off()
        panels[0].set_ylabel("error in parts of the limit")
        handles, labels = panels[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", ncols=len(labels))
        style.save(figure, path)


def quick() -> list[Check]:
    """Return the order of tau_1 and A on three coarse meshes at one strain."""
    meshes, strain = ((8, 12), (12, 18), (18, 27)), STRAINS[0]
    sizes = np.array([1.0 / across for _, across in meshes])
    rows = [quantities(sheet_on(cells), strain) for cells in meshes]
    checks = []
    for name in ("tau_1", "A"):
        fitted = limit(sizes, np.array([row[name] for row in rows]))
        checks.append(
            Check(
                f"coarse meshes, {name}: order",
                fitted.order,
                2.0 * williams(MATERIAL.law.poisson),
                kind="at least",
                reason="twice the exponent of the corner's singularity",
            )
        )
    return checks


def orders_text(orders: Sequence[float]) -> str:
    """Say how the observed orders compare with that of the corner on uniform meshes."""
    uniform = 2.0 * williams(MATERIAL.law.poisson)
    compared = conclusion(
        min(orders) > uniform,
        "all above the order that the corner alone would leave on a uniform mesh",
        "not all above the order that the corner alone would leave on a uniform mesh",
    )
    return f"The observed orders lie between {min(orders):.1f} and {max(orders):.1f}, {compared}."


def _text(results: Mapping[float, tuple[Columns, dict[str, Limit]]]) -> str:
    orders = [end.order for _, limits in results.values() for end in limits.values()]
    return (
        f"The latex sheet (Mooney-Rivlin, L/W = {ASPECT:g}, t/W = {THICKNESS:g}, `thinning`, "
        f"antisymmetric) on {len(MESHES)} meshes with the default grading "
        f"{MeshSettings().grading:g} toward the clamp. Limits and orders are fitted to the "
        f"{FITTED} finest meshes, q = q0 + c h^p (Richardson). *relief* is the energy that the "
        f"wrinkles save against the flat state. The energies are those of the quarter in mu W^3. "
        f"In theory the regular part of the error falls like h^4 (cubics under second "
        f"derivatives), and the corner of clamp and free edge leaves "
        f"h^{2.0 * williams(MATERIAL.law.poisson):.2f} on uniform meshes. {orders_text(orders)} "
        f"Lengths are in W."
    )


def run(output: AnyPath) -> None:
    """Write the group: energy, tau_1, A and Phi^2 on five meshes with their limits."""
    output = Path(output)
    results = _sweep()
    _plot(results, output.with_name("convergence.png"))
    checks = [check for strain, known in results.items() for check in _checks(strain, *known)]
    tables = [_table(strain, *known) for strain, known in results.items()]
    plots = [("convergence.png", "Errors against the limit; dotted: the default mesh.")]
    group = Group("convergence", "Convergence", _text(results), checks, tables, plots)
    write(group, output)
