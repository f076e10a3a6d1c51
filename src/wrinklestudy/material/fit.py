"""Fit of a law to measured stress-strain data, and the material file that comes out of it.

The nominal stress of every law is linear in its constants, so that a fit is one bounded linear
least-squares problem with an exact minimum: no start values, no iteration that may stop early.
"""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from wrinklestudy.material.data import Measurement, read
from wrinklestudy.material.homogeneous import MODES, mooney_rivlin_basis, nominal_stress
from wrinklestudy.material.result import CONSTANTS, Fit, material_of
from wrinklestudy.mechanics.laws import LAWS
from wrinklestudy.typing import Array

# Stretches that count as initial when svk is fitted without a window.
INITIAL_STRETCH = (0.8, 1.25)

# Columns (of unit length) with a larger condition number are the same column up to rounding.
_SINGULAR = 1e8


def fit(
    data: str | Path | Measurement,
    law: str,
    *,
    stretch: tuple[float, float] | None = None,
    modes: Sequence[str] | None = None,
) -> Fit:
    """Fit a law to measured nominal stresses by bounded least squares.

    Minimises the sum of (T_law - T)^2, each divided by the square of its standard error where the
    data have one, over constants >= 0, which keeps the law stable (polyconvex energy).

    ``svk`` is fitted to the initial slope: T = Y B0 / 6 + c (B1 - B0) with the columns B of
    `mooney_rivlin_basis` and a free c that carries the curvature of the data, so that Y is the
    intercept of the Mooney plot: exactly 6 (C10 + C01) for data that follow Mooney-Rivlin, within
    1 % for other softening curves over the default window (a stiffening one needs a narrower
    window). Its `rms_pa` is that of the law itself, not of the auxiliary curve.

    The covariance is s^2 (J^T J)^-1 with s^2 = residual sum of squares / (points - free constants);
    with standard errors J is weighted by them and s^2 is at least 1.

    Parameters
    ----------
    data : str, Path or Measurement
        CSV file (see `wrinklestudy.material.data`) or data already read.
    law : str
        One of `LAWS`.
    stretch : tuple of float, optional
        Smallest and largest stretch to use; all points by default, `INITIAL_STRETCH` for ``svk``.
    modes : sequence of str, optional
        Deformation modes to use, all in the file by default.

    Returns
    -------
    Fit

    Raises
    ------
    ValueError
        If the file, law, window or mode is bad, too few points are left, the points cannot tell
        the constants apart, or no constant comes out positive.
    """
    if law not in CONSTANTS:
        raise ValueError(f"law {law!r} is unknown: allowed are {', '.join(LAWS)}")
    measurement = data if isinstance(data, Measurement) else read(data)
    window = INITIAL_STRETCH if law == "svk" and stretch is None else stretch
    used = measurement.select(window, modes)
    design = _design(law, used)
    condition = _check(design, law, used)
    weight = 1.0 if used.standard_error is None else 1.0 / used.standard_error
    estimate, covariance = _least_squares(
        (design.T * weight).T, used.stress * weight, law != "svk", used.standard_error is not None
    )
    names = CONSTANTS[law]
    constants = dict(zip(names, estimate.tolist(), strict=False))
    if not sum(constants.values()) > 0.0:
        raise ValueError(f"{used.source}: the stress does not rise with stretch; no {law} law fits")
    misfit = nominal_stress(material_of(law, constants), used.stretch, used.mode) - used.stress
    return Fit(
        law=law,
        constants=constants,
        covariance=covariance[: len(names), : len(names)],
        at_bound=tuple(name for name in names if constants[name] == 0.0),
        rms_pa=float(np.sqrt(np.mean(misfit**2))),
        count=used.stretch.size,
        stretch_range=(float(used.stretch.min()), float(used.stretch.max())),
        modes=tuple(mode for mode in MODES if mode in used.mode),
        condition_number=condition,
        source=used.source,
    )


def _design(law: str, used: Measurement) -> Array:
    """Return the columns of the fit, shape ``(n, p)``; the constants of the law come first."""
    basis = mooney_rivlin_basis(used.stretch, used.mode)
    if law == "mooney-rivlin":
        return basis
    if law == "neo-hookean":
        return basis[:, :1]
    slope, curvature = basis[:, 0] / 6.0, basis[:, 1] - basis[:, 0]
    # Pure shear alone has no curvature column: the two columns of its basis coincide.
    return np.stack([slope, curvature] if curvature.any() else [slope], axis=1)


def _check(design: Array, law: str, used: Measurement) -> float:
    """Return the condition number of the scaled design, after checking that it has an answer."""
    count, columns = design.shape
    if count <= columns:
        low, high = INITIAL_STRETCH
        hint = f" (default window of svk: {low:g} to {high:g})" if law == "svk" else ""
        raise ValueError(
            f"{used.source}: {count} points in the chosen stretch window and modes; "
            f"a {law} fit needs at least {columns + 1}{hint}"
        )
    length = np.linalg.norm(design, axis=0)
    if not length[0] > 0.0:
        raise ValueError(f"{used.source}: every point chosen is undeformed (stretch 1)")
    singular = np.linalg.svd(design / length, compute_uv=False)
    if not singular[0] < _SINGULAR * singular[-1]:
        modes = ", ".join(mode for mode in MODES if mode in used.mode)
        raise ValueError(
            f"{used.source}: the points chosen ({modes}) cannot tell the constants of {law} apart;"
            " take more modes, a wider stretch window, or law neo-hookean"
        )
    return float(singular[0] / singular[-1])


def _least_squares(
    design: Array, stress: Array, bounded: bool, known_errors: bool
) -> tuple[Array, Array]:
    """Return the estimate ``(p,)`` and its covariance ``(p, p)``, zero for entries on the bound."""
    from scipy.optimize import nnls  # here because it costs more to import than all the rest

    columns = design.shape[1]
    scale = float(np.abs(stress).max()) or 1.0
    free = np.ones(columns, dtype=np.bool_)
    if bounded:
        free = nnls(design, stress / scale)[0] > 0.0
    estimate, covariance = np.zeros(columns), np.zeros((columns, columns))
    if not free.any():
        return estimate, covariance
    q, r = np.linalg.qr(design[:, free])
    estimate[free] = np.linalg.solve(r, q.T @ stress)
    residual = design @ estimate - stress
    # Data that the law interpolates exactly are still known to rounding only.
    variance = max(
        float(residual @ residual) / (stress.size - int(free.sum())),
        (np.finfo(np.float64).eps * scale) ** 2,
    )
    if known_errors:
        variance = max(variance, 1.0)
    inverse = np.linalg.inv(r)
    covariance[np.ix_(free, free)] = variance * (inverse @ inverse.T)
    return estimate, covariance
