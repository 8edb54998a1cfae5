"""Which launch monitor wrote a file, told by its columns."""

from __future__ import annotations

from collections.abc import Sequence

from clubface.csv_rows import Row
from clubface.errors import FileError
from clubface.launch_monitor.cells import heading
from clubface.launch_monitor.formats import Format
from clubface.launch_monitor.registry import FORMATS
from clubface.table_columns import layout, listed, shot_words
from clubface.table_reader import Reject

OWN = "clubface"
"""The name of the layout of clubface's own tables."""


def detected(path: str, head: Sequence[Row | Reject]) -> Format | None:
    """Return the layout whose header is among the first rows, None for the columns of clubface.

    Where several fit, it is the one that knows most of the columns.
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
                known.setdefault(each.name, len(names & set(each.names)))
        if known:
            break
    if known:
        best = max(known.values())
        fitting = [name for name, count in known.items() if count == best]
        if len(fitting) > 1:
            raise FileError(path, None, f"this may be {' or '.join(fitting)}: say which, as in format={fitting[0]!r}")
        return FORMATS[fitting[0]]
    headings, line, _ = rows[0]
    used = {each.quantity for each in layout(list(dict.fromkeys(headings)), path, line, shot_words()).used}
    if used & {"speed", "ball_speed", "launch"}:
        return None
    widest = max(rows, key=lambda row: sum(bool(cell.strip()) for cell in row[0]))
    message = (
        f"the layout is none of {', '.join(FORMATS)}; {listed([each.strip() for each in widest[0]])}. "
        "Name the columns in a mapping file"
    )
    raise FileError(path, widest[1], message)
