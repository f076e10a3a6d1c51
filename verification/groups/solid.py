"""Group: the sheet as a three-dimensional solid, without any theory of plates."""

from collections.abc import Hashable
from pathlib import Path
from typing import Any

import pandas as pd

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools import solid_table as solid
from verification.tools.solid_estimates import (
    PAPER,
    Estimate,
    Pieces,
    clamp_step,
    estimate,
    extrapolated,
    pieces_of,
    strain_of,
)
from verification.tools.solid_table import case
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.sheet import Sheet
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

SHEETS = (PAPER, ("paper", 1.2e-3), ("neo-Hookean", 1.0e-3), ("10:1", 1.0e-3))
LAWS = ("thinning", "fixed-thickness", "fvk")
STRAIN_BAR = 8.0e-4  # between solid and plate
ERROR_BAR = 4.0e-4  # of the solid itself
AMPLITUDE_BAR = 0.003
_SAME = 2.0e-5  # strains that are computed again on the same mesh
_LAYERS_BAR = 1.0e-4
FINER = solid.FINEST[0] / solid.FINE[0]
_BULK_BAR = 0.1  # of the ratio in which the error falls with K
_AGAIN = 0.18  # strain of the state that is computed again
_APART = 10.0  # error bars between the solid and a law that is refuted
_ENDS = ("birth", "decay")


def _end_checks(ends: pd.DataFrame, best: dict[tuple[str, str, float], Estimate]) -> list[Check]:
    checks = []
    for end in _ENDS:
        for sheet in SHEETS:
            value = best[end, *sheet]
            name = f"{end} of {sheet[0]}, t/W {sheet[1]:g}"
            plate = solid.plate_ends(*sheet)[_ENDS.index(end)]
            why = "`thinning`; the solid extrapolated"
            small = "mesh and K/mu: what the extrapolations add"
            checks += [
                Check(f"{name}: solid", value.strain, plate, STRAIN_BAR, "absolute", why),
                Check(f"{name}: error bar", value.bar, ERROR_BAR, 0.0, "at most", small),
            ]
    for row in ends.to_dict("records"):
        name = ", ".join(map(str, _named(row)))
        for end in _ENDS:
            count = abs(row[f"{end}_after"] - row[f"{end}_before"])
            corner = row[f"{end}_corner"]
            why = "one mode crosses zero within the bracket of the root"
            checks += [
                Check(f"{name}: modes that cross at {end}", count, 1, 0.0, "absolute", why),
                Check(f"{name}: corner at {end}", corner, 0.5, 0.0, "at most", "it is a wrinkle"),
            ]
    return checks


def _option_checks(ends: pd.DataFrame) -> list[Check]:
    """Return the checks of what K/mu, layers and clamp change."""
    checks = []
    usual = case("paper", 1.0e-3, solid.FINE)
    for end in _ENDS:
        values = [
            strain_of(ends, end, case("paper", 1.0e-3, solid.FINE, bulk))
            for bulk in (200.0, 1.0e3, solid.STIFF)
        ]
        fall = (values[0] - values[2]) / (values[1] - values[2])
        expected = (1 / 200 - 1 / solid.STIFF) / (1 / 1.0e3 - 1 / solid.STIFF)
        why = "the error goes like mu/K"
        checks.append(Check(f"{end}: K/mu 200 and 1000", fall, expected, _BULK_BAR, reason=why))
        two = strain_of(ends, end, case("paper", 1.0e-3, solid.FINE, layers=2))
        coarse, fine = (clamp_step(ends, end, cells) for cells in (solid.FINE, solid.FINEST))
        known = strain_of(ends, end, usual)
        one = "one element of order 3 holds all that happens through the thickness"
        held = "both clamps on the finest mesh"
        falls = "cells at the clamp are wider than the layer that holding the thickness makes"
        checks += [
            Check(f"{end}: two layers", two, known, _LAYERS_BAR, "absolute", one),
            Check(f"{end}: whole face clamped", fine, 0.0, STRAIN_BAR, "absolute", held),
            Check(
                f"{end}: what holding the face costs, finer mesh over coarser",
                fine / coarse,
                1.0 / FINER,
                0.0,
                "at most",
                falls,
            ),
        ]
    return checks


