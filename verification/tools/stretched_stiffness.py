"""Bending stiffness across the pull of a sheet in uniaxial tension, for each law."""

from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq

from wrinklestudy.mechanics.laws import Law, MooneyRivlin, SaintVenantKirchhoff
from wrinklestudy.mechanics.section import Section
from wrinklestudy.typing import Array

_THICKNESS = 1.0e-3  # drops out of the ratio


def uniaxial(law: Law, stretch: float) -> Array:
    """Return the metric (3, 1) at a stretch along x where the stress across vanishes."""

    def across(square: float) -> float:
        return float(law.derivatives(np.array([[stretch**2], [square], [0.0]]))[0][1, 0])

    return np.array([[stretch**2], [brentq(across, 0.05, 1.5, xtol=1e-15, rtol=1e-14)], [0.0]])


def across_pull(law: Law, bending: str, stretch: float) -> float:
    """Return d2 psi / db22^2 at a stretch in parts of that of the undeformed sheet.

    Curvatures are second derivatives with respect to the undeformed coordinates, so that the
    value is the one that counts for wrinkles of a given number.
    """
    section = Section(law, _THICKNESS, bending)

    def stiffness(at: float) -> float:
        metric = uniaxial(law, at)
        return float(section.derivatives(metric, np.zeros_like(metric)).bending[1, 1, 0])

    return stiffness(stretch) / stiffness(1.0)


def closed_form(law: Law, bending: str) -> tuple[str, Callable[[float], float]]:
    """Return the same ratio by hand, as a text and as a function of the stretch l.

    Mooney-Rivlin: d2W/dg22^2 = 2 (c10 l + c01 l^3) with c10 + c01 = 1/2, lambda3^2 = 1/l. Saint
    Venant-Kirchhoff with nu = 1/2: constant, lambda3^2 = 1 - (l^2 - 1)/2.
    """
    if bending == "fvk":
        return "1", lambda _: 1.0
    if isinstance(law, SaintVenantKirchhoff):
        if bending == "fixed-thickness":
            return "1", lambda _: 1.0
        return "(3 - l^2) / 2", lambda stretch: 0.5 * (3.0 - stretch**2)
    if not isinstance(law, MooneyRivlin):
        raise TypeError(f"no closed form for {type(law).__name__}")
    first, second = law.c10, law.c01
    if bending == "fixed-thickness":
        return "2 (c10 l + c01 l^3)", lambda l1: 2.0 * (first * l1 + second * l1**3)
    return "2 (c10 + c01 l^2)", lambda l1: 2.0 * (first + second * l1**2)
