"""The same shots written in another way: encodings, units, order of columns, summaries, second headers, workbooks.

A table is a list of rows of cells as a monitor or clubface writes them. Steps change how it is written and not what it
says, so that reading it must give the same values; :func:`same_shots` tells whether it does.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

from clubface import shots as launch_monitor
from clubface.shots.recorded import RecordedShots

MONITORS = Path(__file__).parents[1] / "data" / "launch_monitors"
Rows = list[list[str]]
SHOTS = 9
UNITS = {
    "speed": (("mph", 1.0), ("m/s", 0.44704), ("km/h", 1.609344), ("ft/s", 22 / 15)),
    "angle": (("deg", 1.0), ("rad", np.pi / 180)),
    "length": (("mm", 1.0), ("in", 1 / 25.4), ("cm", 0.1)),
    "spin": (("rpm", 1.0), ("rad/s", np.pi / 30), ("deg/s", 6.0)),
    "distance": (("yd", 1.0), ("m", 0.9144), ("ft", 3.0)),
}
"""Units of a kind, and how many of each are one of the first."""
OWN = {
    "club_speed": ("speed", 100, 6), "attack": ("angle", -1, 2), "path": ("angle", 1, 3), "loft": ("angle", 14, 1.5),
    "face": ("angle", 0.5, 2), "toe": ("length", 2, 8), "high": ("length", -1, 6), "ball_speed": ("speed", 145, 6),
    "launch": ("angle", 12, 2), "azimuth": ("angle", 1, 2), "backspin": ("spin", 2600, 300),
    "sidespin": ("spin", 100, 300), "carry": ("distance", 240, 12),
}  # fmt: skip
"""Columns of clubface: kind, and mean and deviation in the first unit of the kind."""
HEADINGS = ("{name}_{unit}", "{name} [{unit}]", "{name} ({unit})")
MEANS = ("Average", "Avg", "Mean", "Durchschnitt", "Moyenne", "Promedio", "平均")
DEVIATIONS = ("Std Dev", "St. Dev.", "StDev", "Standardabweichung", "Ecart-type", "標準偏差")
ENCODINGS = ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "cp1252", "shift_jis", "gbk")
DELIMITERS = (",", ";", "\t")
REMARKS = (
    ("Remarks", "windy", "fine"), ("Bemerkung", "böig", "schön"), ("備考", "球は右方向に高い", "距離が出ない"),
    ("备注", "击打点偏左侧", "球杆旋转大"),
)  # fmt: skip
HOME = {"shift_jis": ("備考", "备"), "gbk": ("备注", "備")}
"""What a text has that is written in an encoding of its country, and what it does not have: few letters tell no two
such encodings apart."""


class InconsistentError(Exception):
    """The same shots, written in another way, are read as others."""


def own_values(random: Random) -> dict[str, list[float]]:
    """Return shots, by column, in the first unit of each kind; numbers as monitors round them."""
    columns = random.sample([name for name in OWN if name != "club_speed"], random.randint(3, len(OWN) - 1))
    names = [name for name in OWN if name in columns or name == "club_speed"]
    result = {name: [round(random.gauss(*OWN[name][1:]), 1) for _ in range(SHOTS)] for name in names}
    if "ball_speed" in result:  # no ball is near the fastest that its club can send
        result["ball_speed"] = [round(random.uniform(1.3, 1.46) * each, 1) for each in result["club_speed"]]
    return result


def own_table(values: dict[str, list[float]], random: Random, units: dict[str, str] | None = None) -> Rows:
    """Write shots as a table of clubface, in units that are drawn unless given; "" leaves them out."""
    style, heads, columns = random.choice(HEADINGS), [], []
    for name, numbers in values.items():
        unit, factor = random.choice(UNITS[OWN[name][0]])
        if units is not None:
            unit, factor = units.get(OWN[name][0], ""), 1.0
        heads.append((style if unit else "{name}").format(name=name, unit=unit))
        columns.append([f"{each * factor:.12g}" for each in numbers])
    return [["club", *heads], *(["driver", *row] for row in zip(*columns, strict=True))]


def monitor_table(name: str) -> Rows:
    """Return the rows of the file of a monitor, without the line that names its delimiter."""
    path = MONITORS / name
    data = path.read_bytes()
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1252")
    lines = text.splitlines()
    if lines[0].startswith("sep="):
        del lines[0]
    delimiter = max(DELIMITERS, key="\n".join(lines).count)
    return [row for row in csv.reader(lines, delimiter=delimiter) if row]


def _width(rows: Rows) -> int:
    """Return the number of cells of the most rows: those of the table, without what stands above it."""
    counts = [len(row) for row in rows if row]
    return max(set(counts), key=counts.count)


def _header(rows: Rows) -> int:
    return next(place for place, row in enumerate(rows) if len(row) == _width(rows) and sum(map(bool, row)) > 2)


def _is_table(rows: Rows) -> bool:
    return any(len(row) == _width(rows) and sum(map(bool, row)) > 2 for row in rows)


MONITOR_FILES = [path.name for path in sorted(MONITORS.glob("*.csv")) if _is_table(monitor_table(path.name))]
"""Files of monitors that are tables: some have a name and a number in each line."""


def _is_units(row: list[str]) -> bool:
    return not any(any(letter.isdigit() for letter in cell) for cell in row)


def permute(rows: Rows, random: Random) -> Rows:
    """Put the columns into another order."""
    width, head = _width(rows), _header(rows)
    order = random.sample(range(width), width)
    below = [[row[place] for place in order] if len(row) == width else row for row in rows[head:]]
    return [*rows[:head], *below]


def blank_lines(rows: Rows, random: Random) -> Rows:
    """Put empty rows between the rows of the table."""
    result = list(rows)
    for _ in range(random.randint(1, 3)):
        result.insert(random.randint(_first(rows), len(result)), [])
    return result


def empty_column(rows: Rows, random: Random) -> Rows:
    """Add a column in which nothing stands."""
    return _with_column(rows, random, "", [""])


def text_column(rows: Rows, random: Random) -> Rows:
    """Add a column of words that nobody asked for."""
    heading, *words = random.choice(REMARKS)
    return _with_column(rows, random, heading, [*words, ""])


def _with_column(rows: Rows, random: Random, heading: str, words: list[str]) -> Rows:
    width, head, first = _width(rows), _header(rows), _first(rows)
    at = random.randint(0, width)
    cells = [heading if place == head else "" if place < first else random.choice(words) for place in range(len(rows))]
    result = []
    for place, (row, cell) in enumerate(zip(rows, cells, strict=True)):
        here = at if place >= head else width  # a title stays in the first cell
        result.append([*row[:here], cell, *row[here:]] if len(row) == width else row)
    return result


def _first(rows: Rows) -> int:
    """Return the place of the first shot."""
    head = _header(rows)
    return head + 2 if head + 1 < len(rows) and _is_units(rows[head + 1]) else head + 1


def summaries(rows: Rows, random: Random) -> Rows:
    """Add rows of means and deviations, named in a column of words, as trackers do below the shots."""
    first, width = _first(rows), _width(rows)
    shots = rows[first:]
    columns = [] if any(len(row) != width for row in shots) else list(zip(*shots, strict=True))
    numeric = [[_is_number(cell) for cell in cells if cell] for cells in columns]
    texts = [place for place, each in enumerate(numeric) if each and not any(each)]
    if len(shots) < 3 or not texts or any(any(each) and not all(each) for each in numeric):
        return rows  # it has summaries, or cells that are no numbers, already
    at, result = random.choice(texts[:3]), list(rows)
    for words, figure in ((MEANS, np.mean), (DEVIATIONS, np.std)):
        row = []
        for cells, each in zip(columns, numeric, strict=True):
            numbers = [float(cell.replace(",", ".")) for cell in cells if cell] if any(each) else []
            digits = max((len(cell.replace(",", ".").partition(".")[2]) for cell in cells), default=0)
            text = f"{figure(numbers):.{digits}f}" if numbers else ""
            row.append(text.replace(".", ",") if any("," in cell for cell in cells) else text)
        row[at] = random.choice(words)
        result.append(row)
    return result


def _is_number(cell: str) -> bool:
    try:
        float(cell.replace(",", "."))
    except ValueError:
        return False
    return True


def second_header(rows: Rows, random: Random) -> Rows:
    """Repeat the header, and the row of units below it, between the shots."""
    head, first = _header(rows), _first(rows)
    if len(rows) < first + 2 or any(cell in ("Avg", "Average") for row in rows for cell in row):
        return rows
    at = random.randint(first + 1, len(rows) - 1)
    return [*rows[:at], *rows[head:first], *rows[at:]]


STEPS: dict[str, Callable[[Rows, Random], Rows]] = {
    each.__name__: each for each in (permute, empty_column, text_column, summaries, blank_lines, second_header)
}
"""In the order in which they are taken: a second header comes last, so that it is as the first."""


def written(rows: Rows, how: dict[str, Any]) -> tuple[str, bytes]:
    """Return the ending and the bytes of a table: a workbook, or text with delimiter, quotes, line ends, encoding.

    A delimiter that stands in numbers and an encoding that lacks a letter give way to the next.
    """
    if how["format"] == "xlsx":
        return "xlsx", workbook(rows)
    commas = any("," in cell for row in rows for cell in row)
    delimiter = ";" if commas and how["delimiter"] == "," else how["delimiter"]
    text, quoting = io.StringIO(), csv.QUOTE_ALL if how["quoted"] else csv.QUOTE_MINIMAL
    csv.writer(text, delimiter=delimiter, quoting=quoting, lineterminator=how["end"]).writerows(rows)
    has, lacks = HOME.get(how["encoding"], ("", "\0"))
    try:
        at_home = has in text.getvalue() and lacks not in text.getvalue()
        return "csv", text.getvalue().encode(how["encoding"] if at_home else "utf-8")
    except UnicodeEncodeError:
        return "csv", text.getvalue().encode()


def some_way(random: Random) -> dict[str, Any]:
    """Draw how a table is written."""
    return {
        "format": "xlsx" if random.random() < 0.15 else "csv", "delimiter": random.choice(DELIMITERS),
        "quoted": random.random() < 0.4, "end": random.choice(("\n", "\r\n")), "encoding": random.choice(ENCODINGS),
    }  # fmt: skip


def workbook(rows: Rows) -> bytes:
    """Return the bytes of an Excel workbook with a table, whose numbers are numbers."""
    from openpyxl import Workbook

    book, file = Workbook(), io.BytesIO()
    # Where decimals have a comma, a point is one of thousands: such a table stays text.
    commas = any(_is_number(cell) and "," in cell for row in rows for cell in row)
    for row in rows:
        book.active.append([float(cell) if _is_number(cell) and not commas else cell or None for cell in row])
    book.save(file)
    return file.getvalue()


def same_shots(one: RecordedShots, other: RecordedShots, order: Any = None) -> None:
    """Raise :class:`InconsistentError` where two readings differ in more than the rounding of units."""
    if len(one) != len(other):
        raise InconsistentError(f"{len(other)} shots instead of {len(one)}; rejected {other.rejected[:3]}")
    for part in ("deliveries", "launches"):
        first, second = getattr(one, part), getattr(other, part)
        if first.keys() != second.keys():
            raise InconsistentError(f"{part} {sorted(second.keys() ^ first.keys())} are in one reading alone")
        for name, values in first.items():
            if not np.allclose(values, second[name], rtol=1e-6, atol=1e-9, equal_nan=True):
                raise InconsistentError(f"{name} is {second[name][:3]} instead of {values[:3]}")
    for name in ("clubs", "players", "hand"):
        first, second = getattr(one, name), getattr(other, name)
        if (first is None) != (second is None) or (first is not None and first.tolist() != second.tolist()):
            raise InconsistentError(f"{name} differ")


def read_rows(rows: Rows, folder: Path, name: str = "plain.csv", ending: str = "csv", data: bytes | None = None) -> Any:
    """Read a table, written plainly unless as ``data``."""
    if data is None:
        text = io.StringIO()
        commas = any("," in cell for row in rows for cell in row)
        csv.writer(text, delimiter=";" if commas else ",", lineterminator="\n").writerows(rows)
        data = text.getvalue().encode()
    path = folder / f"{Path(name).stem}.{ending}"
    path.write_bytes(data)
    return launch_monitor.read(path)
