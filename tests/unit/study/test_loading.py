"""A study is found by its name or its path, and one that is wrong gets one line."""

import subprocess
import sys

import pytest

from wrinklestudy.stages.figures import run as draw_figure
from wrinklestudy.study.claims.discovery import load_claims
from wrinklestudy.study.digest import SOURCE, code_digest
from wrinklestudy.study.loading import (
    CatalogueError,
    built_in,
    claim_modules,
    load_catalogue,
    sources,
)

CATALOGUE = """from wrinklestudy.study.catalogue import Catalogue, FigureEntry

CATALOGUE = Catalogue(
    name="toy",
    title="Toy",
    figures=(FigureEntry(name="dot", title="dot", caption="A dot.", module=f"{__name__}.dot"),),
    claims=f"{__name__}.claims",
)
"""
CLAIM = """from wrinklestudy.study.claims.finding import Finding, claim


@claim(order=(1, 0, {number}), place="p. 1", statement="It is so.", tolerance="none")
def {name}(_study):
    return Finding("agree")
"""


@pytest.fixture
def toy(tmp_path, monkeypatch):
    """Write a study of one figure and three claims in the working directory."""
    monkeypatch.chdir(tmp_path)
    files = {
        "__init__.py": CATALOGUE,
        "dot.py": "def draw(inputs): ...\n",
        "claims/__init__.py": "",
        "claims/a.py": CLAIM.format(number=3, name="last"),
        "claims/b.py": "from .a import last\n" + CLAIM.format(number=1, name="first"),
        "claims/c.py": CLAIM.format(number=2, name="between"),
    }
    for name, text in files.items():
        path = tmp_path / "toy" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    yield tmp_path / "toy"
    for name in [name for name in sys.modules if name.split(".")[0] == "toy"]:
        del sys.modules[name]


def test_the_study_of_the_paper_comes_with_the_package():
    assert "panaitescu2019" in built_in()
    assert load_catalogue("panaitescu2019").name == "panaitescu2019"
    assert sources("panaitescu2019") == (SOURCE,)


@pytest.mark.parametrize("path", ["toy", "./toy/", "toy/__init__.py", "{folder}/toy"])
def test_a_folder_is_a_study_by_its_path(toy, path):
    catalogue = load_catalogue(path.format(folder=toy.parent))
    assert catalogue.figure_names == ("dot",)
    assert catalogue.figure("dot").module == "toy.dot"
    assert sources("toy") == (SOURCE, toy.parent)


def test_a_single_file_is_a_study_too(toy):
    own = toy.parent / "toy.py"
    text = CATALOGUE.replace('{__name__}.dot"', '{__name__}"').replace('.claims"', '"')
    own.write_text(f"{text}\n{CLAIM.format(number=1, name='so')}")
    assert load_catalogue("toy.py").figure("dot").module == "toy"
    assert [claim.key for claim in load_claims("toy.py")] == ["so"]


@pytest.mark.usefixtures("toy")
def test_claims_come_in_their_order_each_once_though_another_module_imports_it():
    assert claim_modules("toy") == ("toy.claims", "toy.claims.a", "toy.claims.b", "toy.claims.c")
    assert "toy.claims.a" not in sys.modules
    assert [claim.key for claim in load_claims("toy")] == ["first", "between", "last"]


def test_a_study_without_claims_has_none(toy):
    (toy / "__init__.py").write_text(CATALOGUE.replace('f"{__name__}.claims"', '""'))
    assert load_claims("toy") == ()


def test_two_claims_of_one_name_are_refused(toy):
    (toy / "claims" / "c.py").write_text(CLAIM.format(number=9, name="first"))
    with pytest.raises(
        CatalogueError, match=r"'first': stands in toy.claims.b and in toy.claims.c"
    ):
        load_claims("toy")


