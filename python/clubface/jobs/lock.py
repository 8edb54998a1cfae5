"""A lock file held by one process while it works, so that no two write the same output."""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from pathlib import Path

from clubface.errors import FileError
from clubface.support.files import unwritable

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

__all__ = ["Lock"]

HELD_BYTE = 1_000_000
"""Position of the byte that Windows locks: beyond the text, which other processes read."""


class Lock:
    """Holds a file until :meth:`close`, or until the process ends, even if it is killed.

    The operating system holds the lock. On a network drive without locks nothing is locked; this does no harm, since
    two runs of the same work write the same files, each of them completely.

    Parameters
    ----------
    path
        The file, created if needed. It contains the process number, for messages.
    output
        The output being written, for messages.

    Raises
    ------
    FileError
        Another run holds it; the message names its process.
    """

    def __init__(self, path: Path, output: Path) -> None:
        self._path = path
        while True:
            try:
                path.parent.mkdir(exist_ok=True)
                self._handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
            except FileNotFoundError:
                if path.parent.parent.is_dir():
                    continue  # the process that held it has just removed its folder
                raise
            except OSError as error:
                raise unwritable(output, error) from None
            try:
                self._acquire(output)
                if os.path.samestat(os.fstat(self._handle), os.stat(path)):
                    break
            except FileNotFoundError:
                pass
            except BaseException:
                os.close(self._handle)
                raise
            os.close(self._handle)  # the file was removed by the process that held it: open a new one
        with suppress(OSError):  # do not stop because of a full disk
            os.ftruncate(self._handle, 0)
            os.write(self._handle, str(os.getpid()).encode())

    def _acquire(self, output: Path) -> None:
        try:
            if sys.platform == "win32":
                os.lseek(self._handle, HELD_BYTE, os.SEEK_SET)
                msvcrt.locking(self._handle, msvcrt.LK_NBLCK, 1)
                os.lseek(self._handle, 0, os.SEEK_SET)
            else:
                fcntl.flock(self._handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except (BlockingIOError, PermissionError):
            os.lseek(self._handle, 0, os.SEEK_SET)
            holder = os.read(self._handle, 20).decode(errors="replace")
            process = holder if holder.isdecimal() else "unknown"
            message = f"process {process} is writing this; wait until it ends, or give another name"
            raise FileError(str(output), None, message) from None
        except OSError:
            pass  # a network drive without locks

    def close(self) -> None:
        """Release the lock and remove the file."""
        if self._handle < 0:
            return
        if sys.platform != "win32":  # while it is held, since another process may take it as soon as it is free
            with suppress(OSError):
                os.unlink(self._path)
        self.release()
        if sys.platform == "win32":  # which does not remove a file that is open
            with suppress(OSError):
                os.unlink(self._path)

    def release(self) -> None:
        """Release the lock and keep the file."""
        if self._handle >= 0:
            os.close(self._handle)
            self._handle = -1
