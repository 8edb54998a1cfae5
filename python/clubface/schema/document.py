"""Strict TOML reader that knows the line of every key, so that errors name file, line and key.

A :class:`Place` is the location of a value: its file and line, if it has one, and its name in messages.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from clubface.errors import ClubfaceError, FileError, InputError, UnknownNameError, legible
from clubface.support.files import read_input

__all__ = ["Document", "KeyPath", "Place", "quoted"]

MAXIMUM_SIZE = 1_000_000
"""Maximum size of a file [bytes]; club, ball and parameter files are far smaller."""
MOST_PARTS = 16
"""Maximum depth of dotted keys and of nested brackets; clubface's files have three."""
NESTED = f"nested too deeply, more than {MOST_PARTS} tables or lists in each other"
TWICE = ("Cannot overwrite a value", "Cannot declare")
"""Starts of the parser's messages about a key or table that occurs twice."""
INTEGERS = range(-(2**63), 2**63)
"""The range of TOML's integers."""
KeyPath = tuple[str | int, ...]
"""Keys and list indices from the top of a document to a value."""
TEXTS = r'"""(?:[^\\]|\\.)*?"""|\'\'\'.*?\'\'\'|"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'|#[^\n]*'
"""Pattern that matches strings and comments."""
BARE = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.")
"""Characters of bare keys, and the dot between the parts of a key."""
LONGEST_KEY = 60


@dataclass(repr=False, eq=False)
class Place:
    """The location of a value in a file, a mapping or an object.

    Attributes
    ----------
    document
        The file, or None.
    path
        Keys and indices that lead to the value.
    name
        Name in messages, such as "shape.loft".
    label
        Name of the table that holds the value, such as "trim toe"; a key is then called "x of trim toe".
    """

    document: Document | None = None
    path: tuple[str | int, ...] = ()
    name: str = ""
    label: str = ""

    @property
    def folder(self) -> Path | None:
        """The folder of the file, from which relative paths start."""
        return None if self.document is None else Path(self.document.path).parent

    @property
    def title(self) -> str:
        """The name of the value or its table in messages, including the label."""
        return f"{self.name} of {self.label}" if self.name and self.label else self.name or self.label

    def key(self, key: str) -> Place:
        """Return the location of a key of this table."""
        name = f"{self.name}.{key}" if self.name else key
        return replace(self, path=(*self.path, key), name=name)

    def item(self, index: int, label: str = "") -> Place:
        """Return the location of an item of this list; a table may have a label."""
        path = (*self.path, index)
        if label or self.document is not None:
            return Place(self.document, path, label=label)
        return replace(self, path=path, name=f"{self.name}[{index}]")

    def invalid(self, value: Any, allowed: str) -> InputError:
        """Return the error for a value that cannot be used."""
        return InputError(self.title, value, allowed)

    def check_keys(self, given: Iterable[str], known: Iterable[str], required: Iterable[str]) -> None:
        """Raise an error for unknown keys, naming the nearest known one, or for missing required keys."""
        given = dict.fromkeys(given)
        known = tuple(known)
        for key in given:
            if key not in known:
                within = f" of {self.title}" if self.document is None and self.title else ""
                with self.key(key).errors():
                    raise UnknownNameError(f"key{within}", key, known)
        self.require_keys(given, required)

    def require_keys(self, given: Iterable[str], required: Iterable[str]) -> None:
        """Raise an error that lists the required keys missing from a table."""
        given = set(given)
        missing = [key for key in required if key not in given]
        if not missing:
            return
        if self.document is None:
            raise InputError(self.key(missing[0]).title, None, "give it")
        section = ".".join(part for part in self.path if isinstance(part, str))
        inside = f" of [{section}]" if section else ""
        line = self.document.line_of(self.path)
        raise FileError(self.document.path, line, f"these keys{inside} are missing: {', '.join(missing)}")

    @contextmanager
    def errors(self) -> Iterator[None]:
        """Add file and line to errors raised within the block."""
        try:
            yield
        except FileError as error:
            if self.document is None or error.line is not None or error.path == self.document.path:
                raise
            raise self.wrap(error) from error
        except ClubfaceError as error:
            if self.document is None:
                raise
            raise self.wrap(error) from error

    def wrap(self, error: ClubfaceError) -> FileError:
        """Return an error with file and line of the value it is about, if that is here or below."""
        assert self.document is not None
        if self.label and isinstance(error, InputError) and not isinstance(error, UnknownNameError):
            error.parameter += f" of {self.label}" * (" of " not in error.parameter)
        parameter = getattr(error, "parameter", None) or self.title
        names = [re.split(r" of |\[", parameter)[0]]
        names += [names[0].rpartition(".")[0]] * ("." in names[0])
        names += [parameter.rpartition(" ")[2]] * (" " in parameter)
        if isinstance(error, UnknownNameError) and isinstance(error.value, str):
            names.append(error.value)  # the unknown name may itself be a key
        at = self.document.line_of(self.path)
        lines = (self.document.line_like(name, self.path) for name in names)
        line = next((each for each in lines if each != at), at)
        return FileError(self.document.path, line, str(error), parameter or None)


