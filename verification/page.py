"""The page of the verification: what each group found, as Markdown with its tables and plots."""

import math
import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from verification.checks import read
from wrinklestudy.results.files import atomic_path, read_json

_INTRODUCTION = """# Verification

Evidence that the numbers are right, computed by the library itself. `make verify` computes all of
it anew and writes this page: nothing here is typed in. A check that fails makes `make verify` fail,
after the page is written. Lengths are in units of W, stresses in units of the initial shear modulus
mu, unless it is said otherwise. A *mutation* is a fault put into a copy of the code on purpose, to
see that a check catches it.
"""
_VERDICTS = {True: "passed", False: "**FAILED**"}
_CAUGHT_SHOWN = 3


def run(groups: Sequence[Path | str], mutations: Path | str | None, output: Path | str) -> None:
    """Write the page and put the plots of the groups into a folder of its name beside it.

    Parameters
    ----------
    groups : sequence of path
        JSON files of the groups, in the order of the page; their plots lie beside them.
    mutations : path or None
        JSON file of the mutations that were tried.
    output : path
        Markdown file.
    """
    output = Path(output)
    contents = [(Path(path), read(path)) for path in groups]
    tried = [] if mutations is None else read_json(mutations)["mutations"]
    parts = [_INTRODUCTION, summary([group for _, group in contents], tried)]
    for path, group in contents:
        own = [mutation for mutation in tried if mutation["group"] == group["name"]]
        parts.append(section(group, own, output.stem))
        for name, _ in group["plots"]:
            with atomic_path(output.with_suffix("") / name) as copy:
                shutil.copyfile(path.with_name(name), copy)
    with atomic_path(output) as page:
        page.write_text("\n".join(parts), encoding="utf-8")


def summary(groups: Sequence[dict[str, Any]], mutations: Sequence[dict[str, Any]]) -> str:
    """Return the table of all groups: checks, failures, mutations that were caught."""
    rows = []
    for group in groups:
        passed = [check["passed"] for check in group["checks"]]
        own = [one for one in mutations if one["group"] == group["name"]]
        caught = sum(bool(one["caught_by"]) for one in own)
        anchor = group["title"].lower().replace(" ", "-")
        rows.append(
            [
                f"[{group['title']}](#{anchor})",
                len(passed),
                len(passed) - sum(passed),
                f"{caught} of {len(own)}" if own else "none tried",
            ]
        )
    return table(("group", "checks", "failed", "mutations caught"), rows)


def section(group: dict[str, Any], mutations: Sequence[dict[str, Any]], folder: str) -> str:
    """Return the part of the page that belongs to a group.

    Parameters
    ----------
    group : dict
        What `checks.write` wrote.
    mutations : sequence of dict
        Those tried on this group.
    folder : str
        Where the plots lie, as seen from the page.
    """
    lines = [f"## {group['title']}", "", group["text"], ""]
    for name, caption in group["plots"]:
        lines += [f"![{caption}]({folder}/{name})", "", f"*{caption}*", ""]
    for one in group["tables"]:
        lines += [f"**{one['title']}**", "", table(one["columns"], one["rows"])]
    failed = [check for check in group["checks"] if not check["passed"]]
    if failed:
        lines += ["**Failed checks**", "", check_table(failed)]
    lines += [_folded(f"{len(group['checks'])} checks", check_table(group["checks"]))]
    lines += [mutation_text(mutation) for mutation in mutations]
    return "\n".join(lines)


def _folded(title: str, content: str) -> str:
    return f"<details><summary>{title}</summary>\n\n{content}\n</details>\n"


def mutation_text(mutation: dict[str, Any]) -> str:
    """Return a mutation of the code in words and which checks caught it."""
    caught = [str(name) for name in mutation["caught_by"]]
    names = "; ".join(escape(name) for name in caught[:_CAUGHT_SHOWN])
    more = len(caught) - _CAUGHT_SHOWN
    by = f"caught by {names}" + (f" and {more} more" if more > 0 else "")
    return (
        f"*Mutation*: {mutation['what']} (`{mutation['file']}`: "
        f"{_code(mutation['old'])} became {_code(mutation['new'])}): "
        f"{by if caught else '**nothing caught it**'}.\n"
    )


def _code(text: str) -> str:
    """Return code on one line as Markdown."""
    line = " ".join(text.split())
    return f"`` {line} ``" if line else "nothing"


def check_table(checks: Sequence[dict[str, Any]]) -> str:
    """Return a table of checks with their verdicts."""
    rows = [
        [
            check["name"],
            bounded(check["value"]) if check["kind"].startswith("at") else number(check["value"]),
            requirement(check),
            _VERDICTS[check["passed"]],
            check["reason"],
        ]
        for check in checks
    ]
    return table(("check", "value", "must be", "verdict", "because"), rows)


def requirement(check: dict[str, Any]) -> str:
    """Return in a few signs what the value of a check must be."""
    expected = number(check["expected"])
    if check["kind"] == "at most":
        return f"<= {expected}"
    if check["kind"] == "at least":
        return f">= {expected}"
    if check["tolerance"] == 0.0:
        return f"= {expected}"
    if check["kind"] == "absolute":
        return f"{expected} +- {check['tolerance']:.2g}"
    return f"{expected} to {check['tolerance']:.1e} of it"


def number(value: float | None) -> str:
    """Return a number with six digits, as few as it needs; NaN and None are no number."""
    if value is None or math.isnan(value):
        return "no number"
    return f"{value:.6g}"


def bounded(value: float | None) -> str:
    """Return a number that is only held against a bound: two digits, the others are rounding."""
    return number(None if value is None else float(f"{value:.1e}"))


def table(columns: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """Return a Markdown table, closed by an empty line."""
    lines = [columns, ["---"] * len(columns), *([_cell(value) for value in row] for row in rows)]
    return "".join(f"| {' | '.join(escape(cell) for cell in line)} |\n" for line in lines)


def _cell(value: Any) -> str:
    if value is None or isinstance(value, float):
        return number(value)
    return str(value)


def escape(text: str) -> str:
    """Return text that does not end a cell or a line of a table."""
    return " ".join(text.split()).replace("|", "\\|")
