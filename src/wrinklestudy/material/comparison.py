"""All laws fitted to the same points, side by side."""

from dataclasses import dataclass

from wrinklestudy.material.choice import Choice, choose
from wrinklestudy.material.data import Measurement, read
from wrinklestudy.material.fit import fit_choice
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import LAWS
from wrinklestudy.typing import AnyPath


@dataclass(frozen=True)
class Unfitted:
    """A law that could not be fitted, and why, in one line."""

    law: str
    reason: str

    def as_dict(self) -> dict[str, str]:
        """Return plain values for JSON."""
        return {"law": self.law, "reason": self.reason}


def compare(data: AnyPath | Measurement, choice: Choice | None = None) -> list[Fit | Unfitted]:
    """Fit every registered law to the same choice of points.

    Returns
    -------
    list
        By AICc, the lowest first; then laws that were fitted to other points (of small strains,
        whose AICc does not compare) and those that could not be fitted.

    Raises
    ------
    ValueError
        If the file or the choice is bad, or no law can be fitted.
    """
    measurement = data if isinstance(data, Measurement) else read(data)
    choice = choice or Choice()
    choose(measurement, choice)  # what is wrong with it is wrong for every law
    results: list[Fit | Unfitted] = []
    for law in LAWS:
        try:
            results.append(fit_choice(measurement, law, choice))
        except ValueError as error:
            results.append(Unfitted(law, str(error)))
    fits = [result for result in results if isinstance(result, Fit)]
    if not fits:
        raise ValueError(f"{measurement.source}: no law can be fitted; {_first(results)}")
    fits.sort(key=lambda one: (one.aicc != one.aicc, one.aicc))
    return [*fits, *(result for result in results if isinstance(result, Unfitted))]


def _first(results: list[Fit | Unfitted]) -> str:
    return next(result.reason for result in results if isinstance(result, Unfitted))
