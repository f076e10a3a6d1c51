"""What tells the sheets of a figure apart and what they share, in words for legends."""

from collections.abc import Sequence

from wrinklestudy.results.rows import SheetIdentity, columns
from wrinklestudy.results.sheets import SheetStates
from wrinklestudy.study.figures.style import law_label, short_law_label

_SYMBOLS = {"aspect": "L/W", "thickness": "t/W"}
_ATTRIBUTES = tuple(name for name in columns(SheetIdentity) if name != "material")


def labels(sheets: Sequence[SheetStates]) -> list[str]:
    """Return what tells each sheet from the others; the law if there is only one sheet."""
    varied = [
        name for name in _ATTRIBUTES if len({getattr(sheet, name) for sheet in sheets}) > 1
    ] or ["law"]
    name_of = law_label if varied == ["law"] else short_law_label
    texts = []
    for sheet in sheets:
        parts = [name_of(sheet.law)] if "law" in varied else []
        parts += [
            f"${symbol} = {number(getattr(sheet, name))}$"
            for name, symbol in _SYMBOLS.items()
            if name in varied
        ]
        parts += [getattr(sheet, name) for name in ("bending", "parity") if name in varied]
        texts.append(", ".join(parts))
    if len(set(texts)) < len(texts):
        texts = [f"{sheet.material}: {text}" for sheet, text in zip(sheets, texts, strict=True)]
    return texts


def note(series: Sequence[SheetStates]) -> str:
    """Return what all sheets have in common and their labels leave out."""
    first, parts = series[0], []
    if len({sheet.law for sheet in series}) == 1 and len(series) > 1:
        parts.append(law_label(first.law))
    for name, symbol in _SYMBOLS.items():
        if len({getattr(sheet, name) for sheet in series}) == 1:
            parts.append(f"${symbol} = {number(getattr(first, name))}$")
    for name, default in (("bending", "thinning"), ("parity", "antisymmetric")):
        common = {getattr(sheet, name) for sheet in series}
        if len(common) == 1 and common != {default}:
            parts.append(getattr(first, name))
    return ", ".join(parts)


def number(value: float) -> str:
    """Return a number in mathtext without dollar signs; small numbers as powers of ten."""
    if value >= 0.01:
        return f"{value:g}"
    digits, exponent = f"{value:.6e}".split("e")
    factor = f"{float(digits):g}"
    power = f"10^{{{int(exponent)}}}"
    return power if factor == "1" else rf"{factor} \times {power}"
