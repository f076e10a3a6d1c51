"""Fits to exact, noisy, degenerate and measured data, and the material file."""

import json
import warnings
from pathlib import Path

import numpy as np
import pytest
from closed_forms import mooney_rivlin_basis
from hypothesis import given
from hypothesis import strategies as st

from wrinklestudy.material.data import Measurement, read
from wrinklestudy.material.fit import fit
from wrinklestudy.material.homogeneous import MODES, nominal_stress
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import (
    LAWS,
    Material,
    MooneyRivlin,
    SaintVenantKirchhoff,
    foppl_von_karman,
    law_of,
    mooney_rivlin,
    neo_hookean,
    ogden,
    saint_venant_kirchhoff,
    yeoh,
)
from wrinklestudy.results.materials import is_fit, load_fit, load_material
from wrinklestudy.stages import material

DATA = Path(__file__).parents[3] / "data"
LATEX = DATA / "latex_panaitescu2019.csv"
TRELOAR = DATA / "treloar1944.csv"
C10, C01 = 6.21e4, 1.58e5
# Laws that follow from Mooney-Rivlin or compare with its curve
SOFT = ("mooney-rivlin", "neo-hookean", "svk")


def _data(
    stretch: np.ndarray, stress: np.ndarray, mode: str = "uniaxial", error: float | None = None
) -> Measurement:
    errors = None if error is None else np.full(stretch.shape, error)
    return Measurement(stretch, stress, np.full(stretch.shape, mode), errors, "made.csv")


def _mooney(stretch: np.ndarray, c10: float, c01: float, mode: str = "uniaxial") -> np.ndarray:
    return mooney_rivlin_basis(stretch, mode) @ np.array([c10, c01])


def test_the_latex_curve_gives_the_published_constants() -> None:
    result = fit(LATEX, "mooney-rivlin")
    assert result.constants["c10"] == pytest.approx(C10, rel=1e-9)
    assert result.constants["c01"] == pytest.approx(C01, rel=1e-9)
    assert result.count == 51
    assert result.stretch_range == (1.0, 1.5)
    made = result.material()
    assert isinstance(made.law, MooneyRivlin)
    assert made.young_modulus == pytest.approx(6.0 * (C10 + C01), rel=1e-10)


def test_comparison_laws_of_the_latex_curve() -> None:
    # issue of the study: SVK to the initial slope, neo-Hookean over the whole curve
    svk = fit(LATEX, "svk").material()
    assert svk.young_modulus == pytest.approx(6.0 * (C10 + C01), rel=1e-9)
    assert isinstance(svk.law, SaintVenantKirchhoff)
    assert svk.law.poisson == 0.5
    data = read(LATEX)
    column = 2.0 * (data.stretch - data.stretch**-2)
    best = column @ data.stress / (column @ column)
    assert fit(LATEX, "neo-hookean").constants["c10"] == pytest.approx(best, rel=1e-12)
    # c10 lies between the value of the sum at strain 0 and its smaller one at strain 0.5
    assert C10 + C01 / 1.5 < best < C10 + C01


@pytest.mark.parametrize("law", ["mooney-rivlin", "neo-hookean"])
def test_exact_data_leave_a_tiny_positive_covariance_and_no_warning(law: str) -> None:
    stretch = np.linspace(1.0, 1.5, 9)
    c01 = C01 if law == "mooney-rivlin" else 0.0
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = fit(_data(stretch, _mooney(stretch, C10, c01)), law)
        content = result.as_dict()
    assert np.isfinite(result.covariance).all()
    assert np.isfinite(content["correlation"]).all()
    for name, error in result.standard_errors.items():
        assert 0.0 < error < 1e-10 * result.constants[name]
    assert np.linalg.eigvalsh(result.covariance).min() > 0.0


