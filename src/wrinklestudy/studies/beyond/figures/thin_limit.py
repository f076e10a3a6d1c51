"""Hidden width of ever thinner sheets, and of the tension field."""

from matplotlib.figure import Figure

from wrinklestudy.studies.beyond.thin_limit import approaches
from wrinklestudy.study.figures import style
from wrinklestudy.study.figures.inputs import Inputs
from wrinklestudy.study.figures.series import number


def draw(inputs: Inputs) -> Figure:
    """Draw Phi^2 over strain for all thicknesses and the field, and what the sheets lack."""
    figure = style.new(style.WIDE, 5.6)
    left, right = figure.subplots(1, 2)
    wrinkled = [sheet for sheet in inputs.series if "wrinkled" in sheet.status]
    sheets = sorted(wrinkled, key=lambda sheet: -sheet.thickness)
    like, fields = inputs.series[0], inputs.table("tension")
    own = fields[(fields["material"] == like.material) & (fields["aspect"] == like.aspect)]
    own = own.sort_values("strain")
    left.plot(own["strain"], own["phi_squared"], "-", color="k", lw=1.2, label="tension field")
    for sheet, look in zip(sheets, style.ordered(len(sheets)), strict=True):
        strain, phi_squared = sheet.wrinkled("strain", "phi_squared")
        label = f"$t/W = {number(sheet.thickness)}$"
        left.plot(strain, phi_squared, look.marker, color=look.color, label=label)
    strains = approaches(sheets, fields, like)
    for each, look in zip(strains, style.ordered(len(strains)), strict=True):
        label = rf"$\varepsilon = {each.strain:g}$"
        right.loglog(each.thickness, each.deficit, look.marker, color=look.color, label=label)
    for each in sorted(strains, key=lambda approach: approach.thickness[0])[:1]:
        span = each.thickness[[0, -1]]
        right.loglog(span, each.deficit[0] * span / span[0], "-", color=style.GREY, lw=0.8)
    left.set_xlabel(r"$\varepsilon$")
    left.set_ylabel(r"$\Phi^2$")
    right.set_xlabel("$t/W$")
    right.set_ylabel(r"$1 - \Phi^2/\Phi^2_\mathrm{field}$")
    if strains:
        right.legend(loc="upper left")
    style.grow(figure, style.legend_above(left, columns=2))
    return figure
