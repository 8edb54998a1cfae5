"""``clubface tour``: every club of the published tour averages by every model, compared with what was published."""

from __future__ import annotations

from typing import Any

import typer

from clubface.cli import options, show
from clubface.cli.failures import print_note
from clubface.cli.output import progress_bar
from clubface.errors import RangeWarning

app = typer.Typer(add_completion=False)

TABLES_TEXT = "pga-2023 (default), pga-2019, lpga-2019, several separated by commas, or all."


@app.command()
@options.takes(
    show.FOLDER,
    options.BALL,
    show.JSON,
    options.group(None, averages=(options.Text, None, "NAME", TABLES_TEXT)),
    options.group("Model", model=(options.Texts, None, "NAME", options.MODELS_TEXT)),
)
def tour(**texts: Any) -> None:
    """Compute the published tour averages, club by club, with the default model, then with every model."""
    from clubface.simulation.impact import Tally
    from clubface.support.checks import without_warnings
    from clubface.validation.tour import DEFAULT_TABLE, TABLES, published_table, tour as run, tour_result

    models = options.model_names(texts["model"])
    wanted = options.names([texts["averages"] or DEFAULT_TABLE])
    tables = list(dict.fromkeys(name for each in wanted for name in (TABLES if each == "all" else [each])))
    for each in tables:
        published_table(each)  # checked before the work, so that an unknown name is reported at once
    output = show.Output.check(texts, [texts["ball"]])
    tours = []
    for table in tables:
        with progress_bar(table) as progress, without_warnings(RangeWarning):
            tours.append(run(models, table=table, ball=texts["ball"], progress=progress))
    launches = (launch for each in tours for group in each.launches.values() for launch in group)
    if remark := Tally().add_all(launches).remark():
        print_note(f"note: {remark}")
    parts = {each.table.name: each.to_result() for each in tours} if len(tours) > 1 else None
    output.show(tour_result(tours), parts=parts)
