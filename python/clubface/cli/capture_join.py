"""``clubface capture join``: captured deliveries and a monitor's launches of the same shots, as one table."""

from __future__ import annotations

from typing import Annotated

import typer

from clubface.cli import options, output

SHOWN = 20
"""Rows without a partner that are printed."""


def join(
    captured: Annotated[
        str, typer.Argument(metavar="CAPTURED", help="Table of deliveries, as capture read writes it.")
    ],
    session: Annotated[str, typer.Argument(metavar="SESSION", help="The launches: a monitor's file, or a table.")],
    target: Annotated[str, typer.Option("--output", "-o", metavar="FILE", help="Write the shots, CSV or Parquet.")],
    format_: Annotated[
        str | None, typer.Option("--format", metavar="NAME", help="Layout of the session; recognised unless given.")
    ] = None,
    mapping: Annotated[
        str | None, typer.Option("--mapping", metavar="FILE", help="TOML file that names the columns of the session.")
    ] = None,
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
    if shots.rejected:
        print(f"{output.counted(len(shots.rejected), 'row')} left out")
        for each in shots.rejected[:SHOWN]:
            print(f"  line {each.line}, {each.reason}")
        if len(shots.rejected) > SHOWN:
            print(f"  and {len(shots.rejected) - SHOWN} more (--json lists all)")
    output.print_notes(shots.notes)