def _state_checks(states: pd.DataFrame, plates: dict[float, float]) -> tuple[list[Check], Table]:
    kept = {
        cells: solid.rows_of(states, case("paper", 1.0e-3, cells)).set_index("strain")
        for cells in (solid.MIDDLE, solid.FINE)
    }
    soft = solid.rows_of(states, case("paper", 1.0e-3, solid.FINE, 1.0e3)).set_index("strain")
    checks, rows = [], []
    for strain, plate in plates.items():
        middle, fine = (float(table.amplitude_over_thickness[strain]) for table in kept.values())
        limit = extrapolated(middle, fine, solid.FINE[0] / solid.MIDDLE[0])
        softer = float(soft.amplitude_over_thickness[strain])
        profile = float(kept[solid.FINE].profile_difference[strain])
        name = f"strain {strain:g}:"
        checks += [
            Check(f"{name} A/t, solid", fine, plate, AMPLITUDE_BAR, reason="plate: `thinning`"),
            Check(
                f"{name} unstable modes",
                float(kept[solid.FINE].unstable[strain]),
                0,
                0.0,
                "absolute",
            ),
        ]
        rows.append(
            [
                f"{strain:g}",
                f"{plate:.4f}",
                *(f"{value:.4f}" for value in (softer, middle, fine, limit)),
                f"{100 * (fine / plate - 1):+.2f}%",
                f"{100 * (limit / plate - 1):+.2f}%",
                f"{100 * profile:.2f}%",
            ]
        )
    columns = (
        "strain",
        "plate",
        "16 x 32, K/mu 1000",
        "12 x 24",
        "16 x 32",
        "extrapolated",
        "16 x 32 over plate",
        "extrapolated over plate",
        "profile, 16 x 32",
    )
    return checks, Table("A/t of wrinkled solids", columns, rows)


def again(cells: tuple[int, int], ends: pd.DataFrame) -> list[Check]:
    """Return the check that birth and decay on a mesh, computed now, are those of the table."""
    wanted = case("paper", 1.0e-3, cells)
    return [
        Check(
            f"{end} on {cells[0]} x {cells[1]}, computed now",
            found.strain,
            strain_of(ends, end, wanted),
            _SAME,
            "absolute",
            "the kept table",
        )
        for end, found in zip(_ENDS, solid.solve_ends(wanted), strict=True)
    ]


def quick() -> list[Check]:
    """Return the strains of a solid that is computed now, on two small meshes, and the plate's."""
    coarse, fine = (
        solid.solve_ends(case("paper", 1.0e-3, cells)) for cells in (solid.COARSE, solid.MIDDLE)
    )
    ratio = solid.MIDDLE[0] / solid.COARSE[0]
    plate = solid.plate_ends("paper", 1.0e-3)
    return [
        Check(
            f"{end} of the solid",
            extrapolated(low.strain, high.strain, ratio),
            expected,
            STRAIN_BAR,
            "absolute",
            "`thinning`",
        )
        for end, low, high, expected in zip(_ENDS, coarse, fine, plate, strict=True)
    ]


def verdicts(best: dict[str, Estimate], laws: dict[str, tuple[float, float]]) -> str:
    """Say of each bending law what follows from the solid.

    Parameters
    ----------
    best : dict
        Birth and decay of the solid.
    laws : dict
        Birth and decay of the plate under each law.
    """
    sentences = []
    for law, values in laws.items():
        misses = [abs(v - best[end].strain) for v, end in zip(values, _ENDS, strict=True)]
        agrees = all(miss <= STRAIN_BAR for miss in misses)
        refuted = any(
            miss > max(STRAIN_BAR, _APART * best[end].bar)
            for miss, end in zip(misses, _ENDS, strict=True)
        )
        off = (
            f"birth {values[0]:.4f}, decay {values[1]:.4f}: {misses[0]:.4f} and {misses[1]:.4f} off"
        )
        says = conclusion(
            agrees,
            "it is the plate that the solid is",
            conclusion(refuted, "the solid rules it out", "the solid does not decide on it"),
        )
        sentences.append(f"`{law}` ({off}): {says}.")
    return " ".join(sentences)


def _text(
    best: dict[tuple[str, str, float], Estimate],
    laws: dict[str, tuple[float, float]],
    pieces: Pieces,
    dates: str,
) -> str:
    own = {end: best[end, *SHEETS[0]] for end in _ENDS}
    birth, decay = own["birth"], own["decay"]
    between = pieces.clamp * pieces.difference < 0.0 and abs(pieces.clamp) > abs(pieces.difference)
    return (
        "At which strain wrinkles vanish hangs on the bending law, so plates cannot decide it "
        "among themselves. Here the same quarter sheet is a solid: hexahedra of order 3, one "
        "through the thickness, elements and Gauss rules by FElupe, nearly incompressible with "
        "pressure and volume eliminated in each element. Flat states are solved among "
        "displacements that are even in z, the tangent is taken among odd ones; birth and decay "
        "are zeros of its lowest eigenvalue. Only at the clamp is there a choice: the middle line "
        "is held, and the thickness is free (`line`), or the whole face (`face`).\n\n"
        f"The paper's sheet, t/W = 1e-3: birth {birth.strain:.5f} +- {birth.bar:.5f}, decay "
        f"{decay.strain:.5f} +- {decay.bar:.5f}. The three bending laws: {verdicts(own, laws)}\n\n"
        f"The decay strains of solid and `thinning` differ by {pieces.difference:+.5f}. Mesh and "
        f"K/mu leave {decay.bar:.5f} (extrapolation adds {decay.mesh_step:+.5f} for the mesh and "
        f"{decay.bulk_step:+.5f} for K/mu). A second layer of elements changes "
        f"{pieces.layers:+.5f}. Transverse shear, which Kirchhoff and Love neglect, is worth "
        f"{pieces.shear:+.5f} (estimate: bending softer by 2/5 (k t)^2). Holding the thickness at "
        f"the clamp is worth {pieces.clamp:+.5f}: "
        + conclusion(
            between,
            "the plate, which does not know this choice, lies between both solids.",
            "both solids lie on the same side of the plate.",
        )
        + f"\n\nThe large meshes are computed by `make verify-solid` and kept in "
        f"`{solid.ENDS.as_posix()}` and `{solid.STATES.as_posix()}` ({dates}); two small meshes "
        "and a wrinkled state are computed anew here and must agree with those tables."
    )


