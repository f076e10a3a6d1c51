"""What a material law is: its energy at a point, its constants, its names, and the registry."""

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self, TypeVar

import numpy as np

from wrinklestudy.typing import Array
from wrinklestudy.vocabulary import SHEAR_MODULUS


@dataclass(frozen=True)
class Constant:
    """A physical constant of a law.

    Parameters
    ----------
    name : str
        Name in files, in Python and, after two dashes, on the command line.
    symbol : str
        Mathtext without dollar signs.
    unit : str
        'Pa', or '' for a pure number.
    meaning : str
        What it is, in one line.
    low, high : float
        Bounds; `high` itself is allowed, `low` itself unless `above` is set.
    above : bool
        Whether the constant must be greater than `low`.
    default : float, optional
        Value if none is given; a constant without a default is required.
    fitted : bool
        Whether a fit to data determines it; otherwise a fit leaves it at its default.
    """

    name: str
    symbol: str
    unit: str
    meaning: str
    low: float = -math.inf
    high: float = math.inf
    above: bool = False
    default: float | None = None
    fitted: bool = True

    @property
    def column(self) -> str:
        """Name in files and tables, with the unit: 'c10_pa'."""
        return f"{self.name}_pa" if self.unit == "Pa" else self.name

    @property
    def allowed(self) -> str:
        """The bounds in words: '>= 0 Pa'."""
        unit = f" {self.unit}" if self.unit else ""
        bounds = []
        if math.isfinite(self.low):
            bounds.append(f"{'>' if self.above else '>='} {self.low:g}{unit}")
        if math.isfinite(self.high):
            bounds.append(f"<= {self.high:g}{unit}")
        return " and ".join(bounds) or "a finite number"

    def check(self, value: float) -> None:
        """Raise a ValueError of one line if a value is outside the bounds."""
        inside = self.low < value if self.above else self.low <= value
        if not (math.isfinite(value) and inside and value <= self.high):
            raise ValueError(f"{self.name} = {value:g}: must be {self.allowed}")


class Law(ABC):
    """An isotropic material in plane stress, in units of its initial shear modulus.

    A law is dimensionless, so that only the shape of the energy remains: the ratio C01/C10 for
    Mooney-Rivlin, nothing for neo-Hookean, Poisson's ratio for Saint Venant-Kirchhoff. It is a
    function of the in-plane metric of shape ``(3, ...)`` with components (g11, g22, g12).

    A class is a dataclass. Its fields have the names of the constants, or else `dimensionless` and
    `physical` convert between the two.

    Attributes
    ----------
    name : str
        Name in files, in the config and on the command line.
    label, short_label : str
        For figures.
    constants : tuple of Constant
        Physical constants.
    linear : bool
        Whether the energy is linear in the constants that a fit determines.
    small_strain : bool
        Whether the law describes small strains only, so that it is fitted to the initial slope.
    linear_in_plane : bool
        Whether its strain is linear in the displacement in the plane,
        E = (u_a,b + u_b,a + w,a w,b)/2; 1 + 2 E then takes the place of the metric.
    bendings : tuple of str
        Names of the bending laws that go with it; empty if all do.
    starts : tuple of mappings
        For a law that is not linear: the constants from which fits start, with those in Pa in units
        of the initial shear modulus. During a fit each constant keeps the sign it starts with.
    """

    name: ClassVar[str]
    label: ClassVar[str]
    short_label: ClassVar[str]
    constants: ClassVar[tuple[Constant, ...]]
    linear: ClassVar[bool] = False
    small_strain: ClassVar[bool] = False
    linear_in_plane: ClassVar[bool] = False
    bendings: ClassVar[tuple[str, ...]] = ()
    starts: ClassVar[tuple[Mapping[str, float], ...]] = ()

    @property
    @abstractmethod
    def poisson(self) -> float:
        """Poisson's ratio of the undeformed material."""

    @abstractmethod
    def energy(self, metric: Array) -> Array:
        """Return the strain energy per reference volume, shape ``(...)``."""

    @abstractmethod
    def derivatives(self, metric: Array) -> tuple[Array, Array]:
        """Return dW/dg of shape ``(3, ...)`` and d2W/dg2 of shape ``(3, 3, ...)``."""

    @abstractmethod
    def thickness_stretch(self, metric: Array) -> tuple[Array, Array, Array]:
        """Return lambda3 and its first and second derivatives with respect to the metric."""

    @abstractmethod
    def natural_width(self, stretch: Array) -> Array:
        """Return the transverse stretch under uniaxial tension at a stretch, shape ``(...)``."""

    def stretched(self, along: Array, across: Array) -> tuple[Array, Array]:
        """Return the metric of two principal stretches, (3, ...), and dg11/dlambda of the first."""
        return np.stack([along**2, across**2, np.zeros_like(along)]), 2.0 * along

    @classmethod
    @abstractmethod
    def shear_modulus(cls, constants: Mapping[str, float]) -> float:
        """Return the initial shear modulus in Pa from the physical constants."""

    @classmethod
    def dimensionless(cls, constants: Mapping[str, float], modulus: float) -> Self:
        """Return the law from physical constants and their initial shear modulus."""
        values = {
            constant.name: constants[constant.name] / (modulus if constant.unit == "Pa" else 1.0)
            for constant in cls.constants
        }
        return cls(**values)

    def physical(self, modulus: float) -> dict[str, float]:
        """Return the physical constants of the law with an initial shear modulus in Pa."""
        return {
            constant.name: getattr(self, constant.name) * (modulus if constant.unit == "Pa" else 1)
            for constant in self.constants
        }

    @classmethod
    def check(cls, constants: Mapping[str, float]) -> None:
        """Raise a ValueError of one line if constants are allowed one by one but not together."""
        del constants  # most laws allow whatever is within the bounds

    @classmethod
    def polyconvex(cls, constants: Mapping[str, float]) -> bool | None:
        """Return whether the energy is polyconvex with these constants; None if not known.

        Polyconvex energies are elliptic and have minimisers: J. M. Ball, Arch. Rational Mech. Anal.
        63, 337 (1977).
        """
        del constants
        return None

    @classmethod
    def canonical_order(cls, constants: Mapping[str, float]) -> tuple[str, ...]:
        """Return from which constant each takes its value in the form that fits report.

        This matters for a law that stays the same when some of its constants change places.
        """
        return tuple(constants)

    @classmethod
    def covers(cls, law: "Law") -> bool:
        """Return whether a law belongs to this class, or is a special case of another that does."""
        return type(law) is cls

    @classmethod
    def material(cls, **constants: float) -> "Material":
        """Return a material from physical constants.

        Raises
        ------
        ValueError
            If a constant is missing, unknown or outside its bounds; one line that names it.
        """
        values = dict(constants)
        if unknown := values.keys() - {constant.name for constant in cls.constants}:
            known = ", ".join(constant.name for constant in cls.constants)
            raise ValueError(f"{min(unknown)}: not a constant of {cls.name}, which takes {known}")
        for constant in cls.constants:
            if constant.name not in values:
                if constant.default is None:
                    raise ValueError(f"{constant.name}: {cls.name} needs it")
                values[constant.name] = constant.default
            constant.check(values[constant.name])
        cls.check(values)
        modulus = cls.shear_modulus(values)
        if modulus not in SHEAR_MODULUS:
            given = ", ".join(f"{name} = {value:g}" for name, value in values.items())
            raise ValueError(f"{given}: the initial shear modulus must be {SHEAR_MODULUS}")
        return Material(cls.dimensionless(values, modulus), modulus)

    @classmethod
    def unit_laws(cls) -> "list[Law]":
        """Return one law per constant, in which that constant is 1 and all others are 0.

        The energy of a linear law is the sum of their energies, each times its constant.
        """
        names = [constant.name for constant in cls.constants]
        return [cls(**{name: float(name == constant) for name in names}) for constant in names]


