"""What is fitted, carried through and inverted beyond the paper, on numbers that are known."""

from dataclasses import replace

import numpy as np
import pytest
from made_up_study import STRAIN, material, sheet, world

from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import mooney_rivlin, neo_hookean, saint_venant_kirchhoff
from wrinklestudy.results.sheets import MissingError
from wrinklestudy.studies.beyond import CATALOGUE, rubber
from wrinklestudy.studies.beyond.claims.scales import wavelength_law
from wrinklestudy.studies.beyond.lengths import lengths
from wrinklestudy.studies.beyond.power_law import line, power_law
from wrinklestudy.studies.beyond.rubber import Curves, curves, interval, sampled_shares, share
from wrinklestudy.studies.beyond.thresholds import by_mesh, largest_difference, threshold
from wrinklestudy.study.claims.discovery import load_claims

CLAIMS = load_claims("beyond")
NEVER = {"birth": np.nan, "decay": np.nan}


def envelope(length, share=1.0):
    """Columns of wrinkles of a length, half as much stretched as the sheet.

    In the middle they have a share of their largest height.
    """
    names = ("envelope_length_over_width", "deformed_envelope_length_over_width")
    lengths = dict(zip(names, (length, length * (1.0 + 0.5 * STRAIN)), strict=True))
    heights = {"amplitude_over_thickness": 3.0, "envelope_amplitude_over_thickness": 3.0 / share}
    return lengths | heights


def test_a_power_law_comes_back_without_an_error():
    rng = np.random.default_rng(1)
    a, b = rng.uniform(0.1, 3.0, 12), rng.uniform(1.0, 9.0, 12)
    found = power_law(0.7 * a**0.5 * b**-0.25, a=a, b=b)
    assert found.factor == pytest.approx(0.7, rel=1e-10)
    assert found.exponents["a"].value == pytest.approx(0.5, abs=1e-10)
    assert found.exponents["b"].value == pytest.approx(-0.25, abs=1e-10)
    assert max(found.exponents["a"].error, found.scatter) < 1e-10
    assert found.at(a=2.0, b=4.0) == pytest.approx(0.7 * 2.0**0.5 * 4.0**-0.25)


def test_groups_have_factors_of_their_own():
    base = np.geomspace(0.1, 1.0, 4)
    a, group = np.tile(base, 2), np.repeat([2.0, 3.0], 4)
    found = power_law(np.where(group == 2.0, 5.0, 0.2) * a**0.5, group, a=a)
    assert found.exponents["a"].value == pytest.approx(0.5, abs=1e-10)
    assert found.factor == pytest.approx(1.0)  # the geometric mean of 5 and 0.2


def test_the_interval_of_an_exponent_holds_the_truth_in_95_of_100_fits():
    """Student's t over repeated fits of six points with scatter: 2000 fits, 3 standard errors."""
    rng = np.random.default_rng(2)
    base = np.geomspace(0.01, 1.0, 6)
    scatter = rng.normal(0.0, 0.1, (2000, 6))
    covered = [power_law(base**0.5 * np.exp(s), a=base).exponents["a"].covers(0.5) for s in scatter]
    assert np.mean(covered) == pytest.approx(0.95, abs=3.0 * np.sqrt(0.95 * 0.05 / 2000))


def test_a_power_law_needs_more_numbers_than_unknowns():
    two, three = np.array([1.0, 3.0]), np.array([1.0, 2.0, 4.0])
    with pytest.raises(MissingError, match="exponents of a apart"):
        power_law(two, a=two)
    four = np.array([1.0, 2.0, 4.0, 9.0])
    with pytest.raises(MissingError, match="exponents of a, b apart"):
        power_law(four, a=four, b=four**2)
    with pytest.raises(MissingError, match="slope and offset"):
        line(three, np.ones(3))


def test_a_line_comes_back_without_an_error():
    base = np.array([2.0, 3.0, 5.0, 8.0])
    found = line(0.9 * base - 1.2, base)
    assert (found.slope.value, found.offset.value) == pytest.approx((0.9, -1.2))
    assert found.at(base) == pytest.approx(0.9 * base - 1.2)
    assert max(found.slope.error, found.offset.error, found.scatter) < 1e-10


def test_the_share_of_the_second_constant_tells_the_ratio_whatever_the_modulus():
    assert share(mooney_rivlin(1e5, 3e5)) == pytest.approx(0.75)
    assert share(mooney_rivlin(2.0, 6.0)) == pytest.approx(0.75)
    assert share(neo_hookean(1e5)) == 0.0
    assert float(rubber.ratio(0.75)) == pytest.approx(3.0)


