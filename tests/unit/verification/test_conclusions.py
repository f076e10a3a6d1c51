"""Sentences of the page that draw a conclusion come out as the numbers say, both ways."""

from types import SimpleNamespace

import numpy as np
import pytest

from benchmarks.report import choice
from verification.checks import conclusion
from verification.groups import (
    bending_laws,
    closed_forms,
    convergence,
    corner,
    element,
    independent,
    paths,
    scans,
    tension_field,
    whole_sheet,
)
from verification.groups.bending_laws import LINEAR, NEO, OTHERS, PAPER
from verification.groups.corner import BendingForm, Leading
from verification.groups.element import SINGULAR, ErrorOnMesh
from verification.tools import seeding
from verification.tools.sheets import BENDING_LAWS

NAN = float("nan")


def test_what_is_not_a_number_proves_nothing():
    assert conclusion(NAN > 1.0, "yes", "no") == conclusion(NAN <= 1.0, "yes", "no") == "no"


@pytest.mark.parametrize(
    ("errors", "says", "not_said"),
    [
        ((1e-9, 1e-5), "Its error grows with the mesh, from 1e-09 on 1 cells", SINGULAR),
        ((1e-5, 1e-9), "Its error does not grow", "grows"),
        ((1e-9, NAN, 1e-5), f"It has {SINGULAR} on 2 cells; its error grows", "does not"),
        ((NAN, NAN), f"It has {SINGULAR} on 1 cells, 2 cells.", "error"),
    ],
)
def test_scikit_fems_own_element(errors, says, not_said):
    rows = [ErrorOnMesh(cells, 1e-14, error) for cells, error in enumerate(errors, start=1)]
    text = element.monomials_text(rows)
    assert says in text
    assert not_said not in text


def test_a_singular_element_of_scikit_fem_does_not_stop_the_group(monkeypatch, tmp_path):
    """On some processors its matrix has no inverse."""

    def singular(*_args, **_options):
        raise np.linalg.LinAlgError("Singular matrix")

    monkeypatch.setattr(element, "CELLS", (4, 3))
    monkeypatch.setattr(element, "_SWEEP", ((2, 2), (3, 2)))
    monkeypatch.setattr("skfem.element.element_global.ElementGlobal._eval_dofs", singular)
    element.run(tmp_path / "element.json")
    text = (tmp_path / "element.json").read_text()
    assert f"It has {SINGULAR} on 4 cells, 6 cells, 12 cells, the graded mesh." in text
    assert text.count(f'"{SINGULAR}"') == 10  # five derivatives on two meshes
    assert (tmp_path / "element_reproduction.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("ratios", "says"),
    [
        ([1.0, 1.0 + 1e-8], "`thinning` agrees with the exact solution to 1e-08"),
        ([1.0, 1.5], "`thinning` is up to 50% stiffer than the exact solution"),
        ([1.0, 0.5], "`thinning` is up to 50% softer than the exact solution"),
    ],
)
def test_bending_laws_against_the_exact_flexure(ratios, says):
    assert says in closed_forms.flexure_text({"thinning": ratios})


@pytest.mark.parametrize(("order", "says"), [(1.5, ", all above"), (1.0, ", not all above")])
def test_orders_of_convergence(order, says):
    assert says in convergence.orders_text([4.0, order])


def test_modes_of_the_corner():
    wrinkles = [Leading(1.0, NAN)] * 5
    led = corner.modes_text([*wrinkles[:4], Leading(1.0, 2.0)], wrinkles)
    assert "at strains 0.5 it has a larger critical thickness" in led
    assert "none is among the 8 leading modes" in led
    other = corner.modes_text([Leading(1.0, 0.9)] * 5, [*wrinkles, Leading(1.0, 0.5)])
    assert "no mode that sits there has a larger" in other
    assert "1 of the cases have one" in other


