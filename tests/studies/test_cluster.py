"""A study on a real Dask cluster: a scheduler and workers, which are processes of their own and are killed."""

import json
import os
import socket
import subprocess
import sys
import threading
import time
from concurrent.futures import Future
from contextlib import contextmanager, suppress
from importlib.util import find_spec

import pytest

from clubface import studies
from clubface.errors import ClubfaceError, LinkError
from clubface.jobs import workers as jobs_workers
from study_files import squares, sums

pytest.importorskip("pyarrow")
pytestmark = [
    # Imported by the tests that run: it takes a second, which every process that collects would spend.
    pytest.mark.skipif(find_spec("distributed") is None, reason="the extra cluster is not installed"),
    pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::ResourceWarning"),
]


@contextmanager
def processes(*commands):
    """Modules of Dask as processes, ended with all that they have started."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    running = []
    try:
        for command in commands:
            quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
            running.append(subprocess.Popen([sys.executable, "-m", *command], env=environment, **quiet))
        yield running
    finally:
        for each in running:
            each.kill()
            each.wait()


@contextmanager
def scheduler(folder):
    """The address of a scheduler, and its process."""
    file = folder / "scheduler.json"
    command = ["distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard"]
    with processes([*command, "--scheduler-file", str(file)]) as (process,):
        ends = time.monotonic() + 60.0
        while time.monotonic() < ends:
            with suppress(OSError, ValueError):
                yield json.loads(file.read_text())["address"], process
                return
            time.sleep(0.05)
        pytest.fail("the scheduler has not started")


def workers(address, count):
    command = ["distributed.cli.dask_worker", address, "--no-nanny", "--nthreads", "1", "--no-dashboard"]
    return processes(*[[*command, "--name", str(number)] for number in range(count)])


def at(count, act):
    """A progress that acts when so many chunks are done."""
    return lambda done, whole: act() if done == count else None


def test_a_cluster_whose_worker_and_scheduler_are_killed_loses_nothing(tmp_path, monkeypatch, in_this_process):
    # Long enough for a scheduler on a busy machine; as long does the run wait for the one that is killed.
    monkeypatch.setattr(jobs_workers, "SCHEDULER_TIMEOUT", 10.0)

    whole, path = squares(tmp_path, name="whole.toml"), squares(tmp_path, seconds=0.005)
    studies.run(whole)
    with scheduler(tmp_path) as (address, boss), workers(address, 2) as (first, _):
        # The other worker goes on alone.
        done = studies.run(path, scheduler=address, shard="1/2", progress=at(2, first.kill))
        # A chunk that the killed worker had stored and not yet told of is found when it is given again.
        assert done.computed in (9, 10)
        assert done.missing == 10
        with pytest.raises(ClubfaceError, match=r"is lost: .* of 20 chunks"):
            studies.run(path, scheduler=address, progress=at(3, boss.kill))
    done = studies.run(path)
    assert 0 < done.computed <= 7
    assert sums(path) == sums(whole)


def test_an_address_without_a_scheduler_is_reported(tmp_path, monkeypatch):
    monkeypatch.setattr(jobs_workers, "SCHEDULER_TIMEOUT", 1.0)
    with pytest.raises(LinkError, match=r"127.0.0.1:9 is not a scheduler that answers"):
        studies.run(squares(tmp_path), scheduler="127.0.0.1:9")


@pytest.mark.parametrize("says", [None, b"HTTP/1.0 400 Bad Request\r\n\r\n", b"\x01" + bytes(7) + b"\xff" * 8])
def test_a_server_that_is_no_scheduler_is_reported_in_time(tmp_path, monkeypatch, says):
    """One that says nothing, one of the web, and one that announces a message of 2^64 bytes."""
    monkeypatch.setattr(jobs_workers, "SCHEDULER_TIMEOUT", 1.0)
    server = socket.create_server(("127.0.0.1", 0))

    def serve():
        with suppress(OSError):
            while True:
                each, _ = server.accept()
                heard.append(each)
                if says is not None:
                    each.sendall(says)

    heard = []
    threading.Thread(target=serve, daemon=True).start()
    begun = time.monotonic()
    with server, pytest.raises(LinkError, match="is not a scheduler that answers"):
        studies.run(squares(tmp_path), scheduler=f"tcp://127.0.0.1:{server.getsockname()[1]}")
    assert heard
    assert time.monotonic() - begun < 60.0  # it waited without end


def test_the_address_of_a_worker_is_reported(tmp_path):
    with scheduler(tmp_path) as (address, _), workers(address, 1):
        from distributed import Client

        with Client(address) as client:
            client.wait_for_workers(1, timeout=60)
            (worker,) = client.scheduler_info()["workers"]
        with pytest.raises(LinkError, match="is a worker of the cluster"):
            studies.run(squares(tmp_path), scheduler=worker)


class Lost:
    """A client whose workers are lost over some chunks, so many times."""

    status = "running"

    def __init__(self, losses):
        self.losses, self.given = dict(losses), []

    def nthreads(self):
        return {"one": 1}

    def get_executor(self, **options):
        return self

    def submit(self, function, chunk):
        self.given.append(chunk)
        self.losses[chunk] = left = self.losses.get(chunk, 0) - 1
        return self.ended(chunk, left >= 0)

    def ended(self, chunk, lost):
        future = Future()
        if lost:
            future.cancel()
            future.set_running_or_notify_cancel()
        else:
            future.set_result(chunk)
        return future


def computed_by(client):
    return dict(jobs_workers._on_client(client, range(5), abs, "here"))


def test_a_chunk_that_the_scheduler_has_lost_is_given_to_it_again():
    client = Lost({1: 2, 4: jobs_workers.MAX_LOSSES - 1})
    assert computed_by(client) == {chunk: chunk for chunk in range(5)}
    assert sorted(client.given) == [0, 1, 1, 1, 2, 3, *[4] * jobs_workers.MAX_LOSSES]


def test_a_chunk_over_which_worker_after_worker_is_lost_is_given_up():
    with pytest.raises(LinkError, match="has lost the workers of chunk 2 5 times"):
        computed_by(Lost({2: 100}))


class Silent(Lost):
    """A client that hears nothing of its chunks."""

    def ended(self, chunk, lost):
        return Future()


def test_a_scheduler_that_is_silent_for_a_while_is_waited_for(monkeypatch):
    away = Lost({})
    away.status = "connecting"
    assert computed_by(away) == {chunk: chunk for chunk in range(5)}
    monkeypatch.setattr(jobs_workers, "SCHEDULER_TIMEOUT", 0.3)
    silent = Silent({})
    silent.status = "connecting"
    begun = time.monotonic()
    with pytest.raises(LinkError, match="is lost: the scheduler of the cluster"):
        computed_by(silent)
    assert time.monotonic() - begun > 0.3


def test_a_scheduler_that_has_closed_is_not_waited_for(monkeypatch):
    """A minute would be: nothing of this takes as long on any machine."""
    monkeypatch.setattr(jobs_workers, "SCHEDULER_TIMEOUT", 60.0)
    silent = Silent({})
    silent.status = "closed"
    begun = time.monotonic()
    with pytest.raises(LinkError, match="is lost: the scheduler of the cluster"):
        computed_by(silent)
    assert time.monotonic() - begun < 60.0
