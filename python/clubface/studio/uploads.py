"""Files that a person chose in the browser: their bytes in memory, read as the command line reads a file.

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
"""Bytes of a file: a hundred thousand shots."""
MOST_FILES = 8
"""Files that are kept; the one that was not asked for longest makes room."""
LONGEST_NAME = 100
R = TypeVar("R")


class TooLargeError(InputError):
    """A request with more bytes than are taken."""


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
        """Return a function of the shots, which reads no other file meanwhile."""
        with own_files_only(self.name, self.content):
            return function(self.shots)


class Uploads:
    """The files of this run, by names that are made up."""

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
    """Let a computation read a file of these bytes, where it is given, and what comes with the package, alone."""
    given = {}
    if content is not None:
        path, sum_ = absolute(name), hashlib.sha256(content).hexdigest()
        given[path] = InputFile(name, path, len(content), sum_, False, content)
    with InputRecord(given).active() as record:
        yield record


def bare_name(name: str) -> str:
    """Return the name of a file without folders, as it may stand in messages and reports."""
    plain = "".join(each for each in name.replace("\\", "/").rpartition("/")[2] if each.isprintable())
    stem, ending = os.path.splitext(plain.strip(". "))
    return f"{stem[: LONGEST_NAME - len(ending[:10])]}{ending[:10]}" or "session.csv"


async def body_of(request: Request, most: int = LARGEST) -> bytes:
    """Return the bytes of a request; one that goes on is cut off."""
    result = bytearray()
    async for piece in request.stream():
        result += piece
        if len(result) > most:
            size = f"{most // 1_000_000} MB" if most >= 1_000_000 else f"{most // 1000} kB"
            raise TooLargeError("file", Wording(f"larger than {size}"), "a smaller one, such as that of one session")
    return bytes(result)
