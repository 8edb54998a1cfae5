"""A file that one process holds for as long as it works, so that two do not write the same."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from clubface.errors import FileError
from clubface.support.whole_file import unwritable

try:
    import fcntl
except ImportError:  # on Windows nothing is locked
    fcntl = None


class Lock:
    """Holds a file until :meth:`release`, or until the process ends, even if it is killed.

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
        # Who it is, is for people; a full disk does not keep anyone from work.
        with suppress(OSError):
            os.ftruncate(self._handle, 0)
            os.pwrite(self._handle, str(os.getpid()).encode(), 0)

    def _take(self, of: Path) -> None:
        if fcntl is None:
            return
        try:
            fcntl.flock(self._handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            holder = os.pread(self._handle, 20, 0).decode(errors="replace")
            message = f"process {holder or 'unknown'} is writing this; wait until it ends, or give another name"
            raise FileError(str(of), None, message) from None
        except OSError:
            return  # a network drive without locks

    def close(self) -> None:
        """Let go of the file and remove it."""
        self.release(remove=True)

    def release(self, *, remove: bool = False) -> None:
        """Let go of the file, and remove it if wanted."""
        if self._handle < 0:
            return
        if remove:
            with suppress(OSError):
                os.unlink(self._path)
        os.close(self._handle)
        self._handle = -1