@dataclass(frozen=True)
class Material:
    """A law together with its initial shear modulus.

    Parameters
    ----------
    law : Law
        Dimensionless law.
    shear_modulus : float
        Initial shear modulus in Pa.
    """

    law: Law
    shear_modulus: float

    @property
    def young_modulus(self) -> float:
        """Initial slope of the uniaxial stress-strain curve in Pa: 2 (1 + nu) mu."""
        return 2.0 * (1.0 + self.law.poisson) * self.shear_modulus


# The registry: all laws by name, in the order in which they are offered and drawn.
LAWS: dict[str, type[Law]] = {}

AnyLaw = TypeVar("AnyLaw", bound=type[Law])


def register(law: AnyLaw) -> AnyLaw:
    """Put a class of laws into the registry and return it, so that it can decorate the class.

    Raises
    ------
    ValueError
        If there is already a law of that name.
    """
    if LAWS.setdefault(law.name, law) is not law:
        raise ValueError(f"law {law.name!r}: there is one already")
    return law


def law_of(name: str) -> type[Law]:
    """Return the class of a law.

    Raises
    ------
    ValueError
        If there is no law of that name.
    """
    if name not in LAWS:
        raise ValueError(f"law {name!r} is unknown: allowed are {', '.join(LAWS)}")
    return LAWS[name]


def describe(material: Material) -> dict[str, str | float]:
    """Return the law and its constants as plain values, pascals included.

    A law that is a special case of another is described by the one with fewer constants.
    """
    law = material.law
    kinds = [kind for kind in LAWS.values() if kind.covers(law)]
    if not kinds:
        raise TypeError(f"{type(law).__name__} has no description: not one of {', '.join(LAWS)}")
    kind = min(kinds, key=lambda law: len(law.constants))
    values = law.physical(material.shear_modulus)
    return {"law": kind.name, **{c.column: values[c.name] for c in kind.constants}}


def from_description(values: Mapping[str, Any]) -> Material:
    """Return the material of a description from `describe`; other keys are ignored.

    Raises
    ------
    ValueError
        If the law is unknown or a constant is outside its bounds.
    """
    kind = law_of(values["law"])
    return kind.material(**{c.name: float(values[c.column]) for c in kind.constants})
