"""Checkpoint file of an identification, so that an interrupted one continues and ends at the same result."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.identification.simulator import Effort
from clubface.support.resuming import Journal

FORMAT = 1
"""Of the file; another one is refused."""
UNREADABLE = "cannot be read as a checkpoint: remove it or name another"
OTHERS = "was begun from other shots or with other settings: start again without resume"


class Checkpoint:
    """The finished parts of an identification, by name; each is written, whole or not at all, as soon as it is there.

    Numbers are written with all their digits, so that what is read is what was computed, bit for bit.

    Parameters
    ----------
    path
        Of the file; None keeps nothing.
    settings
        A text that is the same only for the same shots and settings.
    effort
        Counts what is computed.
    resume
        Whether to go on from the file, if there is one; otherwise a checkpoint that is there is begun anew.

    Attributes
    ----------
    parts
        What is finished: its value, and the evaluations and impacts it took.
    resumed
        Whether something was read.
    """

    def __init__(
        self, path: str | os.PathLike[str] | None, settings: str, effort: Effort, *, resume: bool = False
    ) -> None:
        self.path = None if path is None else Path(path)
        self.settings = settings
        self.parts: dict[str, dict[str, Any]] = {}
        self._effort = effort
        self._journal = (
            None if self.path is None else Journal(self.path, settings, unreadable=UNREADABLE, others=OTHERS)
        )
        self._before = 0.0
        self._began = time.monotonic()
        if self._journal is not None:
            self._find(self._journal, resume)
        self.resumed = bool(self.parts)

    @property
    def seconds(self) -> float:
        """Time spent on what is finished, by earlier runs as well [s]."""
        return self._before + time.monotonic() - self._began

    @property
    def spent(self) -> Effort:
        """What the finished parts took, by earlier runs as well."""
        return Effort(*(sum(part[key] for part in self.parts.values()) for key in ("evaluations", "impacts")))

    def keep(self, name: str, value: Any, spent: Effort) -> None:
        """Record a finished part, made of what JSON has, and what it took."""
        self.parts[name] = {"value": value, "evaluations": spent.evaluations, "impacts": spent.impacts}
        if self._journal is not None:
            self._journal.write({"format": FORMAT, "seconds": self.seconds, "parts": self.parts})

    def value(self, name: str) -> Any:
        """Return the value of a part, None where it is not finished."""
        return self.parts[name]["value"] if name in self.parts else None

    def once(self, name: str, compute: Callable[[], Any]) -> Any:
        """Return the value of a part: as recorded, or computed and recorded now."""
        if name not in self.parts:
            before = Effort(self._effort.evaluations, self._effort.impacts)
            value = compute()
            self.keep(name, value, self._effort.since(before))
        return self.parts[name]["value"]

    def remove(self) -> None:
        """Remove the file: the work is done."""
        if self._journal is not None:
            self._journal.remove()

    def _find(self, journal: Journal, resume: bool) -> None:
        """Take what an earlier run finished; refuse a file that is no checkpoint: it would be written over."""
        if not journal.path.parent.is_dir():
            raise FileError(str(journal.path), None, "this folder does not exist; give a file in one that does")
        found = journal.read(_checked, resume=resume)
        if found is not None:
            self.parts, self._before = found


def _checked(state: Any) -> tuple[dict[str, dict[str, Any]], float]:
    """Return parts and seconds of a checkpoint."""
    parts = state["parts"]
    if state["format"] != FORMAT or any(set(part) != {"value", "evaluations", "impacts"} for part in parts.values()):
        raise ValueError
    return parts, float(state["seconds"])
