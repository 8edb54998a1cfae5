"""Every key of a TOML file with a value of the wrong type, one at a time."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from clubface.errors import ClubfaceError

WRONG = (
    "-5", "0.5", "true", '"x"', '""', '"1 parsec"', "[]", "{}", "nan", "-inf", "1979-05-27", "07:32:00",
    "1000000000000000000", "[[1]]", '[{ x = 1 }, "x"]', "{ x = 1 }", "[true]",
)  # fmt: skip
"""As they are written."""
NEVER = ("1979-05-27", "07:32:00", "nan", "-inf", '[{ x = 1 }, "x"]', "{ x = 1 }", "[[1]]")
"""Those that no key takes, whatever its type."""


def written(value: Any) -> str:
    """Write a value as TOML."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        return '"' + "".join(c if c >= " " else f"\\u{ord(c):04X}" for c in escaped) + '"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{written(key)} = {written(each)}" for key, each in value.items()) + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(written, value)) + "]"
    return str(value)


def _text(data: Any, path: tuple[Any, ...], raw: str) -> str:
    """Write a document, a line for each key that is in no list, with one value replaced."""
    lines: list[str] = []

    def inline(value: Any, path: tuple[Any, ...] | None) -> str:
        if path == ():
            return raw
        if isinstance(value, dict):
            parts = (f"{written(k)} = {inline(v, _below(path, k))}" for k, v in value.items())
            return "{ " + ", ".join(parts) + " }"
        if isinstance(value, list):
            return "[" + ", ".join(inline(each, _below(path, k)) for k, each in enumerate(value)) + "]"
        return written(value)

    def walk(names: tuple[str, ...], value: Any, path: tuple[Any, ...] | None) -> None:
        if isinstance(value, dict) and value and path != ():
            for key, each in value.items():
                walk((*names, key), each, _below(path, key))
        else:
            lines.append(f"{'.'.join(map(written, names))} = {inline(value, path)}")

    for key, each in data.items():
        walk((key,), each, _below(path, key))
    return "\n".join(lines) + "\n"


def _below(path: tuple[Any, ...] | None, key: Any) -> tuple[Any, ...] | None:
    return path[1:] if path and path[0] == key else None


def places(data: Any) -> Iterator[tuple[tuple[Any, ...], Any]]:
    """Yield the place and the value of every key of a document, and of the first element of every list."""
    pairs = data.items() if isinstance(data, dict) else list(enumerate(data))[:1]
    for key, value in pairs:
        yield (key,), value
        if isinstance(value, dict | list):
            for path, inner in places(value):
                yield (key, *path), inner


def all_places(text: str) -> list[tuple[Any, ...]]:
    """Return the place of every key of a document, and of the first element of every list."""
    return [path for path, _ in places(tomllib.loads(text))]


def with_value(text: str, place: tuple[Any, ...], raw: str) -> tuple[Any, str]:
    """Return the value at a place of a document, and the document with another in its stead."""
    data = value = tomllib.loads(text)
    for key in place:
        value = value[key]
    return value, _text(data, place, raw)


def variants(text: str) -> Iterator[tuple[tuple[Any, ...], str]]:
    """Yield the place of a key and what is written in the stead of its value."""
    for place in all_places(text):
        for raw in WRONG:
            yield place, raw


QUANTITY = re.compile(r"flat|[-+]?[\d.]+(e[-+]?\d+)?( [a-zA-Z]\S*){0,3}")
"""A number with its unit."""


def must_be_refused(value: Any, raw: str) -> bool:
    """Tell whether a value is of a type that no key takes in the place of another."""
    if raw in NEVER:
        return True
    if isinstance(value, bool):
        return raw != "true"
    if isinstance(value, int | float) or (isinstance(value, str) and QUANTITY.fullmatch(value)):
        return raw in ("true", '"x"', '""', '"1 parsec"', "[]", "{}", "[true]")
    if isinstance(value, str):
        return raw in ("true", "-5", "0.5", "[]", "{}", "[true]", "1000000000000000000")
    if isinstance(value, list):
        return raw in ("true", "-5", "0.5", "{}", "[true]", '"x"')
    return raw in ("true", "-5", "0.5", "[]", "[true]", '"x"')


def flaw_of(read: Callable[[Path], object], path: Path, place: tuple[Any, ...], refused: bool) -> str:
    """Say what is wrong with how a file is read, or return nothing."""
    try:
        read(path)
    except ClubfaceError as error:
        message, keys = str(error), [each for each in place if isinstance(each, str)]
        if not refused:
            return ""
        if not any(key in message for key in (*keys[-2:], "x must be", "unknown")):
            return f"does not name the key: {message}"
        # A file that is named in its turn has its own name in its errors.
        return "" if f"{path.name}:" in message or path.name not in message else f"does not name the line: {message}"
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return "is taken" if refused else ""
