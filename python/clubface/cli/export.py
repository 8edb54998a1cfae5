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

    text = inputs_csv(delivery=options.delivery(texts), **options.setup(club, texts))
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

    text = casadi_source(
        **options.setup(club, texts), delivery=options.quantities(texts, DIMENSIONS, {}),
        variables=options.names(texts["by"]) or None, quantities=options.names(texts["quantity"]) or None,
        **options.conditions(texts),
    )  # fmt: skip
    print_written([write_text(output, text)])


@app.command()
@options.takes(options.EQUIPMENT, options.SHAFT, options.CONTACT_MODEL, UNIT)
def fmu(club: options.ClubArgument, output: Source, **texts: Any) -> None:
    """Write a co-simulation unit (FMI 2.0 or 3.0): the ball that another program's head strikes."""
    from clubface.export import write_fmu

    print_written([write_fmu(output, **options.setup(club, texts), version=texts["standard"])])
