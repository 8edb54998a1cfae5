"""``clubface chart``: the model behind TrackMan's chart of drives of 2010."""

from __future__ import annotations

import typer

from clubface.cli import options, output
from clubface.cli.output import print_numbers

app = typer.Typer(add_completion=False)


@app.command()
def chart(as_json: options.Json = False) -> None:
    """Show that TrackMan's chart of drives of 2010 is computed, by a rigid ball that rolls off a head."""
    from clubface import published_data
    from clubface.validation import chart as behind

    found = behind.chart()
    if as_json:
        output.print_json({**found._asdict(), "errors": [each._asdict() for each in found.errors]})
        return
    table = published_data.table(behind.TABLE)
    print_numbers(behind.HEADS, behind.table_rows(found.errors), title=f"{table.title}, ball {behind.BALL}")
    print()
    output.print_notes([*behind.narrative(found), f"{table.title}: {table.source}."])