def test_definiteness_at_the_corner():
    definite, not_so = (BendingForm(0.5, 0, "8 t x 9 t", 1e-3, n) for n in (0, 2))
    finer = BendingForm(0.5, 2, "2 t x 3 t", 1e-3, 1)
    assert "stays positive definite; on finer cells it does not at strain 0.5 (2 t" in (
        corner.forms_text([definite, finer])
    )
    assert "negative eigenvalues there too; on finer cells it has no" in corner.forms_text([not_so])


@pytest.mark.parametrize(
    ("here", "there", "says"),
    [
        (True, True, "both sheets are flat, and the projected width"),
        (True, False, "only the sheet computed here is flat."),
        (False, True, "only the sheet of the data is flat."),
        (False, False, "neither sheet is flat."),
    ],
)
def test_the_last_point_of_the_data(here, there, says):
    assert independent.end_text(0.33, here, there).startswith(f"At eps = 0.33 {says}")


def test_stability_in_the_whole_sheet():
    text = whole_sheet.windows_text(["birth to 0.1", "0.1 to decay"], 13, 13)
    assert "Exactly one parity is stable there at all 13 strains" in text
    assert "Antisymmetric: stable in the whole sheet for strains birth to 0.1." in text
    text = whole_sheet.windows_text(["", "birth to decay"], 12, 13)
    assert "at only 12 of 13" in text
    assert "Antisymmetric: nowhere stable" in text


@pytest.mark.parametrize(
    ("relative", "says"), [(1e-7, "imperfections, not this energy"), (1e-2, "remains open")]
)
def test_the_barrier_against_sliding(relative, says):
    assert says in whole_sheet.barrier_text([relative], 0.06, 1e-14)


def test_what_coarse_meshes_tell_of_sliding():
    text = whole_sheet.mesh_text({(12, 24): [0.07], (12, 36): [0.2]}, [0.2], 1e-4)
    assert "12 x 24: 0.07; 12 x 36: 0.2" in text
    assert "cannot tell at these strains" in text
    assert "they have converged" in text
    text = whole_sheet.mesh_text({(12, 24): [], (12, 36): []}, [], 1e-2)
    assert "give the same signs" in text
    assert "it tells which" in text
    assert "they have not converged" in text


def seeded(distinct, gain):
    return SimpleNamespace(distinct=distinct, states=[0] * 10, gains=np.array([gain]))


def test_minima_from_seeds():
    text = paths.minima_text([seeded(1, 1.0), seeded(1, 1.001)])
    assert "From 20 seeds" in text
    assert "is 1: the state does not depend on the seed" in text
    assert "differ by 1e-03 at most" in text
    assert "is 1 or 2: the state depends" in paths.minima_text([seeded(1, 1.0), seeded(2, 1.0)])


def test_states_on_a_branch():
    same, other = (
        SimpleNamespace(energies=0.0, amplitudes=factor * seeding.AGREE) for factor in (0.5, 2.0)
    )
    assert "pass through the same states" in paths.same_text([same, same])
    assert "do not pass through" in paths.same_text([same, other])


@pytest.mark.parametrize(
    ("rise", "fall", "stiff", "folds", "says"),
    [
        (250.0, -40.0, 1e-6, 0, ["Birth is super", "decay super", "nothing jumps"]),
        (-250.0, -40.0, 1e-6, 0, ["Birth is sub", "decay super", "with a jump"]),
        (250.0, 40.0, 1e-6, 0, ["Birth is super", "decay sub", "with a jump"]),
        (250.0, -40.0, 0.0, 0, ["with a jump"]),
        (250.0, -40.0, 1e-6, 1, ["have 1 folds", "with a jump"]),
    ],
)
def test_how_wrinkles_come_and_go(rise, fall, stiff, folds, says):
    text = paths.onset_text(rise, fall, [stiff, 2e-6], folds)
    assert all(part in text for part in says)


def decays(paper, others):
    """Strains of decay by material and law, each for thinning, fixed-thickness and fvk."""
    rows = {PAPER: paper, OTHERS: others, NEO: (0.26, 0.24, 0.26), LINEAR: (0.13, 0.12, 0.12)}
    return {
        (name, bending): value
        for name, values in rows.items()
        for bending, value in zip(BENDING_LAWS, values, strict=True)
    }


