"""Files that a computation reads are read once, in one place, and nothing but a file is waited for."""

import ast
import os
from pathlib import Path

import pytest

import clubface
from clubface.errors import FileError
from clubface.support.files import (
    InputRecord,
    given_files,
    input_file,
    open_input,
    read_input,
    recorded_files,
    short_names,
)
from package_sources import trees

READERS = {"read_text", "read_bytes"}
NO_INPUTS = {
    "support/files.py": "the place itself; what is written",
    "cli/failures.py": "the device for what nobody reads",
    "fem/sweep.py": "finished runs of the same work",
    "shots/monitors.py": "layouts of monitors, which come with the package",
    "shots/tables/headings.py": "words of headings, which come with the package",
    "published_data.py": "published tables, which come with the package",
    "simulation/own_law.py": "the source of a law of contact of one's own",
    "studies/store.py": "finished parts of a study, and inputs that it keeps",
    "jobs/store.py": "finished parts of long work",
    "jobs/engine.py": "rows of a table that long work adds to",
    "jobs/lock.py": "who works on a file",
    "fem/paper.py": "errors that were computed once, which come with the package",
    "support/processes.py": "the memory of the machine; the processor of the machine",
    "shots/tables/writer.py": "pieces of what is written",
    "cli/app.py": "the device for messages that nobody reads",
    "support/isolated_script.py": "the pipe to the process of a library",
    "shots/live.py": "live shots, which it writes itself",
    "studio/serve.py": "the page of the studio",
    "cli/studio.py": "the browser",
    "export/casadi.py": "pieces of source, which come with the package",
    "export/fmu.py": "the library for units, which comes with the package",
}
"""The modules that open something which is no input of a computation, and what."""


def reads(nodes):
    for node in nodes:
        if isinstance(node, ast.Call):
            if isinstance(node.func, ast.Attribute) and node.func.attr in (*READERS, "open", "fdopen"):
                yield node.func.attr
            elif getattr(node.func, "id", "") == "open":
                yield "open"


def test_no_other_module_opens_files_that_a_computation_depends_on():
    result = {path for path, nodes in trees().items() if list(reads(nodes))}
    assert result <= NO_INPUTS.keys()


