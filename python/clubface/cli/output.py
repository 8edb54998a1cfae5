"""What a command prints on standard output besides tables: JSON for programs, remarks for people."""

from __future__ import annotations

import json
import math
import os
import re
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from contextvars import ContextVar
from pathlib import Path
from typing import Any

from clubface.cli.failures import say
from clubface.errors import LINES, ClubfaceError, InputError, in_a_line, legible
from clubface.support.folders import prepared_folder
from clubface.support.input_files import place_of, recorded_files
from clubface.support.plain_json import plain
from clubface.support.whole_file import write_text

REJECTED = 20
"""Rows without a shot that are printed."""
_REPEATED: ContextVar[list[Any] | None] = ContextVar("repeated", default=None)


class _Legible:
    """A stream for people: whatever is written to it comes out as :func:`clubface.errors.legible` has it.

    On a terminal, what sets the type of letters passes, or on the error stream what moves a bar: tables, notes and
    messages, in which texts of others come, are legible before.
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
    """Let nothing that a file holds reach the output as more than letters."""
    with redirect_stdout(_Legible(sys.stdout, "m")), redirect_stderr(_Legible(sys.stderr, "A-Za-z")):  # pyright: ignore[reportArgumentType]
        yield


@contextmanager
def repeated_in(blocks: list[Any]) -> Iterator[None]:
    """Repeat tables, paragraphs and notes that are printed as blocks of a report."""
    before = _REPEATED.set(blocks)
    try:
        yield
    finally:
        _REPEATED.reset(before)


def repeat_table(title: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Add a table to the report that repeats what is printed, if there is one."""
    if (blocks := _REPEATED.get()) is not None:
        from clubface.reports.blocks import Data, Heading, Table
        from clubface.reports.document import file_name

        if title:
            blocks.append(Heading(3, title))
        plain_heads = [head.replace("-\n", "").replace("\n", " ") for head in heads]
        blocks.append(Table(plain_heads, rows, Data(file_name(title or "table"), plain_heads, rows)))


def _repeat_texts(texts: Sequence[str], *, bullets: bool) -> None:
    if (blocks := _REPEATED.get()) is not None and texts:
        from clubface.reports.blocks import Bullets, Paragraph

        blocks.append(Bullets(texts) if bullets else Paragraph(texts))


HELD = (
    "Moving the CG changes the impact alone: dynamic loft, face angle and lie are held as delivered. On a shaft a CG"
    " farther from its axis also adds loft and closes the face before impact; give the delivery that you expect."
)
"""What is to be said wherever a CG is moved."""


def check_target(name: str, target: str | None, kinds: Sequence[str], inputs: Iterable[str | None] = ()) -> None:
    """Refuse a file to write of another kind, whose folder is not there or that is one of the ``inputs``.

    It is told before work begins. ``kinds`` are the endings a name may have.
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
            raise InputError(name, target, "another file than those that are read")


def check_not_read(target: str | None) -> None:
    """Refuse ``--output`` that is a file which the command has read, such as a club that a study names."""
    if target is not None and place_of(target) in {each.place for each in recorded_files()}:
        raise InputError("--output", target, "another file than those that are read")


def check_picture(target: str | None, inputs: Iterable[str | None] = ()) -> None:
    """Refuse a picture to write in the same way; a missing library is told as well."""
    if target is not None:
        from clubface.plots.style import ENDINGS

        check_target("--plot", target, ENDINGS, inputs)


def check_report(target: str | None, inputs: Iterable[str | None] = ()) -> None:
    """Refuse a report to write in the same way."""
    if target is not None:
        from clubface.reports.document import ENDINGS

        check_target("--report", target, ENDINGS, inputs)
        import clubface.plots  # noqa: F401  (a missing library is told before any work)


def check_resume(resume: bool, target: str | None) -> None:
    """Refuse to go on with work of which nothing was kept, as no file is written."""
    if resume and target is None:
        raise ClubfaceError("--output is missing; what is finished is kept beside it, so --resume needs it")


def prepare_folder(folder: str | None) -> None:
    """Make a folder for tables and pictures; one that cannot be made, or a missing library, is told before any work."""
    if folder is not None:
        prepared_folder(folder)
        import clubface.plots as plots  # noqa: F401


def write_template(text: str, target: str | None, then: str) -> None:
    """Write a template of a TOML file to the screen or a new file, and tell what to do ``then``."""
    if target is None:
        print(text, end="")
        return
    check_target("--output", target, (".toml",))
    write_text(target, text, new=True)
    say(f"wrote {target}; {then}")


def json_text(document: Any, *, indent: int | None = None) -> str:
    """Return JSON in the letters of its texts; what no terminal should get, is escaped."""
    text = json.dumps(document, indent=indent, allow_nan=False, ensure_ascii=False)
    return "".join(each if each.isprintable() or each == "\n" else json.dumps(each)[1:-1] for each in text)


def print_json(document: Any) -> None:
    """Print one JSON document; NaN and infinities, which JSON lacks, become null."""
    print(json_text(plain(document), indent=2))


def number(value: float | None, digits: int = 1) -> str:
    """Write a number with fixed ``digits``; NaN and None stay empty."""
    if value is None or math.isnan(value):
        return ""
    text = f"{value:.{digits}f}"
    return text[1:] if text.startswith("-") and not text.strip("-0.") else text


def counted(count: int, what: str) -> str:
    """Return "1 shot" or "3 shots"."""
    return f"{count} {what}{'s' * (count != 1)}"


def print_rejected(rejected: Sequence[Any], what: str, remedy: str) -> None:
    """Print how many rows gave no shot, and the first of them with line and reason; ``remedy`` tells of the others."""
    if rejected:
        print(f"{counted(len(rejected), 'row')} {what}")
    for each in rejected[:REJECTED]:
        print(f"  line {each.line}: {in_a_line(each.reason)}")
    if len(rejected) > REJECTED:
        print(f"  and {len(rejected) - REJECTED} more ({remedy})")


def terminal_width() -> int | None:
    """Return the columns of the terminal, or None where the output goes to a file or pipe."""
    if (told := os.environ.get("COLUMNS", "")).isdecimal():
        return int(told)
    return os.get_terminal_size(sys.stdout.fileno()).columns if sys.stdout.isatty() else None


def print_notes(notes: Iterable[str]) -> None:
    """Print remarks under a table, each once, wrapped to the terminal."""
    import textwrap

    width = min(terminal_width() or 120, 120)
    told = list(dict.fromkeys(notes))
    _repeat_texts(told, bullets=True)
    for note in told:
        print(textwrap.fill(in_a_line(note), width, initial_indent="* ", subsequent_indent="  "))


def print_paragraph(text: str) -> None:
    """Print running text, wrapped to the terminal."""
    import textwrap

    _repeat_texts([text], bullets=False)
    print(textwrap.fill(legible(text, LINES), min(terminal_width() or 120, 120)))
