"""Parts of pages that are made while the site is built: what a program can say of itself.

A line ``<!-- generated: NAME -->`` in a page is replaced by what the function of that name returns.
"""

import json
import os
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import redirect_stdout
from io import StringIO
from os.path import relpath
from pathlib import Path
from typing import Any

from pygments.lexers.special import TextLexer
from sphinx.application import Sphinx

ROOT = Path(__file__).parents[2]
STUDIES = (
    ("panaitescu2019", "figures", "figures"),
    ("beyond", "figures/beyond", "beyond"),
    ("literature", "figures/literature", "literature"),
    ("imperfections", "figures/imperfections", "imperfections"),
)
_MARK = re.compile(r"^<!-- generated: (\w+) -->$", flags=re.MULTILINE)
_LINK = re.compile(r"\]\(([^()#:]+\.md)\)")
# Pages of the project that are not in docs/, and the page of the site that has the same
_INSTEAD = {"README.md": "index.md", "data/experiment/README.md": "recipes/measurements.md"}
_WIDTH = "100"  # columns of a help


def setup(app: Sphinx) -> dict[str, Any]:
    """Replace the marks while the pages are read."""
    app.connect("source-read", _replace)
    for language in ("mermaid", "csv"):  # readable as text
        app.add_lexer(language, TextLexer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _replace(app: Sphinx, page: str, source: list[str]) -> None:
    folder = Path(app.srcdir, page).parent

    def inside(link: re.Match[str]) -> str:
        there = (folder / link[1]).resolve()
        for outside, instead in _INSTEAD.items():
            if there == ROOT / outside:
                return f"]({relpath(Path(app.srcdir, instead), folder)})"
        return link[0]

    source[0] = _MARK.sub(lambda mark: PARTS[mark[1]](), source[0])
    source[0] = _LINK.sub(inside, source[0])


def command_line() -> str:
    """Return the help of every command."""
    from wrinklestudy.cli.parser import COMMANDS

    parts = [f"```text\n{_help()}\n```"]
    for name, command in COMMANDS.items():
        title = f"## wrinklestudy {name}"
        parts.append(f"{title}\n\n{_sentence(command.help)}\n\n```text\n{_help(name)}\n```")
    return "\n\n".join(parts)


def _help(*words: str) -> str:
    from wrinklestudy.cli.parser import parse

    text = StringIO()
    before = os.environ.get("COLUMNS")
    os.environ["COLUMNS"] = _WIDTH
    try:
        with redirect_stdout(text):
            parse([*words, "--help"])
    except SystemExit:
        pass
    finally:
        os.environ.pop("COLUMNS")
        if before is not None:
            os.environ["COLUMNS"] = before
    return text.getvalue().strip()


def config() -> str:
    """Return all keys of the config, from config/schema.json."""
    schema = json.loads((ROOT / "config" / "schema.json").read_text(encoding="utf-8"))
    parts = [_table(schema)]
    for name, block in schema["$defs"].items():
        parts.append(
            f"## {_block_title(name)}\n\n{_sentence(block['description'])}\n\n{_table(block)}"
        )
    return "\n\n".join(parts)


def _table(block: Mapping[str, Any]) -> str:
    rows = ["| key | meaning | allowed | if left out |", "|---|---|---|---|"]
    required = block.get("required", ())
    for key, entry in block["properties"].items():
        default = json.dumps(entry["default"]) if "default" in entry else ""
        left_out = {"": "", "null": "none"}.get(default, f"`{default}`")
        left_out = "required" if key in required else left_out
        words = _sentence(entry.get("description", ""))
        rows.append(f"| `{key}` | {words} | {_allowed(entry)} | {left_out} |")
    return "\n".join(rows)


def _allowed(entry: Mapping[str, Any]) -> str:
    """Return in words what a schema allows."""
    if "$ref" in entry:
        title = _block_title(entry["$ref"].rpartition("/")[2])
        return f"[{title}](#{title.lower().replace(' ', '-')})"
    if "enum" in entry:
        return ", ".join(f"`{value}`" for value in entry["enum"])
    for several in ("anyOf", "oneOf"):
        if several in entry:
            choices = [choice for choice in entry[several] if choice.get("type") != "null"]
            return " or ".join(_allowed(choice) for choice in choices)
    kind = entry.get("type")
    if kind == "array":
        items = entry.get("items") or entry["prefixItems"][0]
        return f"list of {_allowed(items)}"
    if kind == "object":
        blocks = [_allowed(named) for named in entry.get("patternProperties", {}).values()]
        return f"names with {' or '.join(blocks)}" if blocks else "block"
    word = {"string": "text"}.get(str(kind), str(kind))
    return f"{word} {', '.join(_bounds(entry))}".strip()


def _bounds(entry: Mapping[str, Any]) -> Iterator[str]:
    words = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}
    for name, sign in words.items():
        if name in entry:
            yield f"{sign} {entry[name]:g}"


def _block_title(name: str) -> str:
    return {
        "AnalysisBlock": "Maps and tension",
        "FigureSheetBlock": "Sheet of the figures",
        "StrainRange": "Range of strains",
    }.get(name, name.removesuffix("Block"))


def gallery() -> str:
    """Return the figures that were computed, with captions, or how to compute them."""
    from wrinklestudy.study.loading import load_catalogue

    parts = []
    for study, folder, target in STUDIES:
        pictures = sorted((ROOT / folder).glob("*.png"))
        catalogue = load_catalogue(study)
        entries = {figure.name: figure for figure in catalogue.figures}
        parts.append(f"## {catalogue.title}")
        if not pictures:
            parts.append(
                f"These figures had not been computed when this site was built: `make {target}` "
                "makes them, then `make docs` shows them here."
            )
        for picture in pictures:
            if picture.stem not in entries:
                continue
            entry = entries[picture.stem]
            shown = f"![{_plain(entry.caption)}](../../{folder}/{picture.name})"
            source = f"`{folder}/{picture.stem}.pdf`, made by `make {target}`"
            parts += [f"### {entry.title}", shown, f"{entry.caption} ({source})"]
    return "\n\n".join(parts)


def measurements() -> str:
    """Return data/experiment/README.md without its title."""
    text = (ROOT / "data" / "experiment" / "README.md").read_text(encoding="utf-8")
    return text.partition("\n")[2].strip()


def _plain(text: str) -> str:
    return re.sub(r"[\[\]\n]", " ", text)


def _sentence(text: str) -> str:
    """Return a text as it may stand in a cell of a table."""
    return text[:1].upper() + text[1:].replace("|", r"\|")


PARTS: dict[str, Callable[[], str]] = {
    "command_line": command_line,
    "config": config,
    "gallery": gallery,
    "measurements": measurements,
}
