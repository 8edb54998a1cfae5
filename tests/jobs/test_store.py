"""What is kept of unfinished work: whole, of this work alone, and used by one process at a time."""

import os
import subprocess
import sys

import pytest

from clubface.errors import FileError
from clubface.jobs.lock import Lock
from clubface.jobs.store import Store


@pytest.fixture
def folder(tmp_path):
    return tmp_path / "out.unfinished"


def test_finished_values_are_there_again_with_all_their_digits(folder):
    with Store(folder, {"speed": 1.0}) as store:
        store.keep("a", [0.1, float("nan"), None])
    with Store(folder, {"speed": 1.0}) as store:
        assert store.resumed == ("a",)
        assert store["a"][::2] == [0.1, None]
        assert store.once("b", lambda: 2) == store.once("b", lambda: 3) == 2


def test_other_work_is_refused_or_begun_anew(folder):
    with Store(folder, {"speed": 1.0}) as store:
        store.keep("a", 1)
        store.keep_part("piece", b"part")
    with pytest.raises(FileError, match="begun with another speed"):
        Store(folder, {"speed": 2.0})
    record = folder / "job.json"
    whole = record.read_text()
    record.write_text(whole[:-9])
    with pytest.raises(FileError, match="begun as other work, whose record is damaged"):
        Store(folder, {"speed": 2.0})
    with Store(folder, {"speed": 1.0}) as store:  # each value says whose it is
        assert store.resumed == ("a",)
    assert record.read_text() == whole
    with Store(folder, {"speed": 2.0}, resume=False) as store:
        assert not len(store)
        assert not (folder / "parts").exists()
    assert not folder.exists()  # nothing was kept


def test_values_of_other_work_are_never_taken_for_those_of_this_one(folder, tmp_path):
    with Store(folder, {"speed": 1.0}) as store:
        store.keep("a", 1)
    with Store(tmp_path / "other.unfinished", {"speed": 2.0}) as store:
        store.keep("b", 2)
    values = (folder / "values.jsonl").read_bytes()
    with (tmp_path / "other.unfinished" / "values.jsonl").open("ab") as file:
        file.write(values)
    assert Store(tmp_path / "other.unfinished", {"speed": 2.0}).resumed == ("b",)


def test_a_part_that_is_damaged_or_gone_is_none(folder):
    with Store(folder, {}) as store:
        checksum = store.keep_part("piece", b"part")
        path = store.part("piece", checksum)
        assert path.read_bytes() == b"part"
        path.write_bytes(b"Part")
        assert store.part("piece", checksum) is None
        path.unlink()
        assert store.part("piece", checksum) is None


def test_a_result_that_cannot_be_written_leaves_the_one_before_and_all_parts(folder, tmp_path):
    target = tmp_path / "out"
    target.write_text("of an earlier day")

    def write(file):
        file.write(b"half")
        raise FileError(str(target), None, "a part is gone")

    with Store(folder, {}, output=target) as store:
        store.keep("a", 1)
        with pytest.raises(FileError, match="a part is gone"):
            store.write_result(target, write)
    assert target.read_text() == "of an earlier day"
    with Store(folder, {}, output=target) as store:
        assert store.resumed == ("a",)
        store.write_result(target, lambda file: file.write(b"whole"))
        store.remove()
    assert target.read_bytes() == b"whole"
    assert not folder.exists()


def test_a_full_disk_costs_no_more_than_what_is_being_written(folder):
    resource = pytest.importorskip("resource", reason="no files of limited size")
    with Store(folder, {}) as store:
        store.keep("a", 1)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    try:
        resource.setrlimit(resource.RLIMIT_FSIZE, (4096, limits[1]))
        with pytest.raises(FileError, match="cannot be written: File too large"), Store(folder, {}) as store:
            store.keep("b", "b" * 5000)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    with Store(folder, {}) as store:
        assert store.resumed == ("a",)
        store.keep("c", 3)
    assert Store(folder, {}).resumed == ("a", "c")


@pytest.mark.parametrize("name", ["diary.txt", "values.json"])
def test_a_folder_of_something_else_is_left_alone(folder, name):
    folder.mkdir()
    (folder / name).write_text("mine")
    for resume in (True, False):
        with pytest.raises(FileError, match="not a record of unfinished work"):
            Store(folder, {}, resume=resume)
    assert [each.name for each in folder.iterdir()] == [name]


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
def test_work_that_another_process_does_is_left_to_it_and_the_dead_hold_nothing(folder, tmp_path):
    ready, signal_ready = os.pipe()
    child = os.fork()
    if not child:
        with Store(folder, {"club": "driver"}) as store:
            store.keep("a", 1)
            store.flush()
            os.write(signal_ready, b"x")
            os.read(os.pipe()[0], 1)
    os.read(ready, 1)
    for content in ({"club": "driver"}, {"club": "3-wood"}):
        with pytest.raises(FileError, match=f"process {child} is writing this"):
            Store(folder, content, resume=False)
    os.kill(child, 9)
    os.waitpid(child, 0)
    assert Store(folder, {"club": "driver"}).resumed == ("a",)


def test_a_lock_is_free_once_its_process_is_dead(tmp_path):
    path = tmp_path / "lock"
    hold = "import sys; from pathlib import Path; from clubface.jobs.lock import Lock; "
    hold += "lock = Lock(Path(sys.argv[1]), Path('out')); print(flush=True); input()"
    child = subprocess.Popen([sys.executable, "-c", hold, path], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    child.stdout.readline()
    with pytest.raises(FileError, match=f"out: process {child.pid} is writing this"):
        Lock(path, tmp_path / "out")
    child.kill()
    child.communicate()
    Lock(path, path).close()
    assert not path.exists()


def test_a_lock_whose_file_is_removed_while_it_is_taken_is_taken_on_a_new_one(tmp_path, monkeypatch):
    from clubface.jobs import lock

    pytest.importorskip("fcntl", reason="Windows removes no file that is open")
    path, flock, removed = tmp_path / "lock", lock.fcntl.flock, []

    def overtaken(handle, flags):
        flock(handle, flags)
        if not removed:
            removed.append(path.unlink())

    monkeypatch.setattr(lock.fcntl, "flock", overtaken)
    held = Lock(path, path)
    assert path.read_text() == str(os.getpid())
    with pytest.raises(FileError, match="is writing this"):
        Lock(path, path)
    held.close()
