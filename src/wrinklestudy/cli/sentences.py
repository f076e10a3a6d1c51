"""What was found of a sheet, in sentences and narrow tables."""

from collections.abc import Mapping, Sequence
from typing import Any

from wrinklestudy.cli.output import cell, table, wrapped
from wrinklestudy.cli.sheet_options import GivenSize
from wrinklestudy.vocabulary import FEWEST_CELLS

_State = Mapping[str, Any]


def states_text(states: Sequence[_State], size: GivenSize) -> str:
    """Return what is to be said of the states of a sheet: a sentence or two, and a table."""
    converged = [state for state in states if state["status"] != "not-converged"]
    wrinkled = [state for state in converged if state["status"] == "wrinkled"]
    sentences = []
    if len(states) == 1 and converged:
        sentences.append(f"At {_strain(states[0], size)} the sheet {_state(states[0], size)}.")
    elif wrinkled:
        highest = max(wrinkled, key=lambda state: state["amplitude_over_thickness"])
        sentences += [
            f"The sheet is wrinkled at {len(wrinkled)} of {len(states)} strains"
            f"{between(wrinkled)}.",
            f"The wrinkles are highest at {_strain(highest, size)}, where it "
            f"{_state(highest, size)}.",
        ]
    elif converged:
        is_like = "flat" if all(state["status"] == "flat" for state in converged) else "unwrinkled"
        sentences.append(f"The sheet is {is_like} at {len(converged)} of {len(states)} strains.")
    sentences += _whole_sheet(wrinkled)
    sentences += _coarse_mesh(wrinkled)
    sentences += [f"{failure}." for failure in failures(states)]
    return f"{wrapped(' '.join(sentences))}\n{_states_table(states, size)}"


def _whole_sheet(wrinkled: Sequence[_State]) -> list[str]:
    """Return what is to be said of sheets without mirrors besides: the phase, the bifurcation."""
    known = [state for state in wrinkled if state.get("amplitude_low") is not None]
    if not known:
        return []
    widest = max(known, key=lambda state: state["amplitude_high"] / state["amplitude_low"])
    low, high = (cell(widest[f"amplitude_{end}"]) for end in ("low", "high"))
    return [
        f"Depending on where across the sheet the pattern sits, the highest is {low} to {high} "
        f"thicknesses at strain {widest['strain']:.6g}.",
        f"The wrinkles appear {_APPEAR[widest['bifurcation']]}: {widest['bifurcation_reason']}.",
    ]


def _coarse_mesh(wrinkled: Sequence[_State]) -> list[str]:
    """Return a warning if the mesh of a state is too coarse for its wrinkles."""
    cells = {
        state["strain"]: state["cells_per_wavelength"]
        for state in wrinkled
        if (state.get("cells_per_wavelength") or FEWEST_CELLS) < FEWEST_CELLS
    }
    if not cells:
        return []
    strain = min(cells, key=lambda strain: cells[strain])
    return [
        f"The mesh is too coarse for the wrinkles of {len(cells)} of these states: at strain "
        f"{strain:.6g} it has {cells[strain]:.1f} cells per wavelength, at least "
        f"{FEWEST_CELLS:g} are wanted (--cells-across)."
    ]


_APPEAR = {"sharp": "at a sharp strain", "rounded": "gradually"}


def predictions_text(states: Sequence[_State]) -> str:
    """Return the far-from-threshold predictions of a sheet, said to be predictions, and a table."""
    sentences = [
        "Predicted from tension field theory, not solved: the sheet in the limit of no thickness, "
        "with wrinkles of the wavelength that balances bending and tension."
    ]
    sentences += [f"{failure}." for failure in failures(states)]
    columns = {
        "strain": "strain",
        "status": "status",
        "A/t": "amplitude_over_thickness",
        "lambda/W": "wavelength_over_width",
        "Phi^2": "phi_squared",
        "W_arc/W": "arc_width_over_width",
        "W_proj/W": "projected_width_over_width",
    }
    rows = [
        [str(state[name]) if name == "status" else cell(state[name]) for name in columns.values()]
        for state in states
    ]
    return f"{wrapped(' '.join(sentences))}\n{table([*columns], rows)}"


def failures(states: Sequence[_State]) -> list[str]:
    """Return for each state that did not converge that it did not, and why."""
    return [
        f"strain {state['strain']:.6g} did not converge: {state['reason']}"
        for state in states
        if state["status"] == "not-converged"
    ]


def _strain(state: _State, size: GivenSize) -> str:
    clamps = size.clamps_mm(state["strain"])
    return f"strain {state['strain']:.6g}" + ("" if clamps is None else f" ({_mm(clamps)})")


