"""Words and limits that the whole library shares: one place for what may be said of a sheet."""

from typing import Literal, get_args

Bending = Literal["thinning", "fixed-thickness", "fvk"]
Parity = Literal["antisymmetric", "symmetric"]
Status = Literal["wrinkled", "flat", "not-converged"]

BENDING_LAWS: tuple[Bending, ...] = get_args(Bending)
PARITIES: tuple[Parity, ...] = get_args(Parity)
STATUSES: tuple[Status, ...] = get_args(Status)
