"""Checks, page and gate of the verification: verdicts, what a reader sees, and loud failures."""

import ast
import importlib.util
import math
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from verification import gate, machine, page
from verification.checks import Check, Group, Table, read, write
from wrinklestudy.files.storage import write_json
from wrinklestudy.study.pages import anchor, markdown

ROOT = Path(__file__).parents[3]
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)


@pytest.mark.parametrize(
    ("check", "passed"),
    [
        (Check("", 1.01, 1.0, 0.02), True),
        (Check("", 1.03, 1.0, 0.02), False),
        (Check("", -1.01, -1.0, 0.02), True),
        (Check("", 1e-9, 0.0, 0.02), False),  # relative to zero: zero only
        (Check("", 0.5, 0.0, 0.5, "absolute"), True),
        (Check("", -0.6, 0.0, 0.5, "absolute"), False),
        (Check("", 1.0, 1.0, kind="at most"), True),
        (Check("", 1.1, 1.0, 9.0, kind="at most"), False),
        (Check("", 1.0, 1.0, kind="at least"), True),
        (Check("", 0.9, 1.0, 9.0, kind="at least"), False),
        (Check("", 1e-300, 0.0, kind="more than"), True),
        (Check("", 0.0, 0.0, kind="more than"), False),
    ],
)
def test_verdict(check, passed):
    assert check.passed is passed


@pytest.mark.parametrize("kind", ["relative", "absolute", "at most", "at least", "more than"])
@given(expected=NUMBERS)
def test_what_is_not_a_number_never_passes(kind, expected):
    assert not Check("", math.nan, expected, 1.0, kind).passed


@pytest.fixture
def groups(tmp_path):
    """Two groups on disk, the second with a check that fails."""
    good = Check("a | b", 1.0, 1.0, 1e-3, reason="it is so")
    bad = Check("energy", 2.5, 1.0, 1e-3)
    plots = [("good.png", "A plot")]
    table = Table("Numbers", ("x", "y"), [["one", 1.23456789], ["none", None]])
    write(Group("good", "Good group", "Some *text*.", [good], [table], plots), tmp_path / "g.json")
    write(Group("bad", "Bad group", "", [good, bad]), tmp_path / "b.json")
    (tmp_path / "good.png").write_bytes(b"picture")
    return [tmp_path / "g.json", tmp_path / "b.json"]


@pytest.fixture
def mutations(tmp_path):
    """Mutations of both groups; nothing has caught the second."""
    one = {"group": "good", "file": "plate.py", "what": "a sign", "old": "a +\n b", "new": "a - b"}
    rows = [one | {"caught_by": ["energy"]}, one | {"group": "bad", "caught_by": []}]
    write_json(tmp_path / "mutations.json", {"mutations": rows})
    return tmp_path / "mutations.json"


def test_a_group_keeps_its_verdicts(groups):
    assert [check["passed"] for check in read(groups[1])["checks"]] == [True, False]


def test_page_shows_texts_tables_verdicts_and_plots(groups, mutations, tmp_path):
    output = tmp_path / "docs" / "verification.md"
    page.run(groups, mutations, output)
    text = output.read_text()
    assert "| [Good group](#good-group) | 1 | 0 | 1 of 1 |" in text
    assert "| [Bad group](#bad-group) | 2 | 1 | 0 of 1 |" in text
    assert "Some *text*." in text
    assert "| one | 1.23457 |" in text
    assert "| none | no number |" in text
    assert "| a \\| b | 1 | 1 to 1.0e-03 of it | passed | it is so |" in text
    assert text.count("| FAILED |") == 2  # on top of its group and among all its checks
    assert "`a + b` became `a - b`): caught by energy." in text
    assert "**nothing caught it**" in text
    assert "![A plot](verification/good.png)" in text
    assert (tmp_path / "docs" / "verification" / "good.png").read_bytes() == b"picture"


