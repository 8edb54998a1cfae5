"""Which chunks fall to one of several jobs that share a study: every n-th, so that slow regions are shared out."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from typing import NamedTuple

from clubface.errors import InputError
from clubface.support.checks import check_text

FORMS = 'such as 3/40 (the third of 40), or "slurm" or "kubernetes/40" in a job of an array'
MOST = 1_000_000


class Shard(NamedTuple):
    """One of several jobs.

    Attributes
    ----------
    number
        From 1 on.
    of
        How many there are.
    """

    number: int
    of: int

    def of_all(self, chunks: int) -> range:
        """Return which of all chunks fall to it."""
        return range(self.number - 1, chunks, self.of)


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
    name, _, count = text.partition("/")
    if name == "slurm":
        step = _variable("SLURM_ARRAY_TASK_STEP", environment, "1") or 1
        first = _variable("SLURM_ARRAY_TASK_MIN", environment)
        number = (_variable("SLURM_ARRAY_TASK_ID", environment) - first) // step + 1
        of = _whole(count, text) if count else _variable("SLURM_ARRAY_TASK_COUNT", environment)
    elif name == "kubernetes" and count:
        number, of = _variable("JOB_COMPLETION_INDEX", environment) + 1, _whole(count, text)
    elif re.fullmatch(r"\d{1,7}/\d{1,7}", text, re.ASCII):
        number, of = int(name), int(count)
    else:
        raise InputError("shard", text, FORMS)
    if not (1 <= number <= of <= MOST):
        told = text if name.isdecimal() else f"{text}, which is {number}/{of} here"
        raise InputError("shard", told, f"a number from 1 to the number of shards, {FORMS}")
    return Shard(number, of)


def _whole(text: str, given: str) -> int:
    if not re.fullmatch(r"\d{1,7}", text, re.ASCII):
        raise InputError("shard", given, FORMS)
    return int(text)


def _variable(name: str, environment: Mapping[str, str], otherwise: str | None = None) -> int:
    found = environment.get(name, otherwise)
    if found is None or not re.fullmatch(r"\d{1,9}", found, re.ASCII):
        raise InputError(name, found, "a whole number, as the scheduler sets it in every job of an array")
    return int(found)
