"""Progress on stderr: a line that tells what a long solve is doing, on a terminal only."""

import os
import sys
import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TextIO

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.newton import Iteration
    from wrinklestudy.fem.size import ProblemSize

_PATIENCE = 2.0  # seconds after which a solve tells what it is doing
# Iterations of a wrinkled state: 6 at t/W = 1e-4, 25 at 2e-5, 40 at 1e-5. One takes 0.12 s
# with 11 100 unknowns and 7.6 s with 168 780, on one core of a few years ago.
_ITERATIONS, _DESIGN_THICKNESS, _LEAST = 0.5, 1e-3, 4.0
_SECONDS, _UNKNOWNS, _GROWTH = 0.12, 11_100, 1.5


# Set in a Jupyter kernel, which gives its commands a terminal that keeps every line.
_IN_NOTEBOOK = "JPY_PARENT_PID"


@dataclass
class StatusLine:
    """A line at the bottom of a terminal that is written over; nothing on anything else."""

    stream: TextIO = field(default_factory=lambda: sys.stderr)
    start: float = field(default_factory=time.monotonic)

    def show(self, text: str) -> None:
        """Show a text once the patience is over."""
        if self._written_over() and time.monotonic() - self.start > _PATIENCE:
            import shutil

            width = shutil.get_terminal_size().columns - 1
            self.stream.write(f"\r\x1b[2K{text[:width]}")
            self.stream.flush()

    def clear(self) -> None:
        """Leave an empty line."""
        if self._written_over():
            self.stream.write("\r\x1b[2K")
            self.stream.flush()

    def _written_over(self) -> bool:
        """Return whether a line can be written over: on a terminal, not in a notebook."""
        return self.stream.isatty() and _IN_NOTEBOOK not in os.environ


@dataclass
class SolveProgress:
    """An observer of a solve that shows stage, iteration, decrement, energy and what is left.

    Parameters
    ----------
    label : str
        What is solved.
    size : ProblemSize
    thickness : float
        t/W.
    line : StatusLine
    """

    label: str
    size: "ProblemSize"
    thickness: float
    line: StatusLine
    stage: str = ""
    iteration: int = 0
    since: float = field(default_factory=time.monotonic)

    def __call__(self, stage: str, last: "Iteration | None") -> None:
        """Show how far the solve is."""
        if stage != self.stage:
            self.stage, self.iteration = stage, 0
            self.since = time.monotonic()
        words = f"{self.label}: {stage}"
        numbers = ""
        if last is not None:
            self.iteration += 1
            words += f", iteration {self.iteration}"
            numbers = f" (decrement {last.decrement:.1e}, energy {last.energy:.6g})"
        self.line.show(f"{words}, about {duration(self.seconds_left())} left{numbers}")

    def seconds_left(self) -> float:
        """Return a rough estimate from the size of the mesh and the iterations so far."""
        expected = max(_ITERATIONS * _DESIGN_THICKNESS / self.thickness, _LEAST)
        each = _SECONDS * (self.size.unknowns / _UNKNOWNS) ** _GROWTH
        if self.stage != "wrinkled state":
            return expected * each
        if self.iteration > 1:  # the first one is told of when it is over
            each = (time.monotonic() - self.since) / (self.iteration - 1)
        return max(expected - self.iteration, 1.0) * each


def duration(seconds: float) -> str:
    """Return a time in words: '12 s', '3 min', '2.5 h'."""
    if seconds < 90.0:
        return f"{max(seconds, 1.0):.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 5400.0 else f"{seconds / 3600.0:.1f} h"
