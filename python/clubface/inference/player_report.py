"""The report of a player's shots: a first page, then each club, with changes from session to session."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import groupby
from pathlib import Path
from typing import NamedTuple

import numpy as np

from clubface.errors import InputError
from clubface.inference.player_page import (
    LoftNotes,
    change_note,
    doubt_notes,
    line_notes,
    mishit_notes,
    page_parts,
    strike_notes,
    typical_notes,
    what_if_notes,
)
from clubface.inference.player_statistics import (
    MOST_INFERRED,
    ClubStatistics,
    club_statistics,
    with_computed_carry,
)
from clubface.jobs.workers import in_processes, in_sequence
from clubface.quantities import quantity
from clubface.results.notes import note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.loft_origin import loft_origins, origin_notes
from clubface.shots.mishits import Statistic, difference_error, statistic
from clubface.shots.recorded import TEXTS, RecordedShots, in_order, session_labels
from clubface.shots.session_summary import session_picture, summarize_clubs
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.support.processes import processors
from clubface.units import to_si

__all__ = ["player_result"]

SHOWN = ("speed", "ball_speed", "launch", "total_spin", "carry", "side", "azimuth", "face", "path", "attack")
"""Quantities whose medians are shown by session."""
FIRST = ("speed", "attack", "path", "loft", "face", "toe", "high", "ball_speed", "launch", "azimuth", "total_spin",
         "carry", "side")  # fmt: skip
"""Quantities at the top of the table of statistics."""
CLUBLESS = "a club without a name"
MOST_PICTURES = 40
"""Maximum number of pictures of clubs and bags; each takes a fifth of a second and 150 kB."""
MOST_LOFTS = 8
"""Maximum number of players whose driver loft is assessed; each takes a few seconds."""
MOST_ROWS = 10
"""Maximum number of shots of a club shown in a report; the data files have all."""
FEWEST_FOR_PROCESSES = 200
"""Number of shots above which worker processes pay off: their deliveries take a few seconds."""
RAYS = {"azimuth": "start of the ball", "face": "club face", "path": "club path"}
LEAST_ANGLE = to_si(4.0, "deg")
"""Minimum half width of the picture of directions [rad]."""


class _Scale(NamedTuple):
    """The common scale of the pictures of a player's clubs, SI.

    ``across`` and ``along`` are the horizontal quantity of the pictures of shots with its half width, and the vertical
    one with its ends; ``widest`` is the half width of the pictures of directions [rad].
    """

    across: str
    along: str
    half_width: float
    ends: tuple[float, float]
    widest: float


def player_result(shots: RecordedShots, *, loft_notes: LoftNotes | None = None) -> Result:
    """Return the report for a player in plain language: what was measured, what it means, and how sure that is.

    It starts with a page on the bag, with findings, practice, clubs to buy and how sure that is; the clubs follow. With
    several players, each has a part with a page of their own.

    Parameters
    ----------
    shots
        The shots.
    loft_notes
        Assesses the loft of the driver for the first page, as :func:`clubface.design.loft_fit.player_loft_notes` does.
        Default: lofts are not assessed.

    Raises
    ------
    InputError
        There is no shot.
    """
    if not len(shots):
        raise InputError("shots", shots.source, "at least one shot")
    return result_of_clubs(statistics_by_club(shots), shots, loft_notes)


def statistics_by_club(shots: RecordedShots) -> list[ClubStatistics]:
    """Return the statistics of each club of each player, longest club first; players are not averaged."""
    groups = [(each.player, each.club, shots.select(each.places)) for each in summarize_clubs(shots)]
    many = sum(min(len(each), MOST_INFERRED) for _, _, each in groups) >= FEWEST_FOR_PROCESSES
    run = in_processes if many and len(groups) > 1 and processors() > 1 else in_sequence
    made = {number: each for (number, _), each in run(enumerate(groups), partial(_statistics, len(groups)))}
    return [made[number] for number in range(len(groups))]


def _statistics(clubs: int, group: tuple[int, tuple[str, str, RecordedShots]]) -> ClubStatistics:
    player, name, shots = group[1]
    return replace(club_statistics(shots, name or CLUBLESS, clubs), player=player)


def result_of_clubs(clubs: list[ClubStatistics], shots: RecordedShots, loft_notes: LoftNotes | None = None) -> Result:
    """Return the report on shots from the statistics of their ``clubs``."""
    names = [f"{each.title} ({len(each.shots)})" for each in clubs]
    players = set() if shots.players is None else set(map(str, shots.players))
    sources = Path(shots.source).name if shots.files is None else ", ".join(map(str, dict.fromkeys(shots.files)))
    data = {"shots": len(shots), "file": sources, "clubs": names}
    if len(players) == 1 and players != {""}:
        summary = [note("player-report-by", player=next(iter(players)), **data)]
    else:
        summary = [note("player-report-of", **data)]
    if loft_notes is not None and len(players) > MOST_LOFTS:
        loft_notes = None
        summary.append(note("player-lofts-not-judged", players=len(players)))
    drawn = _clubs_to_draw(clubs)
    if len(drawn) < len(clubs):
        summary.append(note("player-pictures-of-some", drawn=len(drawn), clubs=len(clubs)))
    flown = with_computed_carry(shots)
    of_players = [
        _player_parts(list(theirs), flown, drawn, loft_notes)
        for _, theirs in groupby(clubs, key=lambda each: each.player)
    ]
    first, parts = Result("player", ""), ()
    if len(of_players) == 1:
        first = of_players[0]
        parts = first.parts
    elif of_players:
        parts = (of_players[0].replace(placement="here"), *of_players[1:])
    if notes := [*origin_notes(loft_origins(shots)), *dict.fromkeys(shots.notes)]:
        about_file = Result("notes", "Notes on the file", notes=tuple(notes), placement="appendix")
        parts = (*parts, about_file)
    hands = "" if shots.hand is None else " and ".join(sorted(set(map(str, shots.hand))))
    inputs = {"file": sources, "read as": shots.format, "shots": str(len(shots)),
              "rows that gave no shot": str(len(shots.rejected)), "hand": hands or "not known"}  # fmt: skip
    launches = [each.launch for each in clubs if each.launch is not None]
    made = provenance_of(launches, inputs | flight_conditions())
    title = "Your shots, and what they say"
    return Result("player-report", title, summary=tuple(summary), provenance=made, draw=first.draw, parts=parts)


def _clubs_to_draw(clubs: Sequence[ClubStatistics]) -> set[int]:
    """Return the identities of the clubs that are drawn: the first ones, leaving room for a picture per bag."""
    players: set[str] = set()
    drawn: set[int] = set()
    for each in clubs:
        players.add(each.player)
        if len(drawn) + 1 + len(players) > MOST_PICTURES:
            break
        drawn.add(id(each))
    return drawn


def _player_parts(
    clubs: Sequence[ClubStatistics], flown: RecordedShots, drawn: set[int], loft_notes: LoftNotes | None
) -> Result:
    """Return the page of one player and their clubs; ``flown`` are the shots of all players with their carries."""
    player = clubs[0].player
    theirs = flown if not player else flown.select(flown.players == player)
    bag = [replace(each, player="") for each in summarize_clubs(theirs)]
    scale = _common_scale(clubs)
    page = page_parts(clubs, bag, loft_notes)
    is_drawn = id(clubs[0]) in drawn and any("carry" in each.spreads for each in bag)
    draw = (lambda: [session_picture(theirs, bag)]) if is_drawn else None
    parts = (*page, *(_club_result(each, scale, id(each) in drawn) for each in clubs))
    return Result("player", player, draw=draw, parts=parts, placement="page")


def _club_result(club: ClubStatistics, scale: _Scale, is_drawn: bool) -> Result:
    """Return the part on one club."""
    sections = [
        Result("section", "Where the ball starts, and why", summary=tuple(line_notes(club))),
        Result("section", "Where you strike it", summary=tuple(strike_notes(club))),
    ]
    if changes := tuple(what_if_notes(club)):
        alone = (note("player-changes-alone"),)
        sections.append(Result("changes", "What would change your typical shot", summary=alone, notes=changes))
    sections += sessions_result(club)
    sections.append(Result("section", "How sure we are", summary=tuple(doubt_notes(club))))
    title = club.title[:1].upper() + club.title[1:]
    tables = (_statistics_table(club), _shots_table(club), *([_changes_table(club)] if club.changes else []))
    figures = Result("figures", title, tables=tables, placement="appendix")
    parts = (*(each for each in sections if each.summary), figures)
    draw = (lambda: [club_picture(club, scale)]) if is_drawn else None
    summary, notes = tuple(typical_notes(club)), tuple(mishit_notes(club))
    return Result("club", title, summary=summary, draw=draw, notes=notes, parts=parts, placement="page")


def _statistics_table(club: ClubStatistics) -> Table:
    estimated = club.inferred
    known = {*club.measured, *(estimated.mean if estimated is not None else ())}
    names = [each for each in dict.fromkeys((*FIRST, *club.measured, *sorted(known))) if each in known]
    of_rows = [quantity(each) for each in names]

    def numbers(name: str, label: str = "") -> Column:
        values = [getattr(club.measured[each], name) if each in club.measured else None for each in names]
        return Column(name, values, of_rows, label=label)

    columns: list[Column] = [
        text("quantity", names, printed=False),
        text("name", [each.label for each in of_rows], label="quantity", in_files=False),
        text("shots", [club.measured[each].shots if each in club.measured else 0 for each in names]),
        numbers("median"), numbers("spread", "±"), numbers("low", "two of three from"), numbers("high", "to"),
        text("measured", [club.measured[each].measured if each in club.measured else 0 for each in names],
             label="with mishits"),
        numbers("mean"), numbers("deviation", "±"),
    ]  # fmt: skip
    if estimated is not None:
        for name, values, label in (("inferred", estimated.mean, "estimate of the delivery"),
                                    ("inferred_doubt", estimated.doubt, "± of one shot")):  # fmt: skip
            columns.append(Column(name, [values.get(each) for each in names], of_rows, label=label))
    return table("statistics", *columns, title="Statistics")


def _shots_table(club: ClubStatistics) -> Table:
    shots = club.shots
    texts = [(heading, getattr(shots, name)) for name, heading in TEXTS.items()]
    count = len(shots)
    title = "The shots" if count <= MOST_ROWS else f"The first {MOST_ROWS} of {count} shots; the data have all"
    return table(
        "shots",
        *(text(heading, list(map(str, values))) for heading, values in texts if values is not None),
        text("mishit", club.mishit.tolist()),
        *(column(name, values) for name, values in (shots.deliveries | shots.launches).items()),
        title=title,
        shown_rows=range(min(count, MOST_ROWS)),
    )


def _changes_table(club: ClubStatistics) -> Table:
    changes = club.changes
    return table(
        "changes",
        text("change", [each.name for each in changes], printed=False),
        text("words", [quantity(each.name).label for each in changes], label="change of", in_files=False),
        Column("step", [each.step for each in changes], [quantity(each.name) for each in changes], difference=True),
        *(column(name, [each.launch[name] for each in changes], difference=True)
          for name in ("ball_speed", "launch", "azimuth", "backspin", "sidespin")),
        *(column(name, [getattr(each, name) for each in changes], difference=True) for name in ("carry", "side")),
        title="What changes of the delivery do to the typical shot",
    )  # fmt: skip


def sessions_result(club: ClubStatistics) -> Iterator[Result]:
    """Yield the section on the sessions of a club, if there are several."""
    sessions = by_session(club)
    names = [name for name in SHOWN if sum(name in each for each in sessions.values()) > 1]
    if len(sessions) < 2 or not names:
        return
    labels = list(sessions)
    columns = [
        text("session", labels),
        text("shots", [max(each.measured for each in sessions[label].values()) for label in labels]),
    ]
    for name in names:
        statistics = [sessions[label].get(name) for label in labels]
        columns += [
            column(name, [None if each is None else each.median for each in statistics]),
            column(f"{name}_deviation", [None if each is None else each.spread for each in statistics], name,
                   label="±"),
            text(f"{name}_shots", [0 if each is None else each.shots for each in statistics], printed=False),
        ]  # fmt: skip
    first, last = sessions[labels[0]], sessions[labels[-1]]
    both = [name for name in names if name in first and name in last and min(first[name].shots, last[name].shots) > 1]
    changed = table(
        "changes",
        text("quantity", both),
        text("name", [quantity(name).label for name in both], label="", in_files=False),
        Column("change", [last[name].median - first[name].median for name in both], [quantity(name) for name in both],
               difference=True),
        Column("error", [difference_error(first[name], last[name]) for name in both],
               [quantity(name) for name in both], label="give or take"),
        title=f"From {labels[0]} to {labels[-1]}",
    )  # fmt: skip
    compared = note("player-sessions-compared", first=labels[0], last=labels[-1])
    summary = (note("player-sessions-spread"), compared if both else note("player-sessions-of-one-shot"))
    notes = tuple(change_note(name, first[name], last[name]) for name in both)
    figures = Result("session-changes", f"{club.title} sessions", tables=(changed,), placement="appendix")
    tables, parts = (table("sessions", *columns),), (figures,) if both else ()
    yield Result("sessions", "From session to session", summary=summary, tables=tables, notes=notes, parts=parts)


def by_session(club: ClubStatistics) -> dict[str, dict[str, Statistic]]:
    """Return the statistics of each session by quantity, in session order; empty if there is only one."""
    labels = session_labels(club.shots)
    if labels is None:
        return {}
    values, mishit = club.shots.deliveries | club.shots.launches, club.mishit
    sessions = {
        label: {
            name: each
            for name in SHOWN
            if name in values and (each := statistic(values[name][labels == label], mishit[labels == label]))
        }
        for label in in_order(labels)
    }
    return {label: each for label, each in sessions.items() if each}


def _common_scale(clubs: Sequence[ClubStatistics]) -> _Scale:
    """Return one scale for the pictures of all clubs of a player."""
    landed = any({"carry", "side"} <= set(each.measured) for each in clubs)
    across, along = ("side", "carry") if landed else ("azimuth", "ball_speed")
    points = [_points(each, across, along) for each in clubs]
    x, y = (np.concatenate([each[place] for each in points]) for place in (0, 1))
    low, high = (float(y.min()), float(y.max())) if y.size else (0.0, 1.0)
    room = 0.06 * (high - low) + to_si(1.0, "yd" if landed else "mph")
    half_width = 1.15 * max(float(np.abs(x).max(initial=0.0)), to_si(1.0, "yd" if landed else "deg"))
    angles = [abs(angle) for each in clubs for angle in _directions(each)[0].values()]
    widest = max([LEAST_ANGLE, *(1.3 * each for each in angles)])
    return _Scale(across, along, half_width, (low - room, high + room), widest)


def _points(club: ClubStatistics, across: str, along: str) -> np.ndarray:
    """Return the shots of a club with both values measured as points, shape [2, shots]."""
    flown = with_computed_carry(club.shots)
    columns, nothing = flown.deliveries | flown.launches, np.full(len(flown), math.nan)
    points = np.array([columns.get(name, nothing) for name in (across, along)])
    return points[:, np.isfinite(points).all(axis=0)]


def club_picture(club: ClubStatistics, scale: _Scale) -> Picture:
    """Return the picture of a club: landings or starts of its shots, and face, path and start line from above."""
    caption = f"{club.title}: where the shots go, and face, path and start line"
    footnote = "grey crosses: mishits, not counted" if club.mishits else ""
    panels = [[_shots_panel(club, scale), _directions_panel(club, scale)]]
    return Picture(f"{club.title} picture", caption, panels, height=3.0, footnote=footnote)


def _shots_panel(club: ClubStatistics, scale: _Scale) -> Panel:
    across, along = scale.across, scale.along
    landed = along == "carry"
    title = "Where your shots land" if landed else "How your shots start"
    words = "left - distance from the line - right" if landed else "left - start direction - right"
    off = club.mishit
    shots, far = (_points(replace(club, shots=club.shots.select(each)), across, along) for each in (~off, off))
    if not shots.size:
        return Panel([Mark("text", texts=["no direction was measured"])], title=title)
    marks = [
        Mark("points", x=shots[0], y=shots[1], label="shots", style=0, faint=True),
        Mark("points", x=[np.median(shots[0])], y=[np.median(shots[1])], label="median", style=-2, symbol="+",
             size=14.0),
        Mark("rule", x=0.0, style=-1),
    ]  # fmt: skip
    if far.size:
        marks.append(Mark("points", x=far[0], y=far[1], label="mishits", style=-1, symbol="x", size=4.0))
    limits = (-scale.half_width, scale.half_width)
    return Panel(marks, axis(across, words, limits=limits), axis(along, limits=scale.ends), title)


def _directions(club: ClubStatistics) -> tuple[dict[str, float], set[str]]:
    """Return start line, face and path [rad], and the names of the estimated ones."""
    angles = {name: club.measured[name].median for name in RAYS if name in club.measured}
    estimated = set()
    if club.inferred is not None:
        estimated = {name for name in ("face", "path") if name not in angles}
        angles |= {name: club.inferred.mean[name] for name in estimated}
    return angles, estimated


def _directions_panel(club: ClubStatistics, scale: _Scale) -> Panel:
    """Return the panel of the directions as rays from the ball, from above, with the target at the top."""
    angles, estimated = _directions(club)
    marks = [Mark("rule", x=0.0, style=-1)]
    for name, angle in angles.items():
        label = f"{RAYS[name]} {abs(math.degrees(angle)):.1f}° {'right' if angle > 0 else 'left'}"
        marks.append(Mark("line", x=[0.0, angle], y=[0.0, 1.0], style=list(RAYS).index(name), size=2.0,
                          label=label + (", estimated" if name in estimated else ""),
                          dash=1 if name in estimated else 0))  # fmt: skip
    across = axis("azimuth", "left - degrees from the target - right", unit="deg", limits=(-scale.widest, scale.widest))
    return Panel(marks, across, Axis(limits=(0.0, 1.45), ticks=False), "From above, the target up", legend=bool(angles))
