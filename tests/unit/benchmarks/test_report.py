"""The page of the benchmarks from what they measured."""

import re

import pytest

from benchmarks.report import FILES, page


def run(name, cells, median, **extra):
    return {"name": name, "stats": {"median": median}, "extra_info": {"cells": cells, **extra}}


def mesh_row(along, seconds):
    return {
        "part": "cells along", "along": along, "across": 36, "grading": 1.5, "seconds": seconds,
        "error_amplitude": 1e-3, "error_amplitude_at": "SVK at 0.12",
        "error_tau": 1e-4, "error_tau_at": "L/W 1.8 at 0.4",
    }  # fmt: skip


@pytest.fixture
def measured():
    return {
        "solver": {
            "machine_info": {"cpu": {"brand_raw": "A | B"}},
            "benchmarks": [
                run("test_factorisation[1x]", 100, 0.1),
                run("test_factorisation[4x]", 400, 0.8),
                run("test_wrinkled_state[1x]", 100, 0.3, newton_iterations=3),
            ],
        },
        "study": {
            "cores": 2, "wall": 100.0, "cpu": 180.0, "solving": 90.0, "overhead": 0.5,
            "peak_mb_of_a_job": 293.4,
            "stages": {
                "planar": {"jobs": 10, "job": 20.0, "solve": 15.0},
                "wrinkle": {"jobs": 20, "job": 30.0, "solve": 25.0},
            },
            "starts": [
                {"imports": "Python", "seconds": 0.5}, {"imports": "numpy", "seconds": 2.0},
            ],
        },
        "mesh": {
            "finest": {"cells_along": 40, "cells_across": 60, "grading": 1.5}, "cases": 25,
            "rows": [mesh_row(16, 5.0), mesh_row(24, 10.0)],
        },
        "thin": {
            "strain": 0.1,
            "sheets": [
                {
                    "thickness": 1e-3, "cells": [24, 36], "unknowns": 10439, "status": "wrinkled",
                    "amplitude_over_thickness": 3.09, "wavelength": float("nan"),
                    "cells_per_wavelength": 9.4, "newton_iterations": 3, "planar_seconds": 0.5,
                    "wrinkle_seconds": 0.6, "peak_mb": 271.0,
                }
            ],
        },
    }  # fmt: skip


def test_the_page_has_what_was_measured(measured):
    text = page(measured)
    assert "(A \\| B, 2 cores)" in text
    # time grows by 8 where the cells grow by 4
    assert "| factorisation | 100.0 (1.00) | 800.0 (1.00) | cells^1.50 |" in text
    assert "| wrinkled state | 300.0 (3.00) |  |  |" in text
    assert "- Newton iterations, wrinkled state\\[1x\\]: 3" in text
    assert "**50% of the CPU" in text
    assert "30 starts of Python" in text
    assert "| + numpy | 1.500 |" in text
    # 30 starts of 2 s beside 90 s of solving
    assert "30 of them, start for 60 s." in text
    assert "that alone is 40% of the CPU time" in " ".join(text.split())
    assert "24 x 36, grading 1.5, which holds both; the cheapest here that holds: 16 x 36" in text
    assert "| 0.001 | 24 x 36 | 10439 | wrinkled | 3.09 | no number |" in text


def test_every_table_has_as_many_cells_in_each_row(measured):
    tables = re.findall(r"(?:^\|.*\|\n)+", page(measured), flags=re.MULTILINE)
    assert len(tables) >= len(measured)
    for table in tables:
        counts = {line.replace("\\|", "").count("|") for line in table.splitlines()}
        assert len(counts) == 1


def test_the_same_numbers_give_the_same_page(measured):
    assert set(measured) == set(FILES)
    assert page(measured) == page(dict(reversed(measured.items())))
