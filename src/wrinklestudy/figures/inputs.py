"""What the figures are drawn from: tables, states and materials, read when they are needed."""

from dataclasses import dataclass, field
from os import fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.figures import PAPER_SHEET
from wrinklestudy.figures.style import LAW_NAMES
from wrinklestudy.material.result import Fit, load_fit
from wrinklestudy.metrics.profile import Profile, profile_from_state
from wrinklestudy.metrics.sheet import Surface, full_surface
from wrinklestudy.metrics.table import CASE, COLUMNS, STABILITY_COLUMNS
from wrinklestudy.store import read_h5

if TYPE_CHECKING:
    import pandas as pd  # loaded where a table is read: half of the figures need none

Array = NDArray[np.float64]

_SYMBOLS = {"aspect": "L/W", "thickness": "t/W"}


@dataclass(frozen=True)
class Series:
    """The states of one sheet over strain.

    Parameters
    ----------
    label : str
        What tells this series from the others of the figure.
    law : str
        Strain energy.
    aspect, thickness : float
        L/W and t/W.
    rows : DataFrame
        Rows of the metrics table, by strain.
    birth, decay : float
        Strains at which wrinkles appear and vanish; NaN where there is none.
    """

    label: str
    law: str
    aspect: float
    thickness: float
    rows: "pd.DataFrame"
    birth: float
    decay: float

    def column(self, name: str) -> Array:
        """Return a column of the table; NaN where there is no such number."""
        return self.rows[name].to_numpy(dtype=float)

    @property
    def wrinkled(self) -> NDArray[np.bool_]:
        """Which rows are wrinkled states."""
        return np.asarray(self.rows["status"] == "wrinkled")

    @property
    def flat(self) -> NDArray[np.bool_]:
        """Which rows are flat states."""
        return np.asarray(self.rows["status"] == "flat")

    @property
    def holes(self) -> NDArray[np.bool_]:
        """Which rows did not converge."""
        return np.asarray(self.rows["status"] == "not-converged")

    def curve(self, name: str) -> tuple[Array, Array]:
        """Return strain and a column that vanishes where wrinkles appear and vanish.

        Birth and decay strain come from the eigenvalue problem of the flat sheet and are put
        in between the states with the value 0. NaN (a state that did not converge) is a gap.
        """
        ends = np.array([strain for strain in (self.birth, self.decay) if np.isfinite(strain)])
        strain = np.concatenate([self.column("strain"), ends])
        value = np.concatenate([self.column(name), np.zeros(len(ends))])
        order = np.argsort(strain, kind="stable")
        return strain[order], value[order]


@dataclass(frozen=True)
class State:
    """One wrinkle file.

    Parameters
    ----------
    strain, aspect, thickness : float
        eps, L/W, t/W.
    status : str
        wrinkled, flat or not-converged.
    parity : str
        Of the wrinkle.
    datasets : dict
        Arrays of the file.
    """

    strain: float
    aspect: float
    thickness: float
    status: str
    parity: str
    datasets: dict[str, Any] = field(repr=False)

    def profile(self, per_cell: int = 8) -> Profile:
        """Return the cross-section half-way between the clamps, in units of W."""
        return profile_from_state(*self._geometry(), self.parity, per_cell=per_cell)

    def surface(self, per_cell: tuple[int, int]) -> Surface:
        """Return the full deformed sheet, in units of W."""
        return full_surface(*self._geometry(), self.parity, per_cell)

    def _geometry(self) -> tuple[Array, Array, Array]:
        return self.datasets["grid/x"], self.datasets["grid/y"], self.datasets["position"]


