"""Live shots: each is written to disk before it is shown, so that a killed server resumes with all of them.

A file of live shots has one JSON object per line: a shot as received, in SI units, or the player's choice of club and
hand for the following shots. The next process removes only a line cut off when a process died: it was not acknowledged.
"""

from __future__ import annotations

import json
import math
import os
import threading
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from clubface.equipment.clubs import CLUB_NAMES
from clubface.equipment.described import HANDS
from clubface.errors import FileError
from clubface.jobs.lock import Lock
from clubface.results.notes import Note
from clubface.results.result import Result
from clubface.shots.messages import PROTOCOLS, Message, recorded
from clubface.shots.recorded import RecordedShots
from clubface.shots.shot_list import shot_list_result
from clubface.shots.tables.headings import HAND, LAUNCH_QUANTITIES
from clubface.simulation.results import inputs
from clubface.support.checks import check_choice, check_names
from clubface.support.files import unreadable, unwritable

DELIVERY = tuple(name for name in inputs() if name != HAND)
"""Club quantities a monitor may measure."""
BINARY = getattr(os, "O_BINARY", 0)
"""Without it Windows would end each line in two characters."""
LARGEST = 200_000_000
"""Maximum size of a file of live shots [bytes], some hundred thousand shots."""


class Player(NamedTuple):
    """The player's choice of built-in club and hand, which monitors do not report."""

    club: str = "driver"
    hand: str = "right"


class LiveShot(NamedTuple):
    """A shot that a monitor sent."""

    number: int  # position in the file, from 1
    received: str  # time received, ISO text in UTC
    protocol: str  # protocol of the message
    player: Player  # the club and hand chosen at the time
    message: Message  # what the monitor sent


