"""Loading and unloading in measured data, and cycles of both.

Rubber is stiffer while it is stretched further than while it is let go, and softer the second time;
a law is fitted to one of these branches. Files either name the branch of each point, or it follows
from the order of the points: where the strain turns back, unloading begins.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.typing import Array, Indices, Mask

BRANCHES = ("loading", "unloading")

# Of the span of strain: a way back that is shorter is scatter of the gauge.
_SCATTER = 0.05
# Of a way back: more than that in its first step is no unloading but the start of another test.
_JUMP = 0.8
# Fewer points between turns than this on average are points in no order.
_POINTS_PER_RUN = 3


class Branches(NamedTuple):
    """Branch and cycle (from 1) of each point, shape ``(n,)`` each."""

    branch: NDArray[np.str_]
    cycle: Indices


@dataclass(frozen=True)
class Loop:
    """What is known of loading and unloading in one mode of deformation.

    Parameters
    ----------
    loading, unloading : int
        Numbers of points, over all cycles.
    cycles : int
        Number of loadings that follow an unloading, and the first.
    hysteresis : float
        Area between both branches of the cycle that is fitted over the area below its loading,
        within the strains that both have; NaN without an unloading.
    """

    loading: int
    unloading: int
    cycles: int
    hysteresis: float


def tell_branches(stretch: Array, mode: NDArray[np.str_], named: Sequence[str] = ()) -> Branches:
    """Return branch and cycle of each point.

    In each mode, in the order of the file, a run of rising or falling stretch follows another; the
    first is loading, later ones are unloading where they lead back to stretch 1. A turn counts from
    5 % of the span of the stretches. A step that leads back at once begins another test in the same
    branch, and where strains go up and down from point to point all is loading.

    Parameters
    ----------
    stretch : (n,) array
    mode : (n,) array of str
    named : sequence of str
        Branch of each point, if the file names it.
    """
    branch = np.full(stretch.shape, BRANCHES[0], dtype="<U9")
    cycle = np.ones(stretch.shape, dtype=np.int64)
    for name in np.unique(mode):
        rows = np.flatnonzero(mode == name)
        own = (
            np.array(named, dtype=np.str_)[rows]
            if named
            else np.where(_unloads(stretch[rows]), BRANCHES[1], BRANCHES[0])
        )
        again = (own[1:] == BRANCHES[0]) & (own[:-1] == BRANCHES[1])
        branch[rows] = own
        cycle[rows[1:]] += np.cumsum(again)
    return Branches(branch, cycle)


def _unloads(stretch: Array) -> Mask:
    """Return which points of one mode are on an unloading branch."""
    back = np.zeros(stretch.shape, dtype=np.bool_)
    turns = _turns(stretch, _SCATTER * float(np.ptp(stretch)))
    if len(stretch) < _POINTS_PER_RUN * (len(turns) + 1):
        return back
    unloading, continued = False, False
    for k, start in enumerate(turns):
        last = k + 1 == len(turns)
        end = len(stretch) - 1 if last else turns[k + 1]
        way = stretch[end] - stretch[start]
        jump = not last and (stretch[start + 1] - stretch[start]) / way > _JUMP
        run = slice(start + 1, end + 1)
        if jump or continued:
            back[run] = unloading
            continued = jump
            continue
        back[run] = _toward_rest(stretch[run], float(stretch[start]), float(np.ptp(stretch)))
        unloading = bool(back[end])
    return back


def _toward_rest(run: Array, start: float, span: float) -> Mask:
    """Return which points of a run lead back to stretch 1; it may lead on to the other side."""
    ends = np.array([start, run[-1]]) - 1.0
    if ends[0] * ends[1] < 0.0 and np.abs(ends).min() > _SCATTER * span:
        across: Mask = (run - 1.0) * ends[0] > 0.0
        return across
    return np.full(run.shape, abs(ends[1]) < abs(ends[0]))


def _turns(values: Array, least: float) -> list[int]:
    """Return where values turn by more than an amount: the first point of each extreme."""
    if not least > 0.0:
        return []
    turns: list[int] = []
    direction, low, high = 0, 0, 0
    numbers: list[float] = values.tolist()
    for k, value in enumerate(numbers):
        if direction >= 0 and value <= numbers[high] - least:
            if direction > 0:
                turns.append(high)
            direction, low = -1, k
        elif direction <= 0 and value >= numbers[low] + least:
            if direction < 0:
                turns.append(low)
            direction, high = 1, k
        high = k if value > numbers[high] else high
        low = k if value < numbers[low] else low
    return turns


def hysteresis(loading: tuple[Array, Array], unloading: tuple[Array, Array]) -> float:
    """Return the area between two branches over the area below the loading, NaN without area.

    Parameters
    ----------
    loading, unloading : pair of (n,) arrays
        Stretch and stress of a branch, in any order.
    """
    low = max(stretch.min() for stretch, _ in (loading, unloading))
    high = min(stretch.max() for stretch, _ in (loading, unloading))
    if not low < high:
        return float("nan")
    inner = np.concatenate([loading[0], unloading[0]])
    grid = np.unique(np.concatenate([[low, high], inner[(inner > low) & (inner < high)]]))
    areas = []
    for stretch, stress in (loading, unloading):
        order = np.argsort(stretch, kind="stable")
        curve = np.interp(grid, stretch[order], stress[order])
        areas.append(float(np.sum(0.5 * (curve[1:] + curve[:-1]) * np.diff(grid))))
    return 1.0 - areas[1] / areas[0] if areas[0] != 0.0 else float("nan")
