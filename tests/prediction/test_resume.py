"""Interrupted runs over a file of deliveries keep what is finished, and go on from there to the same bytes."""

import os
import shutil
import subprocess
import sys

import pytest

from clubface.errors import FileError
from clubface.prediction import run as runs
from clubface.prediction.predict import predict
from command_line import MAIN
from deliveries import GOOD, HEAD, table

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

ENDINGS = ["csv", "parquet"]


class StoppedError(Exception):
    """Thrown by a progress function to end a run half way."""


def half_way(rows, error):
    def progress(part, done):
        assert 0.0 < part <= 1.0
        if done >= rows:
            raise error

    return progress


MANY = HEAD + "".join(f"{i},{90 + i % 30},{'bad' if i % 10 == 3 else 1},13,{i % 7}\n" for i in range(100))


@pytest.fixture(autouse=True)
def needs_pyarrow(request):
    if "parquet" in request.node.name:
        pytest.importorskip("pyarrow")


def begin(path, output, **options):
    with pytest.raises(StoppedError):
        predict(path, club="driver", output=output, chunk_rows=10, progress=half_way(40, StoppedError), **options)


@pytest.mark.parametrize("ending", ENDINGS)
@pytest.mark.parametrize("error", [KeyboardInterrupt, StoppedError])
def test_an_interrupted_run_keeps_what_is_finished_and_goes_on_from_there(write, tmp_path, ending, error):
    options = {"club": "driver", "chunk_rows": 10, "model": "area"}
    path, output = write(MANY), tmp_path / f"out.{ending}"
    whole = predict(path, output=tmp_path / f"whole.{ending}", **options)
    with pytest.raises(error) as caught:
        predict(path, output=output, progress=half_way(40, error), **options)
    assert not output.exists()
    if error is KeyboardInterrupt:
        assert f"40 rows are done and kept in {output}.unfinished; resume" in str(caught.value)
    report = predict(path, output=output, resume=True, **options)
    assert report.resumed == 40
    for name in ("rows", "written", "rejected", "notes", "first_rejects"):
        assert getattr(report, name) == getattr(whole, name)
    assert (report.rows, report.written, report.rejected) == (100, 90, 10)
    assert output.read_bytes() == (tmp_path / f"whole.{ending}").read_bytes()
    assert (tmp_path / "out.rejects.csv").read_bytes() == (tmp_path / "whole.rejects.csv").read_bytes()
    kept = {f"{name}.{end}" for name in ("out", "whole") for end in (ending, "rejects.csv")}
    assert {each.name for each in tmp_path.iterdir()} == {*kept, "shots.csv"}


def test_a_run_over_parquet_goes_on_with_pieces_of_another_size(write, tmp_path):
    predict(write(MANY.replace("bad", "1")), club="driver", output=tmp_path / "in.parquet", carry=False)
    options = {"club": "driver", "output": tmp_path / "out.parquet"}
    with pytest.raises(StoppedError):
        predict(tmp_path / "in.parquet", chunk_rows=15, progress=half_way(30, StoppedError), **options)
    assert predict(tmp_path / "in.parquet", chunk_rows=20, resume=True, **options).rows == 100
    import pyarrow.parquet

    found = pyarrow.parquet.read_table(tmp_path / "out.parquet")["id"].to_pylist()
    assert found == [str(number) for number in range(100)]


