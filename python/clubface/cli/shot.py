"""``clubface shot``: one shot, by one model as a list, by several side by side."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say, say_written
from clubface.cli.output import KEYS
from clubface.equipment.models import DEFAULT_MODEL, model
from clubface.errors import RangeWarning
from clubface.simulation.results import SHOWN

app = typer.Typer(add_completion=False)

HEADS = (
    "model", "ball\nspeed\nmph", "smash", "launch\ndeg", "azi-\nmuth\ndeg", "back-\nspin\nrpm", "side-\nspin\nrpm",
    "total\nspin\nrpm", "spin\naxis\ndeg", "carry\nyd", "side\nyd", "con-\ntact\nµs", "peak\nforce\nkN",
)  # fmt: skip
CELLS = (
    "ball_speed", "smash", "launch", "azimuth", "backspin", "sidespin", "total_spin", "spin_axis", "carry", "side",
    "contact_time", "peak_force",
)  # fmt: skip
"""The quantities of the columns after the first."""
ALONE = (*CELLS[:10], "apex", "landing_angle", *CELLS[10:])
"""What is listed for one model."""
SIDED = ("azimuth", "sidespin", "spin_axis", "side")
"""The quantities of which positive means to the right."""
UNITS = {"1": "", "us": "µs"}
"""The units that are written in another way."""

JSON_KEYS = {
    **{key: of for key, of in KEYS.items() if of[0] not in ("total", "total_side")},
    "contact_time_s": ("contact_time", "s"), "peak_force_n": ("peak_force", "N"),
}  # fmt: skip
"""Keys of the JSON objects after "model": quantity and unit."""

DRAWN = 1e-8
"""Accuracy of a history that is drawn: its steps are close enough to make a smooth line."""


@app.command()
@options.takes(options.DELIVERY, options.EQUIPMENT, options.MODELS, options.AIR, options.GROUND)
def shot(
    club: options.ClubArgument,
    plot: Annotated[str | None, options.picture("forces and flight")] = None,
    report: options.Report = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Compute one shot: how the ball leaves and where it flies."""
    delivery = options.delivery(texts)
    output.check_picture(plot)
    output.check_report(report)
    head = options.club_of(club, texts["hand"], texts.get("model"))
    names = options.model_names(texts["model"], DEFAULT_MODEL)
    options.check_accuracy(names, texts["accuracy"])
    sets = options.parameter_sets(names, head.parameters, texts["parameters"], texts["setting"])
    conditions = options.conditions(texts)

    from clubface.simulation.flight import fly
    from clubface.simulation.impact import Tally, impact
    from clubface.support.checks import without_warnings

    with without_warnings(RangeWarning):
        launches = {
            name: impact(head, delivery, model=name, parameters=each, ball=texts["ball"], accuracy=texts["accuracy"])
            for name, each in sets.items()
        }
    if remark := Tally().add_all(launches.values()).remark():
        say(f"note: {remark}")
    flights = {name: fly(launch, **conditions) for name, launch in launches.items()}
    if plot is not None or report is not None:
        _draw(plot, report, launches, flights, conditions, delivery)
    _print(launches, flights, as_json)
    if not as_json and (told := options.own_lofts([(head, delivery)])):
        output.print_paragraph(told)
    say_written([each for each in (plot, report) if each is not None])
    if not (texts["model"] or as_json):
        output.print_paragraph("--model all shows every model side by side.")


def value(launch: Any, flight: Any, quantity: str, unit: str) -> float:
    """Return a quantity of a launch, or else of its flight, in ``unit``."""
    of = launch if quantity in launch.quantities() else flight
    return float(of.get(quantity, unit))


def number(launch: Any, flight: Any, quantity: str) -> str:
    """Return a quantity of a launch, or else of its flight, as people read it; nothing where there is none."""
    unit, digits = SHOWN[quantity]
    return output.number(value(launch, flight, quantity, unit), digits)


def _print(launches: Mapping[str, Any], flights: Mapping[str, Any], as_json: bool) -> None:
    from clubface.cli import output

    if as_json:
        rows = [
            {"model": name, **{key: value(launch, flights[name], *of) for key, of in JSON_KEYS.items()}}
            for name, launch in launches.items()
        ]
        output.print_json(rows)
        return
    if len(launches) == 1:
        (launch,) = launches.values()
        title = f"{launch.club.name}, ball {launch.ball.name}, by {launch.model}"
        output.print_list(_listed(launch, flights[launch.model]), title=title)
    else:
        rows = [
            [name, *(number(launch, flights[name], quantity) for quantity in CELLS)]
            for name, launch in launches.items()
        ]
        output.print_numbers(HEADS, rows)
    if note := _note(launches, flights):
        output.print_paragraph(note)


def _listed(launch: Any, flight: Any) -> list[tuple[str, str, str]]:
    """Return quantity, number, and unit with the side to which it is, of what one model gives."""
    rows = []
    for quantity in ALONE:
        if text := number(launch, flight, quantity):
            unit = SHOWN[quantity][0]
            side = f"to the {'left' if text.startswith('-') else 'right'}" if quantity in SIDED and float(text) else ""
            rows.append((quantity.replace("_", " "), text, f"{UNITS.get(unit, unit)} {side}".strip()))
    return rows


def _note(launches: Mapping[str, Any], flights: Mapping[str, Any]) -> str:
    """Return the one line under the table: flights beyond the aerodynamic data, and where the caveats stand."""
    said = []
    if outside := [name for name in launches if flights[name].outside_fit]:
        said.append(f"Spin leaves the aerodynamic data in flight: {', '.join(outside)}.")
    if doubted := [name for name, each in launches.items() if each.parameters.caveats or each.parameters.value_caveats]:
        which = doubted[0] if len(doubted) == 1 else "NAME"
        said.append(f"Caveats: clubface models {which}")
    return " ".join(said)


def _draw(
    plot: str | None,
    report: str | None,
    launches: Mapping[str, Any],
    flights: Mapping[str, Any],
    conditions: Mapping[str, Any],
    delivery: Mapping[str, float],
) -> None:
    """Draw forces and flights of all models into one file, and write the report around the same picture."""
    from clubface import plots, units
    from clubface.simulation.flight import trajectory
    from clubface.simulation.history import history
    from clubface.simulation.impact import backend_of
    from clubface.simulation.inputs import DIMENSIONS

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
    first = next(iter(launches.values()))
    shown = {name: units.display_unit(name, units.SI_UNITS[DIMENSIONS[name]]) for name in delivery} | {"speed": "mph"}
    described = [f"{name.replace('_', ' ')} {units.show(value, shown[name], 4)}" for name, value in delivery.items()]
    if first.club.hand < 0:
        described.append("left-handed")
    unbroken = ", ".join(each.replace(" ", "\N{NO-BREAK SPACE}") for each in described)
    figure = plots.shot_figure(positions, histories, title=f"{first.club.name}: {unbroken}")
    if plot is not None:
        plots.save(figure, plot)
    if report is not None:
        from clubface.present.report import write_document
        from clubface.present.shot_report import shot_blocks

        blocks = shot_blocks(launches, flights, figure, positions, given=reporting.flown(conditions))
        write_document([*blocks, *reporting.repeat()], report)
