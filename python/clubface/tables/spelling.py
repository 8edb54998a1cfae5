"""How the headings of tables are spelled: their words, and the unit in brackets behind them."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from functools import lru_cache

from clubface.errors import FileError, UnitError
from clubface.units import unit

_UNITS = {
    "yards": "yd", "yds": "yd", "yd": "yd", "feet": "ft", "inches": "in", "inch": "in", "meters": "m", "metres": "m",
    "meter": "m", "metre": "m", "deg/sec": "deg/s", "degrees/s": "deg/s", "dps": "deg/s", "°/sec": "deg/s",
    "degs": "deg", "grad": "deg", "graden": "deg", "grados": "deg", "km/u": "km/h", "km/hr": "km/h", "kmph": "km/h",
    "u/min": "rpm", "1/min": "rpm", "tpm": "rpm", "omw/min": "rpm", "sek": "s", "sec": "s",
    **dict.fromkeys(("yard", "yrd", "yrds", "y", "yarda", "yardas", "ヤード", "码", "碼", "야드"), "yd"),
    **dict.fromkeys(("foot", "pieds", "pies", "piedi", "fuß", "フィート", "英尺", "피트"), "ft"),
    **dict.fromkeys(("zoll", "pouces", "pulgadas", "pollici", "インチ"), "in"),
    **dict.fromkeys(("mtr", "mtrs", "mètres", "mètre", "metros", "metri", "メートル", "米", "미터"), "m"),
    **dict.fromkeys(("º", "degré", "degrés", "gradi", "graus", "grader", "aste", "度", "도"), "deg"),
    **dict.fromkeys(("º/s", "grad/s", "grados/s", "度/秒"), "deg/s"),
    **dict.fromkeys(("m.p.h", "mi/h", "miles/h", "英里/小时", "英里/小時"), "mph"),
    **dict.fromkeys(("km/t", "kph", "kmh", "㎞/h", "公里/小时", "公里/小時"), "km/h"),
    **dict.fromkeys(("m/sec", "mps", "m/秒", "米/秒", "㎧"), "m/s"),
    **dict.fromkeys(("rev/min", "r/min", "tr/min", "giri/min", "upm", "v/min", "回転/分", "转/分", "轉/分"), "rpm"),
    **dict.fromkeys(("varv/min", "tr/mn"), "rpm"),
    **dict.fromkeys(("seconds", "secs", "秒", "초"), "s"),
}  # fmt: skip
"""Further spellings of units in the files of launch monitors and spreadsheets, without a point at the end."""

_WIDE = {code: code - 0xFEE0 for code in range(0xFF01, 0xFF5F)} | {0x3000: " "}
"""The letters, digits and brackets that take the width of a Chinese character, and the usual ones."""
_GAPS = re.compile(r"(?:[\s,/_–-]|\bin\b)+")
"""What stands between a heading and its unit."""
_BRACKETS = re.compile(r"\s*[\[(]([^\[\]()]*)[\])]\s*$")


def plain(text: str) -> str:
    """Return the words of a text in lower case, without punctuation; an underscore parts words as a space does."""
    return " ".join(re.findall(r"[^\W_]+", unicodedata.normalize("NFC", text).casefold()))


def squeezed(name: str) -> str:
    """Return plain words without the spaces between them, in which ``BallSpeed`` and ``Ball Speed`` are the same."""
    return name.replace(" ", "")


def words_apart(text: str) -> str:
    """Return a text in which small and large letters begin words, ``ballSpeedMph``, with spaces between them."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)


def units_behind(text: str) -> Iterator[tuple[str, str]]:
    """Yield how a heading may part into a name in plain words and the unit behind it: ``Carry/yd``, ``Spin in rpm``."""
    apart = words_apart(text)
    for gap in _GAPS.finditer(apart):
        last = apart[gap.end() :]
        if (len(last) > 1 or last in ("m", "s")) and (symbol := unit_symbol(last)) is not None:
            yield plain(apart[: gap.start()]), symbol


def narrow(text: str) -> str:
    """Return a text with usual letters for those that take the width of a Chinese character."""
    return text if text.isascii() else text.translate(_WIDE)


def bracketed(text: str) -> tuple[str, str | None]:
    """Return what stands before the brackets at the end of a heading, and what in them; None where there are none."""
    text = narrow(text)
    found = _BRACKETS.search(text)
    return (text, None) if found is None else (text[: found.start()], found[1].strip())


@lru_cache(maxsize=4096)
def unit_symbol(text: str) -> str | None:
    """Return the symbol of the unit that a monitor writes as ``text``, or None for an unknown one."""
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
    """Return the symbol of the unit that a heading names; one that is unknown or does not fit is an error."""
    try:
        return unit(unit_symbol(text) or text, name=f"the unit of the column {heading!r}", dimension=dimension).symbol
    except UnitError as error:
        raise FileError(*place, str(error), heading) from None
