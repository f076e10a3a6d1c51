"""A stress that is there at stretch 1: a preload, or a load cell that was not set to zero.

No law has a stress at rest. Fitted all the same, it goes into the constants: 6 % of the largest
stress make C10 of a Mooney-Rivlin law wrong by 80 %. The stress at rest is extrapolated from small
strains; removing it shifts all stresses of the mode, which is right for an offset of the load cell.
(A specimen that was stretched before its length was taken needs its true length instead.)
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from wrinklestudy.material.data import Measurement
from wrinklestudy.material.estimates import linear_estimate
from wrinklestudy.material.homogeneous import dimensionless_stress
from wrinklestudy.mechanics.laws import MooneyRivlin
from wrinklestudy.typing import Array, Indices

KEEP, REMOVE = TREATMENTS = ("keep", "remove")

# Stretches from which the stress at rest is extrapolated, and which are taken if these are few.
SMALL, _WIDER = (0.8, 1.25), (0.6, 1.7)
_FEW = 5
# Fewer leave the offset no standard error.
_FEWEST = 4
# An offset is told when scatter makes one with less than this probability, and when it exceeds this
# part of the largest stress at small strains: extrapolation of an Ogden or Yeoh curve is off by up
# to 0.5 % of that.
_PROBABILITY, _PART = 0.002, 0.005


@dataclass(frozen=True)
class Offset:
    """Stress at stretch 1 in one mode of deformation.

    Parameters
    ----------
    stress_pa, standard_error_pa : float
    told : bool
        Whether it is more than the scatter and the extrapolation can make.
    """

    stress_pa: float
    standard_error_pa: float
    told: bool


@dataclass(frozen=True, eq=False)
class Extrapolation:
    """An offset and how it follows from the points.

    Parameters
    ----------
    offset : Offset
    rows : (m,) array of int
        The points that it is extrapolated from.
    weights : (m,) array
        The offset per unit of the stress of each of them.
    """

    offset: Offset
    rows: Indices
    weights: Array


def extrapolate(data: Measurement, modes: Sequence[str]) -> dict[str, Extrapolation]:
    """Return the stress at stretch 1 in each mode that has points enough at small strains.

    T = T0 + a B0 + b B1 is fitted to the first loading within `SMALL` (if there are few points, to
    the five nearest to rest), with the stresses B of the
    two invariants of Mooney-Rivlin (B0 and B0/lambda in pure shear, where they are the same): exact
    for Mooney-Rivlin, and of all laws the first two terms in the strain are free.

    Parameters
    ----------
    data : Measurement
        All points of a file.
    modes : sequence of str
        The modes to look at.
    """
    loading, small = data.on("loading", 1), data.within(SMALL)
    found = {}
    for mode in modes:
        own = loading & (data.mode == mode)
        rows = np.flatnonzero(own & small)
        if np.unique(data.stretch[rows]).size < _FEW:
            rows = np.flatnonzero(own & data.within(_WIDER))
            distance = np.abs(np.log(data.stretch[rows]))
            nearest = np.unique(distance)[:_FEW]
            rows = rows[distance <= nearest.max(initial=0.0)]
        if np.unique(data.stretch[rows]).size >= _FEWEST:
            found[mode] = _extrapolated(data.kept(rows), mode, rows)
    return found


def _extrapolated(points: Measurement, mode: str, rows: Indices) -> Extrapolation:
    from scipy.special import stdtrit

    first, second = (
        dimensionless_stress(law, points.stretch, mode) for law in MooneyRivlin.unit_laws()
    )
    if mode == "shear":
        second = first / points.stretch
    design = np.stack([np.ones_like(first), first, second], axis=1)
    design /= np.linalg.norm(design, axis=0)
    unit = float(design[0, 0])
    free = np.full(3, np.inf)
    estimate = linear_estimate(design, points.stress, points.standard_error, -free, free)
    value = float(estimate.values[0]) * unit
    error = float(np.sqrt(estimate.covariance[0, 0])) * unit
    largest = float(np.abs(points.stress).max())
    quantile = float(stdtrit(points.stress.size - 3, 1.0 - 0.5 * _PROBABILITY))
    told = abs(value) > max(quantile * error, _PART * largest)
    weight = np.ones_like(first) if points.standard_error is None else 1.0 / points.standard_error
    weights = np.linalg.pinv((design.T * weight).T)[0] * weight * unit
    return Extrapolation(Offset(value, error, told), rows, weights)


def shifted(data: Measurement, offsets: Mapping[str, Offset]) -> Measurement:
    """Return the data with all stresses of each mode shifted so that its stress at rest is zero."""
    stress = data.stress.copy()
    for mode, offset in offsets.items():
        stress[data.mode == mode] -= offset.stress_pa
    return replace(data, stress=stress)


def removed(
    data: Measurement, modes: Sequence[str], extrapolations: Mapping[str, Extrapolation]
) -> Measurement:
    """Return the data without the stress at stretch 1 in some modes.

    Raises
    ------
    ValueError
        If a mode has too few points at small strains to know it.
    """
    for mode in modes:
        if mode not in extrapolations:
            raise ValueError(
                f"{data.source}: a preload of the {mode} test cannot be removed; its loading needs "
                f"at least {_FEWEST} stretches between {_WIDER[0]:g} and {_WIDER[1]:g}"
            )
    return shifted(data, {mode: extrapolations[mode].offset for mode in modes})


def propagated(
    covariance: Array,
    slopes: Array,
    data: Measurement,
    used: Indices,
    extrapolations: Mapping[str, Extrapolation],
) -> Array:
    """Return the covariance of constants that were fitted after removing offsets.

    The offsets carry the scatter of the same points: with the constants A T of the stresses T of
    all points and the offsets E T, C = s^2 A (1 - E) S (1 - E)^T A^T with the squared standard
    errors S.

    Parameters
    ----------
    covariance : (p, p) array
        s^2 (J^T S^-1 J)^-1, as if the offsets were known.
    slopes : (n, p) array
        J, derivatives of the stress with respect to the constants at the points used.
    data : Measurement
        All points, N.
    used : (n,) array of int
        The points that were fitted.
    extrapolations : dict
        As `extrapolate` returns them.
    """
    error = data.standard_error
    scatter = np.ones_like(data.stress) if error is None else error
    length = np.linalg.norm(slopes, axis=0)
    weighted = (slopes / length).T / scatter[used]
    inverse = np.linalg.inv(weighted @ weighted.T)
    variance = float(covariance[0, 0]) * length[0] ** 2 / inverse[0, 0]
    gain = inverse @ weighted / scatter[used]  # constants, in units of 1/length, per stress
    whole = np.zeros((len(gain), data.stress.size))
    whole[:, used] = gain
    for mode, extrapolation in extrapolations.items():
        total = gain[:, data.mode[used] == mode].sum(axis=1)
        whole[:, extrapolation.rows] -= np.outer(total, extrapolation.weights)
    whole *= scatter
    corrected: Array = variance * (whole @ whole.T) / np.outer(length, length)
    return corrected
