"""A dataclass as the schema of its file: fields declared by :func:`file_key` are read, checked, written and described.

::

    @dataclass(frozen=True, kw_only=True)
    class Tee:
        height: float = file_key(PhysicalValue("mm", lower=0, upper=100), "height above the ground", example="38 mm")
        colour: str = file_key(Choice(("white", "red")), "what it looks like", default="white")

        def __post_init__(self) -> None:
            check_values(self)

    decode(Tee, Document.read("tee.toml"))
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import MISSING, dataclass, field, fields
from functools import cache
from importlib import import_module
from typing import Any, NamedTuple, TypeVar

from clubface.schema.document import Document, Place, quoted
from clubface.schema.values import Choice, PhysicalValue, Record, Tables, Value
from clubface.support.checks import check_choice
from clubface.support.renamed import warn_renamed

__all__ = [
    "FILES", "Entry", "Table", "check_values", "decode", "encode", "entries", "file_key", "file_schema",
    "json_schema", "key_rows", "quantities", "template", "written_key",
]  # fmt: skip

T = TypeVar("T")


FILES = {
    "club": "equipment.clubs.Club",
    "ball": "equipment.balls.Ball",
    "shaft": "equipment.shafts.Shaft",
    "parameters": "equipment.parameters.ParameterFile",
    "ball-of-pieces": "fem.balls.PIECES_FILE",
    "driver-head": "fem.heads.read.DRIVER_FILE",
    "iron-head": "fem.heads.read.IRON_FILE",
    "mesh-head": "fem.heads.read.MESH_FILE",
    "fem-case": "fem.case.CaseFile",
    "golfer": "design.golfer.GolferFile",
    "prior": "inference.prior.PriorFile",
    "optimisation": "design.optimisation.study.StudyFile",
    "fitting": "design.optimisation.study.FittingFile",
    "shells": "design.shells.study.ShellFile",
    "study": "studies.study.STUDY_FILE",
    "markers": "capture.markers.MarkerFile",
    "monitor-columns": "shots.formats.MappingFile",
    "published-tables": "published_data.PublishedFile",
}
"""Module and name of the dataclass or table type for each kind of file."""


class Entry(NamedTuple):
    """A key of a file.

    Attributes
    ----------
    key
        Key in the file.
    attribute
        Attribute of the object.
    value
        The kind of its value.
    meaning
        Its meaning in one line.
    example
        Example value as users write it; templates omit a key without one.
    is_required
        Whether a file must have the key or one of ``multiples``.
    default
        Default value of the attribute.
    multiples
        Other keys that a file may have in its place, with the factors for their values.
    old_name
        A former name of the key, which files may still use.
    """

    key: str
    attribute: str
    value: Value
    meaning: str
    example: str
    is_required: bool
    default: Any
    multiples: Mapping[str, float]
    old_name: str

    @property
    def unit(self) -> str:
        """The unit in which users write the quantity."""
        return self.value.unit  # pyright: ignore[reportAttributeAccessIssue]

    @property
    def dimension(self) -> str:
        """The dimension of the quantity, as in :mod:`clubface.units`."""
        return self.value.dimension  # pyright: ignore[reportAttributeAccessIssue]


def file_key(
    value: Value,
    meaning: str,
    *,
    name: str = "",
    example: str = "",
    multiples: Mapping[str, float] | None = None,
    old_name: str = "",
    default: Any = MISSING,
    default_factory: Any = MISSING,
    required: bool | None = None,
    **options: Any,
) -> Any:
    """Declare a dataclass field that is a key in its file.

    Parameters
    ----------
    value
        The kind of its value.
    meaning
        Meaning in one line, for pages, templates and editors.
    name
        The key, if it differs from the name of the field.
    example
        Example value for templates, as users write it.
    multiples
        Other keys that may take its place, with the factors for their values, as in ``{"diameter": 0.5}``.
    old_name
        A former name of the key, which is read with a warning.
    required
        Whether a file must have it. Default: if it has no default value.
    default, default_factory, **options
        As for :func:`dataclasses.field`.
    """
    declared = {"key": (value, meaning, name, example, multiples or {}, old_name, required)}
    return field(default=default, default_factory=default_factory, metadata=declared, **options)


@cache
def entries(schema: type) -> Mapping[str, Entry]:
    """Return the keys of a dataclass, in order."""
    keys = {}
    for each in fields(schema):
        if "key" in each.metadata:
            value, meaning, name, example, multiples, old_name, required = each.metadata["key"]
            default = each.default_factory() if each.default_factory is not MISSING else each.default
            is_required = default is MISSING if required is None else required
            name = name or each.name
            keys[name] = Entry(name, each.name, value, meaning, example, is_required, default, multiples, old_name)
    return keys


def quantities(schema: type) -> dict[str, Entry]:
    """Return the keys of a dataclass that hold a physical quantity."""
    return {name: each for name, each in entries(schema).items() if isinstance(each.value, PhysicalValue)}


@dataclass(repr=False, eq=False)
class Table(Value):
    """A table that is read as an instance of a dataclass.

    Attributes
    ----------
    schema
        The dataclass.
    others
        Further keys allowed in the table, which are read elsewhere.
    without
        Keys of the dataclass that are not allowed in the table.
    """

    schema: type
    others: Mapping[str, Value] = field(default_factory=dict)
    without: Collection[str] = ()

    def read(self, given: Any, place: Place, **more: Any) -> Any:
        """Return the object; ``more`` are fields that are not in the file."""
        known = self.keys()
        factors: dict[str, tuple[Entry, float | None]] = {
            other: (each, factor) for each in known.values() for other, factor in each.multiples.items()
        }
        factors |= {each.old_name: (each, None) for each in known.values() if each.old_name}
        kinds = {name: each.value for name, each in known.items()}
        kinds |= {other: each.value for other, (each, _) in factors.items()} | dict(self.others)
        present = given if isinstance(given, Mapping) else {}
        required = [name for name, each in known.items()
                    if each.is_required and not present.keys() & {*each.multiples, each.old_name}]  # fmt: skip
        values = Record(kinds, required).read(given, place)
        for other, (each, factor) in factors.items():
            if other in values:
                if each.key in values:
                    with (at := place.key(other)).errors():
                        raise at.invalid(given[other], f"left out: give {each.key} or {other}, not both")
                value = values.pop(other)
                values[each.key] = value if factor is None else factor * value
                if factor is None:
                    warn_renamed(place.key(other).title, each.key)
        with place.errors():
            return self.schema(
                **{known[name].attribute: each for name, each in values.items() if name in known}, **more
            )

    def check(self, value: Any, place: Place) -> Any:
        """Return an object unchanged, or the object that a mapping describes."""
        return value if isinstance(value, self.schema) else self.read(value, place)

    def json(self) -> dict[str, Any]:
        """Return a JSON Schema object in which each key has its meaning."""
        known = self.keys()
        keys = {}
        for name, each in known.items():
            words = each.value.words()
            about = {"description": each.meaning + (f" ({words})" if words else "")}
            keys |= {one: {**each.value.json(), **about} for one in (name, *each.multiples)}
            if each.old_name:
                keys[each.old_name] = {**each.value.json(), "deprecated": True}
        keys |= {name: each.json() for name, each in self.others.items()}
        required = [name for name, each in known.items() if each.is_required and not each.multiples]
        return {"type": "object", "properties": keys, "required": required, "additionalProperties": False}

    def words(self) -> str:
        """Return that it is a table."""
        return "a table"

    def keys(self) -> Mapping[str, Entry]:
        """Return the keys of the dataclass."""
        return {name: each for name, each in entries(self.schema).items() if name not in self.without}


def decode(
    schema: type[T],
    source: Document | Mapping[str, Any],
    *,
    others: Mapping[str, Value] | None = None,
    usual: Mapping[str, Any] | None = None,
    **more: Any,
) -> T:
    """Return the object that a document or mapping describes; errors name the key and, in a file, the line.

    Parameters
    ----------
    others
        Further keys at the top level, which are read elsewhere.
    usual
        Values of keys that are missing.
    more
        Fields of the object that are not in the file.
    """
    document, data = (source, source.data) if isinstance(source, Document) else (None, source)
    return Table(schema, others or {}).read({**(usual or {}), **data}, Place(document), **more)


def check_values(subject: Any) -> None:
    """Check the fields of a new object, and convert quantities to SI and words to values; None means not given."""
    for each in entries(type(subject)).values():
        value = getattr(subject, each.attribute)
        if value is not None or each.default is not None:
            object.__setattr__(subject, each.attribute, each.value.check(value, Place(name=each.key)))


def encode(subject: Any, *, leave_out: Collection[str] = (), **changed: Any) -> str:
    """Return an object as TOML that reads back as the same object; None and empty values are left out.

    ``changed`` are values written in place of those of the object.
    """
    values = {name: changed.get(name, each) for name, each in _values(subject, leave_out).items()}
    return "\n".join(_lines(entries(type(subject)), values, "")) + "\n"


def _values(subject: Any, leave_out: Collection[str] = ()) -> dict[str, Any]:
    known = entries(type(subject)).values()
    pairs = ((each, getattr(subject, each.attribute)) for each in known if each.key not in leave_out)
    return {
        each.key: value for each, value in pairs if each.is_required or not (value is None or value in ("", (), {}, []))
    }


def _lines(kinds: Mapping[str, Any], values: Mapping[str, Any], heading: str) -> list[str]:
    """Return the lines of a table: its own keys, then its subtables."""
    lines: list[str] = []
    sections: list[str] = []
    for name, value in values.items():
        kind = kinds[name].value if isinstance(kinds[name], Entry) else kinds[name]
        path = f"{heading}.{written_key(name)}" if heading else written_key(name)
        if isinstance(kind, Tables):
            for each in kind.rows(value):
                inner = _lines(kind.keys(), each if isinstance(each, Mapping) else _values(each), path)
                sections += ["", f"[[{path}]]", *inner]
        elif isinstance(kind, Table) or (isinstance(kind, Record) and not kind.example.startswith("{")):
            inner = value if isinstance(value, Mapping) else _values(value)
            inner_kinds = kind.keys() or dict.fromkeys(inner, kind.values if isinstance(kind, Record) else None)
            content = _lines(inner_kinds, inner, path)
            sections += (
                ["", *([f"[{path}]"] if not content or content[0] else []), *content[not content[0] :]]
                if content
                else []
            )
        else:
            lines.append(f"{written_key(name)} = {kind.write(value)}")
    return lines + sections


def written_key(name: str) -> str:
    """Return a key as TOML, without quotes if possible."""
    bare = name and all(each.isascii() and (each.isalnum() or each in "-_") for each in name)
    return name if bare else quoted(name)


def template(schema: type, values: Mapping[str, str], *, width: int = 27) -> list[str]:
    """Return the lines of a template: every key with an example and its meaning.

    ``values`` are TOML values written in place of the examples; other optional keys are commented out.
    """
    lines = []
    for each in entries(schema).values():
        if example := values.get(each.key, each.example):
            is_text = isinstance(each.value, PhysicalValue) and each.value.unit != "1"
            entry = f"{written_key(each.key)} = {quoted(example) if is_text else example}"
            entry = entry if each.is_required or each.key in values else f"# {entry}"
            words = each.value.known if isinstance(each.value, Choice) else {}
            choices = f": {', '.join(words)}" if not all(word in each.meaning for word in words) else ""
            lines.append(f"{entry:<{width}} # {each.meaning}{choices}")
    return lines


def json_schema(schema: type | Value, title: str) -> dict[str, Any]:
    """Return the JSON Schema of a dataclass's files, for completion and checks in editors."""
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": title}
    return head | (Table(schema) if isinstance(schema, type) else schema).json()


def key_rows(schema: type | Value, prefix: str = "") -> list[tuple[str, str, str]]:
    """Return a row for each key of a file, including those of subtables: key, allowed values, meaning."""
    rows = []
    for name, each in (Table(schema) if isinstance(schema, type) else schema).keys().items():
        entry = each if isinstance(each, Entry) else None
        kind: Value = each.value if isinstance(each, Entry) else each
        words = kind.words().format(name)
        default: Any = entry.default if entry and not entry.is_required else None
        if isinstance(default, int | float | str) and default != "":
            words += f"; default `{kind.show(default)}`"
        names = " or ".join(f"`{prefix}{one}`" for one in (name, *(entry.multiples if entry else ())))
        rows.append((names, words, entry.meaning if entry else ""))
        rows += key_rows(kind, f"{prefix}{name}.")
    return rows


def file_schema(name: str) -> Value:
    """Return the table type of a kind of file."""
    check_choice("kind of file", name, FILES)
    module, _, attribute = FILES[name].rpartition(".")
    schema: Any = getattr(import_module(f"clubface.{module}"), attribute)
    return schema if isinstance(schema, Value) else Table(schema)
