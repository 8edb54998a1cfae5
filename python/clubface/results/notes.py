"""Notes of a result: a code, its data, and the sentence that the catalogue makes from them."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from string import Formatter
from typing import Any, NamedTuple

from clubface.errors import UnknownNameError
from clubface.quantities import Quantity, bare_value, format_value, quantity as quantity_named, with_unit
from clubface.results.catalogue import SENTENCES
from clubface.results.table import Column

MOST_RANGES = 4
"""Maximum number of ranges of whole numbers listed in a sentence."""
_PLACES = {
    "at_line": "line {{at_line}}: {}",
    "at_row": "row {{at_row}}: {}",
    "in_shots": "{} (in {{in_shots}} of {{of_shots:n shot}})",
    "in_files": "{{in_files}}: {}",
}
"""Extensions of a sentence by the place to which it applies."""
_WORDS = re.compile(r"(?P<more>[^/]+)/(?P<less>[^/]+?)(?:/(?P<none>[^/]+?))?(?: (?P<digits>\d+))?")


class Note(NamedTuple):
    """A remark on a result.

    Attributes
    ----------
    code
        Code of its sentence in the catalogue, such as "outside-aerodynamic-data".
    data
        Data of the sentence: texts, whole numbers, lists, SI values under names that end in a quantity, and mappings
        from names to any of these. Any note may also give the place to which it applies: files (``in_files``), a line
        or row (``at_line``, ``at_row``), or a number of shots (``in_shots``) out of all (``of_shots``).
    """

    code: str
    data: Mapping[str, Any] = {}

    def __str__(self) -> str:
        return self.sentence

    def __hash__(self) -> int:
        return hash(self.code)

    @property
    def sentence(self) -> str:
        """The sentence in display units."""
        text = SENTENCES[self.code]
        for name, place in _PLACES.items():
            if name in self.data:
                text = place.format(text)
        return _SENTENCE.vformat(text, (), self.data)

    def of(self, **data: Any) -> Note:
        """Return the note with additional data, such as ``in_files``."""
        return self._replace(data={**self.data, **data})

    def to_dict(self) -> dict[str, Any]:
        """Return code, data in metric units, and sentence."""
        return {"code": self.code, "data": dict(map(_metric, self.data, self.data.values())), "text": self.sentence}


def note(code: str, **data: Any) -> Note:
    """Return a note; its code must be in the catalogue, and ``data`` must hold everything that the sentence needs."""
    if code not in SENTENCES:
        raise UnknownNameError("note", code, SENTENCES)
    return Note(code, {key: each.item() if hasattr(each, "item") else each for key, each in data.items()})


def free_text(sentences: Sequence[str]) -> list[Note]:
    """Return sentences from another source, such as the caveats in a parameter file, as notes."""
    return [Note("text", {"text": each}) for each in dict.fromkeys(sentences)]


def placeholders(code: str) -> set[str]:
    """Return the names of the data required by a sentence."""
    return {name for _, name, _, _ in Formatter().parse(SENTENCES[code]) if name}


class _Sentence(Formatter):
    """Formats the data of a note in display units.

    ``{carry}`` has unit and digits of the quantity, ``{carry:0}`` other digits, ``{carry:m 1}`` another unit,
    ``{carry:bare}`` no unit; ``{side:sides}`` gives "3.2 yd right", ``{speed:faster/slower}`` "1.2 mph faster", with a
    third word for a value that is zero to the digits shown; "#" in a word is replaced by the value, as in
    ``{curve:curves # right/curves # left/flies straight}``; ``{shots:n shot}`` counts ("1 shot", "3 shots"),
    ``{shots:?was/were}`` agrees with a count. A list is joined by commas, or as given by ``{names:and}`` or
    ``{names:;}``; ``{names:labels}`` lists the labels of quantities; ``{names:3}`` lists three and counts the rest, and
    ``{frames:ranges}`` gives "3, 7-12". A mapping lists quantities with their labels ("launch angle 12.1 deg"), with
    signs and without zeros for ``{figures:changes}``, without labels for ``{figures:values}``; a pair of numbers in it
    is a value with its standard deviation, a whole number is a count ("3 Measured"), and a text goes in brackets
    ("Carry (yd)"). Any other format is Python's, applied to the bare number.
    """

    def get_value(self, key: int | str, args: Sequence[Any], kwargs: Mapping[str, Any]) -> Any:
        return str(key), kwargs[str(key)]

    def convert_field(self, value: Any, conversion: str | None) -> Any:
        return value

    def format_field(self, value: Any, format_spec: str) -> str:
        name, given = value
        if isinstance(given, Mapping):
            return _list_entries(given, format_spec)
        if isinstance(given, (list, tuple)) and format_spec.startswith("?"):
            given = len(given)
        if isinstance(given, (list, tuple)) and format_spec == "labels":
            return _join_texts([_label(str(each)) for each in given], "and")
        if isinstance(given, (list, tuple)):
            return _join_texts([str(each) for each in given], format_spec)
        if given is None or isinstance(given, (str, bool)):
            return "" if given is None else str(given)
        if format_spec.startswith("n "):
            word = format_spec[2:]
            return f"{given} {word if given == 1 else _plural(word)}"
        if format_spec.startswith("?"):
            return format_spec[1:].split("/")[given != 1]
        if isinstance(given, int) and not format_spec:
            return str(given)
        quantity = _quantity_of(name)
        if quantity is None or format_spec[:1] in (".", "+", ","):
            return format(given, format_spec) if format_spec else f"{given:g}"
        return quantity_text(float(given), quantity, format_spec)


_SENTENCE = _Sentence()


def quantity_text(value: float, quantity: Quantity, spec: str = "") -> str:
    """Return an SI value as text; ``spec`` is its format in a sentence, such as "0", "sides 0" or "faster/slower"."""
    if words := _WORDS.fullmatch(spec):
        size = format_value(abs(value), quantity, digits=None if words["digits"] is None else int(words["digits"]))
        if words["none"] is not None and _is_zero(size):
            return words["none"]
        word = words["more"] if value > 0.0 else words["less"]
        return word.replace("#", size) if "#" in word else f"{size} {word}"
    kind, _, digits = spec.rpartition(" ") if " " in spec or spec.isdigit() else (spec, "", "")
    places = int(digits) if digits else None
    if kind == "sides":
        size = format_value(abs(value), quantity, digits=places)
        return size if _is_zero(size) else f"{size} {(quantity.sides or ('below', 'above'))[value > 0.0]}"
    if kind == "bare":
        return bare_value(value, quantity, digits=places)
    return format_value(value, quantity, kind or None, places)


def entry_text(name: str, value: Any) -> str:
    """Return a named quantity as text, such as "launch angle 12.1 deg"."""
    if isinstance(value, str):
        return f"{name} ({value})"
    if isinstance(value, int):
        return f"{value} {name}"
    known = quantity_named(name)
    if not isinstance(value, (list, tuple)):
        return f"{known.label} {format_value(value, known)}"
    numbers = " ± ".join(bare_value(each, known) for each in value)
    return f"{known.label} {with_unit(numbers, known.reading.unit)}"


def _quantity_of(name: str) -> Quantity | None:
    try:
        return quantity_named(name)
    except UnknownNameError:
        return None


def _label(name: str) -> str:
    quantity = _quantity_of(name)
    return name.replace("_", " ") if quantity is None else quantity.label


def _is_zero(text: str) -> bool:
    return not text.split(" ")[0].strip("-0.%")


def _list_entries(values: Mapping[str, Any], spec: str) -> str:
    """Return the entries of a mapping as a list in words; ``spec`` is their format."""
    if spec not in ("changes", "values"):
        return _join_texts(list(map(entry_text, values, values.values())), spec)
    texts = []
    for name, value in values.items():
        quantity = quantity_named(name)
        text = format_value(value, quantity)
        if spec == "values":
            texts.append(text)
        elif not _is_zero(text):
            texts.append(f"{quantity.label} {text if text.startswith('-') else f'+{text}'}")
    return _join_texts(texts, "and") or "nothing to speak of"


def _metric(name: str, value: Any) -> tuple[str, Any]:
    """Return a name with its metric unit, and the value in that unit; anything but a quantity is returned unchanged."""
    if isinstance(value, Mapping):
        return name, dict(map(_metric, value, value.values()))
    if isinstance(value, (list, tuple)) and value and all(isinstance(each, float) for each in value):
        pairs = [_metric(name, each) for each in value]
        return pairs[0][0], [each for _, each in pairs]
    if isinstance(value, float) and (quantity := _quantity_of(name)) is not None:
        column = Column(name, [value], quantity)
        return column.key, column.exact(0)
    if isinstance(value, float) and not math.isfinite(value):
        return name, None
    return name, list(value) if isinstance(value, tuple) else value


def _join_texts(texts: Sequence[str], word: str) -> str:
    if word == "ranges":
        texts, word = _ranges([*map(int, texts)]), str(MOST_RANGES)
    if word.isdigit():
        more = len(texts) - int(word)
        return ", ".join(texts[: int(word)]) + (f" and {more} more" if more > 0 else "")
    if word in ("and", "or") and len(texts) > 1:
        return f"{', '.join(texts[:-1])} {word} {texts[-1]}"
    return ("; " if word == ";" else ", ").join(texts)


def _ranges(numbers: Sequence[int]) -> list[str]:
    """Return ascending numbers as ranges: "3", "7-12"."""
    runs: list[list[int]] = []
    for each in numbers:
        if runs and each == runs[-1][1] + 1:
            runs[-1][1] = each
        else:
            runs.append([each, each])
    return [str(first) if first == last else f"{first}-{last}" for first, last in runs]


def _plural(word: str) -> str:
    if word.endswith("y") and word[-2:-1] not in "aeiou":
        return f"{word[:-1]}ies"
    return f"{word}es" if word.endswith(("s", "x", "ch", "sh")) else f"{word}s"
