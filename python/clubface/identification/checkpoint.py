"""Checkpoint of an identification, so that an interrupted one continues and ends at the same result."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from clubface.identification.simulator import Effort
from clubface.support.resuming import Store


class Checkpoint:
    """The finished parts of an identification, by name, in a store where one is wanted.

    Numbers are written with all their digits, so that what is read is what was computed, bit for bit.

    Parameters
    ----------
    folder
        Of the store; None keeps nothing.
    content
        What the identification is of, by name.
    effort
        Counts what is computed.
    resume
        Whether to refuse a store of something else, instead of beginning anew in its place.

    Attributes
    ----------
    parts
        What is finished: its value, the evaluations and impacts it took, and the time until then.
    resumed
        Whether something was read.
    """

    def __init__(
        self, folder: str | os.PathLike[str] | None, content: Mapping[str, Any], effort: Effort, *, resume: bool = False
    ) -> None:
        self._effort = effort
        self._store = None if folder is None else Store(Path(folder), content, resume=resume)
        self.parts: dict[str, dict[str, Any]] = {} if self._store is None else {n: self._store[n] for n in self._store}
        self._before = max((part["seconds"] for part in self.parts.values()), default=0.0)
        self._began = time.monotonic()
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
        told = {"value": value, "evaluations": spent.evaluations, "impacts": spent.impacts, "seconds": self.seconds}
        self.parts[name] = told
        if self._store is not None:
            self._store.keep(name, told)

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
        """Remove the store: the work is done."""
        if self._store is not None:
            self._store.remove()

    def close(self) -> None:
        """Keep what is finished for another time."""
        if self._store is not None:
            self._store.close()
