"""What a sheet reaches over strain is that of the curve, not of its samples."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st
from made_up_rows import limits_row, state_row

from wrinklestudy.results.peaks import sheet_row

BIRTH, DECAY = 0.02, 0.42


def wrinkled_at(strain, amplitude=0.0, status="wrinkled"):
    wavelength = 0.2 - 0.1 * strain if status == "wrinkled" else None
    return state_row(
        strain,
        status,
        amplitude_over_thickness=amplitude,
        phi_squared=1e-4 * amplitude**2,
        wavelength_over_width=wavelength,
    )


def pitchfork(strain):
    """(A/t)^2 = 900 (eps - birth)(decay - eps): supercritical at both ends, 6 at 0.22."""
    return math.sqrt(900.0 * max((strain - BIRTH) * (DECAY - strain), 0.0))


@given(st.lists(st.floats(0.03, 0.41), min_size=1, max_size=8, unique=True))
def test_the_peak_of_a_pitchfork_is_exact_wherever_its_samples_are(strains):
    strains = sorted({round(strain, 3) for strain in strains})
    row = sheet_row(limits_row(), [wrinkled_at(strain, pitchfork(strain)) for strain in strains])
    assert row.max_amplitude_over_thickness == pytest.approx(6.0, rel=1e-9)
    assert row.strain_at_max_amplitude == pytest.approx(0.22, abs=1e-9)
    assert row.max_phi_squared == pytest.approx(1e-4 * 36.0, rel=1e-9)
    assert row.strain_at_max_phi_squared == pytest.approx(0.22, abs=1e-9)


def test_wavelengths_are_those_of_the_wrinkled_states_only():
    states = [wrinkled_at(e, pitchfork(e)) for e in (0.1, 0.2, 0.3)]
    states += [wrinkled_at(0.01, 0.0, "flat"), wrinkled_at(0.4, math.nan, "not-converged")]
    row = sheet_row(limits_row(), states)
    assert row.wavelength_over_width_at_max_amplitude == pytest.approx(0.2 - 0.1 * 0.22)
    assert row.min_wavelength_over_width == pytest.approx(0.17)
    assert row.max_wavelength_over_width == pytest.approx(0.19)
    assert (row.wrinkled, row.flat, row.not_converged) == (3, 1, 1)
    assert (row.cells_along, row.cells_across) == (6, 12)


def test_a_sheet_that_never_wrinkles_has_a_peak_of_zero_and_no_place_for_it():
    row = sheet_row(limits_row(None, None), [wrinkled_at(e, 0.0, "flat") for e in (0.1, 0.2)])
    assert row.max_amplitude_over_thickness == row.max_phi_squared == 0.0
    assert row.strain_at_max_amplitude is None
    assert row.wavelength_over_width_at_max_amplitude is None


def test_wrinkles_between_two_strains_have_an_unknown_peak_and_not_a_flat_one():
    row = sheet_row(limits_row(0.11, 0.13), [wrinkled_at(e, 0.0, "flat") for e in (0.1, 0.2)])
    assert row.max_amplitude_over_thickness is None
    assert row.max_phi_squared is None


@pytest.mark.parametrize(("hole", "known"), [(0.05, True), (0.2, False), (0.25, False)])
def test_a_state_that_did_not_converge_beside_the_peak_leaves_it_unknown(hole, known):
    """The peak is at 0.22, between two of the samples."""
    states = [wrinkled_at(e, pitchfork(e)) for e in (0.05, 0.15, 0.2, 0.25, 0.3) if e != hole]
    row = sheet_row(limits_row(), [*states, wrinkled_at(hole, math.nan, "not-converged")])
    assert (row.max_amplitude_over_thickness is not None) == known
    assert (row.strain_at_max_phi_squared is not None) == known


def test_a_curve_that_still_rises_at_its_last_state_has_its_peak_there():
    row = sheet_row(
        limits_row(BIRTH, None), [wrinkled_at(e, pitchfork(e)) for e in (0.05, 0.1, 0.15)]
    )
    assert row.strain_at_max_amplitude == 0.15
    assert row.max_amplitude_over_thickness == pytest.approx(pitchfork(0.15))
