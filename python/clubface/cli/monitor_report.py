"""``clubface monitor report``: a report for a player, in plain language."""

from __future__ import annotations

from typing import Annotated, Any

from clubface.cli import options, output, reporting
from clubface.cli.failures import say
from clubface.cli.recorded import READING, Files, read_shots


@options.takes(READING)
def report(
    files: Files,
    target: Annotated[str, options.output("FILE", "The report to write: .html or .md, with its pictures inside.")],
    hand: Annotated[str | None, options.option("--hand", metavar="right|left", text="Hand of the player.")] = None,
    club: Annotated[
        str | None, options.option("--club", metavar="NAME", text="The club, where the shots name none: 7-iron.")
    ] = None,
    **texts: Any,
) -> None:
    """Write for a player, in plain language: what was measured, what it means, and how sure that is."""
    from dataclasses import replace

    import numpy as np

    from clubface.player_report.document import write_report
    from clubface.reports.document import ENDINGS

    output.check_target("--output", target, ENDINGS, [*files, texts["mapping"]])
    import clubface.plots  # noqa: F401  (a missing library is told before any work)

    shots = read_shots(files, texts | {"hand": hand}, where=True)
    if club is not None:
        shots = replace(shots, clubs=np.full(len(shots), club, dtype=object))
    say(f"wrote {write_report(shots, target, more=reporting.repeat())}")
