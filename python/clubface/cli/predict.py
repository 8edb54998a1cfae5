"""``clubface predict``: launches for a file of deliveries or recorded shots."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, show
from clubface.cli.failures import print_note
from clubface.cli.output import progress_bar
from clubface.cli.recorded import CHOICE, assumed

app = typer.Typer(add_completion=False)

TAKEN = ("carry", "rejects", "resume", "hand", "format", "mapping", "only", "where", "mismatch")
"""Options passed to the function under the same names."""


FILES = options.group(
    None,
    rejects=(str | None, None, "FILE", "Write the unusable rows, with reasons."),
    carry=(bool, True, None, "Compute the flight too."),
)


@app.command()
@options.takes(
    CHOICE, options.EQUIPMENT, options.ONE_MODEL, options.AIR,
    show.table_option("Write the launches to this CSV or Parquet file."), FILES, options.RESUME,
    show.JSON,
)  # fmt: skip
def predict(
    deliveries: Annotated[
        str,
        options.argument(
            "DELIVERIES", "CSV or Parquet file with units in the column names, or a launch monitor's file."
        ),
    ],
    club: Annotated[str, typer.Option("--club", metavar="CLUB", help="Name of a built-in club, or a TOML file.")],
    **texts: Any,
) -> None:
    """Compute the launch of every delivery in a file."""
    setup, conditions = options.setup(club, texts), options.conditions(texts)

    from clubface.shots.prediction import predict as compute

    with progress_bar(lambda part, whole, rows: f"{rows} deliveries") as update:
        report = compute(
            deliveries, **setup, output=texts["target"], units=options.pairs(texts["file_unit"] or (), "--unit"),
            assume=assumed(texts), **{name: texts[name] for name in TAKEN},
            progress=update and (lambda part, rows: update(part, 1.0, rows)), **conditions,
        )  # fmt: skip
    show.Output(as_json=texts["as_json"]).show(report.to_result())
    if report.rejected and not report.written:
        print_note("not one delivery could be used")
        raise typer.Exit(2)
