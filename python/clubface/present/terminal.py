"""Prints a result on the terminal: tables laid out to its width, notes below them.

Loading a library for tables takes longer than a shot, so the layout is made here.
"""

from __future__ import annotations

import os
import sys
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import replace

from clubface.errors import LINES, in_a_line, legible
from clubface.quantities import unit_text
from clubface.results.notes import Note
from clubface.results.result import Result
from clubface.results.table import Column, Table

WIDEST = 120
"""Maximum length of a line of text [characters]."""
NARROWEST = 14
"""Minimum width of a wrapped text column, before a table continues below [characters]."""
LONGEST_NUMBER = 24
"""Maximum length of a number with its remark, such as "1.20 [0.95, 1.45]" [characters]."""


def terminal_width() -> int | None:
    """Return the width of the terminal in characters, or None if the output goes to a file or pipe."""
    if (columns := os.environ.get("COLUMNS", "")).isdecimal():
        return int(columns)
    return os.get_terminal_size(sys.stdout.fileno()).columns if sys.stdout.isatty() else None


def print_result(result: Result, units: Mapping[str, str] | None = None) -> None:
    """Print the tables of a result, its notes, and hints at further options of the command."""
    print(as_text(result, units, terminal_width(), emphasis=_shows_bold()))


def as_text(
    result: Result, units: Mapping[str, str] | None = None, width: int | None = None, *, emphasis: bool = False
) -> str:
    """Return a result as text for the terminal, with headings in bold if ``emphasis``.

    ``units`` are display units by quantity; ``width`` is that of the terminal [characters], or None.
    """
    parts = []
    if result.assumptions:
        parts.append([line for each in result.assumptions for line in _wrap_text(each.sentence, width)])
    values = values_of(result.values, units)
    if values:
        parts.append(_list_lines(result.title, values, width, emphasis))
    printed = [each for each in result.tables if each.printed and len(each)]
    if result.lead:
        parts.append([_bold(line, emphasis) for line in _wrap_text(result.title, width)] * (not values))
        parts[-1] += [line for each in result.lead for line in _wrap_text(in_a_line(each.sentence), width)]
    elif not values and printed and not printed[0].title:
        printed[0] = replace(printed[0], title=result.title)
    if not values and not result.lead and result.title not in [each.title for each in printed]:
        parts.append([_bold(line, emphasis) for line in _wrap_text(result.title, width)])
    parts += [_table_lines(each, units, width, emphasis) for each in printed]
    if notes := note_lines(result.notes, width):
        parts.append(notes)
    if result.hints:
        parts.append([line for each in result.hints for line in _wrap_text(each.sentence, width)])
    parts += [as_text(each, units, width, emphasis=emphasis).split("\n") for each in result.parts]
    return "\n\n".join("\n".join(each) for each in parts)


def note_lines(notes: Sequence[Note], width: int | None = None) -> list[str]:
    """Return notes as bulleted lines, each sentence once."""
    lines = []
    for sentence in dict.fromkeys(each.sentence for each in notes):
        lines += _wrap_text(in_a_line(sentence), width, "* ", "  ")
    return lines


def values_of(columns: Sequence[Column], units: Mapping[str, str] | None = None) -> list[tuple[str, str, str]]:
    """Return label, number, and unit with the side, for the columns that have a value in the first row."""
    rows = []
    for each in columns:
        if not each.printed or not (number := each.shown(0, units)):
            continue
        unit = each.printed_unit_at(0, units)
        quantity = each.quantity_at(0)
        side = ""
        if quantity is not None and quantity.sides and float(number) != 0.0 and not each.difference:
            word = quantity.sides[not number.startswith("-")]
            side = "" if word in each.heading else word
        after = f"{unit_text(unit)} {side}".strip()
        rows.append((each.heading, number, after))
    return rows


