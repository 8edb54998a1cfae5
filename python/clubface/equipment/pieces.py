"""What a ball weighs, and how its mass is spread, from the pieces its file describes; their materials are not read."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

from clubface import units
from clubface.errors import ClubfaceError, FileError, InputError
from clubface.support.strict_toml import Document, quoted


@dataclass(frozen=True)
class Construction:
    """What the file of a ball says to finite elements alone.

    Attributes
    ----------
    data
        The mesh and the pieces, as they were read.
    document
        The whole file, which finite elements read.
    """

    KEYS: ClassVar = ("cube", "element", "pieces")

    data: Mapping[str, Any]
    document: Document = field(compare=False, repr=False)

    @classmethod
    def of(cls, document: Document) -> Construction:
        """Return what a document says of the pieces."""
        return cls({key: value for key, value in document.data.items() if key in cls.KEYS}, document)


class Body(NamedTuple):
    """A ball as a rigid body: mass [kg], moment of inertia about the centre [kg m2]."""

    mass: float
    inertia: float


def body(document: Document, radius: float, mass: float | None) -> Body:
    """Return mass and inertia of the pieces of a file, spheres one around the other.

    The core has the density that makes up the mass, or with None its own.
    """
    core, *around = _tables(document)
    outer, total, inertia = radius, 0.0, 0.0
    for number, piece in reversed(list(enumerate(around, 1))):
        inner = outer - _number(document, piece, number, "thickness", "length")
        if not 0.0 < inner < outer:
            raise document.error("the layers leave no core", "thickness", "pieces", number)
        density = _number(document, piece, number, "density", "density")
        total += density * _volume(inner, outer)
        inertia += density * _second_moment(inner, outer)
        outer = inner
    left = None if mass is None else (mass - total) / _volume(0.0, outer)
    density = _number(document, core, 0, "density", "density") if left is None else left
    if not density > 0.0:
        raise document.error("the layers around it leave the core no mass", "mass")
    return Body(total + density * _volume(0.0, outer), inertia + density * _second_moment(0.0, outer))


def pieces_lines(data: Mapping[str, Any]) -> list[str]:
    """Return the lines of the pieces, as they were read."""
    lines = []
    for piece in data["pieces"]:
        lines += ["[[pieces]]", *toml_lines({key: value for key, value in piece.items() if key != "maxwell"})]
        for branch in piece.get("maxwell", []):
            lines += ["[[pieces.maxwell]]", *toml_lines(branch)]
        lines.append("")
    return lines[:-1]


def toml_lines(values: Mapping[str, Any]) -> list[str]:
    """Return a line for each key."""
    return [f"{key} = {quoted(value) if isinstance(value, str) else repr(value)}" for key, value in values.items()]


def _tables(document: Document) -> Sequence[Mapping[str, Any]]:
    tables = document.data["pieces"]
    if not (isinstance(tables, list) and tables and all(isinstance(each, dict) for each in tables)):
        raise document.error("pieces must be tables, each under [[pieces]]", "pieces")
    return tables


def _number(document: Document, piece: Mapping[str, Any], number: int, key: str, dimension: str) -> float:
    try:
        if key not in piece:
            told = InputError(f"{key} of {piece.get('name', 'the piece')}", None, "give it")
            raise document.error(str(told), "", "pieces", number)
        return units.parse(piece[key], dimension, name=key)
    except FileError:
        raise
    except ClubfaceError as error:
        raise document.wrap(error, "pieces", number) from error


def _volume(inner: float, outer: float) -> float:
    return 4.0 / 3.0 * math.pi * (outer**3 - inner**3)


def _second_moment(inner: float, outer: float) -> float:
    """Return the moment of inertia of a spherical shell over its density [m5]."""
    return 8.0 / 15.0 * math.pi * (outer**5 - inner**5)
