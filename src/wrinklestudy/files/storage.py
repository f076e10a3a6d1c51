"""Read and write the files between the stages.

Every file is written under a temporary name in its own folder and renamed when it is complete,
and the same content gives the same bytes, so that a result can be compared and restored exactly.
"""

import errno
import hashlib
import json
import math
import os
import platform
import uuid
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from wrinklestudy.files import origin
from wrinklestudy.files.records import check
from wrinklestudy.typing import AnyPath

_DISK = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EIO, errno.EACCES)


class DiskError(OSError):
    """A file cannot be written; one line that names it and says why."""


@contextmanager
def atomic_path(output: AnyPath) -> Iterator[Path]:
    """Yield a temporary path that becomes ``output`` when the block ends without an error.

    The temporary file is hidden, lies in the folder of ``output`` (made if missing) and has the
    same suffix; its name has the host and the process that writes. If the block raises, the
    temporary file is removed and an older ``output`` is left as it was. What a process of this host
    that was killed left of the same file is removed first.

    Parameters
    ----------
    output : path-like
        File to write.

    Yields
    ------
    Path
        Where to write in the meantime.

    Raises
    ------
    DiskError
        If the disk is full or cannot be written; one line that names the file.
    """
    target = Path(output)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        _remove_left_over(target)
    except OSError as error:
        raise DiskError(f"{target}: cannot be written ({error.strerror})") from error
    temporary = target.with_name(
        f".{target.stem}-{_host()}-{os.getpid()}-{uuid.uuid4().hex[:8]}{target.suffix}"
    )
    try:
        yield temporary
        os.replace(temporary, target)
    except Exception as error:
        if fault := _fault_of_disk(error):
            raise DiskError(f"{target}: cannot be written ({fault})") from error
        raise
    finally:
        with suppress(OSError):  # of a disk that can only be read
            temporary.unlink(missing_ok=True)


def _fault_of_disk(error: BaseException | None) -> str | None:
    """Return what is wrong with the disk, if that is behind an error.

    Libraries that close a file which could not be written fail once more, in their own ways.
    """
    while error is not None:
        if isinstance(error, OSError) and error.errno in _DISK:
            return os.strerror(error.errno)
        error = error.__context__
    return None


def _remove_left_over(target: Path) -> None:
    """Remove what processes of this host that live no more left of the same file."""
    prefix, suffix = f".{target.stem}-{_host()}-", target.suffix
    for path in target.parent.iterdir():
        if path.name.startswith(prefix) and path.name.endswith(suffix):
            process, _, _ = path.name.removeprefix(prefix).partition("-")
            if process.isdecimal() and not _lives(int(process)):
                path.unlink(missing_ok=True)


def _host() -> str:
    """Return a short name for this host, whose process ids mean nothing on another."""
    return hashlib.sha256(platform.node().encode()).hexdigest()[:8]


def _lives(process: int) -> bool:
    """Whether there is a process of that id, of whatever user."""
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        pass
    return True


