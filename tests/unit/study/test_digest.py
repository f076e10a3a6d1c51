"""The digest of a stage follows its code: all that it imports, and no more."""

import pytest

from wrinklestudy.results.paths import STAGES
from wrinklestudy.study.digest import SOURCE, code_digest, modules

FILES = {
    "__init__.py": '"""Sheets."""\nfrom wrinklestudy.api import solve\n',
    "api.py": "from wrinklestudy import planar, wrinkle\n\ndef solve(): pass\n",
    "planar.py": '"""Flat."""\nfrom wrinklestudy import plate\nfrom .fem import space\n\n'
    'def run():\n    """Solve."""\n    from wrinklestudy.store import write\n    return 1\n',
    "plate.py": "from wrinklestudy.laws import Law\n\ndef energy(x):\n    return x + 1\n",
    "laws.py": "Law = int\n",
    "store.py": "import json\n\ndef write(): pass\n",
    "wrinkle.py": "from wrinklestudy.planar import run\n",
    "material.py": "from typing import TYPE_CHECKING\n\nif TYPE_CHECKING:\n"
    "    from wrinklestudy.plate import energy\nelse:\n    from wrinklestudy.laws import Law\n",
    "fem/__init__.py": "from .element import Element\n",
    "fem/space.py": "from . import element\nfrom .. import store\n",
    "fem/element.py": "Element = float\n",
}


@pytest.fixture
def source(tmp_path):
    for name, text in FILES.items():
        path = tmp_path / "src" / "wrinklestudy" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    for stage in ("planar", "wrinkle", "material"):
        script = f"from wrinklestudy import {stage}\n\n{stage}.run()\n"
        (tmp_path / f"{stage}.py").write_text(script)
    return tmp_path


def digest(source, stage="planar", **options):
    return code_digest(source / f"{stage}.py", sources=[source / "src"], **options)


def edit(source, name, old, new):
    path = source / "src" / "wrinklestudy" / name
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def names(source, stage):
    found = modules(source / f"{stage}.py", sources=[source / "src"])
    return {name.removeprefix("wrinklestudy.") for name in found}


def test_imports_are_followed_in_functions_relative_and_through_modules(source):
    planar = {"planar", "plate", "laws", "store", "fem.space", "fem.element"}
    assert names(source, "planar") == planar
    assert names(source, "wrinkle") == planar | {"wrinkle"}


def test_imports_for_type_checkers_do_not_count(source):
    assert names(source, "material") == {"material", "laws"}


def test_the_package_itself_counts_only_where_something_is_taken_from_it(source):
    (source / "planar.py").write_text("from wrinklestudy import solve\n")
    assert "wrinklestudy" in names(source, "planar")
    assert "wrinkle" in names(source, "planar")


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("plate.py", "x + 1", "x + 2"),
        ("laws.py", "int", "float"),
        ("store.py", "pass", "return 1"),
        ("fem/element.py", "float", "int"),
    ],
)
def test_an_edit_changes_the_stages_that_import_it(source, name, old, new):
    before = [digest(source, stage) for stage in ("planar", "wrinkle")]
    edit(source, name, old, new)
    after = [digest(source, stage) for stage in ("planar", "wrinkle")]
    assert before[0] != after[0]
    assert before[1] != after[1]


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [("plate.py", "x + 1", "x + 2"), ("store.py", "pass", "return 1"), ("planar.py", "1", "2")],
)
def test_an_edit_leaves_the_stages_that_do_not_import_it(source, name, old, new):
    before = digest(source, "material")
    edit(source, name, old, new)
    assert digest(source, "material") == before


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"""Flat."""', '"""Flat state of a sheet."""\n\n# by hand'),
        ('"""Solve."""', "# solve"),
        ("return 1", "return (1)  # one"),
        ("\n\ndef", "\n\n\n\n\ndef"),
    ],
)
def test_comments_docstrings_and_layout_do_not_count(source, old, new):
    before = digest(source)
    edit(source, "planar.py", old, new)
    assert digest(source) == before


def test_the_script_counts_too(source):
    before = digest(source)
    script = source / "planar.py"
    script.write_text(f"# run the stage\n{script.read_text()}")
    assert digest(source) == before
    script.write_text(script.read_text().replace("run()", "run(2)"))
    assert digest(source) != before


def test_a_module_imported_by_a_computed_name_counts_where_it_is_named(source):
    before = digest(source, "material", also=["wrinklestudy.wrinkle"])
    edit(source, "store.py", "pass", "return 1")
    assert digest(source, "material", also=["wrinklestudy.wrinkle"]) != before


ADAPTER = SOURCE.parent / "workflow" / "scripts" / "stage.py"


def test_in_this_package_plate_counts_for_the_states_and_not_for_the_fit():
    for stage in ("planar", "stability", "wrinkle"):
        assert "wrinklestudy.mechanics.plate" in modules(ADAPTER, [f"wrinklestudy.stages.{stage}"])
    for stage in ("material", "mesh", "gate"):
        found = modules(ADAPTER, [f"wrinklestudy.stages.{stage}"])
        assert "wrinklestudy.mechanics.plate" not in found


def test_the_templates_of_a_package_count_where_it_is_imported(source):
    (source / "src/wrinklestudy/pages.py").write_text("from wrinklestudy import templates\n")
    folder = source / "src" / "wrinklestudy" / "templates"
    folder.mkdir()
    (folder / "__init__.py").write_text("")
    (folder / "page.html.j2").write_text("<p>{{ text }}</p>")
    (source / "claims.py").write_text("from wrinklestudy import pages\n")
    before = [digest(source, stage) for stage in ("claims", "planar")]
    (folder / "page.html.j2").write_text("<b>{{ text }}</b>")
    after = [digest(source, stage) for stage in ("claims", "planar")]
    assert before[0] != after[0]
    assert before[1] == after[1]


def test_the_table_beside_a_module_counts_with_it(source):
    (source / "src/wrinklestudy/solid.py").write_text("FILE = __file__\n")
    (source / "claims.py").write_text("from wrinklestudy import solid\n")
    before = [digest(source, stage) for stage in ("claims", "planar")]
    (source / "src/wrinklestudy/solid.csv").write_text("strain\n0.4\n")
    after = [digest(source, stage) for stage in ("claims", "planar")]
    assert before[0] != after[0]
    assert before[1] == after[1]


def test_code_may_lie_in_several_folders(source, tmp_path):
    beside = tmp_path / "beside" / "evidence"
    beside.mkdir(parents=True)
    (beside / "__init__.py").write_text("")
    (beside / "checks.py").write_text("from wrinklestudy.laws import Law\n")
    script = source / "evidence.py"
    script.write_text("from evidence import checks\n")
    sources = [source / "src", tmp_path / "beside"]
    assert set(modules(script, sources=sources)) == {"evidence.checks", "wrinklestudy.laws"}
    before = code_digest(script, sources=sources)
    (beside / "checks.py").write_text("from wrinklestudy.laws import Law\n\nBOUND = 1\n")
    assert code_digest(script, sources=sources) != before


@pytest.mark.parametrize("stage", STAGES)
def test_no_stage_imports_the_command_line_the_config_or_another_stage(stage):
    found = modules(ADAPTER, [f"wrinklestudy.stages.{stage}"])
    assert f"wrinklestudy.stages.{stage}" in found
    assert not [name for name in found if name.startswith("wrinklestudy.study.config.")]
    assert "wrinklestudy.cli" not in found
    assert not {f"wrinklestudy.stages.{other}" for other in STAGES if other != stage} & found.keys()
