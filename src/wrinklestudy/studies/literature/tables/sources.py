"""The sources, and how each is known."""

from wrinklestudy.studies.literature import sources
from wrinklestudy.studies.literature.sources import Source
from wrinklestudy.study.claims.extra_table import ExtraTable
from wrinklestudy.study.claims.tables import StudyTables

COLUMNS = ("name", "citation", "read")
_HEAD = ("", "source", "what was read")


def table(_: StudyTables) -> ExtraTable:
    """Return a row for each source."""
    every = [source for source in vars(sources).values() if isinstance(source, Source)]
    rows = tuple((source.name, source.citation, source.read) for source in every)
    return ExtraTable(COLUMNS, rows, _HEAD, rows)
