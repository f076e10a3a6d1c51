"""A statement that others published: where, how it is known here, and of which sheet."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, get_args

from wrinklestudy.mechanics.bending import BENDING_LAWS
from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.studies.literature.sources import Source
from wrinklestudy.study.claims.finding import Claim, Finding, Value
from wrinklestudy.study.claims.tables import StudyTables

Reliability = Literal["A", "B", "C", "M"]
# How a statement is known; what is remembered only is never judged.
RELIABILITIES: dict[Reliability, str] = dict(
    zip(
        get_args(Reliability),
        (
            "read in the text, or in a file of code or data",
            "read in an abstract, in highlights or on a page of a vendor",
            "quoted by another source that was read",
            "from memory, not read anywhere",
        ),
        strict=True,
    )
)


@dataclass(frozen=True, kw_only=True)
class Published:
    """What was published, and of which sheet.

    Parameters
    ----------
    source : Source
    where : str
        Place in it, or who quotes it.
    reliability : {'A', 'B', 'C', 'M'}
        How it is known: `RELIABILITIES`.
    said : str
        The value or the trend, in a few words.
    law : str
        Law with its constants.
    aspect, thickness : str
        L/W, and t/W or t/L.
    clamps : str
        How the ends are held.

    Raises
    ------
    ValueError
        If there is no such class of reliability.
    """

    source: Source
    where: str
    reliability: Reliability
    said: str
    law: str = "not read"
    aspect: str = "not read"
    thickness: str = "not read"
    clamps: str = "clamped"

    def __post_init__(self) -> None:
        """Refuse a class that does not exist."""
        if self.reliability not in RELIABILITIES:
            raise ValueError(
                f"reliability = {self.reliability!r}: must be one of {', '.join(RELIABILITIES)}"
            )

    @property
    def place(self) -> str:
        """Source and place in one line."""
        return f"{self.source.name}, {self.where}"


@dataclass(frozen=True)
class Statement(Claim):
    """A claim of another publication.

    Parameters
    ----------
    published : Published

    Raises
    ------
    ValueError
        If it is known from memory only: then there is nothing to judge.
    """

    published: Published

    def __post_init__(self) -> None:
        """Refuse a verdict on what nobody read."""
        if self.published.reliability == "M":
            raise ValueError(f"statement {self.key!r}: from memory only, so it has no verdict")


def statement(
    published: Published,
    *,
    order: tuple[int, ...],
    says: str,
    tolerance: str,
    reading: str = "",
) -> Callable[[Callable[[StudyTables], Finding]], Statement]:
    """Return a decorator that makes a rule a `Statement`, named after the function.

    Parameters
    ----------
    published : Published
    order : tuple of int
        As of `Claim`.
    says : str
        What is stated, after the name of its source.
    tolerance, reading : str
        As of `Claim`.
    """

    def wrap(judge: Callable[[StudyTables], Finding]) -> Statement:
        key = judge.__name__.replace("_", "-")
        text = f"{published.source.name}: {says}"
        return Statement(key, order, published.place, text, reading, tolerance, judge, published)

    return wrap


def sheet_of(
    study: StudyTables,
    material: str,
    aspect: float,
    thickness: float,
    bending: str = "thinning",
    parity: str = "antisymmetric",
) -> SheetStates:
    """Return a sheet by its material, size, bending law and parity.

    Models are told by their names: that of a variant begins with that of its material.

    Raises
    ------
    MissingError
        If the study lacks it.
    """
    for sheet in study.sheets:
        own = sheet.material == material or sheet.material.startswith(f"{material}-")
        same_size = (sheet.aspect, sheet.thickness) == (aspect, thickness)
        if own and same_size and (sheet.bending, sheet.parity) == (bending, parity):
            return sheet
    raise MissingError(
        f"a sheet of {material} ({bending}, {parity}), L/W = {aspect:g}, t/W = {thickness:g}"
    )


def under_each_bending_law(
    study: StudyTables, material: str, aspect: float, thickness: float
) -> dict[str, SheetStates]:
    """Return a sheet under each bending law that was computed.

    Raises
    ------
    MissingError
        If there is none.
    """
    found = {}
    for bending in BENDING_LAWS:
        try:
            found[bending] = sheet_of(study, material, aspect, thickness, bending)
        except MissingError:
            continue
    if not found:
        raise MissingError(f"any sheet of {material}, L/W = {aspect:g}, t/W = {thickness:g}")
    return found


def bending_values(what: str, numbers: dict[str, float], digits: int = 3) -> tuple[Value, ...]:
    """Return numbers under bending laws as values; the table of statements has a column for each.

    Parameters
    ----------
    what : str
    numbers : dict
        By bending law, or by another name that follows `what`.
    digits : int
    """
    return tuple(
        Value(f"{what}, {name}", number, digits=digits) for name, number in numbers.items()
    )
