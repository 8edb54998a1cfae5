"""``clubface shot``: one shot, by one model as a list, by several side by side."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import typer

from clubface.cli import options, show
from clubface.cli.failures import print_note
from clubface.equipment.models import DEFAULT_MODEL, model
from clubface.errors import RangeWarning

app = typer.Typer(add_completion=False)

DRAWN = 1e-8
"""Accuracy of plotted histories, with steps small enough for a smooth line."""


@app.command()
@options.takes(
    options.DELIVERY, options.EQUIPMENT, options.SHAFT, options.MODELS, options.AIR, options.GROUND, show.UNITS,
    show.table_option("Write the table to this CSV or Parquet file."), show.plot_option("forces and flight"),
    show.REPORT, show.JSON,
)  # fmt: skip
def shot(club: options.ClubArgument, **texts: Any) -> None:
    """Compute one shot: how the ball leaves and where it flies."""
    output = show.Output.check(texts, [club, texts["ball"], texts["shaft"]])
    delivery = options.delivery(texts)
    head = options.club_of(club, texts["hand"], texts["model"])
    head = head if texts["shaft"] is None else head.on_shaft(texts["shaft"])
    names = options.model_names(texts["model"], DEFAULT_MODEL)
    options.check_accuracy(names, texts["accuracy"])
    sets = options.parameter_sets(names, head.parameters, texts["parameters"], texts["setting"])
    conditions = options.conditions(texts)

    from clubface.results.notes import note
    from clubface.simulation.flight import fly
    from clubface.simulation.impact import Tally, impact
    from clubface.simulation.shot_result import shot_result
    from clubface.support.checks import without_warnings

    with without_warnings(RangeWarning):
        launches = {
            name: impact(head, delivery, model=name, parameters=each, ball=texts["ball"], accuracy=texts["accuracy"])
            for name, each in sets.items()
        }
    if remark := Tally().add_all(launches.values()).remark():
        print_note(f"note: {remark}")
    flights = {name: fly(launch, **conditions) for name, launch in launches.items()}
    hints = () if texts["model"] else (note("all-models"),)
    result = shot_result(launches, flights, conditions=conditions, paths=lambda: _paths(launches, conditions, delivery))
    if output.report is not None:
        result = _add_reasons(result, launches, delivery, conditions)
    output.show(result.replace(hints=hints))


def _add_reasons(result: Any, launches: Mapping[str, Any], delivery: Any, conditions: Mapping[str, Any]) -> Any:
    """Return a shot with the reasons for its flight, in words and as a picture, by the first model that has them."""
    from clubface.equipment.models import models
    from clubface.simulation.explanation import explain, explanation_picture

    launch = next((each for name, each in launches.items() if name in models()), None)
    if launch is None:
        return result
    explained = explain(
        launch.club, delivery, model=launch.model, parameters=launch.parameters, ball=launch.ball,
        accuracy=launch.accuracy, **conditions,
    )  # fmt: skip
    draw = result.draw
    return result.replace(
        summary=(*result.summary, *(each for each in explained.reasons() if each not in result.summary)),
        draw=lambda: [*(draw() if draw is not None else ()), explanation_picture(explained)],
    )


def _paths(
    launches: Mapping[str, Any], conditions: Mapping[str, Any], delivery: Mapping[str, float]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the flight paths and, for the models that have them, the force histories, by model."""
    from clubface.simulation.flight import trajectory
    from clubface.simulation.history import history
    from clubface.simulation.impact import backend_of

    positions = {name: trajectory(launch, **conditions).position for name, launch in launches.items()}
    histories: dict[str, Any] = {}
    for name, each in launches.items():
        if model(name).kind == "contact":
            accuracy = each.accuracy or DRAWN
            histories[name] = history(
                each.club, delivery, model=name, parameters=each.parameters, ball=each.ball, accuracy=accuracy
            )
        elif (forces := backend_of(name).forces(each, delivery)) is not None:
            histories[name] = forces
    return positions, histories
