"""TOML read strictly: every error names the file, the line where it can be found, and the key."""

from __future__ import annotations

import os
from collections.abc import Collection, Iterable
from functools import cached_property
from typing import Any

from clubface.errors import ClubfaceError, FileError, UnknownNameError, legible
from clubface.support.files import read_input

MAXIMUM_SIZE = 1_000_000
"""Bytes; no club, ball or parameter file comes near it."""
MOST_PARTS = 16
"""Names in a dotted key, and brackets in brackets; the files of clubface have three."""
NESTED = f"nested too deeply, more than {MOST_PARTS} tables or lists in each other"
TWICE = ("Cannot overwrite a value", "Cannot declare")
"""How the parser begins to tell that a key or a table is there twice."""
INTEGERS = range(-(2**63), 2**63)
"""Whole numbers that TOML has."""
_TEXT = r'"""(?:[^\\]|\\.)*?"""|\'\'\'.*?\'\'\'|"(?:[^"\\\n]|\\.)*"|\'[^\'\n]*\'|#[^\n]*'
"""Texts and comments."""

BARE = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.")
"""Letters of keys without quotes, and the point between parts of one."""
LONGEST_KEY = 60


class Document:
    """One TOML file: its content, and where each key stands.

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
        self._places: dict[tuple[str, int, str], int] | None = None
        _check_depth(text, path)
        try:
            self.data: dict[str, Any] = tomllib.loads(text)
        except (ValueError, RecursionError) as error:
            message = NESTED if isinstance(error, RecursionError) else str(error)
            line = _line_in(message)
            if "int_max_str_digits" in message:
                message = "a whole number has thousands of digits"
            elif message.startswith(TWICE):
                message = "what this line sets or opens is set or opened before"
            raise FileError(path, line, f"this is not TOML: {message}{self._unquoted(line)}") from None
        for key, value in self.data.items():
            if flaw := _flaw_of(value):
                raise FileError(path, self.line(key), f"{key} holds {flaw}", key)

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Document:
        """Read the file at ``path``; one missing, too large or not UTF-8 is a :class:`FileError`."""
        name, content = os.fspath(path), read_input(path, most=MAXIMUM_SIZE)
        try:
            text = content.decode("utf-8-sig")  # editors of Windows begin with a byte order mark
        except UnicodeDecodeError as error:
            line = content[: error.start].count(b"\n") + 1
            raise FileError(name, line, "this is not UTF-8 text") from None
        return cls(text, name)

    def _unquoted(self, number: int | None) -> str:
        """Say how to write the key of a line if TOML takes it in quotes only."""
        line = self._lines[number - 1] if number is not None and number <= len(self._lines) else ""
        key, equals, _ = (part.strip() for part in line.partition("="))
        if not equals or not key or key[0] in "\"'[" or len(key) > LONGEST_KEY or all(c in BARE for c in key):
            return ""
        return f"; put the name into quotes: {quoted(key)} = ..."

    def line(self, key: str, table: str = "", occurrence: int = 0) -> int | None:
        """Find the line (from 1) that sets ``key`` in the given ``occurrence`` of ``table``, or opens it, or None.

        Without ``key`` it is the line that opens the table. A key may stand behind a heading, in a dotted key, or in
        braces.
        """
        if self._places is None:
            self._places = _places(self._text)
        return self._places.get((table, occurrence, key))

    def _line_like(self, key: str, table: str) -> int | None:
        """Find the first line of a table whose key and group end so: ``ground_tilt`` stands in ``ground.tilt``."""
        for (above, _, last), number in (self._places or {}).items():
            whole = f"{above}.{last}" if above else last
            if whole.startswith(f"{table}." if table else "") and f".{whole}".replace(".", "_").endswith(f"_{key}"):
                return number
        return None

    @cached_property
    def _line_by_path(self) -> dict[tuple[str | int, ...], int]:
        from clubface.schema.lines import lines_of

        return lines_of(self._text)

    def line_of(self, path: tuple[str | int, ...]) -> int | None:
        """Return the line (from 1) of the value at a path of keys and indices, or of the nearest table around it."""
        for length in range(len(path), 0, -1):
            if path[:length] in self._line_by_path:
                return self._line_by_path[path[:length]]
        return None

    def line_like(self, key: str, path: tuple[str | int, ...] = ()) -> int | None:
        """Return the line of a key at or below a path, whose names may be joined by points or low lines.

        ``shape.loft`` and ``shape_loft`` are ``loft`` in ``[shape]``, and so is ``loft`` alone. Without such a key it
        is the line of the path.
        """
        ending = "_" + key.replace(".", "_")
        lines: list[tuple[int, int]] = []
        for each, line in self._line_by_path.items():
            if each[: len(path)] == path and each:
                joined = "_" + "_".join(part for part in each if isinstance(part, str)).replace(".", "_")
                if joined.endswith(ending):
                    lines.append((len(each), line))
        return min(lines)[1] if lines else self.line_of(path)

    def error(self, message: str, key: str | None = None, table: str = "", occurrence: int = 0) -> FileError:
        """Make a :class:`FileError` at the line of ``key``."""
        line = self.line(key, table, occurrence) if key is not None else None
        line = line or (self._line_like(key, table) if key and not occurrence else None)
        return FileError(self.path, line, message, key or None)

    def check_keys(
        self,
        values: dict[str, Any],
        known: Collection[str],
        required: Iterable[str],
        table: str = "",
        occurrence: int = 0,
    ) -> None:
        """Refuse a key that is not ``known``, naming the nearest, and list the ``required`` keys that are missing."""
        for key in values:
            if key not in known:
                raise self.error(str(UnknownNameError("key", key, known)), key, table, occurrence)
        missing = [key for key in required if key not in values]
        if missing:
            place = f" of [{table}]" if table else ""
            raise self.error(f"these keys{place} are missing: {', '.join(missing)}", "", table, occurrence)

    def check_text(self, values: dict[str, Any], keys: Iterable[str], table: str = "", occurrence: int = 0) -> None:
        """Refuse a value of ``keys`` that is not text."""
        for key in keys:
            if key in values and not isinstance(values[key], str):
                raise self.error(f"{key} must be text in quotes, not {values[key]!r:.60}", key, table, occurrence)

    def wrap(self, error: ClubfaceError, table: str = "", occurrence: int = 0) -> FileError:
        """Tell ``error`` about one value with file and line.

        The parameter may be "key", "table.key", "key of name" (the name of what has it) or "key[0]" (in a list).
        """
        named = getattr(error, "parameter", None) or ""
        inside, _, key = named.partition(" of ")[0].partition("[")[0].rpartition(".")
        # The last two: a table inside another, and one written in one line under its own name.
        places = [(named, table), (key, inside or table), (key, f"{table}.{inside}"), (inside, table)]
        lines = (self.line(name, place, occurrence) for name, place in places if name)
        line = next(filter(None, lines), None) or (self._line_like(key or inside, table) if key or inside else None)
        return FileError(self.path, line, str(error), named or None)


def _places(text: str) -> dict[tuple[str, int, str], int]:
    """Return the lines of a valid document by table, how often that was opened before, and key; "" is its opening."""
    import re

    found: dict[tuple[str, int, str], int] = {}
    opened: dict[str, int] = {}
    heading, prefix, parts, within = "", "", [], []
    keys, in_heading, line = True, False, 1

    def note(prefix: str, parts: list[str]) -> str:
        for part in parts:
            found.setdefault((prefix, opened.get(prefix, 0), part), line)
            prefix = f"{prefix}.{part}" if prefix else part
        return prefix

    for token in re.finditer(rf"{_TEXT}|[\[\]{{}},=\n]|[\w-]+", text, flags=re.DOTALL):
        sign = token[0]
        if sign in ("=", "{", "}", "[", "]", ",", "\n"):
            if sign == "\n":
                line += 1
                if not within:
                    keys, in_heading, parts = True, False, []
            elif keys and not within and sign == "[" and not parts:
                in_heading = True
            elif in_heading:
                if sign == "]" and parts:
                    heading = ".".join(parts)
                    note("", parts)
                    opened[heading] = opened.get(heading, -1) + 1
                    found[heading, opened[heading], ""] = line
                    parts = []
            elif sign == "=" and keys:
                prefix = note(within[-1][1] if within else heading, parts)
                keys, parts = False, []
            elif sign in "[{":
                keys = sign == "{"
                within.append((sign, prefix))
            elif sign in "]}" and within:
                prefix = within.pop()[1]
                keys = False
            elif sign == "," and within:
                keys, parts = within[-1][0] == "{", []
                prefix = within[-1][1]
        elif keys and not sign.startswith("#"):
            parts.append(sign.strip("\"'"))
        line += sign.count("\n") if len(sign) > 1 else 0
    return found


def _check_depth(text: str, path: str) -> None:
    """Refuse keys of many parts and deep nesting, on which a parser would spend gigabytes, before it reads them."""
    import re

    # What stands in texts and comments does not count; their ends of lines do.
    bare = re.sub(_TEXT, lambda found: "\n" * found[0].count("\n"), text, flags=re.DOTALL)
    if len(bare) <= MOST_PARTS:
        return
    depth = 0
    for line, content in enumerate(bare.split("\n"), 1):
        for part in re.split(r"([\[\]{},=])", content):
            depth += (part in ("[", "{")) - (part in ("]", "}"))
            if depth > MOST_PARTS or part.count(".") >= MOST_PARTS:
                raise FileError(path, line, f"this is not TOML of clubface: {NESTED}")


def _flaw_of(value: Any) -> str:
    """Say what is in a value that no computation can take, or return nothing."""
    if isinstance(value, dict | list):
        return next(filter(None, map(_flaw_of, value.values() if isinstance(value, dict) else value)), "")
    if isinstance(value, int) and value not in INTEGERS:
        return "a whole number of more than 64 bits, which TOML does not have"
    return ""


def quoted(text: str) -> str:
    """Write ``text`` as a TOML string, in quotes."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{legible(escaped)}"'


def _line_in(message: str) -> int | None:
    """Find the line number in tomllib's "... (at line 3, column 5)"."""
    _, found, rest = message.partition("at line ")
    digits = rest.split(",")[0]
    return int(digits) if found and digits.isdigit() else None
