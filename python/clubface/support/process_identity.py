"""Which process it is, by more than its number: the system gives that to another process once the first has ended."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

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
