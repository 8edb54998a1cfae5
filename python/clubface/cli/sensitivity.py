"""``clubface sensitivity``: the exact derivatives of a launch."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, show

app = typer.Typer(add_completion=False)

_NAMES = "Several with commas or repeated."


@app.command()
@options.takes(options.DELIVERY, options.EQUIPMENT, options.ONE_MODEL, show.REPORT, show.JSON)
def sensitivity(
    club: options.ClubArgument,
    wanted: Annotated[
        list[str] | None,
        options.option("--output", metavar="NAME", text=f"Launch quantity, such as backspin. {_NAMES}"),
    ] = None,
    by: Annotated[
        list[str] | None, options.option("--by", metavar="NAME", text=f"Input or parameter, such as toe. {_NAMES}")
    ] = None,
    **texts: Any,
) -> None:
    """Print how the launch changes with every input and parameter ("rpm per mm")."""
    output = show.Output.check(texts, [club])
    delivery = options.delivery(texts)
    head = options.club_of(club, texts["hand"], texts["model"])
    chosen = options.one_set(head, texts)

    from clubface.simulation.sensitivity import MAIN, sensitivity as differentiate

    result = differentiate(
        head, delivery, model=chosen.model, parameters=chosen, ball=texts["ball"], accuracy=texts["accuracy"],
        outputs=options.names(wanted) or (None if output.as_json else MAIN),
        variables=options.names(by) or None,
    )  # fmt: skip
    output.show(result.to_result(every_variable=bool(by)))
