"""How large a problem is before anything is built: unknowns, memory and what there is of it."""

import math
import os
from dataclasses import dataclass
from pathlib import Path

from wrinklestudy.fem.grid import MeshSettings, cells
from wrinklestudy.vocabulary import Part

_DOFS = 3 * 4  # x, y, z with d/dX, d/dY, d2/dXdY at each node
# Bytes per unknown at the peak of a wrinkled state, a + b ln(unknowns): the fill-in of a
# factorisation grows like that. Measured with PARDISO: 17.3 kB (11 100 unknowns), 18.2 kB (43 500),
# 20.6 kB (168 780), 20.4 kB (476 076); the flat state and its modes alone take half of it.
_BYTES, _BYTES_PER_LOG = 6.7e3, 1.15e3
_FLAT_PART = 0.55
_GIGABYTE = 1e9
_CGROUP_LIMIT = Path("/sys/fs/cgroup/memory.max")


@dataclass(frozen=True)
class ProblemSize:
    """The mesh that a sheet needs, and what solving on it takes.

    Parameters
    ----------
    along, across : int
        Cells of the part of the sheet that is solved.
    """

    along: int
    across: int

    @classmethod
    def of_sheet(cls, aspect: float, thickness: float, mesh: MeshSettings) -> "ProblemSize":
        """Return the size for a sheet of L/W and of the t/W that its mesh is made for."""
        return cls(*cells(aspect, thickness, mesh))

    def of_part(self, part: Part) -> "ProblemSize":
        """Return the size for another part of the sheet, from that for a quarter."""
        along = 2 if part in ("half-width", "whole") else 1
        across = 2 if part in ("half", "whole") else 1
        return ProblemSize(along * self.along, across * self.across)

    @property
    def unknowns(self) -> int:
        """Degrees of freedom of that part, those that are held included."""
        return _DOFS * (self.along + 1) * (self.across + 1)

    def memory(self, wrinkled: bool = True) -> float:
        """Return an estimate of the memory in bytes, of a wrinkled state or of a flat one alone."""
        whole = self.unknowns * (_BYTES + _BYTES_PER_LOG * math.log(self.unknowns))
        return whole if wrinkled else _FLAT_PART * whole

    def text(self, wrinkled: bool = True) -> str:
        """Return what solving takes in words."""
        return (
            f"{self.along} x {self.across} cells, {self.unknowns:,} unknowns, "
            f"about {gigabytes(self.memory(wrinkled))} of memory"
        )

    def check_memory(self, sheet: str, wrinkled: bool = True, jobs: int = 1) -> None:
        """Raise a MemoryError of one line if the memory would not hold the problem.

        Parameters
        ----------
        sheet : str
            What is solved, for the message.
        wrinkled : bool
            Whether wrinkled states are wanted, not flat ones alone.
        jobs : int
            How many are solved at the same time.
        """
        available = available_memory()
        if jobs * self.memory(wrinkled) > available:
            times = f"{jobs} jobs, each with " if jobs > 1 else ""
            raise MemoryError(
                f"{sheet} needs {times}{self.text(wrinkled)}; {gigabytes(available)} are available"
            )


def gigabytes(size: float) -> str:
    """Return a number of bytes in words."""
    value = size / _GIGABYTE
    return f"{value:.0f} GB" if value >= 10.0 else f"{value:.2g} GB"


def available_memory() -> float:
    """Return the memory in bytes that this process may still take; infinity where not known."""
    found = [_free_memory(), _group_limit(), _process_limit()]
    return min((size for size in found if size is not None), default=math.inf)


def _free_memory() -> float | None:
    """Return what the kernel could give, else all that the machine has."""
    try:
        lines = Path("/proc/meminfo").read_text(encoding="ascii").splitlines()
        free = {name: value for name, _, value in (line.partition(":") for line in lines)}
        return 1024.0 * float(free["MemAvailable"].split()[0])
    except (OSError, KeyError, ValueError):
        pass
    try:
        return float(os.sysconf("SC_PAGE_SIZE")) * float(os.sysconf("SC_PHYS_PAGES"))
    except (AttributeError, OSError, ValueError):
        return None


def _group_limit() -> float | None:
    """Return the limit of a container, if there is one."""
    try:
        return float(_CGROUP_LIMIT.read_text(encoding="ascii"))
    except (OSError, ValueError):  # no such file, or "max"
        return None


def _process_limit() -> float | None:
    """Return the limit of the address space (``ulimit -v``), if there is one."""
    try:
        import resource
    except ImportError:  # not on Windows
        return None
    soft, _ = resource.getrlimit(resource.RLIMIT_AS)
    return None if soft == resource.RLIM_INFINITY else float(soft)
