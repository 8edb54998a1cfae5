"""A bar under runs of finite elements."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from clubface.units import fixed


@contextmanager
def progress_bar() -> Iterator[Callable[[float, float, str], object] | None]:
    """Show a bar on the error stream where that is a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("starting", total=1.0)
        yield lambda part, whole, text: bar.update(task, completed=part / whole, description=text)


def run_with_progress(run: Callable[[Callable[[float, float], object] | None], Any]) -> Any:
    """Run an impact under a bar."""
    with progress_bar() as update:
        return run(update and (lambda time, whole: update(time, whole, f"{fixed(time, 'us', 0)}")))