class Document:
    """A TOML file: its content and the line of each key.

    Attributes
    ----------
    data
        The parsed content.
    path
        The name used in errors.
    """

    def __init__(self, text: str, path: str = "<text>") -> None:
        import tomllib

        self.path = path
        self._lines, self._text = text.splitlines(), text
        _check_depth(text, path)
        try:
            self.data: dict[str, Any] = tomllib.loads(text)
        except (ValueError, RecursionError) as error:
            message = NESTED if isinstance(error, RecursionError) else str(error)
            line = _line_number(message)
            if "int_max_str_digits" in message:
                message = "a whole number has thousands of digits"
            elif message.startswith(TWICE):
                message = "the key or table of this line is defined twice"
            raise FileError(path, line, f"this is not TOML: {message}{self._quoting_advice(line)}") from None
        for key, value in self.data.items():
            if flaw := _find_flaw(value):
                raise FileError(path, self.line_of((key,)), f"{key} holds {flaw}", key)

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Document:
        """Read the file at ``path``; raise :class:`FileError` if it is missing, too large or not UTF-8."""
        name, content = os.fspath(path), read_input(path, most=MAXIMUM_SIZE)
        try:
            text = content.decode("utf-8-sig")  # Windows editors write a byte order mark
        except UnicodeDecodeError as error:
            line = content[: error.start].count(b"\n") + 1
            raise FileError(name, line, "this is not UTF-8 text") from None
        return cls(text, name)

    def _quoting_advice(self, number: int | None) -> str:
        """Return advice for the key of a line if TOML accepts it only in quotes."""
        line = self._lines[number - 1] if number is not None and number <= len(self._lines) else ""
        key, equals, _ = (part.strip() for part in line.partition("="))
        if not equals or not key or key[0] in "\"'[" or len(key) > LONGEST_KEY or all(c in BARE for c in key):
            return ""
        return f"; put the name into quotes: {quoted(key)} = ..."

    @cached_property
    def _line_by_path(self) -> dict[KeyPath, int]:
        return lines_of(self._text)

    def line_of(self, path: KeyPath) -> int | None:
        """Return the line (from 1) of the value at a path of keys and indices, or of the nearest enclosing table."""
        for length in range(len(path), 0, -1):
            if path[:length] in self._line_by_path:
                return self._line_by_path[path[:length]]
        return None

    def line_like(self, key: str, path: KeyPath = ()) -> int | None:
        """Return the line of a key at or below a path; names may be joined by dots or underscores.

        ``shape.loft``, ``shape_loft`` and ``loft`` alone all mean ``loft`` in ``[shape]``. Without such a key, the line
        of the path is returned.
        """
        ending = "_" + key.replace(".", "_")
        lines: list[tuple[int, int]] = []
        for each, line in self._line_by_path.items():
            if each[: len(path)] == path and each:
                joined = "_" + "_".join(part for part in each if isinstance(part, str)).replace(".", "_")
                if joined.endswith(ending):
                    lines.append((len(each), line))
        return min(lines)[1] if lines else self.line_of(path)


