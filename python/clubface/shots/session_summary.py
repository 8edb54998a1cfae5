"""Summary of each club in a session: number of shots, medians, spreads, mishits, and carry gaps."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.errors import InputError, Wording
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis, ellipse_about
from clubface.results.result import Provenance, Result
from clubface.results.table import Column, Table, column, row_names, table, text
from clubface.shots.club_names import same_club
from clubface.shots.mishits import Mishit, Statistic, find_mishits, is_mishit, statistic
from clubface.shots.recorded import RecordedShots
from clubface.shots.recorded_result import rejected_table, session_table
from clubface.support.arrays import Floats
from clubface.units import from_si

QUANTITIES = (
    "speed", "ball_speed", "smash", "attack", "launch", "azimuth", "total_spin", "spin_axis", "carry", "side", "total",
)  # fmt: skip
"""Quantities summarised."""
CLEAR_GAP = 2.0
"""Number of standard errors a gap must exceed to be clear."""
FEWEST = 3
"""Minimum number of shots for drawing an ellipse."""
MISHIT = "mishits, not counted"
"""Label of mishits in a legend."""


class Gap(NamedTuple):
    """Median carry of a club minus that of the next shorter club, and its standard error [m]."""

    length: float
    error: float


@dataclass(frozen=True)
class ClubSummary:
    """The shots of one club.

    Attributes
    ----------
    player, club
        Names as in the file, or ""; the player's only if several players are named.
    places, spreads
        Indices of its shots in the session, and statistics by quantity.
    mishits
        Its mishits, with reasons; ``place`` is the index in the session.
    gap
        Carry gap to the player's next shorter club; None for the shortest, or without carry.
    """

    player: str
    club: str
    places: NDArray[np.intp]
    spreads: Mapping[str, Statistic]
    mishits: tuple[Mishit, ...]
    gap: Gap | None

    @property
    def mishit_places(self) -> list[int]:
        """Indices of its mishits in the session."""
        return list(dict.fromkeys(each.place for each in self.mishits))

    @property
    def title(self) -> str:
        """Name of the club, with the player's if there are several."""
        club = self.club or "the shots"
        return f"{self.player}'s {club}" if self.player else club


def summarize_clubs(shots: RecordedShots) -> list[ClubSummary]:
    """Return a summary of each club, the longest first; names of the same club, such as 7i and 7 Iron, are merged.

    Clubs are summarised player by player, in the order of the file. Only measured values count.
    """
    return [
        each for player, places in shots.by_player() for each in _summarize_player(player, shots.select(places), places)
    ]


def _summarize_player(player: str, shots: RecordedShots, whole: NDArray[np.intp]) -> list[ClubSummary]:
    """Return a summary of each club of a player; ``whole`` holds the indices of the player's shots in the session."""
    names = [str(each) for each in shots.clubs] if shots.clubs is not None else [""] * len(shots)
    groups: dict[str, list[int]] = {}
    known: dict[str, str] = {}
    for place, name in enumerate(names):
        if name not in known:
            known[name] = next((each for each in groups if same_club(each, name)), name)
        groups.setdefault(known[name], []).append(place)
    values = shots.deliveries | shots.launches
    clubs = [(name, np.array(places), *_statistics(values, places)) for name, places in groups.items()]
    length = "carry" if any("carry" in each for _, _, each, _ in clubs) else "ball_speed"
    clubs.sort(key=lambda each: -each[2][length].median if length in each[2] else math.inf)
    shorter = [*(each[2] for each in clubs[1:]), {}]
    return [
        ClubSummary(player, name, whole[places], spreads,
                    tuple(each._replace(place=int(whole[places[each.place]])) for each in mishits),
                    _gap(spreads.get("carry"), after.get("carry")))
        for (name, places, spreads, mishits), after in zip(clubs, shorter, strict=True)
    ]  # fmt: skip


def _statistics(values: Mapping[str, Floats], places: list[int]) -> tuple[dict[str, Statistic], list[Mishit]]:
    chosen = {name: each[places] for name, each in values.items()}
    mishits = find_mishits(chosen)
    mask = is_mishit(mishits, len(places))
    spreads = {name: each for name in QUANTITIES if name in chosen and (each := statistic(chosen[name], mask))}
    return spreads, mishits


