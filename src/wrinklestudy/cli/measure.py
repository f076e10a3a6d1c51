"""`wrinklestudy measure`: amplitude, wavelength and confinement of scanned profiles."""

import argparse
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from wrinklestudy.cli.output import Answer
from wrinklestudy.cli.outputs import add_overwrite, planned, write

# Keys of the result that are lengths; those with an error have a key with `_error`
_LENGTHS = ("amplitude", "wavelength", "arc_width", "projected_width", "noise")
_LINES = {
    "amplitude": "amplitude A",
    "wavelength": "wavelength lambda",
    "arc_width": "arc width W_act",
    "projected_width": "width W_proj",
    "phi_squared": "Phi^2",
    "shape_constant": "C = A/(lambda Phi)",
    "noise": "noise of a point",
}


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command."""
    parser.add_argument(
        "scans",
        nargs="+",
        metavar="FILE_OR_FOLDER",
        help="profiles with columns y and w (or y_mm and w_mm); of a folder all *.csv",
    )
    parser.add_argument(
        "--plot", metavar="PICTURE", help="draw points and measures (.pdf, .png, .svg)"
    )
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> Answer:
    """Return what is measured on each profile."""
    paths = _files(arguments.scans)
    picture = _picture(arguments.plot, arguments.overwrite, paths)

    from wrinklestudy.metrics.scan import measure_scan
    from wrinklestudy.study.scan_file import read_scan_file

    files = [read_scan_file(path) for path in paths]
    scans = [(file, measure_scan(file.y, file.z)) for file in files]
    if picture is not None:
        from wrinklestudy.study.figures import scan_picture, style

        with style.applied():
            figure = scan_picture.draw(scans)
            write(picture, lambda path: style.save(figure, path))
    results = [_plain(file, scan) for file, scan in scans]
    return Answer(results, "\n\n".join(_described(result) for result in results) + "\n")


def _files(given: Sequence[str]) -> list[Path]:
    """Return the files, those of a folder in the order of their names."""
    files: list[Path] = []
    for path in map(Path, given):
        inside = sorted(path.glob("*.csv")) if path.is_dir() else [path]
        if not inside:
            raise ValueError(f"{path}: the folder has no *.csv")
        files += inside
    return list(dict.fromkeys(files))


def _picture(given: str | None, overwrite: bool, paths: Sequence[Path]) -> Path | None:
    """Return where to draw, after checking that it may be drawn there."""
    if given is None:
        return None
    from wrinklestudy.stages.figures import SUFFIXES
    from wrinklestudy.study.figures.scan_picture import MOST

    (path,) = planned("--plot", given, SUFFIXES, overwrite, [""])
    if len(paths) > MOST:
        raise ValueError(f"--plot: {len(paths)} profiles; a picture holds at most {MOST}")
    return path


def _plain(file: Any, scan: Any) -> dict[str, Any]:
    """Return a measured scan as plain values, None where there is no number."""
    nan, measures = math.nan, scan.measures
    names = ("amplitude", "wavelength", "arc_width", "projected_width", "phi_squared")
    values = {name: getattr(measures, name, nan) for name in (*names, "shape_constant")}
    errors = {
        f"{name}_error": getattr(scan, f"{name}_error")
        for name in ("amplitude", "wavelength", "phi_squared")
    }
    numbers = values | errors | {"noise": scan.noise}
    known = {name: value if math.isfinite(value) else None for name, value in numbers.items()}
    return {
        "file": str(file.path),
        "unit": file.unit or None,
        "wrinkled": scan.wrinkled,
        "reason": scan.reason or None,
        "note": scan.note or None,
        "points": len(file.y),
        "left_out": scan.left_out,
        **known,
    }


def _described(result: dict[str, Any]) -> str:
    unit = f" {result['unit']}" if result["unit"] else ""
    if result["wrinkled"]:
        verdict = "wrinkled"
    elif result["amplitude"] is None:
        verdict = f"the scan cannot tell: {result['reason']}"
    else:
        verdict = f"not wrinkled: {result['reason']}"
    lines = [f"{result['file']}: {verdict}."]
    if result["note"]:
        lines.append(f"Note: {result['note']}.")
    for name, label in _LINES.items():
        value, error = result[name], result.get(f"{name}_error")
        if value is not None:
            size = f"{value:.6g}" if name.endswith("width") else _rounded(value, error)
            lines.append(f"  {label:<20}{size}{unit if name in _LENGTHS else ''}")
    lines.append(f"  {'points left out':<20}{result['left_out']} of {result['points']}")
    return "\n".join(lines)


def _rounded(value: float, error: float | None) -> str:
    """Return a number with its standard error, both to two digits of the error."""
    if not error or not math.isfinite(error):
        return f"{value:.4g}" if error is None else f"{value:.6g}"
    digits = 1 - math.floor(math.log10(error))
    if not 0 <= digits <= 8:
        return f"{value:.6g} +- {error:.2g}"
    return f"{value:.{digits}f} +- {error:.{digits}f}"
