"""An interrupted run goes on with the same settings only, and its rows keep the numbers that they have in the file."""

import pytest

from clubface.errors import FileError
from clubface.shots.prediction import predict
from deliveries import HEAD, table
from fem_meshes import HEAD as HEAD_OF_MESH, write_mesh

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

MANY = HEAD + "".join(f"{i},{90 + i % 30},{'bad' if i % 10 == 3 else 1},13,{i % 7}\n" for i in range(60))
BEGUN = {
    "club": "driver", "model": "volumetric", "ball": "modern", "hand": "right", "accuracy": 1e-5, "carry": True,
    "parameters": {"friction": 0.3}, "air": {"humidity": 0.2}, "wind": ("1 m/s", 0, 0),
}  # fmt: skip
CHANGED = {
    "club": ["3-wood", "7-iron"], "model": ["area", "slip"], "ball": ["conforming", "published"], "hand": ["left"],
    "accuracy": [1e-6, None], "carry": [False], "parameters": [{"friction": 0.31}, None],
    "air": [{"humidity": 0.3}, {"altitude": "100 m"}, None], "wind": [("2 m/s", 0, 0), (0, 0, "1 m/s"), None],
}  # fmt: skip


class StoppedError(Exception):
    """Ends a run half way."""


def stop(rows):
    def progress(part, done):
        if done >= rows:
            raise StoppedError

    return progress


def test_every_setting_of_a_run_is_tried():
    assert set(CHANGED) == set(BEGUN)


@pytest.mark.parametrize(("name", "value"), [(name, value) for name, values in CHANGED.items() for value in values])
def test_a_run_does_not_go_on_with_another_setting_and_still_does_with_its_own(write, tmp_path, name, value):
    path, output = write(MANY), tmp_path / "out.csv"
    with pytest.raises(StoppedError):
        predict(path, output=output, chunk_rows=10, progress=stop(30), **BEGUN)
    changed = BEGUN | {name: value}
    if name == "model":
        changed["parameters"] = None  # those of the other model do not serve
        changed["accuracy"] = 1e-5
    with pytest.raises(FileError, match="begun with another"):
        predict(path, output=output, resume=True, **changed)
    assert predict(path, output=output, resume=True, **BEGUN).resumed == 30


@pytest.mark.parametrize("what", ["stiffness", "mesh"])
def test_a_run_with_a_meshed_club_does_not_go_on_with_another_mesh_of_the_same_name(write, tmp_path, what):
    """A softer wall has the same mass, CG and inertia, and finite elements give it other launches."""
    write_mesh(tmp_path)
    club = tmp_path / "own.toml"
    club.write_text(HEAD_OF_MESH)
    path, options = write(MANY), {"club": club, "output": tmp_path / "out.csv", "model": "standard", "carry": False}
    with pytest.raises(StoppedError):
        predict(path, chunk_rows=10, progress=stop(30), **options)
    if what == "mesh":
        write_mesh(tmp_path, change=lambda quad: [*quad[1:], quad[0]])  # the same walls, counted from other corners
    else:
        club.write_text(HEAD_OF_MESH.replace("110 GPa", "100 GPa"))
    with pytest.raises(FileError, match="begun with another club or ball"):
        predict(path, resume=True, **options)
    write_mesh(tmp_path)
    club.write_text(HEAD_OF_MESH)
    assert predict(path, resume=True, **options).resumed == 30


@pytest.mark.parametrize("kind", ["csv", "parquet"])
def test_rejects_of_a_run_that_went_on_have_the_numbers_of_their_rows(write, tmp_path, kind):
    path = write(MANY)
    if kind == "parquet":
        pyarrow_csv = pytest.importorskip("pyarrow.csv")
        import pyarrow.parquet

        source, path = path, tmp_path / "in.parquet"
        pyarrow.parquet.write_table(pyarrow_csv.read_csv(source), path)
    options = {"club": "driver", "output": tmp_path / "out.csv", "model": "standard", "carry": False}
    with pytest.raises(StoppedError):
        predict(path, chunk_rows=10, progress=stop(30), **options)
    report = predict(path, chunk_rows=7, resume=True, **options)
    # Rows 3, 13, ... counted from 0 are bad; a line of CSV counts the header and from 1, a row of Parquet from 1.
    bad = [row + (2 if kind == "csv" else 1) for row in range(3, 60, 10)]
    (place,) = (name for name in table(tmp_path / "out.rejects.csv")[0] if name in ("line", "row"))
    assert [int(each[place]) for each in table(tmp_path / "out.rejects.csv")] == bad
    assert [line for line, _ in report.first_rejects] == bad
