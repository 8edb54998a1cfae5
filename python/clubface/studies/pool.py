"""Processes of this machine that compute chunks; one that is killed is replaced, and its chunks are given to others."""

from __future__ import annotations

import json
import os
import selectors
import signal
import subprocess
import sys
import tempfile
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from typing import Any

from clubface.errors import ClubfaceError, RunError

Done = Callable[[int, Mapping[str, Any]], object]
"""Called with the number of a chunk that is done, and what its worker tells of it."""
AHEAD = 2
"""Chunks that a worker is given at a time, so that it never waits for the next."""
TRIES = 3
"""Workers that may die over a chunk before it is given up."""
MISTAKES = 4000
"""Characters of what a worker says before it dies that are shown."""


class Worker:
    """A worker process.

    Parameters
    ----------
    command
        Its command line.
    """

    def __init__(self, command: Sequence[str]) -> None:
        self._said = tempfile.TemporaryFile()  # noqa: SIM115 - for as long as the process lives
        threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
        path = os.pathsep.join(each for each in sys.path if each)
        self.process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._said,
            env={**os.environ, **threads, "PYTHONPATH": path},
            start_new_session=True,  # Ctrl-C is for the command, which then ends its workers
            bufsize=0,
        )
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self._stdin, self.stdout = self.process.stdin, self.process.stdout
        self.given: deque[int] = deque()
        self._rest = b""

    def give(self, chunk: int) -> None:
        """Give it a chunk; one that has died is noticed when it is read."""
        self.given.append(chunk)
        with suppress(BrokenPipeError):
            self._stdin.write(b"%d\n" % chunk)

    def answers(self) -> list[dict[str, Any]] | None:
        """Return what it has answered, or None where it has ended."""
        read = os.read(self.stdout.fileno(), 65536)
        *lines, self._rest = (self._rest + read).split(b"\n")
        return [json.loads(line) for line in lines] if read else None

    def end(self) -> str:
        """End it; return how it had ended by itself, and the last that it said."""
        before = self.process.poll()
        self.process.kill()
        for stream in (self._stdin, self.stdout):
            with suppress(OSError):
                stream.close()
        status = self.process.wait() if before is None else before
        self._said.seek(0)
        said = self._said.read().decode(errors="replace")[-MISTAKES:].strip()
        self._said.close()
        if status < 0:
            with suppress(ValueError):
                return f"was ended by {signal.Signals(-status).name}"
        return f"ended with status {status}" + (f": {said.splitlines()[-1]}" if said else "")


def work(command: Sequence[str], chunks: Iterable[int], *, workers: int, done: Done) -> None:
    """Have all chunks computed.

    Parameters
    ----------
    command
        Of a worker, see :mod:`clubface.studies.worker`.
    chunks
        Numbers of chunks.
    workers
        Processes at a time.
    done
        Called with the number of a chunk that is done, and what its worker tells of it.

    Raises
    ------
    ClubfaceError
        A chunk cannot be computed, for the reason that its worker gave.
    RunError
        Several workers died over the same chunk.
    """
    _Pool(command, iter(chunks), done).run(workers)


class _Pool:
    def __init__(self, command: Sequence[str], chunks: Any, done: Done) -> None:
        self._command, self._chunks, self._done = command, chunks, done
        self._again: deque[int] = deque()
        self._deaths: dict[int, int] = {}
        self._all: set[Worker] = set()
        self._selector = selectors.DefaultSelector()

    def run(self, workers: int) -> None:
        try:
            for _ in range(workers):
                if not self._start():
                    break
            while self._all:
                for key, _ in self._selector.select(0.1):
                    self._hear(key.data)
        finally:
            for worker in self._all:
                worker.process.kill()
            for worker in self._all:
                worker.end()
            self._selector.close()

    def _next(self) -> int | None:
        return self._again.popleft() if self._again else next(self._chunks, None)

    def _start(self) -> bool:
        """Start a worker if there is work for it."""
        if (chunk := self._next()) is None:
            return False
        worker = Worker(self._command)
        self._all.add(worker)
        self._selector.register(worker.stdout, selectors.EVENT_READ, worker)
        worker.give(chunk)
        self._fill(worker)
        return True

    def _fill(self, worker: Worker) -> None:
        while len(worker.given) < AHEAD and (chunk := self._next()) is not None:
            worker.give(chunk)

    def _hear(self, worker: Worker) -> None:
        answers = worker.answers()
        if answers is None:
            self._bury(worker)
            return
        for answer in answers:
            if "mistake" in answer:
                raise ClubfaceError(answer["mistake"])
            if "error" in answer:
                raise RuntimeError(f"chunk {answer['chunk']}: {answer['error']}")
            worker.given.remove(answer["chunk"])
            self._deaths.pop(answer["chunk"], None)
            self._done(answer["chunk"], answer)
        self._fill(worker)
        if not worker.given:
            self._drop(worker)

    def _drop(self, worker: Worker) -> str:
        self._selector.unregister(worker.stdout)
        self._all.discard(worker)
        return worker.end()

    def _bury(self, worker: Worker) -> None:
        """Give the chunks of a worker that has died to others; the first of them is the one it died over."""
        how = self._drop(worker)
        if worker.given:
            first = worker.given[0]
            self._deaths[first] = self._deaths.get(first, 0) + 1
            if self._deaths[first] >= TRIES:
                raise RunError(f"{TRIES} workers died over chunk {first}; the last {how}")
        self._again.extend(worker.given)
        self._start()