def test_treloar_uniaxial_alone_is_ill_conditioned_and_other_modes_cure_it() -> None:
    # literature values of this check (MPa): 0.102, 0.111 uniaxial; 0.168, 0.023 with all modes
    alone = fit(TRELOAR, "mooney-rivlin", stretch=(1.0, 1.65), modes=["uniaxial"])
    assert alone.constants == pytest.approx({"c10": 0.102e6, "c01": 0.111e6}, abs=0.5e3)
    together = fit(TRELOAR, "mooney-rivlin", stretch=(1.0, 1.65))
    assert together.constants == pytest.approx({"c10": 0.168e6, "c01": 0.023e6}, abs=0.5e3)
    assert together.modes == ("uniaxial", "biaxial", "shear")
    assert alone.condition_number > 3.0 * together.condition_number
    assert alone.correlation[0, 1] < -0.99 < together.correlation[0, 1]
    # neither fit may exceed the scatter of a rubber test by much: 2 to 4 % of 0.66 MPa
    assert alone.rms_pa < together.rms_pa < 0.03e6


def test_treloar_initial_slope_is_the_same_from_every_mode() -> None:
    # the three modes of one rubber must agree on Young's modulus within their scatter
    results = [fit(TRELOAR, "svk", modes=[mode]) for mode in ("uniaxial", "biaxial", "shear")]
    together = fit(TRELOAR, "svk")
    for result in results:
        gap = abs(result.constants["young"] - together.constants["young"])
        assert gap < 3.0 * np.hypot(
            result.standard_errors["young"], together.standard_errors["young"]
        )


@pytest.mark.parametrize("law", SOFT)
def test_covariance_is_the_spread_of_repeated_experiments(law: str) -> None:
    rng = np.random.default_rng(20191106)
    stretch = np.linspace(1.05, 1.5, 8)  # few points: the degrees of freedom matter
    truth = _mooney(stretch, C10, 0.0 if law == "neo-hookean" else C01)
    estimates, predicted = [], []
    for noise in 1.0e3 * rng.standard_normal((1500, stretch.size)):
        result = fit(_data(stretch, truth + noise), law, stretch=(1.0, 1.5))
        estimates.append(list(result.constants.values()))
        predicted.append(result.covariance)
        assert result.at_bound == ()
    spread = np.atleast_2d(np.cov(np.array(estimates), rowvar=False))
    # a variance from 1500 repeats is itself known to sqrt(2 / 1500) = 3.7 %
    np.testing.assert_allclose(np.mean(predicted, axis=0), spread, rtol=0.15)
    expected = {"young": 6.0 * (C10 + C01), "c10": C10, "c01": C01}
    error = np.sqrt(np.diag(spread) / 1500.0)
    wanted = [expected[name] for name in result.parameters]
    assert (np.abs(np.mean(estimates, axis=0) - wanted) < 4.0 * error).all()


def test_stated_errors_set_the_scale_of_the_covariance() -> None:
    stretch = np.linspace(1.0, 1.5, 11)
    stress = _mooney(stretch, C10, C01)
    plain = fit(_data(stretch, stress), "mooney-rivlin")
    one = fit(_data(stretch, stress, error=1e3), "mooney-rivlin")
    two = fit(_data(stretch, stress, error=2e3), "mooney-rivlin")
    assert one.constants == pytest.approx(plain.constants, rel=1e-9)
    np.testing.assert_allclose(two.covariance, 4.0 * one.covariance, rtol=1e-9)
    basis = mooney_rivlin_basis(stretch)
    np.testing.assert_allclose(one.covariance, 1e6 * np.linalg.inv(basis.T @ basis), rtol=1e-9)
    # scatter larger than the stated errors counts: the law does not describe the points that well
    bent = stress + 1e4 * np.cos(40.0 * stretch)
    optimist = fit(_data(stretch, bent, error=1.0), "mooney-rivlin")
    honest = fit(_data(stretch, bent), "mooney-rivlin")
    np.testing.assert_allclose(optimist.covariance, honest.covariance, rtol=1e-9)


def test_a_point_with_a_huge_error_does_not_count() -> None:
    stretch = np.linspace(1.1, 1.5, 9)
    stress = _mooney(stretch, C10, C01)
    stress[4] *= 3.0
    error = np.full(9, 1e3)
    error[4] = 1e12
    data = Measurement(stretch, stress, np.full(9, "uniaxial"), error, "made.csv")
    constants = fit(data, "mooney-rivlin").constants
    assert constants == pytest.approx({"c10": C10, "c01": C01}, rel=1e-6)


