"""What a group of the verification writes: checks with tolerances, tables and plots."""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, field
from typing import Any, Literal

from wrinklestudy.files.storage import read_json, write_json
from wrinklestudy.typing import AnyPath

Comparison = Literal["absolute", "relative", "at most", "at least", "more than"]


@dataclass(frozen=True)
class Check:
    """A number, and what it must be.

    Parameters
    ----------
    name : str
        What is compared, with the case.
    value : float
        What was computed.
    expected : float
        Closed form, independent value or bound.
    tolerance : float
        Largest deviation, absolute or relative to `expected`; not used for bounds.
    kind : {'absolute', 'relative', 'at most', 'at least', 'more than'}
        How the two are compared; 'more than' is not passed by the bound itself.
    reason : str
        Why this value and this tolerance.
    """

    name: str
    value: float
    expected: float
    tolerance: float = 0.0
    kind: Comparison = "relative"
    reason: str = ""

    @property
    def passed(self) -> bool:
        """Whether the value is as it must be; NaN never is."""
        if math.isnan(self.value):
            return False
        if self.kind == "at most":
            return self.value <= self.expected
        if self.kind == "at least":
            return self.value >= self.expected
        if self.kind == "more than":
            return self.value > self.expected
        scale = abs(self.expected) if self.kind == "relative" else 1.0
        return abs(self.value - self.expected) <= self.tolerance * scale


@dataclass(frozen=True)
class Table:
    """A table of the page.

    Parameters
    ----------
    title : str
    columns : sequence of str
    rows : sequence of sequences
        Numbers or texts.
    """

    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[float | int | str | None]]


@dataclass(frozen=True)
class Group:
    """Everything that one group of the verification computed.

    Parameters
    ----------
    name, title, text : str
        Name of the module, heading, and what is shown (Markdown; numbers filled in by the group).
    checks : sequence of Check
    tables : sequence of Table
    plots : sequence of (file name, caption)
        PNG files that lie beside the JSON file of the group.
    """

    name: str
    title: str
    text: str
    checks: Sequence[Check]
    tables: Sequence[Table] = field(default_factory=tuple)
    plots: Sequence[tuple[str, str]] = field(default_factory=tuple)


def conclusion(holds: bool, yes: str, no: str) -> str:
    """Return the sentence that the numbers support; a comparison with NaN does not hold.

    Parameters
    ----------
    holds : bool
        Whether the statement holds, from the computed numbers.
    yes, no : str
        The sentence if it holds, and if it does not.
    """
    return yes if holds else no


def write(group: Group, output: AnyPath) -> None:
    """Write a group as JSON, each check with its verdict."""
    content = asdict(group)
    content["checks"] = [asdict(check) | {"passed": check.passed} for check in group.checks]
    write_json(output, content)


def read(path: AnyPath) -> dict[str, Any]:
    """Return a group as plain values."""
    content: dict[str, Any] = read_json(path)
    return content
