"""Tables on the terminal: numbers laid out here, since loading rich takes longer than a shot; words by rich."""

from __future__ import annotations

import os
import sys
import textwrap
from collections.abc import Iterable, Sequence

from clubface.cli.output import repeat_table, terminal_width
from clubface.errors import legible


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
