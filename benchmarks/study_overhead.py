"""What a study costs besides the work itself, and how it grows: the figures of docs/studies.md.

``python benchmarks/study_overhead.py [CHUNKS]`` takes two to five minutes; CHUNKS empty chunks are written (2000 unless
given). On a machine that does other work, the times of a processor still hold, those of a clock do not.
"""

from __future__ import annotations

import os
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from clubface import studies
from clubface.jobs.workers import Shard, in_processes
from clubface.studies.axes import SweepAxis
from clubface.studies.designs import Grid, Samples
from clubface.studies.running import order
from clubface.studies.store import StudyStore, open_store

EMPTY = """
[study]
kind = "empty"
chunk = 1
[empty]
seconds = {seconds}
[sweep]
x = {{ from = 0, to = 1, count = {count} }}
"""
SHOTS = """
[study]
design = "sobol"
samples = 1_048_576
[impact]
club = "driver"
[sweep]
speed = { from = "90 mph", to = "120 mph" }
attack = { from = "-5 deg", to = "5 deg" }
path = { from = "-5 deg", to = "5 deg" }
loft = { from = "8 deg", to = "14 deg" }
toe = { from = "-20 mm", to = "20 mm" }
high = { from = "-10 mm", to = "10 mm" }
"""


def measured(run: Callable[[], object]) -> tuple[float, float]:
    """Return the time of a clock and the time of processors that a call takes, with its workers [s]."""
    begun, used = time.monotonic(), _used()
    run()
    return time.monotonic() - begun, _used() - used


def _used() -> float:
    each = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in each)


def empty(folder: Path, name: str, count: int, seconds: float) -> Path:
    """Return a study of chunks of one task that takes some time."""
    path = folder / f"{name}.toml"
    path.write_text(EMPTY.format(count=count, seconds=seconds))
    return path


def long_chunks(folder: Path) -> None:
    """Chunks of 1 s: overhead, and the speed-up of two workers."""
    count = 20
    clocks = {}
    for workers in (1, 2):
        path = empty(folder, f"long-{workers}", count, 1.0)
        steady: list[float] = []
        clock, used = measured(
            lambda path=path, workers=workers, steady=steady: studies.run(
                path, workers=workers, progress=lambda done, whole: steady.append(time.monotonic())
            )
        )
        clocks[workers] = clock
        # The probe of the study computes one task of the count.
        print(f"{workers} workers, {count} chunks of 1 s of a processor: {clock:.2f} s of a clock,", end=" ")
        print(f"{used:.2f} s of processors: {used / (count + 1) - 1:.2%} overhead", end=", ")
        print(f"{(steady[-1] - steady[0]) / (count - workers) * workers - 1:.2%} of the clock between chunks")
    print(f"speed-up of two workers: {clocks[1] / clocks[2]:.2f} ({os.getloadavg()[0]:.1f} processes were running)")


def empty_chunks(folder: Path, count: int) -> None:
    """Empty chunks: what each costs when it is written, and when it is only handed out."""
    path = empty(folder, "empty", count, 0.0)
    clock, used = measured(lambda: studies.run(path, workers=2))
    size = open_store(path).size() / count
    print(f"{count} empty chunks: {1e3 * used / count:.2f} ms of a processor each, {1e3 * clock / count:.2f} ms of a")
    print(f"  clock with two workers; {size:.0f} bytes a part")
    clock, used = measured(lambda: studies.run(path, workers=2))
    print(f"  checked again: {1e3 * used / count:.2f} ms of a processor each")


def handed_out(folder: Path) -> None:
    """A million chunks, none of them there, handed out to workers that do nothing."""
    many = 1_000_000
    store = StudyStore(folder / "none", {"count": many, "chunk": 1, "content": {}})
    _, used = measured(lambda: sum(1 for _ in in_processes(order(store, Shard(1, 1)), abs, workers=2)))
    print(f"{many} chunks handed out to workers that do nothing: {1e6 * used / many:.0f} us of a processor each")


def shots(folder: Path) -> None:
    """Shots with six inputs and eight results: time and bytes of each."""
    path = folder / "shots.toml"
    path.write_text(SHOTS)
    _, used = measured(lambda: studies.run(path, workers=2))
    store = open_store(path)
    print(f"{store.count} shots with flight, {store.record['chunk']} a chunk: {1e6 * used / store.count:.1f} us of a")
    print(f"  processor each, {store.size() / store.count:.0f} bytes")
    _, used = measured(lambda: studies.join(path, folder / "shots.parquet"))
    print(f"  joined: {1e6 * used / store.count:.2f} us each")


def full_count() -> None:
    """The inputs at the end of a thousand million tasks."""
    count = 1000**3
    axes = [SweepAxis(name=name, unit="1", ends=(0.0, 1.0), count=1000) for name in "abc"]
    _, used = measured(lambda: Grid(axes).values(range(count - 1000, count)))
    print(f"the last 1000 tasks of a grid of 10^9: {1e3 * used:.2f} ms")
    spans = [SweepAxis(name=name, unit="1", ends=(0.0, 1.0)) for name in "abcdef"]
    made = Samples(spans, count, "sobol", 1)
    _, used = measured(lambda: made.values(range(count - 1000, count)))
    print(f"the last 1000 points of a Sobol sequence of 10^9 in 6 dimensions: {used:.1f} s, once a worker")


def cluster(folder: Path) -> None:
    """Empty chunks on a Dask cluster of two processes."""
    try:
        from distributed import LocalCluster
    except ImportError:
        return
    count = 500
    made: Any  # distributed types a cluster as if it were always asynchronous
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0") as made:
        path = empty(folder, "cluster", count, 0.0)
        clock, _ = measured(lambda: studies.run(path, scheduler=made.scheduler_address))
        print(f"{count} empty chunks on a Dask cluster of two workers: {1e3 * clock / count:.1f} ms of a clock each")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        long_chunks(Path(name))
        empty_chunks(Path(name), int(sys.argv[1]) if len(sys.argv) > 1 else 2000)
        handed_out(Path(name))
        shots(Path(name))
        full_count()
        cluster(Path(name))
    for who, words in ((resource.RUSAGE_SELF, "command"), (resource.RUSAGE_CHILDREN, "largest worker")):
        print(f"most memory of the {words}: {resource.getrusage(who).ru_maxrss / 1024:.0f} MB")
