"""Files of a tensile test as laboratories write them, all of one rubber."""

import numpy as np

from wrinklestudy.material.homogeneous import nominal_stress
from wrinklestudy.mechanics.laws import mooney_rivlin

C10, C01 = 4.8e4, 1.31e5
RUBBER = mooney_rivlin(C10, C01)
STRETCH = np.linspace(1.0, 1.6, 31)
GAUGE, WIDTH, THICKNESS = 64.0, 12.0, 0.8  # mm


def stress(stretch=STRETCH, mode="uniaxial"):
    return nominal_stress(RUBBER, stretch, mode)


def lines(names, *columns, separator=",", comma=False, above=()):
    """A table as text; numbers with all digits."""
    rows = [separator.join(repr(float(v)) for v in row) for row in zip(*columns, strict=True)]
    text = "\n".join(rows)
    return "\n".join([*above, names, text.replace(".", ",") if comma else text]) + "\n"


SIZES = ("# gauge length: 64 mm", "# width: 1,2 cm", "# thickness: 800 um")
FORCE = stress() * WIDTH * THICKNESS * 1e-6
FORMATS = {
    "pascals": lines("strain,stress_pa", STRETCH - 1, stress()),
    "stretch": lines("stretch stress_pa", STRETCH, stress(), separator=" "),
    "kilopascals, per cent": lines(
        "strain_percent\tstress_kpa", 100 * (STRETCH - 1), 1e-3 * stress(), separator="\t"
    ),
    "decimal comma": lines(
        "strain;stress_mpa", STRETCH - 1, 1e-6 * stress(), separator=";", comma=True
    ),
    "force": lines("force_n,extension_mm", FORCE, GAUGE * (STRETCH - 1), above=SIZES),
    "machine": "\n".join([*SIZES, "", "Time,Extension,Load", "(s),(mm),(kN)"])
    + "".join(
        f'\n"{k / 50}", "{GAUGE * (lam - 1)!r}" , "{force / 1e3!r}",'
        for k, (lam, force) in enumerate(zip(STRETCH.tolist(), FORCE.tolist(), strict=True))
    ),
    "names with units": lines("Strain (%),Stress (MPa)", 100 * (STRETCH - 1), 1e-6 * stress()),
    "numbered": ",strain,stress_pa\n"
    + "".join(
        f"{k},{lam - 1!r},{pull!r}\n"
        for k, (lam, pull) in enumerate(zip(STRETCH.tolist(), stress().tolist(), strict=True))
    ),
}