def headings_and_rows(
    table: Table, units: Mapping[str, str] | None = None
) -> tuple[list[tuple[str, str]], list[list[str]]]:
    """Return the headings of a table, as label and unit, and its cells as shown, in its layout."""
    columns = [each for each in table.columns if each.printed]
    count = range(len(table)) if table.shown_rows is None else table.shown_rows
    if table.layout == "transposed":
        names = [each for each in columns if each.quantity is None and not each.digits]
        numbers = [each for each in columns if each not in names]
        heads = [("", ""), *((" ".join(filter(None, (each.shown(row) for each in names))), "") for row in count)]
        rows = []
        for each in numbers:
            unit = each.printed_unit_at(0, units) if len(table) else "1"
            label = each.heading if unit == "1" else f"{each.heading}, {unit_text(unit)}"
            rows.append([label, *(each.shown(row, units) for row in count)])
        return heads, rows
    if table.layout == "pivot":
        line, head, value = columns[:3]
        heads, lines = (list(dict.fromkeys(each.values[row] for row in count)) for each in (head, line))
        cells = {(line.values[row], head.values[row]): value.shown(row, units) for row in count}
        unit = value.printed_unit_at(0, units) if len(table) else "1"
        return [("", unit_text(unit)), *((str(each), "") for each in heads)], [
            [str(each), *(cells.get((each, other), "") for other in heads)] for each in lines
        ]
    heads = []
    for each in columns:
        unit = "1" if each.is_mixed or not len(table) else each.printed_unit_at(0, units)
        heads.append((each.heading, unit_text(unit)))
    rows = [[each.shown(row, units) for each in columns] for row in count]
    before: list[str] = []
    added = 0
    for place, each in enumerate(columns):
        if each.is_mixed and (shown := [each.printed_unit_at(row, units) for row in count]) != before:
            heads.insert(place + added, ("unit", ""))
            for unit, cells in zip(shown, rows, strict=True):
                cells.insert(place + added, unit_text(unit))
            before, added = shown, added + 1
    return heads, rows


def _table_lines(table: Table, units: Mapping[str, str] | None, width: int | None, emphasis: bool) -> list[str]:
    if table.layout == "list":
        return _list_lines(table.title, values_of(table.columns, units), width, emphasis)
    heads, rows = headings_and_rows(table, units)
    texts = {place for place, each in enumerate(heads) if not _holds_numbers(rows, place)}
    headings = [words if place in texts else _heading(words, unit) for place, (words, unit) in enumerate(heads)]
    return lay_out(headings, rows, table.title, width, emphasis, table.summary, texts)


def lay_out(
    heads: Sequence[str],
    rows: Sequence[Sequence[str]],
    title: str = "",
    width: int | None = None,
    emphasis: bool = False,
    summary: bool = False,
    texts: set[int] | None = None,
) -> list[str]:
    """Return the lines of a table; one that is too wide continues below, with its first column repeated.

    Headings may have several lines; the cells of the first column are names. ``width`` and ``emphasis`` are as for
    :func:`as_text`. A ``summary`` is a last row that is set apart. ``texts`` are columns of words, which are aligned to
    the left and wrapped if the table is too wide.
    """
    body = [[legible(cell, "\n") for cell in row] for row in rows]
    heads = [legible(head, "\n") for head in heads]
    left = {0} | (texts or set())
    heads, body = _wrap_words(heads, body, left, width)
    widths = [
        max(len(line) for cell in column for line in cell.split("\n")) for column in zip(heads, *body, strict=True)
    ]
    gap = 2 if width is None or sum(widths) + 2 * (len(widths) - 1) <= width else 1
    blocks = [list(range(len(heads)))] if width is None else column_blocks(widths, gap, width)
    lines = [_bold(line, emphasis) for line in textwrap.wrap(legible(title), width or WIDEST)]
    for columns in blocks:
        sizes = [widths[index] for index in columns]
        rule = _rule() * (sum(sizes) + gap * (len(columns) - 1))
        sides = [index in left for index in columns]
        lines += [
            _bold(line, emphasis)
            for line in _align_row([heads[index] for index in columns], sizes, gap, sides, top=False)
        ]
        lines.append(rule)
        for position, row in enumerate(body):
            if summary and position == len(body) - 1:
                lines.append(rule)
            lines += _align_row([row[index] for index in columns], sizes, gap, sides, top=True)
        if columns is not blocks[-1]:
            lines.append("")
    return lines


