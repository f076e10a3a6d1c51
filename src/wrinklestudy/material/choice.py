"""Which points of a measurement a law is fitted to, and what is known of the others."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from wrinklestudy.material.branches import BRANCHES, Loop, hysteresis
from wrinklestudy.material.data import Measurement
from wrinklestudy.material.preload import KEEP, REMOVE, TREATMENTS, Extrapolation, extrapolate
from wrinklestudy.material.preload import removed as without_preload
from wrinklestudy.typing import Indices


@dataclass(frozen=True)
class Choice:
    """What is fitted of a file.

    Parameters
    ----------
    stretch : tuple of float, optional
        Smallest and largest stretch; all by default.
    modes : sequence of str, optional
        Deformation modes; all by default.
    branch : str
        loading or unloading.
    cycle : int
        Which loading and unloading, from 1.
    preload : str
        Whether a stress at stretch 1 is kept or removed: keep or remove.
    """

    stretch: tuple[float, float] | None = None
    modes: Sequence[str] | None = None
    branch: str = BRANCHES[0]
    cycle: int = 1
    preload: str = KEEP


@dataclass(frozen=True, eq=False)
class Chosen:
    """The points that are fitted.

    Parameters
    ----------
    whole : Measurement
        All points of the file, without the preload if that is removed.
    rows : (n,) array of int
        Those that are fitted.
    extrapolations : dict
        Stress at stretch 1 by mode, where it is known.
    loops : dict
        Loading and unloading by mode, where there is more than one loading.
    """

    whole: Measurement
    rows: Indices
    extrapolations: dict[str, Extrapolation]
    loops: dict[str, Loop]

    @property
    def points(self) -> Measurement:
        """The points that are fitted."""
        return self.whole.kept(self.rows)


def choose(data: Measurement, choice: Choice) -> Chosen:
    """Return the points of a measurement that are to be fitted.

    Raises
    ------
    ValueError
        If a part of the choice is not allowed, the data has no such points, or a preload that is to
        be removed is not known; one line that names the file.
    """
    for key, allowed in (("branch", BRANCHES), ("preload", TREATMENTS)):
        if getattr(choice, key) not in allowed:
            raise ValueError(
                f"{key} {getattr(choice, key)!r} is unknown: allowed are {', '.join(allowed)}"
            )
    if choice.cycle < 1:
        raise ValueError(f"cycle = {choice.cycle}: must be >= 1")
    inside = data.within(choice.stretch, choice.modes)
    branch = data.on(choice.branch, choice.cycle)
    on_branch = data.kept(branch).modes
    lost = [mode for mode in choice.modes or data.modes if mode not in on_branch]
    if lost and (choice.modes is not None or not on_branch):
        raise ValueError(
            f"{data.source}: has no {choice.branch} in cycle {choice.cycle} of the {lost[0]} test"
        )
    modes = [mode for mode in on_branch if choice.modes is None or mode in choice.modes]
    extrapolations = extrapolate(data, modes)
    if choice.preload == REMOVE:
        data = without_preload(data, modes, extrapolations)
    loops = {mode: _loop(data, mode, choice.cycle) for mode in modes}
    loops = {mode: loop for mode, loop in loops.items() if loop.unloading or loop.cycles > 1}
    return Chosen(data, np.flatnonzero(inside & branch), extrapolations, loops)


def _loop(data: Measurement, mode: str, cycle: int) -> Loop:
    """Return what is known of loading and unloading in a mode."""
    own = data.kept(data.mode == mode)
    curves = []
    for branch in BRANCHES:
        points = own.kept(own.on(branch, cycle))
        curves.append((points.stretch, points.stress))
    both = all(stretch.size for stretch, _ in curves)
    unloading = 0 if own.branch is None else int(np.sum(own.branch == BRANCHES[1]))
    return Loop(
        loading=own.stretch.size - unloading,
        unloading=unloading,
        cycles=1 if own.cycle is None else int(own.cycle.max()),
        hysteresis=hysteresis(*curves) if both else float("nan"),
    )
