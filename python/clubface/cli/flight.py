"""``clubface flight``: the flight of a ball from a known launch."""

from __future__ import annotations

from typing import Any

import typer

from clubface.cli import options, show

app = typer.Typer(add_completion=False)

_HAND = "Hand of the player, for the name of the shot; default right."
HAND = options.group(None, hand=(options.Text, None, "right|left", _HAND))


@app.command()
@options.takes(
    options.LAUNCH, options.BALL, HAND, options.AIR, options.GROUND, show.UNITS,
    show.plot_option("the flight"), show.REPORT, show.JSON,
)  # fmt: skip
def flight(**texts: Any) -> None:
    """Compute how a launched ball flies, bounces and rolls."""
    from clubface.equipment.balls import ball
    from clubface.equipment.described import HANDS
    from clubface.simulation.results import outputs
    from clubface.simulation.shot_result import flight_result
    from clubface.support.checks import check_choice

    output = show.Output.check(texts, [texts["ball"]])
    dimensions = {name: outputs()[name].dimension for name in options.LAUNCH}
    values = options.quantities(texts, dimensions, {"ball_speed": "167 mph", "launch": "10.9 deg"})
    launch = {**values, **ball(texts["ball"]).inputs()}
    hand = texts["hand"] or "right"
    check_choice("--hand", hand, HANDS)
    output.show(flight_result(launch, hand=hand, **options.conditions(texts)))