def _list_lines(title: str, rows: Sequence[tuple[str, str, str]], width: int | None, emphasis: bool) -> list[str]:
    """Return names and values with units, one below the other."""
    rows = [(legible(name), number, legible(rest)) for name, number, rest in rows]
    names, numbers = (max((len(row[column]) for row in rows), default=0) for column in (0, 1))
    lines = textwrap.wrap(legible(title), width or WIDEST)
    after = max((len(row[2]) for row in rows), default=0)
    rule = _rule() * max(names + numbers + 3 + after, *map(len, lines), 1)
    body = [f"{name.ljust(names)}  {number.rjust(numbers)} {rest}".rstrip() for name, number, rest in rows]
    return [*(_bold(line, emphasis) for line in lines), rule, *body]


def _heading(words: str, unit: str) -> str:
    """Return a heading wrapped to short lines, with the unit below."""
    lines = textwrap.wrap(words, max(9, *map(len, words.split() or [""])), break_long_words=False)
    return "\n".join([*lines, *([unit] if unit else [])])


def _holds_numbers(rows: Sequence[Sequence[str]], place: int) -> bool:
    """Whether a column holds numbers, alone or with a short remark; a formula counts as text."""
    return all(not row[place] or row[place].lstrip("+-")[:1].isdigit() for row in rows) and not any(
        len(row[place]) > LONGEST_NUMBER for row in rows
    )


def _wrap_words(
    heads: Sequence[str], body: Sequence[Sequence[str]], left: set[int], width: int | None
) -> tuple[list[str], list[list[str]]]:
    """Wrap text columns, the widest first, until a table fits; none gets narrower than ``NARROWEST``."""
    rows = [list(heads), *(list(row) for row in body)]
    if width is None:  # a file or pipe takes whole rows, but no cell longer than a line of text
        wrapped = [
            [textwrap.fill(cell, WIDEST) if place in left and len(cell) > WIDEST else cell
             for place, cell in enumerate(row)] for row in rows
        ]  # fmt: skip
        return wrapped[0], wrapped[1:]
    sizes = [max(len(line) for cell in column for line in cell.split("\n")) for column in zip(*rows, strict=True)]
    while (over := sum(sizes) + len(sizes) - 1 - width) > 0:
        widest = max(left, key=lambda place: sizes[place])
        if sizes[widest] <= NARROWEST:
            break
        sizes[widest] = max(NARROWEST, sizes[widest] - max(1, min(over, sizes[widest] // 8)))
    for row in rows:
        for place in left:
            if len(row[place]) > sizes[place]:
                row[place] = textwrap.fill(row[place], sizes[place])
    return rows[0], rows[1:]


def _align_row(cells: Sequence[str], widths: Sequence[int], gap: int, left: Sequence[bool], *, top: bool) -> list[str]:
    """Return the lines of a row; text is aligned to the left, numbers to the right."""
    split = [cell.split("\n") for cell in cells]
    height = max(map(len, split))
    filled = [
        [*lines, *[""] * (height - len(lines))] if top else [*[""] * (height - len(lines)), *lines] for lines in split
    ]
    return [
        (" " * gap)
        .join(
            cell.ljust(width) if side else cell.rjust(width)
            for cell, width, side in zip(line, widths, left, strict=True)
        )
        .rstrip()
        for line in zip(*filled, strict=True)
    ]


def column_blocks(widths: Sequence[float], gap: float, available: float) -> list[list[int]]:
    """Split columns into groups that fit side by side, each beginning with the first column."""
    blocks, used = [[0]], widths[0]
    for index, width in enumerate(widths[1:], 1):
        if used + gap + width > available and len(blocks[-1]) > 1:
            blocks.append([0])
            used = widths[0]
        blocks[-1].append(index)
        used += gap + width
    return blocks


def _wrap_text(text: str, width: int | None, first: str = "", rest: str = "") -> list[str]:
    return textwrap.wrap(
        legible(text, LINES), min(width or WIDEST, WIDEST), initial_indent=first, subsequent_indent=rest
    )


def _shows_bold() -> bool:
    return sys.stdout.isatty() and "NO_COLOR" not in os.environ and os.environ.get("TERM") != "dumb"


def _bold(text: str, emphasis: bool) -> str:
    return f"\033[1m{text}\033[0m" if emphasis else text


def _rule() -> str:
    """Return the character that lines are drawn with: plain ASCII if the terminal has no other."""
    try:
        "─".encode(sys.stdout.encoding or "ascii")
    except UnicodeEncodeError:
        return "-"
    return "─"
