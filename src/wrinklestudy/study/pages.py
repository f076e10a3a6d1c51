"""Pages from templates: one environment, one way to write numbers, one look.

HTML templates (`*.html.j2`) escape every text that they are given. For Markdown there is no such
rule: the macros for tables and figures escape their texts, and a template writes ``| markdown``
where a text comes from a config, a file or a name.
"""

import math
import re
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined, select_autoescape

from wrinklestudy.study import templates

SHARED = Path(templates.__file__).parent
NO_NUMBER = "no number"

# Characters with a meaning inside a line of Markdown: code, emphasis, links, tables, strikes,
# formulas. Not `*` and `~` between spaces, `_` within a word, `<` and `&` where no HTML can start.
_SPECIAL = re.compile(
    r"[\\`\[\]|$]|[*~](?=\S)|(?<=\S)[*~]|<(?=[A-Za-z/!?])|&(?=[A-Za-z#])"
    r"|(?<![A-Za-z0-9])_|_(?!\w)"
)


def number(value: float | None, form: str = ".6g", missing: str = NO_NUMBER) -> str:
    """Return a number as text; None and NaN are no number.

    Parameters
    ----------
    value : float or None
    form : str
        Format specification.
    missing : str
        Text where there is no number.
    """
    if value is None or math.isnan(value):
        return missing
    return format(value, form)


def markdown(text: object) -> str:
    """Return a text on one line, with everything escaped that would be Markdown or HTML."""
    return _SPECIAL.sub(lambda match: f"\\{match[0]}", " ".join(str(text).split()))


def cell(value: object) -> str:
    """Return the text of a cell of a Markdown table; numbers as `number` writes them."""
    if value is None or isinstance(value, float):
        return number(value)
    return markdown(value)


def code(text: str) -> str:
    """Return a piece of code on one line of Markdown, whatever backticks it has."""
    line = " ".join(text.split())
    longest = max((len(run) for run in re.findall("`+", line)), default=0)
    if not line:
        return "nothing"
    fence = "`" * (longest + 1)
    return f"{fence} {line} {fence}" if longest else f"`{line}`"


def anchor(title: str) -> str:
    """Return the name under which a heading of a Markdown page is linked."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def render(template: str, folder: Path | None = None, /, **values: Any) -> str:
    """Return the text of a page; the same values give the same text.

    Parameters
    ----------
    template : str
        Name of the file, `*.html.j2` or `*.md.j2`.
    folder : path, optional
        Searched for templates before the shared ones.
    **values
        What the template refers to.

    Raises
    ------
    jinja2.UndefinedError
        If the template refers to a value that was not given.
    jinja2.TemplateNotFound
        If there is no such template.
    """
    return _environment(folder).get_template(template).render(values)


@cache
def _environment(folder: Path | None) -> Environment:
    environment = Environment(
        loader=FileSystemLoader([*filter(None, [folder]), SHARED]),
        undefined=StrictUndefined,
        autoescape=select_autoescape(["html.j2"], default=False),
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    filters = {"number": number, "markdown": markdown, "cell": cell, "code": code, "anchor": anchor}
    environment.filters |= filters
    return environment
