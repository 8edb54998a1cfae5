"""Formulas of the pages as MathML, written when they are built: no script, nothing from a network, text to select."""

from __future__ import annotations

import re
import unicodedata
from html import escape
from xml.etree import ElementTree

from docutils import nodes
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.application import Sphinx
from sphinx.util import logging
from sphinx.writers.html5 import HTML5Translator

logger = logging.getLogger(__name__)

CHILDREN = {"mfrac": 2, "msub": 2, "msup": 2, "mover": 2, "munder": 2, "mroot": 2, "msubsup": 3, "munderover": 3}
"""Children that elements of MathML must have; a browser shows a fraction of one as it likes."""


def plain(formula: str) -> str:
    r"""Return a formula without what the translator of docutils takes for something else.

    It reads ``\tfrac12 x`` as 12 over x, and ``\boldsymbol\omega`` makes a row of all that follows.
    """
    formula = re.sub(r"(\\[dt]?frac)(\d)(\d)", r"\1{\2}{\3}", formula)
    return re.sub(
        r"\\boldsymbol(?:\\([a-z]+)|{\\([a-z]+)})",
        lambda part: unicodedata.lookup(f"MATHEMATICAL BOLD SMALL {(part[1] or part[2]).upper()}"),
        formula,
    )


def mathml(node: nodes.math | nodes.math_block) -> str:
    """Return a formula as MathML; one that cannot be translated is a warning and stays LaTeX."""
    block = isinstance(node, nodes.math_block)
    try:
        markup = tex2mathml(plain(node.astext()), as_block=block)
        # Of entities only those of XML are known to its parser.
        for element in ElementTree.fromstring(re.sub(r"&(?!lt;|gt;|amp;|#)\w+;", " ", markup)).iter():
            name = element.tag.rpartition("}")[2]
            if len(element) != CHILDREN.get(name, len(element)):
                raise MathError(f"<{name}> of {len(element)} parts")
        return markup
    except MathError as error:
        logger.warning("%s in the formula %s", error, node.astext(), location=node)
        return f"<code>{escape(node.astext())}</code>"


def visit_inline(self: HTML5Translator, node: nodes.math) -> None:
    """Write a formula within a line."""
    self.body.append(mathml(node))
    raise nodes.SkipNode


def visit_block(self: HTML5Translator, node: nodes.math_block) -> None:
    """Write a formula of its own line, which scrolls where the window is narrower."""
    self.body.append(self.starttag(node, "div", CLASS="formula", tabindex="0"))
    self.body.append(mathml(node) + "</div>\n")
    raise nodes.SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the renderer."""
    app.add_html_math_renderer("mathml", (visit_inline, None), (visit_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
