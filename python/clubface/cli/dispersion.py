"""``clubface dispersion``: where a golfer's shots go, by sampling and by derivatives, and what spreads them.

What ``clubface dispersion`` found as JSON has it.

The report of ``clubface dispersion``: where the shots go, in words, beside what the command prints.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say
from clubface.cli.golfer import GolferArgument, golfer_sources
from clubface.cli.output import VALUES, print_numbers, progress_bar
from clubface.equipment.models import models
from clubface.errors import ClubfaceError, InputError
from clubface.support.version import __version__
from clubface.units import from_si, size

if TYPE_CHECKING:
    from clubface.design.dispersion import Dispersion, Hitting
    from clubface.design.golfer import Golfer
    from clubface.design.strokes import Hole
    from clubface.design.variance import ByDerivatives, Indices


QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95)
"""The shares of the shots whose quantiles are told."""


def document(of: Dispersion, slopes: ByDerivatives | None, shares: Indices | None) -> dict[str, Any]:
    """Return a dispersion with its spread by derivatives and its shares of the variance, as JSON has them [SI]."""
    from dataclasses import asdict

    from clubface.design.dispersion import SHARES

    found: dict[str, Any] = {
        "golfer": of.golfer.name, "club": of.club.name, "ball": of.ball.name, "model": of.model, "shots": of.count,
        "lost": of.lost, "reasons": dict(of.reasons), "seed": of.seed, "clubface_version": __version__,
        "quantities": {
            name: {
                "mean": of.mean(name), "spread": of.spread(name), "of_mean_delivery": of.mean_shot[name],
                "quantiles": {f"{share:g}": of.quantile(name, share) for share in QUANTILES},
            }
            for name in of.quantities
        },
    }  # fmt: skip
    if of.points.size:
        found["ellipses"] = [
            {
                "share": each.share,
                "centre": each.centre.tolist(),
                "half_axes": each.half_axes.tolist(),
                "angle": each.angle,
            }
            for each in map(of.ellipse, SHARES)
        ]
    if slopes is not None:
        found["by_derivatives"] = {
            name: {
                "mean": slopes.mean(name),
                "spread": slopes.spread(name),
                "spread_first_order": slopes.spread(name, order=1),
            }
            for name in slopes.value
        }
    if of.hole is not None:
        found["hole"] = {
            **asdict(of.hole),
            "before": of.hole.before(),
            "after": of.strokes,
            "gained": of.gained,
            "lies": dict(of.lies),
        }
    if shares is not None:
        found["shares"] = {
            "kind": shares.kind, "variables": shares.variables,
            "share": {name: each.tolist() for name, each in shares.share.items()},
            "total": {name: each.tolist() for name, each in shares.total.items()},
        }  # fmt: skip
    return found


def write(
    target: str,
    of: Dispersion,
    shares: Indices | None,
    hit: Hitting,
    conditions: Mapping[str, Any],
    show: Callable[[], None],
) -> None:
    """Write the report; ``conditions`` are air, wind and ground, ``show`` prints the tables."""
    from clubface.design.pictures import dispersion_figure

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
        from clubface.design.golfer import told as name_of

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


app = typer.Typer(add_completion=False)

LOFT_THAT_COUNTS = 0.05
"""Degrees of static loft from which a club is said to be delivered with the dynamic loft of another."""
_HOLE = "Hole"
_CLUB = options.option(
    "--club", panel="Club and ball", metavar="CLUB", text="Name or TOML file; the golfer's unless given."
)


@app.command()
@options.takes(options.EQUIPMENT, options.ONE_MODEL, options.AIR, options.GROUND)
def dispersion(
    golfer: GolferArgument,
    club: Annotated[str | None, _CLUB] = None,
    count: Annotated[
        int | None, typer.Option("--count", metavar="N", help="Number of shots; 16384 unless given.")
    ] = None,
    seed: options.Seed = 0,
    no_flight: Annotated[bool, typer.Option("--no-flight", help="Count launches alone; no ball flies.")] = False,
    hole: Annotated[
        str | None,
        options.option(
            "--hole", panel=_HOLE, metavar='"430 yd"', text="Length of a hole on which strokes are counted."
        ),
    ] = None,
    fairway: Annotated[
        str | None, options.option("--fairway", panel=_HOLE, metavar='"32 yd"', text="Width of its fairway.")
    ] = None,
    rough: Annotated[
        str | None,
        options.option(
            "--rough", panel=_HOLE, metavar='"20 yd"', text="Width of its rough on either side; beyond it are trees."
        ),
    ] = None,
    lie: Annotated[
        str | None,
        options.option("--lie", panel=_HOLE, metavar="NAME", text="Where the shot is played from; tee unless given."),
    ] = None,
    no_shares: Annotated[bool, typer.Option("--no-shares", help="Leave out what spreads the shots.")] = False,
    target: Annotated[str | None, options.output("FILE", "Write every shot to this file, CSV or Parquet.")] = None,
    picture: Annotated[str | None, options.picture("where the balls land and what spreads them")] = None,
    report: options.Report = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Hit many shots of a golfer and sum up where they go."""
    from clubface.design.dispersion import COUNT, Hitting, dispersion as compute
    from clubface.design.golfer import club_of, golfer as golfer_named
    from clubface.shots.tables.writer import KINDS

    output.check_target("--output", target, KINDS)
    output.check_picture(picture)
    output.check_report(report)
    for name, value in {"hole": hole, **{name: texts[name] for name in options.AIR}}.items():
        if no_flight and value is not None:
            raise ClubfaceError(f"--{name} has no effect with --no-flight; leave out one of them")
    player = golfer_named(golfer)
    own = None if club is not None else "right" if player.hand > 0 else "left"
    head = options.club_of(
        club_of(player) if club is None else club,
        own if texts["hand"] is None else texts["hand"],
        texts["model"],
    )
    _check(player, head, texts["model"], count)
    conditions = options.conditions(texts)
    hitting = {
        "model": texts["model"], "parameters": options.one_set(head, texts), "ball": texts["ball"],
        "flight": not no_flight, "accuracy": texts["accuracy"], **conditions,
    }  # fmt: skip
    played = _hole(hole, fairway, rough, lie)
    with progress_bar("shots") as progress, _file(target, seed) as each:
        found = compute(
            player, head, count=COUNT if count is None else count, seed=seed, hole=played, each=each, progress=progress,
            **hitting,
        )  # fmt: skip
    if target is not None:
        say(f"wrote {target}")
    hit = Hitting(head, **hitting)
    slopes, shares = _by_derivatives(found, hit), None
    if not (no_shares or no_flight) and found.golfer.spread.any():
        from clubface.design.variance import indices

        with progress_bar("orders of what varies") as progress:
            shares = indices(found.golfer, hit, seed=seed, progress=progress)
    if picture is not None:
        from clubface import plots
        from clubface.design.pictures import dispersion_figure

        say(f"wrote {plots.save(dispersion_figure(found, shares), picture)}")
    if report is not None:
        write(report, found, shares, hit, conditions, lambda: _print(found, slopes, shares))
        say(f"wrote {report}")
    if as_json:
        output.print_json(document(found, slopes, shares))
    else:
        _print(found, slopes, shares)


