"""Which parts fall to one of several jobs that share a computation: every n-th, so that slow regions are shared out."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from typing import NamedTuple

from clubface.errors import InputError
from clubface.support.checks import check_text

__all__ = ["Shard", "shard_of"]

FORMS = 'such as 3/40 (the third of 40), or "slurm" or "kubernetes/40" in a job of an array'
MAX_SHARDS = 1_000_000


class Shard(NamedTuple):
    """One of several jobs: its number, from 1 on, and how many there are."""

    number: int
    shards: int

    def of_all(self, parts: int) -> range:
        """Return which of all parts fall to it."""
        return range(self.number - 1, parts, self.shards)


def shard_of(text: str, environment: Mapping[str, str] = os.environ) -> Shard:
    """Return the shard that a text means.

    Parameters
    ----------
    text
        "3/40"; "slurm" or "slurm/40", which takes the number from ``SLURM_ARRAY_TASK_ID`` beginning at
        ``SLURM_ARRAY_TASK_MIN`` (and how many there are from ``SLURM_ARRAY_TASK_COUNT``); or "kubernetes/40", which
        takes it from ``JOB_COMPLETION_INDEX``, from 0 on. Nothing is taken from the environment unless asked for.
    environment
        The variables.
    """
    check_text("shard", text)
    match = re.fullmatch(r"(?:(\d{1,7})|slurm|kubernetes)(?:/(\d{1,7}))?", text, re.ASCII)
    if match is None or (match[2] is None and text != "slurm"):
        raise InputError("shard", text, FORMS)

    def variable(name: str, default: str | None = None) -> int:
        value = environment.get(name, default)
        if value is None or not re.fullmatch(r"\d{1,9}", value, re.ASCII):
            raise InputError(name, value, "a whole number, as the scheduler sets it in every job of an array")
        return int(value)

    if text.startswith("slurm"):
        step, first = variable("SLURM_ARRAY_TASK_STEP", "1") or 1, variable("SLURM_ARRAY_TASK_MIN")
        number = (variable("SLURM_ARRAY_TASK_ID") - first) // step + 1
    else:
        number = int(match[1]) if match[1] else variable("JOB_COMPLETION_INDEX") + 1
    count = int(match[2]) if match[2] else variable("SLURM_ARRAY_TASK_COUNT")
    if not 1 <= number <= count <= MAX_SHARDS:
        given = text if match[1] else f"{text}, which is {number}/{count} here"
        raise InputError("shard", given, f"a number from 1 to the number of shards, {FORMS}")
    return Shard(number, count)
