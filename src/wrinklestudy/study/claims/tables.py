"""The study as the claims see it: its sheets and materials, read from the tables."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from os import fspath
from typing import TYPE_CHECKING, Any

import numpy as np

from wrinklestudy.files.storage import read_json
from wrinklestudy.material.result import Fit
from wrinklestudy.mechanics.laws import Material
from wrinklestudy.results.analyses import joined_table
from wrinklestudy.results.materials import is_fit, load_fit, load_material
from wrinklestudy.results.rows import SheetIdentity, columns
from wrinklestudy.results.sheets import MissingError, SheetStates
from wrinklestudy.typing import AnalysisFiles, AnyPath

if TYPE_CHECKING:
    import pandas as pd

_ATTRIBUTES = tuple(name for name in columns(SheetIdentity) if name != "material")
_SYMBOLS = {"aspect": "L/W", "thickness": "t/W"}
# Models of the same material have the same initial modulus, up to rounding
_SAME_MODULUS = 1e-9


@dataclass(frozen=True, eq=False)
class FittedMaterial:
    """A fit of the study.

    Parameters
    ----------
    name : str
        Name in the study.
    fit : Fit
        Constants of the law.
    note : str
        Header of the data to which it was fitted.
    """

    name: str
    fit: Fit
    note: str = ""


@dataclass(frozen=True, eq=False)
class StudyTables:
    """All sheets and materials of a study, with the sheet that the paper is about.

    Parameters
    ----------
    sheets : tuple of SheetStates
    materials : tuple of FittedMaterial
    wanted : tuple of (str, float, float)
        Name of the model, L/W and t/W of the paper's sheet.
    given : mapping
        The materials whose constants are given, by name.
    analyses : mapping
        Files of all analyses of the study, by stage and output.
    """

    sheets: tuple[SheetStates, ...] = field(repr=False)
    materials: tuple[FittedMaterial, ...] = field(repr=False)
    wanted: tuple[str, float, float]
    given: Mapping[str, Material] = field(default_factory=dict, repr=False)
    analyses: AnalysisFiles = field(default_factory=dict, repr=False)

    def table(self, analysis: str) -> "pd.DataFrame":
        """Return the table of an analysis (a stage such as ``map``) over the whole study.

        Raises
        ------
        MissingError
            If the study has none.
        """
        paths = self.analyses.get(analysis, {}).get("table", ())
        if not paths:
            raise MissingError(f"any {analysis}")
        return joined_table(paths)

    @property
    def sheet(self) -> SheetStates:
        """The paper's sheet.

        Raises
        ------
        MissingError
            If the study lacks it.
        """
        for sheet in self.sheets:
            if (sheet.material, sheet.aspect, sheet.thickness) == self.wanted:
                return sheet
        name, aspect, thickness = self.wanted
        raise MissingError(f"sheet {name}, L/W = {aspect:g}, t/W = {thickness:g}")

    @property
    def material(self) -> FittedMaterial:
        """The material of the paper's sheet.

        Raises
        ------
        MissingError
            If its file is not there.
        """
        material = self._material_of(self.sheet)
        if material is None:
            raise MissingError(f"material file of {self.wanted[0]}")
        return material

    def select(self, *varied: str, **fixed: str | float) -> list[SheetStates]:
        """Return the sheets that differ from the paper's sheet only in what is named.

        Parameters
        ----------
        *varied : str
            Attributes that may have any value: law, bending, parity, aspect, thickness.
        **fixed : str or float
            Attributes that have another value than the paper's sheet.

        Returns
        -------
        list of SheetStates
            Sorted by the varied attributes, without repeated combinations. They have the material
            of the paper's sheet or, for another law, one fitted to the same data.
        """
        base = self.sheet
        wanted = {name: getattr(base, name) for name in _ATTRIBUTES if name not in varied} | fixed
        chosen: dict[tuple[Any, ...], SheetStates] = {}
        for sheet in sorted(
            self.sheets, key=lambda sheet: (sheet.material != base.material, sheet.material)
        ):
            matches = all(getattr(sheet, name) == value for name, value in wanted.items())
            if matches and self._related(sheet, base):
                chosen.setdefault(tuple(getattr(sheet, name) for name in _ATTRIBUTES), sheet)
        return sorted(
            chosen.values(), key=lambda sheet: tuple(getattr(sheet, name) for name in varied)
        )

    def sheet_with(self, **fixed: str | float) -> SheetStates:
        """Return the sheet that differs from the paper's sheet in the attributes given.

        Raises
        ------
        MissingError
            If the study lacks it.
        """
        sheets = self.select(**fixed)
        if not sheets:
            which = ", ".join(_attribute_text(name, value) for name, value in fixed.items())
            raise MissingError(f"a sheet like {self.sheet.label} but {which}")
        return sheets[0]

    def sheets_by(self, name: str, **fixed: str | float) -> dict[Any, SheetStates]:
        """Return the sheets that differ from the paper's sheet in one attribute, by its value."""
        return {getattr(sheet, name): sheet for sheet in self.select(name, **fixed)}

    def _related(self, sheet: SheetStates, base: SheetStates) -> bool:
        """Return whether two models have the same material or, for two laws, the same data."""
        if sheet.material == base.material:
            return True
        of_base, of_sheet = self._material_of(base), self._material_of(sheet)
        if of_base is None or of_sheet is None:
            return False
        if sheet.law == base.law:
            return of_base.name == of_sheet.name
        return of_base.fit.source == of_sheet.fit.source

    def _material_of(self, sheet: SheetStates) -> FittedMaterial | None:
        """Return the fitted material of a model: by name or, for a variant, by its modulus."""
        for material in self.materials:
            if material.name == sheet.material:
                return material
        if sheet.material in self.given:
            return None
        moduli = sheet.columns["young_modulus_pa"]
        known = moduli[np.isfinite(moduli)]
        for material in self.materials:
            modulus = material.fit.material().young_modulus
            same = len(known) > 0 and abs(known[0] - modulus) <= _SAME_MODULUS * modulus
            if same and material.fit.law == sheet.law:
                return material
        return None


