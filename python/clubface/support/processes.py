"""Isolated processes for libraries that may crash; available memory and processors.

A library that a damaged file can crash is called in a separate process with limits: a crash, an endless loop or
excessive memory use ends that process and raises one error here. The process is kept for further calls, so that only
the first call waits for its start, a tenth of a second; after a crash it is replaced.

The available memory is queried so that requests that are too large raise an error before anything is allocated; the
processor, because its vector units may change the last bits of a result.
"""

from __future__ import annotations

import atexit
import os
import pickle
import platform
import signal
import struct
import subprocess
import sys
import threading
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import Any

from clubface.errors import InputError

SCRIPT = Path(__file__).with_name("isolated_script.py")
LEAST_MEMORY = 2 * 2**30
"""Memory allowance of a library [bytes] beyond what a file needs, including Python and NumPy."""
LEAST_TIME = 30.0
"""Time limit for the smallest file [s]; a whole session takes a few seconds."""


class IsolatedError(Exception):
    """A call in an isolated process failed; the text says why."""


class IsolatedProcess:
    """A process that calls the functions of one file, one at a time.

    Parameters
    ----------
    file
        A Python file that imports nothing from clubface, so that the process starts fast.
    """

    def __init__(self, file: Path) -> None:
        self._file = file
        self._lock = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None
        self._owner = 0

    def call(self, function: str, *arguments: Any, memory: int = 0, seconds: float = 0.0) -> Any:
        """Call a function in the process and return its result.

        Parameters
        ----------
        function, *arguments
            Name of the function, and its arguments, which must be picklable.
        memory, seconds
            Allowance in addition to ``LEAST_MEMORY`` [bytes] and ``LEAST_TIME`` [s].

        Raises
        ------
        IsolatedError
            The function raised an error, or its process crashed, ran out of memory or took too long.
        ModuleNotFoundError
            A library is not installed.
        """
        if self._owner != os.getpid():  # after a fork, the process and perhaps the lock belong to the parent
            self._lock, self._process, self._owner = threading.Lock(), None, os.getpid()
        with self._lock:
            try:
                kind, result = self._answer((str(self._file), function, arguments, LEAST_MEMORY + memory), seconds)
            except BaseException:
                self._end()  # a late answer would be mistaken for that of the next call
                raise
        if kind == "missing":
            raise ModuleNotFoundError(f"No module named {result!r}", name=result)
        if kind == "error":
            raise IsolatedError(result)
        return result

    def _answer(self, request: Any, seconds: float) -> tuple[str, Any]:
        process = self._started()
        assert process.stdin is not None
        assert process.stdout is not None
        limit = LEAST_TIME + seconds
        late = threading.Event()

        def stop() -> None:
            late.set()
            process.kill()

        timer = threading.Timer(limit, stop)
        timer.daemon = True
        timer.start()
        try:
            words = pickle.dumps(request)
            process.stdin.write(struct.pack("<Q", len(words)) + words)
            process.stdin.flush()
            size = struct.unpack("<Q", process.stdout.read(8))[0]
            answer = process.stdout.read(size)
            return pickle.loads(answer)
        except (OSError, struct.error, EOFError, pickle.UnpicklingError):
            if late.is_set():
                raise IsolatedError(f"it takes longer than {limit:.0f} s") from None
            raise IsolatedError(f"the library that reads it {_describe_end(process)}") from None
        finally:
            timer.cancel()

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is None or self._process.poll() is not None:
            self._process = subprocess.Popen(
                [sys.executable, "-P", str(SCRIPT)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), "OPENBLAS_NUM_THREADS": "1"},
                start_new_session=True,  # Ctrl-C is for the caller, which then ends it; so it is
                creationflags=getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0),  # on Windows
            )
            atexit.register(self._end)
        return self._process

    def _end(self) -> None:
        process, self._process = self._process, None
        if process is not None and self._owner == os.getpid():
            process.kill()
            for stream in (process.stdin, process.stdout):
                if stream is not None:
                    with suppress(OSError):
                        stream.close()
            process.wait()


def _describe_end(process: subprocess.Popen[bytes]) -> str:
    """Return how a process ended, in words."""
    status = process.wait()
    if status >= 0:
        return f"ended with status {status}"
    with suppress(ValueError):
        return f"crashed ({signal.Signals(-status).name})"
    return f"crashed (signal {-status})"


UNKNOWN = 4 * 2**30
"""Memory assumed if the system does not report it [bytes]."""

SHARE = 0.5
"""Share of the free memory that one request may use; tables of its result need memory too."""

FAILED = 400
"""Memory for the record of a failed shot: row, parameter and a sentence [bytes]."""
_SMALL = 64 * 2**20
"""Requests below this size are not checked [bytes]."""


def available_memory() -> int:
    """Return the memory still available [bytes], within the limits of system, container and process."""
    limits = [_of_system(), *_of_container()]
    return max(0, min(limits))


def check_request(shots: int, bytes_a_shot: int) -> None:
    """Raise InputError if ``shots`` would need more than ``SHARE`` of the free memory."""
    needed = shots * bytes_a_shot
    if needed <= _SMALL:
        return
    allowed = int(SHARE * available_memory())
    if needed > allowed:
        fit = allowed // bytes_a_shot
        raise InputError(
            "the number of shots",
            shots,
            f"at most {fit} with the free memory ({needed / 1e9:.1f} GB needed); compute them in batches, or from"
            " a file of any length with clubface.predict",
        )


def _of_system() -> int:
    if sys.platform == "win32":
        import ctypes

        status = (ctypes.c_uint64 * 8)(64)  # a MEMORYSTATUSEX, which begins with its own size
        return status[2] if ctypes.windll.kernel32.GlobalMemoryStatusEx(status) else UNKNOWN
    try:
        for line in Path("/proc/meminfo").read_text().splitlines():
            if line.startswith("MemAvailable:"):
                return int(line.split()[1]) * 1024
    except (OSError, ValueError, IndexError):
        pass
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2
    except (AttributeError, OSError, ValueError):
        return UNKNOWN


def _of_container() -> list[int]:
    root = Path("/sys/fs/cgroup")
    result = []
    for limit, used in (
        (root / "memory.max", root / "memory.current"),
        (root / "memory" / "memory.limit_in_bytes", root / "memory" / "memory.usage_in_bytes"),
    ):
        try:
            result.append(int(limit.read_text()) - int(used.read_text()))
        except (OSError, ValueError):
            continue
    return result


def processors() -> int:
    """Return the number of processors available to this process, as limited by a cluster's scheduler."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not Linux
        return os.cpu_count() or 1


@cache
def vector_units() -> str:
    """Return the processor type and the widest vector unit that finite elements use, such as "x86_64 avx2"."""
    machine = platform.machine() or "unknown"
    flags: set[str] = set()
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("flags"):
                flags = set(line.partition(":")[2].split())
                break
    except OSError:
        return machine  # not Linux
    if {"avx512f", "avx512dq"} <= flags:
        return f"{machine} avx512"
    return f"{machine} avx2" if {"avx2", "fma"} <= flags else machine
