"""The lines of a TOML document, by the keys and indices that lead to each value."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

__all__ = ["TEXTS", "KeyPath", "lines_of"]

KeyPath = tuple[str | int, ...]
"""Keys, and indices in lists, from the top of a document to a value."""
TEXTS = r'"""(?:[^\\]|\\.)*?"""|\'\'\'.*?\'\'\'|"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'|#[^\n]*'
"""Texts and comments."""


@dataclass
class _Bracket:
    """A list or an inline table that is open."""

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
        """Return the path that a key of several parts means, and note the line of every part that is new.

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
    """Return the lines (from 1) of all keys, tables and tables in lists of a valid document."""
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
