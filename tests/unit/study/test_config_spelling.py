"""What YAML reads without a word and a config must not have: each is a line with its place."""

import tempfile
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.study.config import ConfigError, load_config
from wrinklestudy.study.config.reading import read_study
from wrinklestudy.study.config.spelling import misleading

ROOT = Path(__file__).parents[3]
RAW = yaml.safe_load((ROOT / "config.yaml").read_text())


def test_what_yaml_would_lose_is_refused_in_each_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "one.yaml").write_text("a: {b: 1}\nc:\n  - d: 1\n    e: 2\n    'd': 3\n")
    (tmp_path / "two.yaml").write_text("mesh:\n  x: 010\n  y: [1_0, '1_0', 1e3, -.inf]\n")
    with pytest.raises(ConfigError) as caught:
        load_config(RAW, ["two.yaml", "one.yaml"])
    assert str(caught.value).splitlines() == [
        "two.yaml, line 2: mesh.x = 010: YAML reads 8; write plain digits",
        "two.yaml, line 3: mesh.y[0] = 1_0: YAML reads 10; write plain digits",
        "one.yaml, line 5: c[0].d stands twice, first in line 3",
    ]


def aliases(levels):
    """Nine times the list before, over and over: a few lines that mean billions of entries."""
    lines = ["a0: &a0 [1, 2]"]
    lines += [
        f"a{k}: &a{k} [{', '.join(f'*a{k - 1}' for _ in range(9))}]" for k in range(1, levels)
    ]
    return "\n".join(lines)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("mesh: &m {cells: *m}", r"line 1: mesh\.cells: contains itself, by an alias"),
        ("a: 1\nsheets: &s [1, *s]", r"line 2: sheets\[1\]: contains itself"),
        (aliases(9), r"line 1: has more than 100,000 entries"),
        ("a: " + "[" * 60 + "]" * 60, r"line 1: lists and blocks in each other, over 50 deep"),
        ("a: " + "[" * 5000 + "]" * 5000, r"has lists and blocks too deep in each other"),
        ("a: 2001-99-99", r"has a value that YAML cannot read \(month must be in 1..12"),
        ("a: !!int x", r"has a value that YAML cannot read"),
        ("a: \x07", r"is not YAML \(special characters are not allowed"),
    ],
)
def test_a_file_that_has_no_end_or_no_value_is_refused(tmp_path, monkeypatch, text, said):
    monkeypatch.chdir(tmp_path)
    Path("my.yaml").write_text(text)
    with pytest.raises(ConfigError, match=rf"^my\.yaml(, |: ){said}") as caught:
        read_study("my.yaml")
    assert "\n" not in str(caught.value)


@given(st.floats(allow_nan=False, allow_infinity=False) | st.integers())
def test_no_number_as_python_writes_it_is_misleading(value):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "c.yaml")
        path.write_text(f"key: {value!r}\n")
        assert misleading(str(path)) == []
