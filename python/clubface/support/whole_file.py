"""Files written whole or not at all: under another name until all of it is on the disk, then renamed."""

from __future__ import annotations

import io
import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO, TextIO

from clubface.errors import LINES, FileError, legible
from clubface.support.input_files import recorded_files

Name = str | os.PathLike[str]


def unwritable(path: Name, error: OSError) -> FileError:
    """Return what to tell where the system refuses to write a file."""
    if isinstance(error, FileExistsError):
        return FileError(os.fspath(path), None, "this file exists already; it is left as it is")
    return FileError(os.fspath(path), None, f"cannot be written: {error.strerror or error}")


@contextmanager
def whole_file(path: Name, *, folder: Path | None = None, new: bool = False) -> Iterator[BinaryIO]:
    """Open a file to write, which takes the place of ``path`` once the block is left and all is on the disk.

    If the block raises, or the disk is full, what stood under the name before stands there still. Libraries that want a
    path are given the ``name`` of the file that is yielded.

    Parameters
    ----------
    path
        The name in the end. A link is followed; a device or a pipe is refused.
    folder
        Where the file lies until then, on the same disk: beside ``path`` unless given.
    new
        Whether a file that has the name already is an error.

    Raises
    ------
    FileError
        The system refused to write, or the file is an input of the computation that writes it.
    """
    target = Path(os.path.realpath(path))
    if os.fspath(target) in {each.place for each in recorded_files()}:
        raise FileError(os.fspath(path), None, "this must be another file than those that are read")
    try:
        mode = _mode_of(target, new)
        fresh = (folder or target.parent) / f".{target.stem[:100]}-{os.urandom(6).hex()}{target.suffix}"
        file = open(fresh, "x+b")  # noqa: SIM115, it is closed below
    except OSError as error:
        raise unwritable(path, error) from None
    try:
        with file:
            yield file
            file.flush()
            if mode is not None:
                os.chmod(fresh, mode)
            os.fsync(file.fileno())
        if new:
            os.link(fresh, target)
            os.unlink(fresh)
        else:
            os.replace(fresh, target)
        synced(target.parent)
    except BaseException as error:
        with suppress(OSError):
            os.unlink(fresh)
        if isinstance(error, OSError):
            raise unwritable(path, error) from None
        raise


@contextmanager
def whole_text(path: Name) -> Iterator[TextIO]:
    """Open a file for text in UTF-8; line ends are written as they are given. See :func:`whole_file`."""
    with whole_file(path) as file:
        text = io.TextIOWrapper(file, encoding="utf-8", newline="", write_through=True)
        yield text
        text.detach()


def write_text(path: Name, text: str, *, encoding: str = "utf-8", new: bool = False) -> Path:
    """Write a file of text, whole or not at all; return its path. What no page or table should get, is escaped."""
    with whole_file(path, new=new) as file:
        file.write(legible(text, LINES).encode(encoding))
    return Path(path)


def synced(folder: Path) -> None:
    """Bring the names in a folder to the disk, where the system can."""
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _mode_of(target: Path, new: bool) -> int | None:
    """Return the rights of the file that is there, None where there is none; refuse what is no file to replace."""
    try:
        found = target.stat()
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(found.st_mode):
        raise FileError(str(target), None, "this is a folder; give the name of a file")
    if not stat.S_ISREG(found.st_mode):
        raise FileError(str(target), None, "this is a device or a pipe; give the name of a file")
    if new:
        raise FileExistsError
    return stat.S_IMODE(found.st_mode)
