"""Recorded shots from the options of a command."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any

from clubface.cli import options
from clubface.cli.options import Group

if TYPE_CHECKING:
    from clubface.shots.measured import ReadyShots
    from clubface.shots.recorded import RecordedShots


_SHOTS = "Shots"
_UNIT_TEXT = "Unit that the file does not name: speed=km/h, carry=m. Repeatable."
_UNIT = options.option("--unit", panel=_SHOTS, metavar="NAME=UNIT", text=_UNIT_TEXT)
READING: Group = {
    **options.LAYOUT,
    "file_unit": (Annotated[options.Texts, _UNIT], None),
    **options.group(_SHOTS,
        where=(str | None, None, "CONDITION",
               "Use only these shots: \"ball_speed > 150 mph and club == '7i'\"."),
    ),
}  # fmt: skip
"""Options of commands that read a file of shots."""
CHOICE: Group = {**READING, **options.group(_SHOTS,
    only=(str | None, None, "NAME", "Use only the shots of the club with this name in the file."),
    mismatch=(str, "refuse", "refuse|note", "Refuse shots of another club, or accept them with a note."),
    assume=(options.Texts, None, "NAME=VALUE",
            'Value to assume where it was not measured: "toe=0 mm". Repeatable.'),
)}  # fmt: skip
"""Options of commands for the shots of one club."""
RECORDED: Group = {
    **options.group("Club and ball",
        club=(options.Text, None, "CLUB", "Name or TOML file; default: the club that the shots name."),
    ),
    **CHOICE,
    **options.EQUIPMENT,
}  # fmt: skip
"""Options of commands for the shots of one club, which may be taken from the shots."""


Files = Annotated[
    list[str], options.argument("FILE...", "Shots: monitors' files, or tables; several files are several sessions.")
]


def read_shots(
    path: str | list[str], texts: Mapping[str, Any], club: Any = None, *, where: bool = False
) -> RecordedShots:
    """Return the shots of files, from ``hand``, the options of ``READING``, and ``--where`` if ``where``."""
    from clubface.shots.reading import read

    units = options.pairs(texts["file_unit"] or (), "--unit")
    shots = read(path, texts["format"], texts["hand"], texts["mapping"], units=units, club=club)
    if not where or texts["where"] is None:
        return shots
    from clubface.shots.conditions import matching_shots

    return matching_shots(shots, texts["where"])[0]


def recorded_shots(path: str | list[str], texts: Mapping[str, Any]) -> ReadyShots:
    """Return the shots of one club, from the options of ``RECORDED``, ready for models."""
    from clubface.shots.measured import ready_shots

    return ready_shots(read_shots(path, texts), **choice(texts))


def choice(texts: Mapping[str, Any]) -> dict[str, Any]:
    """Return the arguments of :func:`clubface.shots.measured.ready_shots` from the options of ``RECORDED``."""
    return {name: texts[name] for name in ("club", "hand", "only", "where", "mismatch")} | {"assume": assumed(texts)}


def assumed(texts: Mapping[str, Any]) -> dict[str, str]:
    """Return the values assumed for quantities that were not measured; a value without a unit is an error."""
    from clubface.simulation.inputs import DIMENSIONS

    values = options.pairs(texts["assume"] or (), "--assume")
    for name, text in values.items():
        if name in DIMENSIONS:
            options.parsed(f"--assume {name}", text, DIMENSIONS[name])
    return values
