"""What every computation takes besides its physics: what a bad shot does, how many threads, which tolerance."""

from __future__ import annotations

from clubface import units
from clubface.errors import InputError
from clubface.support.checks import check_choice, whole

MOST_THREADS = 1024
"""More than any machine has cores; a slip of the keyboard shall not start a million."""


FINEST, COARSEST = 1e-13, 1e-2
"""Tolerances of a step that the core takes."""


def check_on_error(on_error: object) -> None:
    """Refuse a word that is not "raise" or "nan"."""
    check_choice("on_error", on_error, ("raise", "nan"))


def thread_count(threads: object) -> int:
    """Return the number of threads as the core takes it, 0 for all cores."""
    if threads is None:
        return 0
    count = whole(threads)
    if count is None or not 1 <= count <= MOST_THREADS:
        raise InputError("threads", threads, f"a whole number from 1 to {MOST_THREADS}, or None for all cores")
    return count


def tolerance(accuracy: object) -> float | None:
    """Return the tolerance of a step, None for the fast setting."""
    if accuracy is None:
        return None
    found = units.parse(accuracy, units.DIMENSIONLESS, name="accuracy")
    if not FINEST <= found <= COARSEST:
        raise InputError("accuracy", accuracy, "from 1e-13 to 1e-2; leave it out for the fast setting")
    return found
