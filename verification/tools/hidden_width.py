"""The width that the wrinkles of a stretched sheet hide, in the limit of no thickness."""

import numpy as np

from verification.tools.biquadratic import Elements, relax
from wrinklestudy.mechanics.laws import IncompressibleLaw
from wrinklestudy.mechanics.relaxed import principal_stretches
from wrinklestudy.typing import Array

_SAMPLES = 50  # for each cell of the line X = 0
_CLAMP_ZONE = 0.25  # of the first guess


def phi_squared(law: IncompressibleLaw, strain: float, x: Array, y: Array) -> float:
    """Return Phi^2 on X = 0 of a clamped sheet, solved on biquadratic elements.

    Phi^2 is the integral of n - sqrt(b), where positive, over the width that the line X = 0 has
    after the deformation; b is the smaller squared stretch and n = a^(-1/4) the natural width.

    Parameters
    ----------
    law : IncompressibleLaw
    strain : float
        eps of the clamps.
    x, y : (n,) arrays
        Grid lines of the quarter 0 <= X <= L/2, 0 <= Y <= W/2.
    """
    elements = Elements(x, y)
    along, across = elements.nodes
    far = 1.0 - np.exp(-(x[-1] - along) / _CLAMP_ZONE)
    width = 1.0 + ((1.0 + strain) ** -0.5 - 1.0) * far
    start = np.stack([(1.0 + strain) * along, width * across])
    free = np.ones(start.shape, dtype=bool)
    free[0, np.isclose(along, 0.0)] = free[1, np.isclose(across, 0.0)] = False
    free[:, np.isclose(along, x[-1])] = False
    position = relax(elements, law, start, free).position
    (p, q), lengths = elements.on_line(position, 0, 0.0, _SAMPLES)
    metric = np.stack([(p * p).sum(axis=0), (q * q).sum(axis=0), (p * q).sum(axis=0)])
    stretches = principal_stretches(metric)
    excess = stretches.larger**-0.25 - np.sqrt(stretches.smaller)
    projected = float((np.sqrt(metric[1]) * lengths).sum())
    return float((np.maximum(excess, 0.0) * lengths).sum()) / projected
