"""Chunks on the workers of a Dask cluster: few in flight, messages of some hundred bytes, results in the store alone.

The cluster's workers need this version of clubface, and the store, which has the files of the study, under the same
name as here. What the scheduler forgets or loses is given to it again; what is finished is in the store, whatever
happens.
"""

from __future__ import annotations

import asyncio
import logging
import threading
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import Any

from clubface.errors import ClubfaceError, LinkError
from clubface.studies.chunks import ensure

AHEAD = 3
"""Chunks in flight for each thread of the cluster, so that no worker waits for the next."""
TRIES = 5
"""Workers that may be lost over a chunk before it is given up."""
PATIENCE = 15.0
"""Time to wait for the scheduler [s]."""
LONE = 60.0
"""Time to wait for the first worker [s]."""
LOGGERS = ("distributed", "distributed.client", "distributed.comm", "distributed.core", "tornado", "asyncio")


def work_on_cluster(
    address: str,
    arguments: tuple[Any, ...],
    chunks: Iterable[int],
    *,
    done: Callable[[int, Mapping[str, Any]], object],
) -> None:
    """Have all chunks computed.

    Parameters
    ----------
    address
        Of the scheduler, as in "tcp://10.0.0.1:8786".
    arguments
        What :func:`clubface.studies.chunks.ensure` takes before the number of a chunk.
    chunks
        Numbers of chunks.
    done
        Called with the number of a chunk that is done, and what its worker tells of it.

    Raises
    ------
    LinkError
        The scheduler does not answer, is gone, or has no workers.
    ClubfaceError
        A chunk cannot be computed.
    """
    from dask import config
    from distributed import Client

    with _quiet(), config.set({"distributed.comm.timeouts.connect": PATIENCE}):
        _check_scheduler(address)
        client = Client(address, timeout=PATIENCE, set_as_default=False)
        try:
            _Cluster(client, address, arguments, done).run(iter(chunks))
        finally:
            with suppress(Exception):
                client.close(timeout=1.0)


def _check_scheduler(address: str) -> None:
    """Refuse an address at which no scheduler answers: Dask's client waits without end for a server of another kind."""
    from distributed import rpc
    from distributed.utils import LoopRunner

    async def asked() -> str:
        async with rpc(address, timeout=PATIENCE) as peer:
            told: Any = await peer.identity()
            return told["type"]

    try:
        kind = LoopRunner(asynchronous=False).run_sync(lambda: asyncio.wait_for(asked(), PATIENCE + 1.0))
    except Exception as error:  # whatever an answer that is none is taken for
        reason = str(error).splitlines()[0] if str(error) else f"{PATIENCE:.0f} s have passed"
        raise LinkError(address, f"is no scheduler that answers: {reason}") from None
    if kind != "Scheduler":
        raise LinkError(address, f"is a {kind.lower()} of the cluster; give the address of its scheduler")


class _Cluster:
    def __init__(self, client: Any, address: str, arguments: tuple[Any, ...], done: Any) -> None:
        self._client, self._address, self._arguments, self._done = client, address, arguments, done
        self._running: dict[Any, int] = {}
        self._again: deque[int] = deque()
        self._lost: dict[int, int] = {}
        self._number = 0
        self._news = threading.Event()

    def run(self, chunks: Iterator[int]) -> None:
        heard = time.monotonic()
        threads = self._threads()
        looked = time.monotonic()
        while True:
            if time.monotonic() - looked > 2.0:  # workers come and go
                threads, looked = self._threads(wait=False) or threads, time.monotonic()
            while len(self._running) < AHEAD * threads:
                chunk = self._again.popleft() if self._again else next(chunks, None)
                if chunk is None:
                    break
                self._submit(chunk)
            if not self._running:
                return
            self._news.wait(0.1)
            self._news.clear()
            for future in [each for each in self._running if each.done()]:
                self._end(future)
            if self._client.status == "running":
                heard = time.monotonic()
            elif time.monotonic() - heard > PATIENCE or self._client.status == "closed":
                raise LinkError(self._address, "is gone, the scheduler of the cluster")

    def _submit(self, chunk: int) -> None:
        # A key of its own each time: what a scheduler remembers of an earlier try is not what is asked for.
        self._number += 1
        key = f"{self._arguments[2]}-{chunk}-{self._number}-{id(self):x}"
        future = self._client.submit(ensure, *self._arguments, chunk, key=key, pure=False, retries=0)
        self._running[future] = chunk
        future.add_done_callback(lambda _: self._news.set())

    def _end(self, future: Any) -> None:
        """Count a chunk that is done, or give one again whose worker was lost."""
        from concurrent.futures import CancelledError

        from distributed import KilledWorker

        chunk = self._running.pop(future)
        try:
            told = future.result(timeout=PATIENCE)
        except ClubfaceError:
            raise
        except ModuleNotFoundError as error:
            message = f"has a worker without {error.name}; install the same clubface there, with its extra tables"
            raise LinkError(self._address, message) from None
        except (KilledWorker, CancelledError, TimeoutError, OSError):
            self._lost[chunk] = self._lost.get(chunk, 0) + 1
            if self._client.status == "closed":
                raise LinkError(self._address, "is gone, the scheduler of the cluster") from None
            if self._lost[chunk] >= TRIES:
                raise LinkError(self._address, f"has lost the workers of chunk {chunk} {TRIES} times") from None
            self._again.append(chunk)
            return
        finally:
            with suppress(Exception):
                future.release()
        self._lost.pop(chunk, None)
        self._done(chunk, told)

    def _threads(self, *, wait: bool = True) -> int:
        """Return the threads of all workers; wait for the first of these."""
        ends = time.monotonic() + LONE
        while True:
            with suppress(OSError, TimeoutError):
                if (count := sum(self._client.nthreads().values())) or not wait:
                    return count
            if not wait:
                return 0
            if time.monotonic() > ends:
                raise LinkError(self._address, f"has had no worker for {LONE:.0f} s; start some")
            time.sleep(0.1)


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep Dask's log of lost connections from the screen: what they mean is told in one line."""
    before = {name: logging.getLogger(name).level for name in LOGGERS}
    for name in LOGGERS:
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for name, level in before.items():
            logging.getLogger(name).setLevel(level)
