"""Interrupted runs over a file of deliveries keep what is finished, and go on from there to the same bytes."""

import os
import runpy
import shutil
import subprocess
import sys

import pytest

from clubface.equipment.models import OWN
from clubface.errors import FileError
from clubface.shots import prediction as runs
from clubface.shots.prediction import predict
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


def part(output, name):
    """Return a part of the one unfinished work of an output."""
    return output.with_name(f"{output.name}.unfinished") / "parts" / name


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
        assert f"40 rows are done and kept in {output}.unfinished; the same command" in str(caught.value)
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

    result = pyarrow.parquet.read_table(tmp_path / "out.parquet")["id"].to_pylist()
    assert result == [str(number) for number in range(100)]


@pytest.mark.parametrize("name", ["000000000020+10.csv", "000000000020+10.rejects.csv"])
@pytest.mark.parametrize("harm", ["bit", "gone"])
def test_a_damaged_part_is_computed_again_and_no_other(write, tmp_path, name, harm, monkeypatch):
    path, output = write(MANY), tmp_path / "out.csv"
    predict(path, club="driver", output=tmp_path / "whole.csv", chunk_rows=10)
    begin(path, output)
    piece = part(output, name)
    content = bytearray(piece.read_bytes())
    content[len(content) // 2] ^= 1
    if harm == "bit":
        piece.write_bytes(content)
    else:
        piece.unlink()
    computed, compute = [], runs.PredictionTask.compute
    monkeypatch.setattr(
        runs.PredictionTask, "compute", lambda task, chunk: computed.append(chunk.lines[0]) or compute(task, chunk)
    )
    assert predict(path, club="driver", output=output, chunk_rows=10).resumed == 20
    assert computed == [22, 42, 52, 62, 72, 82, 92]  # the first line of a chunk; the header is line 1
    assert output.read_bytes() == (tmp_path / "whole.csv").read_bytes()
    assert (tmp_path / "out.rejects.csv").read_bytes() == (tmp_path / "whole.rejects.csv").read_bytes()


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_part_written_but_not_recorded_is_written_again(write, tmp_path, ending):
    path, output = write(MANY), tmp_path / f"out.{ending}"
    begin(path, output)
    part(output, f"000000000030+10.{ending}").with_name(f"000000000040+10.{ending}").write_bytes(b"half a row")
    predict(path, club="driver", output=output, chunk_rows=10, resume=True)
    predict(path, club="driver", output=tmp_path / f"whole.{ending}", chunk_rows=10)
    assert output.read_bytes() == (tmp_path / f"whole.{ending}").read_bytes()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
@pytest.mark.parametrize("renamed", [0, 1, 2])
@pytest.mark.parametrize("ending", ENDINGS)
def test_a_process_killed_during_the_final_renames_can_be_resumed(write, tmp_path, ending, renamed, monkeypatch):
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
    path.write_text(MANY.replace("99,99,1,13,1", "99,98,1,13,1"), newline="\n")
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    assert os.stat(path).st_size == before.st_size
    with pytest.raises(FileError, match="begun with another source"):
        predict(path, club="driver", output=output, resume=True)
    assert predict(path, club="driver", output=output).rows == 100


def test_an_interrupted_run_resumes_by_itself_and_a_different_one_replaces_it(write, tmp_path):
    path, output = write(MANY), tmp_path / "out.csv"
    begin(path, output)
    part(output, "../job.json").write_text("{")  # each value says what it belongs to
    assert predict(path, club="driver", output=output).resumed == 40
    begin(path, output)
    assert predict(path, club="driver", output=output, model="slip").resumed == 0
    assert not output.with_name("out.csv.unfinished").exists()


def test_a_file_of_another_version_is_not_resumed(write, tmp_path, monkeypatch):
    path, output = write(MANY), tmp_path / "out.csv"
    begin(path, output)
    monkeypatch.setattr("clubface.jobs.store.__version__", "9.9.9")
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
    with pytest.raises(FileError, match=r"out\.csv\.unfinished"):
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
        with pytest.raises(FileError, match="not a record of unfinished work"):
            predict(path, club="driver", output=output, resume=resume)
    assert mine.read_text() == "mine"
    mine.unlink()
    mine.mkdir()
    (mine / "diary.txt").write_text("mine")
    with pytest.raises(FileError, match="not a record of unfinished work"):
        predict(path, club="driver", output=output)
    assert (mine / "diary.txt").read_text() == "mine"


def run(*arguments):
    ran = subprocess.run(
        [sys.executable, "-c", MAIN, *arguments], capture_output=True, text=True, timeout=50, check=False
    )
    return ran.returncode, ran.stderr


@pytest.mark.parametrize("model", ["volumetric", "slip"])
def test_an_output_of_another_process_is_refused_and_dead_processes_hold_no_lock(write, tmp_path, model):
    """With the same options or others."""
    path, output = write(MANY), tmp_path / "out.csv"
    refused = []

    def meanwhile(part, done):
        if not refused:
            refused.append(run("predict", str(path), "--club", "driver", "--model", model, "-o", str(output)))

    predict(path, club="driver", output=output, chunk_rows=10, progress=meanwhile)
    message = f"process {os.getpid()} is writing this; wait until it ends, or give another name"
    assert refused == [(2, f"clubface: {output}: {message}\n")]
    assert len(table(output)) == 90
    dies = "import os, sys; from clubface import predict; "
    dies += "predict(sys.argv[1], club='driver', output=sys.argv[2], chunk_rows=10, progress=lambda *_: os._exit(9))"
    assert subprocess.run([sys.executable, "-c", dies, path, output], check=False).returncode == 9
    assert predict(path, club="driver", output=output, model="slip").rows == 100


LAW = """
import clubface

def law(touch, values):
    return STIFFNESS * max(touch.depth, 0.0) ** 1.5, 0.0, 0.0

clubface.register_law("mine", law)
"""


def test_an_edited_custom_law_starts_again(write, tmp_path):
    """The name is the same, and half the rows are those of the old law."""
    path, output, own = write(GOOD + "3,100,0,11,0\n"), tmp_path / "out.csv", tmp_path / "own.py"
    options = {"club": "driver", "model": "mine", "output": output, "chunk_rows": 1, "carry": False}
    own.write_text(LAW.replace("STIFFNESS", "2e7"))
    try:
        runpy.run_path(str(own))
        with pytest.raises(StoppedError):
            predict(path, progress=half_way(2, StoppedError), **options)
        own.write_text(LAW.replace("STIFFNESS", "3e7"))
        runpy.run_path(str(own))
        with pytest.raises(FileError, match="begun with another model"):
            predict(path, resume=True, **options)
        own.write_text(LAW.replace("STIFFNESS", "2e7"))
        runpy.run_path(str(own))
        assert predict(path, resume=True, **options).resumed == 2
    finally:
        OWN.clear()


@pytest.mark.parametrize("ending", ENDINGS)
def test_a_file_too_large_to_be_kept_gives_the_same_and_is_refused_once_it_changes(
    write, tmp_path, monkeypatch, ending
):
    note = "x" * 1000
    path = write(HEAD.replace("\n", ",notes\n") + f"1,113,1,13,5,{note}\n" * 800)
    if ending == "parquet":
        from pyarrow import csv, parquet

        source, path = path, tmp_path / "in.parquet"
        parquet.write_table(csv.read_csv(source), path, row_group_size=100)
    predict(path, club="driver", output=tmp_path / "kept.csv", chunk_rows=100)
    monkeypatch.setattr("clubface.support.files.LARGEST_KEPT", 0)
    monkeypatch.setattr("clubface.support.files.PIECE", 100)
    predict(path, club="driver", output=tmp_path / "read.csv", chunk_rows=100)
    assert (tmp_path / "read.csv").read_bytes() == (tmp_path / "kept.csv").read_bytes()

    def edit(part, done):
        with path.open("ab") as file:
            file.write(b"x")

    if ending == "parquet":
        return  # which pyarrow has read as a whole by then
    with pytest.raises(FileError, match="changed while it was read"):
        predict(path, club="driver", output=tmp_path / "edited.csv", chunk_rows=100, progress=edit)
    assert not (tmp_path / "edited.csv").exists()
