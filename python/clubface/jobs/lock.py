"""Locks: a file that one process holds while it works, and which process that is.

A file that one process holds for as long as it works, so that two do not write the same.

Which process it is, by more than its number: the system gives that to another process once the first has ended.
"""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.support.files import unwritable

BOOT = Path("/proc/sys/kernel/random/boot_id")
ENDED = ("Z", "X", "x")
"""States of a process that has ended and of which only the number is left."""


def this_process() -> dict[str, Any]:
    """Return who this process is, as :func:`is_running` takes it: machine, number, and when it began."""
    return {"machine": socket.gethostname(), "process": os.getpid(), "begun": _begun_itself(os.getpid())}


@cache
def _begun_itself(process: int) -> str:
    return begun(process)


def is_running(who: dict[str, Any]) -> bool:
    """Return whether a process of this machine runs that said :func:`this_process` of itself.

    Of a machine that does not tell when a process began, the number counts.
    """
    process = who.get("process")
    if who.get("machine") != socket.gethostname() or not isinstance(process, int) or isinstance(process, bool):
        return False
    if process <= 0:
        return False
    now, then = begun(process), who.get("begun")
    return bool(now) and then in (now, "", None)


def begun(process: int) -> str:
    """Return a text that tells when a process began, or that it runs where no more is known; "" where there is none."""
    if sys.platform == "linux":
        return _of_linux(process)
    if sys.platform == "win32":
        return _of_windows(process)
    return _of_others(process)


def _of_linux(process: int) -> str:
    try:
        # The name of the program, which may hold anything, stands in brackets.
        state, *rest = Path(f"/proc/{process}/stat").read_text(errors="replace").rpartition(")")[2].split()
        return "" if state in ENDED else f"{BOOT.read_text().strip()} {rest[18]}"
    except FileNotFoundError:
        return "" if Path("/proc/self/stat").exists() else _of_others(process)
    except (OSError, ValueError, IndexError):
        return _of_others(process)


def _of_others(process: int) -> str:
    try:
        os.kill(process, 0)
    except PermissionError:
        pass
    except (OSError, OverflowError):
        return ""
    with suppress(OSError, subprocess.SubprocessError):
        told = subprocess.run(
            ["ps", "-o", "lstart=", "-p", str(process)], capture_output=True, text=True, timeout=5.0, check=True
        )
        return told.stdout.strip()
    return "runs"


def _of_windows(process: int) -> str:
    import ctypes

    library: Any = ctypes.WinDLL("kernel32")  # pyright: ignore[reportAttributeAccessIssue]
    library.OpenProcess.restype = ctypes.c_void_p
    handle = ctypes.c_void_p(library.OpenProcess(0x1000, False, process))  # what it is allowed to ask of any process
    if not handle:
        return ""
    times, code = [ctypes.c_uint64() for _ in range(4)], ctypes.c_ulong()
    try:
        library.GetProcessTimes(handle, *map(ctypes.byref, times))
        library.GetExitCodeProcess(handle, ctypes.byref(code))
    finally:
        library.CloseHandle(handle)
    return str(times[0].value) if code.value == 259 else ""  # 259: it has not ended


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
