"""docs/upstream.md: the faults are there in what is installed, as the page says.

A failure here is good news: upstream has mended something, and the page and the way around it can
go.
"""

import inspect
import re
import subprocess
import sys
from pathlib import Path

import pytest

PAGE = (Path(__file__).parents[2] / "docs" / "upstream.md").read_text(encoding="utf-8")
EXAMPLES = {
    title: re.findall(r"```python\n(.*?)```\n\nprints\n\n```text\n(.*?)```", text, re.DOTALL)
    for title, text in re.findall(r"^## ([^\n]*)\n(.*?)(?=^## |\Z)", PAGE, re.DOTALL | re.MULTILINE)
}
NUMBERS = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def numbers(text):
    return [float(number) for number in NUMBERS.findall(text)]


@pytest.mark.parametrize("title", [title for title in EXAMPLES if title.startswith("scikit-fem")])
def test_the_example_prints_what_the_page_says(title):
    [(example, printed)] = EXAMPLES[title]
    run = subprocess.run(
        [sys.executable, "-c", example], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr
    # of rounding errors no more than their size is the same on all machines
    assert numbers(run.stdout) == pytest.approx(numbers(printed), rel=0.9)
    assert numbers(run.stdout)[-1] != pytest.approx(numbers(run.stdout)[-3], rel=0.05)


def test_the_timers_of_the_scheduler_are_still_there():
    """Each look at the jobs of snakemake's scheduler starts a timer, limit reached or not."""
    from snakemake.scheduling.job_scheduler import JobScheduler

    lines = inspect.getsource(JobScheduler.schedule).splitlines()
    calls = [n for n, line in enumerate(lines) if "_schedule_reevalutation" in line]
    assert "self.job_rate_limiter is not None" in "".join(lines[calls[-1] - 4 : calls[-1]])


def test_the_groups_of_xdist_are_told_by_a_private_attribute():
    import xdist.remote

    assert "._nodeid = " in Path(xdist.remote.__file__).read_text()
