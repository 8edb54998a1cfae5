"""``clubface export``: clubs, models and deliveries for other programs."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options
from clubface.cli.failures import print_written

app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Write files with which other programs compute impacts."
)

FUNCTION = options.group("Function",
    by=(options.Texts, None, "NAME", "Input or parameter that the function takes, such as toe; default: the "
                                     "delivery of the club. Several: comma-separated or repeated."),
    quantity=(options.Texts, None, "NAME", "Launch quantity that it returns, such as backspin; default: all. "
                                           "Several: comma-separated or repeated."),
)  # fmt: skip
UNIT = options.group("Unit", standard=(str, "2.0", "VERSION", "Version of the FMI standard: 2.0 or 3.0."))
Source = Annotated[str, options.output("FILE", "Write it to this file. Required.")]


@app.command()
@options.takes(options.DELIVERY, options.EQUIPMENT, options.SHAFT, options.ONE_SET)
def inputs(club: options.ClubArgument, output: Source, **texts: Any) -> None:
    """Write the numbers of a shot in the order of the C interface, as CSV: kind, name, value and unit (SI)."""
    from clubface.export import inputs_csv
    from clubface.support.files import write_text

    head = _head(club, texts)
    text = inputs_csv(
        head,
        options.delivery(texts),
        model=texts["model"],
        parameters=options.one_set(head, {**texts, "accuracy": None}),
        ball=texts["ball"],
    )
    print_written([write_text(output, text)])


@app.command()
@options.takes(
    options.DELIVERY, FUNCTION, options.EQUIPMENT, options.SHAFT, options.ONE_MODEL, options.AIR, options.GROUND
)
def casadi(club: options.ClubArgument, output: Source, **texts: Any) -> None:
    """Write C source of external functions for CasADi: launch from delivery, flight from launch, exact Jacobians.

    Values of the delivery that are given stay fixed; the others are what the function takes.
    """
    from clubface.export import casadi_source
    from clubface.simulation.inputs import DIMENSIONS
    from clubface.support.files import write_text

    head = _head(club, texts)
    text = casadi_source(
        head, options.quantities(texts, DIMENSIONS, {}), variables=options.names(texts["by"]) or None,
        quantities=options.names(texts["quantity"]) or None, model=texts["model"],
        parameters=options.one_set(head, texts), ball=texts["ball"], accuracy=texts["accuracy"],
        **options.conditions(texts),
    )  # fmt: skip
    print_written([write_text(output, text)])


@app.command()
@options.takes(options.EQUIPMENT, options.SHAFT, options.CONTACT_MODEL, UNIT)
def fmu(club: options.ClubArgument, output: Source, **texts: Any) -> None:
    """Write a co-simulation unit (FMI 2.0 or 3.0): the ball that another program's head strikes."""
    from clubface.export import write_fmu

    head, given = _head(club, texts), {**texts, "accuracy": None}
    path = write_fmu(
        output, head, model=texts["model"], parameters=options.one_set(head, given), ball=texts["ball"],
        version=texts["standard"],
    )  # fmt: skip
    print_written([path])


def _head(club: str, texts: dict[str, Any]) -> Any:
    """Return the club with the hand and the shaft chosen by the options."""
    head = options.club_of(club, texts["hand"], texts["model"])
    return head if texts["shaft"] is None else head.on_shaft(texts["shaft"])
