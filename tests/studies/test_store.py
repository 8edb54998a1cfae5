"""The store is the truth: what is there and whole is done, what is damaged is computed again, and nothing is mixed."""

import os
import shutil
from contextlib import contextmanager

import pytest

from clubface import studies
from clubface.errors import ClubfaceError, FileError, RunError
from clubface.studies import running, store
from clubface.studies.kinds.kind import Computed
from clubface.studies.running import KEPT, Chunks
from clubface.studies.store import open_store
from clubface.studies.study import read_study
from clubface.support.files import whole_file
from study_files import shots, squares, sums

pytest.importorskip("pyarrow")
pytestmark = pytest.mark.usefixtures("in_this_process")


def part(path, chunk):
    return open_store(path).path(chunk)


def test_the_sums_of_columns_do_not_depend_on_chunks_and_workers(tmp_path):
    small, large = shots(tmp_path, chunk=5), shots(tmp_path, chunk=7, name="large.toml")
    assert studies.run(small, workers=1).chunks == 5
    assert studies.run(large, workers=2).chunks == 4
    assert sums(small) == sums(large)
    assert len(set(sums(small).values())) == 7


def test_a_size_of_chunks_that_is_measured_is_kept_and_does_not_count(tmp_path):
    path = shots(tmp_path)
    studies.run(path, workers=1)
    other = tmp_path / "other.toml"
    other.write_text(path.read_text().replace("chunk = 5", 'seconds = "1 s"'))
    studies.run(other, workers=1)
    other.write_text(other.read_text().replace("1 s", "9 s"))
    assert studies.run(other, workers=1).computed == 0
    assert sums(path) == sums(other)


def test_two_workers_that_compute_the_same_chunk_write_the_same_bytes(tmp_path):
    path = shots(tmp_path)
    studies.run(path, workers=1)
    before = part(path, 2).read_bytes()
    part(path, 2).unlink()
    Chunks(read_study(path), open_store(path)).ensure(2)
    assert part(path, 2).read_bytes() == before


@pytest.mark.skipif(os.name == "nt", reason="nobody removes there what is being written")
def test_a_run_that_another_tidies_up_after_while_it_writes_finds_the_part_there(tmp_path, monkeypatch):
    path = shots(tmp_path)
    studies.run(path, workers=1)
    part(path, 2).unlink()

    @contextmanager
    def overtaken(target):
        with whole_file(target) as file:
            yield file
            monkeypatch.undo()
            Chunks(read_study(path), open_store(path)).ensure(2)
            open_store(path).tidy()

    monkeypatch.setattr(store, "whole_file", overtaken)
    assert Chunks(read_study(path), open_store(path)).ensure(2)["done"] == KEPT
    assert studies.status(path, check=True).damaged == ()


def test_an_interrupted_run_counts_what_earlier_runs_have_finished(tmp_path, monkeypatch):
    path = squares(tmp_path)
    studies.run(path, workers=1, shard="1/4")
    for error in (KeyboardInterrupt, RunError("broken")):

        def stop(*rest, error=error, **options):
            raise error

        monkeypatch.setattr(running, "in_processes", stop)
        with pytest.raises((KeyboardInterrupt, ClubfaceError), match="5 of 20 chunks are done and kept"):
            studies.run(path, workers=1)


def test_a_run_without_a_result_leaves_what_others_have_finished(tmp_path, monkeypatch):
    path = squares(tmp_path)

    def stop(*rest, **options):
        monkeypatch.undo()
        studies.run(path, workers=1, shard="1/4")
        raise RunError("no task that was tried has a result")

    monkeypatch.setattr(running, "in_processes", stop)
    with pytest.raises(ClubfaceError, match="no task that was tried has a result"):
        studies.run(path, workers=1, shard="2/4")
    assert studies.status(path, check=True).done == 5


def test_finished_chunks_are_not_computed_again(tmp_path):
    path = squares(tmp_path)
    assert studies.run(path, workers=1).computed == 20
    stamps = [part(path, chunk).stat().st_mtime_ns for chunk in range(20)]
    part(path, 7).unlink()
    done = studies.run(path, workers=1)
    assert (done.computed, done.mended[0]) == (1, 0)
    assert [part(path, chunk).stat().st_mtime_ns for chunk in range(20) if chunk != 7] == stamps[:7] + stamps[8:]


@pytest.mark.parametrize("at", [0, 100, 0.3, 0.6, 0.9, -1])
def test_a_part_with_a_changed_byte_is_computed_again_and_reported(tmp_path, at):
    path = shots(tmp_path)
    studies.run(path, workers=1)
    before, file = sums(path), part(path, 3)
    content = bytearray(file.read_bytes())
    place = int(at * len(content)) if isinstance(at, float) else at
    content[place] ^= 0x55
    file.write_bytes(content)
    done = studies.run(path, workers=1)
    assert done.mended == (1, (3,))
    assert sums(path) == before


