"""Hyperelastic laws in plane stress, as functions of the in-plane metric, and their registry.

One file per law; `docs/recipes/law.md` says how to add one. Config, command line, fits, labels and
files take names, constants and bounds from `LAWS`.
"""

from wrinklestudy.mechanics.laws.base import (
    LAWS,
    Constant,
    Law,
    Material,
    describe,
    from_description,
    law_of,
    register,
)
from wrinklestudy.mechanics.laws.foppl_von_karman import FopplVonKarman, foppl_von_karman
from wrinklestudy.mechanics.laws.incompressible import IncompressibleLaw, Slopes, determinant
from wrinklestudy.mechanics.laws.mooney_rivlin import MooneyRivlin, mooney_rivlin
from wrinklestudy.mechanics.laws.neo_hookean import NeoHookean, neo_hookean
from wrinklestudy.mechanics.laws.ogden import Ogden, ogden
from wrinklestudy.mechanics.laws.saint_venant_kirchhoff import (
    SaintVenantKirchhoff,
    saint_venant_kirchhoff,
)
from wrinklestudy.mechanics.laws.yeoh import Yeoh, yeoh

# The order in which they are offered and drawn.
for law in (MooneyRivlin, NeoHookean, SaintVenantKirchhoff, Yeoh, Ogden, FopplVonKarman):
    register(law)
del law

__all__ = [
    "LAWS",
    "Constant",
    "FopplVonKarman",
    "IncompressibleLaw",
    "Law",
    "Material",
    "MooneyRivlin",
    "NeoHookean",
    "Ogden",
    "SaintVenantKirchhoff",
    "Slopes",
    "Yeoh",
    "describe",
    "determinant",
    "foppl_von_karman",
    "from_description",
    "law_of",
    "mooney_rivlin",
    "neo_hookean",
    "ogden",
    "register",
    "saint_venant_kirchhoff",
    "yeoh",
]
