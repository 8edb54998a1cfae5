"""Recorded shots: deliveries and launches measured together, one row per shot, from any monitor.

Several files can be joined as sessions, and values stated for what was not measured (``{"toe": "0 mm"}``). Dates are
kept as ISO text: ``05/02/24 10:21:11 AM`` becomes ``2024-05-02T10:21:11``.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import copy
from dataclasses import dataclass, field, replace
from datetime import date, datetime, time
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.described import HANDS
from clubface.errors import InputError, Wording
from clubface.results.notes import Note, free_text, note
from clubface.results.result import Presentable, Result
from clubface.shots.plausibility import can_be
from clubface.shots.tables.headings import HAND, LAUNCH_QUANTITIES, POINTS, by_word, heading_of, shot_words, vocabulary
from clubface.shots.tables.parquet import ENDINGS as PARQUET
from clubface.shots.tables.writer import columns_file
from clubface.simulation.inputs import DIMENSIONS
from clubface.simulation.results import inputs
from clubface.simulation.spin import SPINS, complete, notes_of
from clubface.support.arrays import Floats, Selection, ValueLike
from clubface.support.checks import check_choice, check_names
from clubface.support.files import short_names
from clubface.units import SI_UNITS, from_si, is_missing, parse_values

if TYPE_CHECKING:
    import pandas
    import xarray

TEXTS = {"clubs": "club", "players": "player", "hand": HAND, "dates": "date", "files": "file"}
"""Text attributes of shots, with the headings of their columns."""
SIDES = {1.0: "right", -1.0: "left"}
"""Hand by sign."""


class RejectedRow(NamedTuple):
    """A row of a file that gives no shot: the line at which it begins, from 1, and the reason.

    In a Parquet file the line is the row; it is None if unknown.
    """

    line: int | None
    reason: str


@dataclass(frozen=True, kw_only=True, eq=False)
class RecordedShots(Presentable):
    """Shots as measured, in SI units and radians, with the signs of :class:`Delivery` and :class:`Launch`.

    Every array has one element per shot. NaN means not measured; a quantity never measured is absent.

    Attributes
    ----------
    deliveries
        Inputs of an impact by name (``speed``, ``attack``, ``path``, ``loft``, ``face``, ``toe``, ...), including club
        and ball properties if the file has them.
    launches
        Quantities of the launch and flight by name: ``ball_speed``, ``launch``, ``azimuth``, ``backspin``,
        ``sidespin``, ``total_spin``, ``spin_axis``, ``carry``, ... Spins are completed from each other, and
        contradictory ones left out with a note; see :func:`clubface.simulation.spin.complete`.
    clubs, players
        Names as in the file, or None.
    hand
        ``"right"`` or ``"left"``, or None if unknown.
    dates
        Date of each shot, as ISO text (``2026-05-01`` or ``2026-05-01T10:21:11``) or as in the file; None if unknown.
    files
        File name of each shot if there are several files; else None.
    rows
        Line in the source (in Parquet, row) at which each shot begins.
    source, format
        The file or another name of the source, and the name of its format: ``"clubface"``, ``"trackman"``, ...
    rejected, notes
        The rows that gave no shot, and remarks on the shots; plain text is accepted too.
    speed_at
        Point at which speed, attack angle and path were measured: "cg", as models need it, "face" (its centre) or
        "unknown".
    face_at
        Point at which dynamic loft and face angle were measured: "face" (its centre), as models need it, "contact" or
        "unknown". :func:`clubface.shots.refer` converts both to the points models need.
    derived
        Spins among ``launches`` that were derived from others, by name; NaN elsewhere.
    """

    deliveries: dict[str, Floats]
    launches: dict[str, Floats]
    clubs: NDArray[Any] | None = None
    players: NDArray[Any] | None = None
    hand: NDArray[Any] | None = None
    dates: NDArray[Any] | None = None
    files: NDArray[Any] | None = None
    rows: NDArray[np.int64]
    source: str
    format: str
    rejected: tuple[RejectedRow, ...] = ()
    notes: tuple[Note, ...] = ()
    speed_at: str = POINTS["speed_at"][0]
    face_at: str = POINTS["face_at"][0]
    derived: dict[str, Floats] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name, points in POINTS.items():
            check_choice(name, getattr(self, name), points)
        count = np.size(self.rows)
        checked: dict[str, Any] = {"rows": np.asarray(self.rows, dtype=np.int64).reshape(count)}
        known_deliveries = [name for name in inputs() if name != HAND]
        checked["deliveries"] = _floats(self.deliveries, known_deliveries, count)
        launches = _floats(self.launches, LAUNCH_QUANTITIES, count)
        own = {name: launches[name] for name in SPINS if name in launches}  # without derived spins, derived again below
        measured = {name: np.where(each == self.derived.get(name, np.nan), np.nan, each) for name, each in own.items()}
        spins = complete(measured)
        checked["launches"] = {name: spins.values.get(name, values) for name, values in launches.items()} | spins.values
        checked["derived"] = {
            name: np.where(np.isnan(measured.get(name, np.nan)), values, np.nan)
            for name, values in spins.values.items()
        }
        spin_notes = notes_of(spins, checked["rows"].tolist(), self.row_word)
        given = (free_text([each])[0] if isinstance(each, str) else each for each in self.notes)
        checked["notes"] = tuple(dict.fromkeys((*spin_notes, *given)))
        for name in TEXTS:
            given = getattr(self, name)
            if given is not None:
                checked[name] = _of_length(_texts(given), name, count)
        if self.hand is not None and (wrong := set(checked["hand"]) - {"right", "left"}):
            raise InputError("hand", wrong.pop(), "right or left")
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def row_word(self) -> str:
        """Word for a row: "line" in text, "row" in a Parquet file."""
        return "row" if self.source.lower().endswith(PARQUET) else "line"

    def __repr__(self) -> str:
        lines = [f"{len(self)} shot{'s' * (len(self) != 1)} of {self.source} ({self.format})"]
        for kind in ("deliveries", "launches"):
            lines.append(f"  {kind}: {', '.join(getattr(self, kind)) or 'none'}")
        if self.rejected:
            lines.append(f"  {len(self.rejected)} row{'s' * (len(self.rejected) != 1)} rejected")
        return "\n".join(lines)

    def with_notes(self, *notes: Note) -> Self:
        """Return the same shots with more notes, without checking or completing arrays again."""
        noted = copy(self)
        object.__setattr__(noted, "notes", tuple(dict.fromkeys((*self.notes, *notes))))
        return noted

    def select(self, chosen: Selection) -> Self:
        """Return some of the shots, by a mask, indices or a slice as in NumPy; rejected rows and notes stay."""
        try:
            index = np.arange(len(self))[chosen]
        except IndexError as error:
            raise InputError("chosen", chosen, f"a mask or indices of {len(self)} shots ({error})") from None
        index = np.atleast_1d(index)
        return replace(
            self,
            deliveries={name: values[index] for name, values in self.deliveries.items()},
            launches={name: values[index] for name, values in self.launches.items()},
            derived={name: values[index] for name, values in self.derived.items()},
            rows=self.rows[index],
            **{name: None if (texts := getattr(self, name)) is None else texts[index] for name in TEXTS},
        )

    def groups(self) -> NDArray[np.str_] | None:
        """Return a label for each shot, the same for shots of one player; None if there is only one player.

        A shot without a player's name has a label of its own.
        """
        if self.players is None or len(set(self.players) - {""}) < 2:
            return None
        lonely = np.array([f"row {row}" for row in self.rows], dtype=object)
        return np.where(self.players == "", lonely, self.players).astype(str)

    def by_player(self) -> Iterator[tuple[str, NDArray[np.intp]]]:
        """Yield each player and the indices of the player's shots; all shots under "" unless two players are named.

        Shots without a player's name also come under "".
        """
        if self.players is None or self.groups() is None:
            yield "", np.arange(len(self))
            return
        for player in dict.fromkeys(self.players):
            yield str(player), np.flatnonzero(self.players == player)

    def delivery(self) -> dict[str, Floats]:
        """Return the ``delivery`` argument for :func:`impact`: the deliveries, and the hand as +1 or -1."""
        given = dict(self.deliveries)
        if self.hand is not None:
            given[HAND] = np.array([float(HANDS[each]) for each in self.hand])
        return given

    def units(self) -> dict[str, str]:
        """Return the SI unit of each quantity present."""
        dimensions = shot_words().dimensions
        return {name: SI_UNITS[dimensions[name]] for name in (*self.deliveries, *self.launches)}

    def to_pandas(self) -> pandas.DataFrame:
        """Return a frame with one row per shot, in SI: ``row``, the known texts of ``TEXTS``, then every quantity.

        ``attrs`` holds ``units``, ``source``, ``format``, ``rejected``, ``notes``, ``speed_at`` and ``face_at``.
        """
        import pandas

        columns: dict[str, Any] = {"row": self.rows}
        columns |= {heading: texts for name, heading in TEXTS.items() if (texts := getattr(self, name)) is not None}
        frame = pandas.DataFrame(columns | self.deliveries | self.launches)
        kept = {name: getattr(self, name) for name in ("source", "format", "speed_at", "face_at")}
        frame.attrs = {"units": self.units(), "rejected": [tuple(each) for each in self.rejected], **kept,
                       "notes": [str(each) for each in self.notes]}  # fmt: skip
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """Return a dataset over ``row`` in SI; variables carry units, the dataset its file and format."""
        import xarray

        frame = self.to_pandas().set_index("row")
        units = self.units()
        variables = {name: ("row", frame[name].to_numpy(), {"units": units.get(name, "")}) for name in frame.columns}
        kept = {name: getattr(self, name) or "" for name in ("source", "format", "speed_at", "face_at")}
        return xarray.Dataset(variables, {"row": self.rows}, attrs=kept)

    def to_result(self) -> Result:
        """Return the range and mean of each quantity, the clubs, and the rejected rows as a result."""
        from clubface.shots.recorded_result import shots_result

        return shots_result(self)

    def headings(self) -> dict[str, tuple[str, str]]:
        """Return the heading and unit of each quantity in a table of the shots."""
        return {name: heading_of(name, si_unit) for name, si_unit in self.units().items()}

    def columns(self) -> dict[str, list[str] | Floats]:
        """Return the columns of a table of the shots by heading, with numbers in the units of the headings."""
        columns: dict[str, list[str] | Floats] = {}
        for name, heading in TEXTS.items():
            if (texts := getattr(self, name)) is not None:
                columns[heading] = [str(each) for each in texts]
        for name, points in POINTS.items():
            if getattr(self, name) != points[0]:
                columns[name] = [getattr(self, name)] * len(self)
        values = self.deliveries | self.launches
        return columns | {heading: from_si(values[name], unit) for name, (heading, unit) in self.headings().items()}

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the shots to a CSV or Parquet file, by its ending, for :func:`clubface.read_shots`.

        The file appears only when it is complete. It does not contain rejected rows and notes.
        """
        with columns_file(Path(path), exact=True) as write:
            write(self.columns())


