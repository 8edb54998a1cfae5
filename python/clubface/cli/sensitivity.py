"""``clubface sensitivity``: the exact derivatives of a launch."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.output import print_numbers

app = typer.Typer(add_completion=False)

_NAMES = "Several with commas or repeated."


@app.command()
@options.takes(options.DELIVERY, options.EQUIPMENT, options.ONE_MODEL)
def sensitivity(
    club: options.ClubArgument,
    wanted: Annotated[
        list[str] | None,
        options.option("--output", metavar="NAME", text=f"Launch quantity, such as backspin. {_NAMES}"),
    ] = None,
    by: Annotated[
        list[str] | None, options.option("--by", metavar="NAME", text=f"Input or parameter, such as toe. {_NAMES}")
    ] = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Print how the launch changes with every input and parameter ("rpm per mm")."""
    delivery = options.delivery(texts)
    head = options.club_of(club, texts["hand"], texts.get("model"))
    chosen = options.one_set(head, texts)

    from clubface.simulation.sensitivity import MAIN, sensitivity as differentiate

    outputs = options.names(wanted) or (None if as_json else MAIN)
    found = differentiate(
        head, delivery, model=chosen.model, parameters=chosen, ball=texts["ball"], accuracy=texts["accuracy"],
        outputs=outputs, variables=options.names(by) or None,
    )  # fmt: skip
    if as_json:
        output.print_json(_document(found))
        return
    heads = ["", *(f"{name}\n{_unit(found.units[name])}".rstrip() for name in found.outputs)]
    shown = found.variables if by else found.main_variables
    rows = [
        [_per(variable, found.units[variable]), *(f"{value + 0.0:.4g}" for value in column)]
        for variable, column in zip(found.variables, found.values.T.tolist(), strict=True)
        if variable in shown
    ]
    print_numbers(heads, rows, title=f"{head.name}, {chosen.model}: change of the launch")
    output.print_notes(f"{chosen.model}: {text}" for text in chosen.caveats)
    if any(name.startswith(("cg_", "dcg_")) for name in shown):
        output.print_notes([output.HELD])
    if hidden := len(found.variables) - len(shown):
        output.print_notes([f"{hidden} coefficients of {chosen.model} are left out; --by NAME and --json have them."])


def _document(found: Any) -> dict[str, Any]:
    derivatives = [
        {"output": name, "variable": variable, "value": value, "unit": found.unit(name, variable)}
        for name, row in zip(found.outputs, found.values.tolist(), strict=True)
        for variable, value in zip(found.variables, row, strict=True)
    ]
    return {"model": found.launch.model, "club": found.launch.club.name, "derivatives": derivatives}


def _per(variable: str, unit: str) -> str:
    return f"{variable}, per {unit}" if _unit(unit) else variable


def _unit(unit: str) -> str:
    return "" if unit == "1" else unit