def _mm(clamps: float | None) -> str:
    return f"clamps {cell(clamps, 6)} mm apart"


def _state(state: _State, size: GivenSize) -> str:
    """Return what a sheet is like in a converged state: 'is flat', 'has 12 crests ...'."""
    if state["status"] == "flat":
        return "is flat"
    if state["status"] == "unwrinkled":
        return "has no wrinkles, but its clamps or its weight keep it from being flat"
    height = f"{cell(state['amplitude_over_thickness'])} thicknesses"
    length = f"{cell(state['wavelength_over_width'])} widths"
    if size.width_mm is not None:
        height = f"{cell(state['amplitude_mm'])} mm ({height})"
        length = f"{cell(state['wavelength_mm'])} mm ({length})"
    count = f"has {state['crests_and_troughs']} crests and troughs across its width"
    if state["wavelength_over_width"] is None:
        return f"{count}, the highest {height}"
    return f"{count}, the highest {height}, like ones {length} apart in the middle"


def between(wrinkled: Sequence[_State]) -> str:
    """Return from which strain to which some states are, to follow a count of them."""
    strains = [state["strain"] for state in wrinkled]
    low, high = min(strains), max(strains)
    return f", {low:.6g}" if low == high else f", from {low:.6g} to {high:.6g}"


def _states_table(states: Sequence[_State], size: GivenSize) -> str:
    columns = {"strain": "strain"}
    if size.width_mm is not None:
        columns |= {"clamps mm": "clamps_mm"}
    columns |= {"status": "status"}
    if size.width_mm is not None:
        columns |= {"A mm": "amplitude_mm", "lambda mm": "wavelength_mm"}
    else:
        columns |= {"A/t": "amplitude_over_thickness", "lambda/W": "wavelength_over_width"}
    if "amplitude_low" in states[0]:
        columns |= {"A/t low": "amplitude_low", "A/t high": "amplitude_high"}
    columns |= {
        "peaks": "crests_and_troughs",
        "Phi^2": "phi_squared",
        "stress Pa": "nominal_stress_pa",
    }
    return table([*columns], [[state[name] for name in columns.values()] for state in states])


def stability_text(found: Mapping[str, Any], size: GivenSize) -> str:
    """Return when a sheet wrinkles and when it stops, and the critical thicknesses as a table."""
    names, scales = ["strain", "tau_1/W"], [1.0]
    if size.width_mm is not None:
        names.append("tau_1 mm")
        scales.append(size.width_mm)
    rows = [
        [strain, *(scale * tau for scale in scales), "wrinkles" if tau > size.thickness else "flat"]
        for strain, tau in found["critical_thickness"]
    ]
    return f"{wrapped(_stability(found, size))}\n{table([*names, 'sheet'], rows)}"


def _stability(found: Mapping[str, Any], size: GivenSize) -> str:
    passed_over = found["passed_over"]
    note = f" {passed_over[0].upper()}{passed_over[1:]}." if passed_over else ""
    return f"{_windows(found, size)}{note}"


def _windows(found: Mapping[str, Any], size: GivenSize) -> str:
    peak, where = found["max_critical_thickness"], found["strain_at_max"]
    examined = f"strain {found['largest_strain']:.4g}"
    thickest = f"{cell(peak)} W"
    if size.width_mm is not None:
        thickest = f"{cell(peak * size.width_mm)} mm ({thickest})"
    limit = f"thinner than {thickest}, at strain {where:.4g}"
    if not found["ranges"]:
        none = "No sheet of this length and material wrinkles" if not peak > 0.0 else ""
        return f"{none or 'The sheet never wrinkles'} up to {examined}" + (
            "." if none else f": only sheets {limit}, do."
        )
    least = found["critical_thickness"][0][0]
    ranges = []
    for birth, decay in found["ranges"]:
        start = _event(birth, size) + (", the least that was examined," if birth <= least else "")
        ranges.append(f"from {start} {'on' if decay is None else f'to {_event(decay, size)}'}")
    last = found["ranges"][-1][1]
    end = f"still does at {examined}" if last is None else "is flat again beyond"
    return (
        f"The sheet wrinkles {' and '.join(ranges)}, and {end}. "
        f"Sheets up to {thickest} thick wrinkle, at strain {where:.4g}."
    )


def _event(strain: float, size: GivenSize) -> str:
    clamps = size.clamps_mm(strain)
    return f"strain {cell(strain)}" + ("" if clamps is None else f" ({_mm(clamps)})")
