"""Dates as monitors write them, as ISO text: ``05/02/24 10:21:11 AM`` is ``2024-05-02T10:21:11``."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from datetime import date, datetime, time

_MONTH_NAMES = """
jan january januar janvier enero gennaio januari janeiro ene gen
feb february februar février fevrier febrero febbraio februari fevereiro fév
mar march märz mars marzo maart março mär mrz
apr april avril abril aprile avr abr
may mai mayo maggio mei maj maio
jun june juni juin junio giugno junho giu
jul july juli juillet julio luglio julho lug
aug august août aout agosto augustus augusti ago
sep sept september septembre septiembre settembre setembro set
oct october oktober octobre octubre ottobre outubro okt ott out
nov november novembre noviembre novembro
dec december dezember décembre decembre diciembre dicembre dezembro dez dic
"""
MONTHS = {name: number for number, names in enumerate(_MONTH_NAMES.strip().splitlines(), 1) for name in names.split()}
_CLOCK = re.compile(r"(?<!\d)(\d{1,2}):(\d{2})(?::(\d{2})(?:[.,]\d+)?)?\s*([ap]\.?\s?m\.?)?", re.IGNORECASE)
_YEAR_FIRST = re.compile(r"(?<!\d)(\d{4})[-/.年년\s]\s*(\d{1,2})[-/.月월\s]\s*(\d{1,2})(?!\d)")
_YEAR_LAST = re.compile(r"(?<!\d)(\d{1,2})\s?([-/.])\s?(\d{1,2})\s?\2\s?(\d{4}|\d{2})(?!\d)")
_NAMED = re.compile(
    r"(?<!\d)(?:(\d{1,2})(?:st|nd|rd|th)?\.?[\s-]*(?:de\s+)?([^\W\d_]{3,})|([^\W\d_]{3,})\.?\s+(\d{1,2})(?:st|nd|rd|th)?)"
    r"\.?,?[\s-]+(?:de\s+)?(\d{4})"
)
_COMPACT = re.compile(r"(20\d{2})(\d{2})(\d{2})(?:[T_-]?(\d{2})(\d{2})(\d{2})?)?")


def iso_dates(texts: Sequence[str]) -> tuple[list[str], str | None]:
    """Return dates, with time where there is one, as ISO text, and a note where their order is not certain.

    A text that is no date stays as it is. Whether day or month comes first is decided by the dates of all texts; where
    all could be either, points stand for the day first and strokes for the month.
    """
    different = dict.fromkeys(texts)
    day_first, is_certain = _order(different)
    known = {text: _iso(text, day_first) or text for text in different}
    note = None
    if not is_certain:
        text = next(each for each in different if _YEAR_LAST.search(each))
        note = f"the date {text!r} was read as {known[text][:10]}, with the {'day' if day_first else 'month'} first"
    return [known[each] for each in texts], note


def date_among(cells: Iterable[str]) -> str | None:
    """Return the first date among the cells of a row, as it stands there; None where there is none."""
    return next((cell.strip() for cell in cells if _iso(cell, day_first=False) or _iso(cell, day_first=True)), None)


def _order(texts: Iterable[str]) -> tuple[bool, bool]:
    """Return whether the day comes before the month, and whether that is certain."""
    found = [match for text in texts if not _YEAR_FIRST.search(text) and (match := _YEAR_LAST.search(text))]
    if any(int(match[1]) > 12 for match in found):
        return True, True
    if any(int(match[3]) > 12 for match in found):
        return False, True
    if not found:
        return False, True
    if any("m" in (clock[4] or "").lower() for match in found if (clock := _CLOCK.search(match.string))):
        return False, True
    return found[0][2] == ".", found[0][2] == "." or all(match[1] == match[3] for match in found)


def _iso(text: str, day_first: bool) -> str | None:
    if match := _YEAR_FIRST.search(text):
        parts = [int(each) for each in match.groups()]
    elif match := _YEAR_LAST.search(text):
        first, second, year = int(match[1]), int(match[3]), int(match[4])
        parts = [year if year > 99 else 2000 + year, *((second, first) if day_first else (first, second))]
    elif (match := _NAMED.search(text)) and (month := MONTHS.get((match[2] or match[3]).lower())):
        parts = [int(match[5]), month, int(match[1] or match[4])]
    elif match := _COMPACT.fullmatch(text.strip()):
        parts = [int(each) for each in match.groups()[:3]]
    else:
        return None
    try:
        day = date(*parts)
        clock = _CLOCK.search(text)
        if clock is None:
            return day.isoformat()
        hour = int(clock[1]) % 12 + 12 * (clock[4][0] in "pP") if clock[4] else int(clock[1])
        return datetime.combine(day, time(hour, int(clock[2]), int(clock[3] or 0))).isoformat()
    except ValueError:
        return None
