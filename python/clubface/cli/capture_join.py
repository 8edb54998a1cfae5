"""``clubface capture join``: captured deliveries and a monitor's launches of the same shots, as one table."""

from __future__ import annotations

from typing import Annotated

import typer

from clubface.cli import options, output


def join(
    captured: Annotated[
        str, typer.Argument(metavar="CAPTURED", help="Table of deliveries, as capture read writes it.")
    ],
    session: Annotated[str, typer.Argument(metavar="SESSION", help="The launches: a monitor's file, or a table.")],
    target: Annotated[str, options.output("FILE", "Write the shots, CSV or Parquet.")],
    format_: options.Format = None,
    mapping: options.ColumnsFile = None,
    as_json: options.Json = False,
) -> None:
    """Pair captured deliveries with the launches of a monitor, in the order in which the shots were hit."""
    from clubface import launch_monitor, motion_capture
    from clubface.tables.writer import KINDS

    output.check_target("--output", target, KINDS, [captured, session, mapping])
    shots = motion_capture.join(
        launch_monitor.read(captured), launch_monitor.read(session, format=format_, mapping=mapping)
    )
    shots.write(target)
    if as_json:
        document = {"shots": len(shots), "output": target, "rejected": [each._asdict() for each in shots.rejected]}
        output.print_json(document | {"notes": shots.notes})
        return
    print(f"{output.counted(len(shots), 'shot')}: {target}")
    output.print_rejected(shots.rejected, "left out", "--json lists all")
    output.print_notes(shots.notes)
