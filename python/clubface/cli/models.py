"""``clubface models``: the models, or one with its parameters, published values, sources and caveats."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, show

app = typer.Typer(add_completion=False)


@app.command()
@options.takes(show.REPORT, show.JSON)
def models(
    name: Annotated[str | None, options.argument("[NAME]", "Show this model in full.")] = None, **texts: Any
) -> None:
    """List the impact models, or show one with its parameters and their published values."""
    from clubface.equipment.listings import models_result
    from clubface.simulation.rebound import model_in_full

    output = show.Output.check(texts)
    output.show(models_result() if name is None else model_in_full(name))
