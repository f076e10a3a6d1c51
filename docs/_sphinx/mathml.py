"""Equations as MathML, which browsers draw themselves: the pages need no script and no network."""

from html import escape
from typing import Any

from docutils import nodes
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util.logging import getLogger

_LOGGER = getLogger(__name__)


def setup(app: Sphinx) -> dict[str, Any]:
    """Make MathML the format of equations in HTML."""
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _inline(translator: Any, node: nodes.math) -> None:
    translator.body.append(_converted(node.astext()))
    raise nodes.SkipNode


def _block(translator: Any, node: nodes.math_block) -> None:
    translator.body.append(f'<div class="math">{_converted(node.astext(), block=True)}</div>\n')
    raise nodes.SkipNode


def _converted(tex: str, block: bool = False) -> str:
    """Return TeX as MathML."""
    try:
        return str(tex2mathml(tex, as_block=block))
    except MathError as error:
        _LOGGER.warning("equation %r: %s", tex, error)
        return f"<code>{escape(tex)}</code>"
