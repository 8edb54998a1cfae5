"""Threads that compute at once have the results of one thread, with and without Python's global lock."""

import json
import subprocess
import sys
import sysconfig
import threading
import warnings
from pathlib import Path

import pytest

from clubface.support.checks import without_foreign_warnings

THREADS, ROUNDS = 4, 1


@pytest.fixture(scope="module")
def report():
    """What a process did whose threads came upon empty caches and registries together."""
    helper = Path(__file__).parent / "helpers" / "thread_results.py"
    command = [sys.executable, str(helper), str(THREADS), str(ROUNDS)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_results_of_several_threads_are_those_of_one_to_the_last_bit(report):
    assert report["raised"] == []
    assert report["different"] == []
    assert set(report["computed"].values()) == {THREADS * ROUNDS}


def test_a_warning_is_given_once_by_all_threads_together(report):
    assert set(report["warned"].values()) == {1}


def test_an_interpreter_without_the_global_lock_runs_without_it_after_the_core_is_loaded(report):
    assert report["locked"] is not bool(sysconfig.get_config_var("Py_GIL_DISABLED"))


def test_filters_of_warnings_are_what_they_were_after_two_threads_changed_them():
    """The second thread waits until the first has put the filters back, else it would keep those of the first."""
    before = list(warnings.filters)
    entered = threading.Event()

    def ignoring():
        with without_foreign_warnings():
            entered.set()

    second = threading.Thread(target=ignoring)
    with without_foreign_warnings():
        second.start()
        assert not entered.wait(0.2)
    second.join()
    assert list(warnings.filters) == before
