"""Group 6: what the bending law does to the strain at which wrinkles vanish."""

from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicSpline

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools.law_curves import AMPLITUDE_MESH, MATERIALS, MESH, LawCurve, curves, softer
from verification.tools.sheets import BENDING_LAWS, THICKNESS
from verification.tools.stretched_stiffness import across_pull, closed_form
from wrinklestudy.mechanics import bending as registry
from wrinklestudy.mechanics.laws import MooneyRivlin
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath, Array

PAPER, OTHERS, NEO, LINEAR = MATERIALS
# What Panaitescu et al. (2019) say: of their own sheet, and of Li and Healey (2016) and Fu et al.
# (2019), who took 10:1
PAPER_DECAY, OTHERS_DECAY = 0.4, 0.3
TWINS_BAR = 5e-3  # of the decay strain, where two laws have the same stiffness across the pull
FAMILIES: dict[str, str] = {
    "thinning": "solid elements; shells of finite membrane strain that follow the thickness "
    "(Abaqus S4R and the like)",
    "fixed-thickness": "Kirchhoff-Love shells with the metric a - 2 zeta b through a thickness "
    "that stays (as in the independent code of the group on independent data)",
    "fvk": "membranes of finite strain with the bending energy of Foppl and von Karman (Healey, "
    "Li and Cheng 2013; Li and Healey 2016; Fu et al. 2019)",
}


_NAMES = {"thinning": "thinning", "fixed-thickness": "fixed thickness", "fvk": "FvK"}

Curves = dict[tuple[str, str], LawCurve]
Decays = dict[tuple[str, str], float]


def quick() -> list[Check]:
    """Return the cheap checks: stretched bending stiffness against the formulas by hand."""
    checks = []
    for name, (material, top) in MATERIALS.items():
        for bending in BENDING_LAWS:
            formula, expected = closed_form(material.law, bending)
            stretches = [1.0 + part * top for part in (0.25, 0.5, 1.0)]
            ratios = [across_pull(material.law, bending, l1) / expected(l1) for l1 in stretches]
            checks.append(
                Check(
                    f"{name}, {bending}: stiffness across the pull over {formula}",
                    max(ratios, key=lambda ratio: abs(ratio - 1.0)),
                    1.0,
                    1e-10,
                    reason="section tangent in uniaxial stretch l against the formula by hand; "
                    f"worst of l = {', '.join(f'{l1:g}' for l1 in stretches)}",
                )
            )
    return checks


def _checks(done: Curves) -> list[Check]:
    softening = []
    for name in MATERIALS:
        reference = done[name, "fvk"]
        for bending in BENDING_LAWS[:2]:
            rows = softer(done[name, bending], reference)
            softening.append(
                Check(
                    f"{name}: (tau fvk / tau {bending})^2 over the ratio of stiffness across the "
                    "pull, largest deviation",
                    max(abs(ratio / stiff - 1.0) for _, ratio, stiff in rows),
                    0.08,
                    kind="at most",
                    reason="tau^2 is stress over bending: what is left is the stretch, which is "
                    "not uniform, and bending along the pull",
                )
            )
    order = [done[PAPER, bending].decay for bending in ("fixed-thickness", "thinning", "fvk")]
    return [
        *softening,
        Check(
            f"{PAPER}: least step of the decay strain in the order fixed, thinning, fvk",
            float(np.min(np.diff(order))),
            0.0,
            kind="more than",
            reason="stiffness across the pull falls in this order at every stretch",
        ),
        Check(
            f"{PAPER}, thinning: decay strain",
            done[PAPER, "thinning"].decay,
            PAPER_DECAY,
            0.02,
            "absolute",
            "the paper: wrinkles persist to about this strain",
        ),
        Check(
            f"{OTHERS}, fvk: decay strain",
            done[OTHERS, "fvk"].decay,
            OTHERS_DECAY,
            0.02,
            "absolute",
            "Li and Healey, Fu et al. with that kind of bending energy, as the paper quotes them",
        ),
        Check(
            f"{NEO}: decay with thinning against fvk",
            done[NEO, "thinning"].decay,
            done[NEO, "fvk"].decay,
            TWINS_BAR,
            reason="both have the initial stiffness across the pull at every stretch",
        ),
        Check(
            f"{LINEAR}: decay with fixed thickness against fvk",
            done[LINEAR, "fixed-thickness"].decay,
            done[LINEAR, "fvk"].decay,
            TWINS_BAR,
            reason="both have the initial stiffness at every stretch",
        ),
    ]