def test_unstable_data_end_on_the_bound_and_say_so() -> None:
    # c01 < 0 would be best; the bounded optimum is then the neo-Hookean one, with its error
    stretch = np.linspace(1.0, 1.5, 11)
    data = _data(stretch, _mooney(stretch, 2.0e5, -4.0e4))
    result = fit(data, "mooney-rivlin")
    reference = fit(data, "neo-hookean")
    assert result.at_bound == ("c01",)
    assert result.constants["c01"] == 0.0
    assert result.constants["c10"] == pytest.approx(reference.constants["c10"], rel=1e-12)
    assert result.covariance[0, 0] == pytest.approx(reference.covariance[0, 0], rel=1e-9)
    np.testing.assert_array_equal(result.covariance[1], 0.0)
    np.testing.assert_array_equal(result.correlation, np.eye(2))
    mirrored = fit(_data(stretch, _mooney(stretch, -4.0e4, 2.0e5)), "mooney-rivlin")
    assert mirrored.at_bound == ("c10",)
    assert mirrored.material().young_modulus > 0.0


@given(
    st.floats(-3e5, 3e5),
    st.floats(5e4, 3e5),
    st.floats(0.0, 5e5),
    st.floats(0.0, 5e5),
    st.integers(0, 2**32 - 1),
)
def test_no_stable_constants_do_better(
    c10: float, extra: float, other10: float, other01: float, seed: int
) -> None:
    stretch = np.linspace(1.05, 1.6, 8)
    noise = 5e3 * np.random.default_rng(seed).standard_normal(8)
    stress = _mooney(stretch, c10, extra - min(c10, 0.0) * 1.6) + noise
    result = fit(_data(stretch, stress), "mooney-rivlin")
    rival = np.sqrt(np.mean((_mooney(stretch, other10, other01) - stress) ** 2))
    assert result.rms_pa <= rival * (1.0 + 1e-9)


@given(st.sampled_from(SOFT), st.floats(1e-6, 1e6))
def test_a_change_of_unit_changes_nothing_else(law: str, factor: float) -> None:
    data = read(TRELOAR).select((1.0, 1.65))
    scaled = Measurement(data.stretch, factor * data.stress, data.mode, None, data.source)
    one, other = fit(data, law), fit(scaled, law)
    for name, value in one.constants.items():
        assert other.constants[name] == pytest.approx(factor * value, rel=1e-9)
    np.testing.assert_allclose(other.covariance, factor**2 * one.covariance, rtol=1e-7)
    np.testing.assert_allclose(other.correlation, one.correlation, rtol=1e-7)
    assert other.rms_pa == pytest.approx(factor * one.rms_pa, rel=1e-9)


def test_initial_slope_of_softening_curves_that_are_not_mooney_rivlin() -> None:
    # true stress linear in strain, and in the logarithm of stretch: both start with slope 1 MPa
    stretch = np.linspace(1.0, 1.25, 26)
    for curve in ((stretch - 1.0) / stretch, np.log(stretch) / stretch):
        result = fit(_data(stretch, 1e6 * curve), "svk")
        assert result.constants["young"] == pytest.approx(1e6, rel=0.01)


def test_rms_of_svk_is_the_misfit_of_the_law_not_of_its_tangent() -> None:
    result = fit(LATEX, "svk")
    used = read(LATEX).select(result.stretch_range)
    misfit = nominal_stress(result.material(), used.stretch) - used.stress
    assert result.rms_pa == pytest.approx(np.sqrt(np.mean(misfit**2)), rel=1e-12)
    assert result.rms_pa > 0.1 * used.stress.max()


def test_pure_shear_alone_fits_one_constant_but_not_two() -> None:
    stretch = np.linspace(1.0, 1.5, 9)
    data = _data(stretch, _mooney(stretch, C10, C01, "shear"), "shear")
    assert fit(data, "neo-hookean").constants["c10"] == pytest.approx(C10 + C01, rel=1e-12)
    assert fit(data, "svk", stretch=(1.0, 1.5)).constants["young"] == pytest.approx(
        6.0 * (C10 + C01), rel=1e-12
    )
    with pytest.raises(ValueError, match=r"\(shear\) cannot tell the constants of mooney-rivlin"):
        fit(data, "mooney-rivlin")


