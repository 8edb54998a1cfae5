"""The script of the isolated processes in :mod:`clubface.support.processes`: answers calls until its input ends.

It imports nothing from clubface, so that it starts fast.
"""

from __future__ import annotations

import os
import pickle
import runpy
import struct
import sys
from contextlib import suppress
from typing import Any

try:
    import resource
except ImportError:  # not available on Windows
    resource = None


def main() -> None:
    """Answer calls from standard input on standard output; output of libraries is discarded."""
    answers = os.fdopen(os.dup(1), "wb")
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    requests = sys.stdin.buffer
    functions: dict[str, dict[str, Any]] = {}
    if resource is not None:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    while head := requests.read(8):
        file, function, arguments, memory = pickle.loads(requests.read(struct.unpack("<Q", head)[0]))
        limit_memory(memory)
        answer = pickle.dumps(answered(file, function, arguments, functions), protocol=5)
        answers.write(struct.pack("<Q", len(answer)) + answer)
        answers.flush()


def limit_memory(size: int) -> None:
    """Limit the memory of this process to ``size`` bytes, if the system supports it."""
    if resource is None:
        return
    most = resource.getrlimit(resource.RLIMIT_AS)[1]
    with suppress(OSError, ValueError):
        resource.setrlimit(resource.RLIMIT_AS, (size if most == resource.RLIM_INFINITY else min(size, most), most))


def answered(file: str, function: str, arguments: Any, functions: dict[str, dict[str, Any]]) -> tuple[str, Any]:
    """Return "found" and a function's result, "missing" and the name of a library, or "error" and the reason."""
    try:
        if file not in functions:
            functions[file] = runpy.run_path(file)
        return "found", functions[file][function](*arguments)
    except ModuleNotFoundError as error:
        return "missing", error.name
    except MemoryError:
        return "error", "it needs more memory than any valid file"
    except (Exception, SystemExit) as error:
        return "error", " ".join(str(error).split()) or type(error).__name__


if __name__ == "__main__":
    main()
