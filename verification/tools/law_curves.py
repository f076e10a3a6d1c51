"""Critical thickness and amplitude over strain for each material and bending law."""

from typing import NamedTuple

import numpy as np

from verification.tools.sheets import (
    BENDING_LAWS,
    LATEX,
    NEO_HOOKEAN,
    SVK,
    TEN_TO_ONE,
    THICKNESS,
    amplitude,
    planar_state,
    quarter,
    wrinkled,
)
from verification.tools.stretched_stiffness import across_pull
from wrinklestudy.equilibrium import flat, modes, stability
from wrinklestudy.equilibrium.critical_curve import critical_curve
from wrinklestudy.equilibrium.planar import PlanarSettings
from wrinklestudy.fem.space import Space
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.typing import Array

MESH, AMPLITUDE_MESH = (24, 36), (16, 24)
# Material and largest strain considered
MATERIALS: dict[str, tuple[Material, float]] = {
    "MR of the paper": (LATEX, 0.64),
    "MR 10:1": (TEN_TO_ONE, 0.36),
    "neo-Hookean": (NEO_HOOKEAN, 0.32),
    "SVK": (SVK, 0.15),
}
POINTS, AMPLITUDE_POINTS = 16, 9


class LawCurve(NamedTuple):
    """One material with one bending law."""

    material: str
    bending: str
    strains: Array  # of tau, sorted
    critical: Array  # tau_1/W
    birth: float
    decay: float  # NaN where wrinkles remain
    wrinkled: Array  # strains of the amplitudes
    amplitudes: Array  # A/t

    def tau(self, strain: float) -> float:
        """Return tau_1/W at one of the strains; NaN elsewhere."""
        at = np.flatnonzero(np.abs(self.strains - strain) < 1e-12)
        return float(self.critical[at[0]]) if len(at) else float("nan")


def curves(name: str) -> list[LawCurve]:
    """Return tau_1 and A/t of one material for the three bending laws."""
    material, top = MATERIALS[name]
    space, coarse = quarter(*MESH), quarter(*AMPLITUDE_MESH)
    strains = np.linspace(top / POINTS, top, POINTS)
    known: dict[str, list[tuple[float, float]]] = {bending: [] for bending in BENDING_LAWS}
    for strain in strains:
        state = flat.solve(space, material.law, float(strain))
        for bending in BENDING_LAWS:
            try:
                known[bending].append((float(strain), modes.critical_thickness(state, bending)))
            except ArithmeticError:  # the law leaves no thickness there
                continue
    result = []
    for bending in BENDING_LAWS:
        curve = critical_curve(space, material, PlanarSettings(bending))
        ends = stability.find(curve, THICKNESS, known[bending])
        birth, decay = _number(ends.birth_strain), _number(ends.decay_strain)
        table = np.array([row for row in ends.critical_thickness if row[0] <= top + 1e-9])
        stop = min(top, decay) if np.isfinite(decay) else top
        inside = _strains_between(birth, stop)
        sizes = np.array([_amplitude(coarse, material, e, bending) for e in inside])
        sampled, critical = table.T
        result.append(LawCurve(name, bending, sampled, critical, birth, decay, inside, sizes))
    return result


def _number(value: float | None) -> float:
    return float("nan") if value is None else value


def _strains_between(birth: float, decay: float) -> Array:
    """Return strains from birth to decay, closer at the ends where A goes like a square root."""
    angle = np.linspace(0.0, np.pi, AMPLITUDE_POINTS + 2)[1:-1]
    return birth + 0.5 * (decay - birth) * (1.0 - np.cos(angle))


def _amplitude(space: Space, material: Material, strain: float, bending: str) -> float:
    state = flat.solve(space, material.law, strain)
    return amplitude(
        wrinkled(planar_state(state, material, PlanarSettings(bending, modes=4)), THICKNESS)
    )


def softer(law: LawCurve, reference: LawCurve) -> list[tuple[float, float, float]]:
    """Return strain, (tau of the reference / tau)^2 and the ratio of bending stiffness.

    tau^2 is stress over bending, so that the first ratio is that of the bending stiffness that the
    wrinkles feel; the second is `stretched_stiffness.across_pull` in uniaxial stretch 1 + eps.
    """
    material = MATERIALS[law.material][0].law
    rows = []
    for strain in law.strains:
        ratio = (reference.tau(strain) / law.tau(strain)) ** 2
        if np.isfinite(ratio):
            stretch = 1.0 + float(strain)
            stiff = across_pull(material, law.bending, stretch)
            stiff /= across_pull(material, reference.bending, stretch)
            rows.append((float(strain), float(ratio), stiff))
    return rows
