"""The gate of the verification: it fails if a check failed or a mutation went unnoticed."""

from collections.abc import Sequence
from typing import Any

from verification.checks import read
from verification.page import requirement
from wrinklestudy.files.storage import read_json, write_json
from wrinklestudy.study.pages import number
from wrinklestudy.typing import AnyPath


class VerificationError(ValueError):
    """A check failed, or nothing caught a mutation of the code."""


def run(
    groups: Sequence[AnyPath],
    output: AnyPath,
    mutations: AnyPath | None = None,
    page: AnyPath | None = None,  # noqa: ARG001
) -> None:
    """Write how many checks passed, if all of them did.

    Parameters
    ----------
    groups : sequence of path
        JSON files of the groups.
    output : path
        JSON file with the number of checks of each group.
    mutations : path, optional
        JSON file of the mutations that were tried: each group needs one, and all must be caught.
    page : path, optional
        Not read; named so that the page is there before this fails.

    Raises
    ------
    VerificationError
        With one line for each failed check and each mutation that nothing caught. Nothing is
        written.
    """
    contents = [read(path) for path in groups]
    failures = [line for group in contents for line in failed(group)]
    if mutations is not None:
        failures += unnoticed([group["name"] for group in contents], read_json(mutations))
    if failures:
        raise VerificationError("\n".join(failures))
    write_json(output, {group["name"]: len(group["checks"]) for group in contents})


def failed(group: dict[str, Any]) -> list[str]:
    """Return one line for each failed check of a group; a group without checks is a failure."""
    if not group["checks"]:
        return [f"{group['name']}: has no checks"]
    return [
        f"{group['name']}: {check['name']} is {number(check['value'])}, "
        f"must be {requirement(check)}"
        for check in group["checks"]
        if not check["passed"]
    ]


def unnoticed(groups: Sequence[str], tried: dict[str, Any]) -> list[str]:
    """Return one line for each mutation that nothing caught and each group without any."""
    mutations = tried["mutations"]
    have = {mutation["group"] for mutation in mutations}
    lines = [f"{name}: no mutation was tried" for name in groups if name not in have]
    lines += [
        f"{mutation['group']}: nothing caught the mutation of {mutation['file']}: "
        f"{mutation['what']}"
        for mutation in mutations
        if not mutation["caught_by"]
    ]
    return lines
