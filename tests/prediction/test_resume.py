"""Interrupted runs over a file of deliveries keep what is finished, and go on from there."""

import pytest

from clubface.errors import FileError
from clubface.prediction.predict import predict
from deliveries import GOOD, HEAD, table

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")


class StoppedError(Exception):
    """Thrown by a progress function to end a run half way."""


def half_way(rows, error):
    def progress(part, done):
        assert 0.0 < part <= 1.0
        if done >= rows:
            raise error

    return progress


MANY = HEAD + "".join(f"{i},{90 + i % 30},{'bad' if i % 10 == 3 else 1},13,{i % 7}\n" for i in range(100))


@pytest.mark.parametrize("ending", ["csv", "parquet"])
@pytest.mark.parametrize("error", [KeyboardInterrupt, StoppedError])
def test_an_interrupted_run_keeps_what_is_finished_and_goes_on_from_there(write, tmp_path, ending, error):
    if ending == "parquet":
        pytest.importorskip("pyarrow")
    options = {"club": "driver", "chunk_rows": 10, "model": "area"}
    path, output = write(MANY), tmp_path / f"out.{ending}"
    whole = predict(path, output=tmp_path / f"whole.{ending}", **options)
    with pytest.raises(error) as caught:
        predict(path, output=output, progress=half_way(40, error), **options)
    part = tmp_path / f"out.part.{ending}"
    assert not output.exists()
    if error is KeyboardInterrupt:
        assert f"40 rows are done and kept in {part}" in str(caught.value)
    assert len(read_ids(part)) == 36
    report = predict(path, output=output, resume=True, **options)
    assert report.resumed == 40
    assert (
        (report.rows, report.written, report.rejected) == (whole.rows, whole.written, whole.rejected) == (100, 90, 10)
    )
    assert read_ids(output) == read_ids(tmp_path / f"whole.{ending}")
    assert (tmp_path / "out.rejects.csv").read_bytes() == (tmp_path / "whole.rejects.csv").read_bytes()
    if ending == "csv":
        assert output.read_bytes() == (tmp_path / "whole.csv").read_bytes()
    assert not list(tmp_path.glob("*part*"))


def test_a_run_over_parquet_goes_on_with_pieces_of_another_size(write, tmp_path):
    pytest.importorskip("pyarrow")
    predict(write(MANY.replace("bad", "1")), club="driver", output=tmp_path / "in.parquet", carry=False)
    options = {"club": "driver", "output": tmp_path / "out.parquet"}
    with pytest.raises(StoppedError):
        predict(tmp_path / "in.parquet", chunk_rows=15, progress=half_way(30, StoppedError), **options)
    assert predict(tmp_path / "in.parquet", chunk_rows=20, resume=True, **options).rows == 100
    assert read_ids(tmp_path / "out.parquet") == [str(number) for number in range(100)]


def read_ids(path):
    if path.suffix == ".csv":
        return [row["id"] for row in table(path)]
    import pyarrow.parquet

    return pyarrow.parquet.read_table(path)["id"].to_pylist()


def test_rows_after_the_last_record_of_a_killed_run_are_written_anew(write, tmp_path):
    path, output = write(MANY), tmp_path / "out.csv"
    with pytest.raises(StoppedError):
        predict(path, club="driver", output=output, chunk_rows=10, progress=half_way(40, StoppedError))
    with (tmp_path / "out.part.csv").open("ab") as file:
        file.write(b"half a row " * 10_000)
    predict(path, club="driver", output=output, resume=True)
    predict(path, club="driver", output=tmp_path / "whole.csv")
    assert output.read_bytes() == (tmp_path / "whole.csv").read_bytes()


def test_a_run_is_not_resumed_with_other_settings_or_another_file(write, tmp_path):
    path, output = write(MANY), tmp_path / "out.csv"

    def begin():
        with pytest.raises(StoppedError):
            predict(path, club="driver", output=output, chunk_rows=10, progress=half_way(40, StoppedError))

    begin()
    for changed in ({"model": "slip"}, {"parameters": {"friction": 0.3}}, {"carry": False}, {"air": {"humidity": 0.1}}):
        with pytest.raises(FileError, match="other settings"):
            predict(path, output=output, resume=True, **{"club": "driver", **changed})
    path.write_text(MANY + "last,100,1,13,0\n")
    with pytest.raises(FileError, match="another file"):
        predict(path, club="driver", output=output, resume=True)
    assert predict(path, club="driver", output=output).rows == 101
    begin()
    (tmp_path / "out.part.csv").unlink()
    with pytest.raises(FileError, match="is gone"):
        predict(path, club="driver", output=output, resume=True)
    begin()
    (tmp_path / "out.part.json").write_text("{")
    with pytest.raises(FileError, match="without resuming"):
        predict(path, club="driver", output=output, resume=True)


def test_resume_without_anything_to_resume_starts_at_the_beginning(write, tmp_path):
    report = predict(write(GOOD), club="driver", output=tmp_path / "out.csv", resume=True)
    assert (report.rows, report.resumed) == (2, 0)
