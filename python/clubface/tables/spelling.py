"""How the headings of tables are spelled: their words, and the unit in brackets behind them."""

from __future__ import annotations

import re
import unicodedata

from clubface.errors import FileError, UnitError
from clubface.units import unit

_UNITS = {
    "yards": "yd", "yds": "yd", "yd": "yd", "feet": "ft", "inches": "in", "inch": "in", "meters": "m", "metres": "m",
    "meter": "m", "metre": "m", "deg/sec": "deg/s", "degrees/s": "deg/s", "dps": "deg/s", "°/sec": "deg/s",
    "degs": "deg", "grad": "deg", "graden": "deg", "grados": "deg", "km/u": "km/h", "km/hr": "km/h", "kmph": "km/h",
    "u/min": "rpm", "1/min": "rpm", "tpm": "rpm", "omw/min": "rpm", "sek": "s", "sec.": "s",
}  # fmt: skip
"""Further spellings of units in the files of launch monitors and spreadsheets."""

_BRACKETS = re.compile(r"\s*[\[(]([^\[\]()]*)[\])]\s*$")


def plain(text: str) -> str:
    """Return the words of a text in lower case, without punctuation; an underscore parts words as a space does."""
    return " ".join(re.findall(r"[^\W_]+", unicodedata.normalize("NFC", text).casefold()))


def bracketed(text: str) -> tuple[str, str | None]:
    """Return what stands before the brackets at the end of a heading, and what in them; None where there are none."""
    found = _BRACKETS.search(text)
    return (text, None) if found is None else (text[: found.start()], found[1].strip())


def unit_symbol(text: str) -> str | None:
    """Return the symbol of the unit that a monitor writes as ``text``, or None for an unknown one."""
    spelled = text.strip().strip("[]()").strip()
    for each in (spelled, spelled.lower(), _UNITS.get(spelled.lower(), "")):
        try:
            if each:
                return unit(each).symbol
        except UnitError:
            continue
    return None


def unit_of_column(text: str, dimension: str, heading: str, place: tuple[str, int | None]) -> str:
    """Return the symbol of the unit that a heading names; one that is unknown or does not fit is an error."""
    try:
        return unit(unit_symbol(text) or text, name=f"the unit of the column {heading!r}", dimension=dimension).symbol
    except UnitError as error:
        raise FileError(*place, str(error), heading) from None