def made_up_curves():
    """decay = 0.3 + 0.4 s - 0.3 s^2, which a cubic spline reproduces; top at s = 2/3."""
    shares = np.linspace(0.0, 0.9, 7)
    decay = 0.3 + 0.4 * shares - 0.3 * shares**2
    flat = np.full_like(shares, 0.02)
    return Curves(
        shares, {"birth strain": flat, "decay strain": decay, "largest A/t": 3.0 + shares}
    )


def test_an_interval_of_the_decay_strain_gives_all_the_ratios_that_agree():
    found = made_up_curves()
    top = found.shares_with("decay strain", 0.4, 1.0)
    exact = (2.0 / 3.0) + np.array([-1.0, 1.0]) * np.sqrt(4.0 / 9.0 - 1.0 / 3.0)
    assert top[[0, -1]] == pytest.approx([exact[0], 0.9], abs=1e-4)  # the other end lies beyond
    assert exact[1] > 0.9
    low = found.shares_with("decay strain", 0.33, 0.34)
    assert found.at("decay strain", low[[0, -1]]) == pytest.approx([0.33, 0.34], abs=1e-4)
    assert np.isnan(found.at("decay strain", 0.95))


def test_curves_go_through_the_sheets_in_the_order_of_their_ratios():
    rubbers = [mooney_rivlin(1.0, r) for r in (2.0, 0.0, 0.5, 5.0)]
    sheets = [sheet(decay=0.3 + 0.01 * k) for k in range(4)]
    found = curves(sheets, rubbers)
    assert found.shares == pytest.approx([0.0, 1 / 3, 2 / 3, 5 / 6])
    assert found.at("decay strain", found.shares) == pytest.approx([0.31, 0.32, 0.30, 0.33])
    with pytest.raises(MissingError, match="four ratios"):
        curves(sheets[:3], rubbers[:3])


def test_samples_have_the_spread_of_the_covariance():
    """For a small covariance the share s = b/(a + b) has the variance of its linear form."""
    mean, covariance = np.array([1e5, 1.1e5]), np.array([[1.0, -0.9], [-0.9, 1.5]]) * 1e6
    fit = Fit(
        *("mooney-rivlin", {"c10": mean[0], "c01": mean[1]}, covariance, (), 1.0, 9),
        *((1.0, 1.5), ("uniaxial",), 1.0, "made up", 1e5, 0.0),
    )
    samples = sampled_shares(fit)
    gradient = np.array([-mean[1], mean[0]]) / mean.sum() ** 2
    expected = np.sqrt(gradient @ covariance @ gradient)
    count = len(samples)
    assert samples.std() == pytest.approx(expected, rel=4.0 / np.sqrt(2 * count))
    known = interval(samples)
    assert known.high - known.low == pytest.approx(2 * 1.96 * expected, rel=0.03)
    assert known.covers(mean[1] / mean.sum())


def thin_sheet(scale=1.0, exponent=0.5):
    """A sheet whose critical thickness is scale eps^exponent below birth."""
    return sheet(birth=0.065, critical_thickness=scale * 5e-3 * STRAIN**exponent)


def test_the_birth_strain_is_read_off_the_critical_thickness():
    found = threshold(thin_sheet())
    assert found.strain == pytest.approx([0.02, 0.04, 0.06])  # below birth only
    law = found.law()
    assert law.exponents["thickness"].value == pytest.approx(2.0, abs=1e-9)
    assert float(law.at(thickness=1e-5)) == pytest.approx((1e-5 / 5e-3) ** 2)
    assert largest_difference(found, threshold(thin_sheet(1.003))) == pytest.approx(0.003)
    with pytest.raises(MissingError):
        found.law(up_to=0.03)


def test_meshes_are_compared_where_they_have_a_strain_in_common():
    thick, thin = thin_sheet(), sheet(thickness=5e-4, birth=0.045, critical_thickness=1e-3)
    without = sheet(thickness=2e-4, birth=0.01, critical_thickness=1e-3)
    assert [len(found.strain) for found in by_mesh([thin, without, thick])] == [3, 2]


def test_the_wavelength_has_the_exponents_that_its_sheets_were_made_with():
    """Those of Cerda and Mahadevan, which the made-up sheets follow without an excess."""
    sheets = [
        sheet(aspect=a, thickness=t, excess=0.0, **envelope(a / 2))
        for a in (2.0, 3.0)
        for t in (1e-3, 5e-4)
    ]
    found = lengths(sheets)
    assert found.against_theory == pytest.approx(1.0)
    law = wavelength_law(found, material=False)
    exponents = {name: exponent.value for name, exponent in law.exponents.items()}
    assert exponents == pytest.approx({"thickness": 0.5, "strain": -0.25})
    assert (found.material_wavelength > found.wavelength).all()  # the sheet narrows


