"""Shared code around a command's result: legible output, checks of output files, templates and progress bars."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from time import monotonic
from typing import Any

from clubface.cli.failures import print_note
from clubface.errors import LINES, ClubfaceError, InputError, legible
from clubface.support.files import place_of, prepared_folder, recorded_files, write_text
from clubface.units import fixed


class _Legible:
    """A text stream that passes all text through :func:`clubface.errors.legible`.

    On a terminal, escape sequences for bold text, and on the error stream those of progress bars, are let through:
    tables, notes and messages, which may contain foreign text, have been made legible before.
    """

    def __init__(self, stream: Any, own: str) -> None:
        self._stream, self._own = stream, f"(\033\\[[0-9;?]*[{own}])"

    def write(self, text: str) -> int:
        """Write a text."""
        own = self._own if "\033" in text and self._stream.isatty() else "(?!)"
        parts = re.split(own, text)
        self._stream.write("".join(part if place % 2 else legible(part, LINES) for place, part in enumerate(parts)))
        return len(text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


@contextmanager
def legible_streams() -> Iterator[None]:
    """Make control characters from files harmless on standard output and error."""
    with redirect_stdout(_Legible(sys.stdout, "m")), redirect_stderr(_Legible(sys.stderr, "A-Za-z")):  # pyright: ignore[reportArgumentType]
        yield


def check_target(name: str, target: str | None, kinds: Sequence[str], inputs: Iterable[str | None] = ()) -> None:
    """Raise InputError for an output file of a wrong type, in a missing folder, or equal to one of the ``inputs``.

    Errors are raised before any work. ``kinds`` are the allowed file extensions.
    """
    if target is None:
        return
    path = Path(target)
    if path.suffix.lower() not in kinds:
        raise InputError(name, target, f"a file whose name ends in {', '.join(kinds)}")
    if not path.parent.is_dir():
        raise InputError(name, target, "a file in a folder that exists")
    if path.is_dir():
        raise InputError(name, target, "a file, not a folder")
    for given in inputs:
        if given is not None and path.exists() and os.path.exists(given) and path.samefile(given):
            raise InputError(name, target, "a file other than the inputs")


def check_not_read(target: str | None) -> None:
    """Raise InputError for an ``--output`` that the command has read, such as a club file named in a study."""
    if target is not None and place_of(target) in {each.place for each in recorded_files()}:
        raise InputError("--output", target, "a file other than the inputs")


def check_picture(target: str | None, inputs: Iterable[str | None] = ()) -> None:
    """Check a picture file like :func:`check_target`; a missing library is an error too."""
    if target is not None:
        from clubface.present.style import ENDINGS

        check_target("--plot", target, ENDINGS, inputs)


def check_report(target: str | None, inputs: Iterable[str | None] = (), name: str = "--report") -> None:
    """Check a report file like :func:`check_target`; ``name`` is the option."""
    if target is not None:
        from clubface.present.document import ENDINGS

        check_target(name, target, ENDINGS, inputs)
        import clubface.present.style  # noqa: F401  (a missing library is an error before any work)


def check_resume(resume: bool, target: str | None) -> None:
    """Raise ClubfaceError for resuming without an output file, because nothing was stored."""
    if resume and target is None:
        raise ClubfaceError("--output is missing; finished work is kept next to it, so --resume needs it")


def prepare_folder(folder: str | None) -> None:
    """Create a folder for tables and pictures; failures and missing libraries are reported before any work."""
    if folder is not None:
        prepared_folder(folder)
        from clubface import plots  # noqa: F401


def write_template(text: str, target: str | None, then: str) -> None:
    """Write a TOML template to the screen or a new file, followed by the hint ``then``."""
    if target is None:
        print(text, end="")
        return
    check_target("--output", target, (".toml",))
    write_text(target, text, new=True)
    print_note(f"wrote {target}; {then}")


Update = Callable[..., object]
"""Function called with the amount done, the total, and further values for the text next to the bar."""


SECONDS_BETWEEN_LINES = 60.0
"""Interval at which a long run writes a line if no bar can be shown [s]."""


@contextmanager
def progress_bar(text: str | Callable[..., str], *, kept: str | None = None) -> Iterator[Update | None]:
    """Show a progress bar on the error stream if it is a terminal.

    ``text`` next to the bar is a word for what is counted, or a function of the values given to the bar. ``kept`` is
    the file next to which a long run stores finished work: without a terminal, a line says so when work has begun, and
    another follows every minute.
    """

    def words_of(done: float, whole: float, *more: Any) -> str:
        return f"{done} of {whole} {text}" if isinstance(text, str) else text(done, whole, *more)

    if not sys.stderr.isatty():
        last: float | None = None

        def write_line(done: float, whole: float, *more: Any) -> None:
            nonlocal last
            now = monotonic()
            if last is None:
                print_note(f"working; finished work is kept next to {kept}: if interrupted, give the command again")
            elif now - last >= SECONDS_BETWEEN_LINES:
                print_note(f"{words_of(done, whole, *more)} ({done / (whole or 1):.0%})")
            else:
                return
            last = now

        yield None if kept is None else write_line
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("starting", total=1.0)

        def update(done: float, whole: float, *more: Any) -> None:
            bar.update(task, completed=done / (whole or 1), description=words_of(done, whole, *more))

        yield update


def run_with_progress(run: Callable[[Update | None], Any]) -> Any:
    """Run a finite element impact with a progress bar."""
    with progress_bar(lambda time, whole: fixed(time, "us", 0)) as update:
        return run(update)
