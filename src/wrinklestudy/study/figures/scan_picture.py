"""A picture of scanned profiles: points, what was left out, smooth profile and measures."""

from collections.abc import Sequence
from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.metrics.scan import ScanMeasures
from wrinklestudy.study.figures import style
from wrinklestudy.study.scan_file import ScanFile
from wrinklestudy.typing import Array

MOST = 40  # panels in one picture
_HEIGHT = 4.6  # cm of a panel
_LETTERS = 100  # in a line of a title
_ROOM = 0.6  # of the heights, above them for the wavelength and below them


def draw(scans: Sequence[tuple[ScanFile, ScanMeasures]]) -> Figure:
    """Draw one panel for each profile.

    Parameters
    ----------
    scans : sequence of (ScanFile, ScanMeasures)
        At most `MOST`.
    """
    figure = style.new(style.WIDE, _HEIGHT * len(scans))
    panels = figure.subplots(len(scans), 1, squeeze=False)[:, 0]
    for axes, (file, scan) in zip(panels, scans, strict=True):
        _panel(axes, file, scan)
        axes.legend(loc="upper right", ncols=3)
    return figure


def _panel(axes: Axes, file: ScanFile, scan: ScanMeasures) -> None:
    unit = f" ({file.unit})" if file.unit else ""
    used = scan.used
    shift = 0.5 * float(file.y[used][0] + file.y[used][-1]) if used.any() else 0.0
    offset, tilt = scan.line if np.isfinite(scan.line).all() else (0.0, 0.0)
    heights = file.z - offset - tilt * file.y
    axes.plot(file.y[used], heights[used], ".", color=style.GREY, ms=1.5, label="points")
    low, high = _limits(heights[used])
    axes.set_ylim(low, high)
    left_out = np.where(np.isfinite(heights), heights, low)[~used]
    axes.plot(
        file.y[~used],
        np.clip(left_out, low, high),
        "x",
        color=style.VERMILLION,
        ms=4.0,
        mew=0.8,
        label="left out",
    )
    if scan.profile is not None:
        y, z = scan.profile.y + shift, scan.profile.z
        axes.plot(y, z, color=style.BLUE, lw=1.0, label="smooth profile")
    if scan.wrinkled:
        _mark(axes, scan, shift, file.unit)
    axes.set_title(_title(file, scan), loc="left", fontsize=7.0)
    axes.set_xlabel(f"$y${unit}")
    axes.set_ylabel(f"$w${unit}")


def _limits(heights: Array) -> tuple[float, float]:
    """Return the range of the heights with room around it."""
    if not len(heights):
        return -1.0, 1.0
    room = max(_ROOM * float(np.ptp(heights)), 1e-9 * float(np.abs(heights).max()), 1e-300)
    return float(heights.min()) - 0.3 * room, float(heights.max()) + room


def _mark(axes: Axes, scan: ScanMeasures, shift: float, unit: str) -> None:
    """Draw amplitude and wavelength as arrows."""
    measures, profile = scan.measures, scan.profile
    if measures is None or profile is None:
        return
    arrow = {"arrowstyle": "<->", "lw": 0.8, "shrinkA": 0.0, "shrinkB": 0.0}
    top = int(np.abs(profile.z).argmax())
    y, height = profile.y[top] + shift, profile.z[top]
    axes.annotate("", (y, 0.0), (y, height), arrowprops=arrow)
    axes.axhline(0.0, color=style.BLACK, lw=0.4, zorder=0)
    peaks = measures.extrema
    k = int(np.argmin(np.abs(0.5 * (peaks[:-2] + peaks[2:]))))
    level = float(profile.z.max() + 0.12 * np.ptp(profile.z))
    left, right = peaks[k] + shift, peaks[k + 2] + shift
    axes.annotate("", (left, level), (right, level), arrowprops=arrow)
    for peak in (left, right):
        tip = float(np.interp(peak - shift, profile.y, profile.z))
        axes.plot([peak, peak], [tip, level], color=style.BLACK, lw=0.4, ls=":")
    _label(axes, 0.5 * (left + right), level, "lambda", measures.wavelength, unit)
    _label(axes, y, 0.5 * height, "A", measures.amplitude, unit, ha="left", va="center")


def _label(
    axes: Axes,
    x: float,
    y: float,
    symbol: str,
    value: float,
    unit: str,
    ha: str = "center",
    va: str = "bottom",
) -> None:
    name = f"\\{symbol}" if len(symbol) > 1 else symbol
    behind = {"facecolor": "white", "alpha": 0.7, "edgecolor": "none", "pad": 0.5}
    words = f"${name} = {value:.4g}$ {unit}".strip()
    axes.annotate(
        words,
        (x, y),
        (3.0 if ha == "left" else 0.0, 2.0),
        textcoords="offset points",
        fontsize=7.0,
        ha=ha,
        va=va,
        bbox=behind,
    )


def _title(file: ScanFile, scan: ScanMeasures) -> str:
    """Return file and verdict, without what would be mathematics to matplotlib."""
    verdict = "wrinkled" if scan.wrinkled else scan.reason
    text = f"{file.path.name}: {verdict}; {scan.left_out} of {len(file.y)} points left out"
    return fill(text, _LETTERS).replace("$", r"\$")
