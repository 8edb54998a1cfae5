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
    head = options.club_of(club, texts["hand"], texts["model"])
    chosen = options.one_set(head, texts)

    from clubface.simulation.explanation import explain as explained

    result = explained(
        head, delivery, model=chosen.model, parameters=chosen, ball=texts["ball"], accuracy=texts["accuracy"],
        **options.conditions(texts),
    )  # fmt: skip
    output.show(result.to_result())
