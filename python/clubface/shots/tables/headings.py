"""Quantity and unit of each column in a table of shots, from the words of its heading and the unit behind them.

The words, in many languages, are in ``data/vocabulary.toml``.
"""

from __future__ import annotations

import re
import tomllib
import unicodedata
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any, NamedTuple

from clubface import units
from clubface.errors import FileError, UnitError, shortened
from clubface.quantities import file_unit, quantity as quantity_named
from clubface.results.notes import Note, note
from clubface.simulation.results import flight_outputs, input_dimensions, outputs
from clubface.support.checks import check_choice
from clubface.support.files import DATA
from clubface.units import unit

_WIDE = {code: code - 0xFEE0 for code in range(0xFF01, 0xFF5F)} | {0x3000: " "}
"""Full-width letters, digits and brackets, and the usual ones."""
_GAPS = re.compile(r"(?:[\s,/_–-]|\bin\b)+")
"""Separators between a heading and its unit."""
_BRACKETS = re.compile(r"\s*[\[(]([^\[\]()]*)[\])]\s*$")


@cache
def vocabulary() -> dict[str, Any]:
    """Return the words by subject: units, headings, sides, columns, clubs, summaries, months."""
    return tomllib.loads((DATA / "vocabulary.toml").read_text(encoding="utf-8"))


def by_word(lists: dict[str, list[str]]) -> dict[str, str]:
    """Return the meaning of each word, from the words of each meaning."""
    return {word: meaning for meaning, words in lists.items() for word in words}


WORLD, CLUB = "world", "club"
"""Frames for left and right: the course, or the club, which a left-hander mirrors."""


class Side(NamedTuple):
    """The meaning of a word such as "left" or "open": its sign for a right-hander, in world or club terms."""

    sign: float
    frame: str


FACE_TO_PATH = "face_to_path"
"""Face angle minus path: not a quantity of a shot, but it gives the face angle if the path is known."""
_SIGNS = {"<": Side(-1.0, WORLD), ">": Side(1.0, WORLD), "-": Side(-1.0, CLUB), "+": Side(1.0, CLUB)}


def _sides(groups: list[str]) -> dict[str, Side]:
    lines = (line.split() for each in groups for line in vocabulary()["sides"][each])
    return {word.replace("_", " "): _SIGNS[sign] for sign, *words in lines for word in words}


SIDES: Mapping[str, Mapping[str, Side]] = {name: _sides(groups) for name, groups in vocabulary()["sides"]["of"].items()}
"""The words for the sides of each quantity, the usual ones first."""
MIRRORED = tuple(name for name, words in SIDES.items() if "left" in words)
"""Quantities across the target line: in terms of the club, a left-hander's change their sign."""


_UNITS = by_word(vocabulary()["units"])
_SIDES = "|".join(sorted({re.sub(" ", "[ -]", each) for words in SIDES.values() for each in words}, key=len)[::-1])
_TWO_SIDES = re.compile(rf"(?:^|\s)({_SIDES})([-+])\s*/\s*({_SIDES})([-+])$", re.IGNORECASE)


def plain(text: str) -> str:
    """Return the words of a text in lower case, without punctuation; an underscore separates words like a space."""
    return " ".join(re.findall(r"[^\W_]+", unicodedata.normalize("NFC", text).casefold()))


def squeezed(name: str) -> str:
    """Return plain words without spaces, so that ``BallSpeed`` and ``Ball Speed`` are equal."""
    return name.replace(" ", "")


def units_behind(text: str) -> Iterator[tuple[str, str]]:
    """Yield the ways to split a heading into a plain name and the unit behind it: ``Carry/yd``, ``Spin in rpm``."""
    apart = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)  # ballSpeedMph
    for gap in _GAPS.finditer(apart):
        last = apart[gap.end() :]
        if (len(last) > 1 or last in ("m", "s")) and (symbol := unit_symbol(last)) is not None:
            yield plain(apart[: gap.start()]), symbol


def narrow(text: str) -> str:
    """Return a text with full-width characters replaced by the usual ones."""
    return text if text.isascii() else text.translate(_WIDE)


def bracketed(text: str) -> tuple[str, str | None]:
    """Return the text before the brackets at the end of a heading and the text in them, None without brackets."""
    text = narrow(text)
    match = _BRACKETS.search(text)
    return (text, None) if match is None else (text[: match.start()], match[1].strip())


