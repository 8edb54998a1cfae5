"""``clubface best-loft``: the dynamic loft of the longest carry, and the charts that fitters use."""

from __future__ import annotations

from itertools import product
from typing import Annotated, Any

import typer

from clubface.cli import options, show
from clubface.cli.output import progress_bar
from clubface.errors import ClubfaceError
from clubface.support.checks import check_choice

app = typer.Typer(add_completion=False)


@app.command("best-loft")
@options.takes(
    options.EQUIPMENT, options.ONE_MODEL, options.AIR, show.UNITS, show.TABLE,
    show.plot_option("best lofts and carries, or those found over those of the chart"), show.REPORT, show.JSON,
)  # fmt: skip
def best_loft(
    club: Annotated[
        str, typer.Option("--club", metavar="CLUB", help="Name or TOML file; driver unless given.", show_default=False)
    ] = "driver",
    speed: Annotated[
        list[str] | None,
        options.option("--speed", metavar='"100 mph"', text="Club speed; several with commas or repeated."),
    ] = None,
    attack: Annotated[
        list[str] | None,
        options.option("--attack", metavar='"0 deg"', text="Attack angle; -5, 0 and 5 deg unless given."),
    ] = None,
    chart: Annotated[
        str | None,
        options.option("--chart", metavar="NAME", text="Take speeds and attack angles of a chart: trackman or ping."),
    ] = None,
    **texts: Any,
) -> None:
    """Find the dynamic loft of the longest carry; by club speed, or compared with a published chart."""
    from clubface.design.best_loft import CHARTS, best_loft as find_best_loft, compare_with_chart

    output = show.Output.check(texts, (club,))
    head = options.club_of(club, texts["hand"], texts.get("model"))
    setup = {
        "club": head, "model": texts["model"], "parameters": options.one_set(head, texts), "ball": texts["ball"],
        "accuracy": texts["accuracy"], **options.conditions(texts),
    }  # fmt: skip
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
