"""The command ``clubface``. Each command is a module of this package, imported only when it is used."""

from __future__ import annotations

import gc
import os
import sys
from contextlib import suppress

INTERRUPTED = 130
"""The exit status after Ctrl-C."""


def main() -> None:
    """Run the command line and exit with its status."""
    # The matrices of the commands are small. Starting OpenBLAS's threads costs more than a shot, and on a busy machine
    # they wait for each other: motion capture then takes ten times as long.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # What modules define while they are loaded lives on. Searching it for garbage would take a twentieth of a shot.
    gc.set_threshold(50_000)
    try:
        from clubface.cli.app import run

        status = run(sys.argv[1:])
    except ModuleNotFoundError as error:
        from clubface.cli.failures import missing_library

        status = missing_library(error)
    # Interrupted while modules are loaded; a command reports its own interruption.
    except KeyboardInterrupt as stop:
        from clubface.cli.failures import report

        status = report(stop)
    if status == INTERRUPTED:
        _leave_at_once()
    sys.exit(status)


def _leave_at_once() -> None:
    """Exit without the clean-up of libraries, which takes time: all work has been saved, and the user is waiting."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()
    os._exit(INTERRUPTED)