def _floats(given: Mapping[str, Any], known: Any, count: int) -> dict[str, Floats]:
    check_names("quantity", given, known)
    dimensions = shot_words().dimensions
    return {
        name: _of_length(np.asarray(parse_values(values, dimensions[name], name=name)), name, count)
        for name, values in given.items()
    }


def _texts(given: Any) -> NDArray[Any]:
    """Return names, with "" for missing ones."""
    missing = np.ma.getmaskarray(given)
    names = np.array(np.ma.getdata(given), dtype=object)
    if missing.any() or set(map(type, names.ravel())) != {str}:
        names[[bool(gone) or is_missing(each) for each, gone in zip(names, missing, strict=True)]] = ""
    return names


def _of_length(values: NDArray[Any], name: str, count: int) -> NDArray[Any]:
    if values.shape != (count,):
        shape = Wording(f"an array of shape {values.shape}")
        raise InputError(name, shape, f"one with an element for each shot: ({count},)")
    return values


FEWEST_SAME = 3
"""Minimum number of values for recognising the same shot in different files."""
MEASURED_AT = {"speed_at": ("motion", {"speed", "attack", "path"}), "face_at": ("face-angles", {"loft", "face"})}
"""Data measured at each reference point: name in note codes, and quantities."""
NAMED = 3
"""Maximum number of files listed in the source of joined shots."""