def _named(row: dict[Hashable, Any]) -> list[str]:
    """Return what tells one solid from another, in the order of the table."""
    cells = f"{row['cells_along']} x {row['cells_across']}"
    numbers = (f"{row['thickness']:g}", cells, f"{row['bulk']:g}", str(row["layers"]))
    return [row["material"], *numbers, row["clamp"]]


def _ends_table(ends: pd.DataFrame) -> Table:
    columns = ["material", "t/W", "cells", "K/mu", "layers", "clamp", "birth", "decay"]
    rows = [
        [*_named(row), *(f"{row[end]:.5f}" for end in _ENDS)] for row in ends.to_dict("records")
    ]
    return Table("Birth and decay of solids", columns, rows)


def _best_table(best: dict[tuple[str, str, float], Estimate]) -> Table:
    rows = []
    for sheet in SHEETS:
        row: list[str] = [sheet[0], f"{sheet[1]:g}"]
        for end, plate in zip(_ENDS, solid.plate_ends(*sheet), strict=True):
            value = best[end, *sheet]
            row += [f"{value.strain:.5f} +- {value.bar:.5f}", f"{plate:.5f}"]
        rows.append(row)
    columns = ("material", "t/W", "birth, solid", "`thinning`", "decay, solid", "`thinning`")
    return Table("The solid, extrapolated, and the plate", columns, rows)


def _plot(states: pd.DataFrame, plates: dict[str, dict[float, float]], path: Path) -> None:
    fine = solid.rows_of(states, case("paper", 1.0e-3, solid.FINE))
    with style.applied():
        figure = style.new(style.COLUMN, 5.0)
        axes = figure.subplots()
        for look, (law, values) in zip(style.looks(list(plates)), plates.items(), strict=True):
            axes.plot([*values], [*values.values()], look.line, color=look.color, label=law)
        axes.plot(fine.strain, fine.amplitude_over_thickness, "ko", mfc="none", label="solid")
        axes.set(xlabel=r"strain $\varepsilon$", ylabel=r"$A/t$", ylim=(0.0, None))
        axes.legend()
        style.save(figure, path)


def _plate_amplitudes(bending: str) -> dict[float, float]:
    mesh = solid.PLATE_MESH if bending == "thinning" else MeshSettings()
    sheet = Sheet(2.0, 1.0e-3, solid.MATERIALS["paper"], bending, mesh=mesh)
    amplitudes = {}
    for strain in solid.STRAINS:
        measures = sheet.solve(strain).measures
        amplitudes[strain] = float("nan") if measures is None else measures.amplitude / 1.0e-3
    return amplitudes


def run(output: AnyPath) -> None:
    """Write the group: the kept tables against the plate, and small meshes computed anew."""
    output = Path(output)
    ends, states = pd.read_csv(solid.ENDS), pd.read_csv(solid.STATES)
    best = {(end, *sheet): estimate(ends, end, sheet) for end in _ENDS for sheet in SHEETS}
    laws = {law: solid.plate_ends("paper", 1.0e-3, law) for law in LAWS}
    plates = {law: _plate_amplitudes(law) for law in LAWS[:2]}
    state_checks, state_table = _state_checks(states, plates["thinning"])
    checks = [
        *again(solid.COARSE, ends),
        *again(solid.MIDDLE, ends),
        _state_again(states),
        *_end_checks(ends, best),
        *_option_checks(ends),
        *state_checks,
    ]
    dates = ", ".join(
        f"{row['date']}, FElupe {row['felupe']}"
        for row in ends[["date", "felupe"]].drop_duplicates().to_dict("records")
    )
    pieces = pieces_of(ends, best["decay", *SHEETS[0]])
    _plot(states, plates, output.with_name("solid.png"))
    caption = "A/t of the solid on 16 x 32 cells and of plates under two bending laws."
    group = Group(
        "solid",
        "A solid, not a plate",
        _text(best, laws, pieces, dates),
        checks,
        [_best_table(best), _ends_table(ends), state_table],
        [("solid.png", caption)],
    )
    write(group, output)


def _state_again(states: pd.DataFrame) -> Check:
    wanted = case("paper", 1.0e-3, solid.COARSE)
    kept = solid.rows_of(states, wanted).set_index("strain").amplitude_over_thickness[_AGAIN]
    now = solid.solve_state(wanted.sheet(), wanted.plate().solve(_AGAIN))
    value = now["amplitude_over_thickness"]
    name = f"A/t at strain {_AGAIN:g} on 8 x 16, computed now"
    return Check(name, value, float(kept), 1.0e-5, reason="the kept table")
