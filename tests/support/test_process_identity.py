"""A process is known by more than its number, which another gets once it has ended."""

import json
import os
import subprocess
import sys
import time

import pytest

from clubface.errors import FileError
from clubface.jobs import lock as locks
from clubface.jobs.lock import Lock, begun, is_running, this_process
from clubface.jobs.resuming import Store


def test_this_process_runs_and_one_of_its_number_that_began_earlier_does_not():
    me = this_process()
    assert is_running(me)
    assert not is_running({**me, "begun": f"{me['begun']}0"})
    assert not is_running({**me, "machine": "another"})
    for process in (0, -1, 2**40, "1", None, True, [1]):
        assert not is_running({**me, "process": process})


def test_a_process_that_has_ended_runs_no_more_even_if_nobody_has_asked_for_its_status():
    child = subprocess.Popen([sys.executable, "-c", ""])
    ends = time.monotonic() + 20
    while begun(child.pid) and time.monotonic() < ends:
        time.sleep(0.01)
    assert not begun(child.pid)
    child.wait()
    assert not begun(child.pid)
    for unknown in ("", None):  # of a machine that does not tell when a process began
        assert not is_running({**this_process(), "process": child.pid, "begun": unknown})


def test_a_reused_number_does_not_keep_unfinished_work_from_being_begun_anew(tmp_path, monkeypatch):
    folder = tmp_path / "out.csv.unfinished"
    said = {**this_process(), "process": os.getppid()}  # a number that another process has now
    with monkeypatch.context() as patch:
        patch.setattr("clubface.jobs.resuming.this_process", lambda: said)
        Store(folder, {"club": "driver"}, resume=False).keep("0", 1)
        store = Store(folder, {"club": "driver"}, resume=False)
        store.keep("1", 1)
        store.flush()
    assert not Store(folder, {"club": "3-wood"}, resume=False).resumed


def test_work_of_a_running_process_is_left_to_it(tmp_path, monkeypatch):
    folder = tmp_path / "out.csv.unfinished"
    other = {**this_process(), "process": os.getppid(), "begun": begun(os.getppid())}
    with monkeypatch.context() as patch:
        patch.setattr("clubface.jobs.resuming.this_process", lambda: other)
        store = Store(folder, {"club": "driver"}, resume=False)
        store.keep("1", 1)
        store.flush()
    with pytest.raises(FileError, match=f"process {os.getppid()} is writing this"):
        Store(folder, {"club": "3-wood"}, resume=False)


@pytest.mark.parametrize("has_locks", [True, False])
def test_one_of_two_runs_holds_a_lock_with_the_systems_help_or_without(tmp_path, monkeypatch, has_locks):
    if not has_locks:
        monkeypatch.setattr(locks, "_held_by_system", lambda handle: None)
    path = tmp_path / "live.csv.lock"
    held = Lock(path, tmp_path / "live.csv")
    with pytest.raises(FileError, match=f"live.csv: process {os.getpid()} is writing this"):
        Lock(path, tmp_path / "live.csv")
    held.release()
    path.write_text(json.dumps({**this_process(), "begun": "long ago"}))
    Lock(path, tmp_path / "live.csv").close()
    assert not path.exists()
