"""``clubface explain``: why a ball starts where it starts and curves as it curves."""

from __future__ import annotations

from typing import Any

import typer

from clubface.cli import options, show

app = typer.Typer(add_completion=False)


@app.command()
@options.takes(
    options.DELIVERY, options.EQUIPMENT, options.ONE_MODEL, options.AIR, options.GROUND, show.UNITS,
    show.plot_option("the shot as a coach would draw it"), show.REPORT, show.JSON,
)  # fmt: skip
def explain(club: options.ClubArgument, **texts: Any) -> None:
    """Explain, in words and a picture, where the ball starts and why it curves, with what-ifs."""
    output = show.Output.check(texts, [club, texts["ball"]])
    delivery = options.delivery(texts)
    setup = options.setup(club, texts)

    from clubface.simulation.explanation import explain as explained

    output.show(explained(delivery=delivery, **setup, **options.conditions(texts)).to_result())