RATIOS = {PAPER: 2.5, OTHERS: 0.1, NEO: 0.0}


def test_what_the_bending_law_moves():
    usual = decays((0.40, 0.32, 0.60), (0.28, 0.25, 0.30))
    assert "up to 0.28, the more the larger C01/C10 is." in bending_laws.decay_text(usual, RATIOS)
    other = decays((0.40, 0.39, 0.40), (0.28, 0.25, 0.30))
    assert "not always more" in bending_laws.decay_text(other, RATIOS)


def test_laws_of_equal_stiffness():
    usual = decays((0.40, 0.32, 0.60), (0.28, 0.25, 0.30))
    assert "agree there to 0.0%" in bending_laws.twins_text(usual)
    assert "differ there by up to 8.3%" in bending_laws.twins_text(usual | {(NEO, "fvk"): 0.24})


@pytest.mark.parametrize(
    ("paper", "others", "says"),
    [
        (
            (0.40, 0.32, 0.60),
            (0.28, 0.25, 0.30),
            ["explain the disagreement, as", "depends on the bending law", "does not tell which"],
        ),
        (
            (0.40, 0.40, 0.40),
            (0.30, 0.20, 0.39),
            ["do not explain", "depends on the bending law", "rules out some"],
        ),
        ((0.40, 0.40, 0.40), (0.30, 0.30, 0.30), ["explain the", "much the same with every"]),
    ],
)
def test_the_published_disagreement(paper, others, says):
    text = bending_laws.disagreement_text(decays(paper, others))
    assert all(part in text for part in says)


def mesh_row(along, seconds, error):
    return {
        "along": along, "across": 36, "grading": 1.5, "seconds": seconds,
        "error_amplitude": error, "error_tau": 1e-4,
    }  # fmt: skip


@pytest.mark.parametrize(
    ("errors", "says"),
    [
        ((1e-3, 1e-3), ["holds both; ", "16 x 36, grading 1.5, at 0.50 of the time"]),
        ((1e-3, 1.0), ["does not hold them; ", "16 x 36"]),
        ((1.0, 1.0), ["does not hold them; no mesh that was tried holds both"]),
    ],
)
def test_the_choice_of_the_default_mesh(errors, says):
    text = choice([mesh_row(16, 5.0, errors[0]), mesh_row(24, 10.0, errors[1])])
    assert all(part in text for part in says)


@pytest.mark.parametrize(
    ("covered", "says"),
    [
        ((0.95, 0.93, 0.99), "Phi^2 in 99.0% of the trials, as they must in at least 90%"),
        ((0.95, 0.89, 0.99), "of the trials, which for one of them is less than the 90%"),
        ((0.95, 0.95, NAN), "is less than the 90%"),
    ],
)
def test_how_often_the_errors_of_a_scan_cover_the_truth(covered, says):
    assert says in scans.verdict(covered, 0.01)


def test_a_scan_that_was_refused_covers_nothing():
    known = scans.Trial("white noise", 10, 400, "", (0.01, -0.03, 0.0), (0.01, 0.01, 0.01))
    refused = scans.Trial("white noise", 10, 400, "no", (NAN,) * 3, (NAN,) * 3)
    assert scans.coverage([known, refused]) == [0.5, 0.0, 0.5]
    assert scans.refused([known, refused]) == 0.5


@pytest.mark.parametrize(
    ("plain", "contracting", "taut"), [(1e-5, 6e-4, True), (6e-4, 6e-4, False), (NAN, 6e-4, False)]
)
def test_what_lateral_contraction_does_to_the_rays(plain, contracting, taut):
    errors = ((plain, 0.0), (contracting, 0.05))
    rows = [tension_field.StripErrors(0.01, e, 0.0, np.zeros(1), part) for e, part in errors]
    assert ("leave the sheet taut" in tension_field.taut_corner_text(*rows)) is taut
