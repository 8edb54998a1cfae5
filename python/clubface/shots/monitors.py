"""The layouts of launch monitor files, ``FORMATS`` by name, and ``TABLE`` for all other tables.

A layout is a file in ``data/monitors`` with the fields of :class:`Format`. ``TABLE`` covers clubface's own tables and
those of other programs with the usual column names, using the common vocabulary of
:mod:`clubface.shots.tables.headings`. As the program is unknown, every quantity must have a unit, and columns of the
same quantity must agree.
"""

from __future__ import annotations

import tomllib
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

from clubface.results.notes import note
from clubface.results.result import Result
from clubface.results.table import Table, table, text
from clubface.shots.formats import CG, FACE, Field, Format, common_names
from clubface.shots.tables.headings import HAND, plain, shot_words
from clubface.support.checks import Frozen, check_choice
from clubface.support.files import DATA
from clubface.units import DIMENSIONLESS

__all__ = ["FORMATS", "format_result", "formats_result"]

_NAMES = ("trackman", "foresight", "foresight-2020", "garmin", "rapsodo", "flightscope", "gspro", "square")
"""Layouts in the order in which they are listed and recognised."""


def _read(path: Path) -> Format:
    """Return the layout described by a file of the package."""
    given: dict[str, Any] = tomllib.loads(path.read_text(encoding="utf-8"))
    fields = {
        name: Field(*each["headings"], unit=each.get("unit"), positive=each.get("positive"))
        for name, each in given.pop("columns").items()
    }
    marks = tuple(map(tuple, given.pop("marks")))
    options: dict[str, Any] = {name: tuple(each) if isinstance(each, list) else each for name, each in given.items()}
    return Format(fields=fields, marks=marks, **options)


FORMATS: Mapping[str, Format] = Frozen({name: _read(DATA / "monitors" / f"{name}.toml") for name in _NAMES})


def _fields() -> dict[str, Field]:
    """Return the columns of all measured quantities and of club and ball properties."""
    dimensions = shot_words().dimensions
    headings = {name: quantity for name, (quantity, _) in common_names().items()}
    headings |= {plain(name): name for name in dimensions if name != HAND}
    return {
        quantity: Field(
            *(name for name, each in headings.items() if each == quantity),
            unit="1" if dimensions.get(quantity) == DIMENSIONLESS else None,
        )
        for quantity in dict.fromkeys(headings.values())
    }


TABLE = Format(
    name="clubface",
    title="table of shots",
    fields=_fields(),
    file=("File",),
    needs_units=True,
    all_columns=True,
    speed_at=CG,
    face_at=FACE,
)
"""The common layout; club data refers to the CG and face centre unless columns ``speed_at`` and ``face_at`` differ."""


def formats_result() -> Result:
    """Return the known layouts by name; JSON and files also have their columns."""
    return Result(
        "monitor-formats",
        "Files of launch monitors",
        tables=(_layouts_table(FORMATS.values()), _columns_table(FORMATS.values(), printed=False)),
        hints=(note("monitor-any-other-file"),),
    )


def format_result(name: str) -> Result:
    """Return the columns of a layout; an unknown name raises an :class:`UnknownNameError`."""
    check_choice("format", name, FORMATS)
    layout = FORMATS[name]
    return Result(
        "monitor-format",
        f"{layout.title}; {layout.source}",
        tables=(_columns_table([layout]), _layouts_table([layout], printed=False)),
    )


def _layouts_table(layouts: Collection[Format], **options: Any) -> Table:
    labels = {"name": "format", "title": "written by"}
    return table(
        "formats",
        *(text(name, [getattr(each, name) for each in layouts], label=labels.get(name, ""), printed=name in labels)
          for name in ("name", "title", "speed_at", "face_at", "source")),
        **options,
    )  # fmt: skip


def _columns_table(layouts: Collection[Format], **options: Any) -> Table:
    rows = [(each.name, quantity, field) for each in layouts for quantity, field in each.fields.items()]
    fields = [field for _, _, field in rows]
    return table(
        "columns",
        text("format", [name for name, _, _ in rows], printed=False),
        text("quantity", [quantity for _, quantity, _ in rows]),
        text("headings", [", ".join(each.shown) for each in fields], label="columns"),
        text("unit", [each.unit or "as the file says" for each in fields], label="unit unless named"),
        text("positive", [each.positive or "" for each in fields]),
        **options,
    )
