"""What jobs of tests compute, in a module that worker processes can import."""

import os
import signal
import time
from pathlib import Path

KILL = getattr(signal, "SIGKILL", signal.SIGTERM)
"""Ends a process at once, as any signal does on Windows."""


def square(number):
    return [number, number**2 / 7.0]


def square_slowly(number):
    time.sleep(0.02)
    return square(number)


def dies_once(folder, number):
    """Return a square, by the second process that tries: the first one is killed, as for lack of memory."""
    mark = Path(folder) / str(number)
    if number % 3 == 0 and not mark.exists():
        mark.touch()
        os.kill(os.getpid(), KILL)
    return square(number)


def dies(number):
    os.kill(os.getpid(), KILL)


def lacks_memory(number):
    raise MemoryError


def environment(name):
    return os.environ.get(name), os.getpid(), signal.getsignal(signal.SIGINT) == signal.SIG_IGN
