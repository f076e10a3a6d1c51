"""Imperfect sheets: their names are those of files, and tell one from another."""

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.results.cases import StudySheet
from wrinklestudy.results.imperfect_sheets import (
    IMPERFECTION_PATTERN,
    ImperfectSheet,
    check_imperfect,
    imperfections_of,
    repeated_names,
)

SHEET = StudySheet("latex", 2.0, 1e-3)
WEIGHT = (("density", 950.0), ("gravity", 9.81), ("width_mm", 140.0))
ACROSS = ("thickness_ripple", (0.01, 0.06, 1.5, 0.0))


@pytest.mark.parametrize(
    ("entries", "name", "kind", "size"),
    [
        ((), "perfect", "perfect", 0.0),
        ((("shear", 0.01),), "shear-0.01", "shear", 0.01),
        ((("twist", -0.03),), "twist-minus0.03", "twist", -0.03),
        ((ACROSS,), "thickness-ripple-0.01x0.06x1.5x0", "thickness-ripple 0.06 1.5 0", 0.01),
        (WEIGHT, "density-950_gravity-9.81_width-mm-140", "density", 950.0),
        ((("shear", 0.01), ("twist", 0.02)), "shear-0.01_twist-0.02", "combined", None),
        ((("thickness_table", "my data/Sheet 3.csv"),), "thickness-table-sheet.3", None, None),
    ],
)
def test_a_name_says_what_is_wrong_and_how_much(entries, name, kind, size):
    sheet = ImperfectSheet(SHEET, "whole", entries)
    assert sheet.name == name
    assert re.fullmatch(IMPERFECTION_PATTERN, name)
    assert sheet.kind == (kind or "thickness-table")
    assert sheet.size == size


def test_the_part_that_is_solved_is_in_the_name_unless_it_is_the_whole():
    assert ImperfectSheet(SHEET, "half").name == "perfect_half"


@given(st.floats(-0.5, 0.5), st.floats(-0.5, 0.5))
def test_sizes_have_one_name_each(first, second):
    one, other = (ImperfectSheet(SHEET, "whole", (("shear", value),)) for value in (first, second))
    assert re.fullmatch(IMPERFECTION_PATTERN, one.name)
    assert (one.name == other.name) == (f"{first:.12g}" == f"{second:.12g}") or 0.0 in (
        first,
        second,
    )


def test_two_tables_of_one_stem_are_found():
    tables = [
        ImperfectSheet(SHEET, "whole", (("thickness_table", f"{folder}/a.csv"),))
        for folder in ("x", "y")
    ]
    assert repeated_names(tables) == ["thickness-table-a"]
    assert repeated_names([tables[0], tables[0]]) == []


def test_the_library_gets_what_the_config_says():
    entries = {"shear": 0.01, "lift": 0.02, "thickness_along": 0.1, ACROSS[0]: ACROSS[1]}
    found = imperfections_of(entries | dict(WEIGHT), 4e5)
    assert (found.clamps.shear, found.clamps.lift, found.clamps.twist) == (0.01, 0.02, 0.0)
    assert (found.thickness.along, found.thickness.across) == (0.1, 0.0)
    assert found.thickness.ripples[0].wavelength == 0.06
    assert found.weight == pytest.approx(950 * 9.81 * 0.14 / 4e5)


@pytest.mark.parametrize(
    ("symmetry", "entry", "fault"),
    [
        ("half", ("shear", 0.01), "need 'whole'"),
        ("half-width", ("thickness_across", 0.1), "must be 'whole'"),
        ("quarter", WEIGHT, "needs 'half' or 'whole'"),
    ],
)
def test_a_part_that_does_not_tell_the_whole_is_refused(symmetry, entry, fault):
    entries = entry if isinstance(entry[0], tuple) else (entry,)
    with pytest.raises(ValueError, match=fault):
        check_imperfect(ImperfectSheet(SHEET, symmetry, entries))
    check_imperfect(ImperfectSheet(SHEET, "whole", entries))
