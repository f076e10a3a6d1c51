"""How sheets come to the tension field, on numbers that are known."""

import numpy as np
import pandas as pd
import pytest
from made_up_study import STRAIN, sheet

from wrinklestudy.studies.beyond.thin_limit import Approach, approaches

THICKNESS = np.array([1e-4, 2e-4, 5e-4])


def test_a_deficit_at_first_order_has_exponent_one_and_is_extrapolated_to_the_field():
    field = 4e-3
    approach = Approach(0.1, THICKNESS, field * (1.0 - 800.0 * THICKNESS), field, 1e-6)
    assert approach.law.exponents["thickness"].value == pytest.approx(1.0, abs=1e-10)
    assert approach.extrapolated == pytest.approx(1.0, abs=1e-10)


def test_a_field_has_an_approach_where_three_sheets_of_its_rubber_and_length_are_wrinkled():
    sheets = [sheet(thickness=float(t)) for t in THICKNESS]
    like = sheets[0]
    rows = pd.DataFrame(
        {
            "material": like.material,
            "aspect": like.aspect,
            "strain": [STRAIN[1], 0.5 * (STRAIN[1] + STRAIN[2])],
            "status": "wrinkled",
            "phi_squared": 4e-3,
            "phi_squared_error": 1e-6,
        }
    )
    (approach,) = approaches(sheets, rows, like)
    assert approach.strain == STRAIN[1]
    assert list(approach.thickness) == list(THICKNESS)
    assert approaches(sheets[:2], rows, like) == []
    assert approaches(sheets, rows.assign(aspect=like.aspect + 1.0), like) == []
