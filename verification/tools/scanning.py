"""Simulated laser scans: computed profiles with what scanners add to them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.interpolate import CubicSpline

from verification.tools.sheets import LATEX, both_parities, quarter, solved
from wrinklestudy.fem.grid import MeshSettings
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.measure import Measures, measure
from wrinklestudy.metrics.profile import Profile, profile_from_state
from wrinklestudy.metrics.scan import measure_scan
from wrinklestudy.typing import Array

WIDTH = 140.0  # mm: numbers of the size that a scanner gives
STRAINS = (0.06, 0.12, 0.3)
RATIOS = (100, 30, 10, 5)
POINTS = (400, 700, 1200)
QUANTITIES = ("amplitude", "wavelength", "phi_squared")


@dataclass(frozen=True, eq=False)
class ComputedProfile:
    """A computed profile in mm, its measures, and the spline through it."""

    profile: Profile
    measures: Measures
    curve: Callable[[Array], Array]


@dataclass(frozen=True)
class Trial:
    """One simulated scan, measured.

    Parameters
    ----------
    condition : str
        One of `CONDITIONS`.
    ratio : float
        Amplitude over the standard deviation of the noise of a point.
    points : int
    refusal : str
        Why the scan could not be measured; empty if it could.
    deviations, errors : tuple of float
        Measured less true value, and the stated standard error, both in parts of the true value;
        in the order of `QUANTITIES`.
    """

    condition: str
    ratio: float
    points: int
    refusal: str
    deviations: tuple[float, ...]
    errors: tuple[float, ...]

    @property
    def within(self) -> tuple[bool, ...]:
        """Whether the true values lie within two standard errors."""
        pairs = zip(self.deviations, self.errors, strict=True)
        return tuple(abs(deviation) <= 2.0 * error for deviation, error in pairs)


class Setting(NamedTuple):
    """What a scanner of one kind needs to know: heights and lengths in mm."""

    amplitude: float
    wavelength: float
    noise: float


def computed(strains: Sequence[float] = STRAINS) -> list[ComputedProfile]:
    """Return the profiles of both parities of the paper's sheet at some strains."""
    settings = MeshSettings()
    space = quarter(settings.cells_along // 2, settings.cells_across)
    profiles = []
    for strain in strains:
        for state in both_parities(space, strain, LATEX):
            _, _, position = solved(state)
            nodes = space.nodes_from_field(position)
            sheet = DeformedSheet(space.grid, nodes, state.planar.settings.symmetry)
            line = profile_from_state(sheet, per_cell=16)
            profile = Profile(WIDTH * line.y, WIDTH * line.z)
            curve = CubicSpline(profile.y, profile.z)
            profiles.append(ComputedProfile(profile, measure(profile), curve))
    return profiles


def _tilted(y: Array, z: Array, setting: Setting, rng: np.random.Generator) -> Array:
    offset, tilt = setting.amplitude * rng.uniform(-5.0, 5.0, 2)
    return z + offset + tilt * y / float(np.ptp(y))


def _lost(y: Array, z: Array, setting: Setting, rng: np.random.Generator) -> Array:  # noqa: ARG001
    """Lose one point in twenty and a run of one in sixty, for a number or for nothing."""
    z = z.copy()
    sign = float(rng.choice([-9999.0, np.nan]))
    z[rng.integers(0, len(z), len(z) // 20)] = sign
    start = int(rng.integers(0, len(z) - len(z) // 60))
    z[start : start + len(z) // 60] = sign
    return z


def _spiked(y: Array, z: Array, setting: Setting, rng: np.random.Generator) -> Array:  # noqa: ARG001
    z = z.copy()
    places = rng.integers(0, len(z), len(z) // 100)
    z[places] += setting.amplitude * rng.uniform(-8.0, 8.0, len(places))
    return z


def _quantised(y: Array, z: Array, setting: Setting, rng: np.random.Generator) -> Array:  # noqa: ARG001
    step = 2.0 * setting.noise
    return np.round(z / step) * step


def _rippled(y: Array, z: Array, setting: Setting, rng: np.random.Generator) -> Array:
    """Add a regular ripple of a quarter of the wavelength or less, as high as the noise."""
    length = setting.wavelength * rng.uniform(0.08, 0.25)
    height, phase = setting.noise * rng.uniform(0.5, 1.5), rng.uniform(0.0, 2.0 * np.pi)
    return z + height * np.sin(2.0 * np.pi * y / length + phase)


_Change = Callable[[Array, Array, Setting, np.random.Generator], Array]
CONDITIONS: dict[str, tuple[_Change, ...]] = {
    "white noise": (),
    "tilt and offset": (_tilted,),
    "lost points": (_lost,),
    "spikes": (_spiked,),
    "quantised": (_quantised,),
    "short ripple": (_rippled,),
    "all of these": (_tilted, _rippled, _quantised, _spiked, _lost),
}


def scanned(
    true: ComputedProfile, condition: str, ratio: float, points: int, seed: int
) -> tuple[Array, Array]:
    """Return coordinate and deflection of a simulated scan in mm."""
    rng = np.random.default_rng(seed)
    noise = true.measures.amplitude / ratio
    setting = Setting(true.measures.amplitude, true.measures.wavelength, noise)
    y = np.linspace(true.profile.y[0], true.profile.y[-1], points)
    z = true.curve(y) + noise * rng.standard_normal(points)
    for change in CONDITIONS[condition]:
        z = change(y, z, setting, rng)
    return y, z


def trial(true: ComputedProfile, condition: str, ratio: float, points: int, seed: int) -> Trial:
    """Measure a simulated scan."""
    scan = measure_scan(*scanned(true, condition, ratio, points, seed), seed=seed)
    unknown = (float("nan"),) * len(QUANTITIES)
    if scan.measures is None:
        return Trial(condition, ratio, points, scan.reason, unknown, unknown)
    exact = [getattr(true.measures, name) for name in QUANTITIES]
    values = [getattr(scan.measures, name) for name in QUANTITIES]
    errors = [getattr(scan, f"{name}_error") for name in QUANTITIES]
    return Trial(
        condition,
        ratio,
        points,
        scan.reason,
        tuple(value / e - 1.0 for value, e in zip(values, exact, strict=True)),
        tuple(error / e for error, e in zip(errors, exact, strict=True)),
    )


def trials(
    profiles: Sequence[ComputedProfile],
    ratios: Sequence[float] = RATIOS,
    points: Sequence[int] = POINTS,
) -> list[Trial]:
    """Return trials of all combinations, each with random numbers of its own."""
    cases = [
        (true, condition, ratio, count)
        for condition in CONDITIONS
        for ratio in ratios
        for count in points
        for true in profiles
    ]
    return [trial(*case, seed) for seed, case in enumerate(cases)]
