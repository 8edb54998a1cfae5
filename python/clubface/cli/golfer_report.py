"""The reports of ``clubface golfer``: how a golfer delivers the club, what is known of it, and what rests on that."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from clubface.cli import output, reporting
from clubface.cli.tables import print_numbers
from clubface.units import from_si

if TYPE_CHECKING:
    from clubface.design.golfer.doubt import Doubts
    from clubface.design.golfer.estimate import Estimate
    from clubface.design.golfer.golfer import Golfer
    from clubface.equipment.clubs import Club


def figures(of: Golfer) -> list[str]:
    """Return the names of all figures of a golfer, as :meth:`Golfer.source` takes them."""
    found = [f"{part} of {name}" for part in ("mean", "spread") for name in of.variables]
    correlated = int((of.correlation != 0.0).sum()) > len(of.variables)
    more = {"correlation": correlated, "mishits": of.mishit_share > 0.0}
    return [*found, *(name for name, has in more.items() if has)]


def golfer_sources(of: Golfer) -> list[str]:
    """Return where each figure of a golfer comes from, figures of one source together."""
    told: dict[str, list[str]] = {}
    for figure in figures(of):
        told.setdefault(of.source(figure), []).append(figure.replace("_", " "))
    return [f"Golfer {of.title or of.name}, {', '.join(names)}: {source}" for source, names in told.items()]


def write(
    target: str, of: Golfer, club: Club | None, show: Callable[[], None], estimated: Estimate | None = None
) -> None:
    """Write the report of a golfer with a club, None where his is unknown; ``show`` prints the tables."""
    from clubface.design.golfer.doubt import COUNT, doubts
    from clubface.design.golfer.file import to_toml

    given = {"golfer": of.title or of.name, "hand": "right" if of.hand > 0 else "left"}
    picture, columns, found, launches = None, {}, None, ()
    if club is not None:
        from clubface.simulation.impact import impact

        found = doubts(of, club)
        launches = (impact(club, of.for_hand(club.hand).delivery()),)
    if found is not None and found.figures:
        from clubface.design.golfer.figure import golfer_figure

        shows = f"How much the spread of the landings changes if a figure is {found.off:.0%} smaller or larger"
        picture, columns = (shows, golfer_figure(found)), _columns(found)
        given |= {"shots of each change": str(COUNT), "seed": "0"}

    def tables() -> None:
        show()
        if picture is not None and found is not None:
            print_numbers(*_table(found), title=f"If a figure is {found.off:.0%} smaller or larger")

    reporting.write(
        target, title=f"{of.title or of.name}: how the club is delivered", words=_words(of, found, estimated),
        picture=picture, columns=columns, show=tables, launches=launches, given=given,
        conditions=None if club is None else {}, sources=golfer_sources(of),
        files={f"{reporting.named(of.name)}.toml": to_toml(of)},
    )  # fmt: skip


def _words(of: Golfer, found: Doubts | None, estimated: Estimate | None) -> Iterator[str]:
    """Say how a golfer delivers, what is known of it and what rests on it, in sentences."""
    from clubface.design.golfer.doubt import is_assumed

    spread = dict(zip(of.variables, of.spread, strict=True))
    mean = dict(zip(of.variables, of.mean, strict=True))
    if estimated is not None:
        yield f"These figures come from {output.counted(estimated.shots, 'shot')}, in the order in which they were hit."
    told = [f"reaches the ball at {from_si(mean['speed'], 'mph'):.0f} mph"]
    if spread.get("speed"):
        told.append(f"two shots of three within {from_si(spread['speed'], 'mph'):.1f} mph of that")
    if spread.get("face"):
        told.append(f"with a face angle that differs by {from_si(spread['face'], 'deg'):.1f} degrees from shot to shot")
    yield f"The club {', '.join(told)}."
    if of.mishit_share > 0.0:
        yield f"{of.mishit_share:.0%} of the shots are mishits, {of.mishit_scale:.2g} times as far off in everything."
    spreads = [f"spread of {name}" for name in of.variables if spread[name] > 0.0]
    sourced = [each.removeprefix("spread of ").replace("_", " ") for each in spreads if not is_assumed(of, each)]
    if sourced:
        others = " For the rest it is assumed." if len(sourced) < len(spreads) else ""
        yield f"How much these differ from shot to shot was measured or published: {', '.join(sourced)}.{others}"
    else:
        yield (
            "How much the shots differ from each other has no source, and counts as assumed for every part of the"
            " delivery: take it as typical, not as measured."
        )
    if found is None or not found.figures:
        return
    for name, way in (("carry", "The carry"), ("side", "Where the ball lands to the sides")):
        most = max(found.figures, key=lambda each: each.spread[name][1] - found.spread[name])
        more = 100.0 * found.changes(most, name)[1]
        yield (
            f"{way} differs by {from_si(found.spread[name], 'yd'):.1f} yd from shot to shot (standard deviation). It "
            f"rests most on the {most.figure.replace('_', ' ')}{', which is assumed' * most.assumed}: if that "
            f"were {found.off:.0%} larger, the shots would differ by {more:.0f}% more."
        )


def _table(found: Doubts) -> tuple[list[str], list[list[str]]]:
    heads = ["", "is", *(f"{name} {how}\n%" for name in found.spread for how in ("smaller", "larger"))]
    rows = []
    for each in found.figures:
        changes = [100.0 * change for name in found.spread for change in found.changes(each, name)]
        rows.append([
            each.figure.replace("_", " "), "assumed" if each.assumed else "sourced",
            *(output.number(change, 1) for change in changes),
        ])  # fmt: skip
    return heads, rows


def _columns(found: Doubts) -> dict[str, list[Any]]:
    columns: dict[str, list[Any]] = {
        "figure": [each.figure for each in found.figures], "assumed": [each.assumed for each in found.figures]
    }  # fmt: skip
    for name, now in found.spread.items():
        for place, how in enumerate(("smaller", "larger")):
            values = [from_si(each.spread[name][place], "yd") for each in found.figures]
            columns[f"spread of {name}, figure {how} (yd)"] = [float(value) for value in values]
        columns[f"spread of {name} now (yd)"] = [float(from_si(now, "yd"))] * len(found.figures)
    return columns
