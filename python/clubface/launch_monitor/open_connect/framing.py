"""JSON objects from a stream of bytes, which may be cut anywhere and has no separators."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

LARGEST = 65_536
"""Bytes of a message; one of Open Connect has less than 2000."""
DEEPEST = 16
"""Objects in objects; Open Connect has two."""
_SPACE = b" \t\r\n\x00"
_QUOTE, _ESCAPE = ord('"'), ord("\\")
_OPEN, _CLOSE = b"{[", b"}]"


class Broken(NamedTuple):
    """Bytes that are not a message, and the reason."""

    reason: str


class ObjectStream:
    """Collects bytes and returns the JSON objects in them, each as soon as its last brace has arrived."""

    def __init__(self) -> None:
        self._held = bytearray()
        self.drop()

    def drop(self) -> None:
        """Discard an unfinished message; the next bytes begin a new one."""
        self._held.clear()
        self._seen = 0
        self._depth = 0
        self._in_text = False
        self._escaped = False
        self._in_garbage = False

    @property
    def is_partial(self) -> bool:
        """Whether a message has begun and not ended."""
        return self._depth > 0

    def feed(self, data: bytes) -> list[dict[str, Any] | Broken]:
        """Return the messages that ``data`` completes, and a :class:`Broken` for bytes that are not a message."""
        self._held += data
        found: list[dict[str, Any] | Broken] = []
        while self._seen < len(self._held):
            byte = self._held[self._seen]
            self._seen += 1
            if self._depth == 0:
                self._between(byte, found)
            elif self._in_text:
                self._text(byte)
            elif byte == _QUOTE:
                self._in_text = True
            elif byte in _OPEN:
                self._depth += 1
            elif byte in _CLOSE:
                self._depth -= 1
                if self._depth == 0:
                    found.append(_parsed(bytes(self._held[: self._seen])))
                    self._cut()
            if self._seen > LARGEST or self._depth > DEEPEST:
                found.append(Broken(f"a message longer than {LARGEST} bytes or deeper than {DEEPEST} levels"))
                rest = bytes(self._held[self._seen :])
                self.drop()
                self._in_garbage = True
                self._held += rest
        return found

    def _between(self, byte: int, found: list[dict[str, Any] | Broken]) -> None:
        if byte == _OPEN[0]:
            self._depth = 1
            self._in_garbage = False
            del self._held[: self._seen - 1]
            self._seen = 1
            return
        if byte not in _SPACE and not self._in_garbage:
            self._in_garbage = True
            found.append(Broken(f"no JSON object begins with {chr(byte)!r}"))
        self._cut()

    def _text(self, byte: int) -> None:
        if self._escaped:
            self._escaped = False
        elif byte == _ESCAPE:
            self._escaped = True
        elif byte == _QUOTE:
            self._in_text = False

    def _cut(self) -> None:
        del self._held[: self._seen]
        self._seen = 0


def _parsed(text: bytes) -> dict[str, Any] | Broken:
    try:
        found = json.loads(text.decode("utf-8"))
    except UnicodeDecodeError:
        return Broken("not UTF-8 text")
    except (ValueError, RecursionError) as error:
        return Broken(f"not JSON: {error}")
    return found if isinstance(found, dict) else Broken("no JSON object")
