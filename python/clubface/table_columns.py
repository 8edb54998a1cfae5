"""Which column of a file of deliveries is which quantity, and in which unit."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

from clubface import units
from clubface.errors import FileError, UnitError
from clubface.quantities import input_dimensions, inputs

SYNONYMS = {
    "speed": ("club_speed", "clubhead_speed", "club_head_speed", "head_speed"),
    "attack": ("attack_angle", "angle_of_attack", "aoa"),
    "path": ("club_path", "swing_path"),
    "loft": ("dynamic_loft", "dyn_loft", "delivered_loft"),
    "face": ("face_angle", "club_face_angle"),
    "lie": ("lie_tilt",),
    "toe": ("impact_toe", "toe_offset", "impact_offset"),
    "high": ("impact_high", "high_offset", "impact_height"),
    "closure": ("closure_rate", "face_closure"),
    "pitch_rate": ("loft_rate",),
    "lie_rate": (),
    "hand": ("handedness",),
}
"""Other names of the inputs of a delivery, in the words of launch monitors."""

HAND = "hand"


class Column(NamedTuple):
    """A column that is used.

    Attributes
    ----------
    place
        Its place in a row.
    heading
        As in the file.
    quantity
        The input it gives.
    unit
        The unit of its numbers.
    """

    place: int
    heading: str
    quantity: str
    unit: str


class Layout(NamedTuple):
    """What the columns of a file mean.

    Attributes
    ----------
    headings
        Of all columns, as in the file; one without is named after its place.
    used
        The columns that give inputs.
    passed
        Headings of the columns that are only passed through.
    notes
        What a reader of the result should know.
    """

    headings: tuple[str, ...]
    used: tuple[Column, ...]
    passed: tuple[str, ...]
    notes: tuple[str, ...]


def layout(headings: Sequence[str], path: str, line: int | None) -> Layout:
    """Find the inputs among ``headings``; a unit that does not fit, a repeated or missing column is an error."""
    named = tuple(heading.strip() or f"column_{place + 1}" for place, heading in enumerate(headings))
    for place, heading in enumerate(named):
        if heading in named[:place]:
            raise FileError(path, line, f"the column {heading!r} is there twice", heading)
    meanings = known_names()
    used: dict[str, Column] = {}
    passed, notes = [], []
    for place, heading in enumerate(named):
        name, unit = _split(heading, path, line)
        quantity = meanings.get(name)
        if quantity is None:
            passed.append(heading)
            near = _near(name, meanings)
            if near is not None:
                notes.append(f"the column {heading!r} is not used; did you mean {near}?")
            continue
        if quantity in used:
            message = f"the columns {used[quantity].heading!r} and {heading!r} both give the {quantity}"
            raise FileError(path, line, message, heading)
        used[quantity] = Column(place, heading, quantity, _unit_of(quantity, unit, heading, path, line))
        if unit is None and used[quantity].unit != "1":
            notes.append(f"the column {heading!r} names no unit: taken as {used[quantity].unit}")
    if "speed" not in used:
        found = ", ".join(named[:12]) + (", ..." if len(named) > 12 else "")
        message = f'there is no column for the clubhead speed, such as "club_speed_mph"; there are: {found}'
        raise FileError(path, line, message, "speed")
    return Layout(named, tuple(used.values()), tuple(passed), tuple(notes))


def known_names() -> dict[str, str]:
    """Return the input meant by every name a column may have."""
    own = {name: name for name in inputs()}
    return own | {other: name for name, others in SYNONYMS.items() for other in others}


def _split(heading: str, path: str, line: int | None) -> tuple[str, str | None]:
    """Return the name in lower case and the unit of a heading."""
    text = "_".join(heading.replace("-", "_").split()) if "[" not in heading and "(" not in heading else heading
    known = known_names()
    unknown: object = None
    for spelled in (text, text.lower()):
        try:
            name, unit = units.parse_column_name(spelled, known)
        except UnitError as error:
            unknown = error.value
            continue
        if _plain(name) in known:
            return _plain(name), unit
    name = _plain(text.partition("[")[0].partition("(")[0])
    if unknown is not None and name in known:
        allowed = " or ".join(units.symbols(input_dimensions()[known[name]]))
        message = f"the column {heading!r} is in the unknown unit {unknown!r}; it must be in {allowed}"
        raise FileError(path, line, message, heading)
    return _plain(text) if unknown is None else name, None


def _plain(name: str) -> str:
    return "_".join(name.strip().lower().replace("-", "_").split()).strip("_")


def _near(name: str, known: Collection[str]) -> str | None:
    """Return the known name that ``name``, with or without a unit at its end, is most likely a misspelling of."""
    from difflib import get_close_matches

    for each in (name, name.rpartition("_")[0]):
        if len(each) > 3 and (near := get_close_matches(each, known, 1, 0.8)):
            return near[0]
    return None


def _unit_of(quantity: str, unit: str | None, heading: str, path: str, line: int | None) -> str:
    dimension = input_dimensions()[quantity]
    if unit is None:
        return units.SI_UNITS[dimension]
    if units.unit(unit).dimension != dimension:
        allowed = " or ".join(units.symbols(dimension))
        raise FileError(path, line, f"the column {heading!r} is in {unit}; {quantity} must be in {allowed}", heading)
    return unit