def _check_depth(text: str, path: str) -> None:
    """Raise an error for keys of many parts and deep nesting, for which the parser would need gigabytes."""
    # Remove strings and comments, but keep their line breaks.
    bare = re.sub(TEXTS, lambda match: "\n" * match[0].count("\n"), text, flags=re.DOTALL)
    if len(bare) <= MOST_PARTS:
        return
    depth = 0
    for line, content in enumerate(bare.split("\n"), 1):
        for part in re.split(r"([\[\]{},=])", content):
            depth += (part in ("[", "{")) - (part in ("]", "}"))
            if depth > MOST_PARTS or part.count(".") >= MOST_PARTS:
                raise FileError(path, line, f"this is not TOML of clubface: {NESTED}")


def _find_flaw(value: Any) -> str:
    """Return the reason why a value cannot be used, or ""."""
    if isinstance(value, dict | list):
        return next(filter(None, map(_find_flaw, value.values() if isinstance(value, dict) else value)), "")
    if isinstance(value, int) and value not in INTEGERS:
        return "a whole number of more than 64 bits, which TOML does not allow"
    return ""


def quoted(text: str) -> str:
    """Return ``text`` as a quoted TOML string."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{legible(escaped)}"'


def _line_number(message: str) -> int | None:
    """Return the line number in tomllib's "... (at line 3, column 5)"."""
    _, marker, rest = message.partition("at line ")
    digits = rest.split(",")[0]
    return int(digits) if marker and digits.isdigit() else None


@dataclass
class _Bracket:
    """An open list or inline table."""

    sign: str
    path: KeyPath
    index: int = 0

    @property
    def inside(self) -> KeyPath:
        return (*self.path, self.index) if self.sign == "[" else self.path


@dataclass
class _Reader:
    """The state of the reader between two tokens."""

    lines: dict[KeyPath, int] = field(default_factory=dict)
    last: dict[KeyPath, int] = field(default_factory=dict)
    """Index of the latest table of each array of tables."""

    def resolve(self, parts: list[str], line: int, start: KeyPath = (), *, heading: int = 0) -> KeyPath:
        """Return the path of a dotted key, and record the line of every new part.

        ``heading`` is the number of brackets around a heading: two open another table of an array.
        """
        path = start
        for number, part in enumerate(parts, 1):
            path = (*path, part)
            self.lines.setdefault(path, line)
            if heading and number == len(parts):
                if heading == 2:
                    self.last[path] = self.last.get(path, -1) + 1
                    self.lines[*path, self.last[path]] = line
                else:
                    self.lines[path] = line
            if heading and path in self.last:
                path = (*path, self.last[path])
        return path


def lines_of(text: str) -> dict[KeyPath, int]:
    """Return the lines (counted from 1) of all keys, tables and arrays of tables in a valid document."""
    reader, open_brackets = _Reader(), list[_Bracket]()
    table: KeyPath = ()
    value: KeyPath = ()
    parts: list[str] = []
    is_key, heading, line = True, 0, 1
    for token in re.finditer(rf"{TEXTS}|[\[\]{{}},=\n]|[\w-]+", text, flags=re.DOTALL):
        sign = token[0]
        inner = open_brackets[-1] if open_brackets else None
        if sign == "\n":
            if inner is None:
                is_key, heading, parts = True, 0, []
        elif sign == "[" and is_key and inner is None and not parts:
            heading += 1
        elif sign == "]" and heading:
            if parts:
                table = reader.resolve(parts, line, heading=heading)
                parts = []
        elif sign == "=" and is_key:
            value = reader.resolve(parts, line, table if inner is None else inner.inside)
            is_key, parts = False, []
        elif sign in ("[", "{"):
            path = inner.inside if inner is not None and inner.sign == "[" else value
            open_brackets.append(_Bracket(sign, path))
            reader.lines.setdefault(path, line)
            is_key, parts = sign == "{", []
        elif sign in ("]", "}"):
            if inner is not None:
                open_brackets.pop()
            is_key = False
        elif sign == ",":
            if inner is not None:
                inner.index += inner.sign == "["
                is_key, parts = inner.sign == "{", []
        elif is_key and not sign.startswith("#"):
            parts.append(sign.strip("\"'"))
        line += sign.count("\n")
    return reader.lines
