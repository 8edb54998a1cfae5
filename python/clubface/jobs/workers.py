"""Workers for the parts of a job: this thread, several threads, processes, a Dask cluster, or shards.

Each ``in_`` or ``on_`` function takes parts and the function that computes one, and yields every part with its result
as it finishes. Leaving the loop, as Ctrl-C does, stops running computations.
"""

from __future__ import annotations

import asyncio
import logging
import os
import re
import signal
import sys
import threading
import time
import warnings
from collections import Counter, deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import CancelledError, Future, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from contextvars import copy_context
from itertools import islice
from multiprocessing import parent_process
from multiprocessing.context import SpawnContext, SpawnProcess
from queue import Empty, SimpleQueue
from types import ModuleType
from typing import Any, NamedTuple, TypeVar

from clubface.errors import ClubfaceError, InputError, LinkError, RunError
from clubface.support.checks import check_count, check_text
from clubface.support.processes import processors

__all__ = [
    "KeepGoing", "Shard", "in_processes", "in_sequence", "in_threads", "on_cluster", "shard_of", "worker_count",
]  # fmt: skip

P = TypeVar("P")
R = TypeVar("R")
KeepGoing = Callable[[float, float], object]
"""Function called by a computation with the time reached and the end time; raises an error if it must stop."""
MAX_WORKERS = 1024
POLL_INTERVAL = 0.05
"""Maximum delay until Ctrl-C and lost connections are noticed [s]."""
MAX_TRIES = 3
"""Number of processes that may die on a part before it is abandoned."""
THREAD_VARIABLES = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


def worker_count(workers: int | None) -> int:
    """Return the number of parts computed at a time: as requested, or one per processor."""
    return processors() if workers is None else check_count("workers", workers, 1, MAX_WORKERS)


def in_sequence(parts: Iterable[P], compute: Callable[[P], R]) -> Iterator[tuple[P, R]]:
    """Compute the parts one after another in this thread."""
    for part in parts:
        yield part, compute(part)


