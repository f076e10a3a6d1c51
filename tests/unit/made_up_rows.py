"""Made-up rows of the tables, for the tests that read and write them."""

from wrinklestudy.results.rows import StabilityRow, StateRow, columns, make_row

SHEET = {
    "material": "latex",
    "law": "mooney-rivlin",
    "bending": "thinning",
    "parity": "antisymmetric",
    "aspect": 2.0,
    "thickness": 1e-3,
}


def state_row(strain, status="wrinkled", **values):
    """Return a state of the sheet `SHEET`, with no number for what is not given."""
    known = {"young_modulus_pa": 1e6, "newton_iterations": 7, "cells_along": 6, "cells_across": 12}
    row = dict.fromkeys(columns(StateRow)) | SHEET | known | {"reason": ""}
    return make_row(StateRow, row | {"strain": strain, "status": status} | values, "test", "row")


def limits_row(birth=0.02, decay=0.42, **values):
    """Return where the sheet `SHEET` is unstable."""
    ends = {"birth_strain": birth, "decay_strain": decay}
    highest = {"max_critical_thickness": 2e-3, "strain_at_max": 0.1}
    return make_row(StabilityRow, SHEET | ends | highest | values, "test", "row")
