"""Common base of clubs, balls and shafts: dataclasses with the keys of a file as fields, read, written and changed."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Collection, Mapping
from dataclasses import fields, replace
from typing import Any, ClassVar, Self, TypeVar

from clubface import units
from clubface._core import check, inputs
from clubface.equipment.attachment import ADDED_NAMES
from clubface.errors import InputError, ShotError
from clubface.schema import TEXT, Document, Record, Value, check_values, decode, encode, quantities, template
from clubface.support.checks import Frozen, check_names

_OWN_NAMES = {"club_mass": "mass", "static_loft": "loft", "ball_mass": "mass", "ball_radius": "radius",
              "ball_inertia": "inertia"}  # fmt: skip
"""Field names in clubs and balls of inputs that have other names in shots."""
HANDS = {"right": 1, "left": -1}
FLAT = "flat"
T = TypeVar("T")


def sources_of(schema: Callable[[], type[EquipmentItem]], *others: str) -> Record:
    """Return the type of a table with the source of each quantity of a dataclass, and of ``others``."""
    return Record(lambda: dict.fromkeys([*quantities(schema()), *schema().SOURCE_GROUPS, *others], TEXT))


class EquipmentItem:
    """A club, ball or shaft, read from TOML; each subclass is a frozen dataclass with ``sources``."""

    SOURCE_GROUPS: ClassVar[Mapping[str, tuple[str, ...]]] = {}
    """Names that stand for several fields under [sources]."""
    OTHER_KEYS: ClassVar[Mapping[str, Value]] = {}
    """Keys of the file that are read elsewhere."""

    def __repr__(self) -> str:
        hand = ", left-handed" if getattr(self, "hand", 1) < 0 else ""
        about = getattr(self, "description", "")
        lines = [f"{getattr(self, 'name', '')}{hand}{f': {about}' * bool(about)}"]
        for key, each in quantities(type(self)).items():
            value = getattr(self, key)
            if value is not None:
                number = FLAT if value == math.inf else f"{units.from_si(value, each.unit):.6g}"
                unit = "" if each.unit == "1" or value == math.inf else f" {each.unit}"
                lines.append(f"  {key:<20} {number}{unit}")
        return "\n".join(lines)

    def replace(self, **changes: Any) -> Self:
        """Return a copy with fields changed; values are text with a unit or SI numbers: ``mass="200 g"``."""
        return changed(self, changes)

    @classmethod
    def from_document(cls, document: Document) -> Self:
        """Read the item described by a TOML document."""
        return decode(cls, document, others=cls.OTHER_KEYS)

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Self:
        """Read the item described by a TOML file; see ``template`` for its format."""
        return cls.from_document(Document.read(path))

    @classmethod
    def from_text(cls, text: str, path: str = "<text>") -> Self:
        """Read the item described by TOML text; ``path`` names it in errors."""
        return cls.from_document(Document(text, path))


def set_si(subject: Any) -> None:
    """Check a new frozen object, convert its fields to SI, and expand and freeze its sources."""
    if not isinstance(subject.sources, Mapping):
        raise InputError("sources", subject.sources, "a mapping of properties to texts")
    check_values(subject)
    groups = subject.SOURCE_GROUPS
    sources = {name: text for key, text in subject.sources.items() for name in groups.get(key, (key,))}
    object.__setattr__(subject, "sources", Frozen(sources))


def changed(subject: T, changes: Mapping[str, Any]) -> T:
    """Return a copy of ``subject`` with some fields changed; changed fields lose their source."""
    check_names("field", changes, [each.name for each in fields(subject)])  # pyright: ignore
    kept = {k: v for k, v in subject.sources.items() if k not in changes}  # pyright: ignore
    return replace(subject, **{"sources": kept, **changes})  # pyright: ignore


def to_toml(subject: Any, leave_out: Collection[str] = ()) -> str:
    """Return TOML text that reads back exactly as ``subject``, even if some fields follow from others."""
    sources = dict(subject.sources)
    for group, names in subject.SOURCE_GROUPS.items():
        if names[0] in sources and all(sources.get(name) == sources[names[0]] for name in names):
            renamed = {(group if name == names[0] else name): text for name, text in sources.items()}
            sources = {name: text for name, text in renamed.items() if name not in names}
    return encode(subject, leave_out=leave_out, sources=sources)


def template_lines(schema: type, values: Mapping[str, str]) -> list[str]:
    """Return the commented keys of a file, then an example of sources."""
    return [*template(schema, values), "", "[sources]                   # source of each value",
            '# mass = "weighed"', ""]  # fmt: skip


def check_body(group: str, values: Mapping[str, float]) -> None:
    """Raise ShotError if inputs of a "club" or "ball" [SI] are physically impossible."""
    fault = check(group, [values.get(each["name"], 0.0) for each in inputs()])
    if fault is not None:
        name, message = fault
        own = "added_inertia" if name in ADDED_NAMES else _OWN_NAMES.get(name, name)
        raise ShotError(own, values[name], message)
