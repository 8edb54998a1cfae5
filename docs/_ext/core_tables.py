"""Tables of models, parameters, inputs, outputs and errors, made from the package itself when the pages are built.

No page repeats by hand what the registry states or the models compute, and a model without a page stops the build.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import ClassVar

from docutils import nodes
from docutils.statemachine import StringList
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

from clubface import _core, units
from clubface.equipment.models import model, models
from clubface.equipment.parameters import builtin_sets
from clubface.inference.evaluation import published
from clubface.present.terminal import headings_and_rows
from clubface.results.table import Table
from clubface.schema import file_schema, key_rows
from clubface.shots.measured import QUANTITIES
from clubface.validation import benchmark_data, tour, tour as tour_averages
from clubface.validation.tour import mean_table

NBSP = "\N{NO-BREAK SPACE}"


def markdown_table(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> list[str]:
    """Lay out a Markdown table; a bar inside a cell is escaped."""

    def line(cells: Sequence[object]) -> str:
        return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"

    return [line(heads), line(["---"] * len(heads)), *(line(row) for row in rows)]


def result_table(table: Table) -> list[str]:
    """Lay out a table of a result in Markdown, with the units people read."""
    heads, rows = headings_and_rows(table)
    return markdown_table([f"{words} ({unit})" if unit else words for words, unit in heads], rows)


class CoreTable(SphinxDirective):
    """A directive whose content is a Markdown table."""

    stacked: ClassVar = False
    """Whether each row is a block on a phone, as suits a table of descriptions."""

    def table(self) -> list[str]:
        """Lines of the table."""
        raise NotImplementedError

    def run(self) -> list[nodes.Node]:
        """Parse the table as if it stood in the page."""
        holder = nodes.container()
        lines = ["{.stacked}", *self.table()] if self.stacked else self.table()
        self.state.nested_parse(StringList(lines, source="core"), self.content_offset, holder)
        return holder.children


class ModelList(CoreTable):
    """``{model-list}``: every model, with its page, kind and the laws it obeys."""

    stacked = True

    def table(self) -> list[str]:
        """One row a model, in the order of the registry."""
        heads = ("model", "kind", "what it is", "laws it obeys")
        return markdown_table(
            heads,
            (
                (f"[`{name}`](/models/{name}.md)", each.kind, each.summary, each.laws_in_words)
                for name, each in models().items()
            ),
        )


class ModelParameters(CoreTable):
    """``{model-parameters} NAME``: the parameters of a model, then every published set with its sources and caveats."""

    required_arguments = 1

    def table(self) -> list[str]:
        """Values in SI."""
        chosen = model(self.arguments[0])
        meanings = markdown_table(
            ("parameter", "meaning", "allowed"),
            (
                (f"`{p.name}`", p.meaning, f"{p.lower:.6g} to {p.upper:.6g} {p.unit.removeprefix('1')}".strip())
                for p in chosen.parameters
            ),
        )
        sets = builtin_sets(chosen.name)
        values = markdown_table(
            ("published value", *(f"[{index}]" for index, _ in enumerate(sets, 1))),
            ((f"`{p.name}`", *(f"{one.values[p.name]:.6g}" for one in sets)) for p in chosen.parameters),
        )
        lines = [*meanings, "", *values, ""]
        for index, one in enumerate(sets, 1):
            club = "any club" if one.club == "any" else f"the {one.club}"
            lines.append(
                f"* [{index}] `{one.name}`, for {club}{', used by default' if one.default else ''}. {one.source}."
            )
            lines += [f"  * {caveat}" for caveat in one.caveats]
            lines += [f"  * `{name}`: {caveat}" for name, caveat in one.value_caveats.items()]
        return lines


class KeyTable(CoreTable):
    """``{key-table} club``: the keys of a kind of file; with a second name those of one table in it, to a depth."""

    stacked = True
    required_arguments = 1
    optional_arguments = 1
    option_spec: ClassVar = {"depth": int}

    def table(self) -> list[str]:
        """One row a key."""
        name, *table = self.arguments
        prefix = f"{table[0]}." if table else ""
        rows = []
        for key, allowed, meaning in key_rows(file_schema(name)):
            inner = key.replace("`", "").split(" or ")[0]
            depth = inner.removeprefix(prefix).count(".") + 1
            if inner.startswith(prefix) and depth <= self.options.get("depth", depth):
                rows.append((key.replace(f"`{prefix}", "`"), allowed, meaning))
        return markdown_table(("key", "allowed", "meaning"), rows)


class Quantities(CoreTable):
    """``{quantities} inputs``: the core's columns; also ``outputs``, ``flight_inputs``, ``flight_outputs``."""

    stacked = True
    required_arguments = 1

    def table(self) -> list[str]:
        """One row a quantity, in the order of the columns."""
        quantities = getattr(_core, self.arguments[0])()
        return markdown_table(
            ("name", "unit", "meaning"),
            ((f"`{q['name']}`", q["unit"].replace(" ", NBSP), q["meaning"]) for q in quantities),
        )


