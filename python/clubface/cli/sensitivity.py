"""``clubface sensitivity``: the exact derivatives of a launch."""

from __future__ import annotations

from typing import Any

import typer

from clubface.cli import options, show
from clubface.errors import InputError

app = typer.Typer(add_completion=False)

NAMES = options.group(
    None,
    output=(options.Texts, None, "NAME", "Launch quantity, such as backspin. Several: comma-separated or repeated."),
    by=(options.Texts, None, "NAME", "Input or parameter, such as toe. Several: comma-separated or repeated."),
)


@app.command()
@options.takes(options.DELIVERY, options.EQUIPMENT, options.ONE_MODEL, NAMES, show.REPORT, show.JSON)
def sensitivity(club: options.ClubArgument, **texts: Any) -> None:
    """Print how the launch changes with every input and parameter ("rpm per mm")."""
    output = show.Output.check(texts, [club])
    delivery = options.delivery(texts)
    setup = options.setup(club, texts)

    from clubface.simulation.flight import Flight
    from clubface.simulation.results import outputs
    from clubface.simulation.sensitivity import MAIN, sensitivity as differentiate

    for each in options.names(texts["output"]) or ():
        if each in Flight.quantities() and each not in outputs():
            raise InputError(
                "--output", each, "a quantity of the launch; clubface explain says what a degree, 10 mm of strike and "
                "1 mph are worth in carry and side, and clubface compare splits differences of flights",
            )  # fmt: skip
    result = differentiate(
        delivery=delivery, **setup,
        outputs=options.names(texts["output"]) or (None if output.as_json else MAIN),
        variables=options.names(texts["by"]) or None,
    )  # fmt: skip
    output.show(result.to_result(every_variable=bool(texts["by"])))