def join_sessions(sessions: Sequence[RecordedShots]) -> RecordedShots:
    """Return the shots of several files as one, in the order given, each shot with its file.

    Exports overlap, and a file may be given twice, so a shot with the same club, player, date and values as one in an
    earlier file is left out; a note counts these.
    """
    if len(sessions) == 1:
        return sessions[0]
    names = short_names([each.source for each in sessions])
    sessions = [
        each if each.files is not None else replace(each, files=np.array([name] * len(each), dtype=object))
        for each, name in zip(sessions, names, strict=True)
    ]
    kept = _first_of_each(sessions)
    notes = [
        note("shots-in-earlier-file", left=int(np.sum(~mask)), shots=int(mask.size)).of(in_files=[name])
        for name, mask in zip(names, kept, strict=True)
        if not mask.all()
    ]
    for remark in dict.fromkeys(remark for each in sessions for remark in each.notes):
        holders = [name for name, each in zip(names, sessions, strict=True) if remark in each.notes]
        is_of_all = len(holders) == len(sessions) or "in_files" in remark.data
        notes.append(remark if is_of_all else remark.of(in_files=holders))
    points = {}
    for point, (what, quantities) in MEASURED_AT.items():
        where = list(dict.fromkeys(getattr(each, point) for each in sessions if quantities & each.deliveries.keys()))
        points[point] = where[0] if len(where) == 1 else getattr(sessions[0], point) if not where else "unknown"
        if len(where) > 1:
            notes.append(note(f"measured-{what}-at-different-places", places=where))
    parts = [each.select(mask) for each, mask in zip(sessions, kept, strict=True) if mask.any()]
    columns = {kind: _columns([getattr(each, kind) for each in parts], parts)
               for kind in ("deliveries", "launches", "derived")}  # fmt: skip
    texts = _columns([{name: each for name in TEXTS if (each := getattr(part, name)) is not None} for part in parts],
                     parts, "", object)  # fmt: skip
    if "" in texts.get("hand", ()):
        del texts["hand"]
    source = ", ".join(each.source for each in sessions[:NAMED])
    formats = dict.fromkeys(each.format for each in sessions)
    return RecordedShots(
        **columns,
        **texts,
        **points,
        rows=np.concatenate([each.rows for each in parts]),
        source=source + (f" and {len(sessions) - NAMED} more" if len(sessions) > NAMED else ""),
        format=" and ".join(formats),
        rejected=tuple(
            each._replace(reason=f"{name}: {each.reason}")
            for name, session in zip(names, sessions, strict=True)
            for each in session.rejected
        ),
        notes=tuple(notes),
    )