def _gap(longer: Statistic | None, shorter: Statistic | None) -> Gap | None:
    if longer is None or shorter is None:
        return None
    return Gap(longer.median - shorter.median, math.hypot(longer.error, shorter.error))


def session_result(shots: RecordedShots) -> Result:
    """Return counts, medians, spreads, mishits and gaps of each club, with the picture of the landings."""
    clubs = summarize_clubs(shots)
    return Result(
        "session-summary",
        f"{shots.source} ({shots.format})",
        tables=(
            _clubs_table(clubs),
            mishits_table(shots, clubs),
            session_table(shots),
            rejected_table(shots.rejected, shots.row_word),
        ),
        notes=(*shots.notes, *_remarks(clubs)),
        provenance=Provenance(inputs={"file": shots.source, "read as": shots.format}),
        draw=lambda: [session_picture(shots, clubs)],
    )


def _clubs_table(clubs: Sequence[ClubSummary]) -> Table:
    measured = [name for name in QUANTITIES if any(name in each.spreads for each in clubs)]
    several = any(each.player for each in clubs)
    whose = [each.player or "not named" for each in clubs]
    columns = [
        text("player", [each.player for each in clubs], printed=False),
        text("whose", whose, label="player", in_files=False) if several else None,
        text("club", [each.club for each in clubs], printed=False),
        text("named", [each.club or "without a name" for each in clubs], label="club", in_files=False),
        text("shots", [each.places.size for each in clubs]),
        text("mishits", [len(each.mishit_places) for each in clubs],
             printed=any(each.mishits for each in clubs)),
    ]  # fmt: skip
    for name in measured:
        spreads = [each.spreads.get(name) for each in clubs]

        def numbers(statistic: str, spreads: Sequence[Statistic | None] = spreads) -> list[float]:
            return [math.nan if each is None else getattr(each, statistic) for each in spreads]

        columns += [
            column(f"{name}_median", numbers("median"), name, label=quantity(name).label),
            column(f"{name}_spread", numbers("spread"), name, label="±"),
            column(name, numbers("mean"), printed=False),
            column(f"{name}_deviation", numbers("deviation"), name, printed=False),
            text(f"{name}_shots", [0 if each is None else each.measured for each in spreads], printed=False),
        ]
    if any(each.gap for each in clubs):
        gaps = [each.gap or Gap(math.nan, math.nan) for each in clubs]
        columns += [
            column("gap", [each.length for each in gaps], "carry", label="gap"),
            column("gap_error", [each.error for each in gaps], "carry", printed=False),
        ]
    return table("clubs", *columns)


def mishits_table(shots: RecordedShots, clubs: Sequence[ClubSummary]) -> Table:
    """Return the table of mishits: line in the file, quantity that is far off, and its median."""
    rows = [(club, each) for club in clubs for each in club.mishits]
    off = [quantity(each.quantity) for _, each in rows]
    return table(
        "mishits",
        text("line", [int(shots.rows[each.place]) for _, each in rows], label=shots.row_word),
        None if shots.files is None else text("file", [str(shots.files[each.place]) for _, each in rows]),
        text("player", [club.player for club, _ in rows], printed=any(club.player for club, _ in rows)),
        text("club", [club.club for club, _ in rows], printed=any(club.club for club, _ in rows)),
        *row_names("quantity", [each.quantity for _, each in rows], [each.label for each in off]),
        Column("value", [each.value for _, each in rows], off),
        Column("median", [each.median for _, each in rows], off),
        title="Mishits, excluded from medians, spreads and gaps",
    )  # fmt: skip


