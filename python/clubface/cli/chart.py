"""``clubface chart``: the model behind TrackMan's chart of drives of 2010."""

from __future__ import annotations

from typing import Any

import typer

from clubface.cli import options, show

app = typer.Typer(add_completion=False)


@app.command()
@options.takes(show.JSON)
def chart(**texts: Any) -> None:
    """Show that TrackMan's 2010 chart of drives was computed with a model: a rigid ball that rolls off a head."""
    from clubface.validation.chart import chart as compute_chart

    show.Output.check(texts).show(compute_chart().to_result())
