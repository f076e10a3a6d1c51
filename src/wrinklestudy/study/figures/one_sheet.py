"""Pictures of one sheet: a state with its profile, and where its flat state is unstable."""

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from wrinklestudy.equilibrium.ranges import Stability
from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.metrics.profile import Profile, profile_from_state
from wrinklestudy.metrics.surface import full_surface
from wrinklestudy.results.vtu import LengthUnit
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.oblique import ObliqueView, projected
from wrinklestudy.study.figures.series import number

# Deflections of this part of W are drawn at the most, by one of these factors times a power of ten.
_DRAWN, _FACTORS = 0.05, (1.0, 2.0, 5.0)
_SAMPLES = (480, 600)  # about that many over the whole length and width
_HEADROOM = 1.15


@dataclass(frozen=True)
class PicturedSheet:
    """What pictures say of a sheet.

    Parameters
    ----------
    aspect, thickness : float
        L/W, t/W.
    law : str
        Name of the strain energy.
    unit : LengthUnit
        In which lengths are shown.
    """

    aspect: float
    thickness: float
    law: str
    unit: LengthUnit

    @property
    def is_measured(self) -> bool:
        """Whether lengths are known, not their ratios alone."""
        return self.unit.name == "mm"

    @property
    def note(self) -> str:
        """The sheet as a line of text."""
        law = style.law_label(self.law)
        if not self.is_measured:
            return f"{law}, $L/W = {self.aspect:g}$, $t/W = {number(self.thickness)}$"
        width = self.unit.width
        sizes = {"L": self.aspect * width, "W": width, "t": self.thickness * width}
        return ", ".join([law, *(f"${name} = {size:g}$ mm" for name, size in sizes.items())])


def draw_state(sheet: PicturedSheet, strain: float, shape: DeformedSheet) -> Figure:
    """Draw the lit sheet obliquely from above and its profile half-way between the clamps.

    Parameters
    ----------
    sheet : PicturedSheet
    strain : float
    shape : DeformedSheet
        In units of W.
    """
    profile = profile_from_state(shape)
    height = float(np.abs(profile.z).max())
    flat = height < 1e-6 * sheet.thickness
    view = ObliqueView(exaggeration(height) if not flat else 1.0, sheet.thickness)
    if not flat:
        view = ObliqueView(view.exaggeration, height)
    surface = full_surface(shape, _per_cell(shape))
    tall = 6.2 * max(1.0, 2.0 / sheet.aspect)
    figure = style.new(style.WIDE, tall + 4.0)
    above, below = figure.subplots(2, 1, height_ratios=[tall, 3.2])
    above.set_aspect("equal")
    above.axis("off")
    drawn_points = view.draw(above, surface)
    for end in (0, -1):  # the clamps
        above.plot(*projected(drawn_points[:, end]), color=style.BLACK, lw=2.2, clip_on=False)
    drawn = "flat" if flat else rf"$z$ drawn $\times\,{view.exaggeration:g}$"
    title = rf"{sheet.note}, $\varepsilon = {strain:.6g}$; {drawn}"
    figure.suptitle(title, fontsize=8.0)
    unit = 1.0 / sheet.unit.width if sheet.is_measured else sheet.thickness
    label = "$z$ (mm)" if sheet.is_measured else "$z/t$"
    if not flat:
        figure.colorbar(view.scale(unit), ax=above, shrink=0.7, aspect=20, label=label)
    _profile(below, sheet, profile, flat)
    return figure


def _per_cell(shape: DeformedSheet) -> tuple[int, int]:
    along, across = shape.grid.cells
    return max(1, _SAMPLES[0] // (2 * along)), max(1, _SAMPLES[1] // (2 * across))


def exaggeration(height: float) -> float:
    """Return the largest round factor that draws a height not too high."""
    largest = max(_DRAWN / height, 1.0)
    power = 10.0 ** np.floor(np.log10(largest))
    return float(max(factor * power for factor in _FACTORS if factor * power <= largest))


def _profile(axes: Axes, sheet: PicturedSheet, profile: Profile, flat: bool) -> None:
    width = sheet.unit.width
    scale = width if sheet.is_measured else 1.0 / sheet.thickness
    heights = 0.0 * profile.z if flat else scale * profile.z
    across = (width if sheet.is_measured else 1.0) * profile.y
    axes.axhline(0.0, color=style.GREY, lw=0.5)
    axes.plot(across, heights, color=style.BLUE)
    axes.set_xlim(1.04 * across[0], 1.04 * across[-1])
    if flat:
        axes.set_ylim(-1.0, 1.0)
    axes.set_xlabel("$y$ (mm)" if sheet.is_measured else "$y/W$")
    axes.set_ylabel("$z$ (mm)" if sheet.is_measured else "$z/t$")
    axes.set_title("profile half-way between the clamps", loc="left", fontsize=8.0, pad=3.0)


def draw_stability(sheet: PicturedSheet, found: Stability) -> Figure:
    """Draw tau_1 over strain, the thickness of the sheet and the strains of birth and decay.

    The curve goes through the thicknesses that were computed, which are marked; tau_1^2, which is
    smooth at zero strain too, is interpolated.
    """
    from scipy.interpolate import Akima1DInterpolator

    strains, values = np.array([(0.0, 0.0), *found.critical_thickness]).T
    unit = sheet.unit.width if sheet.is_measured else 1e3
    line = np.linspace(0.0, strains[-1], 801)
    squared = Akima1DInterpolator(strains, values**2, method="makima")(line)
    figure, axes = style.panel(1.6 * style.COLUMN, 6.4)
    axes.plot(line, unit * np.sqrt(np.maximum(squared, 0.0)), color=style.BLUE)
    label = r"critical thickness $\tau_1$"
    axes.plot(strains[1:], unit * values[1:], "o", ms=2.2, color=style.BLUE, label=label)
    thickness = unit * found.thickness
    axes.axhline(thickness, color=style.BLACK, lw=0.8, ls="--", label="thickness of the sheet")
    ends = {"birth": found.birth_strain, "decay": found.decay_strain}
    for name, strain in ends.items():
        if strain is not None:
            axes.plot([strain, strain], [0.0, thickness], color=style.VERMILLION, lw=0.7, ls=":")
            axes.plot([strain], [thickness], "o", color=style.VERMILLION)
            left = strain > 0.8 * strains[-1]
            axes.annotate(
                rf"{name} $\varepsilon = {strain:.4g}$",
                (strain, 0.0),
                xytext=(-2.0 if left else 2.0, 4.0),
                textcoords="offset points",
                rotation=90,
                ha="right" if left else "left",
                fontsize=7,
            )
    _shade_wrinkled(axes, found)
    axes.set_xlim(0.0, 1.02 * strains[-1])
    axes.set_ylim(0.0, _HEADROOM * max(thickness, unit * values.max()))
    axes.set_xlabel(r"strain $\varepsilon$")
    axes.set_ylabel("thickness (mm)" if sheet.is_measured else "$10^3$ thickness$/W$")
    style.grow(figure, style.legend_above(axes, title=sheet.note, columns=3))
    return figure


def _shade_wrinkled(axes: Axes, found: Stability) -> None:
    """Shade the strains between birth and decay, to the end where no decay is known."""
    if found.birth_strain is not None:
        end = found.largest_strain if found.decay_strain is None else found.decay_strain
        axes.axvspan(found.birth_strain, end, color=style.SKY, alpha=0.15, lw=0, label="wrinkled")