@lru_cache(maxsize=4096)
def unit_symbol(text: str) -> str | None:
    """Return the symbol of a unit as written by monitors, or None if unknown."""
    spelled = narrow(text).strip().strip("[]()").strip()
    lower = spelled.lower().removesuffix(".")
    for each in (spelled, lower, _UNITS.get(lower, "")):
        try:
            if each:
                return unit(each).symbol
        except UnitError:
            continue
    return None


def unit_of_column(text: str, dimension: str, heading: str, place: tuple[str, int | None]) -> str:
    """Return the symbol of a heading's unit; raise an error if it is unknown or of the wrong dimension."""
    try:
        return unit(unit_symbol(text) or text, name=f"the unit of the column {heading!r}", dimension=dimension).symbol
    except UnitError as error:
        raise FileError(*place, str(error), heading) from None


DELIVERY_QUANTITIES = (
    "speed", "attack", "path", "loft", "face", "lie", "toe", "high", "closure", "pitch_rate", "lie_rate",
    "ball_backspin", "ball_sidespin", "ball_riflespin", "hand",
)  # fmt: skip
"""Delivery inputs, whose synonyms are in the registry of quantities."""
LAUNCH_QUANTITIES = (
    "ball_speed", "smash", "launch", "azimuth", "backspin", "sidespin", "total_spin", "spin_axis", "contact_time",
    "peak_force", "carry", "side", "apex", "flight_time", "landing_angle", "landing_speed", "total", "total_side",
)  # fmt: skip
"""Launch and flight quantities that a table may contain."""
SECOND_CHOICE = frozenset({"carry_flat", "carry_flat_length", "flat_carry"})
"""Names of nearly the same quantity, used only if the file has no better column."""
HAND = "hand"
MOST_NAMED = 12
"""Maximum number of columns named in an error."""


class HeadingParts(NamedTuple):
    """The parts of a heading; bracketed words that are not a unit belong to its name."""

    name: str  # words in lower case, without punctuation
    unit: str | None  # the text of the unit in brackets
    positive: str | None  # the word for the positive side, as in "(deg closed-/open+)"
    bare: str  # words outside brackets: "spin axis" for "Spin Axis (Sim)"


def heading(text: str) -> HeadingParts:
    """Return the parts of a heading such as ``Push/Pull (deg L-/R+)``."""
    before, inner = bracketed(text)
    if inner is None:
        return HeadingParts(plain(text), None, None, plain(text))
    positive = None
    sides = _TWO_SIDES.search(inner)
    if sides:
        inner = inner[: sides.start()].strip()
        positive = plain(sides[1] if sides[2] == "+" else sides[3])
    bare = plain(before)
    is_unit = not inner or unit_symbol(inner) is not None
    return HeadingParts(bare if is_unit else plain(text), inner if inner and is_unit else None, positive, bare)


class KnownHeadings:
    """Known headings in plain words, whatever their spelling and the position of the unit.

    If names are equal without spaces, the first counts; names in ``with_unit`` count only with a unit behind them.
    """

    def __init__(self, names: Iterable[str], with_unit: Collection[str] = ()) -> None:
        self._names = dict.fromkeys(names)
        self._unparted = {squeezed(each): each for each in reversed(self._names)}
        self._with_unit = with_unit
        self._read: dict[str, HeadingParts] = {}

    def spelled(self, name: str) -> str:
        """Return the known heading that differs only in spaces, as for ``clubspeed``; else ``name``."""
        return name if name in self._names else self._unparted.get(squeezed(name), name)

    def parts(self, text: str) -> HeadingParts:
        """Return the parts of a heading; its unit may follow without brackets: ``club_speed_mph``, ``Carry/yd``."""
        if (result := self._read.get(text)) is None:
            result = self._read[text] = self._parts(text)
        return result

    def _parts(self, text: str) -> HeadingParts:
        parts = heading(text)
        if (name := self.spelled(parts.name)) in self._names:
            return parts._replace(name=name)
        if bracketed(text)[1] is None:
            words = "_".join(text.replace("-", "_").split())
            for spelled in (words, words.lower()):
                short, symbol = units.parse_column_name(spelled)
                if symbol is not None and (name := self.spelled(plain(short))) in self._names:
                    return HeadingParts(name, symbol, None, name)
            for before, symbol in units_behind(text):
                if (name := self.spelled(before)) in self._names or name in self._with_unit:
                    return HeadingParts(name, symbol, None, name)
        return parts


@dataclass(frozen=True)
class Vocabulary:
    """The words a table may use."""

    names: Mapping[str, str]  # quantity by column name, in plain words
    dimensions: Mapping[str, str]  # dimension by quantity

    @cached_property
    def headings(self) -> KnownHeadings:
        """The names as headings."""
        return KnownHeadings(self.names)

    def quantity(self, text: str) -> str | None:
        """Return the quantity of a heading, or None."""
        return self.names.get(self.headings.parts(text).name)


