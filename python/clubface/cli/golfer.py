"""``clubface golfer``: golfers as distributions of deliveries, built in or estimated from a monitor's file."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Any

import typer

from clubface.cli import options, output, show
from clubface.cli.failures import print_note
from clubface.cli.recorded import RECORDED, Files, recorded_shots

app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Golfers: how their deliveries vary from shot to shot."
)
GolferArgument = Annotated[str, options.argument("GOLFER", "Name of a built-in golfer, or a TOML file.")]


@app.command("list")
@options.takes(show.JSON)
def list_golfers(**texts: Any) -> None:
    """List the built-in golfers."""
    from clubface.design.golfer import golfer, golfers
    from clubface.design.golfer_result import golfers_result

    show.Output.check(texts).show(golfers_result([golfer(name) for name in golfers()]))


@app.command("show")
@options.takes(show.table_option("Write a TOML file to start your own golfer from."), show.REPORT, show.JSON)
def show_golfer(golfer: GolferArgument, **texts: Any) -> None:
    """Show a golfer's means, spreads and correlations, and the source of each figure."""
    from clubface.design.golfer import golfer as golfer_named, to_toml
    from clubface.design.golfer_estimate import doubts
    from clubface.design.golfer_result import golfer_result
    from clubface.equipment.clubs import CLUB_NAMES, club

    target = texts.pop("target")
    shown = show.Output.check(texts, (golfer,))
    player = golfer_named(golfer)
    if target is not None:
        output.write_template(to_toml(player), target, f"use it as in: clubface dispersion {target}")
        if not shown.as_json and shown.report is None:
            return
    head = club(player.club).replace(hand=player.hand) if player.club in CLUB_NAMES else None
    known = None if head is None or shown.report is None else doubts(player, head)
    shown.show(golfer_result(player, head, doubts=known))


ESTIMATED = options.group(None,
    name=(str, "my golfer", "NAME", "Name of the golfer."),
    like=(str | None, None, "GOLFER",
          "Golfer that supplies what was not measured; default: the built-in one nearest in speed."),
)  # fmt: skip


@app.command("estimate")
@options.takes(
    {name: each for name, each in RECORDED.items() if name != "ball"}, ESTIMATED,  # no ball is involved
    show.table_option("Write the golfer to this TOML file."), show.REPORT, show.JSON,
)  # fmt: skip
def estimate(files: Files, **texts: Any) -> None:
    """Estimate a golfer from shots in the order in which they were hit."""
    from clubface.design.golfer import to_toml
    from clubface.design.golfer_estimate import doubts, estimate_golfer
    from clubface.design.golfer_result import golfer_result
    from clubface.equipment.clubs import CLUB_NAMES
    from clubface.support.files import write_text

    shown = show.Output.check(texts, [*files, texts["mapping"], texts["club"], texts["like"]], (".toml",))
    shots = recorded_shots(files, texts)
    estimated = estimate_golfer(shots, name=texts["name"], like=texts["like"])
    if shown.target is not None:
        write_text(shown.target, to_toml(estimated.golfer))
        own = "" if estimated.golfer.club in CLUB_NAMES else f" --club {texts['club']}"
        print_note(f"wrote {shown.target}; use it as in: clubface dispersion {shown.target}{own}")
    known = None if shown.report is None else doubts(estimated.golfer, shots.club)
    result = golfer_result(estimated.golfer, shots.club, estimated, known)
    replace(shown, target=None).show(result)
