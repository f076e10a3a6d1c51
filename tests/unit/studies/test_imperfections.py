"""The study of imperfections: its limits, its budget and its verdicts, on made-up numbers."""

import math

import numpy as np
import pytest
from made_up_study import MATERIALS, material, sheet, world

from wrinklestudy.mechanics.laws import mooney_rivlin
from wrinklestudy.results.imperfection_rows import ImperfectionRow
from wrinklestudy.results.rows import columns
from wrinklestudy.results.tables import write_imperfections
from wrinklestudy.studies.imperfections import CATALOGUE
from wrinklestudy.studies.imperfections.budget import SET_UP, budget, total
from wrinklestudy.studies.imperfections.effects import effects_of, reached
from wrinklestudy.study.catalogue import Catalogue
from wrinklestudy.study.claims.discovery import load_claims
from wrinklestudy.study.claims.tables import StudyTables

CLAIMS = {claim.key: claim for claim in load_claims("imperfections")}
SIZES = (0.01, 0.03, 0.1)
RIPPLE = "thickness-ripple 0.0625 1.5708 0"
STRAINS = (0.12, 0.3)


def row(kind="perfect", size=0.0, strain=0.12, **changes):
    """Return a row of a wrinkled sheet."""
    blank = {
        name: None if column.optional else "" if column.kind is str else 0
        for name, column in columns(ImperfectionRow).items()
    }
    known = {
        **{"material": "latex", "bending": "thinning", "aspect": 2.0, "thickness": 1e-3},
        **{"imperfection": kind if kind == "perfect" else f"{kind}-{size:g}".replace(" ", "x")},
        **{"kind": kind, "size": size, "strain": strain, "status": "wrinkled"},
        **{"amplitude_low": 3.1, "amplitude_high": 3.3, "envelope_amplitude": 3.3},
        **{"tilt": 0.0, "shift_along": 0.0, "shift_across": 0.0, "pin_reaction": 1e-15},
        **{"softest_eigenvalue": 1e-8, "parity_energy": 0.0, "newton_iterations": 7},
        **{"residual": 1e-24, "birth_strain": 0.0247, "decay_strain": 0.4, "windows": "x"},
        **{"bifurcation": "sharp", "symmetry": "whole", "parity": "antisymmetric"},
    }
    return ImperfectionRow(**{**blank, **known, **changes})


def made_up(tmp_path, rows=(), power=1.0, **kinds):
    """Return a study; of each kind the relative change of A and that of decay at size 1."""
    every = [row(strain=strain) for strain in STRAINS]
    for kind, (amplitude, decay, parity) in kinds.items():
        name = RIPPLE if kind == "ripple" else kind.replace("_", "-")
        every += [
            row(
                name,
                size,
                strain,
                envelope_amplitude=3.3 * (1.0 + amplitude * size),
                decay_strain=0.4 + decay * size,
                parity_energy=parity * size**power,
                tilt=size / 2.0 / (1.0 + strain),
            )
            for size in SIZES
            for strain in STRAINS
        ]
    path = tmp_path / "imperfections.csv"
    write_imperfections([*every, *rows], path)
    fits = (
        material("treloar", constants={"c10": 1e5, "c01": 0.2e5}),
        material("treloar-uniaxial", constants={"c10": 1e5, "c01": 1.0e5}),
    )
    base = world((*MATERIALS, *fits))
    ratios = {"mr-000": 0.26, "mr-050": 0.33, "mr-100": 0.36, "mr-500": 0.4}
    given = {name: mooney_rivlin(1e5, 1e5 * float(name[3:]) / 100.0 + 1e-9) for name in ratios}
    sheets = [sheet(material=name, decay=decay) for name, decay in ratios.items()]
    analyses = {"imperfection": {"table": [path]}}
    return StudyTables((*base.sheets, *sheets), base.materials, base.wanted, given, analyses)


def verdict(study, key):
    return CLAIMS[key].finding(study).verdict


@pytest.mark.parametrize(
    ("changes", "how"),
    [
        ([0.001, 0.01, 0.1], "between"),
        ([0.03, 0.1, 0.3], "below"),
        ([0.001, -0.002, 0.003], "above"),
        ([0.001, math.nan, 0.3], "unknown"),
        ([0.001, 0.04, math.nan], "between"),
    ],
)
def test_where_a_change_reaches_a_limit(changes, how):
    found = reached([0.1, 1.0, 10.0], changes, 0.02)
    assert found.how == how
    low, high = {"between": (0.1, 10.0), "below": (0.0, 0.1), "above": (10.0, 10.0)}.get(
        how, (math.nan, math.nan)
    )
    assert low <= found.size <= high or how == "unknown"
    assert found.bound == (0.0 if how == "unknown" else found.size)


@pytest.mark.parametrize("exponent", [1.0, 1.4, 2.0])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_power_law_is_found_again_between_and_below_the_sizes(exponent, sign):
    """|change| = (size/0.2)^n 0.02 is 0.02 at 0.2, whatever the sizes that were computed."""
    for sizes, how in (
        ([0.01, 0.1, 1.0], "between"),
        ([0.3, 1.0], "below"),
        ([0.01, 0.1], "above"),
    ):
        changes = sign * 0.02 * (np.array(sizes) / 0.2) ** exponent
        found = reached(sizes, changes, 0.02)
        assert found.how == how
        assert found.size == pytest.approx(sizes[-1] if how == "above" else 0.2)


