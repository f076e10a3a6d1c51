"""Words and limits that the whole library shares: one place for what may be said of a sheet."""

from typing import Literal, get_args

Parity = Literal["antisymmetric", "symmetric"]
Status = Literal["wrinkled", "flat", "not-converged"]

PARITIES: tuple[Parity, ...] = get_args(Parity)
STATUSES: tuple[Status, ...] = get_args(Status)
