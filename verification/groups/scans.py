"""Group 11: scans of known profiles with noise and faults, and whether the errors cover them."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from verification.checks import Check, Group, Table, conclusion, write
from verification.tools.scanning import (
    CONDITIONS,
    POINTS,
    QUANTITIES,
    RATIOS,
    STRAINS,
    Trial,
    computed,
    trials,
)
from wrinklestudy.study.figures import style
from wrinklestudy.typing import AnyPath

LEAST = 0.9  # of the trials have the true value within two stated standard errors
QUICK_LEAST = 0.8  # of the few trials of the quick checks, of which chance takes some
TIMES = 3.0  # the spread of white noise that the median stated error may be
SPIKES = 2.0  # times that the error of A may be with spikes
FEWEST = 0.02  # of the trials may be refused or taken for noise
SYMBOLS = dict(zip(QUANTITIES, ("A", "lambda", "Phi^2"), strict=True))


def coverage(of: Sequence[Trial]) -> list[float]:
    """Return the part of some trials with the true A, lambda, Phi^2 within two standard errors."""
    return [float(part) for part in np.mean([trial.within for trial in of], axis=0)]


def _spread(of: Sequence[Trial]) -> list[tuple[float, float]]:
    """Return root mean square deviation and median stated error of A, lambda and Phi^2."""
    deviations = np.array([trial.deviations for trial in of])
    errors = np.array([trial.errors for trial in of])
    actual = np.sqrt(np.nanmean(deviations**2, axis=0))
    return list(zip(actual.tolist(), np.nanmedian(errors, axis=0).tolist(), strict=True))


def _coverage_checks(of: Sequence[Trial], least: float) -> list[Check]:
    reason = f"of {len(of)} trials; a normal distribution would have 0.954"
    return [
        Check(f"{SYMBOLS[name]} within two standard errors", part, least, 0.0, "at least", reason)
        for name, part in zip(QUANTITIES, coverage(of), strict=True)
    ]


def _size_checks(of: Sequence[Trial]) -> list[Check]:
    """Return whether the errors of white noise are of the size of the actual deviations."""
    checks = []
    reason = "a stated error that covers everything says nothing"
    for ratio in RATIOS:
        own = [t for t in of if t.condition == "white noise" and t.ratio == ratio]
        for name, (actual, stated) in zip(QUANTITIES, _spread(own), strict=True):
            case = f"white noise, ratio {ratio:g}: median error of {SYMBOLS[name]} over deviation"
            checks.append(Check(case, stated / actual, TIMES, 0.0, "at most", reason))
    return checks


def _spike_check(of: Sequence[Trial]) -> Check:
    """Return whether spikes leave the stated errors as they are without them."""
    with_spikes, without = (
        np.nanmedian([trial.errors[0] for trial in of if trial.condition == condition])
        for condition in ("spikes", "white noise")
    )
    reason = "spikes are left out: they neither move A nor widen its error"
    name = "median error of A with spikes over that of white noise"
    return Check(name, float(with_spikes / without), SPIKES, 0.0, "at most", reason)


def refused(of: Sequence[Trial]) -> float:
    """Return the part of some trials that were refused or taken for noise."""
    return float(np.mean([bool(trial.refusal) for trial in of]))


def _tables(of: Sequence[Trial]) -> list[Table]:
    rows: list[list[float | int | str | None]] = []
    groups: dict[str, list[Trial]] = {"all": list(of)}
    groups |= {name: [t for t in of if t.condition == name] for name in CONDITIONS}
    groups |= {f"A/noise = {ratio:g}": [t for t in of if t.ratio == ratio] for ratio in RATIOS}
    groups |= {f"{count} points": [t for t in of if t.points == count] for count in POINTS}
    for name, own in groups.items():
        cells = [f"{part:.0%}" for part in coverage(own)]
        cells += [f"{actual:.1%} / {stated:.1%}" for actual, stated in _spread(own)]
        rows.append([name, len(own), *cells, sum(bool(t.refusal) for t in own)])
    columns = (
        "trials of",
        "number",
        *(f"{symbol} covered" for symbol in SYMBOLS.values()),
        *(f"{symbol} deviation / error" for symbol in SYMBOLS.values()),
        "no wrinkles told",
    )
    title = (
        "Part of the trials with the true value within two stated standard errors; root mean "
        "square deviation and median stated standard error, in parts of the true value"
    )
    return [Table(title, columns, rows)]


def _plot(of: Sequence[Trial], path: Path) -> None:
    """Draw deviation over stated error against the ratio of signal to noise."""
    rng = np.random.default_rng(0)
    with style.applied():
        figure = style.new(style.WIDE, 5.0)
        panels = figure.subplots(1, len(QUANTITIES), sharey=True)
        labels = ("$A$", r"$\lambda$", r"$\Phi^2$")
        for k, (axes, label) in enumerate(zip(panels, labels, strict=True)):
            x = np.array([t.ratio for t in of]) * np.exp(rng.uniform(-0.15, 0.15, len(of)))
            y = np.array([t.deviations[k] / t.errors[k] for t in of])
            axes.axhspan(-2.0, 2.0, color=style.GREY, alpha=0.2, lw=0.0)
            axes.semilogx(x, y, ".", color=style.BLUE, ms=2.0)
            axes.set(xlabel="$A$/noise of a point", title=label, ylim=(-5.0, 5.0))
        panels[0].set_ylabel("deviation/stated error")
        style.save(figure, path)


def quick() -> list[Check]:
    """Return the checks of few trials on the profiles of one strain."""
    few = trials(computed((STRAINS[1],)), RATIOS[1:], (POINTS[1],))
    return [*_coverage_checks(few, QUICK_LEAST), _spike_check(few)]


def verdict(covered: Sequence[float], missed: float) -> str:
    """Say how often the true values lie within two stated standard errors."""
    parts = ", ".join(
        f"{SYMBOLS[name]} in {part:.1%}" for name, part in zip(QUANTITIES, covered, strict=True)
    )
    good = f"as they must in at least {LEAST:.0%}"
    bad = f"which for one of them is less than the {LEAST:.0%} that it must be"
    return (
        f"The true values lie within two stated standard errors: {parts} of the trials, "
        f"{conclusion(all(part >= LEAST for part in covered), good, bad)}. In {missed:.1%} of "
        "them the wrinkles were not told from the noise."
    )


def run(output: AnyPath) -> None:
    """Write the group: trials of simulated scans."""
    output = Path(output)
    all_trials = trials(computed())
    _plot(all_trials, output.with_name("scans.png"))
    missed = refused(all_trials)
    reason = "wrinkles five times as high as the noise of a point are seen"
    checks = [
        *_coverage_checks(all_trials, LEAST),
        *_size_checks(all_trials),
        _spike_check(all_trials),
        Check("part without wrinkles told", missed, FEWEST, 0.0, "at most", reason),
    ]
    caption = "Deviation from the true value over the stated standard error; grey: within two."
    plots = [("scans.png", caption)]
    text = _text(len(all_trials), verdict(coverage(all_trials), missed))
    title = "Scans with noise"
    write(Group("scans", title, text, checks, _tables(all_trials), plots), output)


def _text(count: int, said: str) -> str:
    strains = ", ".join(f"{strain:g}" for strain in STRAINS)
    ratios = ", ".join(f"{ratio:g}" for ratio in RATIOS)
    return (
        "Computed profiles are scanned: both parities of the latex sheet, L/W = 2, t/W = 1e-3, at "
        f"strains {strains}, in mm for W = 140 mm. Each of {count} trials has {POINTS[0]} to "
        f"{POINTS[-1]} points with white noise at A/noise = {ratios}, and no fault of scanners, "
        "one or all of them: tilt and offset of up to five amplitudes; one point in twenty lost, "
        "and a run of one in sixty; spikes of up to eight amplitudes on one point in a hundred; "
        "steps of twice the noise; a regular ripple of 0.08 to 0.25 wavelengths, as high as the "
        "noise. Each scan is measured by `metrics.scan.measure_scan`, which knows nothing of "
        f"the profile but its points. {said}"
    )