def test_a_file_that_is_edited_during_a_computation_stays_as_it_was_read(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text("before")
    with InputRecord().active():
        read_input(path)
        path.write_text("after")
        assert read_input(path) == b"before"
        with InputRecord().active(), open_input(path) as file:  # a part of the computation, such as a study
            assert file.read() == b"before"
    assert read_input(path) == b"after"


def test_a_file_under_two_names_is_one_file(tmp_path, monkeypatch):
    (tmp_path / "sub").mkdir()
    (tmp_path / "mine.toml").write_text("x")
    names = ["mine.toml", "sub/../mine.toml", tmp_path / "mine.toml"]
    if os.name != "nt":  # where links need rights
        (tmp_path / "link.toml").symlink_to("mine.toml")
        names.append("link.toml")
    monkeypatch.chdir(tmp_path)
    with InputRecord().active():
        for name in names:
            read_input(name)
        (only,) = recorded_files()
    assert only.path == "mine.toml"


def test_files_of_one_name_are_distinguished_by_their_folders():
    assert short_names(["/a/x/anna.toml", "/a/y/anna.toml", "/a/my.toml"]) == ["x/anna.toml", "y/anna.toml", "my.toml"]
    assert short_names(["anna.toml", "sub/anna.toml"]) == ["anna.toml", "sub/anna.toml"]


def test_files_of_the_package_are_recorded_as_such():
    with InputRecord().active():
        clubface.Club.builtin("driver")
        (only,) = recorded_files()
    assert only.shipped


def test_a_worker_reads_what_it_was_given_and_nothing_else(tmp_path):
    path, other = tmp_path / "mine.toml", tmp_path / "other.toml"
    path.write_text("before")
    other.write_text("x")
    given = {str(path): input_file(path)}
    path.unlink()
    with InputRecord(given).active():
        assert read_input(path) == b"before"
        with pytest.raises(FileError, match="when the computation began"):
            read_input(other)
        assert clubface.Club.builtin("driver").name == "driver"


def test_a_large_table_that_changes_while_it_is_read_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("clubface.support.files.LARGEST_KEPT", 10)
    path = tmp_path / "shots.csv"
    path.write_text("a" * 3_000_000)
    with open_input(path) as file:
        assert file.read(4) == b"aaaa"
        with path.open("a") as writer:
            writer.write("b")
        with pytest.raises(FileError, match="changed while it was read"):
            file.read()


def test_files_beyond_what_is_kept_are_read_in_their_place_and_refused_once_they_change(tmp_path, monkeypatch):
    monkeypatch.setattr("clubface.support.files.MOST_KEPT", 5)
    first, second = tmp_path / "first.toml", tmp_path / "second.toml"
    first.write_text("before one")
    second.write_text("before two")
    with InputRecord().active():
        assert (read_input(first), read_input(second)) == (b"before one", b"before two")
        first.write_text("later")
        second.write_text("after two.")
        assert read_input(first) == b"before one"
        with pytest.raises(FileError, match="changed while it was read"):
            read_input(second)


def test_a_worker_is_given_no_damaged_copy_of_an_input(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text("before")
    read = input_file(path)
    (tmp_path / read.sha256).write_text("before")
    given = [(str(path), read.sha256, read.size)]
    assert given_files(given, tmp_path)[str(path)].content == b"before"
    (tmp_path / read.sha256).write_text("beforE")
    with pytest.raises(FileError, match="damaged"):
        given_files(given, tmp_path)


@pytest.mark.skipif(
    os.name == "nt" or not Path("/proc/self/maps").exists(), reason="no files of the system that say no size"
)
def test_a_file_that_says_no_size_is_limited_all_the_same():
    with pytest.raises(FileError, match="larger than"):
        input_file("/proc/self/maps", most=10)


def special(kind, folder):
    """Return a path at which there is something other than a file that can be read."""
    path = folder / "it.toml"
    if kind == "loop":
        path.symlink_to(folder / "back.toml")
        (folder / "back.toml").symlink_to(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "no end":
        path.symlink_to("/dev/zero")
    elif kind == "not UTF-8":
        path = Path(os.fsdecode(os.fsencode(folder) + b"/caf\xe9.toml"))
    elif kind == "long":
        path = folder / f"{'x' * 300}.toml"
    elif kind == "under a file":
        (folder / "file").write_text("")
        path = folder / "file" / "it.toml"
    elif kind == "zero":
        path = folder / "a\0b.toml"
    return path


KINDS = ("folder", "long", "under a file", "zero")
if os.name != "nt":  # where links need rights, no folder has devices or pipes, and names are not made of bytes
    KINDS += ("loop", "pipe", "no end", "not UTF-8")


COMMANDS = {
    "shot": ("shot", "FILE", "--speed", "50 m/s"),
    "ball": ("shot", "driver", "--speed", "50 m/s", "--ball", "FILE"),
    "parameters": ("shot", "driver", "--speed", "50 m/s", "--parameters", "FILE"),
    "predict": ("predict", "FILE", "--club", "driver", "-o", "OUT.csv"),
    "map": ("map", "FILE", "--speed", "50 m/s"),
    "dispersion": ("dispersion", "FILE"),
    "best-loft": ("best-loft", "--speed", "50 m/s", "--club", "FILE"),
    "evaluate": ("evaluate", "FILE"),
    "identify": ("identify", "FILE", "--model", "slip"),
    "infer": ("infer", "FILE", "--club", "driver", "-o", "OUT.csv"),
    "golfer": ("golfer", "show", "FILE"),
    "monitor": ("monitor", "read", "FILE"),
    "monitor report": ("monitor", "report", "FILE", "-o", "OUT.html"),
    "mapping": ("monitor", "read", "FILE", "--mapping", "FILE"),
    "optimise": ("optimise", "FILE"),
    "fem head": ("fem", "head", "FILE"),
    "fem run": ("fem", "run", "FILE"),
    "fem design": ("fem", "design", "FILE"),
    "study": ("study", "run", "FILE"),
    "capture": ("capture", "read", "FILE", "--markers", "FILE", "--club", "driver"),
    "club": ("club", "check", "FILE"),
}


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_refuses_what_is_no_file_in_one_line(command, tmp_path, clubface_):
    for kind in KINDS:
        folder = tmp_path / kind
        folder.mkdir()
        path = str(special(kind, folder))
        words = [each.replace("FILE", path).replace("OUT", str(tmp_path / "out")) for each in COMMANDS[command]]
        ran = clubface_(*words)
        lines = [each for each in ran.err.splitlines() if not each.startswith("clubface: note:")]
        assert ran.status == 2, (kind, ran.err)
        assert len(lines) == 1, (kind, ran.err)
        assert lines[0].isprintable()


@pytest.mark.skipif(os.name == "nt", reason="names of files are not made of bytes there")
def test_a_name_that_is_not_utf8_is_read_and_shown(tmp_path, clubface_):
    path = Path(os.fsdecode(os.fsencode(tmp_path) + b"/caf\xe9 'a\" b.toml"))
    path.write_text(clubface.club("driver").replace(name="mine").to_toml())
    report = tmp_path / "report.html"
    ran = clubface_("shot", str(path), "--speed", "50 m/s", "--report", str(report))
    assert ran.status == 0, ran.err
    assert "caf\\xe9" in report.read_text()
