"""A table filled by several runs has every row once, whatever interrupts them and whoever else writes it."""

import pytest
from hypothesis import given, settings, strategies as st

from clubface.errors import FileError
from clubface.jobs import Job, Store, engine as tables
from clubface.jobs.engine import run_table

COLUMNS = {"toe": float, "high": float, "force": float, "stopped": str}
PLACES = [(toe, high) for toe in (-0.5, 0.0, 0.5) for high in (0.0, 1.0 / 3.0)]


class Rows:
    """Computes rows, and is interrupted after so many of them."""

    def __init__(self, after=1000):
        self.after, self.computed = after, []

    def __call__(self, place, keep_going, threads):
        if len(self.computed) == self.after:
            raise KeyboardInterrupt
        self.computed.append(place)
        return {"toe": place[0], "high": place[1], "force": 1e3 / (2.0 + place[0]), "stopped": 'a "word", and'}


def fill(path, places, rows, **options):
    return run_table(Job("rows", places, rows, **options), path, {"case": 1}, COLUMNS, workers=1)


@settings(max_examples=12)
@given(st.lists(st.tuples(st.permutations(PLACES), st.integers(0, 6), st.integers(0, 4)), max_size=5))
def test_interrupted_runs_over_any_of_the_places_end_with_each_row_computed_once(tmp_path_factory, runs):
    path, computed = tmp_path_factory.mktemp("table") / "rows.csv", []
    for places, count, after in [*runs, (PLACES, len(PLACES), 1000)]:
        rows = Rows(after)
        missing = [place for place in places[:count] if place not in computed]
        if after < len(missing):
            with pytest.raises(KeyboardInterrupt):
                fill(path, places[:count], rows)
        else:
            fill(path, places[:count], rows)
        computed += rows.computed
    assert sorted(computed) == sorted(PLACES)
    undisturbed = path.with_name("undisturbed.csv")
    assert fill(undisturbed, PLACES, Rows()) == fill(path, PLACES, Rows(0))
    assert sorted(path.read_bytes().splitlines()) == sorted(undisturbed.read_bytes().splitlines())
    assert {each.name for each in path.parent.iterdir()} == {path.name, undisturbed.name}


def test_rows_that_another_run_writes_meanwhile_are_neither_lost_nor_computed_again(tmp_path, monkeypatch):
    path, rows = tmp_path / "rows.csv", Rows()

    def store_after_another_run(*arguments, **options):
        monkeypatch.setattr(tables, "Store", Store)
        fill(path, PLACES[2:], Rows())
        return Store(*arguments, **options)

    monkeypatch.setattr(tables, "Store", store_after_another_run)
    fill(path, PLACES[:3], rows)
    assert rows.computed == PLACES[:2]
    assert [row["toe"] for row in fill(path, PLACES, Rows(0))] == [place[0] for place in PLACES]


def test_a_row_that_is_no_longer_accepted_is_computed_again_and_replaced(tmp_path):
    path, again = tmp_path / "rows.csv", Rows()
    fill(path, PLACES, Rows())
    path.write_text(path.read_text().replace("-0.5,0.0,", "-0.5,0.0,1"))
    fill(path, PLACES[:1], again, accepts=lambda place, row: row["force"] < 1e3)
    assert again.computed == PLACES[:1]
    whole = fill(tmp_path / "undisturbed.csv", PLACES, Rows())
    assert fill(path, PLACES, Rows(0)) == whole


def test_a_table_that_an_editor_of_windows_has_saved_is_the_same(tmp_path):
    path = tmp_path / "rows.csv"
    whole = fill(path, PLACES[:3], Rows())
    path.write_bytes(path.read_bytes().replace(b"\n", b"\r\n"))
    assert fill(path, PLACES[:3], Rows(0)) == whole
    fill(path, PLACES, Rows())
    assert b"\r" not in path.read_bytes()


def test_a_complete_table_is_read_where_nothing_can_be_written(tmp_path, monkeypatch):
    path = tmp_path / "rows.csv"
    whole = fill(path, PLACES, Rows())
    monkeypatch.setattr(tables, "Store", None)
    assert fill(path, PLACES[::-1], Rows(0)) == whole[::-1]


def test_the_table_of_another_case_is_refused_before_anything_is_computed(tmp_path):
    path, rows = tmp_path / "rows.csv", Rows()
    fill(path, PLACES[:1], Rows())
    with pytest.raises(FileError, match=r"rows\.csv:1: "):
        run_table(Job("rows", PLACES, rows), path, {"case": 2}, COLUMNS, workers=1)
    assert rows.computed == []
    assert [each.name for each in tmp_path.iterdir()] == ["rows.csv"]