@pytest.mark.parametrize(
    ("stretch", "stress", "law", "message"),
    [
        ([1.0, 1.1, 1.2], [0.0, 1e4, 2e4], "gent", "'gent' is unknown: allowed are mooney"),
        ([1.1, 1.2], [1e4, 2e4], "mooney-rivlin", "2 points in the chosen .* at least 3"),
        ([1.3, 1.4, 1.5], [1e4, 2e4, 3e4], "svk", r"0 points .* 0\.8 to 1\.25"),
        ([1.2, 1.2, 1.2], [1e4, 2e4, 3e4], "mooney-rivlin", "cannot tell the constants"),
        ([1.0, 1.0, 1.0], [0.0, 0.0, 0.0], "neo-hookean", "undeformed"),
        ([1.1, 1.2, 1.3], [-1e4, -2e4, -3e4], "mooney-rivlin", "does not rise"),
        ([1.1, 1.2, 1.25], [-1e4, -2e4, -3e4], "svk", "does not rise"),
        ([1.1, 1.2, 1.3], [0.0, 0.0, 0.0], "neo-hookean", "does not rise"),
    ],
)
def test_data_without_an_answer_are_refused_in_one_line(
    stretch: list[float], stress: list[float], law: str, message: str
) -> None:
    with pytest.raises(ValueError, match=message) as caught:
        fit(_data(np.array(stretch), np.array(stress)), law)
    assert "\n" not in str(caught.value)


def _same(one: Fit, other: Fit) -> bool:
    return one.as_dict() == other.as_dict()


@pytest.mark.parametrize("law", LAWS)
def test_the_material_file_gives_back_every_bit_of_the_fit(tmp_path: Path, law: str) -> None:
    output = tmp_path / "material" / "latex.json"
    window = (1.0, 1.65) if law in SOFT else None  # short of which points few constants are told
    material.run(law, "latex", output, csv=TRELOAR, stretch=window, modes=["uniaxial", "biaxial"])
    result = fit(TRELOAR, law, stretch=window, modes=["uniaxial", "biaxial"])
    assert _same(load_fit(output), result)
    assert load_material(output) == result.material()
    content = json.loads(output.read_text())
    assert content["name"] == "latex"
    assert content["source"] == "treloar1944.csv"
    assert "Treloar" in content["source_note"]
    assert content["shear_modulus_pa"] == result.material().shear_modulus
    first = output.read_bytes()
    material.run(law, "latex", output, csv=TRELOAR, stretch=window, modes=["uniaxial", "biaxial"])
    assert output.read_bytes() == first
    assert [path.name for path in output.parent.iterdir()] == ["latex.json"]


def test_a_failed_run_leaves_the_older_file(tmp_path: Path) -> None:
    output = tmp_path / "latex.json"
    material.run("mooney-rivlin", "latex", output, csv=LATEX)
    first = output.read_bytes()
    with pytest.raises(ValueError, match="has no shear data"):
        material.run("mooney-rivlin", "latex", output, csv=LATEX, modes=["shear"])
    assert output.read_bytes() == first
    assert [path.name for path in tmp_path.iterdir()] == ["latex.json"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"law": None}, "key 'law' is missing"),
        ({"law": "gent"}, "'gent' is unknown"),
        ({"constants": {"c10": 1.0}}, "key 'c01' is missing"),
        ({"constants": {"c10": 1.0, "c01": -1.0}}, "c01 = -1: must be >= 0 Pa"),
        ({"constants": {"c10": "soft", "c01": 1.0}}, "soft"),
        ({"covariance": None}, "key 'covariance' is missing"),
    ],
)
def test_a_damaged_material_file_is_refused_by_name(
    tmp_path: Path, change: dict[str, object], message: str
) -> None:
    path = tmp_path / "latex.json"
    material.run("mooney-rivlin", "latex", path, csv=LATEX)
    content = json.loads(path.read_text()) | change
    path.write_text(json.dumps({key: value for key, value in content.items() if value is not None}))
    with pytest.raises(ValueError, match=rf"latex\.json: .*{message}"):
        load_fit(path)