def _table(done: Curves) -> Table:
    rows = []
    for (name, bending), curve in done.items():
        material, _ = MATERIALS[name]
        peak = int(np.argmax(curve.amplitudes))
        at_decay = across_pull(material.law, bending, 1.0 + curve.decay)
        rows.append(
            [
                name,
                bending,
                f"{curve.birth:.5f}",
                f"{curve.decay:.4f}",
                f"{curve.critical.max():.4e}",
                f"{curve.amplitudes[peak]:.3f} at {curve.wrinkled[peak]:.3f}",
                closed_form(material.law, bending)[0],
                f"{at_decay:.3f}",
            ]
        )
    return Table(
        f"Birth and decay at L/W = 2, t/W = {THICKNESS:g}, antisymmetric ({MESH[0]} x {MESH[1]} "
        f"cells; A/t on {AMPLITUDE_MESH[0]} x {AMPLITUDE_MESH[1]})",
        [
            "material", "bending law", "birth", "decay", "largest tau_1/W", "largest A/t",
            "stiffness across the pull", "its value at decay",
        ],
        rows,
    )  # fmt: skip


def _plot(done: Curves, path: Path) -> None:
    lines = dict(zip(BENDING_LAWS, style.looks(["a", "b", "c"]), strict=True))
    with style.applied():
        figure = style.new(1.4 * style.WIDE, 12.0)
        panels = figure.subplots(3, len(MATERIALS), sharex="col", sharey="row")
        for (name, bending), curve in done.items():
            column, look = list(MATERIALS).index(name), lines[bending]
            top, middle, low = panels[:, column]
            options = {
                "color": look.color,
                "linestyle": look.line,
                "label": registry.BENDING_LAWS[bending].label,
            }
            ends = np.array([curve.birth, curve.decay])
            strains = np.concatenate([ends[:1], curve.wrinkled, ends[1:]])
            # A^2 is smooth at both ends, A is not
            squares = np.concatenate([[0.0], curve.amplitudes**2, [0.0]])
            fine, square = _smooth(strains, squares)
            top.plot(fine, np.sqrt(square), **options)
            middle.plot(*_smooth(curve.strains, 1e3 * curve.critical), **options)
            law = MATERIALS[name][0].law
            stiff = [across_pull(law, bending, 1.0 + float(e)) for e in curve.strains]
            low.plot(curve.strains, stiff, **options)
            rows = np.array(softer(curve, done[name, "fvk"])).T
            low.plot(rows[0], rows[1], look.marker, color=look.color, fillstyle="none")
            top.set_title(name, fontsize="medium")
            low.set_xlabel("strain")
        for axes in panels[1]:
            axes.axhline(1e3 * THICKNESS, color=style.GREY, linewidth=0.6)
        panels[0, 0].set_ylabel("A / t")
        panels[1, 0].set_ylabel(r"1000 $\tau_1 / W$")
        panels[2, 0].set_ylabel("bending stiffness")
        panels[0, 0].set_ylim(0.0, None)
        handles, labels = panels[0, 0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper left", ncols=len(labels))
        style.save(figure, path)


def _smooth(strains: Array, values: Array) -> tuple[Array, Array]:
    apart = np.concatenate([[True], np.diff(strains) > 1e-3])  # roots of tau = t lie close by
    fine = np.linspace(strains[0], strains[apart][-1], 400)
    return fine, np.maximum(CubicSpline(strains[apart], values[apart])(fine), 0.0)


def decay_text(decay: Decays, ratios: Mapping[str, float]) -> str:
    """Say where wrinkles vanish, and how much of that is due to the bending law alone.

    Parameters
    ----------
    decay : dict
        Strains of decay by material and bending law.
    ratios : mapping
        C01/C10 of the Mooney-Rivlin materials.
    """

    def decays(name: str) -> str:
        return ", ".join(f"{decay[name, b]:.3f} ({b})" for b in BENDING_LAWS)

    spreads = {
        name: float(np.ptp([decay[name, bending] for bending in BENDING_LAWS]))
        for name in sorted(ratios, key=lambda name: ratios[name])
    }
    grows = all(a < b for a, b in pairwise(spreads.values()))
    return (
        "The strain at which wrinkles vanish, for the constants of the paper "
        f"(C01/C10 = {ratios[PAPER]:.3g}): {decays(PAPER)}. For the 10:1 sheet of other groups "
        f"(C10 = 1/2 - 1/22, C01 = 1/22): {decays(OTHERS)}. Neo-Hookean: {decays(NEO)}. Saint "
        f"Venant-Kirchhoff: {decays(LINEAR)}. The bending law alone moves it by up to "
        f"{max(spreads.values()):.2f}, "
        + conclusion(
            grows, "the more the larger C01/C10 is.", "not always more for larger C01/C10."
        )
    )


def twins_text(decay: Decays) -> str:
    """Say whether bending laws of equal stiffness across the pull have the same decay."""
    cases: tuple[tuple[str, str, str], ...] = (
        (NEO, "thinning", "fvk"),
        (LINEAR, "fixed-thickness", "fvk"),
    )
    worst = max(abs(decay[name, a] / decay[name, b] - 1.0) for name, a, b in cases)
    return (
        "For the neo-Hookean sheet thinning cancels the stiffening in the formula, and for Saint "
        "Venant-Kirchhoff the tangent is constant: "
        + conclusion(
            worst <= TWINS_BAR,
            f"`thinning` and `fvk`, and `fixed-thickness` and `fvk`, agree there to {worst:.1%} of "
            "the decay strain.",
            f"still the pairs of laws differ there by up to {worst:.1%} of the decay strain.",
        )
    )


def disagreement_text(decay: Decays) -> str:
    """Say what constants and bending law contribute to the published disagreement."""
    step = decay[PAPER, "thinning"] - decay[OTHERS, "fvk"]
    published = PAPER_DECAY - OTHERS_DECAY
    by_constants = {b: decay[PAPER, b] - decay[OTHERS, b] for b in BENDING_LAWS}
    others = [decay[OTHERS, bending] for bending in BENDING_LAWS]
    explain = min(by_constants.values()) > 0.5 * published
    varies = max(by_constants.values()) > 1.5 * min(by_constants.values())
    near = max(abs(strain - OTHERS_DECAY) for strain in others) <= 0.5 * published
    return (
        f"The paper sees wrinkles up to about {PAPER_DECAY:g}; it quotes analyses with similar "
        f"dimensions that end near {OTHERS_DECAY:g} and suspects the constants. Computed: from "
        f"10:1 with `fvk` to the paper's constants with `thinning` is a step of {step:.2f}. With "
        "the same law throughout, the constants account for "
        f"{', '.join(f'{v:.2f} ({b})' for b, v in by_constants.items())}. Read: "
        + conclusion(
            explain,
            "the constants explain the disagreement, as the paper suspects",
            "the constants alone do not explain the disagreement with every bending law",
        )
        + conclusion(
            varies,
            ", but how much of it depends on the bending law",
            ", much the same with every bending law",
        )
        + ": with the paper's constants an analysis with `fvk` ends at "
        f"{decay[PAPER, 'fvk']:.2f}, one with a fixed thickness at "
        f"{decay[PAPER, 'fixed-thickness']:.2f}. That the other analyses used `fvk` is the "
        f"inference above; with 10:1 all three laws end between {min(others):.2f} and "
        f"{max(others):.2f}, so that the published strain alone "
        + conclusion(near, "does not tell which law was used.", "rules out some of the laws.")
    )


def _text(done: Curves) -> str:
    decay = {key: curve.decay for key, curve in done.items()}
    families = "\n".join(f"- `{bending}`: {text}." for bending, text in FAMILIES.items())
    ratios = {name: _ratio(name) for name in (PAPER, OTHERS, NEO)}
    return (
        f"**Computed.** {decay_text(decay, ratios)}\n\n"
        "Why: tau_1^2 is compressive stress over bending stiffness, and the stress does not depend "
        "on the bending law. The stiffness that counts is the one across the pull; in uniaxial "
        "stretch l it is 2 (c10 l + c01 l^3) of the initial one with a fixed thickness, "
        "2 (c10 + c01 l^2) with lambda3^2 = 1/l in it, and 1 with `fvk` (c10 + c01 = 1/2). Lines "
        "in the lowest row of the figure are these formulas through the section's tangent, symbols "
        "are (tau_fvk / tau)^2 of the whole clamped sheet; the largest difference is "
        f"{_worst(done):.0%}. {twins_text(decay)} In these formulas only the term with C01 tells "
        f"`thinning` from `fvk`.\n\n"
        "**Which analyses have which law** (an inference from what is published of them; none of "
        f"those codes was run):\n\n{families}\n\n"
        f"**The published disagreement.** {disagreement_text(decay)}"
    )


def _ratio(name: str) -> float:
    law = MATERIALS[name][0].law
    return law.c01 / law.c10 if isinstance(law, MooneyRivlin) else float("nan")


def _worst(done: Curves) -> float:
    rows = [
        row
        for name in MATERIALS
        for bending in BENDING_LAWS
        for row in softer(done[name, bending], done[name, "fvk"])
    ]
    return max(abs(ratio / stiff - 1.0) for _, ratio, stiff in rows)


def run(output: AnyPath) -> None:
    """Compute the group and write it with its figure."""
    output = Path(output)
    done = {(c.material, c.bending): c for name in MATERIALS for c in curves(name)}
    plot = output.with_name("bending_laws.png")
    _plot(done, plot)
    caption = (
        f"Amplitude, critical thickness (line: t/W = {THICKNESS:g}) and bending stiffness across "
        "the pull in parts of the initial one; symbols: what the wrinkles feel, (tau_fvk / tau)^2"
    )
    group = Group(
        "bending_laws",
        "Bending laws",
        _text(done),
        [*quick(), *_checks(done)],
        (_table(done),),
        ((plot.name, caption),),
    )
    write(group, output)
