"""Mutations of the code: faults put into a copy of it, to see whether the checks catch them.

Each mutation replaces one text in one file of a temporary copy of the package and runs the quick
checks of its group on that copy in a new process. It is caught by the checks that then fail, or by
an error that stops them.
"""

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from textwrap import shorten

from wrinklestudy.files.storage import write_json
from wrinklestudy.study.digest import PACKAGE, SOURCE

PROJECT = Path(__file__).resolve().parents[1]  # where the package `verification` lies
_LIMIT = 300.0  # seconds
_WIDTH = 160  # of a message
_CHECKS = (
    "import json, wrinklestudy\n"
    "from verification.groups import {group}\n"
    "failed = [check.name for check in {group}.quick() if not check.passed]\n"
    "print(json.dumps([wrinklestudy.__file__, failed]))"
)


@dataclass(frozen=True)
class Mutation:
    """One fault.

    Parameters
    ----------
    group : str
        The group whose quick checks must catch it.
    what : str
        The fault in words.
    file : str
        File below the package.
    old, new : str
        Text that occurs once, and what replaces it.
    """

    group: str
    what: str
    file: str
    old: str
    new: str


MUTATIONS = (
    Mutation(
        "element",
        "sign of one slope function of the Hermite basis",
        "fem/hermite.py",
        "(3 * s**2 - 2 * s**3, s**3 - s**2)",
        "(3 * s**2 - 2 * s**3, s**2 - s**3)",
    ),
    Mutation(
        "element",
        "derivatives in y scaled with the width of the cell",
        "fem/space.py",
        "wide ** -d[0] * high ** -d[1]",
        "wide ** -d[0] * wide ** -d[1]",
    ),
    Mutation(
        "kernel",
        "a sign in the Hessian",
        "mechanics/plate.py",
        "out -= section.moment[a - 2] * surface.dual[b, i] * normal[j]",
        "out += section.moment[a - 2] * surface.dual[b, i] * normal[j]",
    ),
    Mutation(
        "kernel",
        "a factor missing where element tangents are scattered",
        "fem/assembly.py",
        "(scale[left] * scale[right])",
        "(scale[left])",
    ),
    Mutation(
        "closed_forms",
        "lambda3 dropped, with its derivatives",
        "mechanics/laws/incompressible.py",
        "return stretch, first * slope, hessian",
        "return np.ones_like(det), 0.0 * slope, 0.0 * hessian",
    ),
    Mutation(
        "closed_forms",
        "a factor two in the second derivative of the law",
        "mechanics/laws/mooney_rivlin.py",
        "by_det2 = 2.0 * (",
        "by_det2 = 1.0 * (",
    ),
    Mutation(
        "convergence",
        "wrong weights of the Gauss points: all equal",
        "fem/space.py",
        "return points, weights",
        "return points, np.full_like(weights, 1.0 / len(weights))",
    ),
    Mutation(
        "corner",
        "modes of the corner taken for wrinkles",
        "equilibrium/deflections.py",
        "CORNER_PART = 0.5",
        "CORNER_PART = 1.5",
    ),
    Mutation(
        "imperfections",
        "slope at a twisted clamp that does not turn with it",
        "fem/boundary.py",
        "np.repeat([[-n[0] / n[2]], [-n[1] / n[2]]], len(tied), axis=1)",
        "np.zeros((2, len(tied)))",
    ),
    Mutation(
        "independent",
        "force of half the sheet",
        "fem/boundary.py",
        "factor = 1.0 if self.odd_across is None else 2.0",
        "factor = 1.0",
    ),
    Mutation(
        "independent",
        "arm of the upper and lower Gauss point t/2 instead of t/(2 sqrt 3)",
        "mechanics/bending.py",
        "shift = thickness / math.sqrt(3.0) * curvature",
        "shift = thickness * curvature",
    ),
    Mutation(
        "solid",
        "every bending law is that of a fixed thickness",
        "mechanics/bending.py",
        "return BENDING_LAWS[name]",
        'return BENDING_LAWS["fixed-thickness"]',
    ),
    Mutation(
        "whole_sheet",
        "classes that break y taken for those that keep it",
        "equilibrium/mirror_stability.py",
        "symmetry.broken(kind.keeps_x, kind.keeps_y)",
        "symmetry.broken(kind.keeps_x, True)",
    ),
    Mutation(
        "whole_sheet",
        "one component keeps its parity in classes that break x",
        "fem/boundary.py",
        "else _opposite(self.odd_along)",
        "else (False, False, True)",
    ),
    Mutation(
        "paths",
        "clamp left behind by the corrector of the continuation",
        "equilibrium/continuation.py",
        "here = self.at(point.strain).derivatives(point.unknowns)",
        "here = self.at(guess.strain).derivatives(point.unknowns)",
    ),
    Mutation(
        "paths",
        "search stopped far from the minimum",
        "equilibrium/newton.py",
        "0.0 <= decrement <= options.tolerance * abs(energy)",
        "0.0 <= decrement <= 1e-7 * abs(energy)",
    ),
    Mutation(
        "bending_laws",
        "lambda3 to the first power in the bending stiffness",
        "mechanics/bending.py",
        "bending = arm**2 * mean2",
        "bending = arm * lever * mean2",
    ),
    Mutation(
        "scans",
        "noise drawn without the long waves that the spline has taken out",
        "metrics/smoothing.py",
        "power[:first] = np.median(",
        "power[:first] = 0.0 * np.median(",
    ),
    Mutation(
        "scans",
        "spikes taken for measurements",
        "metrics/scan_points.py",
        "SPIKE = 5.0",
        "SPIKE = 5000.0",
    ),
    Mutation(
        "tension_field",
        "natural width of wrinkles ignored: they hide all that is narrower than undeformed",
        "mechanics/relaxed.py",
        "return np.nan_to_num(self.law.natural_width(np.sqrt(larger))) ** 2",
        "return np.ones_like(larger)",
    ),
    Mutation(
        "tension_field",
        "tension of wrinkles at the width of the sheet instead of the natural one",
        "mechanics/relaxed.py",
        "stress, tangent = self.law.derivatives(natural)",
        "stress, tangent = self.law.derivatives(\n"
        "            np.stack([natural[0], stretches.smaller[where], natural[2]])\n"
        "        )",
    ),
    Mutation(
        "tension_field",
        "hidden width over the width of the sheet at each point",
        "metrics/confinement.py",
        "points.wrinkled, points.natural_width * (1.0 - 1.0 / (1.0 + points.excess)), 0.0",
        "points.wrinkled, points.excess, 0.0",
    ),
    Mutation(
        "regression",
        "a random start of the eigenvalue search",
        "equilibrium/modes.py",
        "v0=np.ones(size)",
        "v0=np.random.default_rng().standard_normal(size)",
    ),
    Mutation(
        "thin_sheets",
        "bending of the envelope linear in the thickness",
        "equilibrium/envelope.py",
        "thickness**2 * bent",
        "thickness * bent",
    ),
    Mutation(
        "regression",
        "biaxial data fitted as if the second direction were held",
        "material/homogeneous.py",
        '"biaxial": stretch,',
        '"biaxial": np.ones_like(stretch),',
    ),
)


