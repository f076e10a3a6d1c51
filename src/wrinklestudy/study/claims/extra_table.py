"""A further table of the claims stage, in a file and on the page."""

from dataclasses import dataclass


@dataclass(frozen=True)
class ExtraTable:
    """A table that a study adds to its claims.

    Parameters
    ----------
    columns : tuple of str
        Columns of the file.
    rows : tuple of tuple
        Rows of the file: texts, and numbers with all digits; NaN where there is no number.
    head : tuple of str
        Columns of the table on the page; empty if there is nothing to show.
    cells : tuple of tuple of str
        Rows of the table on the page.
    note : str
        Sentence below the table on the page, or instead of it.
    """

    columns: tuple[str, ...]
    rows: tuple[tuple[str | float, ...], ...]
    head: tuple[str, ...] = ()
    cells: tuple[tuple[str, ...], ...] = ()
    note: str = ""
