"""The flight of a ball of known launch as a result."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from clubface.quantities import format_value, quantity
from clubface.results.notes import Note, note
from clubface.results.provenance import Provenance
from clubface.results.result import Result
from clubface.results.table import column
from clubface.simulation.flight import fly, has_measured_run, trajectory
from clubface.simulation.provenance import flight_conditions
from clubface.simulation.shot_result import shot_picture

QUANTITIES = (
    "carry", "side", "total", "total_side", "apex", "landing_angle", "flight_time", "landing_speed", "landing_spin",
)  # fmt: skip
ENDS = ("soft", "firm")
"""The fairways between which a total lies that no published run supports."""


def flight_result(
    launch: Mapping[str, float], *, air: Any = None, wind: Any = None, ground: str | Mapping[str, Any] | None = None
) -> Result:
    """Fly a ball and return carry, total, apex and landing, with the totals on soft and firm ground of a low ball.

    Parameters
    ----------
    launch, air, wind, ground
        As for :func:`clubface.fly`; single values.
    """
    flown = fly(launch, air=air, wind=wind, ground=ground)
    values = [column(name, [getattr(flown, name)]) for name in QUANTITIES]
    notes: list[Note] = [note("spin-outside-aerodynamic-data")] if flown.outside_fit else []
    if ground is None and not has_measured_run(flown.landing_angle, flown.landing_speed):
        soft, firm = (float(fly(launch, air=air, wind=wind, ground=f"{each} fairway").total) for each in ENDS)
        notes.append(note("run-not-measured", soft_total=soft, firm_total=firm))
        values += [
            column("total_soft", [soft], "total", printed=False), column("total_firm", [firm], "total", printed=False),
        ]  # fmt: skip
    inputs = {name.replace("_", " "): format_value(value, quantity(name)) for name, value in launch.items() if value}
    return Result(
        "flight", "Flight", values=tuple(values), notes=tuple(notes),
        provenance=Provenance(inputs=inputs | flight_conditions(air, wind, ground)),
        draw=lambda: [shot_picture({"flight": trajectory(launch, air=air, wind=wind, ground=ground).position})],
    )  # fmt: skip
