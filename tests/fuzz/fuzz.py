"""Damaged files for every reader: whatever is neither read nor refused in one line is a finding, kept as a file.

Each input follows from the seed and its number alone, so that ``--only NUMBER`` makes a finding again. Inputs run in
processes of their own, one for each core, with a limit of memory; one that crashes, or hangs in a library, costs that
process, and is a finding.
"""

from __future__ import annotations

import argparse
import math
import multiprocessing
import os
import queue
import resource
import shutil
import sys
import tempfile
import threading
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1] / "helpers"))

PATIENCE = 60.0
"""Seconds after which a process that tells nothing is taken for lost."""
MEMORY = 6 * 2**30
"""Bytes of address space of a process; libraries and threads take two."""
PIECE = 2000
"""Inputs that a process is given at once; it takes a second to start."""
SHOWN = 3
"""Findings of one kind that are kept; more say nothing new."""
SPAWN = multiprocessing.get_context("spawn")


def work(seed: int, numbers: range, folder: str, results: Any) -> None:
    """Read inputs, telling the number of each before and what came of it after."""
    from fuzz_input import content, finding
    from fuzz_readers import READERS

    tempfile.tempdir = folder  # what readers make goes with it
    for reader in READERS.values():
        reader.seeds()  # they may take longer than an input
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    for number in numbers:
        name, data = content(seed, number)
        path = Path(folder) / f"input.{READERS[name].ending}"
        path.write_bytes(data)
        results.send((number, name, None))
        result = finding(name, path, measure=number % 20 == 0)
        results.send((number, name, result or ""))
    results.send(None)


class Worker:
    """A process that reads inputs."""

    def __init__(self, seed: int, numbers: range) -> None:
        self.seed, self.numbers = seed, numbers
        self.folder = tempfile.mkdtemp(prefix="clubface-fuzz-")
        self.start(numbers)

    def start(self, numbers: range) -> None:
        self.results, theirs = SPAWN.Pipe(duplex=False)
        self.process = SPAWN.Process(target=work, args=(self.seed, numbers, self.folder, theirs))
        self.process.start()
        theirs.close()

    def findings(self) -> Any:
        """Yield number, reader and finding ("" for none) of each input, until all are read."""
        number, name = self.numbers.start, ""
        while True:
            try:
                if not self.results.poll(PATIENCE):
                    raise EOFError
                report = self.results.recv()
            except EOFError:
                self.process.kill()
                self.process.join()
                yield number, name, f"the process ended with {self.process.exitcode}, or hung"
                if number + 1 >= self.numbers.stop:
                    break
                self.start(range(number + 1, self.numbers.stop))
                continue
            if report is None:
                break
            number, name, result = report
            if result is not None:
                yield number, name, result
        self.end()

    def end(self) -> None:
        """Stop the process, wherever it is, and remove its folder."""
        self.process.kill()
        self.process.join()
        shutil.rmtree(self.folder, ignore_errors=True)


def fuzz(seed: int, numbers: range, output: Path, *, seconds: float, workers: int) -> int:
    """Read inputs, until all are read or the time is over, and write findings to a folder; return their number."""
    pieces = iter([range(at, min(at + PIECE, numbers.stop)) for at in range(numbers.start, numbers.stop, PIECE)])
    reports: queue.SimpleQueue[Any] = queue.SimpleQueue()
    began, taking = time.monotonic(), threading.Lock()

    def over() -> bool:
        return time.monotonic() - began > seconds

    def read() -> None:
        try:
            while not over():
                with taking:
                    piece = next(pieces, None)
                if piece is None:
                    break
                worker = Worker(seed, piece)
                for each in worker.findings():
                    reports.put(each)
                    if over():
                        worker.end()
                        break
        finally:
            reports.put(None)

    kinds: Counter[str] = Counter()
    done, running = 0, workers
    with ThreadPoolExecutor(workers) as pool:
        for _ in range(workers):
            pool.submit(read)
        while running:
            result = reports.get()
            if result is None:
                running -= 1
                continue
            done += 1
            number, name, computed = result
            if computed:
                kind = f"{name}: {computed.partition(':')[0]}"
                kinds[kind] += 1
                if kinds[kind] <= SHOWN:
                    keep(seed, number, computed, output)
            if done % 100 == 0:
                rate = f"{done / (time.monotonic() - began):.0f} a second"
                end = "\n" if done % 10_000 == 0 else "\r"
                print(f"{done} inputs, {sum(kinds.values())} findings, {rate}", end=end, flush=True)
    print(f"{done} inputs in {time.monotonic() - began:.0f} s, {sum(kinds.values())} findings")
    for kind, count in kinds.most_common():
        print(f"{count:6} {kind}")
    return sum(kinds.values())


def keep(seed: int, number: int, result: str, output: Path) -> None:
    """Write an input and what was found with it, named as the corpus of the tests names them."""
    from fuzz_input import content
    from fuzz_readers import READERS

    name, data = content(seed, number)
    output.mkdir(parents=True, exist_ok=True)
    path = output / f"{name}--{seed}-{number}.{READERS[name].ending}"
    path.write_bytes(data)
    path.with_suffix(".txt").write_text(f"seed {seed}, input {number}: {result}\n")
    print(f"{path}: {result}", flush=True)


def main() -> None:
    """Read the command line, and leave with status 1 if there is a finding."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=1_000_000, help="number of inputs")
    parser.add_argument("--seconds", type=float, default=math.inf, help="end after this time, whatever the count")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="processes at a time")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", type=int, help="number of one input to make and read again, in this process")
    parser.add_argument("--output", type=Path, default=Path("out/fuzz"), help="folder for findings")
    given = parser.parse_args()
    if given.only is None:
        how = {"seconds": given.seconds, "workers": given.workers}
        sys.exit(fuzz(given.seed, range(given.count), given.output, **how) > 0)
    from fuzz_input import content
    from fuzz_readers import READERS

    name, data = content(given.seed, given.only)
    given.output.mkdir(parents=True, exist_ok=True)
    path = given.output / f"{name}--{given.seed}-{given.only}.{READERS[name].ending}"
    path.write_bytes(data)
    print(f"{path}: {len(data)} bytes for {name}")
    READERS[name].read(path)


if __name__ == "__main__":
    main()