def _plain(value: Any) -> Any:
    """Return ``value`` as JSON knows it: no numpy types, NaN as None."""
    if isinstance(value, Mapping):
        return {str(key): _plain(entry) for key, entry in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return _plain(value.tolist())
    if isinstance(value, list | tuple):
        return [_plain(entry) for entry in value]
    if isinstance(value, float) and math.isnan(value):
        return None
    return value


def format_json(value: Any) -> str:
    """Return ``value`` as JSON text with sorted keys and NaN as null.

    Raises
    ------
    ValueError
        If a number is infinite.
    TypeError
        If something in ``value`` has no JSON form.
    """
    return json.dumps(_plain(value), sort_keys=True, indent=1, allow_nan=False) + "\n"


def write_json(output: AnyPath, value: Any) -> None:
    """Write ``value`` (mappings, sequences, numpy arrays, scalars) as JSON; see `format_json`."""
    text = format_json(value)
    with atomic_path(output) as path:
        path.write_text(text, encoding="utf-8")


def read_json(path: AnyPath) -> Any:
    """Return the content of a JSON file.

    Raises
    ------
    ValueError
        If the file is not JSON; the message names file and line. `DamagedFileError` if it is not
        what its record says.
    """
    check(path)
    try:
        return json.loads(Path(path).read_text(encoding="utf-8"))
    except UnicodeDecodeError as error:
        raise ValueError(f"{os.fspath(path)}: is not JSON: {error.reason}") from None
    except json.JSONDecodeError as error:
        message = f"{os.fspath(path)}: line {error.lineno} is not JSON: {error.msg}"
        raise ValueError(message) from None


def write_h5(
    output: AnyPath,
    datasets: Mapping[str, NDArray[Any] | str],
    attrs: Mapping[str, Any],
) -> None:
    """Write arrays and attributes as an HDF5 file without time stamps.

    Parameters
    ----------
    output : path-like
        File to write.
    datasets : mapping
        Arrays or strings by name; a name ``group/name`` makes the group.
    attrs : mapping
        Attributes of the file: strings, numbers, booleans, arrays, lists of numbers or of strings,
        and None, which is stored as an HDF5 attribute with a null dataspace (`h5py.Empty`).

    Raises
    ------
    TypeError
        If an attribute has another type; the message names it.
    """
    import h5py

    # the default file format has no time stamps in groups, libver="latest" would have
    with atomic_path(output) as path, h5py.File(path, "w") as file:
        for name in sorted(attrs):
            file.attrs[name] = _attribute(name, attrs[name])
        if origin.current():
            file.attrs[origin.KEY] = origin.current()
        for name in sorted(datasets):
            file.create_dataset(name, data=datasets[name], track_times=False)


def _attribute(name: str, value: Any) -> Any:
    import h5py

    if value is None:
        return h5py.Empty("f8")
    if isinstance(value, str | bool | int | float | np.generic):
        return value
    if isinstance(value, list | tuple) and value and all(isinstance(v, str) for v in value):
        return np.array(value, dtype=h5py.string_dtype())
    if isinstance(value, np.ndarray | list | tuple):
        array = np.asarray(value)
        if array.dtype.kind in "biuf":
            return array
    raise TypeError(
        f"attribute {name!r} = {value!r}: must be text, a number, a list of these or None"
    )


def read_h5(
    path: AnyPath, names: tuple[str, ...] | None = None
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the datasets and attributes that `write_h5` wrote.

    Parameters
    ----------
    path : path-like
        File to read.
    names : tuple of str, optional
        Datasets to read; all of them by default, none of them for ``()``.

    Returns
    -------
    datasets : dict
        Arrays or strings by their full name (``group/name``).
    attrs : dict
        Attributes as plain Python scalars, strings and None; arrays as numpy arrays, lists of
        strings as lists. What `origin` put there is left out.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        If the file is not HDF5 or a dataset is missing; the message names the file.
        `DamagedFileError` if it is not what its record says.
    """
    import h5py

    if not Path(path).exists():
        raise FileNotFoundError(f"{os.fspath(path)}: no such file")
    check(path)
    try:
        file = h5py.File(path, "r")
    except OSError as error:
        raise ValueError(f"{os.fspath(path)}: not a complete HDF5 file ({error})") from None
    with file:
        wanted = _dataset_names(file) if names is None else names
        missing = [name for name in wanted if name not in file]
        if missing:
            raise ValueError(f"{os.fspath(path)}: has no dataset {missing[0]!r}")
        datasets = {name: _dataset(file[name]) for name in wanted}
        attrs = {
            name: _plain_attribute(value)
            for name, value in file.attrs.items()
            if name != origin.KEY
        }
    return datasets, attrs


def _dataset_names(file: Any) -> list[str]:
    import h5py

    names: list[str] = []

    def collect(name: str, item: Any) -> None:
        if isinstance(item, h5py.Dataset):
            names.append(name)

    file.visititems(collect)
    return names


def _dataset(dataset: Any) -> Any:
    import h5py

    text = h5py.check_string_dtype(dataset.dtype) is not None
    return dataset.asstr()[()] if text else dataset[()]


def _plain_attribute(value: Any) -> Any:
    import h5py

    if isinstance(value, h5py.Empty):
        return None
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, np.ndarray) and value.dtype.kind == "O":
        return value.tolist()
    return value
