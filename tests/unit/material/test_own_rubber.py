"""A rubber has the same constants whatever the file that its test is written in."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rubber_files import C01, C10, FORMATS, STRETCH, lines, stress

from wrinklestudy.material.choice import Choice
from wrinklestudy.material.comparison import Unfitted, compare
from wrinklestudy.material.data import Measurement, read
from wrinklestudy.material.fit import fit
from wrinklestudy.material.homogeneous import MODES, nominal_stress
from wrinklestudy.material.remarks import ILL_CONDITIONED
from wrinklestudy.material.stability import stability
from wrinklestudy.material.uncertainty import stress_band
from wrinklestudy.mechanics.laws import mooney_rivlin, neo_hookean, ogden, yeoh
from wrinklestudy.results.materials import load_fit
from wrinklestudy.stages import material as stage

TRUTH = pytest.approx({"c10": C10, "c01": C01}, rel=1e-9)


@pytest.fixture
def written(tmp_path):
    def write(text, name="my.csv"):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.mark.parametrize("name", FORMATS)
def test_every_format_gives_the_constants_that_made_it(written, name):
    result = fit(written(FORMATS[name]), "mooney-rivlin")
    assert result.constants == TRUTH
    assert result.warnings == ()
    assert result.stretch_range == pytest.approx((1.0, 1.6))


@given(
    st.sampled_from(
        [("strain", 1.0, 1.0), ("stretch", 1.0, 0.0), ("strain_percent", 100.0, 100.0)]
    ),
    st.sampled_from([("stress_pa", 1.0), ("stress_kpa", 1e-3), ("stress_mpa", 1e-6)]),
    st.sampled_from([",", ";", "\t", " "]),
    st.booleans(),
    st.lists(st.tuples(st.floats(0.1, 9.0), st.floats(-1e7, 1e7)), min_size=1, max_size=6),
)
def test_units_and_signs_change_nothing(tmp_path_factory, along, pull, separator, comma, points):
    (name, factor, rest), (unit, scale) = along, pull
    stretch, values = np.array(points).T
    text = lines(
        f"{name}{separator}{unit}",
        stretch * factor - rest,
        values * scale,
        separator=separator,
        comma=comma and separator != ",",
    )
    path = tmp_path_factory.mktemp("rubber") / "my.csv"
    path.write_text(text)
    data = read(path)
    np.testing.assert_allclose(data.stretch, stretch, rtol=1e-13)
    np.testing.assert_allclose(data.stress, values, rtol=1e-13, atol=1e-300)


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("strain,stress_pa\n0,0\n12,1e5\n", ["line 3", "column strain", "<= 10", "strain_percent"]),
        ("stretch,stress_pa\n100,0\n150,1e5\n", ["line 2", "column stretch", "<= 11"]),
        ("strain,stress_pa\n0,1_12000\n", ["line 2", "column stress_pa", "'1_12000'"]),
        ("strain,stress\n0,1\n", ["line 1", "'stress' is unknown", "with its unit: stress_pa or"]),
        ("strain,stress_pa\n0,00,0,0\n0,02,25533,0\n", ["line 2", "semicolons"]),
        ("extension_mm,stress_pa\n0,0\n", ["'# gauge length: 80 mm' is missing", "extension_mm"]),
        ("strain,load_n\n0,0\n", ["'# width: 10 mm' is missing", "load_n needs the width"]),
        ("# width: 3\nstrain,load_n\n0,0\n", ["'# thickness: 1 mm' is missing"]),
        ("# width: 3 inch\nstrain,load_n\n0,0\n", ["line 1, width", "'inch'", "mm, cm, m, um"]),
        ("# width: -3 mm\nstrain,load_n\n0,0\n", ["line 1, width", "-3 mm must be >= 1e-6"]),
        ("# width: 1,250 mm\nstrain,load_n\n0,0\n", ["line 1, width", "is not a number"]),
        (
            "# gauge length: 0.064\nextension_mm,stress_pa\n6.4,0\n",
            ["line 3, column extension_mm", "strain of 100", "gauge length 0.064 mm"],
        ),
        ("force_n,stress_pa,strain\n0,0,0\n", ["line 1", "stress_pa and force_n exclude"]),
        ("strain,stress_pa,branch\n0,0,up\n", ["line 2, column branch", "loading, unloading"]),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_line(written, text, parts):
    with pytest.raises(ValueError, match=r"my\.csv") as caught:
        read(written(text))
    message = str(caught.value)
    assert "\n" not in message
    assert [part for part in parts if part not in message] == []


def cyclic(softer=0.8, cycles=1, named=False):
    """Loading and unloading; the second loading starts softer, as rubber does."""
    text = ["strain,stress_pa" + ",branch" * named]
    for cycle in range(cycles):
        for branch, path, part in (
            ("loading", STRETCH, 0.9**cycle),
            ("unloading", STRETCH[::-1], softer * 0.9**cycle),
        ):
            rows = zip((path - 1).tolist(), (part * stress(path)).tolist(), strict=True)
            text += [f"{e!r},{t!r}" + f",{branch}" * named for e, t in rows]
    return "\n".join(text) + "\n"


@pytest.mark.parametrize("named", [True, False])
def test_the_first_loading_is_fitted_and_the_others_are_counted(written, named):
    path = written(cyclic(0.8, 3, named))
    result = fit(path, "mooney-rivlin")
    assert result.constants == TRUTH
    loop = result.loops["uniaxial"]
    assert (loop.loading, loop.unloading, loop.cycles) == (93, 93, 3)
    # stresses of the unloading are 0.8 of those of the loading
    assert loop.hysteresis == pytest.approx(0.2, rel=1e-9)
    (warning,) = result.warnings
    assert "only the loading of cycle 1 is fitted" in warning
    assert "20.0% less" in warning
    back = fit(path, "mooney-rivlin", branch="unloading")
    assert back.constants == pytest.approx({"c10": 0.8 * C10, "c01": 0.8 * C01}, rel=1e-9)
    third = fit(path, "mooney-rivlin", cycle=3)
    assert third.constants == pytest.approx({"c10": 0.81 * C10, "c01": 0.81 * C01}, rel=1e-9)
    with pytest.raises(ValueError, match=r"my\.csv: has no loading in cycle 4 of the uniaxial"):
        fit(path, "mooney-rivlin", cycle=4)


def test_a_loop_that_was_sorted_by_strain_is_told(written):
    pairs = np.ravel(np.column_stack([stress(), 0.8 * stress()]))
    result = fit(written(lines("stretch,stress_pa", np.repeat(STRETCH, 2), pairs)), "mooney-rivlin")
    assert [w for w in result.warnings if w.startswith("mixed: uniaxial") and "20%" in w]
    twice = lines("stretch,stress_pa", np.tile(STRETCH, 2), np.tile(stress(), 2))
    assert fit(written(twice), "mooney-rivlin").warnings == ()


def branch_of(stretch, mode=None):
    stretch = np.array(stretch)
    text = lines("stretch,stress_pa", stretch, np.zeros(stretch.size))
    if mode is not None:
        rows = zip(stretch.tolist(), mode, strict=True)
        text = "stretch,stress_pa,mode\n" + "".join(f"{lam!r},0,{m}\n" for lam, m in rows)
    return text


@pytest.mark.parametrize(
    ("stretch", "unloading", "cycles"),
    [
        (np.linspace(0.6, 1.5, 10), 0, 1),  # from compression to tension in order
        (np.linspace(1.5, 1.0, 10), 0, 1),  # written backwards
        (np.tile(np.linspace(1.0, 1.5, 10), 3), 0, 1),  # three specimens
        (np.linspace(1, 1.5, 200) + 0.01 * (-1.0) ** np.arange(200), 0, 1),
        ([1.0, 1.3, 1.1, 1.4, 1.2, 1.5, 1.05], 0, 1),  # in no order
        ([*np.linspace(1, 1.5, 9), *np.linspace(1.5, 1, 9)], 9, 1),  # peak written twice
        ([*np.linspace(1, 1.5, 9), 1.5, 1.5, 1.5, *np.linspace(1.4, 1.1, 5)], 8, 1),  # held
        ([*np.linspace(1, 0.6, 9), *np.linspace(0.65, 1, 9)], 9, 1),  # compression
        # pulled, pushed and back: the way back to rest is unloading on either side
        ([*np.linspace(1, 1.5, 9), *np.linspace(1.4, 0.6, 9), *np.linspace(0.7, 0.95, 6)], 10, 2),
    ],
)
def test_the_turn_tells_loading_from_unloading(written, stretch, unloading, cycles):
    data = read(written(branch_of(stretch)))
    assert int(np.sum(data.branch == "unloading")) == unloading
    assert data.cycle.max() == cycles


def test_the_modes_of_a_file_turn_on_their_own(written):
    loop = [*np.linspace(1, 1.5, 6), *np.linspace(1.4, 1, 5)]
    modes = ["uniaxial", "shear"] * 11
    data = read(written(branch_of(np.repeat(loop, 2), modes)))
    for mode in ("uniaxial", "shear"):
        assert (data.branch[data.mode == mode] == "unloading").tolist() == [False] * 6 + [True] * 5


@pytest.mark.parametrize("offset", [6e3, -2.5e4])
# with and without a point at rest; few points
@pytest.mark.parametrize("taken", [slice(0, None), slice(1, None), slice(0, None, 5)])
def test_a_preload_is_told_and_removed(written, offset, taken):
    path = written(lines("stretch,stress_pa", STRETCH[taken], stress()[taken] + offset))
    kept = fit(path, "mooney-rivlin")
    assert abs(kept.constants["c10"] / C10 - 1.0) > 0.1
    (warning,) = [text for text in kept.warnings if text.startswith("preload")]
    assert f"{offset:.4g}" in warning
    assert "--remove-preload" in warning
    result = fit(path, "mooney-rivlin", preload="remove")
    assert result.constants == TRUTH
    assert result.offsets["uniaxial"].stress_pa == pytest.approx(offset, rel=1e-9)
    assert result.warnings == ()


@pytest.mark.parametrize("made", [yeoh(1.8e5, -1.5e3, 40.0), ogden(6.3e5, 1.3, -1e4, -2.0)])
@pytest.mark.parametrize("mode", MODES)
def test_the_extrapolation_to_rest_suits_other_laws(made, mode):
    """Two terms in the strain are free; the third is that of Mooney-Rivlin within a part of it."""
    pull = nominal_stress(made, STRETCH, mode)
    at_rest = pull[STRETCH <= 1.25].max()
    modes = np.full(STRETCH.size, mode)
    data = Measurement(STRETCH, pull + 1e4, modes)
    found = fit(data, "neo-hookean", preload="remove").offsets[mode].stress_pa
    assert found == pytest.approx(1e4, abs=0.003 * at_rest)
    silent = fit(Measurement(STRETCH, pull, modes), "neo-hookean")
    assert not silent.offsets[mode].told


def test_noise_alone_is_no_preload():
    rng = np.random.default_rng(3)
    told = 0
    for noise in 2e3 * rng.standard_normal((200, STRETCH.size)):
        data = Measurement(STRETCH, stress() + noise, np.full(STRETCH.size, "uniaxial"))
        told += fit(data, "neo-hookean").offsets["uniaxial"].told
    assert told <= 2


def test_a_preload_without_small_strains_cannot_be_removed():
    stretch = np.linspace(1.72, 1.9, 9)
    data = Measurement(stretch, stress(stretch), np.full(9, "uniaxial"), source="far.csv")
    with pytest.raises(ValueError, match=r"far\.csv: a preload of the uniaxial test cannot be"):
        fit(data, "mooney-rivlin", preload="remove")


@pytest.mark.parametrize("preload", ["keep", "remove"])
def test_errors_and_bands_cover_the_truth(preload):
    """About 95 % of 400 repeated tests, for constants and curve, whether or not an offset is known.

    400 trials of 95 % scatter by 1.1 %.
    """
    rng = np.random.default_rng(11)
    offset = 0.0 if preload == "keep" else 1.5e4
    at = np.array([1.1, 1.3, 1.6])
    true = stress(at)
    inside = np.zeros(3)
    predicted, found = [], []
    for noise in 1.5e3 * rng.standard_normal((400, STRETCH.size)):
        data = Measurement(STRETCH, stress() + offset + noise, np.full(STRETCH.size, "uniaxial"))
        result = fit(data, "mooney-rivlin", preload=preload)
        curve, half = stress_band(result, at, "uniaxial")
        inside += np.abs(curve - true) <= half
        predicted.append(result.covariance)
        found.append(list(result.constants.values()))
    assert (np.abs(inside / 400 - 0.95) < 0.035).all()
    spread = np.cov(np.array(found), rowvar=False)
    np.testing.assert_allclose(np.mean(predicted, axis=0), spread, rtol=0.25)


def test_stated_errors_go_into_the_covariance_with_a_preload():
    error = np.linspace(1e3, 3e3, STRETCH.size)
    modes = np.full(STRETCH.size, "uniaxial")
    data = Measurement(STRETCH, stress() + 2e4, modes, error)
    result = fit(data, "mooney-rivlin", preload="remove")
    rng = np.random.default_rng(5)
    found = []
    for noise in error * rng.standard_normal((400, STRETCH.size)):
        again = Measurement(STRETCH, data.stress + noise, modes, error)
        found.append(list(fit(again, "mooney-rivlin", preload="remove").constants.values()))
    spread = np.cov(np.array(found), rowvar=False)
    np.testing.assert_allclose(result.covariance, spread, rtol=0.25)


def test_five_per_cent_written_as_strain_is_told_by_its_straight_curve(written):
    strain = np.linspace(0.0, 0.05, 11)
    (text,) = (
        warning
        for warning in fit(
            written(lines("strain,stress_pa", 100 * strain, stress(1 + strain))), "mooney-rivlin"
        ).warnings
        if "strain_percent" in warning
    )
    assert text.startswith("strain: the uniaxial stress is proportional")
    # no rubber is taken for that, however far it is stretched
    far = np.linspace(1.0, 7.0, 40)
    for made in (neo_hookean(2e5), yeoh(1.8e5, -1.5e3, 40.0)):
        for mode in MODES:
            pull = nominal_stress(made, far, mode)
            data = Measurement(far, pull, np.full(far.size, mode))
            assert not [w for w in fit(data, "neo-hookean").warnings if w.startswith("strain")]


def test_pascals_that_are_megapascals_are_told_by_the_modulus():
    data = Measurement(STRETCH, 1e-6 * stress(), np.full(STRETCH.size, "uniaxial"))
    assert "check the units" in fit(data, "mooney-rivlin").warnings[0]


def test_a_slipped_digit_is_named_by_its_line(written):
    values = stress()
    values[12] = -9999.0
    path = written(lines("stretch,stress_pa", STRETCH, values, above=["# batch 7"]))
    warnings = fit(path, "mooney-rivlin").warnings
    assert "outliers: line 15 of my.csv, up to" in " ".join(warnings)


def test_what_the_data_cannot_tell_is_said():
    narrow = np.linspace(1.0, 1.1, 11)
    data = Measurement(narrow, stress(narrow), np.full(11, "uniaxial"))
    result = fit(data, "mooney-rivlin")
    assert result.condition_number > ILL_CONDITIONED
    assert [w for w in result.warnings if w.startswith("ill-conditioned")]
    stiff = Measurement(STRETCH, 1e5 * (STRETCH**2 - 1 / STRETCH), np.full(31, "uniaxial"))
    result = fit(stiff, "mooney-rivlin")
    assert result.at_bound == ("c01",)
    assert [w for w in result.warnings if w.startswith("at bound: c01")]


def test_a_law_is_stable_where_the_stress_rises_in_every_mode():
    assert stability(mooney_rivlin(C10, C01), (1.0, 4.0)).stable
    # I1 - 3 = lambda^2 + 2/lambda - 3: the slope c10 + 2 c20 x changes sign, first where the
    # stretch of both sides makes x largest
    made = yeoh(1e5, -1.5e4, 0.0)
    found = stability(made, (1.0, 2.2))
    assert not found.stable
    assert list(found.lost_at) == ["uniaxial", "biaxial", "shear"]
    assert found.lost_at["biaxial"] < found.lost_at["shear"] < found.lost_at["uniaxial"]
    at = found.lost_at["shear"]
    before, after = (nominal_stress(made, at + step, "shear") for step in (-0.02, 0.02))
    top = nominal_stress(made, at, "shear")
    assert top > max(before, after)


def test_the_fit_of_an_unstable_law_says_so():
    made = yeoh(1e5, -1.5e4, 0.0)
    stretch = np.linspace(1.0, 1.6, 20)
    data = Measurement(stretch, nominal_stress(made, stretch), np.full(20, "uniaxial"))
    result = fit(data, "yeoh")
    assert not result.as_dict()["stable"]
    assert [w for w in result.warnings if w.startswith("unstable: stress does not rise in biaxial")]


def test_the_law_that_made_the_data_is_the_best_of_all():
    rng = np.random.default_rng(2)
    modes = np.repeat(MODES, 20)
    stretch = np.tile(np.linspace(1.05, 2.5, 20), 3)
    made = nominal_stress(mooney_rivlin(1.2e5, 6e4), stretch, modes)
    data = Measurement(stretch, made + 2e3 * rng.standard_normal(60), modes, source="made.csv")
    results = compare(data)
    assert results[0].law == "mooney-rivlin"  # Ogden is as close, with two constants more
    assert {result.law for result in results} == {
        *("mooney-rivlin", "neo-hookean", "svk", "yeoh", "ogden", "foppl-von-karman")
    }
    aicc = [result.aicc for result in results if not isinstance(result, Unfitted)]
    assert aicc[:-2] == sorted(aicc[:-2])
    assert np.isnan(aicc[-2:]).all()  # the small strains of svk and FvK are other points


def test_aicc_is_that_of_the_residuals():
    rng = np.random.default_rng(2)
    values = stress() + 1e3 * rng.standard_normal(31)
    data = Measurement(STRETCH, values, np.full(31, "uniaxial"))
    result = fit(data, "mooney-rivlin")
    misfit = nominal_stress(result.material(), STRETCH) - values
    expected = 31 * np.log(np.mean(misfit**2)) + 4 + 12 / 28
    assert result.aicc == pytest.approx(expected, rel=1e-12)


def test_a_law_that_cannot_be_fitted_says_why():
    shear = Measurement(STRETCH, stress(mode="shear"), np.full(31, "shear"), source="made.csv")
    reasons = {one.law: one.reason for one in compare(shear) if isinstance(one, Unfitted)}
    assert "cannot tell the constants" in reasons["mooney-rivlin"]
    with pytest.raises(ValueError, match=r"made\.csv: has no biaxial data"):
        compare(shear, Choice(modes=["biaxial"]))


def test_the_stage_takes_the_same_options_and_gives_every_bit_back(written, tmp_path):
    path = written(cyclic())
    options = {"branch": "unloading", "cycle": 1, "preload": "remove"}
    output = tmp_path / "my.json"
    stage.run("mooney-rivlin", "my", output, csv=path, **options)
    result = fit(path, "mooney-rivlin", **options)
    assert load_fit(output).as_dict() == result.as_dict()
    content = json.loads(output.read_text())
    assert content["branch"] == "unloading"
    assert content["warnings"] == list(result.warnings)
