"""What commands print: JSON, remarks, tables, quantities with their units, and progress.

What a command prints on standard output besides tables: JSON for programs, remarks for people.

Tables on the terminal: numbers laid out here, since loading rich takes longer than a shot; words by rich.

Quantities of a launch and its flight in tables: units, digits, and the keys of JSON documents and files.

A bar under work that takes long.
"""

from __future__ import annotations

import json
import math
import os
import re
import sys
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from contextvars import ContextVar
from pathlib import Path
from typing import Annotated, Any

from clubface import units
from clubface.cli import options
from clubface.cli.failures import say
from clubface.errors import LINES, ClubfaceError, InputError, in_a_line, legible
from clubface.simulation.results import SHOWN
from clubface.support.checks import check_names, plain
from clubface.support.files import place_of, prepared_folder, recorded_files, write_text
from clubface.units import fixed

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
        from clubface.present.document import Data, Heading, Table, file_name

        if title:
            blocks.append(Heading(3, title))
        plain_heads = [head.replace("-\n", "").replace("\n", " ") for head in heads]
        blocks.append(Table(plain_heads, rows, Data(file_name(title or "table"), plain_heads, rows)))


def _repeat_texts(texts: Sequence[str], *, bullets: bool) -> None:
    if (blocks := _REPEATED.get()) is not None and texts:
        from clubface.present.document import Bullets, Paragraph

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
        from clubface.present.style import ENDINGS

        check_target("--plot", target, ENDINGS, inputs)


def check_report(target: str | None, inputs: Iterable[str | None] = ()) -> None:
    """Refuse a report to write in the same way."""
    if target is not None:
        from clubface.present.document import ENDINGS

        check_target("--report", target, ENDINGS, inputs)
        import clubface.present.style  # noqa: F401  (a missing library is told before any work)


def check_resume(resume: bool, target: str | None) -> None:
    """Refuse to go on with work of which nothing was kept, as no file is written."""
    if resume and target is None:
        raise ClubfaceError("--output is missing; what is finished is kept beside it, so --resume needs it")


def prepare_folder(folder: str | None) -> None:
    """Make a folder for tables and pictures; one that cannot be made, or a missing library, is told before any work."""
    if folder is not None:
        prepared_folder(folder)
        from clubface import plots  # noqa: F401


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


def print_numbers(
    heads: Sequence[str], rows: Iterable[Sequence[str]], *, title: str = "", summary: bool = False
) -> None:
    r"""Print a table of numbers; one too wide for the terminal continues below, its first column repeated.

    Parameters
    ----------
    heads
        One heading a column; lines are separated by ``\n``.
    rows
        Cells, already written out; those of the first column are names.
    title
        Printed above.
    summary
        Whether the last row sums up the others and is set apart.
    """
    body = [[legible(cell, "\n") for cell in row] for row in rows]
    heads, title = [legible(head, "\n") for head in heads], legible(title)
    repeat_table(title, heads, body)
    available = terminal_width()
    widths = [
        max(len(line) for cell in column for line in cell.split("\n")) for column in zip(heads, *body, strict=True)
    ]
    gap = 2 if available is None or sum(widths) + 2 * (len(widths) - 1) <= available else 1
    blocks = [list(range(len(heads)))] if available is None else _blocks(widths, gap, available)
    for line in textwrap.wrap(title, available or 120):
        print(_bold(line))
    for columns in blocks:
        rule = _rule() * (sum(widths[index] for index in columns) + gap * (len(columns) - 1))
        split = [heads[index].split("\n") for index in columns]
        height = max(map(len, split))
        for line in zip(*([""] * (height - len(head)) + head for head in split), strict=True):
            print(_bold(_aligned(line, [widths[index] for index in columns], gap)))
        print(rule)
        for position, row in enumerate(body):
            if summary and position == len(body) - 1:
                print(rule)
            print(_aligned([row[index] for index in columns], [widths[index] for index in columns], gap))
        if columns is not blocks[-1]:
            print()


def print_list(rows: Sequence[tuple[str, str, str]], *, title: str) -> None:
    """Print names with their numbers, one below the other, each with what follows it, such as its unit."""
    rows, title = [(legible(name), number, legible(rest)) for name, number, rest in rows], legible(title)
    names, numbers = (max(len(row[column]) for row in rows) for column in (0, 1))
    lines = textwrap.wrap(title, terminal_width() or 120)
    for line in lines:
        print(_bold(line))
    print(_rule() * max(names + numbers + 3 + max(len(row[2]) for row in rows), *map(len, lines)))
    for name, number, rest in rows:
        print(f"{name.ljust(names)}  {number.rjust(numbers)} {rest}".rstrip())


