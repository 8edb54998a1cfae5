"""A bar under work that takes long."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from clubface.units import fixed

Update = Callable[..., object]
"""Takes what is done, the whole of it, and what else the text beside the bar tells of."""


@contextmanager
def progress_bar(text: str | Callable[..., str]) -> Iterator[Update | None]:
    """Show a bar on the error stream where that is a terminal.

    The ``text`` beside it is made of what the bar is told; a word is that for what is counted.
    """
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("starting", total=1.0)

        def update(done: float, whole: float, *more: Any) -> None:
            told = f"{done} of {whole} {text}" if isinstance(text, str) else text(done, whole, *more)
            bar.update(task, completed=done / (whole or 1), description=told)

        yield update


def run_with_progress(run: Callable[[Update | None], Any]) -> Any:
    """Run an impact of finite elements under a bar."""
    with progress_bar(lambda time, whole: fixed(time, "us", 0)) as update:
        return run(update)
