"""An incompressible Mooney-Rivlin solid at points: stress and tangent of the deformation gradient.

W = c10 (|F|^2 - 3) + c01 (|cof F|^2 - 3) + (p - 2 c10 - 4 c01) (det F - 1) is a polynomial in F;
its stress vanishes where F = 1 and p = 0. The pressure p is a field of its own,
p = K (det F - 1) in the mean over an element.
"""

from typing import NamedTuple

import numpy as np

from wrinklestudy.mechanics.laws import Material
from wrinklestudy.mechanics.laws.mooney_rivlin import MooneyRivlin
from wrinklestudy.typing import Array

_LEVI_CIVITA = np.zeros((3, 3, 3))
for _i, _j, _k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
    _LEVI_CIVITA[_i, _j, _k], _LEVI_CIVITA[_i, _k, _j] = 1.0, -1.0
# (A x B)_iJ = e_imk e_JML A_mM B_kL, as a map from A to the matrix that multiplies B
_CROSS = np.einsum("imk,JML->iJkLmM", _LEVI_CIVITA, _LEVI_CIVITA).reshape(81, 9)


class SolidPoints(NamedTuple):
    """What the law says at points."""

    cofactor: Array  # (9, ...)
    volume: Array  # det F, (...)
    stress: Array  # dW/dF, (9, ...)


class SolidLaw(NamedTuple):
    """Constants in units of the initial shear modulus, c10 + c01 = 1/2."""

    c10: float
    c01: float

    @classmethod
    def of(cls, material: Material) -> "SolidLaw":
        """Return the solid of a material of the library.

        Raises
        ------
        TypeError
            If it is not Mooney-Rivlin or neo-Hookean.
        """
        law = material.law
        if not isinstance(law, MooneyRivlin):
            raise TypeError(f"{law.name}: the solid needs Mooney-Rivlin constants")
        return cls(law.c10, law.c01)

    def points(self, gradient: Array, pressure: Array) -> SolidPoints:
        """Return cofactor, volume and stress from F, (9, ...), and p, (...)."""
        cofactor = 0.5 * _times(_cross(gradient), gradient)
        volume = (cofactor[:3] * gradient[:3]).sum(axis=0)
        stress = 2.0 * self.c10 * gradient + self._pressure(pressure) * cofactor
        if self.c01:
            stress += 2.0 * self.c01 * _times(_cross(gradient), cofactor)
        return SolidPoints(cofactor, volume, stress)

    def tangent(self, gradient: Array, pressure: Array) -> Array:
        """Return d2W/dFdF at fixed p, (9, 9, ...)."""
        crossed = _cross(gradient)
        out = self._pressure(pressure) * crossed
        if self.c01:
            rows = crossed.reshape(9, 9, -1).transpose(2, 0, 1)
            square = (rows @ rows).transpose(1, 2, 0).reshape(crossed.shape)
            cofactor = 0.5 * _times(crossed, gradient)
            out += 2.0 * self.c01 * (square + _cross(cofactor))
        for entry in range(9):
            out[entry, entry] += 2.0 * self.c10
        return out

    def _pressure(self, pressure: Array) -> Array:
        return pressure - 2.0 * self.c10 - 4.0 * self.c01


def _cross(left: Array) -> Array:
    """Return the matrix of the tensor cross product with A, (9, 9, ...)."""
    return (_CROSS @ left.reshape(9, -1)).reshape(9, 9, *left.shape[1:])


def _times(matrix: Array, vector: Array) -> Array:
    product: Array = np.einsum("ab...,b...->a...", matrix, vector)
    return product
