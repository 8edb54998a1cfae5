"""The histories that a study has kept, as columns."""

from __future__ import annotations

import os
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from clubface.errors import FileError, InputError
from clubface.studies.kinds.kind import TASK
from clubface.studies.store import open_store
from clubface.support.checks import check_choice, is_count

__all__ = ["histories"]


def histories(
    study: str | os.PathLike[str],
    name: str,
    *,
    tasks: Iterable[int] | None = None,
    store: str | os.PathLike[str] | None = None,
) -> dict[str, NDArray[np.float64]]:
    """Return a history that a study has kept, one task after the other.

    Parameters
    ----------
    study
        The file of the study, or the folder of its store.
    name
        The history, such as "contact" of a study of finite elements.
    tasks
        Numbers of tasks, from 0 on in the order of the study; all unless given.
    store
        The folder of the store of a file, unless it is the usual one.

    Returns
    -------
    dict
        Columns by name [SI], float64, of equal length: the number of the ``task`` and those of the history. Tasks
        without a result have no rows.

    Raises
    ------
    InputError
        The study keeps no such history, or has no such task.
    FileError
        The study, or what is asked for of it, is not computed yet.
    """
    opened = open_store(study, store)
    if not opened.histories:
        raise InputError("history", name, 'left out: the study keeps none; ask for it, as in histories = ["contact"]')
    check_choice("history", name, opened.histories)
    wanted = None if tasks is None else list(tasks)
    for task in wanted or ():
        if not is_count(task, 0, opened.count - 1):
            raise InputError("task", task, f"a whole number from 0 to {opened.count - 1}")
    size = opened.record["chunk"]
    chunks = range(opened.chunks) if wanted is None else sorted({task // size for task in wanted})
    parts: list[dict[str, NDArray[np.float64]]] = []
    for chunk in chunks:
        try:
            columns = opened.read_history(name, chunk)
        except FileNotFoundError:
            message = f"chunk {chunk} is not done yet; clubface study run computes it"
            raise FileError(str(opened.folder), None, message) from None
        if wanted is not None:
            chosen = np.isin(columns[TASK], wanted)
            columns = {each: column[chosen] for each, column in columns.items()}
        parts.append(columns)
    return {each: np.concatenate([part[each] for part in parts] or [np.empty(0)]) for each in opened.histories[name]}
