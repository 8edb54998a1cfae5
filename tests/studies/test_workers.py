"""Workers, commands and machines that die at any moment lose nothing that is finished."""

import os
import random
import signal
import subprocess
import sys
import time

import pytest

from clubface import studies
from clubface.errors import ClubfaceError
from command_line import press_ctrl_c
from study_files import shots, squares, started, sums

pytest.importorskip("pyarrow")

KILLER = """
import os, signal
replace = os.replace
def killed(source, target, **options):
    folder = os.environ.get("KILLED_RENAMES")
    if folder and os.sep + "parts" + os.sep in os.fspath(target):
        number = len(os.listdir(folder))
        open(os.path.join(folder, str(number)), "w").close()
        if number % 3 == 0:
            os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))
    return replace(source, target, **options)
os.replace = killed
"""
"""What makes every third worker that is about to give a part its name die before it does, as when the power fails."""


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory):
    path = squares(tmp_path_factory.mktemp("undisturbed"))
    studies.run(path, workers=1)
    return sums(path)


def children(pid):
    """The processes that a process has started."""
    with open(f"/proc/{pid}/task/{pid}/children") as file:
        return [int(each) for each in file.read().split()]


def left(folder):
    return [each.name for each in folder.rglob(".*")]


def test_workers_killed_between_writing_and_renaming_lose_nothing(tmp_path, undisturbed):
    (tmp_path / "killer").mkdir()
    (tmp_path / "killer" / "sitecustomize.py").write_text(KILLER)
    (tmp_path / "renames").mkdir()
    path = squares(tmp_path)
    command = started(
        "study", "run", path, "--workers", "2", path=[tmp_path / "killer"], KILLED_RENAMES=str(tmp_path / "renames")
    )
    _, message = command.communicate(timeout=240)
    assert command.returncode == 0, message
    renames = len(os.listdir(tmp_path / "renames"))
    assert renames - (renames + 2) // 3 == 20  # every chunk once, beside those that were killed
    assert sums(path) == undisturbed
    assert left(tmp_path / "squares.store") == []


@pytest.mark.skipif(not os.path.exists("/proc/self/task") or os.name == "nt", reason="needs /proc")
def test_workers_killed_at_random_are_replaced(tmp_path, undisturbed):
    path = squares(tmp_path, seconds=0.005)
    command, random_, killed = started("study", "run", path, "--workers", "2"), random.Random(1), 0
    while command.poll() is None and killed < 3:
        time.sleep(random_.uniform(0.1, 0.4))
        for worker in children(command.pid)[:1]:
            os.kill(worker, signal.SIGKILL)
            killed += 1
    _, message = command.communicate(timeout=240)
    assert command.returncode == 0, message
    assert killed
    assert sums(path) == undisturbed


@pytest.mark.parametrize("end", [subprocess.Popen.kill, press_ctrl_c])
def test_a_command_that_is_killed_is_gone_on_with(tmp_path, undisturbed, end):
    path, store = squares(tmp_path, seconds=0.01), tmp_path / "squares.store"
    command = started("study", "run", path, "--workers", "2")
    ends = time.monotonic() + 120.0
    while len(list(store.rglob("0*.parquet"))) < 3 and time.monotonic() < ends:
        time.sleep(0.02)
    end(command)
    begun = time.monotonic()
    _, message = command.communicate(timeout=60)
    if end is press_ctrl_c:
        assert command.returncode == 130
        assert "of 20 chunks are done and kept in" in message
        assert time.monotonic() - begun < 2.0  # 0.1 s on a machine that has nothing else to do
    done = studies.run(path, workers=1)
    assert 0 < done.computed < 20
    assert sums(path) == undisturbed


def test_an_error_in_a_chunk_ends_the_run_and_keeps_the_others(tmp_path):
    path = squares(tmp_path)
    studies.run(path, workers=1, shard="1/2")
    (tmp_path / "squares.store" / "parts" / "0000" / "00000005.parquet").mkdir()
    with pytest.raises(ClubfaceError, match=r"00000005.parquet: this is a folder.*chunks are done and kept in"):
        studies.run(path, workers=1)
    assert studies.status(path).done > 10


MEMORY = """
import resource, sys
from clubface import studies
studies.run(sys.argv[1], workers=2)
studies.join(sys.argv[1])
studies.summary(sys.argv[1])
print(*(resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)))
"""
"""Runs a study and prints the most memory that this process and a worker had [kB]."""


@pytest.mark.study
def test_a_hundred_thousand_tasks_take_no_more_memory_than_a_thousand(tmp_path):
    """A hundred times the parts; libraries that are loaded, and what they keep of what they free, differ by 10 MB."""
    peaks = []
    for count in (1_000, 100_000):
        path = squares(tmp_path, count=count, name=f"of-{count}.toml")
        ran = subprocess.run([sys.executable, "-c", MEMORY, path], capture_output=True, text=True, check=True)
        peaks.append([int(each) for each in ran.stdout.split()])
    print(peaks)
    assert all(large - small < 10_000 for small, large in zip(*peaks, strict=True))


@pytest.mark.study
@pytest.mark.parametrize("seed", range(3))
def test_a_study_killed_twenty_times_ends_with_the_same_sums(tmp_path, seed):
    whole, path, random_ = shots(tmp_path, name="whole.toml", chunk=1), shots(tmp_path, chunk=1), random.Random(seed)
    studies.run(whole, workers=1)
    for kill in range(20):
        command = started("study", "run", path, "--workers", "2")
        time.sleep(random_.uniform(0.0, 3.0))
        for worker in children(command.pid) if command.poll() is None and kill % 3 == 0 else ():
            os.kill(worker, signal.SIGKILL)
        command.send_signal(signal.SIGINT if kill % 2 else signal.SIGKILL)
        command.communicate()
        if kill % 5 == 4 and begun(path):
            for part in random_.sample(sorted((tmp_path / "shots.store" / "parts").rglob("0*.parquet")), 1):
                part.unlink()
    studies.run(path, workers=2)
    assert sums(path) == sums(whole)


def begun(path):
    return any((path.parent / f"{path.stem}.store").rglob("0*.parquet"))
