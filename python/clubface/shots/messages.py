"""Messages of launch monitors over a socket, for all protocols: content, numbers, and framing.

A stream of bytes may be split anywhere, so the end of each JSON object has to be found.
"""

from __future__ import annotations

import json
import math
import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from clubface.errors import AssumptionWarning, ClubfaceError, shortened
from clubface.results.notes import Note, note
from clubface.shots.plausibility import impossible, impossible_note, shown, within_turn
from clubface.simulation.spin import AXIS, BACK, DIMENSIONS, SIDE, SPINS, TOTAL, complete, parts
from clubface.support.checks import warn_once
from clubface.units import from_si, parse, to_si, unit

if TYPE_CHECKING:
    from clubface.shots.recorded import RecordedShots

LARGEST_NUMBER = 1e9
"""Limit that no number in a message reaches, except placeholders for values not measured."""
LARGEST_VALUE = 1e39
"""Limit for placeholders; the largest four-byte float is 3.4e38."""
PROTOCOLS = {"open-connect": "Open Connect", "flight-relay": "Flight Relay", "opengolfsim": "OpenGolfSim"}
"""Readable names of the protocols."""
LISTED = 10
"""Maximum number of message notes listed for a session, the most frequent first."""


class MessageError(ClubfaceError, ValueError):
    """An invalid message; the text names the field at fault and is sent back."""


@dataclass(frozen=True, kw_only=True)
class Message:
    """The content of a launch monitor's message, in SI units.

    Attributes
    ----------
    kind
        "shot", "heartbeat" or "status".
    device, shot_number
        Name and shot number given by the sender; number 0 if none.
    delivery, launch
        Inputs of an impact, and quantities of the launch, by name; empty if club or ball were not measured.
    impossible, notes
        Impossible values, which are left out of both; other parts that were left out, and why.
    is_ready, sees_ball
        The monitor's reported state; None if it reports none.
    identity
        Unique identifier of the shot, if the protocol gives one.
    """

    kind: str
    device: str
    shot_number: int = 0
    delivery: Mapping[str, float] = field(default_factory=dict)
    launch: Mapping[str, float] = field(default_factory=dict)
    impossible: Mapping[str, float] = field(default_factory=dict)
    notes: tuple[Note, ...] = ()
    is_ready: bool | None = None
    sees_ball: bool | None = None
    identity: str = ""


def shot_message(raw: Message) -> Message:
    """Return the message without impossible values, with all spins that can be derived; an error if nothing is left."""
    if not raw.launch and not raw.delivery:
        raise MessageError("; ".join(["the message holds no value of a shot", *map(str, raw.notes)]))
    wrong = impossible({**raw.delivery, **raw.launch})
    launch, delivery = (
        {name: value for name, value in each.items() if name not in wrong} for each in (raw.launch, raw.delivery)
    )
    if not launch and not delivery:
        raise MessageError(f"no shot can have such values: {', '.join(wrong)}")
    spins = complete({name: np.array([launch[name]]) for name in SPINS if name in launch})
    known = {name: float(values[0]) for name, values in spins.values.items() if not np.isnan(values[0])}
    rest = {name: float(within_turn(name, value)) for name, value in launch.items() if name not in SPINS}
    notes = (*raw.notes, *(each.note for each in spins.contradictions), *spins.notes)
    return replace(raw, delivery=delivery, launch=rest | known, impossible=wrong, notes=notes)


class ValuesNotTaken:
    """Reports values left out of shots, each only once: a monitor without spin sends zero with every shot."""

    def __init__(self) -> None:
        self._reported: set[tuple[str, float] | Note] = set()

    def sentences(self, message: Message) -> Iterator[str]:
        """Yield a sentence for each new impossible value or note of a message."""
        shot = f"shot {message.shot_number}" if message.shot_number else "a shot"
        new = [each for each in message.impossible.items() if each not in self._reported]
        if new:
            values = ", ".join(f"{name} of {shown(name, value)}" for name, value in new)
            yield f"{shot}: no shot can have {values}: treated as not measured"
        remarks = [each for each in message.notes if each not in self._reported]
        yield from (f"{shot}: {each}" for each in remarks)
        self._reported.update(new, remarks)


