"""The report of a player's shots, club by club, and how they changed from session to session, as a result."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from clubface.errors import InputError
from clubface.inference import player_sentences
from clubface.inference.player_sentences import NAMES, SIDES, amount
from clubface.inference.player_statistics import (
    MOST_INFERRED,
    ClubStatistics,
    Statistic,
    club_statistics,
    difference_error,
    statistic,
)
from clubface.jobs.workers import in_processes, in_sequence
from clubface.quantities import quantity
from clubface.results.notes import free_text
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.loft_origin import AT_LAUNCH, loft_origins, origin_notes
from clubface.shots.recorded import TEXTS, RecordedShots, in_order, session_labels
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.support.processes import processors
from clubface.units import to_si

__all__ = ["player_result"]

SHOWN = ("speed", "ball_speed", "launch", "total_spin", "carry", "side", "azimuth", "face", "path", "attack")
"""Quantities whose means are shown from session to session."""
CLUBLESS = "a club without a name"
MOST_PICTURES = 40
"""Pictures of a report; each takes a fifth of a second and 150 kB."""
MOST_ROWS = 10
"""Shots of a club that a report shows; its data have all."""
FEWEST_FOR_PROCESSES = 200
"""Number of shots from which it pays to start processes: their deliveries take a few seconds."""
RAYS = {"azimuth": "start of the ball", "face": "club face", "path": "club path"}
LEAST_ANGLE = to_si(4.0, "deg")
"""Smallest half width [rad] of the picture of directions."""


def player_result(shots: RecordedShots) -> Result:
    """Return for a player, in plain language: what was measured, what it means, and how sure that is.

    Its parts are the clubs of each player, with their sections.

    Raises
    ------
    InputError
        There is no shot.
    """
    if not len(shots):
        raise InputError("shots", shots.source, "at least one shot")
    return result_of_clubs(statistics_by_club(shots), shots)


def statistics_by_club(shots: RecordedShots) -> list[ClubStatistics]:
    """Return the statistics of each club of each player; the shots of two players are not averaged."""
    groups = []
    for player, places in shots.by_player():
        theirs = shots.select(places)
        if theirs.clubs is None:
            groups.append((player, "", theirs))
        else:
            groups += [(player, str(name), theirs.select(theirs.clubs == name)) for name in dict.fromkeys(theirs.clubs)]
    many = sum(min(len(each), MOST_INFERRED) for _, _, each in groups) >= FEWEST_FOR_PROCESSES
    run = in_processes if many and len(groups) > 1 and processors() > 1 else in_sequence
    made = {number: each for (number, _), each in run(enumerate(groups), partial(_statistics, len(groups)))}
    return [made[number] for number in range(len(groups))]


def _statistics(clubs: int, group: tuple[int, tuple[str, str, RecordedShots]]) -> ClubStatistics:
    player, name, shots = group[1]
    return replace(club_statistics(shots, name or CLUBLESS, clubs), player=player)


def result_of_clubs(clubs: list[ClubStatistics], shots: RecordedShots) -> Result:
    """Return the report on shots, of which ``clubs`` holds the statistics club by club."""
    names = [f"{each.title} ({len(each.shots)})" for each in clubs]
    players = set() if shots.players is None else set(map(str, shots.players))
    whose = f" by {next(iter(players))}" if len(players) == 1 and players != {""} else ""
    sources = Path(shots.source).name if shots.files is None else ", ".join(map(str, dict.fromkeys(shots.files)))
    summary = [f"This report is about {player_sentences.counted(len(shots))}{whose} of {sources}: {', '.join(names)}."]
    if len(clubs) > MOST_PICTURES:
        advice = "a report on some of the players draws them all (--where)"
        summary.append(f"Pictures are drawn for the first {MOST_PICTURES} of {len(clubs)} clubs; {advice}.")
    parts = [_club_result(each, place < MOST_PICTURES) for place, each in enumerate(clubs)]
    if notes := [*origin_notes(loft_origins(shots), AT_LAUNCH), *dict.fromkeys(shots.notes)]:
        sentences = [f"{note[:1].upper()}{note[1:]}." for note in notes]
        parts.append(Result("notes", "Notes on the file", notes=tuple(free_text(sentences))))
    hands = "" if shots.hand is None else " and ".join(sorted(set(map(str, shots.hand))))
    inputs = {"file": sources, "read as": shots.format, "shots": str(len(shots)),
              "rows that gave no shot": str(len(shots.rejected)), "hand": hands or "not known"}  # fmt: skip
    launches = [each.launch for each in clubs if each.launch is not None]
    return Result(
        "player-report",
        "Your shots, and what they say",
        summary=tuple(free_text(summary)),
        provenance=provenance_of(launches, inputs | flight_conditions()),
        parts=tuple(parts),
    )


def _club_result(club: ClubStatistics, is_drawn: bool) -> Result:
    """Return the part on one club."""
    sections = [
        Result("section", title, summary=tuple(free_text(list(sentences))))
        for title, sentences in (
            ("Where the ball starts, and why", player_sentences.line(club)),
            ("Where you strike it", player_sentences.strike(club)),
        )
    ]
    if changes := list(player_sentences.what_if(club)):
        sections.append(
            Result(
                "changes",
                "What would change your average shot",
                summary=tuple(free_text(["Each of these alone, with all else as it is:"])),
                notes=tuple(free_text(changes)),
                tables=(_changes_table(club),),
            )
        )
    sections += sessions_result(club)
    sections.append(Result("section", "How sure we are", summary=tuple(free_text(list(player_sentences.doubt(club))))))
    return Result(
        "club",
        club.title[:1].upper() + club.title[1:],
        summary=tuple(free_text(list(player_sentences.measured(club)))),
        tables=(_statistics_table(club), _shots_table(club)),
        draw=(lambda: [club_picture(club)]) if is_drawn else None,
        parts=tuple(each for each in sections if each.summary),
    )


def _statistics_table(club: ClubStatistics) -> Table:
    estimated = club.inferred
    known = {*club.measured, *(estimated.mean if estimated is not None else ())}
    names = [each for each in dict.fromkeys((*NAMES, *club.measured, *sorted(known))) if each in known]
    of_rows = [quantity(each) for each in names]

    def numbers(name: str, label: str = "") -> Column:
        values = [getattr(club.measured[each], name) if each in club.measured else None for each in names]
        return Column(name, values, of_rows, label=label)

    columns: list[Column] = [
        text("quantity", names, printed=False),
        text("name", [NAMES.get(each, each.replace("_", " ")) for each in names], label="quantity", in_files=False),
        text("shots", [club.measured[each].count if each in club.measured else 0 for each in names]),
        numbers("mean"), numbers("spread", "±"), numbers("low", "two of three from"), numbers("high", "to"),
    ]  # fmt: skip
    if estimated is not None:
        for name, values, label in (("inferred", estimated.mean, "estimate of the delivery"),
                                    ("inferred_doubt", estimated.doubt, "± of one shot")):  # fmt: skip
            columns.append(Column(name, [values.get(each) for each in names], of_rows, label=label))
    return table("statistics", *columns, title="All figures of this club")


def _shots_table(club: ClubStatistics) -> Table:
    shots = club.shots
    texts = [(heading, getattr(shots, name)) for name, heading in TEXTS.items()]
    count = len(shots)
    title = "The shots" if count <= MOST_ROWS else f"The first {MOST_ROWS} of {count} shots; the data have all"
    return table(
        "shots",
        *(text(heading, list(map(str, values))) for heading, values in texts if values is not None),
        *(column(name, values) for name, values in (shots.deliveries | shots.launches).items()),
        title=title,
        shown_rows=range(min(count, MOST_ROWS)),
    )


def _changes_table(club: ClubStatistics) -> Table:
    changes = club.changes
    return table(
        "changes",
        text("change", [each.name for each in changes], printed=False),
        text("words", [f"you {player_sentences.STEPS[each.name]}" for each in changes], label="if", in_files=False),
        Column("step", [each.step for each in changes], [quantity(each.name) for each in changes], difference=True),
        *(column(name, [each.launch[name] for each in changes], difference=True)
          for name in ("ball_speed", "launch", "azimuth", "backspin", "sidespin")),
        *(column(name, [getattr(each, name) for each in changes], difference=True) for name in ("carry", "side")),
    )  # fmt: skip


def sessions_result(club: ClubStatistics) -> Iterator[Result]:
    """Yield the section on the sessions of a club; nothing where there is only one."""
    sessions = by_session(club.shots)
    names = [name for name in SHOWN if sum(name in each for each in sessions.values()) > 1]
    if len(sessions) < 2 or not names:
        return
    labels = list(sessions)
    columns = [
        text("session", labels),
        text("shots", [max(each.count for each in sessions[label].values()) for label in labels]),
    ]
    for name in names:
        statistics = [sessions[label].get(name) for label in labels]
        columns += [
            column(name, [None if each is None else each.mean for each in statistics], label=NAMES[name]),
            column(f"{name}_deviation", [None if each is None else each.spread for each in statistics], name,
                   label="±"),
            text(f"{name}_shots", [0 if each is None else each.count for each in statistics], printed=False),
        ]  # fmt: skip
    first, last = sessions[labels[0]], sessions[labels[-1]]
    both = [name for name in names if name in first and name in last and min(first[name].count, last[name].count) > 1]
    changed = table(
        "changes", text("quantity", both), text("name", [NAMES[name] for name in both], label="", in_files=False),
        Column("change", [last[name].mean - first[name].mean for name in both], [quantity(name) for name in both],
               difference=True),
        Column("error", [difference_error(first[name], last[name]) for name in both],
               [quantity(name) for name in both], label="give or take"), printed=False,
    )  # fmt: skip
    sentences = ["± is how much the shots of a session differ (one standard deviation)."]
    if both:
        sentences.append(f"From {labels[0]} to {labels[-1]}, with margins that hold 19 times out of 20:")
    else:
        sentences.append("One shot a session is too few to tell a change from chance.")
    yield Result(
        "sessions",
        "From session to session",
        summary=tuple(free_text(sentences)),
        tables=(table("sessions", *columns), *([changed] if both else [])),
        notes=tuple(free_text([change_sentence(name, first[name], last[name]) for name in both])),
    )


def by_session(shots: RecordedShots) -> dict[str, dict[str, Statistic]]:
    """Return the statistics of each session by quantity, in the order of the sessions; none where there is only one."""
    labels = session_labels(shots)
    if labels is None:
        return {}
    values = shots.deliveries | shots.launches
    sessions = {
        label: {name: each for name in SHOWN if name in values and (each := statistic(values[name][labels == label]))}
        for label in in_order(labels)
    }
    return {label: each for label, each in sessions.items() if each}


def change_sentence(name: str, first: Statistic, last: Statistic) -> str:
    """Return how a mean changed, and how sure that is, in words."""
    change, error = last.mean - first.mean, difference_error(first, last)
    size = amount(abs(change), name, digits=1)
    more, less = SIDES[name].split() if name in SIDES else ("more", "less")
    direction = f"{size} {'further ' if name in SIDES else ''}{more if change > 0.0 else less}"
    doubt = f"give or take {amount(error, name, digits=1)}"
    if not size.strip("0.°").startswith(tuple("123456789")):
        return f"{NAMES[name]}: the same, {doubt}"
    return f"{NAMES[name]}: " + (f"no sure change ({direction}, {doubt})" if abs(change) <= error else
                                 f"{direction}, {doubt}")  # fmt: skip


def club_picture(club: ClubStatistics) -> Picture:
    """Return the picture of a club: where its shots finish or start, and face, path and start line from above."""
    caption = f"{club.title}: where the shots go, and face, path and start line"
    return Picture(f"{club.title} picture", caption, [[_shots_panel(club), _directions_panel(club)]], height=3.0)


def _shots_panel(club: ClubStatistics) -> Panel:
    columns = club.shots.deliveries | club.shots.launches
    landed = {"carry", "side"} <= set(columns)
    across, along = ("side", "carry") if landed else ("azimuth", "ball_speed")
    title = "Where your shots land" if landed else "How your shots start"
    words = "left - distance from the line - right" if landed else "left - start direction - right"
    nothing = np.full(len(club.shots), math.nan)
    x, y = (columns.get(name, nothing) for name in (across, along))
    known = np.isfinite(x) & np.isfinite(y)
    if not known.any():
        return Panel([Mark("text", texts=["no direction was measured"])], title=title)
    x, y = x[known], y[known]
    widest = 1.15 * max(float(np.abs(x).max()), to_si(1.0, "yd" if landed else "deg"))
    marks = [
        Mark("points", x=x, y=y, label="shots", style=0, faint=True),
        Mark("points", x=[x.mean()], y=[y.mean()], label="mean", style=-2, symbol="+", size=14.0),
        Mark("rule", x=0.0, style=-1),
    ]
    return Panel(marks, axis(across, words, limits=(-widest, widest)), axis(along), title)


def _directions_panel(club: ClubStatistics) -> Panel:
    """Return the directions as rays from the ball, seen from above, the target up."""
    angles = {name: club.measured[name].mean for name in RAYS if name in club.measured}
    estimated = set()
    if club.inferred is not None:
        estimated = {name for name in ("face", "path") if name not in angles}
        angles |= {name: club.inferred.mean[name] for name in estimated}
    widest = max([LEAST_ANGLE, *(1.3 * abs(each) for each in angles.values())])
    marks = [Mark("rule", x=0.0, style=-1)]
    for name, angle in angles.items():
        label = f"{RAYS[name]} {abs(math.degrees(angle)):.1f}° {'right' if angle > 0 else 'left'}"
        marks.append(Mark("line", x=[0.0, angle], y=[0.0, 1.0], style=list(RAYS).index(name), size=2.0,
                          label=label + (", estimated" if name in estimated else ""),
                          dash=1 if name in estimated else 0))  # fmt: skip
    across = axis("azimuth", "left - degrees from the target - right", unit="deg", limits=(-widest, widest))
    return Panel(marks, across, Axis(limits=(0.0, 1.45), ticks=False), "From above, the target up", legend=bool(angles))
