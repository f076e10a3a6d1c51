"""What `stability` says of windows of strain: from the least on, several, what is unknown."""

from wrinklestudy.cli.sentences import stability_text
from wrinklestudy.cli.sheet_options import GivenSize
from wrinklestudy.equilibrium.stability import find

SURVEY = (0.001, 0.003, 0.01, 0.019, 0.021, 0.05, 0.1, 0.16, 0.24, 0.32, 0.4)
RATIOS = GivenSize(2.0, 1e-3)
LENGTHS = GivenSize(2.0, 1e-3, width_mm=100.0)


def said(curve, size=RATIOS):
    limits = find(curve, size.thickness, survey=SURVEY, origin=False)
    return " ".join(stability_text(vars(limits), size).split("\n\n")[0].split())


def falling(strain):
    """tau_1 of a sheared sheet: it wrinkles from the least strain on."""
    return 1.5e-3 - 2e-3 * strain


def test_a_sheet_that_wrinkles_from_the_least_strain_on_has_no_birth():
    text = said(falling)
    start = "The sheet wrinkles from strain 0.001, the least that was examined, to strain 0.25"
    assert text.startswith(start)
    assert "nothing is known" not in text


def test_lengths_are_said_with_strains():
    text = said(falling, LENGTHS)
    assert "from strain 0.001 (clamps 200.2 mm apart), the least that was examined, to" in text


def test_each_window_is_named():
    def curve(strain):
        early, late = 1.2 - 40.0 * strain, 1.5 - 60.0 * (strain - 0.12) ** 2
        return 1e-3 * (early if strain < 0.02 else late)

    text = said(curve)
    assert "from strain 0.001, the least that was examined, to strain 0.005 and from" in text


def test_strains_that_are_passed_over_have_a_reason():
    def curve(strain):
        if strain < 0.02:
            raise ArithmeticError("the sheet sags")
        return falling(strain)

    text = said(curve)
    assert text.endswith("Below strain 0.021 nothing is known: the sheet sags.")
