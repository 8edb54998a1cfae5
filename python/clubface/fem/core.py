"""Calls into the compiled finite element core: errors are translated, and Ctrl-C works at any time."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any, TypeVar

from clubface.errors import ShotError

T = TypeVar("T")

THE_RUN = "the run"
"""Named in errors that no input causes."""

Progress = Callable[[float, float], object]
"""Called with simulated time and duration [s]."""


def core_call(function: Callable[..., T], *arguments: Any, progress: Progress | None = None) -> T:
    """Call the core in a second thread, so that Ctrl-C stops the run at once and keeps the results so far."""
    stop = threading.Event()

    def watch(time: float, whole: float) -> None:
        if stop.is_set():
            raise KeyboardInterrupt
        if progress is not None:
            progress(time, whole)

    with translated_errors():
        if threading.current_thread() is not threading.main_thread():
            return function(*arguments, watch)
        with ThreadPoolExecutor(1) as pool:
            try:
                running = pool.submit(function, *arguments, watch)
                while True:
                    try:
                        return running.result(timeout=0.5)
                    except TimeoutError:
                        if running.done():
                            raise
                    except KeyboardInterrupt:
                        if stop.is_set():
                            raise
                        stop.set()
            finally:
                # Stop the run if the wait ended for any other reason, such as an exception.
                stop.set()


def in_thread(function: Callable[..., Any], *arguments: Any) -> Any:
    """Call the core in a second thread; Ctrl-C ends the wait, while the core finishes its work."""
    with translated_errors(), ThreadPoolExecutor(1) as pool:
        return pool.submit(function, *arguments).result()


@contextmanager
def translated_errors() -> Iterator[None]:
    """Translate an input error of the core, ``ValueError(name, value, allowed)``, into a :class:`ShotError`."""
    try:
        yield
    except ValueError as error:
        if len(error.args) != 3:
            raise
        name, value, allowed = error.args  # name and value may be empty
        raise ShotError(name or THE_RUN, value or None, f"{value}; {allowed}" if value else allowed) from None
