"""The published figures, subject by subject, made from the files that the package ships."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from core_tables import CoreTable, markdown_table
from sphinx.application import Sphinx

from clubface import published_data, units
from clubface.inference.evaluation import published
from clubface.published_data import KINDS, PublishedTable
from clubface.shots.measured import QUANTITIES

LONG = 16
"""Rows of a table that is shown folded."""


class PublishedTables(CoreTable):
    """``{published-tables} ball``: all tables of a subject with conditions, caveats and sources."""

    required_arguments = 1

    def table(self) -> list[str]:
        """The tables, in the order of the file."""
        return [
            line for each in published_data.subjects()[self.arguments[0]].values() for line in (*described(each), "")
        ]


class PublishedAccuracyTable(CoreTable):
    """``{published-accuracy} driver``: Tables 2 and 3 (4 and 5) of Caldwell and McPhee, with their marks."""

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a quantity; errors in italics are the least of their table in print."""
        given = [each for each in published().values() if each.club == self.arguments[0]]
        heads = [f"`{each.model}`<br>{each.source if each.source.startswith('Table') else 'thesis'}" for each in given]
        rows = []
        for name, symbol in QUANTITIES.items():
            digits = 0 if symbol == "rpm" else 2

            def shown(values: Mapping[str, float], name: str = name, symbol: str = symbol, digits: int = digits) -> str:
                return f"{units.from_si(values[name], symbol):.{digits}f}"

            cells = []
            for each in given:
                mark = "*" if each.is_least(name) else ""
                spread = f" ± {shown(each.std)}" if each.std else ""
                cells.append(f"{mark}{shown(each.mae)}{mark}{spread}")
            mean = f"{units.from_si(given[0].mean[name], symbol):.4g}"
            rows.append([f"{name.replace('_', ' ')}, {symbol}", mean, *cells])
        return markdown_table(["", "measured", *heads], rows)


def described(each: PublishedTable) -> list[str]:
    """Lay out one table as Markdown; a long one folds away."""
    doubt = f" **In doubt:** {each.caveat}" if each.caveat else ""
    computed = "".join(f" **Not measured:** {name.replace('_', ' ')}. {why}." for name, why in each.derived.items())
    via = f"; read in {each.via}" if each.via else ""
    lines = [
        f"**`{each.name}`** — {each.title}; {KINDS[each.kind]}. {each.conditions}{computed}{doubt}"
        f" *Source:* {each.source}{via}.",
        "",
    ]
    heads = [name.replace("_", " ") + unit(each.units.get(name, "1")) for name in each.columns]
    rows = markdown_table(heads, zip(*(cells(each, name) for name in each.columns), strict=True))
    if len(each) < LONG:
        return lines + rows
    return [*lines, f"<details><summary>{len(each)} rows</summary>", "", *rows, "", "</details>"]


def unit(symbol: str) -> str:
    """Write a unit behind the name of a column; a plain number has none."""
    return "" if symbol == "1" else f", {symbol}"


def cells(each: PublishedTable, column: str) -> Iterable[str]:
    """Write a column as it was printed, in its own unit; nothing where nothing was printed."""
    if column not in each.units:
        return each[column].tolist()
    return ["" if np.isnan(value) else f"{value:.6g}" for value in each.get(column, each.units[column])]


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("published-tables", PublishedTables)
    app.add_directive("published-accuracy", PublishedAccuracyTable)
    return {"parallel_read_safe": True}