class TourComparison(CoreTable):
    """``{tour-comparison} pga-2019 spin``: published value and model less published; computed by the build.

    In place of a quantity, ``lofts`` shows dynamic lofts, ``published_ratios`` and ``own_ratios`` I w / (m R v_t).
    """

    required_arguments = 2

    def table(self) -> list[str]:
        """One row a club that any model has a figure of; the page says the unit."""
        result, name = compared(self.arguments[0]).to_result(), self.arguments[1]
        heads, rows = headings_and_rows(result.table(name))
        words = [each for each, _ in heads]
        if name == "lofts":
            words = ["club", "published", "possible", *words[4:]]
            rows = [[club, known, f"{a} to {b}", *rest] for club, known, a, b, *rest in rows]
        return markdown_table(words, (row for row in rows if any(row[2:])))


class TourSummary(CoreTable):
    """``{tour-summary}``: each model's mean absolute errors over all rows of all tables."""

    def table(self) -> list[str]:
        """One row a model."""
        means = mean_table([compared(name) for name in tour_averages.TABLES])
        every = [row for row, name in enumerate(means["averages"].values) if name == "all"]
        return result_table(replace(means, columns=means.columns[1:], shown_rows=every))


class BenchmarkMeans(CoreTable):
    """``{benchmark-means}``: the mean launches of the benchmark shots, next to the published ones."""

    def table(self) -> list[str]:
        """One row a launch quantity."""
        heads, columns = ["mean of"], []
        for club in benchmark_data.CLUBS:
            heads.append(f"{club}: published, made up")
            given = next(each for each in published().values() if each.club == club)
            measured = benchmark_data.load(club).measured.launches
            columns.append((given.mean, {name: float(abs(measured[name]).mean()) for name in QUANTITIES}))
        rows = []
        for name, unit in QUANTITIES.items():
            digits = 0 if unit == "rpm" else 2
            pairs = [[f"{units.from_si(each[name], unit):.{digits}f}" for each in column] for column in columns]
            rows.append([f"{name.replace('_', ' ')}, {unit}", *(", ".join(pair) for pair in pairs)])
        return markdown_table(heads, rows)


@cache
def compared(table: str) -> tour.Tour:
    """Every model on the published deliveries of a table."""
    return tour.tour(table=table)


def every_model_has_a_page(app: Sphinx) -> None:
    """Stop the build if a registered model is not documented."""
    missing = [name for name in models() if not (Path(app.srcdir) / "models" / f"{name}.md").exists()]
    if missing:
        raise ExtensionError(f"no page in docs/models for: {', '.join(missing)}")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("model-list", ModelList)
    app.add_directive("model-parameters", ModelParameters)
    app.add_directive("key-table", KeyTable)
    app.add_directive("quantities", Quantities)
    app.add_directive("tour-comparison", TourComparison)
    app.add_directive("tour-summary", TourSummary)
    app.add_directive("benchmark-means", BenchmarkMeans)
    app.connect("builder-inited", every_model_has_a_page)
    return {"parallel_read_safe": True}