@pytest.mark.parametrize("content", [b"", b"PAR1", b"PAR1" + b"\0" * 500 + b"PAR1"])
def test_a_part_that_is_no_part_is_computed_again(tmp_path, content):
    path = squares(tmp_path)
    studies.run(path, workers=1)
    before = sums(path)
    part(path, 19).write_bytes(content)
    assert studies.status(path, check=True).damaged == (19,)
    with pytest.raises(FileError, match=r"damaged; clubface study run computes it again"):
        sums(path)
    assert studies.run(path, workers=1).mended == (1, (19,))
    assert sums(path) == before


def test_a_part_in_the_place_of_another_is_computed_again(tmp_path):
    path, other = squares(tmp_path), squares(tmp_path, name="other.toml", seconds=1e-9)
    for each in (path, other):
        studies.run(each, workers=1)
    before = sums(path)
    shutil.copy(part(path, 3), part(path, 4))
    shutil.copy(part(other, 6), part(path, 6))
    assert studies.run(path, workers=1).mended == (2, (4, 6))
    assert sums(path) == before


def test_a_part_tells_where_it_comes_from_to_any_program(tmp_path):
    import pyarrow.parquet

    path = shots(tmp_path)
    studies.run(path, workers=1)
    table = pyarrow.parquet.read_table(part(path, 1))
    assert table.column_names == ["loft", "toe", "attack", "ball_speed", "backspin", "carry", "side"]
    assert table.schema.field("loft").metadata == {b"unit": b"rad"}
    _, description = open_store(path).read(1)
    assert (description["first"], description["tasks"], description["name"], description["kind"]) == (
        5,
        5,
        "shots",
        "impact",
    )
    assert description["inputs"]["held"] == {"speed": "105 mph"}
    assert description["clubface_version"]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("14 deg", "15 deg", r"another \[sweep\]"),
        ("count = 4", "count = 5", r"another \[sweep\], another design"),
        ("105 mph", "106 mph", r"another \[impact\]"),
        ("chunk = 5", "chunk = 6", "another chunk"),
        ("loft =", "face =", r"another \[sweep\]"),
    ],
)
def test_a_changed_study_does_not_go_on_in_the_old_store(tmp_path, old, new, words):
    path = shots(tmp_path)
    studies.run(path, workers=1)
    path.write_text(path.read_text().replace(old, new))
    for command in (studies.run, studies.status, studies.join, studies.summary):
        with pytest.raises(FileError, match=f"begun with {words}.*; give another folder with --store"):
            command(path)


def test_a_changed_file_that_the_study_names_is_another_study(tmp_path):
    import clubface

    mine = tmp_path / "mine.toml"
    mine.write_text(clubface.club("driver").replace(name="mine").to_toml())
    path = shots(tmp_path)
    path.write_text(path.read_text().replace('"driver"', '"mine.toml"'))
    studies.run(path, workers=1)
    mine.write_text(mine.read_text() + "\n")
    with pytest.raises(FileError, match=r"begun with another file mine\.toml; give"):
        studies.run(path, workers=1)


def test_other_folders_are_left_alone(tmp_path):
    path, folder = squares(tmp_path), tmp_path / "photos"
    folder.mkdir()
    (folder / "one.jpg").write_text("precious")
    with pytest.raises(FileError, match="not the store of a study"):
        studies.run(path, store=folder)
    assert [each.name for each in folder.iterdir()] == ["one.jpg"]
    with pytest.raises(FileError, match="holds no study"):
        studies.status(folder)
    with pytest.raises(FileError, match="no part of this study is finished yet"):
        studies.status(path)


def test_a_damaged_record_is_reported(tmp_path):
    path = squares(tmp_path)
    studies.run(path, workers=1)
    record = tmp_path / "squares.store" / "record.json"
    record.write_text(record.read_text().replace('"count": 200', '"count": 300'))
    with pytest.raises(FileError, match="this study record is damaged; remove it: clubface study run"):
        studies.run(path, workers=1)
    record.unlink()
    assert studies.run(path, workers=1).computed == 0


def test_an_unfinished_study_is_not_joined(tmp_path):
    path = squares(tmp_path)
    studies.run(path, workers=1, shard="1/4")
    result = studies.status(path)
    assert (result.done, result.chunks, result.missing[:4]) == (5, 20, (1, 2, 3, 5))
    for command in (studies.join, studies.summary):
        with pytest.raises(FileError, match="15 of 20 chunks are not done yet"):
            command(path)


