"""Tasks that compute next to nothing: what a study costs by itself on a machine or a cluster is measured with them."""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.studies.axes import Swept
from clubface.studies.kinds.kind import Column, Computed, Described, Kind


class Empty:
    """The square of one input, after a time of work that the study asks for.

    See :class:`clubface.studies.kinds.kind.Task`.

    Parameters
    ----------
    study
        The study.
    seconds
        Time of a processor that each task takes [s].
    """

    columns: Mapping[str, Column]
    depends_on: Mapping[str, str]

    def __init__(self, study: Described, seconds: float) -> None:
        self._design, self._seconds = study.design, seconds
        self.columns = {"square": Column("1", "square of the input x")}
        self.depends_on = {}

    def run(self, indices: range) -> Computed:
        """Square the inputs, and work on for the time that was asked for."""
        ends = time.thread_time() + self._seconds * len(indices)
        (x,) = self._design.values(indices).values()
        while time.thread_time() < ends:
            pass
        return Computed({"square": x * x})


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    return {"x": Swept("1")}


def _task(study: Described) -> Empty:
    seconds = units.parse(study.table.get("seconds", 0.0), "time", name="seconds")
    if not 0.0 <= seconds <= 3600.0:
        raise InputError("seconds", seconds, "from 0 to 3600 s")
    return Empty(study, seconds)


KIND = Kind(name="empty", keys=("seconds",), swept=_swept, task=_task)
