"""``clubface clubs``: the built-in clubs and balls, or one of them in full."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, show

app = typer.Typer(add_completion=False)


@app.command()
@options.takes(show.REPORT, show.JSON)
def clubs(
    name: Annotated[str | None, options.argument("[NAME|FILE]", "Show this club in full.")] = None, **texts: Any
) -> None:
    """List the built-in clubs by kind, and the balls, or show one club with the source of every value."""
    from clubface.equipment.clubs import club
    from clubface.equipment.listings import club_result, clubs_result

    output = show.Output.check(texts, [name])
    output.show(clubs_result() if name is None else club_result(club(name)))
