"""How many tasks a chunk has: measured once when a study begins, and kept in its record from then on."""

from __future__ import annotations

import time

from clubface.errors import ClubfaceError
from clubface.studies.kinds.kind import Computed, Task
from clubface.studies.study import MOST_ROWS, StudyFile

ENOUGH, LOADING = 0.1, 5.0
"""Time of a processor [s] over which tasks are timed, and that loading libraries does not take."""
LEAST, FEWEST = 0.1, 32
"""A chunk that takes longer [s] is made smaller where there would be fewer chunks than that."""
STEPS = (5, 2, 1)
"""A size is one of these times a power of ten."""


def chunk_size(study: StudyFile, task: Task) -> int:
    """Return the tasks of a chunk: as the study says, or as many as take the time that a chunk should take.

    The results do not depend on it. Where it is measured, a study none of whose tasks can be computed ends before it
    begins.

    Raises
    ------
    ClubfaceError
        The tasks that were tried have no result; the message says why.
    """
    if study.chunk is not None:
        return min(study.chunk, study.design.count)
    begun = time.process_time()
    _check(study, task)
    seconds, tasks = time.process_time() - begun, 1
    # Libraries are loaded in the first time, which tells the time of a task only where that is much longer.
    if seconds < LOADING:
        seconds, tasks = 0.0, 0
    while seconds < ENOUGH and tasks < min(study.design.count, MOST_ROWS):
        tasks = min(max(8 * tasks, 1), study.design.count, MOST_ROWS)
        first = (study.design.count - tasks) // 2
        begun = time.process_time()
        task.run(range(first, first + tasks))
        seconds = time.process_time() - begun
    rate = tasks / max(seconds, 1e-9)
    # A small study is cut into smaller chunks, so that several workers have some.
    shared = max(rounded(LEAST * rate), -(-study.design.count // FEWEST))
    return min(rounded(study.seconds * rate), shared, study.design.count)


def rounded(size: float) -> int:
    """Return the largest number of the form 1, 2 or 5 times a power of ten that is not above ``size``; at least 1."""
    power = 1
    while power * 10 <= min(size, MOST_ROWS):
        power *= 10
    return max(1, next((step * power for step in STEPS if step * power <= min(size, MOST_ROWS)), 1))


def tried_first(of: range) -> tuple[int, ...]:
    """Return the first, the last and the middle one of some chunks or tasks.

    A study none of which has a result is not gone on with: of an input that is swept too far to both sides, the middle
    has one.
    """
    return tuple(dict.fromkeys((*of[:1], *of[-1:], *of[len(of) // 2 :][:1])))


def _check(study: StudyFile, task: Task) -> None:
    """Refuse a study of whose tasks none that is tried first has a result."""
    found = Computed({})
    for index in tried_first(range(study.design.count)):
        try:
            found = task.run(range(index, index + 1))
        except ClubfaceError as error:
            raise study.wrap(error) from None
        if not found.failed:
            return
    raise ClubfaceError(f"no task that was tried has a result: {found.failed[0][1]}")
