"""Processes of this machine that compute chunks; one that is killed is replaced, and its chunks are given to others."""

from __future__ import annotations

import io
import json
import os
import queue
import signal
import subprocess
import sys
import tempfile
import threading
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from typing import Any, Self

from clubface.errors import ClubfaceError, RunError

Done = Callable[[int, Mapping[str, Any]], object]
"""Called with the number of a chunk that is done, and what its worker tells of it."""
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
    heard
        Where it puts itself with each of its answers, and with None at its end.
    """

    def __init__(self, command: Sequence[str], heard: queue.SimpleQueue[Any]) -> None:
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
        self._stdin = self.process.stdin
        self.given: int | None = None
        self._reader = threading.Thread(target=self._listen, args=(self.process.stdout, heard), daemon=True)
        self._reader.start()

    def _listen(self, stdout: Any, heard: queue.SimpleQueue[Any]) -> None:
        """Pass on what it answers, and None when it has ended."""
        with stdout, io.BufferedReader(stdout) as lines:
            for line in lines:
                heard.put((self, json.loads(line) if line.endswith(b"\n") else None))
        heard.put((self, None))

    def give(self, chunk: int) -> None:
        """Give it a chunk; one that has died is noticed when its output ends."""
        self.given = chunk
        self.tell(f"{chunk}\n")

    def tell(self, text: str) -> None:
        """Write to it."""
        with suppress(OSError):
            self._stdin.write(text.encode())

    def end(self) -> str:
        """End it; return how it had ended by itself, and the last that it said."""
        before = self.process.poll()
        self.process.kill()
        with suppress(OSError):
            self._stdin.close()
        status = self.process.wait() if before is None else before
        self._reader.join()
        self._said.seek(0)
        said = self._said.read().decode(errors="replace")[-MISTAKES:].strip()
        self._said.close()
        if status < 0:
            with suppress(ValueError):
                return f"was ended by {signal.Signals(-status).name}"
        return f"ended with status {status}" + (f": {said.splitlines()[-1]}" if said else "")


class Pool:
    """Processes that compute chunks; to be used in a ``with``, which ends those that are left.

    Parameters
    ----------
    command
        Of a worker, see :mod:`clubface.studies.worker`.
    workers
        Processes at a time. They start at once, and load what they need while the study is prepared.
    """

    def __init__(self, command: Sequence[str], workers: int) -> None:
        self._command = command
        self._again: deque[int] = deque()
        self._deaths: dict[int, int] = {}
        self._heard: queue.SimpleQueue[Any] = queue.SimpleQueue()
        self._all = {Worker(command, self._heard) for _ in range(workers)}

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, *rest: object) -> None:
        for worker in self._all:
            worker.process.kill()
        for worker in self._all:
            # Who has pressed Ctrl-C does not wait for the last breath of those that are killed.
            if kind is not None and issubclass(kind, KeyboardInterrupt):
                threading.Thread(target=worker.end, daemon=True).start()
            else:
                worker.end()

    def work(self, chunks: Iterable[int], done: Done, *, first: str = "") -> None:
        """Have all chunks computed.

        Parameters
        ----------
        chunks
            Numbers of chunks.
        done
            Called with the number of a chunk that is done, and what its worker tells of it.
        first
            What every worker is told before its first chunk.

        Raises
        ------
        ClubfaceError
            A chunk cannot be computed, for the reason that its worker gave.
        RunError
            Several workers died over the same chunk.
        """
        self._chunks, self._done, self._first = iter(chunks), done, first
        for worker in list(self._all):
            self._begin(worker)
        while self._all:
            with suppress(queue.Empty):
                self._hear(*self._heard.get(timeout=0.1))

    def _next(self) -> int | None:
        return self._again.popleft() if self._again else next(self._chunks, None)

    def _begin(self, worker: Worker) -> None:
        """Give a worker its first chunk; one for which there is none is ended."""
        worker.tell(self._first)
        self._go_on(worker)

    def _go_on(self, worker: Worker) -> None:
        if (chunk := self._next()) is not None:
            worker.give(chunk)
        else:
            self._all.discard(worker)
            worker.end()

    def _hear(self, worker: Worker, answer: dict[str, Any] | None) -> None:
        if worker not in self._all:
            return  # the end of one that was ended
        if answer is None:
            self._bury(worker)
            return
        if "mistake" in answer:
            raise ClubfaceError(answer["mistake"])
        if "error" in answer:
            raise RuntimeError(f"chunk {answer['chunk']}: {answer['error']}")
        worker.given = None
        self._deaths.pop(answer["chunk"], None)
        self._done(answer["chunk"], answer)
        self._go_on(worker)

    def _bury(self, worker: Worker) -> None:
        """Give the chunk of a worker that has died to another."""
        self._all.discard(worker)
        with suppress(subprocess.TimeoutExpired):
            worker.process.wait(1.0)  # its output ends a little before it does
        how, chunk = worker.end(), worker.given
        if chunk is not None:
            self._deaths[chunk] = self._deaths.get(chunk, 0) + 1
            if self._deaths[chunk] >= TRIES:
                raise RunError(f"{TRIES} workers died over chunk {chunk}; the last {how}")
            self._again.append(chunk)
        if (chunk := self._next()) is not None:
            self._again.appendleft(chunk)
            worker = Worker(self._command, self._heard)
            self._all.add(worker)
            self._begin(worker)
