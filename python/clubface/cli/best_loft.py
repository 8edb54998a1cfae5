"""``clubface best-loft``: the dynamic loft of the longest carry, and the charts that fitters use."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from typing import Any

import typer

from clubface.cli import options, show
from clubface.cli.output import progress_bar
from clubface.errors import ClubfaceError
from clubface.support.checks import check_choice

app = typer.Typer(add_completion=False)

_OBJECTIVE = "What counts, with --golfer or --loft: carry (default), total, side_spread or strokes."
SEARCH = options.group(
    None,
    club=(options.Text, None, "CLUB", "Name or TOML file; default: golfer's, or driver."),
    speed=(options.Texts, None, '"100 mph"', "Club speed; several: comma-separated or repeated."),
    attack=(options.Texts, None, '"0 deg"', "Attack angle; default -5, 0 and 5 deg."),
    golfer=(options.Text, None, "NAME|FILE", "Advise this golfer, over all shots and objectives."),
    loft=(options.Text, None, '"15.5 deg"', "Advise on this dynamic loft, at a single speed."),
    objective=(options.Text, None, "NAME", _OBJECTIVE),
    hole=(options.Text, None, '"430 yd"', "Length of the hole, to count strokes."),
    chart=(options.Text, None, "NAME", "Use the speeds and attack angles of a chart: trackman or ping."),
)


@app.command("best-loft")
@options.takes(
    SEARCH, options.EQUIPMENT, options.ONE_MODEL, options.AIR, options.GROUND, options.WORTH, show.UNITS, show.TABLE,
    show.plot_option("best lofts and carries, those of a chart, or what loft is worth"), show.REPORT, show.JSON,
)  # fmt: skip
def best_loft(**texts: Any) -> None:
    """Find the best dynamic loft: for a golfer, by club speed, or compared with a published chart."""
    from clubface.design.best_loft import CHARTS, best_loft as find_best_loft, compare_with_chart
    from clubface.design.golfer import club_of, golfer as golfer_named
    from clubface.design.loft_fit import fit_loft, steady_golfer
    from clubface.design.strokes import Hole

    club, speed, attack, golfer, loft, objective, hole, chart = (texts[name] for name in SEARCH)
    output = show.Output.check(texts, (club, golfer))
    player = None if golfer is None else golfer_named(golfer)
    own = None if player is None or club is not None else "right" if player.hand > 0 else "left"
    club = club if club is not None else "driver" if player is None else club_of(player)
    worth = options.pairs(texts["worth"] or (), "--worth")
    setup = options.setup(club, texts | {"hand": texts["hand"] or own}) | options.conditions(texts)
    compared = {"--objective": objective, "--hole": hole}
    if player is not None or loft is not None:
        if player is not None:
            _refuse(
                {"--speed": speed, "--attack": attack, "--loft": loft, "--chart": chart}, "the golfer has these already"
            )
        else:
            _refuse({"--chart": chart}, "--loft means a single delivery")
            player = steady_golfer(club, **{
                name: options.parsed(f"--{name}", text, dimension)
                for name, text, dimension in (
                    ("speed", _one("--speed", speed, "91 mph"), "speed"),
                    ("attack", _one("--attack", attack, "-1 deg"), "angle"), ("loft", loft, "angle"),
                )
                if text is not None
            })  # fmt: skip
        setup.pop("accuracy")
        played = None if hole is None else Hole(length=options.parsed("--hole", hole, "length"))
        with progress_bar(lambda done, whole, step: step) as update:
            result = fit_loft(
                player, **setup, objective=objective or "carry", worth=worth, hole=played, progress=update
            ).to_result()
        output.show(result)
        return
    _refuse(compared, "give --golfer, or --loft with --speed and --attack, to compare with")
    setup["worth"] = worth
    if chart is not None:
        check_choice("--chart", chart, CHARTS)
        if speed is not None or attack is not None:
            raise ClubfaceError("--chart has its own speeds and attack angles; leave out --speed and --attack")
        with progress_bar("shots") as update:
            result = compare_with_chart(chart, **setup, progress=update).to_result()
    elif speed is None:
        raise ClubfaceError('--speed is missing; give it, as in --speed "100 mph", or a chart, as in --chart trackman')
    else:
        attack = ["-5 deg,0 deg,5 deg"] if attack is None else attack
        speeds = [options.parsed("--speed", text, "speed") for text in options.names(speed) or [""]]
        attacks = [options.parsed("--attack", text, "angle") for text in options.names(attack) or [""]]
        cases = zip(*product(speeds, attacks), strict=True)
        with progress_bar("shots") as update:
            result = find_best_loft(*map(list, cases), **setup, progress=update).to_result()
    output.show(result)


def _refuse(given: Mapping[str, Any], reason: str) -> None:
    """Raise ClubfaceError for options that have no effect."""
    for option, value in given.items():
        if value is not None:
            raise ClubfaceError(f"{option} has no effect here: {reason}")


def _one(option: str, texts: list[str] | None, example: str) -> str:
    """Return the only value of an option that may have several."""
    values = options.names(texts)
    if len(values) != 1:
        raise ClubfaceError(f'{option} must be given once with --loft, as in {option} "{example}"')
    return values[0]
