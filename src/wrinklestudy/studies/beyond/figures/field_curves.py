"""Force, widths and hidden width of the tension field, and of sheets on the way to it."""

import numpy as np
from matplotlib.figure import Figure

from wrinklestudy.metrics.confinement import line_weights
from wrinklestudy.studies.beyond.figures.side_by_side import nearest_field
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs, StateFile
from wrinklestudy.study.figures.series import number
from wrinklestudy.typing import Array

_LINES = 60  # lines X = const
_SAME = 1e-9  # of a strain


def draw(inputs: Inputs) -> Figure:
    """Draw force and widths over strain, relative to the tension field's, and Phi^2 along x."""
    figure = style.new(style.WIDE, 9.6)
    (force, arc), (projected, along) = figure.subplots(2, 2)
    wrinkled = [sheet for sheet in inputs.series if "wrinkled" in sheet.status]
    sheets = sorted(wrinkled, key=lambda sheet: -sheet.thickness)
    like, table = inputs.series[0], inputs.table("tension")
    own = table[(table["material"] == like.material) & (table["aspect"] == like.aspect)]
    own = own[own["phi_squared"].notna()].sort_values("strain")
    panels = {
        force: ("nominal_stress_pa", "force"),
        arc: ("arc_width_over_width", r"$W_\mathrm{arc}$"),
        projected: ("projected_width_over_width", r"$W_\mathrm{proj}$"),
    }
    looks = dict(zip([s.thickness for s in sheets], style.ordered(len(sheets)), strict=True))
    for axes, (column, name) in panels.items():
        axes.axhline(0.0, color="k", lw=1.2, label="tension field")
        for sheet in sheets:
            strain, value = sheet.wrinkled("strain", column)
            solved = np.isin(strain, own["strain"])
            field = np.interp(strain[solved], own["strain"], own[column])
            look, label = looks[sheet.thickness], f"$t/W = {number(sheet.thickness)}$"
            off = 100.0 * (value[solved] / field - 1.0)
            axes.plot(strain[solved], off, look.marker + "-", color=look.color, label=label)
        axes.set_xlabel(r"$\varepsilon$")
        axes.set_ylabel(f"{name}: off the field by (%)")
    states = [state for state in inputs.states_of_sheets() if state.status == "wrinkled"]
    field = nearest_field(inputs, states[0])
    along.plot(field.x, field.phi_squared, "k-", lw=1.2)
    for state in states:
        if not np.isclose(state.strain, field.strain, rtol=0.0, atol=_SAME):
            continue  # the state of this sheet nearest to the strain is one of another strain
        x, phi_squared = hidden(state)
        along.plot(x, phi_squared, "-", color=looks[state.thickness].color)
    along.set_xlabel("$X/W$")
    along.set_ylabel(rf"$\Phi^2$ at $\varepsilon = {field.strain:g}$")
    along.set_ylim(bottom=0.0)
    style.grow(figure, style.legend_above(force, columns=3))
    return figure


def hidden(state: StateFile) -> tuple[Array, Array]:
    """Return lines X = const, (m,), and Phi^2 on them: of the line and its image in the plane."""
    sheet = state.known
    x = np.linspace(0.0, float(sheet.grid.x[-1]), _LINES)
    y, weights = line_weights(sheet.grid.y)
    across = sheet.evaluate(x, y, dy=1)
    arc = np.sqrt((across**2).sum(0)) @ weights
    projected = np.sqrt((across[:2] ** 2).sum(0)) @ weights
    return x, arc / projected - 1.0