def _aligned(cells: Sequence[str], widths: Sequence[int], gap: int) -> str:
    """Return one line: the first cell to the left, the others to the right."""
    placed = [
        cell.rjust(width) if index else cell.ljust(width)
        for index, (cell, width) in enumerate(zip(cells, widths, strict=True))
    ]
    return (" " * gap).join(placed).rstrip()


def _blocks(widths: Sequence[int], gap: int, available: int) -> list[list[int]]:
    """Split columns into groups that fit side by side, each beginning with the first column."""
    blocks, used = [[0]], widths[0]
    for index, width in enumerate(widths[1:], 1):
        if used + gap + width > available and len(blocks[-1]) > 1:
            blocks.append([0])
            used = widths[0]
        blocks[-1].append(index)
        used += gap + width
    return blocks


def _bold(text: str) -> str:
    plain = not sys.stdout.isatty() or "NO_COLOR" in os.environ or os.environ.get("TERM") == "dumb"
    return text if plain else f"\033[1m{text}\033[0m"


def _rule() -> str:
    """Return what a line is drawn with; the plain character where the terminal has no other."""
    try:
        "─".encode(sys.stdout.encoding or "ascii")
    except UnicodeEncodeError:
        return "-"
    return "─"


def print_words(heads: Sequence[str], rows: Iterable[Sequence[str]], *, numbers: Sequence[int] = ()) -> None:
    """Print a table of words, which are wrapped to the terminal; the columns in ``numbers`` hold numbers."""
    from rich import box
    from rich.console import Console
    from rich.table import Table

    class Screen(Console):
        """A console that leaves it to the caller what a closed pipe means."""

        def on_broken_pipe(self) -> None:
            raise BrokenPipeError

    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, padding=(0, 1, 0, 0), show_edge=False, header_style="bold")
    for index, head in enumerate(heads):
        right = index in numbers
        table.add_column(
            legible(head, "\n"), justify="right" if right else "left", no_wrap=right or not index, overflow="fold"
        )
    for row in rows:
        table.add_row(*(legible(cell, "\n") for cell in row))
    Screen(width=terminal_width() or 10_000, highlight=False, markup=False, emoji=False).print(table)


KEYS = {
    "ball_speed_mps": ("ball_speed", "m/s"), "smash": ("smash", "1"), "launch_deg": ("launch", "deg"),
    "azimuth_deg": ("azimuth", "deg"), "backspin_rpm": ("backspin", "rpm"), "sidespin_rpm": ("sidespin", "rpm"),
    "total_spin_rpm": ("total_spin", "rpm"), "spin_axis_deg": ("spin_axis", "deg"), "carry_m": ("carry", "m"),
    "side_m": ("side", "m"), "total_m": ("total", "m"), "total_side_m": ("total_side", "m"), "apex_m": ("apex", "m"),
    "landing_deg": ("landing_angle", "deg"),
}  # fmt: skip
"""Keys of JSON and columns of a file: quantity and unit."""
VALUES = {name: SHOWN[name] for name, _ in KEYS.values()}
"""Unit and digits of what is listed."""

Units = Annotated[
    list[str] | None,
    options.option("--unit", metavar="NAME=UNIT", text='The unit of a quantity for people: "carry=m". Repeatable.'),
]
Shown = Mapping[str, tuple[str, int]]
"""Unit and digits by quantity."""


def shown_units(texts: Iterable[str] | None) -> dict[str, tuple[str, int]]:
    """Return unit and digits of each quantity of a table; of another unit as many digits as tell as much."""
    told = options.pairs(texts or (), "--unit")
    check_names("quantity of --unit", told, VALUES)
    found = dict(VALUES)
    for name, symbol in told.items():
        usual, digits = VALUES[name]
        unit = units.unit(symbol, name="--unit", dimension=units.unit(usual).dimension).symbol
        more = round(math.log10(units.size(unit) / units.size(usual)))
        found[name] = (unit, max(0, digits + more))
    return found


def label(quantity: str, unit: str) -> str:
    """Return the name of a quantity with its unit, for a row."""
    words = quantity.replace("_", " ")
    return words if unit == "1" else f"{words}, {unit}"


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
