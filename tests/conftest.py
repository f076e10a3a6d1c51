"""Order of the tests when they run side by side."""

from pathlib import Path

import pytest
from hypothesis import settings

HERE = Path(__file__).parent

# Machines are shared: how long an example takes says nothing about the code.
settings.register_profile("study", deadline=None)
settings.load_profile("study")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Keep the tests of a file in one process, those of the workflow in the first to start.

    They share one run of the quick study, and other files share what their fixtures compute.
    """
    for item in items:
        path = item.path.relative_to(HERE)
        group = "workflow" if path.parts[0] == "workflow" else path.as_posix()
        item.add_marker(pytest.mark.xdist_group(group))
    items.sort(key=lambda item: item.path.parent.name != "workflow")
