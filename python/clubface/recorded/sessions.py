"""Sessions: the shots of several files as one, and which shots were hit on the same day."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.recorded.shots import TEXTS, RecordedShots
from clubface.support.input_files import short_names

FEWEST_SAME = 3
"""Values that two shots of different files must share to be the same shot."""
_MEASURED_AT = {
    "speed_at": ("club speed, attack angle and path", {"speed", "attack", "path"}),
    "face_at": ("dynamic loft and face angle", {"loft", "face"}),
}
"""What is taken at each place, in words and by quantity."""
NAMED = 3
"""Files that the name of their shots lists."""


def joined(sessions: Sequence[RecordedShots]) -> RecordedShots:
    """Return the shots of several files as one, in the order given, each shot with its file.

    A shot that an earlier file has already, with the same club, player, date and values, is left out, and a note counts
    such shots: exports overlap, and a file may be given twice.
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
        f"{name}: {np.sum(~mask)} of {mask.size} shots are in an earlier file too, and were left out"
        for name, mask in zip(names, kept, strict=True)
        if not mask.all()
    ]
    for note in dict.fromkeys(note for each in sessions for note in each.notes):
        holders = [name for name, each in zip(names, sessions, strict=True) if note in each.notes]
        notes.append(note if len(holders) == len(sessions) else f"{', '.join(holders)}: {note}")
    points = {}
    for point, (what, quantities) in _MEASURED_AT.items():
        where = list(dict.fromkeys(getattr(each, point) for each in sessions if quantities & each.deliveries.keys()))
        points[point] = where[0] if len(where) == 1 else getattr(sessions[0], point) if not where else "unknown"
        if len(where) > 1:
            notes.append(f"the files take {what} at different places ({', '.join(where)}), so that they do not compare")
    parts = [each.select(mask) for each, mask in zip(sessions, kept, strict=True) if mask.any()]
    columns = {
        kind: _columns([getattr(each, kind) for each in parts], parts) for kind in ("deliveries", "launches", "derived")
    }
    texts = {name: _texts([getattr(each, name) for each in parts], parts) for name in TEXTS}
    if texts["hand"] is not None and "" in texts["hand"]:
        texts["hand"] = None
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
            (row.tobytes(), *("" if of is None else str(of[place]) for of in texts))
            for place, row in enumerate(np.nan_to_num(table, nan=1e300))
        ]
        kept.append(np.array([not (many and key in seen) for key, many in zip(keys, enough, strict=True)], dtype=bool))
        seen |= set(keys)
    return kept


def _columns(every: Sequence[dict[str, Any]], parts: Sequence[RecordedShots]) -> dict[str, Any]:
    names = dict.fromkeys(name for each in every for name in each)
    return {
        name: np.concatenate([each.get(name, np.full(len(of), np.nan)) for each, of in zip(every, parts, strict=True)])
        for name in names
    }


def _texts(every: Sequence[Any], parts: Sequence[RecordedShots]) -> Any:
    if all(each is None for each in every):
        return None
    empty = [np.array([""] * len(of), dtype=object) for of in parts]
    return np.concatenate([none if each is None else each for each, none in zip(every, empty, strict=True)])
