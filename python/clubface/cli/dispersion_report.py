"""The report of ``clubface dispersion``: where the shots go, in words, beside what the command prints."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from clubface.cli import reporting
from clubface.cli.golfer_report import golfer_sources
from clubface.cli.quantity_units import VALUES
from clubface.units import from_si

if TYPE_CHECKING:
    from clubface.design.dispersion.hitting import Hitting
    from clubface.design.dispersion.indices import Indices
    from clubface.design.dispersion.sampling import Dispersion


def write(
    target: str,
    of: Dispersion,
    shares: Indices | None,
    hit: Hitting,
    conditions: Mapping[str, Any],
    show: Callable[[], None],
) -> None:
    """Write the report; ``conditions`` are air, wind and ground, ``show`` prints the tables."""
    from clubface.design.dispersion.figure import dispersion_figure

    drawn = None
    columns: dict[str, Any] = {}
    if of.points.size:
        drawn = ("Where the balls land, and what spreads them", dispersion_figure(of, shares))
        columns = {"ahead (yd)": from_si(of.points[:, 0], "yd"), "right (yd)": from_si(of.points[:, 1], "yd")}
    golfer = of.golfer
    hole = {} if of.hole is None else {"hole": of.hole.told()}
    told = {"golfer": golfer.title or golfer.name, "shots": str(of.count), "seed": str(of.seed)}
    with_ = "" if told["golfer"].endswith(of.club.name) else f" with {of.club.name}"
    reporting.write(
        target, title=f"{told['golfer']}: where the shots go{with_}", words=_words(of, shares),
        picture=drawn, columns=columns, show=show, launches=[hit.mean(golfer)[0]],
        given=told | hole, conditions=conditions, sources=golfer_sources(golfer),
    )  # fmt: skip


def _words(of: Dispersion, shares: Indices | None) -> Iterator[str]:
    """Say where shots go, and what spreads them most, in sentences."""

    def told(name: str, share: float) -> str:
        return f"{from_si(of.quantile(name, share), VALUES[name][0]):.0f}"

    yield f"Half of {of.count} shots leave at {told('ball_speed', 0.25)} to {told('ball_speed', 0.75)} mph."
    if not of.points.size:
        return
    yield (
        f"Half of them carry {told('carry', 0.25)} to {told('carry', 0.75)} yd, and nine of ten at least "
        f"{told('carry', 0.1)} yd."
    )
    left, right = (from_si(of.quantile("side", share), "yd") for share in (0.05, 0.95))
    places = [reporting.more_or_less(each, "yd", ("right", "left"), 0) for each in (left, right)]
    yield f"Nine of ten land between {' and '.join(places)} of the line."
    if shares is not None:
        from clubface.design.golfer.golfer import told as name_of

        words = {"carry": "How far the ball goes", "side": "How far it is off the line"}
        for name, parts in shares.share.items():
            most = max(range(len(parts)), key=lambda place, parts=parts: float(parts[place]))
            if name in words:
                yield (
                    f"{words[name]} depends most on the {name_of(shares.variables[most])}, which makes"
                    f" {float(parts[most]):.0%} of the differences (of the variance)."
                )
    if of.hole is not None:
        yield f"On the hole given, the shot leaves {of.strokes:.2f} strokes to play, as tour players count."