def numbers_of(
    data: Mapping[str, Any], names: Iterable[str], where: str, notes: list[Note], needed: Collection[str] = ()
) -> dict[str, float]:
    """Return the fields that hold a number; null means not measured.

    A field with anything else gets a note; a ``needed`` field without a number raises a :class:`MessageError`.
    """
    result = {}
    for name in names:
        if data.get(name) is None and name not in needed:
            continue
        try:
            result[name] = number_of(data, name, where, LARGEST_VALUE)
        except MessageError:
            if name in needed:
                raise
            notes.append(note("message-field-no-number", field=f"{where}{name}", value=shortened(repr(data[name]), 40)))
    return result


def number_of(data: Mapping[str, Any], name: str, where: str, largest: float = LARGEST_NUMBER) -> float:
    """Return a field that must hold a number, or a number as text."""
    result = data.get(name)
    try:
        is_none = isinstance(result, bool) or result is None or (isinstance(result, str) and "_" in result)
        number = math.nan if is_none else float(result)  # pyright: ignore[reportArgumentType]
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not abs(number) < largest:
        raise MessageError(f"{where}{name} must be a number" if result is not None else f"{where}{name} is missing")
    return number


def object_of(data: Mapping[str, Any], name: str) -> Mapping[str, Any]:
    """Return a field that must hold an object."""
    result = data.get(name)
    if not isinstance(result, Mapping):
        raise MessageError(f"{name} is missing" if result is None else f"{name} must be an object")
    return result


def in_si(given: Mapping[str, float], fields: Mapping[str, tuple[str, str]]) -> dict[str, float]:
    """Return the values of fields in SI by quantity; ``fields`` gives quantity and unit of each field."""
    return {fields[name][0]: to_si(value, fields[name][1]) for name, value in given.items()}


def in_units(values: Mapping[str, Any], fields: Mapping[str, tuple[str, str]]) -> dict[str, float]:
    """Return the fields of a message in their units, from SI values or texts with units; NaN is left out."""
    result = {}
    for name, (quantity, symbol) in fields.items():
        if values.get(quantity) is not None:
            number = _si_number(values[quantity], quantity, unit(symbol).dimension)
            if not math.isnan(number):
                result[name] = float(from_si(number, symbol))
    return result


def whole_spin(launch: Mapping[str, Any]) -> dict[str, float]:
    """Return all four spin quantities of a launch [rad/s, rad]; warn about assumptions."""
    given = {name: _si_number(launch[name], name, DIMENSIONS[name]) for name in SPINS if launch.get(name) is not None}
    back, side, assumed = parts({name: value for name, value in given.items() if not math.isnan(value)})
    if assumed:
        warn_once(assumed, AssumptionWarning)
    return {BACK: back, SIDE: side, TOTAL: math.hypot(back, side), AXIS: math.atan2(side, back)}


def _si_number(value: Any, name: str, dimension: str) -> float:
    """Return a number in SI; NaN, for not measured, is allowed."""
    return value if isinstance(value, float) and math.isnan(value) else parse(value, dimension, name=name)


