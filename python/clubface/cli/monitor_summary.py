"""``clubface monitor summary``: what a session says of each club, as a table and a picture."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING, Annotated, Any

from clubface.cli import options, output
from clubface.cli.failures import say
from clubface.cli.recorded import READING, Files, read_shots
from clubface.cli.tables import print_numbers
from clubface.units import from_si, size

if TYPE_CHECKING:
    from clubface.launch_monitor.summary import ClubSummary

SURE = 2.0
"""Standard errors that a gap must have to be one."""
DIGITS = {"1": 2, "rpm": 0}
Hand = Annotated[str | None, options.option("--hand", metavar="right|left", text="Hand of the player.")]


@options.takes(READING)
def summary(
    files: Files,
    hand: Hand = None,
    picture: Annotated[str | None, options.picture("where each club lands and the gaps between clubs")] = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Sum up the shots of each club: counts, means, spreads, and the gaps in carry."""
    output.check_picture(picture, [*files, texts["mapping"]])
    from clubface.launch_monitor.summary import QUANTITIES, summarised

    shots = read_shots(files, texts | {"hand": hand}, where=True)
    clubs = summarised(shots)
    measured = [name for name in QUANTITIES if any(name in each.spreads for each in clubs)]
    if picture is not None:
        from clubface import plots
        from clubface.launch_monitor.figures import session_figure

        say(f"wrote {plots.save(session_figure(shots, clubs), picture)}")
    if as_json:
        output.print_json(
            {
                "source": shots.source,
                "shots": len(shots),
                "clubs": [_document(each) for each in clubs],
                "rejected": [each._asdict() for each in shots.rejected],
                "notes": shots.notes,
            }
        )
        return
    several = any(each.player for each in clubs)
    heads = [*(["player"] if several else []), "club", "shots"]
    for name in measured:
        heads += [f"{name.replace('_', ' ')}\n{'' if QUANTITIES[name] == '1' else QUANTITIES[name]}", "\n±"]
    gaps = any(each.gap for each in clubs)
    rows = [_row(each, measured, gaps, several) for each in clubs]
    print_numbers([*heads, "gap\nyd"] if gaps else heads, rows, title=f"{shots.source} ({shots.format})")
    output.print_rejected(shots.rejected, "rejected", "--json lists all")
    output.print_notes([*shots.notes, *_remarks(clubs)])


def _row(of: ClubSummary, measured: list[str], gaps: bool, several: bool) -> list[str]:
    from clubface.launch_monitor.summary import QUANTITIES

    cells = [*([of.player or "not named"] if several else []), of.club or "without a name", str(of.places.size)]
    for name in measured:
        unit, spread = QUANTITIES[name], of.spreads.get(name)
        digits = DIGITS.get(unit, 1)
        cells.append(output.number(from_si(spread.mean, unit) if spread else None, digits))
        cells.append(output.number(spread.deviation / size(unit) if spread else None, digits))
    return [*cells, output.number(from_si(of.gap.length, "yd") if of.gap else None)] if gaps else cells


def _remarks(clubs: list[ClubSummary]) -> list[str]:
    found = ["± is the standard deviation from shot to shot"]
    for name in dict.fromkeys(name for each in clubs for name in each.spreads):
        some = {(each.player, each.club): each.spreads[name].shots for each in clubs if name in each.spreads}
        few = [
            f"{some[each.player, each.club]} of {each.places.size} of {_called(each)}"
            for each in clubs
            if 0 < some.get((each.player, each.club), 0) < each.places.size
        ]
        if few:
            found.append(f"{name.replace('_', ' ')} was not measured in every shot: {', '.join(few)}")
    for longer, shorter in pairwise(clubs):
        if longer.gap is not None and not longer.gap.length > SURE * longer.gap.error:
            error = output.number(from_si(longer.gap.error, "yd"))
            told = f"a standard error of {error} yd" if error else "a single shot, so that its error is not known"
            found.append(
                f"the gap between {_called(longer)} and {_called(shorter)} is not sure: "
                f"{from_si(longer.gap.length, 'yd'):.1f} yd with {told}"
            )
    return found


def _called(of: ClubSummary) -> str:
    club = of.club or "the shots"
    return f"{of.player}'s {club}" if of.player else club


def _document(of: ClubSummary) -> dict[str, Any]:
    return {
        "player": of.player,
        "club": of.club,
        "shots": of.places.size,
        "quantities": {name: each._asdict() for name, each in of.spreads.items()},
        "gap": of.gap._asdict() if of.gap else None,
    }