class LiveShots:
    """The shots of a file, to which live shots are added; the file is created if it does not exist.

    Raises a ``FileError`` if another process writes it, it cannot be written, or it is not a file of live shots.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        self._shots: list[LiveShot] = []
        self._identities: set[str] = set()
        self._listeners: list[Callable[[], object]] = []
        self._changed = threading.RLock()
        self._player = Player()
        self._lock = Lock(Path(f"{path}.lock"), self.path)
        try:
            self.damaged = self._read()
            self._file = os.open(self.path, os.O_WRONLY | os.O_APPEND | os.O_CREAT | BINARY, 0o666)
        except OSError as error:
            self._lock.close()
            raise unwritable(self.path, error) from None
        except BaseException:
            self._lock.close()
            raise

    @property
    def shots(self) -> Sequence[LiveShot]:
        """All shots, in the order received."""
        return self.since(0)

    def since(self, number: int) -> Sequence[LiveShot]:
        """Return the shots after the one with this number."""
        with self._changed:
            return tuple(self._shots[max(number, 0) :])

    @property
    def player(self) -> Player:
        """The player's current choice, for the next shots."""
        return self._player

    def choose(self, club: str, hand: str) -> None:
        """Choose club and hand for the next shots."""
        check_choice("club", club, CLUB_NAMES)
        check_choice("hand", hand, HANDS)
        with self._changed:
            self._append({"club": club, "hand": hand})
            self._player = Player(club, hand)
        self._notify()

    def keep(self, message: Message, protocol: str) -> LiveShot | None:
        """Write a shot to disk, then notify all listeners; None for one sent before. May raise a ``FileError``."""
        with self._changed:
            if self._is_known(message, protocol):
                return None
            received = datetime.now(UTC).isoformat(timespec="milliseconds")
            shot = LiveShot(len(self._shots) + 1, received, protocol, self._player, message)
            self._append(_record(shot))
            self._add(shot)
        self._notify()
        return shot

    def subscribe(self, listener: Callable[[], object]) -> Callable[[], None]:
        """Call a function after every change, on the thread that made it; return a function that unsubscribes."""
        with self._changed:
            self._listeners.append(listener)

        def end() -> None:
            with self._changed:
                if listener in self._listeners:
                    self._listeners.remove(listener)

        return end

    def close(self) -> None:
        """Close the file and release its lock."""
        os.close(self._file)
        self._lock.close()

    def _notify(self) -> None:
        for each in tuple(self._listeners):
            each()

    def _add(self, shot: LiveShot) -> None:
        self._shots.append(shot)
        if shot.message.identity:
            self._identities.add(shot.message.identity)

    def _is_known(self, message: Message, protocol: str) -> bool:
        """Return whether a monitor is resending a shot, as after a lost acknowledgement."""
        if message.identity:
            return message.identity in self._identities
        if message.shot_number == 0:
            return False
        last = next((each for each in reversed(self._shots) if each.message.device == message.device), None)
        same = ("shot_number", "delivery", "launch")
        return last is not None and (protocol, *(getattr(message, name) for name in same)) == (
            last.protocol, *(getattr(last.message, name) for name in same)
        )  # fmt: skip

    def _append(self, record: Mapping[str, Any]) -> None:
        line = json.dumps(record, allow_nan=False, ensure_ascii=False).encode("utf-8", "replace") + b"\n"
        size = os.fstat(self._file).st_size
        try:
            if os.write(self._file, line) != len(line):
                raise OSError(28, os.strerror(28))
            os.fsync(self._file)
        except OSError as error:
            os.ftruncate(self._file, size)  # half a line would spoil the next one
            raise unwritable(self.path, error) from None

    def _read(self) -> list[int]:
        """Read the file and return the numbers of damaged lines, from 1; they stay in the file."""
        try:
            with open(self.path, "rb") as file:
                content = file.read(LARGEST + 1)
        except FileNotFoundError:
            return []
        except OSError as error:
            raise unreadable(str(self.path), error) from None
        if len(content) > LARGEST:
            raise FileError(str(self.path), None, "this file is too large; begin a new one")
        *lines, torn = content.split(b"\n")
        damaged = []
        for number, line in enumerate(lines, 1):
            if not line.strip():
                continue
            try:
                self._restore(json.loads(line))
            except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
                damaged.append(number)
        if content and not self._shots and self._player == Player() and (damaged or torn[:1] != b"{"):
            raise FileError(str(self.path), 1, "this is not a file of live shots; give the name of a new one")
        if torn:
            os.truncate(self.path, len(content) - len(torn))
        return damaged

    def _restore(self, record: Mapping[str, Any]) -> None:
        player = Player(record["club"], record["hand"])
        check_choice("club", player.club, CLUB_NAMES)
        check_choice("hand", player.hand, HANDS)
        if "received" not in record:
            self._player = player
            return
        check_choice("protocol", record["protocol"], PROTOCOLS)
        message = Message(
            kind="shot", device=str(record["device"]), shot_number=int(record["shot_number"]),
            delivery=_numbers(record["delivery"], DELIVERY), launch=_numbers(record["launch"], LAUNCH_QUANTITIES),
            impossible=_numbers(record["impossible"], (*DELIVERY, *LAUNCH_QUANTITIES)),
            identity=str(record["identity"]),
            notes=tuple(Note(str(code), dict(data)) for code, data in record["notes"]),
        )  # fmt: skip
        for each in message.notes:
            str(each)  # a note whose sentence cannot be made is damaged
        self._player = player
        self._add(LiveShot(len(self._shots) + 1, str(record["received"]), record["protocol"], player, message))


def _record(shot: LiveShot) -> dict[str, Any]:
    message = shot.message
    return {
        "received": shot.received, "protocol": shot.protocol, "device": message.device,
        "shot_number": message.shot_number, "identity": message.identity, **shot.player._asdict(),
        "delivery": dict(message.delivery), "launch": dict(message.launch), "impossible": dict(message.impossible),
        "notes": [[each.code, dict(each.data)] for each in message.notes],
    }  # fmt: skip


def _numbers(values: Mapping[str, Any], known: Collection[str]) -> dict[str, float]:
    check_names("quantity", values, known)
    result = {str(name): float(value) for name, value in values.items()}
    if not all(map(math.isfinite, result.values())):
        raise ValueError
    return result


def live_shots(shots: Sequence[LiveShot]) -> RecordedShots:
    """Return live shots, at least one, as recorded shots."""
    texts = {
        "clubs": [each.player.club for each in shots],
        "hand": [each.player.hand for each in shots],
        "dates": [each.received for each in shots],
    }
    return replace(
        recorded([each.message for each in shots]),
        **{name: np.array(values, dtype=object) for name, values in texts.items()},
        rows=np.array([each.number for each in shots], dtype=np.int64),
        source=" and ".join(PROTOCOLS[each] for each in dict.fromkeys(one.protocol for one in shots)),
        format="live",
    )


def live_result(shots: Sequence[LiveShot]) -> Result:
    """Return successive live shots as a list, with computed values."""
    return shot_list_result(live_shots(shots), first=shots[0].number, title="Live shots")
