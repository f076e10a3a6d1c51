"""What the docs name is there."""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml

from wrinklestudy.results.paths import STAGES

ROOT = Path(__file__).parents[2]
PAGES = sorted([ROOT / "README.md", ROOT / "config" / "README.md", *(ROOT / "docs").rglob("*.md")])
PACKAGE = ROOT / "src" / "wrinklestudy"
ARCHITECTURE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_to_files(page):
    targets = re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text(encoding="utf-8"))
    local = [target for target in targets if "://" not in target]
    assert [target for target in local if not (page.parent / target).exists()] == []


def test_files_that_the_architecture_names_exist():
    named = re.findall(r"`([\w./]+(?:/|\.(?:py|md|smk|yaml|json|txt)))`", ARCHITECTURE)
    outside = ("results/", "figures/", "gate.json")  # what a study makes
    files = [name for name in named if not name.startswith(outside) or (PACKAGE / name).exists()]
    assert len(files) > 30
    assert [
        name for name in files if not ((ROOT / name).exists() or (PACKAGE / name).exists())
    ] == []


def test_the_architecture_has_every_room_and_every_stage():
    rooms = re.findall(r"^\| `(\w+)(?:/|\.py)` \|", ARCHITECTURE, flags=re.MULTILINE)
    there = [path.stem for path in PACKAGE.iterdir() if path.suffix in ("", ".py")]
    assert sorted(rooms) == sorted(name for name in there if not name.startswith("__"))
    stages = re.findall(r"^\| (\w+) \| .* \|$", ARCHITECTURE, flags=re.MULTILINE)
    assert stages[: stages.index("gate") + 1][-len(STAGES) :] == list(STAGES)


@pytest.mark.parametrize("page", ["model", "why_different", "reference/library"])
def test_examples_of_a_page_run(page):
    text = (ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8")
    examples = re.findall(r"^```python\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)
    assert examples
    run = subprocess.run(
        [sys.executable, "-c", "\n".join(examples)], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr


def test_home_shows_the_example_of_the_readme():
    """A test of the README runs it."""
    home = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    pattern = re.compile(r"```python\n(.*?)```", flags=re.DOTALL)
    assert pattern.findall(home) == pattern.findall(readme)


def test_every_page_is_in_the_contents_of_the_site():
    home = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    trees = re.findall(r"```\{toctree\}\n(.*?)```", home, flags=re.DOTALL)
    listed = {line for tree in trees for line in tree.splitlines() if line[:1].isalpha()}
    sources = [*(ROOT / "docs").rglob("*.md"), *(ROOT / "docs").rglob("*.ipynb")]
    pages = {path.relative_to(ROOT / "docs").with_suffix("").as_posix() for path in sources}
    assert listed == pages - {"index"}


def test_what_the_catalog_of_workflows_shows_names_every_block_of_the_config():
    schema = json.loads((ROOT / "config" / "schema.json").read_text(encoding="utf-8"))
    page = (ROOT / "config" / "README.md").read_text(encoding="utf-8")
    assert [key for key in schema["properties"] if f"`{key}`" not in page] == []
    files = {path.name for path in (ROOT / "config").glob("*.yaml")}
    assert files <= set(re.findall(r"\]\(([\w.]+)\)", page))


def test_the_citation_is_of_this_version_and_of_the_paper():
    """The keys that CFF 1.2 requires, and those that the catalog of workflows reads."""
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert citation["cff-version"] == "1.2.0"
    assert citation["message"]
    assert citation["authors"]
    for key, name in (("title", "name"), ("version", "version"), ("license", "license")):
        assert citation[key] == project[name]
    (paper,) = citation["references"]
    assert (paper["volume"], paper["start"], paper["year"]) == (100, "053003", 2019)
    catalog = yaml.safe_load((ROOT / ".snakemake-workflow-catalog.yml").read_text(encoding="utf-8"))
    assert set(catalog["usage"]) == {"mandatory-flags", "software-stack-deployment", "report"}