def test_effects_are_changes_against_the_perfect_sheet(tmp_path):
    (shear, ripple) = effects_of(made_up(tmp_path, shear=(1.0, 0.1, 0.0), ripple=(0, 0, -3.0)))
    assert shear.sizes == pytest.approx(SIZES)
    assert shear.amplitude[0.3] == pytest.approx(SIZES)
    assert shear.decay == pytest.approx(0.1 * np.array(SIZES))
    assert shear.decay_limit.size == pytest.approx(0.1)
    assert shear.decay_at(0.02) == pytest.approx(0.002)
    assert shear.decay_at(0.005) == pytest.approx(0.0005)
    assert math.isnan(shear.decay_at(0.2))
    assert ripple.parity[0.12] == pytest.approx(-3.0 * np.array(SIZES))


def test_a_hole_is_a_hole(tmp_path):
    """A state that did not converge makes its kind unknown from that size on, and is counted."""
    failed = row("lift", 0.03, envelope_amplitude=None, decay_strain=None, status="not-converged")
    others = [row("lift", size, s) for size in SIZES for s in STRAINS if (size, s) != (0.03, 0.12)]
    study = made_up(tmp_path, [failed, *others])
    (lift,) = effects_of(study)
    assert lift.amplitude_limit(0.12).how == "unknown"
    assert lift.amplitude_limit(0.3).how == "above"
    assert verdict(study, "every-state-converges") == "disagree"
    assert verdict(made_up(tmp_path, shear=(0, 0, 0)), "every-state-converges") == "agree"


@pytest.mark.parametrize(
    ("key", "yes", "no"),
    [
        (
            "aligned-clamps-are-enough",
            {"shear": (1.0, 0.1, 0), "twist": (0, 0, 0)},
            {"shear": (1.0, 0.1, 0), "twist": (3.0, 0, 0)},
        ),
        (
            "even-rubber-is-enough",
            {"thickness_along": (0.0, 0.2, 0)},
            {"thickness_along": (0.0, 0.5, 0)},
        ),
        (
            "something-smooth-chooses",
            {"ripple": (0, 0, 3.0), "shear": (0, 0, 0.1)},
            {"ripple": (0, 0, 3.0), "shear": (0, 0, 0.01)},
        ),
        ("weight-does-not-matter", {"density": (1.0, 0.1, 0)}, {"density": (1.0, 2.0, 0)}),
        ("weight-does-not-matter", {"density": (1.0, 0.1, 0)}, {"density": (3.0, 0.1, 0)}),
        (
            "rubber-before-clamps",
            {"shear": (0, 1e-4, 0)},
            {"shear": (0, 20.0, 0)},
        ),
    ],
)
def test_verdicts_go_either_way(tmp_path, key, yes, no):
    assert verdict(made_up(tmp_path, **yes), key) == "agree"
    assert verdict(made_up(tmp_path, **no), key) == "disagree"


def test_a_ripple_that_chooses_in_proportion_is_told_from_one_that_does_not(tmp_path):
    """The wavelength of the made-up wrinkles decides which ripple is one of half of it."""
    for power, exponent in ((1.0, True), (2.0, False)):
        study = made_up(tmp_path, power=power, ripple=(0, 0, -3.0))
        finding = CLAIMS["a-ripple-chooses"].finding(study)
        slopes = [v.number for v in finding.values if v.name.startswith("exponent")]
        assert slopes == pytest.approx([power, power])
        strain, waves = study.sheet.wrinkled("strain", "wavelength_over_width")
        own = waves[np.isclose(strain[:, None], STRAINS).any(axis=1)]
        near = bool((abs(0.0625 / (0.5 * own) - 1.0) <= 0.15).any())
        assert (finding.verdict == "agree") == (exponent and near)


def test_the_pin_and_the_tilt_go_either_way(tmp_path):
    calm = made_up(tmp_path, shear=(0, 0, 0))
    assert verdict(calm, "the-pin-carries-nothing") == "agree"
    assert verdict(calm, "tilt-of-a-sheared-sheet") == "agree"
    pulled = [row("shear", 0.01, tilt=0.02), row(strain=0.2, pin_reaction=1e-5)]
    busy = made_up(tmp_path, pulled)
    assert verdict(busy, "the-pin-carries-nothing") == "disagree"
    assert verdict(busy, "tilt-of-a-sheared-sheet") == "disagree"


def test_without_imperfect_sheets_nothing_is_claimed():
    for claim in CLAIMS.values():
        assert claim.finding(world()).verdict == "not computed"


def test_errors_add_as_squares(tmp_path):
    study = made_up(tmp_path, shear=(0, 1.0, 0), lift=(0, 0.5, 0))
    shares = budget(study, effects_of(study))
    assert total(shares, "set-up") == pytest.approx(
        math.hypot(SET_UP["shear"], 0.5 * SET_UP["lift"])
    )
    parts = (total(shares, source) for source in ("set-up", "rubber", "steps"))
    assert total(shares) == pytest.approx(math.hypot(*parts))


def test_every_table_says_what_is_lacking_and_shows_what_is_there(tmp_path):
    from importlib import import_module

    assert isinstance(CATALOGUE, Catalogue)
    study = made_up(tmp_path, shear=(1.0, 0.1, 0), ripple=(0, 0, 3.0))
    for entry in CATALOGUE.tables:
        module = import_module(entry.module)
        assert module.table(world()).note.startswith("Not in the study")
        full = module.table(study)
        assert full.rows
        assert all(len(cells) == len(full.head) for cells in full.cells)
        assert all(len(cells) == len(full.columns) for cells in full.rows)
