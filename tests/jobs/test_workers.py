"""Threads, processes and clusters compute all parts, replace what dies, and stop at once when they are interrupted."""

import os
import subprocess
import sys
import threading
import time
from functools import partial

import pytest

import job_parts
from clubface.errors import RunError
from clubface.jobs import Job, Store, run, workers
from clubface.jobs.workers import in_processes, in_threads
from command_line import interruptible, press_ctrl_c


@pytest.mark.parametrize(
    ("points", "count", "threads"),
    [
        (4, 2, [1, 1, 1, 1]),
        (5, 2, [1, 1, 1, 1, 2]),
        (1, 8, [8]),
        (3, 8, [2, 2, 2]),
        (3, 1, [1, 1, 1]),
        (0, 2, []),
        # More workers than cores get no more threads than there are.
        (1, 100, [8]),
        (20, 100, [1] * 20),
    ],
)
def test_no_core_is_left_without_work_at_the_end(points, count, threads, monkeypatch):
    monkeypatch.setattr(workers, "processors", lambda: 8)
    given = {}

    def compute(point, keep_going, threads):
        keep_going(0.0, 1.0)
        given[point] = threads
        return -point

    ended = list(in_threads(range(points), compute, workers=count))
    assert [given[point] for point in range(points)] == threads
    assert sorted(ended) == [(point, -point) for point in range(points)]


def test_a_failure_ends_the_other_threads_and_is_raised():
    others, stopped = threading.Event(), threading.Event()

    def compute(point, keep_going, _):
        if point == 0:
            assert others.wait(10.0)
            raise ValueError("no such run")
        others.set()
        while not stopped.wait(0.01):
            try:
                keep_going(0.0, 1.0)
            except KeyboardInterrupt:
                stopped.set()
        raise KeyboardInterrupt

    with pytest.raises(ValueError, match="no such run"):
        list(in_threads(range(2), compute, workers=2))
    assert stopped.is_set()


def test_killed_processes_lose_nothing(tmp_path):
    """Of eight parts three kill their process once, and with it what the other one computes."""
    marks = tmp_path / "marks"
    marks.mkdir()
    with Store(tmp_path / "out.unfinished", {}) as store:
        job = Job("squares", range(8), partial(job_parts.dies_once, str(marks)))
        results = run(job, partial(in_processes, workers=2), store=store)
    assert results == {part: job_parts.square(part) for part in range(8)}
    assert len(list(marks.iterdir())) == 3


def test_a_part_that_kills_every_process_is_given_up():
    with pytest.raises(RunError, match="3 workers died over chunk 5"):
        list(in_processes([5], job_parts.dies, workers=1))
    with pytest.raises(RunError, match="not enough memory for chunk 7"):
        list(in_processes([7], job_parts.lacks_memory, workers=1))


def test_a_process_has_one_thread_no_ctrl_c_and_an_identity_of_its_own():
    ((_, (threads, process, ignores)),) = in_processes(["OPENBLAS_NUM_THREADS"], job_parts.environment, workers=1)
    assert (threads, ignores) == ("1", True)
    assert process != os.getpid()


PROGRAM = """
import sys
from functools import partial
from pathlib import Path
from clubface.jobs import Job, Store, run
from clubface.jobs.workers import in_processes
import job_parts

print("begun", flush=True)
with Store(Path(sys.argv[1]), {}) as store:
    run(Job("squares", range(200), job_parts.square_slowly), partial(in_processes, workers=2), store=store)
"""
"""A script, which does not ask whether it is the main program: its workers must not run it again."""


@pytest.mark.parametrize("end", [subprocess.Popen.kill, press_ctrl_c])
def test_a_program_that_is_killed_is_gone_on_with_and_leaves_no_process(tmp_path, end):
    script, folder = tmp_path / "script.py", tmp_path / "out.unfinished"
    script.write_text(PROGRAM)
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    child = interruptible([sys.executable, script, folder], env=environment)
    ends = time.monotonic() + 120.0
    while not (folder / "values.jsonl").exists() and time.monotonic() < ends:
        time.sleep(0.02)
    end(child)
    begun = time.monotonic()
    out, message = child.communicate(timeout=60)  # which waits for every process that holds its output
    assert time.monotonic() - begun < 2.0  # 0.1 s on a machine that has nothing else to do
    assert out == "begun\n"
    if end is press_ctrl_c:
        assert "of 200 squares are done; they are in" in message
    with Store(folder, {}) as store:
        assert 0 < len(store.resumed) < 200
        job = Job("squares", range(200), job_parts.square)
        assert run(job, store=store) == {part: job_parts.square(part) for part in range(200)}