@pytest.mark.parametrize(
    ("law", "constants", "modulus"),
    [
        ("mooney-rivlin", {"c10": 1e5, "c01": 2.5e5}, 7e5),  # 2 (C10 + C01)
        ("svk", {"young": 9e5, "poisson": 0.5}, 3e5),  # Y / 2 (1 + nu)
        ("svk", {"young": 9e5}, 3e5),  # incompressible by default
    ],
)
def test_given_constants_come_back_as_the_same_material_and_are_no_fit(
    tmp_path: Path, law: str, constants: dict[str, float], modulus: float
) -> None:
    material.run(law, "given", tmp_path / "given.json", constants=constants)
    loaded = load_material(tmp_path / "given.json")
    assert loaded == law_of(law).material(**constants)
    assert loaded.shear_modulus == pytest.approx(modulus, rel=1e-12)
    assert not is_fit(tmp_path / "given.json")
    with pytest.raises(ValueError, match=r"given\.json: key 'stretch_range' is missing"):
        load_fit(tmp_path / "given.json")


def test_a_file_that_is_no_material_at_all(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"absent\.json: cannot be read"):
        load_material(tmp_path / "absent.json")
    path = tmp_path / "list.json"
    path.write_text("[1, 2]")
    with pytest.raises(ValueError, match=r"list\.json: not a material file"):
        load_material(path)
    path.write_text('{"law": ')
    with pytest.raises(ValueError, match=r"list\.json"):
        load_material(path)


def test_the_fitted_constants_reproduce_the_curve_they_came_from() -> None:
    data = read(LATEX)
    stress = nominal_stress(fit(LATEX, "mooney-rivlin").material(), data.stretch)
    np.testing.assert_allclose(stress, data.stress, atol=1e-5)
    np.testing.assert_allclose(
        nominal_stress(mooney_rivlin(C10, C01), data.stretch), data.stress, atol=1e-5
    )


ALL_MODES = np.repeat(MODES, 14)
MADE = {
    "mooney-rivlin": mooney_rivlin(1.7e5, 2.0e4),
    "neo-hookean": neo_hookean(1.8e5),
    "svk": saint_venant_kirchhoff(1.3e6),
    "yeoh": yeoh(1.8e5, -1.5e3, 4.0e1),
    "ogden": ogden(6.3e5, 1.3, -1.0e4, -2.0),
    "foppl-von-karman": foppl_von_karman(1.3e6),
}


def _made(material: Material, highest: float = 3.0) -> Measurement:
    """Stresses of a material in all modes."""
    stretch = np.tile(np.linspace(1.05, highest, 14), 3)
    stress = nominal_stress(material, stretch, ALL_MODES)
    return Measurement(stretch, stress, ALL_MODES, None, "made.csv")


def test_every_registered_law_is_fitted_here() -> None:
    assert set(MADE) == set(LAWS)


@pytest.mark.parametrize("law", [law for law in LAWS if not law_of(law).small_strain])
def test_a_fit_finds_the_constants_that_made_the_data(law: str) -> None:
    made = MADE[law]
    result = fit(_made(made), law)
    assert result.constants == pytest.approx(made.law.physical(made.shear_modulus), rel=1e-7)
    assert result.at_bound == ()
    assert result.rms_pa < 1e-7 * made.shear_modulus


def test_ogden_of_mooney_rivlin_data_has_its_exponents() -> None:
    result = fit(_made(MADE["mooney-rivlin"]), "ogden")
    wanted = {"mu1": 3.4e5, "alpha1": 2.0, "mu2": -4.0e4, "alpha2": -2.0}
    assert result.constants == pytest.approx(wanted, rel=1e-7)
    stretch = np.linspace(1.0, 4.0, 9)
    for mode in MODES:
        expected = nominal_stress(MADE["mooney-rivlin"], stretch, mode)
        curve = nominal_stress(result.material(), stretch, mode)
        np.testing.assert_allclose(curve, expected, rtol=1e-7, atol=1e-3)


def test_treloar_up_to_the_end_needs_more_than_two_invariants() -> None:
    """Chains near their full length stiffen the rubber, which no Mooney-Rivlin curve does.

    Its uniaxial stress rises like 2 C10 lambda, slower than the line through the origin and the
    last point; the measured stress doubles from stretch 6.4 to 7.6. A second exponent, or the cube
    of I1 - 3, follows it.
    """
    data = read(TRELOAR)
    assert data.stretch.max() == 7.6
    results = {law: fit(data, law) for law in ("mooney-rivlin", "yeoh", "ogden")}
    rms = {law: result.rms_pa for law, result in results.items()}
    assert rms["yeoh"] < 0.25 * rms["mooney-rivlin"]
    assert rms["ogden"] < 0.30 * rms["mooney-rivlin"]
    last = {law: float(nominal_stress(result.material(), 7.6)) for law, result in results.items()}
    measured = 6.3176e6
    assert last["mooney-rivlin"] < 0.65 * measured
    assert abs(last["yeoh"] / measured - 1.0) < 0.15
    assert abs(last["ogden"] / measured - 1.0) < 0.15
    # the part of the larger exponent grows like lambda^(alpha - 1), faster than lambda
    assert results["ogden"].constants["alpha1"] > 3.0


