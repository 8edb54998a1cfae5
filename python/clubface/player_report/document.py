"""The report of a player's shots: its pieces, club by club, and the file."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

from clubface.errors import InputError
from clubface.player_report import words
from clubface.player_report.figures_of_club import ClubFigures, figures_of
from clubface.player_report.progress import progress
from clubface.recorded.loft_origin import AT_LAUNCH, loft_origins, origin_notes
from clubface.recorded.shots import RecordedShots
from clubface.reports.blocks import Block, Bullets, Data, Heading, Paragraph, Picture
from clubface.reports.conditions import flight_conditions
from clubface.reports.document import check_ending, file_name, write_document
from clubface.reports.origin import origin

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
    yield Paragraph((f"This report is about {words.counted(len(shots))}{whose} of {sources}: {', '.join(names)}.",))
    if len(clubs) > MOST_PICTURES:
        advice = "a report on some of the players draws them all (--where)"
        yield Paragraph((f"Pictures are drawn for the first {MOST_PICTURES} of {len(clubs)} clubs; {advice}.",))
    for place, each in enumerate(clubs):
        yield Heading(2, each.title[:1].upper() + each.title[1:])
        yield Paragraph(tuple(words.measured(each)))
        if place < MOST_PICTURES:
            yield _picture(each)
        for title, texts in (
            ("Where the ball starts, and why", tuple(words.line(each))),
            ("Where you strike it", tuple(words.strike(each))),
        ):
            if texts:
                yield Heading(3, title)
                yield Paragraph(texts)
        if changes := tuple(words.what_if(each)):
            yield Heading(3, "What would change your average shot")
            yield Paragraph(("Each of these alone, with all else as it is:",))
            yield Bullets(changes)
        yield from progress(each)
        if doubts := tuple(words.doubt(each)):
            yield Heading(3, "How sure we are")
            yield Paragraph(doubts)
    if notes := [*origin_notes(loft_origins(shots), AT_LAUNCH), *dict.fromkeys(shots.notes)]:
        yield Heading(2, "Notes on the file")
        yield Bullets(tuple(f"{note[:1].upper()}{note[1:]}." for note in notes))
    hands = "" if shots.hand is None else " and ".join(sorted(set(map(str, shots.hand))))
    given = {"file": sources, "read as": shots.format, "shots": str(len(shots)),
             "rows that gave no shot": str(len(shots.rejected)), "hand": hands or "not told"}  # fmt: skip
    yield from origin([each.launch for each in clubs if each.launch is not None], given=given | flight_conditions())


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
    return [
        replace(figures_of(theirs, name or CLUBLESS, len(groups)), player=player) for player, name, theirs in groups
    ]


def _only_player(shots: RecordedShots) -> str:
    """Return the player whose shots all are, "" where the file does not say."""
    named = set() if shots.players is None else set(map(str, shots.players))
    return named.pop() if len(named) == 1 else ""


def _picture(of: ClubFigures) -> Picture:
    from clubface.player_report.picture import club_picture
    from clubface.plots.style import svg

    shows = f"{of.title}: where the shots go, and face, path and start line"
    return Picture(shows, svg(club_picture(of)), _data(of))


def _data(of: ClubFigures) -> Data:
    columns = of.shots.columns()
    return Data(file_name(of.title), list(columns), list(zip(*columns.values(), strict=True)))