@pytest.mark.parametrize("name", ["00000002.csv", "00000002.rejects.csv"])
def test_a_damaged_piece_is_told_and_not_put_into_the_output(write, tmp_path, name):
    path, output = write(MANY), tmp_path / "out.csv"
    begin(path, output)
    piece = tmp_path / "out.csv.unfinished" / name
    content = bytearray(piece.read_bytes())
    content[len(content) // 2] ^= 1
    piece.write_bytes(content)
    with pytest.raises(FileError, match=f"{name}: this part of the unfinished work is damaged"):
        predict(path, club="driver", output=output, resume=True)
    assert not output.exists()


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_piece_written_but_not_recorded_is_written_anew(write, tmp_path, ending):
    path, output = write(MANY), tmp_path / f"out.{ending}"
    begin(path, output)
    (tmp_path / f"out.{ending}.unfinished" / f"00000004.{ending}").write_bytes(b"half a row")
    predict(path, club="driver", output=output, chunk_rows=10, resume=True)
    predict(path, club="driver", output=tmp_path / f"whole.{ending}", chunk_rows=10)
    assert output.read_bytes() == (tmp_path / f"whole.{ending}").read_bytes()


@pytest.mark.parametrize("renamed", [0, 1, 2])
@pytest.mark.parametrize("ending", ENDINGS)
def test_death_at_the_renames_at_the_end_leaves_what_can_be_resumed(write, tmp_path, ending, renamed, monkeypatch):
    """Before the first, between both, and before the store is removed: a process that dies does no more."""
    path, output = write(MANY), tmp_path / f"out.{ending}"
    predict(path, club="driver", output=tmp_path / f"whole.{ending}", chunk_rows=10)
    child = os.fork()
    if not child:
        seen = []
        replace = os.replace

        def dies(fresh, target):
            if os.path.dirname(target) == str(tmp_path):
                if len(seen) == renamed:
                    os._exit(9)
                seen.append(target)
            replace(fresh, target)

        os.replace = dies
        runs.Store.remove = lambda store: os._exit(9)
        predict(path, club="driver", output=output, chunk_rows=10, threads=1)
        os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 9
    assert (tmp_path / "out.rejects.csv").exists() == (renamed > 0)
    assert output.exists() == (renamed > 1)
    report = predict(path, club="driver", output=output, chunk_rows=10, resume=True)
    assert report.resumed == 100
    assert output.read_bytes() == (tmp_path / f"whole.{ending}").read_bytes()
    assert (tmp_path / "out.rejects.csv").read_bytes() == (tmp_path / "whole.rejects.csv").read_bytes()
    assert not (tmp_path / f"out.{ending}.unfinished").exists()


def test_a_run_is_not_resumed_with_other_settings_or_another_file(write, tmp_path):
    path, output = write(MANY), tmp_path / "out.csv"
    begin(path, output)
    for what, changed in {
        "model": {"model": "slip"},
        "parameters": {"parameters": {"friction": 0.3}},
        "layout of columns": {"carry": False},
        "air or wind": {"air": {"humidity": 0.1}},
        "accuracy": {"accuracy": 1e-9},
        "club or ball": {"club": "7-iron"},
    }.items():
        with pytest.raises(FileError, match=rf"begun with another .*{'model' if what == 'parameters' else what}"):
            predict(path, output=output, resume=True, **{"club": "driver", **changed})
    # As large as before, and as old.
    before = os.stat(path)
    path.write_text(MANY.replace("99,99,1,13,1", "99,98,1,13,1"))
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert os.stat(path).st_size == before.st_size
    with pytest.raises(FileError, match="begun with another source; start again without resuming"):
        predict(path, club="driver", output=output, resume=True)
    assert predict(path, club="driver", output=output).rows == 100
    begin(path, output)
    (tmp_path / "out.csv.unfinished" / "00000002.csv").unlink()
    with pytest.raises(FileError, match="is gone"):
        predict(path, club="driver", output=output, resume=True)
    (tmp_path / "out.csv.unfinished" / "work.json").write_text("{")
    with pytest.raises(FileError, match="is damaged; remove the folder"):
        predict(path, club="driver", output=output, resume=True)


def test_a_file_of_another_version_is_not_resumed(write, tmp_path, monkeypatch):
    from clubface.support import resuming

    path, output = write(MANY), tmp_path / "out.csv"
    begin(path, output)
    monkeypatch.setattr(resuming, "__version__", "9.9.9")
    with pytest.raises(FileError, match="begun with another version"):
        predict(path, club="driver", output=output, resume=True)


def test_resume_without_anything_to_resume_starts_at_the_beginning(write, tmp_path):
    report = predict(write(GOOD), club="driver", output=tmp_path / "out.csv", resume=True)
    assert (report.rows, report.resumed) == (2, 0)


@pytest.mark.parametrize("name", ["out.part.csv", "out.csv.part", "out.csv.new", ".out.csv", "out.csv.unfinished.csv"])
def test_an_input_named_like_what_is_unfinished_is_not_touched(write, tmp_path, name):
    path = write(MANY, name)
    before = path.read_bytes()
    assert predict(path, club="driver", output=tmp_path / "out.csv", chunk_rows=10).written == 90
    assert path.read_bytes() == before
    assert len(table(tmp_path / "out.csv")) == 90


def test_inputs_and_rejects_in_the_folder_of_what_is_unfinished_are_refused_at_once(write, tmp_path):
    path, output = write(MANY), tmp_path / "out.csv"
    with pytest.raises(FileError, match=r"out\.csv\.unfinished; give another name"):
        predict(path, club="driver", output=output, rejects=tmp_path / "out.csv.unfinished")
    begin(path, output)
    inside = tmp_path / "out.csv.unfinished" / "mine.csv"
    shutil.copy(path, inside)
    with pytest.raises(FileError, match=r"mine\.csv: the finished parts of .*out\.csv go to"):
        predict(inside, club="driver", output=output)
    assert inside.read_text() == MANY


def test_a_file_or_folder_that_is_no_record_of_a_run_is_left_alone(write, tmp_path):
    path, output = write(MANY), tmp_path / "out.csv"
    mine = tmp_path / "out.csv.unfinished"
    mine.write_text("mine")
    for resume in (False, True):
        with pytest.raises(FileError, match="no record of unfinished work"):
            predict(path, club="driver", output=output, resume=resume)
    assert mine.read_text() == "mine"
    mine.unlink()
    mine.mkdir()
    (mine / "diary.txt").write_text("mine")
    with pytest.raises(FileError, match="no record of unfinished work"):
        predict(path, club="driver", output=output)
    assert (mine / "diary.txt").read_text() == "mine"


def test_two_runs_do_not_write_the_same_file_and_the_dead_hold_nothing(write, tmp_path):
    path, output = write(MANY), tmp_path / "out.csv"
    told = []

    def meanwhile(part, done):
        if not told:
            arguments = ["predict", str(path), "--club", "driver", "-o", str(output)]
            ran = subprocess.run(
                [sys.executable, "-c", MAIN, *arguments], capture_output=True, text=True, timeout=50, check=False
            )
            told.append((ran.returncode, ran.stdout, ran.stderr))

    predict(path, club="driver", output=output, chunk_rows=10, progress=meanwhile)
    said = f"clubface: {output}: process {os.getpid()} is writing this; wait until it ends, or give another name\n"
    assert told == [(2, "", said)]
    assert len(table(output)) == 90
    child = os.fork()
    if not child:
        predict(path, club="driver", output=output, chunk_rows=10, progress=lambda *_: os.kill(os.getpid(), 9))
    os.waitpid(child, 0)
    assert predict(path, club="driver", output=output, resume=True).rows == 100
