"""``clubface monitor report``: a report for a player, in plain language."""

from __future__ import annotations

from typing import Annotated

import typer

from clubface.cli import options, output
from clubface.cli.failures import say


def report(
    file: Annotated[str, typer.Argument(metavar="FILE", help="Shots: a launch monitor's file, or a table.")],
    target: Annotated[str, options.output("FILE", "The report to write: .html or .md, with its pictures inside.")],
    format_: options.Format = None,
    mapping: options.ColumnsFile = None,
    hand: Annotated[str | None, options.option("--hand", metavar="right|left", text="Hand of the player.")] = None,
    club: Annotated[
        str | None, options.option("--club", metavar="NAME", text="The club, where the shots name none: 7-iron.")
    ] = None,
) -> None:
    """Write for a player, in plain language: what was measured, what it means, and how sure that is."""
    from dataclasses import replace

    import numpy as np

    from clubface import launch_monitor
    from clubface.player_report.document import write_report
    from clubface.reports.document import ENDINGS

    output.check_target("--output", target, ENDINGS, [file, mapping])
    import clubface.plots  # noqa: F401  (a missing library is told before any work)

    shots = launch_monitor.read(file, format_, hand, mapping)
    if club is not None:
        shots = replace(shots, clubs=np.full(len(shots), club, dtype=object))
    say(f"wrote {write_report(shots, target)}")
