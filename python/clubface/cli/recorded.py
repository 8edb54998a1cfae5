"""From the options of a command to recorded shots of one club, whatever measured them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

import typer

from clubface.cli import options
from clubface.cli.options import Group, text_option

_SHOTS = "Shots"
_MISMATCH = typer.Option(
    "--mismatch",
    rich_help_panel=_SHOTS,
    help="What happens to shots that look like those of another club: refuse or note.",
)
RECORDED: Group = {
    "club": text_option(
        "--club", "Club and ball", "CLUB", "Name or TOML file; the club that the shots name unless given."
    ),
    "only": text_option("--only", _SHOTS, "NAME", "Take only the shots of the club that the file calls so."),
    "format": (options.Format, None),
    "mapping": (options.ColumnsFile, None),
    "mismatch": (Annotated[str, _MISMATCH], "refuse"),
    **options.EQUIPMENT,
}
"""Options of a command that reads recorded shots."""


def recorded_shots(path: str, texts: Mapping[str, str | None]) -> tuple[Any, Any]:
    """Return the recorded shots of one club and the club, from the options of ``RECORDED``.

    Velocities and angles that a launch monitor takes elsewhere are referred to the points of clubface.
    """
    from clubface import launch_monitor
    from clubface.measured.shots import club_of, of_one_club

    shots = launch_monitor.read(path, texts["format"], texts["hand"], texts["mapping"])
    shots = shots.select(of_one_club(shots, texts["only"]))
    head = club_of(shots, texts["club"])
    if texts["hand"] is not None:
        head = head.replace(hand=texts["hand"])
    return launch_monitor.refer(shots, head), head