def _vocabulary(quantities: Sequence[str], dimensions: Mapping[str, str], others: Mapping[str, str]) -> Vocabulary:
    """Return the words for quantities with these dimensions, with synonyms from the registry."""
    foreign = {name: each for name, each in vocabulary()["headings"].items() if name in dimensions}
    own = {plain(name): name for name in dimensions}
    synonyms = {name: quantity_named(name).synonyms for name in quantities}
    return Vocabulary({**_reversed(foreign), **others, **own, **_reversed(synonyms)}, dimensions)


@cache
def delivery_words() -> Vocabulary:
    """Return the words for the inputs of an impact."""
    return _vocabulary(DELIVERY_QUANTITIES, input_dimensions(), {})


@cache
def shot_words() -> Vocabulary:
    """Return the words for the inputs of an impact and for measured launch and flight quantities."""
    variables = {**flight_outputs(), **outputs()}
    dimensions = {name: variables[name].dimension for name in LAUNCH_QUANTITIES}
    launches = _vocabulary(LAUNCH_QUANTITIES, dimensions, delivery_words().names)
    return Vocabulary(launches.names, {**delivery_words().dimensions, **dimensions})


class FileColumn(NamedTuple):
    """A column in use."""

    place: int  # position in a row
    heading: str  # as in the file
    quantity: str
    unit: str  # symbol of the unit of its numbers
    side: Side = Side(1.0, WORLD)  # the sign of a number without a side, and whether it is in world or club terms
    is_named: bool = True  # whether the unit is from the file, so that the file must be corrected if it is wrong
    is_assumed: bool = False  # whether the unit is only the default of the maker's program


class ColumnLayout(NamedTuple):
    """The columns of a file and their meaning."""

    headings: tuple[str, ...]  # of all columns, as in the file; an unnamed column is named after its position
    used: tuple[FileColumn, ...]  # columns that give inputs
    passed: tuple[str, ...]  # headings of columns that are only passed through
    notes: tuple[Note, ...]


POINTS = {"speed_at": ("cg", "face", "unknown"), "face_at": ("face", "contact", "unknown")}
"""Columns for the reference points of club motion and face angles, with their values, the one models need first. They
are written only for other points."""


def layout(
    headings: Sequence[str],
    path: str,
    line: int | None,
    words: Vocabulary | None = None,
    given_units: Mapping[str, str] | None = None,
    remedy: Callable[[Mapping[str, str]], str] | None = None,
) -> ColumnLayout:
    """Return the quantities among ``headings``; raise an error for a wrong unit or a repeated column.

    ``words`` defaults to the inputs of an impact. ``given_units`` are units, by quantity or dimension, of columns
    without one; an error lists columns that still have none, and the ``remedy``, by default command options.
    """
    given_units = given_units or {}
    words = words or delivery_words()
    named = tuple(heading.strip() or f"column_{place + 1}" for place, heading in enumerate(headings))
    if len(set(named)) < len(named):
        heading = next(each for each, count in Counter(named).items() if count > 1)
        raise FileError(path, line, f"the column {heading!r} is there twice", heading)
    used: dict[str, FileColumn] = {}
    passed, notes = [], []
    without_unit: list[tuple[str, str]] = []
    for place, heading in enumerate(named):
        parts, inner = words.headings.parts(heading), bracketed(heading)[1]
        name, unit = words.headings.spelled(parts.bare), inner or parts.unit
        quantity = words.names.get(name)
        if quantity is None:
            passed.append(heading)
            near = None if plain_name(name) in POINTS else near_name(name, words.names)
            if near is not None:
                notes.append(note("column-misspelled", column=shortened(heading, 80), near=near))
            continue
        if quantity in used:
            message = f"the columns {used[quantity].heading!r} and {heading!r} both give the {quantity}"
            raise FileError(path, line, message, heading)
        dimension = words.dimensions[quantity]
        if unit is not None:
            symbol = unit_of_column(unit, dimension, heading, (path, line))
        else:
            symbol = given_unit(given_units, quantity, dimension)
            if symbol is None and dimension != units.DIMENSIONLESS:
                without_unit.append((heading, quantity))
        used[quantity] = FileColumn(place, heading, quantity, symbol or "1")
    if without_unit:
        raise missing_units(without_unit, path, line, words.dimensions, remedy)
    return ColumnLayout(named, tuple(used.values()), tuple(passed), tuple(notes))


