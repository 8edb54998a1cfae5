"""What a command prints on standard output: tables for people, JSON for programs."""

from __future__ import annotations

import json
import math
import os
import sys
from collections.abc import Iterable, Sequence
from typing import Any


def print_json(document: Any) -> None:
    """Print one JSON document; NaN and infinities, which JSON lacks, become null."""
    print(json.dumps(plain(document), indent=2, allow_nan=False, ensure_ascii=False))


def plain(value: Any) -> Any:
    """Return ``value`` made of what JSON has; numpy numbers and arrays included."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict) or hasattr(value, "items"):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return value


def number(value: float | None, digits: int = 1) -> str:
    """Write a number with fixed ``digits``; NaN and None stay empty."""
    if value is None or math.isnan(value):
        return ""
    text = f"{value:.{digits}f}"
    return text[1:] if text.startswith("-") and not text.strip("-0.") else text


def terminal_width() -> int | None:
    """Return the columns of the terminal, or None where the output goes to a file or pipe."""
    if "COLUMNS" in os.environ and os.environ["COLUMNS"].isdigit():
        return int(os.environ["COLUMNS"])
    return os.get_terminal_size(sys.stdout.fileno()).columns if sys.stdout.isatty() else None


def print_table(
    heads: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    title: str = "",
    left: Sequence[int] = (0,),
    rule_before_last: bool = False,
) -> None:
    r"""Print a table; one too wide for the terminal continues below, its first column repeated.

    Parameters
    ----------
    heads
        One heading a column; lines are separated by ``\n``.
    rows
        Cells, already written out.
    title
        Printed above.
    left
        Columns of words: aligned to the left, wrapped if need be. The others hold numbers.
    rule_before_last
        Whether the last row is a summary, set apart.
    """
    from rich import box
    from rich.console import Console
    from rich.table import Table

    class Screen(Console):
        """A console that leaves it to the caller what a closed pipe means."""

        def on_broken_pipe(self) -> None:
            raise BrokenPipeError

    body = [list(row) for row in rows]
    available = terminal_width()
    console = Screen(width=available or 10_000, highlight=False, markup=False, emoji=False)
    widths = [_width([head, *(row[index] for row in body)]) for index, head in enumerate(heads)]
    gap = 2 if available is None or sum(widths) + 2 * (len(widths) - 1) <= available else 1
    wraps = any(index in left for index in range(1, len(heads)))
    blocks = [list(range(len(heads)))] if available is None or wraps else _blocks(widths, gap, available)
    for columns in blocks:
        table = Table(
            title=title or None, title_justify="left", title_style="bold", box=box.SIMPLE_HEAD, pad_edge=False,
            padding=(0, gap - 1, 0, 0), show_edge=False, header_style="bold",
        )  # fmt: skip
        for index in columns:
            words = index in left
            table.add_column(
                heads[index], justify="left" if words else "right", no_wrap=not words or index == 0, overflow="fold"
            )
        for position, row in enumerate(body):
            table.add_row(
                *(row[index] for index in columns), end_section=rule_before_last and position == len(body) - 2
            )
        console.print(table)
        title = ""
        if columns is not blocks[-1]:
            console.print()


def _width(cells: Iterable[str]) -> int:
    return max(len(line) for cell in cells for line in cell.split("\n"))


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


def print_notes(notes: Iterable[str]) -> None:
    """Print remarks under a table, each once, wrapped to the terminal."""
    import textwrap

    width = min(terminal_width() or 120, 120)
    for note in dict.fromkeys(notes):
        print(textwrap.fill(note, width, initial_indent="* ", subsequent_indent="  "))


def print_paragraph(text: str) -> None:
    """Print running text, wrapped to the terminal."""
    import textwrap

    print(textwrap.fill(text, min(terminal_width() or 120, 120)))