def run(output: Path | str, mutations: Sequence[Mutation] = MUTATIONS) -> None:
    """Try all mutations and write which checks caught each, with data from the current folder.

    Parameters
    ----------
    output : path
        JSON file with the mutations and, for each, the names of the checks in ``caught_by``.

    Raises
    ------
    ValueError
        If a quick check fails without any mutation, or an old text does not occur exactly once.
    """
    with TemporaryDirectory() as folder:
        for group in dict.fromkeys(mutation.group for mutation in mutations):
            if failed := failures(_copy(Path(folder, group)), group):
                raise ValueError(f"{group}: fails without a mutation: {'; '.join(failed)}")
        tried = []
        for number, mutation in enumerate(mutations):
            source = _copy(Path(folder, str(number)))
            apply(mutation, source)
            tried.append(asdict(mutation) | {"caught_by": failures(source, mutation.group)})
    write_json(output, {"mutations": tried})


def apply(mutation: Mutation, source: Path) -> None:
    """Replace the text of a mutation in a folder that holds the package.

    Raises
    ------
    ValueError
        If the text does not occur exactly once.
    """
    path = source / PACKAGE / mutation.file
    text = path.read_text(encoding="utf-8")
    if (count := text.count(mutation.old)) != 1:
        raise ValueError(f"{mutation.file}: {mutation.old!r} occurs {count} times, must be once")
    path.write_text(text.replace(mutation.old, mutation.new), encoding="utf-8")


def failures(source: Path, group: str) -> list[str]:
    """Return the quick checks of a group that fail with the package in a folder.

    An error that stops the checks counts as a failure, named by its last line.

    Raises
    ------
    RuntimeError
        If another copy of the package was loaded.
    """
    path = os.pathsep.join([str(source), str(PROJECT)])
    environment = os.environ | {"PYTHONPATH": path, "PYTHONDONTWRITEBYTECODE": "1"}
    command = [sys.executable, "-W", "ignore", "-c", _CHECKS.format(group=group)]
    try:
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, timeout=_LIMIT, check=False
        )
    except subprocess.TimeoutExpired:
        return [f"stopped after {_LIMIT:g} s"]
    if done.returncode:
        last = (done.stderr.strip().splitlines() or ["no message"])[-1]
        return [shorten(f"the checks stop with {last}", _WIDTH, placeholder=" ...")]
    file, failed = json.loads(done.stdout.splitlines()[-1])
    if source not in Path(file).parents:
        raise RuntimeError(f"{group}: the package came from {file}, not from {source}")
    names: list[str] = failed
    return names


def _copy(target: Path) -> Path:
    """Copy the package into a new folder and return it."""
    ignore = shutil.ignore_patterns("__pycache__")
    shutil.copytree(SOURCE / PACKAGE, target / PACKAGE, ignore=ignore)
    return target