SPIN = ("backspin", "sidespin", "total_spin")
GROUPS = {"spin": ("angular rate", SPIN)}
"""Names for giving the unit of several quantities of one dimension."""


def given_unit(given: Mapping[str, str], quantity: str, dimension: str) -> str | None:
    """Return the unit given for a quantity by name, group or dimension, in this order."""
    groups = (name for name, (_, members) in GROUPS.items() if quantity in members)
    return next((given[name] for name in (quantity, *groups, dimension) if name in given), None)


def check_units(given: Mapping[str, str], dimensions: Mapping[str, str] | None = None) -> dict[str, str]:
    """Return checked units by quantity, group or dimension; ``dimensions`` gives the quantities' dimensions.

    Raises an ``UnknownNameError`` for any other name, and a ``UnitError`` for a unit unknown or of another dimension.
    """
    dimensions = shot_words().dimensions if dimensions is None else dimensions
    groups = {name: dimension for name, (dimension, members) in GROUPS.items() if set(members) & set(dimensions)}
    known = {**{each: each for each in dimensions.values()}, **groups, **dimensions}
    for name, symbol in given.items():
        check_choice("quantity or dimension", name, known)
        units.unit(symbol, name=f"the unit of {name}", dimension=known[name])
    return dict(given)


def missing_units(
    columns: Sequence[tuple[str, str]],
    path: str,
    line: int | None,
    dimensions: Mapping[str, str],
    remedy: Callable[[Mapping[str, str]], str] | None = None,
) -> FileError:
    """Return the error on columns without a unit, given by heading and quantity."""
    options = {}
    for _, quantity in columns:
        dimension = dimensions[quantity]
        unit = heading_of(quantity, units.SI_UNITS[dimension])[1]
        unit = "yd" if unit == "m" else unit
        if quantity in SPIN:
            options["spin"] = unit
        elif options.setdefault(dimension, unit) != unit or " " in dimension:
            options[quantity] = unit
    options = {name: unit for name, unit in options.items() if " " not in name}
    if (shown := [shortened(repr(heading), 40) for heading, _ in columns[:MOST_NAMED]]) and len(columns) > MOST_NAMED:
        shown.append(f"and {len(columns) - MOST_NAMED} more")
    one = len(columns) == 1
    message = (
        f"the column{'s' * (not one)} {', '.join(shown)} name{'s' * one} no unit: give {'it' if one else 'them'}, as "
        f"in {(remedy or _as_options)(options)}, with the units in which the numbers were written"
    )
    return FileError(path, line, message, columns[0][0])


def _as_options(units: Mapping[str, str]) -> str:
    given = " ".join(f"--unit {name}={unit}" for name, unit in units.items())
    return f"{given} (in Python units={units!r} of clubface.shots.read or clubface.predict)"


def require_speed(columns: ColumnLayout, path: str, line: int | None) -> None:
    """Raise an error for a table without clubhead speed, the only input without a default."""
    if all(each.quantity != "speed" for each in columns.used):
        message = f'there is no column for the clubhead speed, such as "club_speed_mph"; {listed(columns.headings)}'
        raise FileError(path, line, message, "speed")


def listed(headings: Sequence[str]) -> str:
    """Return a list of the first dozen columns in words, with unprintable characters as question marks."""
    first = [shortened(heading, 40) for heading in headings[:12]]
    shown = ["".join(each if each.isprintable() else "?" for each in heading) for heading in first]
    return "there are: " + ", ".join(shown) + (", ..." if len(headings) > 12 else "")


def plain_name(name: str) -> str:
    """Return a heading in lower case with underscores between its words."""
    return plain(name).replace(" ", "_").strip("_")


def near_name(name: str, known: Collection[str]) -> str | None:
    """Return the known name that ``name``, with or without a unit at its end, most likely misspells, or None."""
    from difflib import get_close_matches

    for each in (name, name.rpartition(" ")[0]):
        if len(each) > 3 and (near := get_close_matches(each, known, 1, 0.8)):
            return plain_name(near[0])
    return None


def _reversed(synonyms: Mapping[str, Sequence[str]]) -> dict[str, str]:
    return {plain(other): name for name, others in synonyms.items() for other in others}


def heading_of(name: str, si_unit: str) -> tuple[str, str]:
    """Return the heading of a column and its unit."""
    shown = "mph" if si_unit == "m/s" else file_unit(name, si_unit)
    spelled = "club_speed" if name == "speed" else name
    if shown == "1":
        return spelled, shown
    return (f"{spelled}_{shown}" if shown.isalnum() else f"{spelled} [{shown}]"), shown
