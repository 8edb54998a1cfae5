"""How the shots of a club changed from session to session, and how sure each change is."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np

from clubface.player_report.figures_of_club import ClubFigures, Figure, figure
from clubface.player_report.words import NAMES, SIDES, amount, unit_of
from clubface.recorded.sessions import in_order, session_labels
from clubface.recorded.shots import RecordedShots
from clubface.reports.blocks import Block, Bullets, Data, Heading, Paragraph, Table
from clubface.reports.document import file_name
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
    yield Table(["session", "shots", *(NAMES[name] for name in names)], rows, _data(club, sessions, names))
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


def _data(club: ClubFigures, sessions: Mapping[str, Mapping[str, Figure]], names: list[str]) -> Data:
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
