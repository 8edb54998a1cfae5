"""Files appear whole or not at all, and nothing else in the package writes them."""

import ast
import errno
import os
import stat
import sys

import pytest

from clubface.errors import FileError
from clubface.jobs.store import fingerprint
from clubface.support import files
from clubface.support.files import whole_file, whole_text, write_text
from package_sources import trees


def test_a_file_has_its_name_only_once_it_is_whole_and_synced(tmp_path, monkeypatch):
    path, done = tmp_path / "a.csv", []
    path.write_text("before")
    path.chmod(0o640)
    sync, replace = os.fsync, os.replace
    monkeypatch.setattr(os, "fsync", lambda handle: (done.append("sync"), sync(handle)))
    monkeypatch.setattr(os, "replace", lambda *names: (done.append("rename"), replace(*names)))
    with whole_file(path) as file:
        file.write(b"after")
        assert path.read_text() == "before"
    # The content, the name, the folder of the name, which Windows does not sync.
    assert done == ["sync", "rename", *([] if sys.platform == "win32" else ["sync"])]
    assert path.read_text() == "after"
    assert stat.S_IMODE(path.stat().st_mode) == 0o640 or sys.platform == "win32"
    assert os.listdir(tmp_path) == ["a.csv"]


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt])
def test_a_block_that_raises_leaves_what_was_there(tmp_path, error):
    path = write_text(tmp_path / "a.csv", "before")

    def write():
        with whole_text(path) as file:
            file.write("half of")
            raise error

    with pytest.raises(error):
        write()
    assert path.read_text() == "before"
    assert os.listdir(tmp_path) == ["a.csv"]


@pytest.mark.parametrize("call", ["fsync", "replace"])
def test_a_write_that_fails_at_the_end_is_reported_and_keeps_the_old_file(tmp_path, monkeypatch, call):
    path = write_text(tmp_path / "a.csv", "before")

    def full(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, call, full)
    with pytest.raises(FileError, match=r"a\.csv: cannot be written: No space left on device"):
        write_text(path, "after")
    assert path.read_text() == "before"
    assert os.listdir(tmp_path) == ["a.csv"]


def test_a_file_that_another_program_reads_is_replaced_once_it_is_closed(tmp_path, monkeypatch):
    path, replace, tries = write_text(tmp_path / "a.csv", "before"), os.replace, []

    def in_use(*names):
        tries.append(names)
        if len(tries) % 4:
            error = PermissionError(errno.EACCES, "Access is denied")
            error.winerror = 5
            raise error
        replace(*names)

    monkeypatch.setattr(os, "replace", in_use)
    monkeypatch.setattr(files, "PATIENCE", 10.0)
    assert write_text(path, "after").read_text() == "after"
    monkeypatch.setattr(files, "PATIENCE", 0.0)
    with pytest.raises(FileError, match=r"a\.csv: cannot be written: Access is denied; close it in other programs"):
        write_text(path, "later")
    assert path.read_text() == "after"
    assert os.listdir(tmp_path) == ["a.csv"]


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there, and pipes have no names in folders")
def test_links_are_followed_and_devices_and_folders_are_not_replaced(tmp_path):
    path = write_text(tmp_path / "a.csv", "before")
    link = tmp_path / "link.csv"
    link.symlink_to(path)
    write_text(link, "after")
    assert link.is_symlink()
    assert path.read_text() == "after"
    os.mkfifo(tmp_path / "pipe.csv")
    with pytest.raises(FileError, match="a device or a pipe"):
        write_text(tmp_path / "pipe.csv", "x")
    with pytest.raises(FileError, match="this is a folder"):
        write_text(tmp_path, "x")
    with pytest.raises(FileError, match="exists already; it is left as it is"):
        write_text(path, "x", new=True)
    assert path.read_text() == "after"
    assert write_text(tmp_path / "new.csv", "x", new=True).read_text() == "x"
    assert sorted(os.listdir(tmp_path)) == ["a.csv", "link.csv", "new.csv", "pipe.csv"]


def writers(nodes):
    """The lines that write a file by other means."""
    for node in nodes:
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        owner = getattr(getattr(node.func, "value", None), "id", "")
        modes = [each.value for each in node.args if isinstance(each, ast.Constant) and isinstance(each.value, str)]
        opens = name == "open" and any(set(mode) <= set("wax+bt") for mode in modes)
        if opens or (isinstance(node.func, ast.Attribute) and name in ("write_text", "write_bytes")):
            yield node.lineno
        if owner == "os" and name in ("replace", "rename", "open"):
            yield node.lineno


def test_files_are_written_in_one_place():
    result = {path for path, nodes in trees().items() if list(writers(nodes))}
    # The others open a lock, devices and pipes in the place of an output, or copy inputs for a library that opens files
    # itself: none of them makes a file of results. Live shots are appended line by line, so that none is ever lost.
    pipes = {"cli/app.py", "cli/failures.py", "fem/heads/mesh_file.py", "support/isolated_script.py"}
    assert result <= {"support/files.py", "jobs/lock.py", "jobs/store.py", "shots/live.py", *pipes}
    assert "support/files.py" in result


@pytest.mark.parametrize("text", ["p.open('w')", "open(p, 'xb')", "p.write_text('a')", "os.replace(a, b)"])
def test_another_writer_is_seen(text):
    assert list(writers(ast.walk(ast.parse(text))))


def test_a_fingerprint_sees_every_number_and_refuses_what_it_cannot_see():
    import numpy as np

    many = np.zeros(5000)
    other = many.copy()
    other[2500] = 1e-300
    assert fingerprint([many]) != fingerprint([other])
    assert fingerprint({"a": (1, 2)}) == fingerprint({"a": [1, 2]})
    assert fingerprint({(1, 2): 1, (0, 1): 2}) == fingerprint({(0, 1): 2, (1, 2): 1})
    with pytest.raises(TypeError, match="object has no fingerprint"):
        fingerprint(object())
