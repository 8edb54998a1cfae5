"""What clubs and balls share: reading, writing and changing an object made of properties with units."""

from __future__ import annotations

import math
import os
from collections.abc import Collection, Mapping
from dataclasses import fields, replace
from typing import Any, ClassVar, NamedTuple, Self, TypeVar

from clubface import units
from clubface.errors import ClubfaceError, InputError
from clubface.support.checks import Frozen, check_choice, check_names
from clubface.support.strict_toml import Document, quoted

HANDS = {"right": 1, "left": -1}
FLAT = "flat"
T = TypeVar("T")
SOURCE_GROUPS = {"cg": ("cg_x", "cg_y", "cg_z"), "inertia": ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")}
"""Words that stand for several fields under [sources]."""


class Property(NamedTuple):
    """One number of a description.

    Attributes
    ----------
    dimension
        As in ``units``.
    unit
        The unit it is written in.
    meaning
        One line for the template.
    example
        A value for the template.
    required
        Whether a file must give it.
    """

    dimension: str
    unit: str
    meaning: str
    example: str
    required: bool = True


Properties = Mapping[str, Property]


class Described:
    """A club or a ball: read from TOML, changed in part; its subclass is a frozen dataclass with ``sources``.

    Attributes
    ----------
    properties
        The numbers that describe it, by field.
    """

    properties: ClassVar[Properties]

    def __repr__(self) -> str:
        hand = ", left-handed" if getattr(self, "hand", 1) < 0 else ""
        about = getattr(self, "description", "")
        lines = [f"{getattr(self, 'name', '')}{hand}{f': {about}' * bool(about)}"]
        for key, each in self.properties.items():
            value = getattr(self, key)
            if value is not None:
                number = FLAT if value == math.inf else f"{units.from_si(value, each.unit):.6g}"
                unit = "" if each.unit == "1" or value == math.inf else f" {each.unit}"
                lines.append(f"  {key:<20} {number}{unit}")
        return "\n".join(lines)

    def replace(self, **changes: Any) -> Self:
        """Return it with fields changed, as text with a unit or an SI number: ``mass="200 g"``."""
        return changed(self, changes)

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Self:
        """Read what a TOML file describes; see ``template`` for its form."""
        return from_document(cls, Document.read(path), cls.properties)

    @classmethod
    def from_text(cls, text: str, path: str = "<text>") -> Self:
        """Read what TOML text describes; ``path`` names it in errors."""
        return from_document(cls, Document(text, path), cls.properties)


def from_document(kind: type[T], document: Document, properties: Properties) -> T:
    """Read the object a TOML document describes; every error carries file and line."""
    data = dict(document.data)
    texts = [each.name for each in fields(kind) if each.name not in properties and each.name != "sources"]  # pyright: ignore
    required = ["name"] + (["kind"] if "kind" in texts else []) + [k for k, q in properties.items() if q.required]
    document.check_keys(data, [*texts, *properties, "sources"], required)
    document.check_text(data, texts)
    sources = data.get("sources", {})
    if not isinstance(sources, dict):
        raise document.error("sources must be a table of texts", "sources")
    groups = {key: names for key, names in SOURCE_GROUPS.items() if names[0] in properties}
    document.check_keys(sources, [*properties, *groups], (), "sources")
    document.check_text(sources, sources, "sources")
    if sources:
        data["sources"] = {name: text for key, text in sources.items() for name in groups.get(key, (key,))}
    try:
        return kind(**data)
    except ClubfaceError as error:
        raise document.wrap(error) from error


def set_si(subject: Any, properties: Properties) -> None:
    """Turn the properties of a new (frozen) object into SI floats, its hand into +1 or -1, and freeze its sources."""
    for key, each in properties.items():
        value = getattr(subject, key)
        if value is None and not each.required:
            continue
        flat = key in ("bulge", "roll") and (value == FLAT or value == math.inf)
        number = math.inf if flat else units.parse(value, each.dimension, name=key)
        object.__setattr__(subject, key, number)
    hand = getattr(subject, "hand", None)
    if isinstance(hand, str):
        check_choice("hand", hand, HANDS)
        object.__setattr__(subject, "hand", HANDS[hand])
    if not isinstance(subject.sources, Mapping):
        raise InputError("sources", subject.sources, "a mapping of properties to texts")
    object.__setattr__(subject, "sources", Frozen(subject.sources))


def changed(subject: T, changes: Mapping[str, Any]) -> T:
    """Return ``subject`` with some fields changed; a changed property loses its source."""
    names = [each.name for each in fields(subject)]  # pyright: ignore
    check_names("field", changes, names)
    kept = {k: v for k, v in subject.sources.items() if k not in changes}  # pyright: ignore
    return replace(subject, **{"sources": kept, **changes})  # pyright: ignore


def to_toml(subject: Any, properties: Properties, texts: Mapping[str, str], left_out: Collection[str] = ()) -> str:
    """Write TOML text that reads back as ``subject``, bit by bit, though some properties follow from others."""
    lines = [f"{key} = {quoted(value)}" for key, value in {"name": subject.name, **texts}.items()]
    if subject.description:
        lines.append(f"description = {quoted(subject.description)}")
    lines.append("")
    for key, each in properties.items():
        value = getattr(subject, key)
        if value is not None and key not in left_out:
            lines.append(f"{key} = {quoted(written(value, each))}")
    sources = dict(subject.sources)
    for group, names in SOURCE_GROUPS.items():
        if names[0] in sources and all(sources.get(name) == sources[names[0]] for name in names):
            sources = {
                name if name != names[0] else group: text for name, text in sources.items() if name not in names[1:]
            }
    if sources:
        lines += ["", "[sources]", *(f"{key} = {quoted(text)}" for key, text in sources.items())]
    return "\n".join(lines) + "\n"


def written(value: float, each: Property) -> str:
    """Write ``value`` [SI] as text that parses to the same bits, in the usual unit where one of its numbers does."""
    if math.isinf(value):
        return FLAT
    for unit in (each.unit, units.SI_UNITS[each.dimension]):
        number = float(units.from_si(value, unit))
        for near in (
            f"{number:.15g}",
            *map(repr, (number, math.nextafter(number, 0.0), math.nextafter(number, 1e300))),
        ):
            text = near + ("" if unit == "1" else f" {unit}")
            if math.isfinite(float(near)) and units.parse(text, each.dimension) == value:
                return text
    return f"{value!r} {units.SI_UNITS[each.dimension]}"


def template_lines(properties: Properties, given: Collection[str] = ()) -> list[str]:
    """Write one commented line a property, then an example of sources; optional keys are comments unless ``given``."""
    lines = []
    for key, each in properties.items():
        entry = f"{key} = {quoted(each.example)}"
        lines.append(f"{entry if each.required or key in given else '# ' + entry:<27} # {each.meaning}")
    return [*lines, "", "[sources]                   # where each value comes from", '# mass = "weighed"', ""]
