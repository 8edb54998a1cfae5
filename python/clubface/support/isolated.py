"""Functions of libraries that damaged files can crash, called in a process of their own, within limits.

A crash, endless work or a request for all memory then ends that process and is one error here. It stays for further
calls, so that the first alone waits for it to start, a tenth of a second; another takes its place after a crash.
"""

from __future__ import annotations

import atexit
import os
import pickle
import signal
import struct
import subprocess
import sys
import threading
from contextlib import suppress
from pathlib import Path
from typing import Any

SCRIPT = Path(__file__).with_name("isolated_script.py")
LEAST_MEMORY = 2 * 2**30
"""Bytes that a library may ask for beside what a file needs: it, Python and NumPy are among them."""
LEAST_TIME = 30.0
"""Seconds that it may take for the smallest file; a whole session is read in a few."""


class IsolatedError(Exception):
    """A call in an isolated process that came to nothing: its text says why there is no result."""


class IsolatedProcess:
    """A process that calls the functions of one file, one at a time.

    Parameters
    ----------
    file
        A Python file that imports nothing of clubface, so that the process starts fast.
    """

    def __init__(self, file: Path) -> None:
        self._file = file
        self._lock = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None
        self._owner = 0

    def call(self, function: str, *arguments: Any, memory: int = 0, seconds: float = 0.0) -> Any:
        """Return what a function returns.

        Parameters
        ----------
        function, *arguments
            Its name, and what can be pickled.
        memory, seconds
            What it may take beyond ``LEAST_MEMORY`` [bytes] and ``LEAST_TIME`` [s].

        Raises
        ------
        IsolatedError
            The function raised an error, or its process crashed, ran out of memory or took too long.
        ModuleNotFoundError
            A library is not installed.
        """
        if self._owner != os.getpid():  # the process belongs to the one that this was forked from, and so may the lock
            self._lock, self._process, self._owner = threading.Lock(), None, os.getpid()
        with self._lock:
            try:
                kind, found = self._answer((str(self._file), function, arguments, LEAST_MEMORY + memory), seconds)
            except BaseException:
                self._end()  # an answer that was not waited for would be taken for that of the next call
                raise
        if kind == "missing":
            raise ModuleNotFoundError(f"No module named {found!r}", name=found)
        if kind == "error":
            raise IsolatedError(found)
        return found

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
            told = pickle.dumps(request)
            process.stdin.write(struct.pack("<Q", len(told)) + told)
            process.stdin.flush()
            size = struct.unpack("<Q", process.stdout.read(8))[0]
            answer = process.stdout.read(size)
            return pickle.loads(answer)
        except (OSError, struct.error, EOFError, pickle.UnpicklingError):
            if late.is_set():
                raise IsolatedError(f"it takes longer than {limit:.0f} s") from None
            raise IsolatedError(f"the library that reads it {_ended(process)}") from None
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
                start_new_session=True,  # Ctrl-C is for the caller, which then ends it
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


def _ended(process: subprocess.Popen[bytes]) -> str:
    """Say how a process ended."""
    status = process.wait()
    if status >= 0:
        return f"ended with status {status}"
    with suppress(ValueError):
        return f"crashed ({signal.Signals(-status).name})"
    return f"crashed (signal {-status})"
