"""One number has one text and one file, and a study is a set of cases."""

import math
import re

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from wrinklestudy.results import cases
from wrinklestudy.results.cases import Case, StudySheet, canonical, format_value, parse_value

positive = st.floats(min_value=1e-12, max_value=1e12)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.1 + 0.2, "0.3"),
        (1e-3, "0.001"),
        (1.25e-4, "0.000125"),
        (1 / 3, "0.333333333333"),
        (2.0, "2"),
        (100.0, "100"),
        (1e12, "1000000000000"),
        (-0.0, "0"),
    ],
)
def test_format_of_known_numbers(value, text):
    assert format_value(value) == text


@given(positive)
@example(0.1 + 0.2)
@example(9.999999999999999)
def test_text_and_number_round_trip(value):
    text = format_value(value)
    assert re.fullmatch(cases.VALUE_PATTERN, text)
    assert parse_value(text) == pytest.approx(value, rel=1e-11)
    assert format_value(parse_value(text)) == text


@given(st.integers(1, 10**6), st.integers(0, 9))
def test_a_decimal_that_a_user_writes_is_kept_exactly(digits, places):
    value = digits / 10**places
    assert parse_value(format_value(value)) == value


@given(positive, st.integers(-3, 3))
def test_rounding_noise_makes_no_second_file(value, steps):
    value = canonical(value)
    noisy = value
    for _ in range(abs(steps)):
        noisy = math.nextafter(noisy, math.copysign(math.inf, steps))
    assert format_value(noisy) == format_value(value)


@pytest.mark.parametrize("value", [-0.1, math.nan, math.inf])
def test_what_is_no_strain_has_no_text(value):
    with pytest.raises(ValueError, match="finite number >= 0"):
        format_value(value)


@pytest.mark.parametrize("text", ["0.10", "1e-3", ".5", "01", "-1", "1.", "nan", "", "1,5", " 1"])
def test_a_second_spelling_is_refused(text):
    with pytest.raises(ValueError, match="plain decimal"):
        parse_value(text)


@given(st.text(alphabet="0123456789.e-+", max_size=8))
def test_parsing_accepts_only_what_formatting_writes(text):
    try:
        value = parse_value(text)
    except ValueError:
        assume(False)
    assert format_value(value) == text


@given(st.integers(1, 500), st.integers(0, 60), st.integers(1, 100))
def test_a_range_has_exact_decimals_and_both_ends(first, count, width):
    start, step = first / 1000, width / 1000
    stop = (first + count * width) / 1000
    values = cases.strain_range(start, stop, step)
    assert values == tuple((first + k * width) / 1000 for k in range(count + 1))


@given(st.integers(1, 400), st.integers(1, 9), st.integers(2, 100), st.data())
def test_a_stop_between_two_values_is_refused_with_the_nearest_ones(first, count, width, data):
    """Of the two ends that are offered each is one, and a strain."""
    start, step = first / 1000, width / 1000
    low = first + count * width
    stop = (low + data.draw(st.integers(1, width - 1))) / 1000
    with pytest.raises(ValueError, match="whole number of steps") as caught:
        cases.strain_range(start, stop, step)
    offered = [float(text) for text in str(caught.value).rpartition(": ")[2].split(" or ") if text]
    assert offered == [end / 1000 for end in (low, low + width) if end <= 1000]
    for end in offered:
        assert cases.strain_range(start, end, step)[-1] == end


@pytest.mark.parametrize(("start", "stop", "step"), [(0.2, 0.1, 0.1), (0.1, 0.2, 0.0)])
def test_a_range_without_values_is_an_error(start, stop, step):
    with pytest.raises(ValueError, match="no values"):
        cases.strain_range(start, stop, step)


@pytest.mark.parametrize(
    ("thickness", "resolved"),
    [(1.6e-3, 1e-3), (1e-3, 1e-3), (9.9e-4, 5e-4), (7e-4, 5e-4), (5e-4, 5e-4), (1.25e-4, 1.25e-4)],
)
def test_design_thickness(thickness, resolved):
    assert cases.resolved_thickness(thickness) == resolved


@given(st.floats(min_value=1e-6, max_value=0.05))
def test_a_mesh_resolves_its_sheet_but_not_a_sheet_half_as_thick(thickness):
    resolved = cases.resolved_thickness(thickness)
    assert resolved <= thickness * (1 + 1e-8)
    assert resolved == 1e-3 or 2 * resolved > thickness * (1 - 1e-8)
    assert cases.resolved_thickness(resolved) == resolved


def test_a_thickness_must_be_positive():
    with pytest.raises(ValueError, match="must be > 0"):
        cases.resolved_thickness(0.0)


def test_cases_are_unique_and_sorted():
    series = [
        ("latex", [2.0], [1e-3], [0.3, 0.1]),
        ("latex", [2.0, 1.5], [1e-3], [0.1 + 0.2]),
    ]
    thin = StudySheet("latex", 2.0, 1e-3)
    short = StudySheet("latex", 1.5, 1e-3)
    assert cases.cases(series) == (Case(short, 0.3), Case(thin, 0.1), Case(thin, 0.3))