def test_a_study_without_any_result_ends_before_it_begins(tmp_path):
    path = shots(tmp_path)
    path.write_text(path.read_text().replace("105 mph", "-105 mph"))
    for _ in range(2):
        with pytest.raises(ClubfaceError, match="no task that was tried has a result: speed"):
            studies.run(path, workers=1)
        assert not (tmp_path / "shots.store").exists()
        path.write_text(path.read_text().replace("chunk = 5", "seconds = 2"))


def test_a_study_with_a_result_in_its_first_or_last_chunk_goes_on(tmp_path):
    path = shots(tmp_path, chunk=12)
    path.write_text(
        path.read_text().replace('held = { speed = "105 mph" }', "").replace("loft = {", "speed = [-1, 45]\nloft = {")
    )
    assert studies.run(path, workers=1).failed[0] == 24


@pytest.mark.parametrize("chunk", ["chunk = 5", "seconds = 2"])
@pytest.mark.parametrize("workers", [1, 2])
def test_an_input_that_is_swept_too_far_to_both_sides_has_results_between(tmp_path, chunk, workers):
    path = shots(tmp_path)
    text = path.read_text().replace('toe = ["-10 mm", "0 mm", "10 mm"]\n', "").replace("chunk = 5", chunk)
    path.write_text(text.replace("[sweep]\n", '[sweep]\ntoe = { from = "-80 mm", to = "80 mm", count = 33 }\n'))
    done = studies.run(path, workers=workers)
    assert done.missing == 0
    assert 0 < done.failed[0] < done.tasks


def test_a_mistake_found_by_the_first_task_is_reported_with_its_file_and_leaves_no_store(tmp_path):
    path = shots(tmp_path)
    path.write_text(path.read_text().replace("[sweep]", 'parameters = { friction = -1 }\nmodel = "area"\n[sweep]'))
    with pytest.raises(FileError, match=r"shots\.toml:8: friction is"):
        studies.run(path, workers=1)
    assert not (tmp_path / "shots.store").exists()


def test_pandas_reads_all_parts_as_one_table(tmp_path):
    pandas = pytest.importorskip("pandas")
    path = shots(tmp_path)
    path.write_text(path.read_text() + 'hand = ["right", "left"]\n')
    studies.run(path)
    table = pandas.read_parquet(tmp_path / "shots.store" / "parts")
    assert len(table) == 48
    assert table["hand"].tolist() == ["right", "left"] * 24
    assert table["side"][8:10].sum() == pytest.approx(0.0, abs=1e-9)  # mirror images, to rounding


def test_parts_are_found_by_what_checks_them(tmp_path):
    path = squares(tmp_path)
    studies.run(path, workers=1)
    columns, _ = open_store(path).read(19)
    assert columns["x"][-1] == 1.0
    assert columns["square"].tolist() == (columns["x"] ** 2).tolist()


class Slow:
    """A task that loads for a while, and then takes a time for each index, on a clock of its own."""

    def __init__(self, clock, loading, each):
        self._clock, self._loading, self._each = clock, loading, each

    def run(self, indices):
        self._clock[0] += self._loading + self._each * len(indices)
        self._loading = 0.0
        return Computed({})


@pytest.mark.parametrize(
    ("loading", "each", "count", "size"),
    [
        (0.6, 3e-6, 10**9, 500_000),  # 2 s are 667,000 tasks, above the most
        (0.6, 3e-6, 100_000, 20_000),  # 0.1 s, so that there is a chunk for each of several workers
        (0.6, 1e-3, 10**6, 2_000),
        (0.0, 0.7, 1000, 2),
        (0.0, 60.0, 1000, 1),
        (4.0, 0.05, 3, 1),
    ],
)
def test_a_chunk_takes_the_time_it_should(tmp_path, monkeypatch, loading, each, count, size):
    clock = [0.0]
    monkeypatch.setattr(running.time, "process_time", lambda: clock[0])
    path = tmp_path / "study.toml"
    path.write_text(f'[study]\nkind = "empty"\n[sweep]\nx = {{ from = 0, to = 1, count = {count} }}\n')
    assert running.chunk_size(read_study(path), Slow(clock, loading, each)) == size


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with a name")
def test_a_pipe_in_the_place_of_a_part_is_refused_and_not_waited_for(tmp_path):
    path = squares(tmp_path)
    studies.run(path, workers=1)
    part(path, 0).unlink()
    os.mkfifo(part(path, 0))
    assert studies.status(path).missing == (0,)
    with pytest.raises(ClubfaceError, match="00000000"):
        studies.run(path, workers=1)


def test_a_name_with_a_zero_character_is_no_file(tmp_path):
    path = shots(tmp_path)
    path.write_text(path.read_text().replace("[sweep]", 'parameters = "a\\u0000.toml"\n[sweep]'))
    with pytest.raises(FileError, match="cannot be read"):
        studies.run(path, workers=1)
