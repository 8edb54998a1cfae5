"""Recorded shots: deliveries and launches measured together, one row a shot, whatever they were measured with."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from copy import copy
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.described import HANDS
from clubface.errors import InputError, Told
from clubface.simulation.quantities import inputs
from clubface.simulation.spin import SPINS, complete, notes_of
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, check_names
from clubface.tables.headings import HAND, LAUNCH_SYNONYMS, POINTS, heading_of, shot_words
from clubface.tables.parquet import ENDINGS as PARQUET
from clubface.tables.writer import write_columns
from clubface.units import SI_UNITS, from_si, is_missing, parse_values

if TYPE_CHECKING:
    import pandas

TEXTS = {"clubs": "club", "players": "player", "hand": HAND, "dates": "date", "files": "file"}
"""What is known of shots in words, with the headings of the columns."""
SIDES = {1.0: "right", -1.0: "left"}
"""The hand by the sign the core takes."""


class RejectedRow(NamedTuple):
    """A row of a file that gives no shot.

    Attributes
    ----------
    line
        Where it begins (in a Parquet file, the number of the row), from 1; None where it is not known.
    reason
        What is wrong.
    """

    line: int | None
    reason: str


@dataclass(frozen=True, kw_only=True, eq=False)
class RecordedShots:
    """Shots as they were measured, SI and radians, with the signs of :class:`Delivery` and :class:`Launch`.

    Every array has one element a shot. A value that was not measured is NaN; a quantity that was measured for no shot
    is not there.

    Attributes
    ----------
    deliveries
        Inputs of an impact by name (``speed``, ``attack``, ``path``, ``loft``, ``face``, ``toe``, ...), of club and
        ball as well where the file gives them.
    launches
        Quantities of the launch and flight by name: ``ball_speed``, ``launch``, ``azimuth``, ``backspin``,
        ``sidespin``, ``total_spin``, ``spin_axis``, ``carry``, ... Spins that follow from others are filled in, and of
        those that contradict each other some are left out, which a note says; see
        :func:`clubface.simulation.spin.complete`.
    clubs
        Name of the club as in the file, or None where the file has none.
    players
        Name of the player as in the file, or None where the file has none.
    hand
        ``"right"`` or ``"left"``, or None where it is not known.
    dates
        When each shot was hit, as ISO text (``2026-05-01`` or ``2026-05-01T10:21:11``) or as in the file; None where
        the file does not say.
    files
        Name of the file of each shot, where they are of several; else None.
    rows
        Where each shot begins in the source: its line in text, its row in Parquet.
    source
        The file, or another name of the source.
    format
        How it is written: ``"clubface"``, ``"trackman"``, ...
    rejected
        The rows that gave no shot.
    notes
        What a reader of the shots should know.
    speed_at
        Where speed, attack angle and path were taken: "cg", as models want it, "face" (its centre) or "unknown".
    face_at
        Where dynamic loft and face angle were taken: "face" (its centre), as models want it, "contact" or "unknown".
        :func:`clubface.launch_monitor.refer` refers both to where models want them.
    derived
        The spins among ``launches`` that were not measured but follow from others, by name; NaN elsewhere.
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
    notes: tuple[str, ...] = ()
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
        launches = _floats(self.launches, LAUNCH_SYNONYMS, count)
        measured = {name: self._measured(name, launches[name]) for name in SPINS if name in launches}
        spins = complete(measured)
        checked["launches"] = {name: spins.values.get(name, values) for name, values in launches.items()} | spins.values
        checked["derived"] = {
            name: np.where(np.isnan(measured.get(name, np.nan)), values, np.nan)
            for name, values in spins.values.items()
        }
        spin_notes = notes_of(spins, checked["rows"].tolist(), self.row_word)
        checked["notes"] = tuple(dict.fromkeys((*spin_notes, *self.notes)))
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

    def _measured(self, name: str, values: Floats) -> Floats:
        """Return values of a spin without those that were filled in from others, and are so again."""
        derived = self.derived.get(name)
        return values if derived is None else np.where(values == derived, np.nan, values)

    @property
    def row_word(self) -> str:
        """What ``rows`` counts: lines of text, or the rows of a Parquet file."""
        return "row" if self.source.lower().endswith(PARQUET) else "line"

    def __repr__(self) -> str:
        lines = [f"{len(self)} shot{'s' * (len(self) != 1)} of {self.source} ({self.format})"]
        for kind in ("deliveries", "launches"):
            lines.append(f"  {kind}: {', '.join(getattr(self, kind)) or 'none'}")
        if self.rejected:
            lines.append(f"  {len(self.rejected)} row{'s' * (len(self.rejected) != 1)} rejected")
        return "\n".join(lines)

    def with_notes(self, *notes: str) -> Self:
        """Return the same shots with further notes, whose arrays are neither checked nor completed again."""
        noted = copy(self)
        object.__setattr__(noted, "notes", tuple(dict.fromkeys((*self.notes, *notes))))
        return noted

    def select(self, which: Any) -> Self:
        """Return some of the shots: a mask, indices or a slice, as NumPy takes them; rejected rows and notes stay."""
        try:
            index = np.arange(len(self))[which]
        except IndexError as error:
            raise InputError("which", which, f"a mask or indices of {len(self)} shots ({error})") from None
        index = np.atleast_1d(index)
        return replace(
            self,
            deliveries={name: values[index] for name, values in self.deliveries.items()},
            launches={name: values[index] for name, values in self.launches.items()},
            derived={name: values[index] for name, values in self.derived.items()},
            rows=self.rows[index],
            **{name: None if (texts := getattr(self, name)) is None else texts[index] for name in TEXTS},
        )

    def groups(self) -> NDArray[Any] | None:
        """Return a label for each shot that says which belong together, those of a player; None if there is one player.

        A shot whose player is not named belongs to none.
        """
        if self.players is None or len(set(self.players) - {""}) < 2:
            return None
        lonely = np.array([f"row {row}" for row in self.rows], dtype=object)
        return np.where(self.players == "", lonely, self.players).astype(str)

    def by_player(self) -> Iterator[tuple[str, NDArray[np.intp]]]:
        """Yield each player and the places of his shots; all shots under "" where the file does not name two players.

        Where it does, those of which it does not name the player come under "" too.
        """
        if self.players is None or self.groups() is None:
            yield "", np.arange(len(self))
            return
        for player in dict.fromkeys(self.players):
            yield str(player), np.flatnonzero(self.players == player)

    def delivery(self) -> dict[str, Floats]:
        """Return what :func:`impact` takes as ``delivery``: the deliveries, and the hand as +1 or -1."""
        given = dict(self.deliveries)
        if self.hand is not None:
            given[HAND] = np.array([float(HANDS[each]) for each in self.hand])
        return given

    def units(self) -> dict[str, str]:
        """Return the SI unit of each quantity there is."""
        dimensions = shot_words().dimensions
        return {name: SI_UNITS[dimensions[name]] for name in (*self.deliveries, *self.launches)}

    def to_pandas(self) -> pandas.DataFrame:
        """Return one row a shot, SI: ``row``, the texts of ``TEXTS`` where known, then every quantity.

        ``attrs`` of the frame holds ``units`` and ``source``, ``format``, ``rejected``, ``notes``, ``speed_at``,
        ``face_at``.
        """
        import pandas

        columns: dict[str, Any] = {"row": self.rows}
        columns |= {heading: texts for name, heading in TEXTS.items() if (texts := getattr(self, name)) is not None}
        frame = pandas.DataFrame(columns | self.deliveries | self.launches)
        kept = {name: getattr(self, name) for name in ("source", "format", "notes", "speed_at", "face_at")}
        frame.attrs = {"units": self.units(), "rejected": [tuple(each) for each in self.rejected], **kept}
        return frame

    def columns(self) -> dict[str, Any]:
        """Return the columns of a table of the shots by their headings, numbers in the units that these name."""
        columns: dict[str, Any] = {}
        for name, heading in TEXTS.items():
            if (texts := getattr(self, name)) is not None:
                columns[heading] = [str(each) for each in texts]
        for name, points in POINTS.items():
            if getattr(self, name) != points[0]:
                columns[name] = [getattr(self, name)] * len(self)
        of = self.deliveries | self.launches
        for name, si_unit in self.units().items():
            named, shown = heading_of(name, si_unit)
            columns[named] = from_si(of[name], shown)
        return columns

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the shots to a CSV or Parquet file, by its ending, as :func:`clubface.read_shots` reads them.

        The file has its name only once it is complete. Rejected rows and notes are not in it.
        """
        write_columns(self.columns(), Path(path))


def _floats(given: Mapping[str, Any], known: Any, count: int) -> dict[str, Floats]:
    check_names("quantity", given, known)
    dimensions = shot_words().dimensions
    read = {name: parse_values(values, dimensions[name], name=name) for name, values in given.items()}
    return {name: _of_length(np.asarray(values), name, count) for name, values in read.items()}


def _texts(given: Any) -> NDArray[Any]:
    """Return names, "" where one is missing."""
    missing = (
        np.ma.getmaskarray(given) if isinstance(given, np.ma.MaskedArray) else np.zeros(np.shape(given), dtype=bool)
    )
    names = np.array(np.ma.getdata(given), dtype=object)
    if missing.any() or set(map(type, names.ravel())) != {str}:
        names[[bool(gone) or is_missing(each) for each, gone in zip(names, missing, strict=True)]] = ""
    return names


def _of_length(values: NDArray[Any], name: str, count: int) -> NDArray[Any]:
    if values.shape != (count,):
        raise InputError(
            name, Told(f"an array of shape {values.shape}"), f"one with an element for each shot: ({count},)"
        )
    return values
