"""The law of Ogden with two terms.

A term depends on the principal stretches through l1^alpha + l2^alpha = a^s + b^s, s = alpha/2,
with the eigenvalues a, b = m +- sqrt(q) of the metric, m = T/2 and q = T^2/4 - D. Derivatives of
the eigenvalues do not exist where these coincide (undeformed, equibiaxial), but S(m, q) = a^s + b^s
is an analytic function of m and q:

    S = 2 m^s sum_k C(s, 2k) r^k,  r = q/m^2.

Near r = 0 this series is summed; elsewhere the powers of a and b = D/a are used.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from wrinklestudy.mechanics.laws.base import Constant, Material
from wrinklestudy.mechanics.laws.incompressible import IncompressibleLaw, Slopes
from wrinklestudy.typing import Array, Mask

# The series is used where r = ((a - b)/(a + b))^2 is below this: beyond it the differences in the
# other formulas lose no more than a digit, and up to it the series needs few terms.
_SMALL = 0.1
_NEGLIGIBLE = 1e-18
_TERMS = 120  # no exponent that is allowed needs more than 100
_LARGEST_EXPONENT = 50.0


@dataclass(frozen=True)
class Ogden(IncompressibleLaw):
    """Incompressible Ogden sheet of two terms in plane stress.

    W = sum_p mu_p/alpha_p (l1^alpha_p + l2^alpha_p + l3^alpha_p - 3), l3 = 1/(l1 l2). With the
    exponents 2 and -2 it is Mooney-Rivlin with C10 = mu1/2, C01 = -mu2/2.

    R. W. Ogden, Large deformation isotropic elasticity, Proc. R. Soc. A 326, 565 (1972).

    Parameters
    ----------
    mu1, alpha1, mu2, alpha2 : float
        Moduli in units of the initial shear modulus sum mu_p alpha_p / 2, and exponents.
    """

    name = "ogden"
    label = "Ogden"
    short_label = "Ogden"
    constants = tuple(
        constant
        for p in (1, 2)
        for constant in (
            Constant(f"mu{p}", rf"\mu_{p}", "Pa", f"modulus of term {p}"),
            Constant(
                f"alpha{p}",
                rf"\alpha_{p}",
                "",
                f"exponent of term {p}: not 0, with the sign of mu{p}",
                -_LARGEST_EXPONENT,
                _LARGEST_EXPONENT,
            ),
        )
    )
    # mu_p alpha_p / 2 is what a term contributes to the initial shear modulus.
    starts = tuple(
        {
            "mu1": 2.0 * (1.0 - share) / first,
            "alpha1": first,
            "mu2": 2.0 * share / second,
            "alpha2": second,
        }
        for first, second, share in (
            (2.0, -2.0, 0.1),
            (5.0, 1.3, 0.9),
            (8.0, 1.3, 0.99),
            (1.5, -4.0, 0.02),
            (4.0, -0.5, 0.5),
            (-0.5, -3.0, 0.5),
        )
    )

    mu1: float
    alpha1: float
    mu2: float
    alpha2: float

    @property
    def terms(self) -> tuple[tuple[float, float], ...]:
        """The pairs (mu_p, alpha_p)."""
        return (self.mu1, self.alpha1), (self.mu2, self.alpha2)

    @classmethod
    def shear_modulus(cls, constants: Mapping[str, float]) -> float:
        """Return sum mu_p alpha_p / 2."""
        return 0.5 * sum(constants[f"mu{p}"] * constants[f"alpha{p}"] for p in (1, 2))

    @classmethod
    def check(cls, constants: Mapping[str, float]) -> None:
        """Refuse an exponent of zero and a term that softens the sheet: mu_p alpha_p < 0."""
        for p in (1, 2):
            modulus, exponent = constants[f"mu{p}"], constants[f"alpha{p}"]
            if exponent == 0.0:
                raise ValueError(f"alpha{p} = 0: must be >= -50 and <= 50, but not 0")
            if modulus * exponent < 0.0:
                allowed = ">= 0 Pa" if exponent > 0.0 else "<= 0 Pa"
                raise ValueError(
                    f"mu{p} = {modulus:g}: must be {allowed} with alpha{p} = {exponent:g}"
                )

    @classmethod
    def polyconvex(cls, constants: Mapping[str, float]) -> bool | None:
        """Return True for exponents of magnitude >= 1 (Ball 1977), mu_p alpha_p >= 0 as allowed."""
        return True if min(abs(constants[f"alpha{p}"]) for p in (1, 2)) >= 1.0 else None

    @classmethod
    def canonical_order(cls, constants: Mapping[str, float]) -> tuple[str, ...]:
        """Return the order in which the term with the larger exponent comes first."""
        if constants["alpha1"] >= constants["alpha2"]:
            return "mu1", "alpha1", "mu2", "alpha2"
        return "mu2", "alpha2", "mu1", "alpha1"

    def density(self, trace: Array, det: Array) -> Array:
        """Return W(T, D)."""
        eigenvalues = _eigenvalues(trace, det)
        total = np.zeros_like(det)
        for modulus, exponent in self.terms:
            s = 0.5 * exponent
            raised = _raised_sum(s, eigenvalues) + np.expm1(-s * np.log(det))
            total = total + _factor(modulus, exponent) * raised
        return total

    def slopes(self, trace: Array, det: Array) -> Slopes:
        """Return the first and second derivatives of W(T, D)."""
        eigenvalues = _eigenvalues(trace, det)
        m = eigenvalues.mean
        sums = [np.zeros_like(det) for _ in range(5)]
        for modulus, exponent in self.terms:
            s, factor = 0.5 * exponent, _factor(modulus, exponent)
            by_m, by_q, by_m2, mixed, by_q2 = _power_sum_slopes(s, eigenvalues)
            pressed = s * det ** (-s - 1.0)  # -d/dD of l3^alpha = D^-s
            # m = T/2 and q = T^2/4 - D
            sums[0] += factor * (0.5 * by_m + m * by_q)
            sums[1] -= factor * (by_q + pressed)
            sums[2] += factor * (0.25 * by_m2 + m * mixed + m * m * by_q2 + 0.5 * by_q)
            sums[3] -= factor * (0.5 * mixed + m * by_q2)
            sums[4] += factor * (by_q2 + (s + 1.0) * pressed / det)
        return Slopes(*sums)


def _factor(modulus: float, exponent: float) -> float:
    """Return mu/alpha, and 0 for alpha = 0, where the term tends to mu ln(l1 l2 l3) = 0."""
    return modulus / exponent if exponent != 0.0 else 0.0


class _Eigenvalues(NamedTuple):
    """The eigenvalues a >= b of metrics."""

    mean: Array  # m
    ratio: Array  # r = q/m^2
    near: Mask  # where the series is used
    large: Array  # a
    less: Array  # b
    gap: Array  # a - b, any positive number where the series is used


def _eigenvalues(trace: Array, det: Array) -> _Eigenvalues:
    mean = 0.5 * trace
    square = mean * mean
    ratio = (square - det) / square
    near = np.real(ratio) < _SMALL
    # Rounding may leave a tiny negative ratio where the eigenvalues coincide.
    half = mean * np.sqrt(np.where(np.real(ratio) > 0.0, ratio, 0.0))
    large = mean + half
    return _Eigenvalues(mean, ratio, near, large, det / large, np.where(near, 1.0, 2.0 * half))


def _raised_sum(s: float, at: _Eigenvalues) -> Array:
    """Return S - 2 = a^s + b^s - 2.

    The powers less one are taken at once: mu_p/alpha_p may be many times the shear modulus, and
    with it the rounding of powers near 1 would hide the energy of a small strain.
    """
    binomials = _binomials(s, 0).copy()
    binomials[0] = 0.0
    raised = np.expm1(s * np.log(at.mean))
    series = 2.0 * (raised + (1.0 + raised) * _polynomial(binomials, at.ratio))
    far = np.expm1(s * np.log(at.large)) + np.expm1(s * np.log(at.less))
    return np.where(at.near, series, far)


def _power_sum_slopes(s: float, at: _Eigenvalues) -> tuple[Array, Array, Array, Array, Array]:
    """Return S_m, S_q, S_mm, S_mq and S_qq of S(m, q) = a^s + b^s.

    In the series S_q has the coefficients s C(s - 1, 2k + 1), and S_mq follows from the others
    because S(c m, c^2 q) = c^s S(m, q).
    """
    m, large, less = at.mean, at.large, at.less
    by_m = s * (large ** (s - 1.0) + less ** (s - 1.0))
    by_m2 = s * (s - 1.0) * (large ** (s - 2.0) + less ** (s - 2.0))
    odd = _binomials(s - 1.0, 1)
    series = s * m ** (s - 2.0) * _polynomial(odd, at.ratio)
    by_q = np.where(at.near, series, s * (large ** (s - 1.0) - less ** (s - 1.0)) / at.gap)
    series = s * m ** (s - 4.0) * _polynomial(odd[1:] * np.arange(1, len(odd)), at.ratio)
    by_q2 = np.where(at.near, series, (by_m2 - 2.0 * by_q) / at.gap**2)
    mixed = (s - 2.0) * by_q / m - 2.0 * m * at.ratio * by_q2
    return by_m, by_q, by_m2, mixed, by_q2


@lru_cache(maxsize=256)
def _binomials(s: float, first: int) -> Array:
    """Return C(s, first), C(s, first + 2), ... as many as matter in a series in r < _SMALL."""
    n = np.arange(_TERMS)
    every = np.concatenate([[1.0], np.cumprod((s - n) / (n + 1.0))])[first::2]
    k = np.arange(len(every))
    needed = np.flatnonzero(np.abs(every) * (k + 1.0) * _SMALL**k > _NEGLIGIBLE)
    return every[: max(needed[-1] if len(needed) else 0, 1) + 1]


def _polynomial(coefficients: Array, x: Array) -> Array:
    total = np.full_like(x, coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        total *= x
        total += coefficient
    return total


def ogden(mu1: float, alpha1: float, mu2: float, alpha2: float) -> Material:
    """Return an incompressible Ogden material from two moduli in Pa and their exponents.

    Raises
    ------
    ValueError
        If mu_p alpha_p is negative for a term, an exponent is 0, or the initial shear modulus
        sum mu_p alpha_p / 2 is not positive.
    """
    return Ogden.material(mu1=mu1, alpha1=alpha1, mu2=mu2, alpha2=alpha2)
