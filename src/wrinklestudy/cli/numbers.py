"""Numbers on the command line."""

import argparse
import math


def number(text: str) -> float:
    """Return a finite number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"{text.strip()!r} is not a finite number")
    return value


def whole_number(text: str) -> int:
    """Return a whole number."""
    value = number(text)
    if value != round(value):
        raise argparse.ArgumentTypeError(f"{text.strip()!r} is not a whole number")
    return int(value)
