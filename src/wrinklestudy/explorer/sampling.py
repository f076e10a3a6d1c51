"""Shapes as a page keeps them: few samples of a quarter, which the page mirrors, in few bytes."""

from base64 import b64encode
from dataclasses import dataclass
from typing import Any

import numpy as np

from wrinklestudy.metrics.interpolant import DeformedSheet
from wrinklestudy.typing import Array

PROFILE_POINTS = 241  # on half the width
_PLANE = (25, 25)  # samples of the smooth x and y of a quarter, along the pull and across
_LARGEST = 32767


@dataclass(frozen=True)
class Samples:
    """How many samples of z a quarter has, along the pull and across."""

    along: int
    across: int

    @property
    def letters(self) -> int:
        """Letters that the z of a state takes."""
        return 4 * -(-2 * self.along * self.across // 3)


# What the eye sees comes first; the coarser ones are for studies with many states. Plotly itself
# refines surfaces of fewer than about 80 lines, which takes it longer than to draw them.
SAMPLES = (Samples(41, 121), Samples(41, 91), Samples(41, 61), Samples(31, 41))


def packed_shape(shape: DeformedSheet, flat: bool, samples: Samples) -> dict[str, Any]:
    """Return the samples of a state: profile, x and y of the quarter, and z unless it is flat.

    Parameters
    ----------
    shape : DeformedSheet
        Solved on the quarter, in units of W.
    flat : bool
        Whether the state is flat: what is left of a seed is no wrinkle.
    samples : Samples
        Of z.
    """
    ends = float(shape.grid.x[-1]), float(shape.grid.y[-1])
    line = shape.evaluate(np.zeros(1), np.linspace(0.0, ends[1], PROFILE_POINTS))[:, 0]
    x, y = (np.linspace(0.0, end, count) for end, count in zip(ends, _PLANE, strict=True))
    packed = {
        "profile": [_single(line[1]), _single(np.zeros_like(line[2]) if flat else line[2])],
        "plane": [_scaled(part) for part in shape.evaluate(x, y)[:2]],
    }
    if not flat:
        counts = (samples.along, samples.across)
        x, y = (np.linspace(0.0, end, count) for end, count in zip(ends, counts, strict=True))
        packed["height"] = [_scaled(shape.evaluate(x, y)[2])]
    return packed


def _single(values: Array) -> dict[str, Any]:
    """Return numbers in single precision."""
    return {"single": b64encode(values.astype("<f4").tobytes()).decode("ascii")}


def _scaled(values: Array) -> dict[str, Any]:
    """Return a table as whole numbers of 16 bits times a step."""
    step = float(np.abs(values).max()) / _LARGEST or 1.0
    whole = np.round(values / step).astype("<i2")
    text = b64encode(whole.tobytes()).decode("ascii")
    return {"step": step, "shape": list(values.shape), "whole": text}