@dataclass(frozen=True)
class Inputs:
    """Paths of everything that a figure may be drawn from; read on demand.

    Parameters
    ----------
    metrics, stability : Path
        Tables of the metrics stage.
    materials, states, data : tuple of Path
        Material files, wrinkle files, measured stress-strain files.
    sheet : tuple of float
        L/W and t/W of the single-sheet figures.
    """

    metrics: Path
    stability: Path
    materials: tuple[Path, ...] = ()
    states: tuple[Path, ...] = ()
    data: tuple[Path, ...] = ()
    sheet: tuple[float, float] = PAPER_SHEET

    def sheet_series(self) -> list[Series]:
        """Return the series of `sheet`; of all sheets if the study lacks that one."""
        table = _read_table(self.metrics, COLUMNS)
        wanted = (table["aspect"] == self.sheet[0]) & (table["thickness"] == self.sheet[1])
        return self._series(table[wanted] if wanted.any() else table)

    def _series(self, table: "pd.DataFrame") -> list[Series]:
        if table.empty:
            raise ValueError(f"{self.metrics}: has no rows, nothing to draw")
        limits = _read_table(self.stability, STABILITY_COLUMNS).set_index(list(CASE))
        varied = [name for name in CASE if table[name].nunique() > 1]
        found = []
        for case, rows in table.groupby(list(CASE), sort=True):
            one: dict[str, Any] = dict(zip(CASE, case, strict=True))
            birth, decay = _birth_and_decay(limits, case)
            found.append(
                Series(
                    label=_label(one, varied),
                    law=one["law"],
                    aspect=one["aspect"],
                    thickness=one["thickness"],
                    rows=rows.sort_values("strain"),
                    birth=birth,
                    decay=decay,
                )
            )
        return found

    def loaded_states(self) -> list[State]:
        """Return the states by strain.

        Raises
        ------
        ValueError
            If there is none, or they are not of one sheet.
        """
        states = sorted((_load_state(path) for path in self.states), key=lambda one: one.strain)
        if not states:
            raise ValueError("states: none given, this figure shows states")
        if len({(one.aspect, one.thickness, one.parity) for one in states}) > 1:
            raise ValueError("states: must be of one sheet (L/W, t/W, parity)")
        return states

    def fits(self) -> list[Fit]:
        """Return the fits of the materials, in the order of the files."""
        return [load_fit(path) for path in self.materials]


def _read_table(path: Path, columns: dict[str, str]) -> "pd.DataFrame":
    import pandas as pd

    table = pd.read_csv(path)
    missing = [name for name in columns if name not in table.columns]
    if missing:
        raise ValueError(f"{path}: column {missing[0]!r} is missing")
    return table


def _birth_and_decay(limits: "pd.DataFrame", case: Any) -> tuple[float, float]:
    if case not in limits.index:
        return float("nan"), float("nan")
    row = limits.loc[case]
    return float(row["birth_strain"]), float(row["decay_strain"])


def _label(case: dict[str, Any], varied: list[str]) -> str:
    parts = [] if "law" not in varied and varied else [LAW_NAMES.get(case["law"], case["law"])]
    parts += [f"${_SYMBOLS[name]} = {case[name]:g}$" for name in _SYMBOLS if name in varied]
    parts += [str(case[name]) for name in ("bending", "parity") if name in varied]
    if "material" in varied and "law" not in varied:
        parts.insert(0, str(case["material"]))
    return ", ".join(parts)


def _load_state(path: Path) -> State:
    datasets, attrs = read_h5(path)
    try:
        return State(
            strain=attrs["strain"],
            aspect=attrs["aspect"],
            thickness=attrs["thickness"],
            status=attrs["status"],
            parity=attrs["parity"],
            datasets=datasets,
        )
    except KeyError as error:
        raise ValueError(f"{fspath(path)}: attribute {error} is missing") from None


def sheet_note(aspect: float, thickness: float) -> str:
    """Return the sheet as a line of text for a figure."""
    return f"$L/W = {aspect:g}$, $t/W = {power_of_ten(thickness)}$"


def power_of_ten(value: float) -> str:
    """Return a number as a power of ten in mathtext, without dollar signs."""
    digits, exponent = f"{value:.6e}".split("e")
    factor = f"{float(digits):g}"
    power = f"10^{{{int(exponent)}}}"
    return power if factor == "1" else rf"{factor} \times {power}"