def test_page_is_the_same_twice(groups, tmp_path):
    outputs = [tmp_path / name / "verification.md" for name in "ab"]
    for output in outputs:
        page.run(groups, None, output)
    assert outputs[0].read_bytes() == outputs[1].read_bytes()


@pytest.mark.parametrize("name", ["a <b>bold</b> check", "a `check` | *here*"])
def test_names_on_the_page_are_only_text(name, tmp_path):
    bad = Check(name, 2.0, 1.0, reason=name)
    write(Group("odd", name, "", [bad], [Table(name, (name,), [[name]])]), tmp_path / "odd.json")
    page.run([tmp_path / "odd.json"], None, tmp_path / "page.md")
    text = (tmp_path / "page.md").read_text()
    assert name not in text.replace(f"(#{anchor(name)})", "")
    # title, heading, title of the table, column, cell, and name and reason of the check twice
    assert text.count(markdown(name)) == 9


def test_the_page_says_where_it_ran(groups, tmp_path):
    versions = {"Python": "3.11.7"}
    noted = {"processor": "x86_64, A | B", "system": "Linux", "kernels": ["openblas 0.3 (Zen)"]}
    write_json(tmp_path / "m.json", noted | {"factorisation": "SuperLU", "versions": versions})
    page.run(groups, None, tmp_path / "page.md", tmp_path / "m.json")
    last = (tmp_path / "page.md").read_text().rstrip().splitlines()[-1]
    assert last == (
        "x86_64, A \\| B, Linux; BLAS: openblas 0.3 (Zen); sparse factorisation: `SuperLU`; "
        "Python 3.11.7."
    )


def test_the_model_of_the_processor_is_read_without_anything_that_names_the_machine(tmp_path):
    text = "processor\t: 0\nmodel name\t: AMD EPYC\nserial\t: 17\n\nprocessor\t: 1\n"
    (tmp_path / "cpuinfo").write_text(text)
    assert machine.processor(tmp_path / "cpuinfo") == "AMD EPYC"
    assert machine.processor(tmp_path / "nothing") == "model unknown"


def test_this_machine_has_a_blas_and_versions():
    facts = machine.facts()
    assert facts["kernels"]
    assert {"Python", "numpy", "scipy"} <= set(facts["versions"])


def test_gate_names_every_failure_on_its_line(groups, mutations, tmp_path):
    with pytest.raises(gate.VerificationError) as failure:
        gate.run(groups, tmp_path / "gate.json", mutations)
    assert str(failure.value).splitlines() == [
        "bad: energy is 2.5, must be 1 to 1.0e-03 of it",
        "bad: nothing caught the mutation of plate.py: a sign",
    ]
    assert not (tmp_path / "gate.json").exists()


def test_gate_opens_when_all_is_well(groups, tmp_path):
    gate.run(groups[:1], tmp_path / "gate.json")
    assert (tmp_path / "gate.json").exists()


def test_a_group_without_checks_or_without_mutations_is_a_failure(groups, mutations, tmp_path):
    empty = tmp_path / "e.json"
    write(Group("empty", "Empty", "", []), empty)
    with pytest.raises(gate.VerificationError) as failure:
        gate.run([groups[0], empty], tmp_path / "gate.json", mutations)
    assert "empty: has no checks" in str(failure.value)
    assert "empty: no mutation was tried" in str(failure.value)


def groups_of_the_workflow():
    """The list GROUPS of the Snakefile."""
    text = (ROOT / "verification" / "Snakefile").read_text()
    start = text.index("GROUPS = ")
    return ast.literal_eval(text[start + len("GROUPS = ") : text.index("]", start) + 1])


@pytest.mark.parametrize("name", groups_of_the_workflow())
def test_every_group_of_the_workflow_can_run(name):
    """The module is there and has what workflow and mutations call, without importing it."""
    spec = importlib.util.find_spec(f"verification.groups.{name}")
    assert spec is not None
    tree = ast.parse(Path(spec.origin).read_text())
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    assert {"run", "quick"} <= functions
