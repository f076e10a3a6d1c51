"""The kind of processor and the versions with which the verification ran."""

import platform
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import threadpoolctl
from scipy import sparse

from wrinklestudy.fem.factorisation import make_solver
from wrinklestudy.files.storage import write_json
from wrinklestudy.typing import AnyPath

PACKAGES = ("numpy", "scipy", "scikit-fem", "pypardiso", "mkl")
_CPUINFO = Path("/proc/cpuinfo")


def run(output: AnyPath, groups: object = None) -> None:  # noqa: ARG001
    """Write a JSON file about the machine that this runs on.

    Parameters
    ----------
    output : path
    groups : object
        Not read; named so that this runs after the groups.
    """
    write_json(output, facts())


def facts() -> dict[str, Any]:
    """Return processor, BLAS kernels, factorisation and versions; nothing that names a machine."""
    solver = make_solver()
    solver.factorise(sparse.eye_array(2, format="csr"))  # loads its BLAS library
    return {
        "processor": f"{platform.machine()}, {processor(_CPUINFO)}",
        "system": platform.system(),
        "kernels": kernels(),
        "factorisation": type(solver).__name__,
        "versions": {"Python": platform.python_version()}
        | {name: known for name in PACKAGES if (known := _version(name))},
    }


def processor(cpuinfo: Path) -> str:
    """Return the model of the processor from a file like /proc/cpuinfo."""
    try:
        text = cpuinfo.read_text(encoding="utf-8")
    except OSError:
        return "model unknown"
    fields = dict(line.split(":", 1) for line in text.splitlines()[::-1] if ":" in line)
    names = {name.strip(): value.strip() for name, value in fields.items()}
    return names.get("model name") or "model unknown"


def kernels() -> list[str]:
    """Return the BLAS libraries that are loaded, with the kernels they chose."""
    versions = {
        f"{library['internal_api']} {library['version']}"
        + (f" ({library['architecture']})" if library.get("architecture") else "")
        for library in threadpoolctl.threadpool_info()
        if library["user_api"] == "blas"
    }
    return sorted(versions)


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""
