"""`make docs`: the site is built without a warning and needs no network."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from wrinklestudy.cli.parser import COMMANDS

pytest.importorskip("sphinx", reason="the extra docs is not installed")

pytestmark = pytest.mark.workflow

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The folder of the site."""
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "sphinx", "--fail-on-warning", "--keep-going", "--quiet"]
    run = subprocess.run(
        [*command, str(DOCS), str(folder)],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT / "src")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return folder


def page(site, name):
    return (site / f"{name}.html").read_text(encoding="utf-8")


def test_every_source_is_a_page(site):
    sources = [
        path.relative_to(DOCS) for path in DOCS.rglob("*") if path.suffix in (".md", ".ipynb")
    ]
    assert len(sources) > 25
    assert [path for path in sources if not (site / path.with_suffix(".html")).exists()] == []


def test_no_page_loads_anything_from_the_network(site):
    loads = re.compile(r"""<(?:script|img|link|iframe)[^>]+(?:src|href)=["'](?:https?:)?//""")
    pages = list(site.rglob("*.html"))
    assert [path.name for path in pages if loads.search(path.read_text(encoding="utf-8"))] == []


def test_equations_are_drawn_by_the_browser(site):
    text = page(site, "model")
    assert text.count('<math xmlns="http://www.w3.org/1998/Math/MathML"') > 40
    assert "$" not in re.sub(
        r"<[^>]*>", "", text.partition("<article")[2].partition("</article")[0]
    )


def test_the_reference_has_every_command_key_and_name(site):
    commands, keys = page(site, "reference/command_line"), page(site, "reference/config")
    assert all(f'id="wrinklestudy-{name}"' in commands for name in COMMANDS)
    assert "--clamp-mm" in commands
    schema = json.loads((ROOT / "config" / "schema.json").read_text(encoding="utf-8"))
    blocks = [schema, *schema["$defs"].values()]
    named = [key for block in blocks for key in block["properties"]]
    assert [key for key in named if f'<span class="pre">{key}</span>' not in keys] == []
    import wrinklestudy

    library = page(site, "reference/library")
    assert [
        name for name in wrinklestudy.__all__ if f'id="wrinklestudy.{name}"' not in library
    ] == []


def test_search_finds_words_of_all_kinds_of_pages(site):
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    for stem in ("confin", "treloar", "slurm", "isogeometr"):
        assert re.search(rf'[{{,]"?{stem}"?:', index), stem