def recorded(messages: Iterable[Message], *, hand: str | None = None, protocol: str = "open-connect") -> RecordedShots:
    """Return the shots among the messages as :class:`RecordedShots`; ``rows`` are the shot numbers.

    ``protocol`` is the protocol of the messages. Notes count impossible values and list what else was left out.
    """
    from clubface.shots.recorded import RecordedShots

    shots = [each for each in messages if each.kind == "shot"]

    def columns(parts_of_shots: Sequence[Mapping[str, float]]) -> dict[str, Any]:
        names = dict.fromkeys(name for each in parts_of_shots for name in each)
        return {name: np.array([each.get(name, math.nan) for each in parts_of_shots]) for name in names}

    wrong = {name: values[~np.isnan(values)] for name, values in columns([each.impossible for each in shots]).items()}
    notes = Counter(remark for each in shots for remark in each.notes)
    return RecordedShots(
        deliveries=columns([each.delivery for each in shots]),
        launches=columns([each.launch for each in shots]),
        hand=None if hand is None else np.array([hand] * len(shots), dtype=object),
        rows=np.array([each.shot_number for each in shots], dtype=np.int64),
        source=PROTOCOLS.get(protocol, protocol),
        format=protocol,
        notes=(
            *(impossible_note(name, len(values), len(shots), float(values[0])) for name, values in wrong.items()),
            *(each.of(in_shots=count, of_shots=len(shots)) for each, count in notes.most_common(LISTED)),
            *([note("messages-more", more=len(notes) - LISTED)] if len(notes) > LISTED else []),
        ),
    )


LARGEST = 65_536
"""Maximum size of a message [bytes]; Open Connect messages have less than 2000."""
DEEPEST = 16
"""Maximum nesting depth; Open Connect has two levels."""
_SPACE = b" \t\r\n\x00"
_MARK = re.compile(rb'"(?:[^"\\]|\\.)*+(?P<text_ends>"?)|[\[{]|[\]}]', re.DOTALL)
"""A text, possibly unfinished, or the beginning or end of an object or list."""


class Broken(NamedTuple):
    """Why some bytes are not a message."""

    reason: str


class ObjectStream:
    """Collects bytes and returns the JSON objects in them, each as soon as its last brace has arrived."""

    def __init__(self) -> None:
        self.drop()

    def drop(self) -> None:
        """Discard an unfinished message; the next bytes begin a new one."""
        self._held = b""
        self._seen = self._depth = 0
        self._in_garbage = False

    @property
    def is_partial(self) -> bool:
        """Whether a message has begun and not ended."""
        return self._depth > 0

    def feed(self, data: bytes) -> list[dict[str, Any] | Broken]:
        """Return the messages that ``data`` completes, and a :class:`Broken` for bytes that are not a message."""
        self._held += data
        result: list[dict[str, Any] | Broken] = []
        while self._held:
            if self._depth == 0:
                before, brace, rest = self._held.partition(b"{")
                if (garbage := before.strip(_SPACE)) and not self._in_garbage:
                    result.append(Broken(f"no JSON object begins with {chr(garbage[0])!r}"))
                self._in_garbage = not brace and (self._in_garbage or bool(garbage))
                self._held, self._seen, self._depth = brace + rest, len(brace), len(brace)
                continue
            self._scan()
            if self._seen > LARGEST or self._depth > DEEPEST:
                result.append(Broken(f"a message longer than {LARGEST} bytes or deeper than {DEEPEST} levels"))
                self._held, self._depth, self._in_garbage = self._held[min(self._seen, LARGEST) :], 0, True
            elif self._depth == 0:
                result.append(_parsed(self._held[: self._seen]))
                self._held = self._held[self._seen :]
            else:
                break
        return result

    def _scan(self) -> None:
        """Advance to the end of the object or of the data; an unfinished text is scanned again later."""
        while 0 < self._depth <= DEEPEST:
            mark = _MARK.search(self._held, self._seen)
            if mark is None or mark["text_ends"] == b"":
                if mark is None or len(self._held) > LARGEST:
                    self._seen = len(self._held)
                return
            self._seen = mark.end()
            if mark["text_ends"] is None:
                self._depth += 1 if mark[0] in b"{[" else -1


def _parsed(text: bytes) -> dict[str, Any] | Broken:
    try:
        result = json.loads(text.decode("utf-8"))
    except UnicodeDecodeError:
        return Broken("not UTF-8 text")
    except (ValueError, RecursionError) as error:
        return Broken(f"not JSON: {error}")
    return result if isinstance(result, dict) else Broken("no JSON object")
