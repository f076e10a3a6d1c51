"""A made-up page: two sheets of a study with a hole, a map and a tension field."""

from dataclasses import replace

import pytest

from wrinklestudy.explorer.content import Content, ShownMap, ShownSheet, map_of_points
from wrinklestudy.results.load import load_sheets
from wrinklestudy.results.rows import columns
from wrinklestudy.results.tension import TensionRow

STRAINS = (0.02, 0.06, 0.1, 0.12, 0.2, 0.32, 0.46)
NAMED = "rubber"


def shown(folder, sheet, material, **options):
    """Return a made-up sheet with its shapes."""
    (states,) = load_sheets(*([path] for path in sheet.write(folder, STRAINS)))
    shapes = tuple(sheet.shape(row.strain) for row in states.states)
    return ShownSheet(states, shapes, material, **options)


def tension_row(strain, phi_squared, aspect=2.0):
    """Return a made-up tension field."""
    values = dict.fromkeys(columns(TensionRow)) | {"material": NAMED, "law": "mooney-rivlin"}
    numbers = {"remainder": 0.0, "newton_iterations": 5, "cells_along": 4, "cells_across": 4}
    case = {"aspect": aspect, "strain": strain, "status": "wrinkled", "reason": ""}
    return TensionRow(**values | numbers | case | {"phi_squared": phi_squared})


def critical_map(model):
    """Return a made-up map with a hole."""
    aspects, strains = (1.0, 2.0, 4.0), (0.05, 0.1, 0.3)
    points = [(a, e, 1e-3 * (1.0 + e) / a) for a in aspects for e in strains]
    return map_of_points(model, [*points[:-1], (4.0, 0.3, None)])


@pytest.fixture(scope="session")
def content(tmp_path_factory, made_up) -> Content:
    """Made-up sheets: one material with two bending laws and thicknesses, another without map."""
    folder = tmp_path_factory.mktemp("explorer")
    thin = made_up(material=NAMED, thickness=5e-4, holes=())
    sheets = [
        shown(folder, made_up(material=NAMED), NAMED),
        shown(folder, thin, NAMED, width_mm=140.0),
        shown(folder, made_up(material="rubber-fvk", bending="fvk"), NAMED),
        shown(folder, made_up(material="stiff", birth=None, holes=()), "stiff"),
    ]
    maps: list[ShownMap] = [critical_map(NAMED)]
    tension = {NAMED: [tension_row(strain, 2e-3 * strain) for strain in (0.05, 0.2, 0.4)]}
    return Content("Made up", "a test", sheets, maps, tension, {NAMED: "a law"})


@pytest.fixture(scope="session")
def hostile(content) -> Content:
    """The same with names that would be markup if nothing escaped them."""
    name = "</script><script>hacked=1</script><img src=x onerror=hacked=1>"
    sheets = [replace(sheet, material=name) for sheet in content.sheets[:1]]
    return replace(
        content,
        title=f"Title {name}",
        source=f"{name}.yaml",
        sheets=sheets,
        tension={name: content.tension[NAMED]},
        constants={name: f"<b>{name}</b>"},
    )
