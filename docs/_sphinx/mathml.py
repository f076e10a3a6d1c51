"""Equations as MathML, which browsers draw themselves: the pages need no script and no network."""

from typing import Any

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx


def setup(app: Sphinx) -> dict[str, Any]:
    """Make MathML the format of equations in HTML."""
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    app.config.html_math_renderer = "mathml"
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _inline(translator: Any, node: nodes.math) -> None:
    translator.body.append(_converted(node.astext()))
    raise nodes.SkipNode


def _block(translator: Any, node: nodes.math_block) -> None:
    translator.body.append(f'<div class="math">{_converted(node.astext(), block=True)}</div>\n')
    raise nodes.SkipNode


def _converted(tex: str, block: bool = False) -> str:
    """Return TeX as MathML, with the TeX as an annotation that can be copied."""
    return tex2mathml(tex, as_block=block).replace("<math ", '<math role="math" ', 1)
