"""The page as a file: one, whole, marked, with every text escaped."""

import json
import re
from dataclasses import replace

import pytest

from wrinklestudy.explorer import page as page_module
from wrinklestudy.explorer.page import is_page, page, write_page


@pytest.fixture(scope="module")
def text(content):
    return page(content)


def embedded(text):
    """Return the numbers that a page holds."""
    found = re.search(r'<script type="application/json" id="numbers">(.*?)</script>', text)
    return json.loads(found[1])


def test_the_numbers_are_those_of_the_tables_with_all_their_digits(text, content):
    for given, shown in zip(embedded(text)["sheets"], content.sheets, strict=True):
        assert given["thickness"] == shown.sheet.thickness
        for name in ("strain", "amplitude_over_thickness", "phi_squared", "reason", "status"):
            assert given["states"][name] == [getattr(row, name) for row in shown.sheet.states]
        holes = [status == "not-converged" for status in given["states"]["status"]]
        assert [shape is None for shape in given["shapes"]] == holes


def test_the_same_content_gives_the_same_bytes(text, content):
    assert page(content) == text


def test_nothing_is_loaded_from_elsewhere(text):
    start, _, rest = text.partition("/**\n* plotly.js")
    end = rest.rpartition("</script>\n<script>")[2]
    for part in (start, end):
        assert not re.findall(r"""(?:src|href)=["']|url\(|@import|https?:""", part)
    assert "default-src 'none'" in start


def test_names_are_escaped_and_end_no_script(hostile):
    text = page(hostile)
    assert "<img src=x" not in text
    assert "<script>hacked" not in text
    assert embedded(text)["sheets"][0]["material"] == hostile.sheets[0].material
    assert "Title &lt;/script&gt;" in text


def test_a_page_is_told_from_other_files(tmp_path, content):
    ours, other = tmp_path / "ours.html", tmp_path / "other.html"
    write_page(content, ours)
    other.write_text("<html><title>mine</title></html>")
    assert is_page(ours)
    assert not is_page(other)
    assert ours.stat().st_size < 15_000_000


def test_what_is_too_large_is_refused_in_one_line(monkeypatch, content):
    monkeypatch.setattr(page_module, "MOST_BYTES", 1_000_000)
    with pytest.raises(ValueError, match=r"\d+ wrinkled states make a page of \d+ MB") as error:
        page(content)
    assert "\n" not in str(error.value)


def test_a_page_without_sheets_is_refused(content):
    with pytest.raises(ValueError, match="no sheet to show"):
        page(replace(content, sheets=[]))


def test_many_states_get_fewer_samples(monkeypatch, content, text):
    monkeypatch.setattr(page_module, "_FOR_HEIGHTS", 100_000)
    coarse = embedded(page(content))["sheets"][0]["shapes"][1]["height"][0]["shape"]
    fine = embedded(text)["sheets"][0]["shapes"][1]["height"][0]["shape"]
    assert coarse[0] * coarse[1] < fine[0] * fine[1]
