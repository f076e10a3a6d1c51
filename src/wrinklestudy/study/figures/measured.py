"""Measured data drawn over a figure: black stars, with bars or a band for their error."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes

from wrinklestudy.study.figures.style import BLACK, GREY
from wrinklestudy.study.measurements import Points, Scan
from wrinklestudy.typing import Array

LABEL = "measured"


def bars(
    axes: Axes,
    x: Array,
    y: Array,
    error: Array,
    x_error: Array | None = None,
    label: str | None = LABEL,
    face: str = "white",
) -> None:
    """Draw measured points with bars where the error is known."""
    axes.errorbar(
        x,
        y,
        yerr=error,
        xerr=x_error,
        fmt="*",
        color=BLACK,
        mfc=face,
        ms=5.5,
        mew=0.6,
        elinewidth=0.5,
        zorder=1.5,  # below what is computed
        label=label,
    )


def band(axes: Axes, points: Points, factor: float = 1.0) -> float:
    """Draw measured points against strain on a band of their error; return the highest end."""
    strain, value, error = points.strain, factor * points.value, factor * points.error
    bars(axes, strain, value, error)
    edges = np.unique(strain)
    low = [np.min((value - error)[strain == edge]) for edge in edges]
    high = [np.max((value + error)[strain == edge]) for edge in edges]
    axes.fill_between(edges, low, high, color=GREY, alpha=0.25, lw=0.0, zorder=0)
    return float(np.nanmax([value, value + error]))


def confinement(scans: Sequence[Scan]) -> Points | None:
    """Return Phi^2 of the full width against strain of scanned profiles, None if there are none."""
    if not scans:
        return None
    return Points(
        np.array([scan.strain for scan in scans]),
        np.array([scan.measures.phi_squared for scan in scans]),
        np.array([scan.phi_squared_error for scan in scans]),
    )


def slaving(axes: Axes, scans: Sequence[Scan]) -> tuple[float, float]:
    """Draw A/t against Phi lambda/t of the wrinkled profiles; return the largest of either.

    Filled for Phi over the full width, open for the central wrinkle, as the computed states; the
    relative error of Phi^2 is taken to be the same for both, that of Phi is half of it.
    """
    shown = [scan for scan in scans if scan.wrinkled and scan.measures.phi_squared > 0.0]
    if not shown:
        return 0.0, 0.0
    thickness = np.array([scan.sheet[1] for scan in shown])
    amplitude = np.array([scan.measures.amplitude for scan in shown]) / thickness
    error = np.array([scan.error for scan in shown]) / thickness
    wavelength = np.array([scan.measures.wavelength for scan in shown]) / thickness
    relative = np.array(
        [
            np.hypot(
                scan.wavelength_error / scan.measures.wavelength,
                0.5 * scan.phi_squared_error / scan.measures.phi_squared,
            )
            for scan in shown
        ]
    )
    farthest = 0.0
    for face, label, name in (
        (BLACK, LABEL, "phi_squared"),
        ("white", None, "phi_squared_central"),
    ):
        slaved = wavelength * np.sqrt([getattr(scan.measures, name) for scan in shown])
        bars(axes, slaved, amplitude, error, relative * slaved, label, face)
        farthest = float(np.nanmax([farthest, *slaved]))
    return farthest, float(amplitude.max())
