"""Where a file comes from, written into the file itself: HDF5, VTU, PDF, PNG, SVG, figure CSV.

A job states the origin of its files once; the writers put it where readers of the format do
not mind it. It has no time, no path and no name of a host: the same job gives the same bytes.
"""

import json
import re
import struct
import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # --help loads no numpy
    from wrinklestudy.typing import AnyPath

KEY = "provenance"  # HDF5 attribute, text chunk of a PNG
_PDF_KEY, _SVG_KEY = "Subject", "Description"  # of what the formats allow
_PNG_START = b"\x89PNG\r\n\x1a\n"
_CSV_LINE = f"# {KEY}: "
_VTU_COMMENT = re.compile(rf"<!-- {KEY}: (.*?) -->\s*$".encode(), flags=re.DOTALL)
_PDF_TEXT = re.compile(rf"/{_PDF_KEY} \(((?:[^\\()]|\\.)*)\)".encode(), flags=re.DOTALL)

_STATED: ContextVar[str] = ContextVar("origin", default="")


@contextmanager
def stated(made: Mapping[str, Any]) -> Iterator[None]:
    """State the origin of all files that are written within the block."""
    # no "--" in the text, which would end a comment in XML; a minus as \u002d is JSON too
    text = json.dumps(made, sort_keys=True).replace("--", "-\\u002d")
    token = _STATED.set(text)
    try:
        yield
    finally:
        _STATED.reset(token)


def current() -> str:
    """Return the origin as JSON in ASCII on one line; empty where none is stated."""
    return _STATED.get()


def take_over(text: str) -> None:
    """State what another process states: its `current`."""
    _STATED.set(text)


def metadata(suffix: str) -> dict[str, str]:
    """Return the origin as metadata of a picture, as `Figure.savefig` takes them."""
    key = {".pdf": _PDF_KEY, ".svg": _SVG_KEY}.get(suffix, KEY)
    return {key: current()} if current() else {}


def comment_line() -> str:
    """Return the origin as a line above the numbers of a figure; empty where none is stated."""
    return f"{_CSV_LINE}{current()}\n" if current() else ""


def append_comment(path: "AnyPath") -> None:
    """Add the origin to an XML file, at its end."""
    if current():
        with open(path, "ab") as file:
            file.write(f"<!-- {KEY}: {current()} -->\n".encode())


def embedded(path: "AnyPath") -> dict[str, Any] | None:
    """Return the origin that a file has in itself; None if it has none.

    Raises
    ------
    OSError
        If the file cannot be read.
    ValueError
        If it is damaged; one line that names the file.
    """
    file = Path(path)
    reader = _READERS.get(file.suffix)
    text = None if reader is None else reader(file)
    if text is None:
        return None
    try:
        made = json.loads(text)
    except ValueError:
        made = None
    if not isinstance(made, dict):
        raise ValueError(f"{file}: damaged, what it says of its origin cannot be read")
    return made


def _of_h5(path: Path) -> str | None:
    import h5py

    try:
        with h5py.File(path, "r") as file:
            text = file.attrs.get(KEY)
    except (OSError, RuntimeError) as error:
        if not path.is_file():
            raise
        raise ValueError(f"{path}: not a complete HDF5 file ({error})") from None
    return None if text is None else str(text)


def _of_xml(path: Path) -> bytes | None:
    found = _VTU_COMMENT.search(path.read_bytes())
    return None if found is None else found[1]


def _of_svg(path: Path) -> str | None:
    import html

    pattern = r"<dc:description>(.*?)</dc:description>"
    found = re.search(pattern, path.read_text(encoding="utf-8"), flags=re.DOTALL)
    return None if found is None else html.unescape(found[1])


def _of_pdf(path: Path) -> bytes | None:
    found = _PDF_TEXT.search(path.read_bytes())
    return None if found is None else re.sub(rb"\\(.)", rb"\1", found[1], flags=re.DOTALL)


def _of_png(path: Path) -> bytes | None:
    data, place = path.read_bytes(), len(_PNG_START)
    while data.startswith(_PNG_START) and place + 12 <= len(data):
        size, kind = struct.unpack_from(">I4s", data, place)
        content = data[place + 8 : place + 8 + size]
        key, _, text = content.partition(b"\0")
        if kind == b"tEXt" and key == KEY.encode():
            if data[place + 8 + size : place + 12 + size] != struct.pack(
                ">I", zlib.crc32(kind + content)
            ):
                raise ValueError(f"{path}: damaged, what it says of its origin cannot be read")
            return text
        place += 12 + size
    return None


def _of_csv(path: Path) -> str | None:
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            if line.startswith(_CSV_LINE):
                return line.removeprefix(_CSV_LINE)
            if not line.startswith("#"):
                break
    return None


_READERS = {
    ".h5": _of_h5,
    ".vtu": _of_xml,
    ".svg": _of_svg,
    ".pdf": _of_pdf,
    ".png": _of_png,
    ".csv": _of_csv,
}