def in_threads(
    parts: Iterable[P], compute: Callable[[P, KeepGoing, int], R], *, workers: int | None = None
) -> Iterator[tuple[P, R]]:
    """Compute several parts at a time on threads, for compiled code that lets other threads run.

    ``compute`` takes a part, a function to call as it proceeds, and the number of threads that it may use: one, or more
    for the last parts if there are fewer parts than workers.
    """
    count, todo = worker_count(workers), list(parts)
    last, cores = len(todo) % count, min(count, processors())
    numbered = iter(enumerate(todo))
    stopped = threading.Event()

    def keep_going(time: float, end: float) -> None:
        if stopped.is_set():
            raise KeyboardInterrupt

    with ThreadPoolExecutor(count) as pool:

        def submit(item: tuple[int, P]) -> Future[R]:
            number, part = item
            threads = max(cores // last, 1) if number >= len(todo) - last else 1
            return pool.submit(copy_context().run, compute, part, keep_going, threads)

        try:
            for (_, part), future in _complete_parts(numbered, submit, lambda: count):
                yield part, future.result()
        finally:
            stopped.set()


def in_processes(parts: Iterable[P], compute: Callable[[P], R], *, workers: int | None = None) -> Iterator[tuple[P, R]]:
    """Compute several parts at a time in processes on this machine, each with one thread.

    A part whose process dies is passed to another process. ``compute``, parts and results are pickled.

    Raises
    ------
    RunError
        Several processes died on a part, or there is not enough memory for one.
    """
    count, again, deaths = worker_count(workers), deque[tuple[int, P]](), Counter[int]()
    idle: list[_Process] = []
    busy: dict[Future[R], _Process] = {}

    def submit(item: tuple[int, P]) -> Future[R]:
        process = idle.pop() if idle else _Process()
        try:
            future = process.executor.submit(compute, item[1])
        except BrokenProcessPool:  # the process died while idle
            process.end()
            process = _Process()
            future = process.executor.submit(compute, item[1])
        busy[future] = process
        return future

    try:
        for (number, part), future in _complete_parts(enumerate(parts), submit, lambda: count, again=again):
            process = busy.pop(future)
            try:
                result = future.result()
            except BrokenProcessPool:
                ending = process.end()
                deaths[number] += 1
                if deaths[number] >= MAX_TRIES:
                    name = part if isinstance(part, int) else number
                    raise RunError(f"{MAX_TRIES} workers died over chunk {name}; the last {ending}") from None
                again.append((number, part))
            except MemoryError:
                name = part if isinstance(part, int) else number
                message = f"not enough memory for chunk {name}; give smaller chunks, or fewer workers"
                raise RunError(message) from None
            else:
                idle.append(process)
                yield part, result
    finally:
        for process in (*idle, *busy.values()):
            process.kill()
        for process in (*idle, *busy.values()):
            process.end()


def _complete_parts(
    parts: Iterator[P],
    submit: Callable[[P], Future[R]],
    width: Callable[[], int],
    *,
    again: deque[P] | None = None,
    check: Callable[[], object] = lambda: None,
) -> Iterator[tuple[P, Future[R]]]:
    """Yield each finished part with its future; ``width()`` parts are computed at a time.

    Parts put into ``again`` are submitted again, before the others.
    """
    running: dict[Future[R], P] = {}
    ended: SimpleQueue[Future[R]] = SimpleQueue()
    while True:
        room = max(width() - len(running), 0)
        repeated = [again.popleft() for _ in range(min(room, len(again)))] if again else []
        for part in (*repeated, *islice(parts, room - len(repeated))):
            future = submit(part)
            running[future] = part
            future.add_done_callback(ended.put)
        if not running:
            return
        try:
            future = ended.get(timeout=POLL_INTERVAL)
        except Empty:
            pass
        else:
            yield running.pop(future), future
        check()


class _Process:
    """An executor with one process, so that the others survive its death."""

    def __init__(self) -> None:
        self._context = _Context()
        self.executor = ProcessPoolExecutor(1, self._context, initializer=_begin_worker)

    def kill(self) -> None:
        """Kill the process; its finished work is already kept."""
        for process in self._context.started:
            with suppress(ValueError, OSError):
                process.kill()

    def end(self) -> str:
        """Wait until the process has ended; return how it ended."""
        self.executor.shutdown(cancel_futures=True)
        code = next((each.exitcode for each in self._context.started), None)
        if code is not None and code < 0:
            with suppress(ValueError):
                return f"was ended by {signal.Signals(-code).name}"
        return f"ended with status {code}"


class _Context(SpawnContext):
    """Starts processes that import only this package, not the running program, and that Ctrl-C does not reach.

    Attributes
    ----------
    started
        The processes.
    """

    def __init__(self) -> None:
        self.started: list[SpawnProcess] = []

    def Process(self, *arguments: Any, **options: Any) -> SpawnProcess:  # noqa: N802  # pyright: ignore[reportIncompatibleVariableOverride]
        process = _WorkerProcess(*arguments, **options)
        self.started.append(process)
        return process


class _WorkerProcess(SpawnProcess):
    def start(self) -> None:
        with _for_worker():
            super().start()


@contextmanager
def _for_worker() -> Iterator[None]:
    """Temporarily change what a new process inherits from this one."""
    program, variables = sys.modules["__main__"], {name: os.environ.get(name) for name in THREAD_VARIABLES}
    # Otherwise a script without `if __name__ == "__main__"` would run again in each process.
    sys.modules["__main__"] = ModuleType("__main__")
    # Libraries read these when they are loaded, before anything can be called in the process.
    os.environ.update(dict.fromkeys(THREAD_VARIABLES, "1"))
    try:
        with _interrupts_held():
            yield
    finally:
        sys.modules["__main__"] = program
        for name, value in variables.items():
            os.environ.pop(name, None) if value is None else os.environ.update({name: value})


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """Let a process that starts hear no Ctrl-C; one that comes to this process meanwhile waits, but not on Windows."""
    if sys.platform == "win32":
        import ctypes

        ctypes.windll.kernel32.SetConsoleCtrlHandler(None, True)
        try:
            yield
        finally:
            ctypes.windll.kernel32.SetConsoleCtrlHandler(None, False)
    else:
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            yield
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin_worker() -> None:
    """Prepare a worker process: it ignores Ctrl-C, prints and warns of nothing, and ends with the main process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.dup2(2, 1)
    warnings.simplefilter("ignore")
    main = parent_process()
    if main is not None:
        threading.Thread(target=lambda: (main.join(), os._exit(1)), daemon=True).start()


CHUNKS_PER_THREAD = 3
"""Parts in flight per thread of the cluster, so that no worker is idle."""
MAX_LOSSES = 5
"""Number of times the scheduler may lose a part before it is abandoned."""
SCHEDULER_TIMEOUT = 15.0
"""Maximum time to wait for the scheduler [s]."""
FIRST_WORKER_TIMEOUT = 60.0
"""Maximum time to wait for the first worker [s]."""
RECOUNT_INTERVAL = 2.0
"""Interval at which the threads of the cluster are counted, because workers come and go [s]."""
LOGGERS = ("distributed", "distributed.client", "distributed.comm", "distributed.core", "tornado", "asyncio")


def on_cluster(parts: Iterable[P], compute: Callable[[P], R], *, address: str) -> Iterator[tuple[P, R]]:
    """Compute parts on the workers of a Dask cluster, which must have the same version of clubface.

    Parameters
    ----------
    parts, compute
        The parts, and the function that computes one; results should be small.
    address
        Address of the scheduler, as in "tcp://10.0.0.1:8786".

    Raises
    ------
    LinkError
        The scheduler does not answer, was lost, or has no workers.
    """
    from dask import config
    from distributed import Client

    with _without_logs(), config.set({"distributed.comm.timeouts.connect": SCHEDULER_TIMEOUT}):
        _check_scheduler(address)
        client = Client(address, timeout=SCHEDULER_TIMEOUT, set_as_default=False)
        try:
            yield from _on_client(client, parts, compute, address)
        finally:
            with suppress(Exception):
                client.close(timeout=1.0)


def _on_client(client: Any, parts: Iterable[P], compute: Callable[[P], R], address: str) -> Iterator[tuple[P, R]]:
    from distributed import KilledWorker

    again, losses = deque[P](), Counter[P]()
    executor, threads = client.get_executor(pure=False, retries=0), _threads(client, address)
    counted = answered = time.monotonic()

    def width() -> int:
        nonlocal threads, counted
        if time.monotonic() - counted > RECOUNT_INTERVAL:
            with suppress(OSError, TimeoutError):
                threads = sum(client.nthreads().values()) or threads
            counted = time.monotonic()
        return CHUNKS_PER_THREAD * threads

    def check() -> None:
        nonlocal answered
        if client.status == "running":
            answered = time.monotonic()
        elif time.monotonic() - answered > SCHEDULER_TIMEOUT or client.status == "closed":
            raise LinkError(address, "is lost: the scheduler of the cluster has stopped")

    completed = _complete_parts(
        iter(parts), lambda part: executor.submit(compute, part), width, again=again, check=check
    )
    for part, future in completed:
        try:
            yield part, future.result()
        except ClubfaceError:
            raise
        except ModuleNotFoundError as error:
            message = f"has a worker without {error.name}; install the same clubface there, with its extra tables"
            raise LinkError(address, message) from None
        except (KilledWorker, CancelledError, TimeoutError, OSError):
            check()
            losses[part] += 1
            if losses[part] >= MAX_LOSSES:
                raise LinkError(address, f"has lost the workers of chunk {part} {MAX_LOSSES} times") from None
            again.append(part)


def _threads(client: Any, address: str) -> int:
    """Return the number of threads of all workers, after waiting for the first worker."""
    ends = time.monotonic() + FIRST_WORKER_TIMEOUT
    while time.monotonic() < ends:
        with suppress(OSError, TimeoutError):
            if count := sum(client.nthreads().values()):
                return count
        time.sleep(POLL_INTERVAL)
    raise LinkError(address, f"has had no worker for {FIRST_WORKER_TIMEOUT:.0f} s; start some")


def _check_scheduler(address: str) -> None:
    """Raise LinkError if no scheduler answers; Dask's client would wait forever for another kind of server."""
    from distributed import rpc
    from distributed.utils import LoopRunner

    async def identity() -> str:
        async with rpc(address, timeout=SCHEDULER_TIMEOUT) as peer:
            answer: Any = await peer.identity()
            return answer["type"]

    try:
        kind = LoopRunner(asynchronous=False).run_sync(lambda: asyncio.wait_for(identity(), SCHEDULER_TIMEOUT + 1.0))
    except Exception as error:  # whatever Dask makes of an answer from another kind of server
        reason = str(error).splitlines()[0] if str(error) else f"{SCHEDULER_TIMEOUT:.0f} s have passed"
        raise LinkError(address, f"is not a scheduler that answers: {reason}") from None
    if kind != "Scheduler":
        raise LinkError(address, f"is a {kind.lower()} of the cluster; give the address of its scheduler")


@contextmanager
def _without_logs() -> Iterator[None]:
    """Hide Dask's log of lost connections; one message explains them instead."""
    before = {name: logging.getLogger(name).level for name in LOGGERS}
    for name in LOGGERS:
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for name, level in before.items():
            logging.getLogger(name).setLevel(level)


FORMS = 'such as 3/40 (the third of 40), or "slurm" or "kubernetes/40" in a job of an array'
MAX_SHARDS = 1_000_000


class Shard(NamedTuple):
    """One of several jobs that take every n-th part each: its number, from 1, and the number of jobs."""

    number: int
    shards: int

    def of_all(self, parts: int) -> range:
        """Return the parts that belong to this shard."""
        return range(self.number - 1, parts, self.shards)


def shard_of(text: str, environment: Mapping[str, str] = os.environ) -> Shard:
    """Parse a shard such as "2/8".

    Parameters
    ----------
    text
        "3/40"; "slurm" or "slurm/40", which takes the number from ``SLURM_ARRAY_TASK_ID``, counted from
        ``SLURM_ARRAY_TASK_MIN``, and the number of jobs from ``SLURM_ARRAY_TASK_COUNT`` if not given; or
        "kubernetes/40", which takes it from ``JOB_COMPLETION_INDEX``, counted from 0. Otherwise the environment is not
        used.
    environment
        The environment variables.
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
