"""What tension field theory predicts of a thin sheet that is not itself solved."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from wrinklestudy.mechanics import laws
from wrinklestudy.results.rows import Row, described
from wrinklestudy.vocabulary import STATUSES, Status

if TYPE_CHECKING:
    from wrinklestudy.equilibrium.envelope import ThinWrinkles
    from wrinklestudy.equilibrium.tension_field import TensionField

METHOD = "far-from-threshold"


@dataclass(frozen=True)
class PredictionRow(Row):
    """The far-from-threshold prediction for one sheet and strain: limit plus one wavelength."""

    material: str = described("name of the material", identifies=True)
    law: str = described("law of the strain energy", identifies=True)
    bending: str = described("bending law", identifies=True)
    aspect: float = described("L/W", identifies=True)
    thickness: float = described("t/W", identifies=True)
    strain: float = described("eps = (L' - L)/L of the clamps", identifies=True, shown=True)
    method: str = described("far-from-threshold: predicted, not solved", shown=True)
    status: Status = described(  # noqa: RUF009 (a field with metadata, like all the others)
        "wrinkled, flat (the tension field hides no width, or too little) or not-converged",
        allowed=STATUSES,
        shown=True,
    )
    amplitude_over_thickness: float | None = described(
        "A/t, largest amplitude of the envelope on X = 0", shown=True
    )
    wavelength_over_width: float | None = described(
        "lambda/W at the centre of the deformed sheet", shown=True
    )
    phi_squared: float | None = described("Phi^2 of the tension field on X = 0", shown=True)
    arc_width_over_width: float | None = described("W_arc/W of the tension field", shown=True)
    projected_width_over_width: float | None = described(
        "W_proj/W of the tension field", shown=True
    )
    nominal_stress_pa: float | None = described(
        "clamp force over undeformed cross-section, of the tension field", "Pa", shown=True
    )
    reason: str = described("why it did not converge; empty if it did", shown=True)


def prediction_row(
    field: "TensionField",
    wrinkles: "ThinWrinkles | None",
    material: laws.Material,
    bending: str,
    thickness: float,
) -> PredictionRow:
    """Return a prediction as a row.

    Parameters
    ----------
    field : TensionField
    wrinkles : ThinWrinkles or None
        None where there are none or the field did not converge.
    material : Material
    bending : str
        The bending law.
    thickness : float
        t/W.
    """
    from wrinklestudy.metrics.confinement import confinement

    law = str(laws.describe(material)["law"])
    row = PredictionRow(
        material=law,
        law=law,
        bending=bending,
        aspect=field.space.grid.aspect,
        thickness=thickness,
        strain=field.strain,
        method=METHOD,
        status="not-converged",
        amplitude_over_thickness=None,
        wavelength_over_width=None,
        phi_squared=None,
        arc_width_over_width=None,
        projected_width_over_width=None,
        nominal_stress_pa=None,
        reason=field.reason,
    )
    if not field.converged:
        return row
    measured = confinement(field)
    row = replace(
        row,
        status="flat",
        amplitude_over_thickness=0.0,
        phi_squared=measured.phi_squared,
        arc_width_over_width=measured.arc_width,
        projected_width_over_width=measured.projected_width,
        nominal_stress_pa=field.force * material.shear_modulus,
    )
    if wrinkles is None:
        return row
    return replace(
        row,
        status="wrinkled",
        amplitude_over_thickness=wrinkles.largest_amplitude / thickness,
        wavelength_over_width=wrinkles.wavelength,
    )
