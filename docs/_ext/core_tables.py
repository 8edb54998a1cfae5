"""Tables of models, parameters, inputs and outputs, made from the core's registry when the pages are built.

No page repeats by hand what the registry states, and a model without a page stops the build.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from clubface import _core


def markdown_table(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> list[str]:
    """Lay out a Markdown table; a bar inside a cell is escaped."""

    def line(cells: Sequence[object]) -> str:
        return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"

    return [line(heads), line(["---"] * len(heads)), *(line(row) for row in rows)]


def number(value: float | None) -> str:
    """Write a bound or default; an absent one stays empty."""
    return "" if value is None else f"{value:.6g}"


def laws(model: dict[str, Any]) -> str:
    """Name the laws a model obeys, and those it obeys only while a parameter is zero."""

    def words(names: Sequence[str]) -> str:
        return ", ".join(name.replace("_", " ") for name in names)

    always = words(model["laws"])
    if not model["laws_without"]:
        return always
    parameter, more = model["laws_without"]
    return f"{always}; with `{parameter}` = 0 also {words(more)}"


class CoreTable(SphinxDirective):
    """A directive whose content is a Markdown table."""

    def table(self) -> list[str]:
        """Lines of the table."""
        raise NotImplementedError

    def run(self) -> list[nodes.Node]:
        """Parse the table as if it stood in the page."""
        holder = nodes.container()
        self.state.nested_parse(StringList(self.table(), source="core"), self.content_offset, holder)
        return holder.children


class ModelList(CoreTable):
    """``{model-list}``: every model, with its page, kind and the laws it obeys."""

    def table(self) -> list[str]:
        """One row a model, in the order of the registry."""
        heads = ("model", "kind", "what it is", "laws it obeys")
        return markdown_table(
            heads,
            (
                (
                    f"[`{model['name']}`](/models/{model['name']}.md)",
                    model["kind"],
                    model["summary"],
                    laws(model),
                )
                for model in _core.models()
            ),
        )


class ModelParameters(CoreTable):
    """``{model-parameters} NAME``: unit, meaning, default, bounds and source of each parameter."""

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a parameter; values in SI."""
        model = next(model for model in _core.models() if model["name"] == self.arguments[0])
        heads = ("parameter", "unit", "meaning", "default", "allowed", "source")
        return markdown_table(
            heads,
            (
                (
                    f"`{p['name']}`",
                    p["unit"],
                    p["meaning"],
                    number(p["default"]),
                    f"{number(p['lower'])} to {number(p['upper'])}",
                    p["source"],
                )
                for p in model["parameters"]
            ),
        )


class Quantities(CoreTable):
    """``{quantities} inputs``: the core's columns; also ``outputs``, ``flight_inputs``, ``flight_outputs``."""

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a quantity, in the order of the columns."""
        quantities = getattr(_core, self.arguments[0])()
        return markdown_table(
            ("name", "unit", "meaning"), ((f"`{q['name']}`", q["unit"], q["meaning"]) for q in quantities)
        )


def every_model_has_a_page(app: Sphinx) -> None:
    """Stop the build if a registered model is not documented."""
    missing = [m["name"] for m in _core.models() if not (Path(app.srcdir) / "models" / f"{m['name']}.md").exists()]
    if missing:
        raise ExtensionError(f"no page in docs/models for: {', '.join(missing)}")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("model-list", ModelList)
    app.add_directive("model-parameters", ModelParameters)
    app.add_directive("quantities", Quantities)
    app.connect("builder-inited", every_model_has_a_page)
    return {"parallel_read_safe": True}
