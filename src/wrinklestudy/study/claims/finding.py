"""A claim, the finding about it, and how a verdict is reached."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.study.claims.tables import StudyTables
from wrinklestudy.typing import Array

Verdict = Literal["agree", "disagree", "depends on", "not computed"]
VERDICTS: tuple[Verdict, ...] = get_args(Verdict)

_BEYOND = "beyond the largest strain computed"


def number_text(number: float, digits: int = 3) -> str:
    """Return a number with some significant digits; NaN and inf in words, as in `Value`."""
    if math.isnan(number):
        return "none"
    return _BEYOND if math.isinf(number) else f"{number:.{digits}g}"


@dataclass(frozen=True)
class Value:
    """A computed number.

    Parameters
    ----------
    name : str
        What the number is.
    number : float
        NaN if there is none, inf for a strain beyond those computed.
    unit : str
        Unit, empty for a ratio.
    digits : int
        Significant digits in texts; the CSV has all digits.
    """

    name: str
    number: float
    unit: str = ""
    digits: int = 3

    @property
    def text(self) -> str:
        """The number with its unit."""
        return f"{number_text(self.number, self.digits)} {self.unit}".rstrip()


@dataclass(frozen=True)
class Finding:
    """The outcome of one claim.

    Parameters
    ----------
    verdict : Verdict
        Follows from the values by the tolerance of the claim.
    values : tuple of Value
        What was computed.
    explanation : str
        A text with the computed numbers; never empty for a disagreement or a dependence.
    depends_on : str
        What the verdict depends on, if it depends on something.
    sheets : tuple of SheetStates
        The sheets that the values come from.
    """

    verdict: Verdict
    values: tuple[Value, ...] = ()
    explanation: str = ""
    depends_on: str = ""
    sheets: tuple[SheetStates, ...] = ()

    def __post_init__(self) -> None:
        """Refuse a verdict that says too little.

        Raises
        ------
        ValueError
            If anything but an agreement has no explanation, or a dependence names nothing.
        """
        if self.verdict != "agree" and not self.explanation:
            raise ValueError(f"verdict {self.verdict!r}: needs an explanation")
        if (self.verdict == "depends on") != bool(self.depends_on):
            raise ValueError(f"verdict {self.verdict!r}: depends_on = {self.depends_on!r}")


@dataclass(frozen=True)
class Claim:
    """What a publication claims and the rule that judges it.

    Parameters
    ----------
    key : str
        Short name.
    order : tuple of int
        Its place in the table of claims: section, subsection (0 for none), number.
    place : str
        Where it is claimed, by section, figure or table.
    statement : str
        What is claimed there, in the words of this project.
    reading : str
        How the statement is understood for the test, if it leaves that open; empty otherwise.
    tolerance : str
        When the study counts as agreeing.
    judge : callable
        From a study to a finding; raises `MissingError` if the study lacks something.
    """

    key: str
    order: tuple[int, ...]
    place: str
    statement: str
    reading: str
    tolerance: str
    judge: Callable[[StudyTables], Finding]

    def finding(self, study: StudyTables) -> Finding:
        """Return the finding for a study: 'not computed', and why, if it lacks something."""
        try:
            return self.judge(study)
        except MissingError as lack:
            return Finding("not computed", explanation=f"Not in the study: {lack}.")


def claim(
    *, order: tuple[int, ...], place: str, statement: str, tolerance: str, reading: str = ""
) -> Callable[[Callable[[StudyTables], Finding]], Claim]:
    """Return a decorator that makes a rule a `Claim`, named after the function."""

    def wrap(judge: Callable[[StudyTables], Finding]) -> Claim:
        key = judge.__name__.replace("_", "-")
        return Claim(key, order, place, statement, reading, tolerance, judge)

    return wrap


def largest(name: str, numbers: Array, strain: Array) -> tuple[Value, Value]:
    """Return the number of largest size under a name, and the strain at which it occurs."""
    worst = int(np.argmax(np.abs(numbers)))
    return Value(name, float(numbers[worst])), Value("at strain", float(strain[worst]))


def verdict_of(holds: bool) -> Verdict:
    """Return 'agree' or 'disagree'."""
    return "agree" if holds else "disagree"


def verdict_across(outcomes: Mapping[str, bool], what: str) -> tuple[Verdict, str]:
    """Return the verdict over several versions of the model, and what it depends on.

    Parameters
    ----------
    outcomes : mapping
        Whether the claim holds, by version.
    what : str
        What tells the versions apart.
    """
    if all(outcomes.values()):
        return "agree", ""
    if not any(outcomes.values()):
        return "disagree", ""
    yes = ", ".join(name for name, holds in outcomes.items() if holds)
    no = ", ".join(name for name, holds in outcomes.items() if not holds)
    return "depends on", f"{what} (holds for {yes}; not for {no})"


def listed(numbers: Mapping[str, float], digits: int = 3) -> str:
    """Return named numbers as part of a sentence."""
    return ", ".join(f"{number_text(v, digits)} ({name})" for name, v in numbers.items())
