"""The page of the verification: what each group computed, with tables and plots."""

import shutil
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from verification import templates
from verification.checks import read
from wrinklestudy.files.storage import atomic_path, read_json
from wrinklestudy.study.pages import markdown, number, render
from wrinklestudy.typing import AnyPath

COLUMNS = ("check", "value", "must be", "verdict", "because")
_CAUGHT_SHOWN = 3


def run(
    groups: Sequence[AnyPath],
    mutations: AnyPath | None,
    page: AnyPath,
    machine: AnyPath | None = None,
    plots: AnyPath | None = None,
) -> None:
    """Write the page and put the plots of the groups into a folder beside it.

    Parameters
    ----------
    groups : sequence of path
        JSON files of the groups, in the order of the page; their plots lie beside them.
    mutations : path or None
        JSON file of the mutations that were tried.
    page : path
        Markdown file.
    machine : path, optional
        JSON file of `machine`.
    plots : path, optional
        Folder of the plots; by default that of the page's name beside it.
    """
    page = Path(page)
    folder = page.with_suffix("") if plots is None else Path(plots)
    tried = [] if mutations is None else read_json(mutations)["mutations"]
    contents = [(Path(path), read(path)) for path in groups]
    text = render(
        "verification.md.j2",
        Path(templates.__file__).parent,
        groups=[section(group, tried) for _, group in contents],
        folder=folder.name,
        columns=COLUMNS,
        machine=None if machine is None else read_json(machine),
    )
    for path, group in contents:
        for name, _ in group["plots"]:
            with atomic_path(folder / name) as copy:
                shutil.copyfile(path.with_name(name), copy)
    with atomic_path(page) as target:
        target.write_text(text, encoding="utf-8")


def section(group: dict[str, Any], mutations: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return what the template says of a group.

    Parameters
    ----------
    group : dict
        The content of a file of `checks.write`.
    mutations : sequence of dict
        All mutations that were tried; those of other groups are left out.
    """
    own = [mutation for mutation in mutations if mutation["group"] == group["name"]]
    caught = sum(bool(mutation["caught_by"]) for mutation in own)
    return group | {
        "checks": [check_row(check) for check in group["checks"]],
        "failed": [check_row(check) for check in group["checks"] if not check["passed"]],
        "caught": f"{caught} of {len(own)}" if own else "none tried",
        "mutations": [mutation | {"outcome": outcome(mutation["caught_by"])} for mutation in own],
    }


def outcome(caught_by: Sequence[str]) -> str:
    """Return in Markdown which checks caught a mutation."""
    if not caught_by:
        return "**nothing caught it**"
    names = "; ".join(markdown(name) for name in caught_by[:_CAUGHT_SHOWN])
    more = len(caught_by) - _CAUGHT_SHOWN
    return f"caught by {names}" + (f" and {more} more" if more > 0 else "")


def check_row(check: dict[str, Any]) -> list[str]:
    """Return a check as a row with its verdict, columns `COLUMNS`."""
    bound = check["kind"] not in ("absolute", "relative")
    return [
        check["name"],
        bounded(check["value"]) if bound else number(check["value"]),
        requirement(check),
        "passed" if check["passed"] else "FAILED",
        check["reason"],
    ]


def requirement(check: dict[str, Any]) -> str:
    """Return in a few characters what the value of a check must be."""
    expected = number(check["expected"])
    signs = {"at most": "<=", "at least": ">=", "more than": ">"}
    if check["kind"] in signs:
        return f"{signs[check['kind']]} {expected}"
    if check["tolerance"] == 0.0:
        return f"= {expected}"
    if check["kind"] == "absolute":
        return f"{expected} +- {check['tolerance']:.2g}"
    return f"{expected} to {check['tolerance']:.1e} of it"


def bounded(value: float | None) -> str:
    """Return a number that is only compared with a bound, to two digits; the rest is rounding."""
    return number(None if value is None else float(f"{value:.1e}"))