RUBBERS = {"mr-000": 0.0, "mr-100": 1.0, "mr-200": 2.0, "mr-500": 5.0, "check-150": 1.5}
# linear in C01/(C10 + C01), through the 0.4 of the made-up sheet at 0.82
DECAYS = {name: 0.26 + 0.14 / 0.82 * r / (1.0 + r) for name, r in RUBBERS.items()}
POISSON = {"svk-00": 0.0, "svk-30": 0.3, "svk-50": 0.5}


def study(decays=(), length=lambda a: 0.6 * a, share=0.9, **base):
    """The made-up study of the paper with rubbers of other constants."""
    decays = DECAYS | dict(decays)
    sheets = [sheet(material=name, decay=decays[name], **base) for name in RUBBERS]
    sheets += [
        sheet(material=name, law="svk", critical=1e-3 + nu, **NEVER if nu == 0.0 else {})
        for name, nu in POISSON.items()
    ]
    sheets += [
        sheet(aspect=a, thickness=t, **envelope(length(a), share))
        for a, t in ((2.2, 1e-3), (2.6, 1e-3), (2.2, 5e-4), (3.2, 5e-4), (4.0, 5e-4))
    ]
    given = {name: mooney_rivlin(1e5, r * 1e5) for name, r in RUBBERS.items()}
    given |= {name: saint_venant_kirchhoff(1e6, nu) for name, nu in POISSON.items()}
    fits = [
        material("latex"),
        material("treloar-uniaxial", constants={"c10": 1.0e5, "c01": 1.1e5}, source="t.csv"),
        material("treloar", constants={"c10": 1.7e5, "c01": 0.2e5}, source="t.csv"),
    ]
    fits[1:] = [replace(m, fit=replace(m.fit, covariance=1e6 * np.eye(2))) for m in fits[1:]]
    made = world()
    return replace(made, sheets=(*made.sheets, *sheets), materials=tuple(fits), given=given)


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.key)
def test_each_claim_is_judged_or_says_what_is_missing(claim):
    finding = claim.finding(study())
    lacking = {"one-mesh-for-birth", "coordinates-of-the-wavelength"}
    lacking |= {"birth-as-the-square-of-thickness"}
    lacking |= {"compression-ends-or-lasts"}  # test_compression.py
    lacking |= {claim.key for claim in CLAIMS if claim.order[0] in (4, 8)}  # test_beyond_maps.py
    lacking |= {claim.key for claim in CLAIMS if claim.order[0] in (1, 2)}  # test_thin_limit.py
    assert (finding.verdict == "not computed") == (claim.key in lacking), finding.explanation
    assert finding.explanation


CASES = [
    ("later-decay-with-more-c01", {}, "agree"),
    ("later-decay-with-more-c01", {"decays": {"mr-500": 0.3}}, "disagree"),
    ("curves-hold-between", {}, "agree"),
    ("curves-hold-between", {"decays": {"check-150": 0.3}}, "disagree"),
    ("uniaxial-fit-is-enough", {}, "disagree"),  # the fits differ by more than their errors
    ("wrinkles-as-long-as-the-sheet", {}, "agree"),
    ("wrinkles-as-long-as-the-sheet", {"length": lambda a: a - 1.2}, "disagree"),
    ("wrinkles-end-before-the-clamps", {"length": lambda a: a - 1.2}, "agree"),
    ("wrinkles-from-end-to-end", {}, "agree"),
    ("wrinkles-from-end-to-end", {"share": 0.3}, "disagree"),
    ("wrinkles-end-before-the-clamps", {"share": 0.3}, "not computed"),  # two zones
    ("wrinkles-end-before-the-clamps", {"length": lambda a: a**0.5}, "disagree"),
    ("wrinkles-at-every-poisson-ratio", {}, "agree"),
]


@pytest.mark.parametrize(("key", "changes", "verdict"), CASES)
def test_a_verdict_follows_from_the_numbers(key, changes, verdict):
    (claim,) = (claim for claim in CLAIMS if claim.key == key)
    assert claim.finding(study(**changes)).verdict == verdict


def test_every_section_has_claims_and_every_figure_and_table_a_section():
    assert {claim.order[0] for claim in CLAIMS} <= {s.number for s in CATALOGUE.sections}
    for kind in ("figures", "tables"):
        shown = [name for section in CATALOGUE.sections for name in getattr(section, kind)]
        assert sorted(shown) == sorted(entry.name for entry in getattr(CATALOGUE, kind))
