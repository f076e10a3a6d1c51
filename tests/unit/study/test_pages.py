"""Pages from templates: what a text from a config may do to them, and what stops them."""

from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jinja2 import UndefinedError

from wrinklestudy.study.pages import anchor, cell, code, markdown, number, render

HOSTILE = "<b>|`code`|[link](x) *it* _it_ $x$ ~~no~~ &amp; a\n# b"


@pytest.mark.parametrize(
    ("value", "form", "text"),
    [
        (1.0 / 3.0, ".6g", "0.333333"),
        (2.0, ".6g", "2"),
        (0.1234, ".2f", "0.12"),
        (float("nan"), ".6g", "no number"),
        (None, ".2f", "no number"),
    ],
)
def test_numbers(value, form, text):
    assert number(value, form) == text


def test_markdown_of_a_hostile_name_is_only_text():
    assert markdown(HOSTILE) == (
        r"\<b>\|\`code\`\|\[link\](x) \*it\* \_it\_ \$x\$ \~\~no\~\~ \&amp; a # b"
    )


@pytest.mark.parametrize(
    "text", ["W_act/W", "<= 1e-10", "E_s - E_a", "2 * (c10 + c01 l^2)", "A & B", "W ~ r^-0.6"]
)
def test_what_is_no_markdown_stays_as_it_is(text):
    assert markdown(text) == text


@given(st.text(alphabet="ab`| \n"))
def test_code_is_fenced_by_more_backticks_than_it_has(text):
    line = " ".join(text.split())
    shown = code(text)
    if not line:
        assert shown == "nothing"
        return
    fence = shown[: len(shown) - len(shown.lstrip("`"))]
    assert fence not in line
    assert shown == (f"{fence} {line} {fence}" if "`" in line else f"`{line}`")


@given(rows=st.lists(st.lists(st.text(), min_size=2, max_size=2), max_size=4))
def test_any_text_stays_in_its_cell(rows, tables):
    lines = render("table.md.j2", tables, columns=("a", "b"), rows=rows).splitlines()
    assert len(lines) == len(rows) + 2
    for line in lines:
        assert line.replace("\\\\", "").replace("\\|", "").count("|") == 3


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    """Folder with one template for each kind of page: a table."""
    folder = tmp_path_factory.mktemp("templates")
    for kind in ("md", "html"):
        text = f'{{% from "macros.{kind}.j2" import table %}}\n{{{{ table(columns, rows) }}}}'
        (folder / f"table.{kind}.j2").write_text(text)
    return folder


class Cells(HTMLParser):
    """Collects the texts of the cells and every tag."""

    def __init__(self):
        super().__init__()
        self.tags, self.texts = [], []

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, attrs))

    def handle_data(self, data):
        if data.strip():
            self.texts.append(data)


def test_html_escapes_what_it_is_given(tables):
    parser = Cells()
    parser.feed(render("table.html.j2", tables, columns=["a"], rows=[[HOSTILE]]))
    assert parser.texts == ["a", HOSTILE]
    assert "b" not in [tag for tag, _ in parser.tags]


def test_numbers_in_cells_are_written_like_all_numbers():
    assert [cell(value) for value in (1.23456789, float("nan"), None, 7, "a|b")] == [
        "1.23457",
        "no number",
        "no number",
        "7",
        r"a\|b",
    ]


def test_a_value_that_is_missing_stops_the_page(tables):
    with pytest.raises(UndefinedError, match="rows"):
        render("table.md.j2", tables, columns=["a"])


def test_headings_are_linked_as_github_does():
    assert anchor("Corner of clamp, and `free` edge") == "corner-of-clamp-and-free-edge"
