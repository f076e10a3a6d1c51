"""What a sheet answers when it is asked for a number: that of its states, or that there is none."""

from dataclasses import replace

import numpy as np
import pytest
from made_up_rows import limits_row, state_row
from made_up_study import STRAIN, shape, sheet

from wrinklestudy.results.peaks import sheet_row
from wrinklestudy.results.sheets import MissingError, SheetStates


def sheet_of(limits, *states):
    return SheetStates(sheet_row(limits, states), states)


def test_nothing_is_interpolated_across_a_state_that_did_not_converge():
    one = sheet()
    assert one.at("phi_squared", 0.11) == pytest.approx(
        1.25e-3 * shape(0.11, 0.025, 0.06, 0.4), rel=1e-3
    )
    assert one.at("phi_squared", 0.45) == one.at("phi_squared", 0.005) == 0.0
    states = list(one.states)
    hole = list(STRAIN).index(0.12)
    states[hole] = replace(states[hole], status="not-converged")
    with pytest.raises(MissingError, match=r"phi_squared at strain 0.11 of latex"):
        replace(one, states=tuple(states)).at("phi_squared", 0.11)
    with pytest.raises(MissingError, match=r"wavelength_over_width at strain 0.5"):
        one.at("wavelength_over_width", 0.5)


def test_columns_are_those_of_the_states_that_have_all_the_numbers():
    one = sheet_of(
        limits_row(),
        state_row(0.1, "flat", phi_squared=0.0),
        state_row(0.2, phi_squared=1e-3, wavelength_over_width=0.1),
        state_row(0.3, phi_squared=2e-3),
        state_row(0.35, "not-converged"),
    )
    assert [list(values) for values in one.wrinkled("strain", "phi_squared")] == [
        [0.2, 0.3],
        [1e-3, 2e-3],
    ]
    assert list(one.wrinkled("strain", "wavelength_over_width")[0]) == [0.2]
    assert list(one.converged("strain")[0]) == [0.1, 0.2, 0.3]
    assert list(one.wrinkled_above(0.2)) == [False, False, True, False]
    with pytest.raises(MissingError, match="shape_constant in any wrinkled state of latex"):
        one.wrinkled("shape_constant")


@pytest.mark.parametrize(
    ("birth", "decay", "status", "wrinkles", "never", "end"),
    [
        (None, None, "flat", False, True, 0.0),
        (None, None, "not-converged", False, False, 0.0),
        (0.02, 0.4, "wrinkled", True, False, 0.4),
        (0.02, None, "wrinkled", True, False, np.inf),
        (0.12, 0.14, "flat", True, False, 0.14),
    ],
)
def test_whether_and_how_long_a_sheet_wrinkles(birth, decay, status, wrinkles, never, end):
    one = sheet_of(limits_row(birth, decay), state_row(0.1, status))
    assert (one.wrinkles, one.never_wrinkles, one.end) == (wrinkles, never, end)
    if birth is None or decay is None:
        with pytest.raises(MissingError, match="birth and decay strain"):
            one.limits()
    else:
        assert one.limits() == (birth, decay)


def test_a_peak_beside_a_hole_is_missing():
    one = sheet_of(
        limits_row(),
        state_row(0.1, amplitude_over_thickness=2.0),
        state_row(0.2, "not-converged"),
    )
    assert np.isnan(one.peak["max_amplitude_over_thickness"])
    with pytest.raises(MissingError, match="max_amplitude_over_thickness of latex"):
        one.peak_value("max_amplitude_over_thickness")
