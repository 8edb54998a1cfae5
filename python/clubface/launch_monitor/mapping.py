"""Mapping files: a TOML file that describes the columns of any CSV, so that it is read like a known format.

.. code-block:: toml

    name = "my-monitor"     # optional; the name of the format
    delimiter = ";"         # optional; found out if left out
    decimal = ","           # optional; found out if left out
    club = "Schläger"       # optional: the heading of the column that names the club
    player = "Spieler"      # optional: the heading of the column that names the player
    hand = "Hand"           # optional: the heading of the column that says right or left
    speed_at = "cg"         # optional: where speed, attack and path are measured: "cg" or "face"
    face_at = "face"        # optional: where loft and face angle are measured: "face" (its centre) or "contact"

    [columns.speed]         # a quantity of a delivery or launch
    heading = "Tempo"       # without its unit; case, spaces and punctuation do not count
    unit = "km/h"           # needed if neither the heading nor a row of units names it

    [columns.path]
    heading = "Bahn"
    unit = "deg"
    positive = "in-out"     # the positive side: right if left out; or left, open, toe, heel, up, toe up, ...
    optional = true         # the file may lack it
"""

from __future__ import annotations

import os
from typing import Any, NamedTuple

from clubface.errors import UnitError, UnknownNameError
from clubface.launch_monitor.cells import FACE_TO_PATH, SIDES
from clubface.launch_monitor.formats import CG, CONTACT, FACE, PLAYER, UNKNOWN, Field, Format
from clubface.support.strict_toml import Document
from clubface.tables.headings import HAND, shot_words
from clubface.tables.spelling import plain
from clubface.units import DIMENSIONLESS, unit

KEYS = ("name", "delimiter", "decimal", "club", "player", "hand", "speed_at", "face_at", "columns")
COLUMN_KEYS = ("heading", "unit", "positive", "optional")
DELIMITERS = (",", ";", "\t", "|")
SPEED_AT, FACE_AT = (CG, FACE), (FACE, CONTACT)


class Mapped(NamedTuple):
    """The content of a mapping file.

    Attributes
    ----------
    layout
        The columns.
    delimiter
        The character between cells, or None.
    decimal_comma
        Whether numbers are written with a decimal comma, or None.
    """

    layout: Format
    delimiter: str | None
    decimal_comma: bool | None


def mapping_of(path: str | os.PathLike[str]) -> Mapped:
    """Read a mapping file; an unknown key, quantity, unit or word is an error that names its line."""
    document = Document.read(path)
    data = document.data
    document.check_keys(data, KEYS, ("columns",))
    document.check_text(data, [key for key in KEYS if key != "columns"])
    columns = data["columns"]
    if not isinstance(columns, dict) or not columns:
        raise document.error("columns must be tables of columns, as in [columns.speed]", "columns")
    delimiter = _choice(document, "delimiter", {each: each for each in DELIMITERS})
    decimal = _choice(document, "decimal", {".": False, ",": True})
    if delimiter == "," and decimal and "delimiter" in data:
        raise document.error("decimal and delimiter cannot both be a comma", "decimal")
    quantities = [*(name for name in shot_words().dimensions if name != HAND), FACE_TO_PATH]
    fields: dict[str, Field] = {}
    required: list[str] = []
    for name, column in columns.items():
        if name not in quantities:
            raise document.wrap(UnknownNameError("quantity", name, quantities))
        fields[name] = _field(document, name, column)
        if not column.get("optional", False):
            required.append(column["heading"])
    if not required:
        raise document.error("at least one column must not be optional: the header is known by it", "columns")
    layout = Format(
        name=data.get("name", "mapping"),
        title=data.get("name", f"mapped by {document.path}"),
        fields=fields,
        marks=(tuple(required),),
        club=(data["club"],) if "club" in data else (),
        player=(data["player"],) if "player" in data else PLAYER,
        hand=(data["hand"],) if "hand" in data else (),
        needs_units=True,
        only_own=True,
        speed_at=_choice(document, "speed_at", {each: each for each in SPEED_AT}) or UNKNOWN,
        face_at=_choice(document, "face_at", {each: each for each in FACE_AT}) or UNKNOWN,
    )
    return Mapped(layout, delimiter, decimal)


def _choice(document: Document, key: str, choices: dict[str, Any]) -> Any:
    if key not in document.data:
        return None
    given = document.data[key]
    if given not in choices:
        raise document.error(str(UnknownNameError(key, given, choices)), key)
    return choices[given]


def _field(document: Document, name: str, column: Any) -> Field:
    table = f"columns.{name}"
    if not isinstance(column, dict):
        raise document.error(f"columns.{name} must be a table, as in [columns.{name}]", name, "columns")
    document.check_keys(column, COLUMN_KEYS, ("heading",), table)
    document.check_text(column, ("heading", "unit", "positive"), table)
    if not plain(column["heading"]):
        raise document.error("the heading has no word", "heading", table)
    if not isinstance(column.get("optional", False), bool):
        raise document.error("optional must be true or false", "optional", table)
    dimension = shot_words().dimensions["face" if name == FACE_TO_PATH else name]
    symbol = column.get("unit", "1" if dimension == DIMENSIONLESS else None)
    if symbol is not None:
        try:
            unit(symbol, name="unit", dimension=dimension)
        except UnitError as error:
            raise document.error(str(error), "unit", table) from None
    positive = column.get("positive")
    if positive is not None and plain(positive) not in SIDES.get(name, {}):
        known = SIDES.get(name)
        message = str(UnknownNameError("side", positive, known)) if known else f"{name} has no sides"
        raise document.error(message, "positive", table)
    return Field(column["heading"], unit=symbol, positive=positive)
