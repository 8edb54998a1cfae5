"""``clubface flight``: the flight of a ball whose launch is known."""

from __future__ import annotations

from typing import Any

import typer

from clubface.cli import options, output
from clubface.cli.output import print_numbers
from clubface.units import from_si

app = typer.Typer(add_completion=False)

SHOWN = {
    "carry_m": ("carry", "m", "yd", 1), "side_m": ("side", "m", "yd", 1), "total_m": ("total", "m", "yd", 1),
    "total_side_m": ("total_side", "m", "yd", 1), "apex_m": ("apex", "m", "yd", 1),
    "landing_deg": ("landing_angle", "deg", "deg", 1), "flight_time_s": ("flight_time", "s", "s", 2),
    "landing_speed_mps": ("landing_speed", "m/s", "mph", 1), "landing_spin_rpm": ("landing_spin", "rpm", "rpm", 0),
}  # fmt: skip
"""Keys of the JSON object: quantity, its unit there and in the table, and digits in the table."""

ENDS = ("soft", "firm")
"""The fairways between which a total lies that no published run supports."""


@app.command()
@options.takes(options.LAUNCH, options.BALL, options.AIR, options.GROUND)
def flight(as_json: options.Json = False, **texts: Any) -> None:
    """Compute where a launched ball flies, bounces and rolls."""
    from clubface.equipment.balls import ball
    from clubface.simulation.flight import fly, has_measured_run
    from clubface.simulation.results import outputs

    dimensions = {name: outputs()[name].dimension for name in options.LAUNCH}
    values = options.quantities(texts, dimensions, {"ball_speed": "167 mph", "launch": "10.9 deg"})
    conditions = options.conditions(texts)
    launch = {**values, **ball(texts["ball"]).inputs()}
    flown = fly(launch, **conditions)
    between: dict[str, float] = {}
    if texts["ground"] is None and not has_measured_run(flown.landing_angle, flown.landing_speed):
        for firmness in ENDS:
            between[firmness] = float(fly(launch, **{**conditions, "ground": f"{firmness} fairway"}).total)
    if as_json:
        shown = {key: float(flown.get(name, unit)) for key, (name, unit, _, _) in SHOWN.items()}
        output.print_json(shown | {f"total_{firmness}_m": total for firmness, total in between.items()})
        return
    heads = [f"{name.replace('_', chr(10))}\n{unit}" for name, _, unit, _ in SHOWN.values()]
    cells = [output.number(float(flown.get(name, unit)), digits) for name, _, unit, digits in SHOWN.values()]
    print_numbers(heads, [cells])
    if flown.outside_fit:
        output.print_notes(["the spin leaves the range to which the aerodynamics were fitted"])
    if between:
        soft, firm = (from_si(total, "yd") for total in between.values())
        note = f"no measured run of so low or slow a ball is published; the total is {soft:.0f} to {firm:.0f} yd"
        output.print_notes([f"{note} from a soft to a firm fairway"])
