"""A file that one process holds for as long as it works, so that two do not write the same."""

from __future__ import annotations

import json
import os
import sys
from contextlib import suppress
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.support.process_identity import is_running, this_process
from clubface.support.whole_file import unwritable

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

LONGEST = 1000
"""Bytes of what a holder says of itself."""


class Lock:
    """Holds a file until :meth:`release`, or until the process ends, even if it is killed.

    The system holds it, if the drive can; on one that has no locks, the file says which process holds it.

    Parameters
    ----------
    path
        The file, which is made if need be.
    of
        What is written meanwhile, for people.

    Raises
    ------
    FileError
        Another run holds it; the message names its process.
    """

    def __init__(self, path: Path, of: Path) -> None:
        self._path = path
        while True:
            try:
                self._handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
            except OSError as error:
                raise unwritable(of, error) from None
            try:
                self._take(of)
                if os.path.samestat(os.fstat(self._handle), os.stat(path)):
                    break
            except FileNotFoundError:
                pass  # whoever held it has ended and removed it since
            except BaseException:
                os.close(self._handle)
                raise
            os.close(self._handle)
        # A full disk does not keep anyone from work.
        with suppress(OSError):
            os.ftruncate(self._handle, 0)
            os.lseek(self._handle, 0, os.SEEK_SET)
            os.write(self._handle, json.dumps(this_process()).encode())

    def _take(self, of: Path) -> None:
        held = _held_by_system(self._handle)
        if held is False or (held is None and is_running(self._holder())):
            message = f"process {self._holder().get('process', 'unknown')} is writing this; wait until it ends, or give"
            raise FileError(str(of), None, f"{message} another name")

    def _holder(self) -> dict[str, Any]:
        """Return what the last holder said of itself; nothing where that is not known."""
        with suppress(OSError, ValueError):
            os.lseek(self._handle, 0, os.SEEK_SET)
            found = json.loads(os.read(self._handle, LONGEST))
            return found if isinstance(found, dict) else {}
        return {}

    def close(self) -> None:
        """Let go of the file and remove it."""
        self.release(remove=True)

    def release(self, *, remove: bool = False) -> None:
        """Let go of the file, and remove it if wanted."""
        if self._handle < 0:
            return
        if remove and sys.platform != "win32":  # while it is held: another may hold it as soon as it is let go
            with suppress(OSError):
                os.unlink(self._path)
        os.close(self._handle)
        self._handle = -1
        if remove and sys.platform == "win32":  # which removes no file that anyone has opened
            with suppress(OSError):
                os.unlink(self._path)


def _held_by_system(handle: int) -> bool | None:
    """Take the lock of an open file: True if it is held now, False if another process holds it, None without locks."""
    try:
        if sys.platform == "win32":
            os.lseek(handle, 1_000_000, os.SEEK_SET)  # beyond the text, which others read
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        else:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:
        return None  # a network drive without locks
    return True