def _remarks(clubs: Sequence[ClubSummary]) -> Iterator[Note]:
    yield note("session-median" if any(each.mishits for each in clubs) else "session-median-of-all")
    for name in dict.fromkeys(name for each in clubs for name in each.spreads):
        counts = [(each, each.spreads[name].measured) for each in clubs if name in each.spreads]
        if few := [f"{count} of {each.places.size} of {each.title}" for each, count in counts
                   if count < each.places.size]:  # fmt: skip
            yield note("session-partly-measured", quantity=name.replace("_", " "), counts=few)
    for longer, shorter in pairwise(clubs):
        if longer.gap is not None and not longer.gap.length > CLEAR_GAP * longer.gap.error:
            data = {"longer": longer.title, "shorter": shorter.title, "gap_carry": longer.gap.length}
            if math.isnan(longer.gap.error):
                yield note("session-gap-of-a-single-shot", **data)
            else:
                yield note("session-gap-not-sure", **data, error_carry=longer.gap.error)


def session_picture(shots: RecordedShots, clubs: Sequence[ClubSummary]) -> Picture:
    """Return the picture of a session: landings with one-standard-deviation ellipses, carries and gaps.

    Mishits are grey crosses and excluded from ellipses, carries and gaps. Without carry, an ``InputError`` is raised.
    """
    drawn = [each for each in clubs if "carry" in each.spreads]
    if not drawn:
        raise InputError("picture", Wording("impossible"), "leave it out: the file has no carry")
    landings: list[Mark] = [Mark("rule", x=0.0, style=-1)]
    carries: list[Mark] = []
    for place, each in enumerate(drawn):
        if "side" in each.spreads:
            landings += _landings(shots, each, place)
        carry = each.spreads["carry"]
        spread = 0.0 if carry.shots < 2 else carry.spread
        label = f"{from_si(carry.median, 'yd'):.0f}"
        label += f"\ngap {from_si(each.gap.length, 'yd'):.0f}" if each.gap else ""
        at: dict[str, Any] = {"x": [place], "y": [carry.median], "style": place, "symbol": str(place), "size": 5.0}
        carries.append(Mark("intervals", y0=[carry.median - spread], y1=[carry.median + spread], **at))
        carries.append(Mark("points", texts=[label], **at))
        if each.mishits:
            far = shots.launches["carry"][each.mishit_places]
            carries.append(Mark("points", x=[place] * len(far), y=far, style=-1, symbol="x", size=4.0, label=MISHIT))
    names = [f"{each.player}: {each.club or 'without a name'}" if each.player else each.club or "without a name"
             for each in drawn]  # fmt: skip
    ends = [shots.launches["carry"][each.places] for each in drawn]
    low, high = (float(each(np.concatenate(ends))) for each in (np.nanmin, np.nanmax))
    carry_axis = axis("carry", limits=(low - 0.1 * (high - low + 1.0), high + 0.12 * (high - low + 1.0)))
    club_axis = Axis(names=names, limits=(-0.5, len(names) - 0.5))
    panels = [Panel(carries, club_axis, carry_axis, "median carry, spread, and gap to the next club")]
    if len(landings) > 1:
        panels.insert(0, Panel(landings, axis("side", "side, to the right"), carry_axis,
                               "landings, with one-standard-deviation ellipses"))  # fmt: skip
    footnote = "grey crosses: mishits, not counted" if any(each.mishits for each in drawn) else ""
    return Picture("session", "Landings and carry by club", [panels], height=4.4,
                   share_y=True, footnote=footnote)  # fmt: skip


def _landings(shots: RecordedShots, club: ClubSummary, place: int) -> Iterator[Mark]:
    """Yield the landings of a club and, if there are enough, their ellipse."""
    off = np.isin(club.places, club.mishit_places)
    every = np.array([shots.launches[name][club.places] for name in ("side", "carry")])
    known = np.isfinite(every).all(axis=0)
    points, far = every[:, known & ~off], every[:, known & off]
    yield Mark(
        "points", x=points[0], y=points[1], label=club.title, style=place, symbol=str(place), size=3.0, faint=True
    )
    if far.size:
        yield Mark("points", x=far[0], y=far[1], label=MISHIT, style=-1, symbol="x", size=4.0)
    if points.shape[1] >= FEWEST:
        x, y = ellipse_about(points, 1.0)
        yield Mark("outline", x=x, y=y, style=place, dash=0, size=1.2)