def session_labels(shots: RecordedShots) -> NDArray[Any] | None:
    """Return the session of each shot, its day or else its file; None where all are of one session."""
    labels = np.array([""] * len(shots), dtype=object)
    if shots.files is not None:
        labels = shots.files.copy()
    if shots.dates is not None:
        days = np.array([each[:10] if re.match(r"\d{4}-\d\d-\d\d", each) else "" for each in shots.dates], dtype=object)
        labels = np.where(days != "", days, labels)
    return labels if len(set(labels)) > 1 else None


def in_order(labels: NDArray[Any]) -> list[str]:
    """Return the sessions, those with a day by their days and before the others."""
    different = list(dict.fromkeys(labels.tolist()))
    days = sorted(each for each in different if re.fullmatch(r"\d{4}-\d\d-\d\d", each))
    return [*days, *(each for each in different if each not in days)]


def _first_of_each(sessions: Sequence[RecordedShots]) -> list[NDArray[np.bool_]]:
    """Return which shots of each file no earlier file has."""
    common = set.intersection(*({*each.deliveries, *each.launches} - {*each.derived} for each in sessions))
    names = sorted(common)
    seen: set[tuple[Any, ...]] = set()
    kept = []
    for each in sessions:
        values = each.deliveries | each.launches
        table = np.column_stack([values[name] for name in names]) if names else np.empty((len(each), 0))
        table = np.round(table, 9) + 0.0
        enough = (~np.isnan(table)).sum(axis=1) >= FEWEST_SAME
        texts = [getattr(each, name) for name in ("clubs", "players", "dates")]
        keys = [
            (row.tobytes(), *("" if part is None else str(part[place]) for part in texts))
            for place, row in enumerate(np.nan_to_num(table, nan=1e300))
        ]
        kept.append(np.array([not (many and key in seen) for key, many in zip(keys, enough, strict=True)], dtype=bool))
        seen |= set(keys)
    return kept


def _columns(
    every: Sequence[Mapping[str, Any]], parts: Sequence[RecordedShots], nothing: Any = np.nan, kind: type = float
) -> dict[str, Any]:
    """Return the joined columns of several parts, with ``nothing`` where a part lacks one."""
    names = dict.fromkeys(name for each in every for name in each)
    sizes = [*map(len, parts)]
    return {
        name: np.concatenate(
            [each.get(name, np.full(size, nothing, kind)) for each, size in zip(every, sizes, strict=True)]
        )
        for name in names
    }


Shots = TypeVar("Shots", bound=RecordedShots)


