"""The flight of a ball of known launch as a result."""

from __future__ import annotations

from collections.abc import Mapping

from clubface.quantities import format_value, quantity
from clubface.results.notes import Note, note
from clubface.results.provenance import Provenance
from clubface.results.result import Result
from clubface.results.table import column, text
from clubface.simulation.flight import AirLike, GroundLike, WindLike, fly, has_measured_run, trajectory
from clubface.simulation.provenance import flight_conditions
from clubface.simulation.shot_result import shape_note, shot_picture

QUANTITIES = (
    "carry", "side", "curve", "total", "total_side", "apex", "landing_angle", "flight_time", "landing_speed",
    "landing_spin",
)  # fmt: skip
ENDS = ("soft", "firm")
"""The fairways between which a total lies that no published run supports."""


def flight_result(
    launch: Mapping[str, float],
    *,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    hand: str = "right",
) -> Result:
    """Fly a ball and return its way through the air and on the ground, of a low ball on soft and firm ground too.

    Parameters
    ----------
    hand
        Of the player, for the name of the shot.
    launch, air, wind, ground
        As for :func:`clubface.fly`; single values.
    """
    flown = fly(launch, air=air, wind=wind, ground=ground)
    values = [column(name, [getattr(flown, name)]) for name in QUANTITIES]
    values.append(text("shot_shape", [flown.shot_shape(hand) or None], printed=False))
    notes: list[Note] = [shape_note("shot-shape", flown, hand)]
    if flown.outside_fit:
        notes.append(note("spin-outside-aerodynamic-data"))
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
        draw=lambda: [
            shot_picture(
                {"flight": trajectory(launch, air=air, wind=wind, ground=ground).position},
                shapes={"flight": flown.shot_shape(hand)},
            )
        ],
    )  # fmt: skip