def load(
    states: AnyPath,
    stability: AnyPath,
    peaks: AnyPath,
    materials: Sequence[AnyPath],
    sheet: tuple[str, float, float],
    analyses: AnalysisFiles | None = None,
) -> StudyTables:
    """Read a study from the tables of the summary stage and its material files.

    Parameters
    ----------
    states, stability, peaks : path-like
        Tables of the summary stage.
    materials : sequence of path-like
        Files of the material stage.
    sheet : tuple of (str, float, float)
        Model, L/W and t/W of the paper's sheet.
    analyses : mapping, optional
        Files of the analyses, by stage and output; read when a claim asks for them.

    Raises
    ------
    ValueError
        If a column is missing, a cell is not what its column allows, or a sheet is missing
        from one of the three tables; one line that names the file.
    """
    from wrinklestudy.results.load import load_study

    sheets = load_study(states, stability, peaks)
    name, aspect, thickness = sheet
    paths = sorted(fspath(path) for path in materials)
    fitted = tuple(
        FittedMaterial(_name(path), load_fit(path), read_json(path).get("source_note", ""))
        for path in paths
        if is_fit(path)
    )
    given = {_name(path): load_material(path) for path in paths if not is_fit(path)}
    wanted = (name, float(aspect), float(thickness))
    return StudyTables(tuple(sheets), fitted, wanted, given, analyses or {})


def _name(path: AnyPath) -> str:
    content = read_json(path)
    if not isinstance(content, dict) or not isinstance(content.get("name"), str):
        raise ValueError(f"{fspath(path)}: key 'name' is missing; not a material file")
    return str(content["name"])


def _attribute_text(name: str, value: str | float) -> str:
    """Return an attribute of a sheet in words, for messages."""
    text = value if isinstance(value, str) else f"{value:g}"
    return f"{_SYMBOLS.get(name, name)} = {text}"
