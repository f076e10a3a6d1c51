"""Records of a job: what its files were made from, written beside them and into them."""

import platform
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from wrinklestudy.files.origin import stated
from wrinklestudy.files.records import Record, file_digest
from wrinklestudy.files.storage import atomic_path

# Packages on which the last digits, or the look of a figure, depend
_PACKAGES = ("numpy", "scipy", "pypardiso", "scikit-fem", "h5py", "pandas", "matplotlib")


def program() -> dict[str, Any]:
    """Return program, versions and kind of machine, with no name of a host.

    It takes a tenth of the time of a job: the workflow asks once and tells each job.
    """
    from importlib.metadata import PackageNotFoundError, version

    versions = {"python": platform.python_version()}
    for name in _PACKAGES:
        try:
            versions[name] = version(name)
        except PackageNotFoundError:  # pypardiso is not for every machine
            continue
    return {
        "program": f"wrinklestudy {version('wrinklestudy')}",
        "versions": versions,
        "machine": f"{platform.system()} {platform.machine()}",
    }


@contextmanager
def recorded(
    about: Mapping[str, Any],
    stage: str,
    params: Mapping[str, Any],
    inputs: Mapping[str, str | Sequence[str]],
    outputs: Sequence[str],
    records: Sequence[str],
) -> Iterator[None]:
    """Say in the files written within the block, and in their records, what they are made from.

    The old records go first: a job that is killed leaves files without a record, which are made
    again, and never the record of another file.

    Parameters
    ----------
    about : mapping
        What `program` gives.
    stage : str
        Name of the stage.
    params : mapping
        What the job takes from the config, with ``code``, the digest of its code, and perhaps
        ``caption`` with the ``cases`` and the ``mesh`` of a figure.
    inputs : mapping
        Files by their names in the rule.
    outputs, records : sequences of str
        Files that the block writes and the files of their records, in the same order.
    """
    for old in records:
        Path(old).unlink(missing_ok=True)
    files = {name: [value] if isinstance(value, str) else value for name, value in inputs.items()}
    digests = {file: file_digest(file) for group in files.values() for file in group}
    caption = params.get("caption")
    made = {
        **about,
        "stage": stage,
        "code": params["code"],
        "config": {name: params[name] for name in sorted(params) if name not in _NOT_CONFIG},
        "inputs": {
            name: _joined(digests[file] for file in group) for name, group in files.items() if group
        },
        **({"shown": caption} if isinstance(caption, Mapping) else {}),
    }
    with stated(made):
        yield
    for output, path in zip(outputs, records, strict=True):
        record = Record(made, digests, Path(output).stat().st_size, file_digest(output))
        with atomic_path(path) as temporary:
            temporary.write_text(record.text(), encoding="utf-8")


_NOT_CONFIG = ("caption", "code")


def _joined(digests: Iterable[str]) -> str:
    """Return one digest for some files: that of a single one, else of all of them in order."""
    import hashlib

    several = list(digests)
    if len(several) == 1:
        return several[0]
    return hashlib.sha256(" ".join(several).encode()).hexdigest()