def test_the_digest_follows_the_files_of_the_user(toy):
    script = toy.parent / "script.py"
    script.write_text("pass\n")

    def digests():
        return [
            code_digest(script, [f"toy.{name}"], sources("toy")) for name in ("dot", "claims.b")
        ]

    before = digests()
    (toy / "dot.py").write_text("def draw(inputs): return 1\n")
    after = digests()
    assert (before[0] == after[0], before[1] == after[1]) == (False, True)
    path = toy / "claims" / "a.py"  # imported by b
    path.write_text(path.read_text().replace("agree", "disagree"))
    assert (digests()[0] == after[0], digests()[1] == after[1]) == (True, False)


def test_a_module_without_draw_is_told_before_anything_is_written(toy):
    (toy / "dot.py").write_text("def drawn(inputs): ...\n")
    with pytest.raises(
        ValueError, match=r"figure 'dot': module toy.dot must define draw\(inputs\)"
    ):
        draw_figure("toy", "dot", output="dot.pdf")
    assert not (toy.parent / "dot.pdf").exists()


@pytest.mark.parametrize(
    ("study", "message"),
    [
        (
            "panaitescu2091",
            r"study = 'panaitescu2091': must be one of beyond, imperfections, literature, pana",
        ),
        ("nowhere/toy.py", r"study = 'nowhere/toy.py': must be one of"),
        ("toy/claims/README.md", r"must be one of"),
        ("my-toy", r"study = 'my-toy': 'my-toy' must be a name that Python can import"),
        ("json", r"study = 'json': 'json' is the name of another package; take another"),
    ],
)
def test_what_is_no_study_gets_one_line(toy, study, message):
    for name in ("my-toy", "json"):
        (toy.parent / name).mkdir()
        (toy.parent / name / "__init__.py").write_text(CATALOGUE)
    with pytest.raises(CatalogueError, match=message) as caught:
        load_catalogue(study)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("CATALOGUE =", "CATALOG =", r"toy/__init__.py must define CATALOGUE, a wrinklestudy"),
        ("Catalogue(", "dict(", r"toy/__init__.py must define CATALOGUE"),
        ("Catalogue,", "Katalog,", r"toy/__init__.py, line 1: ImportError: cannot import name"),
        ('"Toy",', '"Toy"', r"toy/__init__.py, line 5: SyntaxError: "),
        ("title=", "titel=", r"toy/__init__.py, line \d: TypeError: .*titel"),
        ('"dot"', '"A Dot"', r"line 6: ValueError: figure 'A Dot': must be of lower-case letters"),
        (".dot", ".dots", r"study = 'toy': figure 'dot': there is no module 'toy.dots' in "),
        (".claims", ".claim", r"study = 'toy': claims: there is no module 'toy.claim' in "),
        (
            'name="dot", ',
            'name="dot", measured=("height",), ',
            r"figure 'dot': measured = 'height': allowed: stress, amplitude, wavelength, profiles",
        ),
        ("figures=(", "figures=2 * (", r"figure 'dot': is in the catalogue twice"),
    ],
)
def test_a_mistake_in_a_study_gets_one_line_that_says_where(toy, old, new, message):
    (toy / "__init__.py").write_text(CATALOGUE.replace(old, new, 1))
    with pytest.raises(CatalogueError, match=message) as caught:
        load_catalogue("toy")
    assert str(caught.value).startswith("study = 'toy': ")
    assert "\n" not in str(caught.value)


def test_a_mistake_in_a_module_that_the_study_imports_is_named_there(toy):
    (toy / "__init__.py").write_text("from . import dot\n" + CATALOGUE)
    (toy / "dot.py").write_text("\n\nimport no_such_package\n")
    with pytest.raises(CatalogueError, match=r"toy/dot.py, line 3: ModuleNotFoundError: No module"):
        load_catalogue("toy")


def test_planning_reads_the_catalogue_and_loads_nothing_heavy():
    code = (
        "import sys; from wrinklestudy.study.loading import load_catalogue, claim_modules;"
        "load_catalogue('panaitescu2019'); assert len(claim_modules('panaitescu2019')) > 9;"
        "print([m for m in ('matplotlib', 'numpy', 'pandas', 'pydantic') if m in sys.modules],"
        "[m for m in sys.modules if 'panaitescu2019.' in m])"
    )
    shown = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert shown.stdout.strip() == "[] ['wrinklestudy.studies.panaitescu2019.catalogue']"
