"""The sheets that a figure shows, each with its states over strain, from the tables."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.results.cases import canonical
from wrinklestudy.results.peaks import peak_row
from wrinklestudy.results.table import CASE, read_states, stability_row
from wrinklestudy.study.figures.style import law_label, short_law_label
from wrinklestudy.typing import Array

Row = Mapping[str, Any]

_SYMBOLS = {"aspect": "L/W", "thickness": "t/W"}


@dataclass(frozen=True, eq=False)
class Series:
    """The states of one sheet over strain.

    Parameters
    ----------
    label : str
        What tells this series from the others of the figure.
    law, bending, parity : str
        Strain energy, bending law, symmetry across the width.
    aspect, thickness : float
        L/W and t/W.
    rows : list of mapping
        Rows of the metrics table, by strain.
    birth, decay : float
        Strains at which wrinkles appear and vanish; NaN where there is none.
    """

    label: str
    law: str
    bending: str
    parity: str
    aspect: float
    thickness: float
    birth: float
    decay: float
    rows: list[Row] = field(repr=False)

    def column(self, name: str) -> Array:
        """Return a column of the table; NaN where there is no such number."""
        return np.array([row[name] for row in self.rows], dtype=np.float64)

    def of_status(self, status: str) -> NDArray[np.bool_]:
        """Return which rows have a status."""
        return np.array([row["status"] == status for row in self.rows])

    @property
    def sheet(self) -> tuple[float, float]:
        """L/W and t/W as `wrinklestudy.study.measurements` has them."""
        return canonical(self.aspect), canonical(self.thickness)

    @property
    def wrinkled(self) -> NDArray[np.bool_]:
        """Which rows are wrinkled states."""
        return self.of_status("wrinkled")

    @property
    def flat(self) -> NDArray[np.bool_]:
        """Which rows are flat states."""
        return self.of_status("flat")

    @property
    def holes(self) -> NDArray[np.bool_]:
        """Which rows did not converge."""
        return self.of_status("not-converged")

    @property
    def never_wrinkles(self) -> bool:
        """Whether every state is flat and the flat sheet is stable throughout."""
        return bool(self.flat.all()) and not np.isfinite(self.birth)

    def maximum(self) -> float:
        """Return the maximum of A/t over strain as the summary has it; NaN if it is not known.

        Zero if the sheet never wrinkles. It is not known if a state beside it did not converge, or
        if no state is wrinkled although the flat sheet is unstable between two of the strains.
        """
        limits = {name: self.rows[0][name] for name in CASE}
        limits |= {"birth_strain": _or_none(self.birth), "decay_strain": _or_none(self.decay)}
        return float(peak_row(limits, self.rows)["max_amplitude_over_thickness"])

    def curve(self, name: str) -> tuple[Array, Array]:
        """Return strain and a column that vanishes where wrinkles appear and vanish.

        Birth and decay strain come from the eigenvalue problem of the flat sheet and are put
        in between the states with the value 0, unless they are farther from the states than these
        are from each other. NaN (a state that did not converge) is a gap.
        """
        strain = self.column("strain")
        reach = np.diff(strain).max(initial=0.0) if len(strain) > 1 else np.inf
        ends = np.array([self.birth, self.decay])
        ends = ends[(ends >= strain[0] - reach) & (ends <= strain[-1] + reach)]
        value = np.concatenate([self.column(name), np.zeros(len(ends))])
        strain = np.concatenate([strain, ends])
        order = np.argsort(strain, kind="stable")
        return strain[order], value[order]


def read_series(metrics: Sequence[Path], stability: Sequence[Path]) -> list[Series]:
    """Return the sheets of the tables, in their order.

    Parameters
    ----------
    metrics : sequence of Path
        Tables of the metrics stage.
    stability : sequence of Path
        Files of the stability stage; a sheet without one has no birth and decay.

    Raises
    ------
    ValueError
        If there is no table, or one has no rows or lacks a column; one line that names the file.
    """
    if not metrics:
        raise ValueError("metrics: no table given, this figure shows sheets")
    cases: dict[tuple[Any, ...], list[Row]] = {}
    for path in metrics:
        rows = read_states(path)
        if not rows:
            raise ValueError(f"{path}: has no rows, nothing to draw")
        for row in rows:
            cases.setdefault(_key(row), []).append(row)
    limits = {_key(row): row for row in map(stability_row, stability)}
    labels = _labels([rows[0] for rows in cases.values()])
    return [
        _series(label, rows, limits.get(case, {}))
        for label, (case, rows) in zip(labels, cases.items(), strict=True)
    ]


def _series(label: str, rows: list[Row], limits: Row) -> Series:
    case = rows[0]
    return Series(
        label=label,
        law=case["law"],
        bending=case["bending"],
        parity=case["parity"],
        aspect=case["aspect"],
        thickness=case["thickness"],
        birth=_or_nan(limits.get("birth_strain")),
        decay=_or_nan(limits.get("decay_strain")),
        rows=sorted(rows, key=lambda one: float(one["strain"])),
    )


def _key(row: Row) -> tuple[Any, ...]:
    return tuple(row[name] for name in CASE)


def _or_nan(value: float | None) -> float:
    return float("nan") if value is None else float(value)


def _or_none(value: float) -> float | None:
    return None if np.isnan(value) else value


def _labels(cases: list[Row]) -> list[str]:
    """Return what tells each case from the others: its law if there is but one."""
    varied = [name for name in CASE[1:] if len({case[name] for case in cases}) > 1] or ["law"]
    name_of = law_label if varied == ["law"] else short_law_label
    labels = []
    for case in cases:
        parts = [name_of(str(case["law"]))] if "law" in varied else []
        parts += [
            f"${_SYMBOLS[name]} = {number(case[name])}$" for name in _SYMBOLS if name in varied
        ]
        parts += [str(case[name]) for name in ("bending", "parity") if name in varied]
        labels.append(", ".join(parts))
    if len(set(labels)) < len(labels):
        labels = [f"{case['material']}: {text}" for case, text in zip(cases, labels, strict=True)]
    return labels


def note(series: Sequence[Series]) -> str:
    """Return what all series have in common and their labels do not say."""
    first, parts = series[0], []
    if len({one.law for one in series}) == 1 and len(series) > 1:
        parts.append(law_label(first.law))
    for name, symbol in _SYMBOLS.items():
        if len({getattr(one, name) for one in series}) == 1:
            parts.append(f"${symbol} = {number(getattr(first, name))}$")
    for name, default in (("bending", "thinning"), ("parity", "antisymmetric")):
        common = {getattr(one, name) for one in series}
        if len(common) == 1 and common != {default}:
            parts.append(getattr(first, name))
    return ", ".join(parts)


def number(value: float) -> str:
    """Return a number in mathtext without dollar signs: a power of ten if it is small."""
    if value >= 0.01:
        return f"{value:g}"
    digits, exponent = f"{value:.6e}".split("e")
    factor = f"{float(digits):g}"
    power = f"10^{{{int(exponent)}}}"
    return power if factor == "1" else rf"{factor} \times {power}"
