"""The report of a player's shots, club by club, and how they changed from session to session.

The report of a player's shots: its pieces, club by club, and the file.

How the shots of a club changed from session to session, and how sure each change is.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from clubface.errors import InputError
from clubface.jobs.workers import in_processes, in_sequence
from clubface.present import player_sentences
from clubface.present.club_summary import MOST_INFERRED, ClubFigures, Figure, figure, figures_of
from clubface.present.document import (
    Block,
    Bullets,
    Data,
    Heading,
    Paragraph,
    Picture,
    Table,
    check_ending,
    file_name,
    write_document,
)
from clubface.present.player_sentences import NAMES, SIDES, amount, unit_of
from clubface.present.report import provenance_blocks
from clubface.shots.loft_origin import AT_LAUNCH, loft_origins, origin_notes
from clubface.shots.recorded import RecordedShots, in_order, session_labels
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.support.processes import processors
from clubface.units import from_si, size

SHOWN = ("speed", "ball_speed", "launch", "total_spin", "carry", "side", "azimuth", "face", "path", "attack")
"""Quantities whose means are shown."""


def progress(club: ClubFigures) -> Iterator[Block]:
    """Yield the section on the sessions of a club; nothing where there is one."""
    sessions = by_session(club.shots)
    if len(sessions) < 2:
        return
    names = [name for name in SHOWN if sum(name in each for each in sessions.values()) > 1]
    if not names:
        return
    yield Heading(3, "From session to session")
    counts = {label: max(each.count for each in figures.values()) for label, figures in sessions.items()}
    rows = [
        [label, str(counts[label]), *(_cell(figures.get(name), name) for name in names)]
        for label, figures in sessions.items()
    ]
    yield Table(["session", "shots", *(NAMES[name] for name in names)], rows, _progress_data(club, sessions, names))
    yield Paragraph(("± is how much the shots of a session differ (one standard deviation).",))
    first, *_, last = sessions
    changes = [text for name in names if (text := _change(name, sessions[first], sessions[last]))]
    if changes:
        yield Paragraph((f"From {first} to {last}, each with what chance leaves open 19 times out of 20:",))
        yield Bullets(changes)
    else:
        yield Paragraph(("One shot a session is too few to tell a change from chance.",))


def by_session(shots: RecordedShots) -> dict[str, dict[str, Figure]]:
    """Return the figures of each session by quantity, in the order of the sessions; one without a name is all."""
    labels = session_labels(shots)
    if labels is None:
        return {}
    values = shots.deliveries | shots.launches
    sessions = {
        label: {name: each for name in SHOWN if name in values and (each := figure(values[name][labels == label]))}
        for label in in_order(labels)
    }
    return {label: each for label, each in sessions.items() if each}


def _cell(figures: Figure | None, name: str) -> str:
    if figures is None:
        return ""
    return amount(figures.mean, name) + ("" if math.isnan(figures.spread) else f" ± {amount(figures.spread, name)}")


def _change(name: str, first: Mapping[str, Figure], last: Mapping[str, Figure]) -> str | None:
    """Say how a mean changed; None where there is no telling, since a session has a single shot."""
    if name not in first or name not in last or min(first[name].count, last[name].count) < 2:
        return None
    old, new = first[name], last[name]
    error = _difference_error(old, new)
    change = new.mean - old.mean
    digits = 1
    size_of = amount(abs(change), name, digits=digits)
    if name in SIDES:
        more, less = SIDES[name].split()
        which = f"{size_of} further {more if change > 0.0 else less}"
    else:
        which = f"{size_of} {'more' if change > 0.0 else 'less'}"
    open_ = f"give or take {amount(error, name, digits=digits)}"
    if not size_of.strip("0.°").startswith(tuple("123456789")):
        return f"{NAMES[name]}: the same, {open_}"
    if abs(change) <= error:
        return f"{NAMES[name]}: no sure change ({which}, {open_})"
    return f"{NAMES[name]}: {which}, {open_}"


def _difference_error(one: Figure, other: Figure) -> float:
    """Return half of the 95% interval of the difference of two means, whose spreads may differ (Welch, 1947)."""
    from scipy.special import stdtrit

    parts = [each.spread**2 / each.count for each in (one, other)]
    total = sum(parts)
    if total == 0.0:
        return 0.0
    freedom = total**2 / sum(part**2 / (each.count - 1) for part, each in zip(parts, (one, other), strict=True))
    return float(stdtrit(freedom, 0.975)) * math.sqrt(total)


def _progress_data(club: ClubFigures, sessions: Mapping[str, Mapping[str, Figure]], names: list[str]) -> Data:
    headings = ["session"]
    for name in names:
        unit = unit_of(name)
        headings += [f"{name} ({unit})", f"{name} standard deviation ({unit})", f"{name} shots"]
    rows = []
    for label, figures in sessions.items():
        row: list[str | float] = [label]
        for name in names:
            each, unit = figures.get(name), unit_of(name)
            mean, spread = (each.mean, each.spread) if each else (np.nan, np.nan)
            row += [float(from_si(mean, unit)), spread / size(unit), each.count if each else 0]
        rows.append(row)
    return Data(file_name(f"{club.title} sessions"), headings, rows)


CLUBLESS = "a club without a name"
MOST_PICTURES = 40
"""Pictures of a report; each takes a fifth of a second and 150 kB."""


def blocks(clubs: list[ClubFigures], shots: RecordedShots) -> Iterator[Block]:
    """Yield the pieces of the report on shots, of which ``clubs`` holds the figures club by club."""
    yield Heading(1, "Your shots, and what they say")
    names = [f"{each.title} ({len(each.shots)})" for each in clubs]
    player = _only_player(shots)
    sources = Path(shots.source).name if shots.files is None else ", ".join(map(str, dict.fromkeys(shots.files)))
    whose = f" by {player}" if player else ""
    yield Paragraph(
        (f"This report is about {player_sentences.counted(len(shots))}{whose} of {sources}: {', '.join(names)}.",)
    )
    if len(clubs) > MOST_PICTURES:
        advice = "a report on some of the players draws them all (--where)"
        yield Paragraph((f"Pictures are drawn for the first {MOST_PICTURES} of {len(clubs)} clubs; {advice}.",))
    for place, each in enumerate(clubs):
        yield Heading(2, each.title[:1].upper() + each.title[1:])
        yield Paragraph(tuple(player_sentences.measured(each)))
        if place < MOST_PICTURES:
            yield _picture(each)
        for title, texts in (
            ("Where the ball starts, and why", tuple(player_sentences.line(each))),
            ("Where you strike it", tuple(player_sentences.strike(each))),
        ):
            if texts:
                yield Heading(3, title)
                yield Paragraph(texts)
        if changes := tuple(player_sentences.what_if(each)):
            yield Heading(3, "What would change your average shot")
            yield Paragraph(("Each of these alone, with all else as it is:",))
            yield Bullets(changes)
        yield from progress(each)
        if doubts := tuple(player_sentences.doubt(each)):
            yield Heading(3, "How sure we are")
            yield Paragraph(doubts)
    if notes := [*origin_notes(loft_origins(shots), AT_LAUNCH), *dict.fromkeys(shots.notes)]:
        yield Heading(2, "Notes on the file")
        yield Bullets(tuple(f"{note[:1].upper()}{note[1:]}." for note in notes))
    hands = "" if shots.hand is None else " and ".join(sorted(set(map(str, shots.hand))))
    given = {"file": sources, "read as": shots.format, "shots": str(len(shots)),
             "rows that gave no shot": str(len(shots.rejected)), "hand": hands or "not told"}  # fmt: skip
    launches = [each.launch for each in clubs if each.launch is not None]
    yield from provenance_blocks(provenance_of(launches, given | flight_conditions()))


def write_report(shots: RecordedShots, path: str | os.PathLike[str], *, more: Iterable[Block] = ()) -> Path:
    """Write the report of a player's shots to one file, Markdown or HTML by its ending; return its path.

    ``more`` stands at its end.
    """
    check_ending(path)
    if not len(shots):
        raise InputError("shots", shots.source, "at least one shot")
    return write_document([*blocks(figures_by_club(shots), shots), *more], path)


def figures_by_club(shots: RecordedShots) -> list[ClubFigures]:
    """Return the figures of each club of each player; what two players hit is no one's typical shot."""
    groups = []
    for player, places in shots.by_player():
        of = shots.select(places)
        names = [""] if of.clubs is None else dict.fromkeys(of.clubs)
        groups += [(player, str(name), of if of.clubs is None else of.select(of.clubs == name)) for name in names]
    many = sum(min(len(each), MOST_INFERRED) for _, _, each in groups) >= FEWEST_FOR_PROCESSES
    how = in_processes if many and len(groups) > 1 and processors() > 1 else in_sequence
    found = {number: each for (number, _), each in how(enumerate(groups), partial(_figures, len(groups)))}
    return [found[number] for number in range(len(groups))]


FEWEST_FOR_PROCESSES = 200
"""Shots from which on it pays to start processes: their deliveries take a few seconds."""


def _figures(clubs: int, group: tuple[int, tuple[str, str, RecordedShots]]) -> ClubFigures:
    player, name, shots = group[1]
    return replace(figures_of(shots, name or CLUBLESS, clubs), player=player)


def _only_player(shots: RecordedShots) -> str:
    """Return the player whose shots all are, "" where the file does not say."""
    named = set() if shots.players is None else set(map(str, shots.players))
    return named.pop() if len(named) == 1 else ""


def _picture(of: ClubFigures) -> Picture:
    from clubface.plots import svg
    from clubface.present.player_picture import club_picture

    shows = f"{of.title}: where the shots go, and face, path and start line"
    return Picture(shows, svg(club_picture(of)), _data(of))


def _data(of: ClubFigures) -> Data:
    columns = of.shots.columns()
    return Data(file_name(of.title), list(columns), list(zip(*columns.values(), strict=True)))