def assume_values(shots: Shots, assume: Mapping[str, ValueLike]) -> Shots:
    """Return the shots with stated values for delivery quantities that were not measured, and notes that count them.

    ``assume`` gives values by the names of :class:`clubface.Delivery`, as text with units or SI numbers. Measured
    values stay.
    """
    check_names("quantity in assume", assume, DIMENSIONS)
    deliveries, notes = dict(shots.deliveries), []
    for name, stated in assume.items():
        value = units.parse(stated, DIMENSIONS[name], name=f"assume {name}")
        if not can_be(name, value):
            raise InputError(f"assume {name}", stated, "a value with its unit that a shot can have")
        measured = deliveries.get(name, np.full(len(shots), np.nan))
        lacking = np.isnan(measured)
        deliveries[name] = np.where(lacking, value, measured)
        has_unit = isinstance(stated, str) and stated.strip()[-1:] not in "0123456789."
        shown = stated if has_unit else units.show(value, units.SI_UNITS[DIMENSIONS[name]])
        if count := int(lacking.sum()):
            notes.append(note("value-stated", quantity=name, lacking=count, shots=len(shots), stated=shown))
        else:
            notes.append(note("value-stated-not-used", quantity=name, stated=shown))
    return replace(shots, deliveries=deliveries, notes=(*shots.notes, *notes))


MONTHS = {word: int(number) for word, number in by_word(vocabulary()["months"]).items()}
_CLOCK = re.compile(r"(?<!\d)(\d{1,2}):(\d{2})(?::(\d{2})(?:[.,]\d+)?)?\s*([ap]\.?\s?m\.?)?", re.IGNORECASE)
_YEAR_FIRST = re.compile(r"(?<!\d)(\d{4})[-/.年년\s]\s*(\d{1,2})[-/.月월\s]\s*(\d{1,2})(?!\d)")
_YEAR_LAST = re.compile(r"(?<!\d)(\d{1,2})\s?([-/.])\s?(\d{1,2})\s?\2\s?(\d{4}|\d{2})(?!\d)")
_NAMED = re.compile(
    r"(?<!\d)(?:(\d{1,2})(?:st|nd|rd|th)?\.?[\s-]*(?:de\s+)?([^\W\d_]{3,})|([^\W\d_]{3,})\.?\s+(\d{1,2})(?:st|nd|rd|th)?)"
    r"\.?,?[\s-]+(?:de\s+)?(\d{4})"
)
_COMPACT = re.compile(r"(20\d{2})(\d{2})(\d{2})(?:[T_-]?(\d{2})(\d{2})(\d{2})?)?")


def iso_dates(texts: Sequence[str]) -> tuple[list[str], Note | None]:
    """Return dates, with time if given, as ISO text, and a note if the order of day and month is uncertain.

    Text that is not a date stays unchanged. All dates together decide whether day or month comes first; if they leave
    it open, dots mean day first and slashes month first.
    """
    different = dict.fromkeys(texts)
    day_first, is_certain = _order(different)
    known = {text: _iso(text, day_first) or text for text in different}
    remark = None
    if not is_certain:
        text = next(each for each in different if _YEAR_LAST.search(each))
        remark = note("date-read", date=text, day=known[text][:10], first="day" if day_first else "month")
    return [known[each] for each in texts], remark


def date_among(cells: Iterable[str]) -> str | None:
    """Return the first date among the cells of a row, unchanged; None if there is none."""
    return next((cell.strip() for cell in cells if _iso(cell, day_first=False) or _iso(cell, day_first=True)), None)


def _order(texts: Iterable[str]) -> tuple[bool, bool]:
    """Return whether the day comes before the month, and whether this is certain."""
    result = [match for text in texts if not _YEAR_FIRST.search(text) and (match := _YEAR_LAST.search(text))]
    if any(int(match[1]) > 12 for match in result):
        return True, True
    if any(int(match[3]) > 12 for match in result):
        return False, True
    if not result:
        return False, True
    if any("m" in (clock[4] or "").lower() for match in result if (clock := _CLOCK.search(match.string))):
        return False, True
    return result[0][2] == ".", result[0][2] == "." or all(match[1] == match[3] for match in result)


def _iso(text: str, day_first: bool) -> str | None:
    if match := _YEAR_FIRST.search(text):
        parts = [int(each) for each in match.groups()]
    elif match := _YEAR_LAST.search(text):
        first, second, year = int(match[1]), int(match[3]), int(match[4])
        parts = [year if year > 99 else 2000 + year, *((second, first) if day_first else (first, second))]
    elif (match := _NAMED.search(text)) and (month := MONTHS.get((match[2] or match[3]).lower())):
        parts = [int(match[5]), month, int(match[1] or match[4])]
    elif match := _COMPACT.fullmatch(text.strip()):
        parts = [int(each) for each in match.groups()[:3]]
    else:
        return None
    try:
        day = date(*parts)
        clock = _CLOCK.search(text)
        if clock is None:
            return day.isoformat()
        hour = int(clock[1]) % 12 + 12 * (clock[4][0] in "pP") if clock[4] else int(clock[1])
        return datetime.combine(day, time(hour, int(clock[2]), int(clock[3] or 0))).isoformat()
    except ValueError:
        return None
