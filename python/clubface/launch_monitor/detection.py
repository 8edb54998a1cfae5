"""Recognition of the launch monitor that wrote a file, by its columns."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from clubface.errors import FileError
from clubface.launch_monitor.cells import heading
from clubface.launch_monitor.formats import Format
from clubface.launch_monitor.registry import FORMATS
from clubface.launch_monitor.tables import TABLE
from clubface.tables.csv_rows import Row
from clubface.tables.headings import listed
from clubface.tables.rows import Reject

TELLING = frozenset({"speed", "ball_speed", "launch"})
"""Quantities of which a table of shots has one."""
FEWEST_KNOWN = 2
"""Headings of a layout that make a row its header where the layout was asked for by its name."""


def detected(path: str, head: Sequence[Row | Reject]) -> Format:
    """Return the layout whose header is among the first rows; ``TABLE`` for columns with usual names of no maker.

    If several layouts fit, the one that knows most of the columns is taken.
    """
    rows = [row for row in head if not isinstance(row, Reject)]
    if not rows:
        reason = next((row for row in head if isinstance(row, Reject)), None)
        if reason is not None:
            raise FileError(path, reason.line, reason.reason)
        raise FileError(path, 1, "the file is empty")
    known: dict[str, int] = {}
    for cells, _, _ in rows:
        names = {heading(each).name for each in cells}
        for each in FORMATS.values():
            if each.is_marked(names):
                known.setdefault(each.name, len(names & set(each.own_names)))
        if known:
            break
    if known:
        best = max(known.values())
        fitting = [name for name, count in known.items() if count == best]
        if len(fitting) > 1:
            message = f"this may be a file of {' or '.join(fitting)}; give the format, such as {fitting[0]}"
            raise FileError(path, None, message)
        return FORMATS[fitting[0]]
    if any(TABLE.is_header(cells) and TELLING & _quantities(TABLE, cells) for cells, _, _ in rows):
        return TABLE
    widest = max(rows, key=lambda row: sum(bool(cell.strip()) for cell in row[0]))
    counts = {name: _known(each, widest[0]) for name, each in FORMATS.items()}
    alike = [name for name, count in counts.items() if count == max(counts.values()) >= FEWEST_KNOWN]
    message = (
        f"the layout is none of {', '.join(FORMATS)}; {listed([each.strip() for each in widest[0]])}. "
        "Name the columns in a mapping file"
    )
    if alike:
        message += f", or the format whose columns they are, perhaps {' or '.join(alike)}"
    raise FileError(path, widest[1], message)


def asked_for(layout: Format, head: Sequence[Row | Reject]) -> Format:
    """Return the layout that was asked for, adapted to the columns that the file has.

    The header is the row that contains most of the layout's columns. A file in which no row has two of them is not read
    by the layout.
    """
    rows = [row[0] for row in head if not isinstance(row, Reject)]
    if not rows or _marked(layout, rows):
        return layout
    header = max(rows, key=lambda cells: _known(layout, cells))
    if _known(layout, header) < FEWEST_KNOWN:
        return layout
    columns = tuple(name for each in header if (name := heading(each).name) in layout.names)
    return replace(layout, marks=(*layout.marks, columns))


def others(layout: Format, head: Sequence[Row | Reject]) -> list[str]:
    """Return the names of the layouts whose header is among the first rows if that of ``layout`` is not."""
    rows = [row[0] for row in head if not isinstance(row, Reject)]
    if layout.name in FORMATS and _marked(FORMATS[layout.name], rows):
        return []
    return [name for name, each in FORMATS.items() if _marked(each, rows)]


def is_foreign(layout: Format, cells: Sequence[str]) -> bool:
    """Tell whether a row is the header of a table that a layout cannot read."""
    names = {layout.heading(each).name for each in cells}
    if any(each.is_marked(names) for each in FORMATS.values() if each.name != layout.name):
        return not layout.is_marked(names)
    known = len(_quantities(layout, cells))
    return TABLE.is_header(cells) and known < FEWEST_KNOWN <= len(_quantities(TABLE, cells))


def _quantities(layout: Format, cells: Sequence[str]) -> set[str]:
    """Return the quantities whose headings are among the cells of a row."""
    return {layout.names[name][0] for each in cells if (name := layout.heading(each).name) in layout.names}


def _marked(layout: Format, rows: Sequence[Sequence[str]]) -> bool:
    """Tell whether one of the rows is the header of a layout."""
    return any(layout.is_marked({heading(each).name for each in cells}) for cells in rows)


def _known(layout: Format, cells: Sequence[str]) -> int:
    """Return how many cells of a row are headings of a layout."""
    return len({heading(each).name for each in cells} & set(layout.own_names))