def _check(player: Golfer, head: Any, model: str, count: int | None) -> None:
    """Ask for a number of shots where they take long, and say so where golfer and club do not go together."""
    from clubface.equipment.clubs import CLUB_NAMES, club

    if count is None and model not in models():
        raise ClubfaceError(f"--count is missing; give it, as in --count 64: each shot by {model} takes long")
    if player.club not in CLUB_NAMES:
        return
    usual = club(player.club)
    more = from_si(head.loft - usual.loft, "deg")
    if usual.parameters != head.parameters:
        say(f"note: the deliveries of {player.name} are those with a {player.club}, not with {head.name}")
    elif "loft" in player.variables and abs(more) >= LOFT_THAT_COUNTS:
        say(
            f"note: {head.name} has {abs(more):.1f} deg {'more' if more > 0.0 else 'less'} loft than {player.club}, and"
            f" {player.name} hits it with the dynamic loft of {player.club}; clubface optimise with [fit] delivers a"
            " club of more loft with more"
        )


def _file(target: str | None, seed: int) -> Any:
    """Open the file of every shot, if one is wanted."""
    if target is None:
        from contextlib import nullcontext

        return nullcontext()
    from clubface.design.dispersion import shots_file

    return shots_file(target, seed=seed)


def _hole(length: str | None, fairway: str | None, rough: str | None, lie: str | None) -> Hole | None:
    given_too = {"--fairway": fairway, "--rough": rough, "--lie": lie}
    if length is None:
        for option, value in given_too.items():
            if value is not None:
                raise ClubfaceError(f'{option} is of a hole; give its length as well, as in --hole "430 yd"')
        return None
    from clubface.design.strokes import Hole

    told = {"fairway": fairway, "rough": rough}
    lengths = {name: options.parsed(f"--{name}", text, "length") for name, text in told.items() if text is not None}
    try:
        return Hole(
            length=options.parsed("--hole", length, "length"), **lengths, **({} if lie is None else {"lie": lie})
        )
    except InputError as error:
        error.parameter = "--hole" if error.parameter == "length" else error.parameter
        raise