@pytest.mark.parametrize("law", ["yeoh", "ogden"])
def test_covariance_of_the_other_laws_is_that_of_their_jacobian(law: str) -> None:
    """s^2 (J^T J)^-1 with J from central differences of the law's stress."""
    data = _made(MADE["yeoh"], 5.0) if law == "ogden" else _made(MADE["ogden"])
    result = fit(data, law)

    def stress(change: dict[str, float]) -> np.ndarray:
        material = law_of(law).material(**(result.constants | change))
        return nominal_stress(material, data.stretch, data.mode)

    columns = []
    for name, value in result.constants.items():
        step = 1e-5 * abs(value)
        ends = [stress({name: value + sign * step}) for sign in (1, -1)]
        columns.append((ends[0] - ends[1]) / (2.0 * step))
    slopes = np.stack(columns, axis=1)
    scale = np.array(list(result.constants.values()))
    free = data.stretch.size - len(columns)
    variance = result.rms_pa**2 * data.stretch.size / free
    expected = variance * np.linalg.inv((slopes * scale).T @ (slopes * scale))
    np.testing.assert_allclose(result.covariance / np.outer(scale, scale), expected, rtol=1e-4)
    # at the minimum the misfit is orthogonal to all that the constants can change
    misfit = stress({}) - data.stress
    angles = misfit @ slopes / np.linalg.norm(slopes, axis=0) / np.linalg.norm(misfit)
    np.testing.assert_allclose(angles, 0.0, atol=1e-6)


@pytest.mark.parametrize("law", ["yeoh", "ogden"])
def test_stated_errors_weigh_the_points_of_the_other_laws(law: str) -> None:
    data = _made(MADE[law])
    error = np.full(data.stretch.size, 2e3)
    stress = data.stress.copy()
    stress[5] *= 3.0
    error[5] = 1e12
    result = fit(Measurement(data.stretch, stress, data.mode, error, "made.csv"), law)
    made = MADE[law]
    assert result.constants == pytest.approx(made.law.physical(made.shear_modulus), rel=1e-5)
    half = fit(Measurement(data.stretch, stress, data.mode, 0.5 * error, "made.csv"), law)
    np.testing.assert_allclose(result.covariance, 4.0 * half.covariance, rtol=1e-4)


def test_a_yeoh_fit_refuses_a_sheet_that_is_soft_at_rest() -> None:
    # the best c10 is negative: the bound 0 leaves no initial modulus
    made = yeoh(1.0e5, 2.0e4, 0.0)
    data = _made(made)
    x = data.stretch**2 + 2.0 / data.stretch - 3.0
    soft = Measurement(data.stretch, data.stress * (x - 0.5), data.mode, None, "made.csv")
    with pytest.raises(ValueError, match="does not rise with stretch; no yeoh law fits"):
        fit(soft.select(None, ["uniaxial"]), "yeoh")


def test_data_with_a_single_term_cannot_tell_two_apart() -> None:
    with pytest.raises(ValueError, match=r"made\.csv: .*fewer constants"):
        fit(_made(MADE["neo-hookean"]), "ogden")


def test_constants_and_units_in_the_file() -> None:
    content = fit(_made(MADE["ogden"]), "ogden").as_dict()
    assert content["units"] == {"mu1": "Pa", "alpha1": "", "mu2": "Pa", "alpha2": ""}
    assert list(content["constants"]) == content["parameters"] == list(content["units"])
    assert list(content["constants_pa"]) == list(content["standard_errors_pa"]) == ["mu1", "mu2"]
    assert np.shape(content["covariance"]) == (4, 4)
    assert "covariance_pa2" not in content
    content = fit(LATEX, "mooney-rivlin").as_dict()
    assert content["covariance_pa2"] == content["covariance"]
    assert content["constants_pa"] == content["constants"]
