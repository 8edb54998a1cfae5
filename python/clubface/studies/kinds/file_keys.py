"""Keys of files as inputs that a study sweeps: each value of a ball or of a head, checked as if its file held it."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.fem.balls import PieceRecord
from clubface.schema import Choice, Document, PhysicalValue, Record, Table, Value
from clubface.schema.document import KeyPath
from clubface.schema.values import Tables
from clubface.studies.axes import Swept

__all__ = ["VariedFile", "short_names", "swept_keys"]


PIECES: KeyPath = ("pieces",)
"""The list of tables that go by their own names alone."""
NOT_SWEPT = ("kind", "law")
"""Choices that decide which other keys there are."""


@dataclass(frozen=True)
class FileKey:
    """A key of a file that may be swept: where it stands, and the kind of its value."""

    path: KeyPath
    kind: Value

    @property
    def swept(self) -> Swept:
        """What it is as an input of a study."""
        if isinstance(self.kind, PhysicalValue):
            return Swept(units.SI_UNITS[self.kind.dimension])
        if isinstance(self.kind, Choice):
            return Swept(None, tuple(self.kind.known))
        schema = self.kind.json()
        return Swept("1", limits=(schema.get("minimum", 0), schema.get("maximum", 10**6)))

    def written(self, value: float | str) -> float | int | str:
        """Return a value as the file would hold it: in SI."""
        counted = not isinstance(value, str) and not isinstance(self.kind, PhysicalValue)
        return int(value) if counted else value


@dataclass(frozen=True)
class VariedFile:
    """A file some of whose values are swept.

    Attributes
    ----------
    document
        The file.
    table
        The kind of its content.
    group
        What stands before the name of a key at its top, as in ``ball_cube``. Keys of its tables are named by table and
        key, as in ``thickness_face_centre`` and ``trims_toe_x``, and those of pieces by their name, as in ``core_c10``.
    """

    document: Document
    table: Table
    group: str

    @cached_property
    def keys(self) -> Mapping[str, FileKey]:
        """The keys by name: those that the file holds, and those that it may hold at its top and in its tables."""
        return {"_".join(name): key for name, key in _leaves(self.table, self.document.data, (), (self.group,))}

    def with_values(self, values: Mapping[str, float | str]) -> Document:
        """Return the document with some of its keys changed, by name; a number is SI."""
        data = copy.deepcopy(self.document.data)
        for name, value in values.items():
            if name not in self.keys:
                raise InputError(name, value, f"left out: {self.document.path} has no such key")
            *tables, last = self.keys[name].path
            inside: Any = data
            for part in tables:
                inside = inside.setdefault(part, {}) if isinstance(inside, dict) else inside[part]
            inside[last] = self.keys[name].written(value)
        varied = copy.copy(self.document)
        varied.data = data
        return varied


def _leaves(kind: Value, given: Any, path: KeyPath, name: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], FileKey]]:
    if isinstance(kind, Tables):
        for index, each in enumerate(given if isinstance(given, list) else ()):
            label = str(each.get("name", index))
            yield from _leaves(kind.table, each, (*path, index), (label,) if path == PIECES else (*name, label))
    elif isinstance(kind, Table | Record):
        table = given if isinstance(given, Mapping) else {}
        for key, each in _kinds(kind, table).items():
            nested = isinstance(each, Tables | Table | Record)
            # A table of a dataclass has what its keys are without a file; others lack what they do not hold.
            if key in table or isinstance(kind, Table) or (len(path) == 1 and not nested and given is not None):
                inner = (key,) if nested and not path else (*name, key)
                yield from _leaves(each, table.get(key), (*path, key), inner)
    elif name[-1] not in NOT_SWEPT and (
        isinstance(kind, PhysicalValue | Choice) or kind.json().get("type") == "integer"
    ):
        yield name, FileKey(path, kind)


def _kinds(kind: Table | Record, given: Mapping[str, Any]) -> Mapping[str, Value]:
    """Return the kinds of the keys of a table."""
    if isinstance(kind, PieceRecord):
        return kind.kinds_of(given)
    if isinstance(kind, Record):
        return dict.fromkeys(given, kind.values) if isinstance(kind.values, Value) else kind.keys()
    return {key: each.value for key, each in kind.keys().items()}


def swept_keys(files: Iterable[VariedFile]) -> dict[str, Swept]:
    """Return what may be swept of some files, by name."""
    return {name: key.swept for each in files for name, key in each.keys.items()}


def short_names(full: Iterable[str], taken: Iterable[str]) -> dict[str, str]:
    """Return what goes by a shorter name too, such as ``ball_cube`` by ``cube``: where no other has that name."""
    longer: dict[str, list[str]] = {}
    for name in full:
        parts = name.split("_")
        for start in range(1, len(parts)):
            longer.setdefault("_".join(parts[start:]), []).append(name)
    taken = {*taken}
    return {short: names[0] for short, names in longer.items() if len(names) == 1 and short not in taken}