def _by_derivatives(of: Dispersion, hit: Any) -> ByDerivatives | None:
    """Return the spread by derivatives, or None for a model that has none."""
    if of.model not in models():
        return None
    from clubface.design.variance import by_derivatives

    return by_derivatives(of.golfer, hit)


def _print(of: Dispersion, slopes: ByDerivatives | None, shares: Indices | None) -> None:
    heads = ["", "unit", "mean", "±", *(f"{share:.0%}" for share in QUANTILES)]
    if slopes is not None:
        heads += ["by derivatives\nmean", "\n±"]
    rows = []
    for name in of.quantities:
        unit, digits = VALUES[name]
        values = [of.mean(name), of.spread(name), *(of.quantile(name, share) for share in QUANTILES)]
        row = [name.replace("_", " "), unit, *(output.number(from_si(each, unit), digits) for each in values)]
        if slopes is not None:
            known = name in slopes.value
            both = (slopes.mean(name) / size(unit), slopes.spread(name) / size(unit)) if known else (None, None)
            row += [output.number(each, digits) for each in both]
        rows.append(row)
    what = f"{output.counted(of.count, 'shot')}, club {of.club.name}, ball {of.ball.name}, by {of.model}"
    print_numbers(heads, rows, title=f"{of.golfer.title or of.golfer.name}: {what}")
    if of.points.size:
        print()
        _print_ellipses(of)
    if of.hole is not None:
        print()
        _print_strokes(of)
    if shares is not None:
        print()
        _print_shares(shares)
    print()
    output.print_notes(_notes(of, slopes, shares))


def _print_ellipses(of: Dispersion) -> None:
    from math import degrees

    from clubface.design.dispersion import SHARES

    rows = []
    for share in SHARES:
        found = of.ellipse(share)
        lengths = [*found.centre, *(2.0 * found.half_axes)]
        cells = [output.number(float(from_si(each, "yd")), 1) for each in lengths]
        rows.append([f"{share:.0%}", *cells, output.number(degrees(found.angle))])
    heads = ("landings", "centre\nahead, yd", "centre\nright, yd", "long\naxis, yd", "short\naxis, yd",
             "long axis to\nline, deg")  # fmt: skip
    print_numbers(heads, rows, title="Ellipses that hold a share of the landings")


def _print_strokes(of: Dispersion) -> None:
    assert of.hole is not None
    told = ", ".join(f"{100.0 * share:.0f} % {name}" for name, share in of.lies.items() if share > 0.0)
    before = of.hole.before()
    length = output.number(from_si(of.hole.length, "yd"), 0)
    output.print_paragraph(
        f"On a hole of {length} yd a tour player takes {before:.3f} strokes from the {of.hole.lie} and"
        f" {of.strokes:.3f} after a shot of this golfer: strokes gained {of.gained:+.3f}."
    )
    output.print_paragraph(f"At rest: {told}.")


def _print_shares(of: Indices) -> None:
    from clubface.design.golfer import told

    order = sorted(range(len(of.variables)), key=lambda place: -max(float(each[place]) for each in of.share.values()))
    sobol = of.kind == "sobol"
    heads = [""]
    for name in of.share:
        heads += [f"{name}\nalone", f"{name}\nin all"] if sobol else [f"{name}\n%"]
    rows = []
    for place in order:
        row = [told(of.variables[place])]
        for name in of.share:
            parts = [of.share[name][place], of.total[name][place]] if sobol else [of.share[name][place]]
            row += [output.number(100.0 * float(each), 1) for each in parts]
        rows.append(row)
    kind = "Sobol indices" if sobol else "Shapley effects"
    print_numbers(heads, rows, title=f"What spreads the shots: {kind}, % of the variance")


def _notes(of: Dispersion, slopes: ByDerivatives | None, shares: Indices | None) -> list[str]:
    found = ["± is the standard deviation; 5% of the shots stay below the value under 5%, and so on"]
    if of.lost:
        found.append(
            f"{of.lost} shots ({100.0 * of.lost / of.count:.2g} %) have no result and are left out, such as: "
            f"{'; '.join(of.reasons.values())}"
        )
    if slopes is not None:
        found.append("by derivatives: to the second order about the mean delivery")
    if of.hole is not None:
        found.append("strokes: averages of the PGA Tour by distance and lie (Broadie, 2011 and 2012)")
    if shares is not None and shares.kind == "shapley":
        found.append("the delivery's values are correlated, so that the variance is shared out by Shapley's rule")
    return found
