"""Files chosen in the browser: kept in memory, and read as the command line reads files.

What is computed from them sees these bytes under a bare name, and no other file but those that come with the package.
"""

from __future__ import annotations

import hashlib
import os
import secrets
from collections import OrderedDict
from collections.abc import Callable, Mapping
from contextlib import contextmanager
from threading import RLock
from typing import Any, NamedTuple, TypeVar

from starlette.requests import Request

from clubface.errors import InputError, Wording
from clubface.shots.reading import read
from clubface.shots.recorded import RecordedShots
from clubface.support.files import InputFile, InputRecord, absolute

__all__ = ["LARGEST", "MOST_FILES", "TooLargeError", "Upload", "Uploads", "bare_name", "body_of", "own_files_only"]

LARGEST = 20_000_000
"""Largest file [bytes]: a hundred thousand shots."""
MOST_FILES = 8
"""Number of files kept; the least recently used one makes room."""
LONGEST_NAME = 100
R = TypeVar("R")


class TooLargeError(InputError):
    """A request that is too large."""


class Upload(NamedTuple):
    """A file and its shots.

    Attributes
    ----------
    name
        Its name without folders.
    content
        Its bytes.
    shots
        What was read of it.
    """

    name: str
    content: bytes
    shots: RecordedShots

    def compute(self, function: Callable[[RecordedShots], R]) -> R:
        """Call a function with the shots, without access to other files."""
        with own_files_only(self.name, self.content):
            return function(self.shots)


class Uploads:
    """The files of this run, under generated names."""

    def __init__(self) -> None:
        self._files: OrderedDict[str, Upload] = OrderedDict()
        self._lock = RLock()

    def add(self, name: str, content: bytes, options: Mapping[str, Any]) -> tuple[str, Upload]:
        """Read a file; ``options`` are those of :func:`clubface.shots.read`."""
        if not content:
            raise InputError("file", Wording("empty"), "one with the shots of a launch monitor")
        with own_files_only(name, content):
            upload = Upload(name, content, read(name, **options))
        identity = secrets.token_urlsafe(9)
        with self._lock:
            self._files[identity] = upload
            while len(self._files) > MOST_FILES:
                self._files.popitem(last=False)
        return identity, upload

    def get(self, identity: str) -> Upload:
        """Return a file."""
        with self._lock:
            if identity not in self._files:
                raise InputError("file", identity, "one that is still open here: choose the file again")
            self._files.move_to_end(identity)
            return self._files[identity]


@contextmanager
def own_files_only(name: str = "", content: bytes | None = None) -> Any:
    """Restrict a computation to reading this file, if given, and the files of the package."""
    given = {}
    if content is not None:
        path, sum_ = absolute(name), hashlib.sha256(content).hexdigest()
        given[path] = InputFile(name, path, len(content), sum_, False, content)
    with InputRecord(given).active() as record:
        yield record


def bare_name(name: str) -> str:
    """Return the name of a file without folders, for messages and reports."""
    plain = "".join(each for each in name.replace("\\", "/").rpartition("/")[2] if each.isprintable())
    stem, ending = os.path.splitext(plain.strip(". "))
    return f"{stem[: LONGEST_NAME - len(ending[:10])]}{ending[:10]}" or "session.csv"


async def body_of(request: Request, most: int = LARGEST) -> bytes:
    """Return the body of a request; one that is too long is cut off."""
    result = bytearray()
    async for piece in request.stream():
        result += piece
        if len(result) > most:
            size = f"{most // 1_000_000} MB" if most >= 1_000_000 else f"{most // 1000} kB"
            raise TooLargeError("file", Wording(f"larger than {size}"), "a smaller one, such as that of one session")
    return bytes(result)
