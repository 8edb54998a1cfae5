"""Tables of results: what people read and what files have are the same numbers."""

import csv
import io
import json
import math

import pytest
from hypothesis import given, strategies as st

from clubface import units
from clubface.errors import UnknownNameError
from clubface.present.report import csv_text, json_text, write_table
from clubface.present.terminal import as_text
from clubface.quantities import quantities, quantity
from clubface.results import Result, column, note, text
from clubface.results.catalogue import SENTENCES
from clubface.results.table import table

numbers = st.lists(st.floats(allow_nan=True, allow_infinity=False, width=64), min_size=1, max_size=5)


def read_back(made):
    rows = list(csv.reader(io.StringIO(csv_text(made))))
    return [dict(zip(rows[0], row, strict=True)) for row in rows[1:]]


@given(numbers)
def test_csv_and_json_have_the_same_digits(values):
    made = table("shots", text("model", ["a"] * len(values)), column("ball_speed", values), column("backspin", values))
    document = json.loads(json_text(Result("probe", "Probe", (made,)).to_dict()))
    for row, record in zip(document["tables"]["shots"]["rows"], read_back(made), strict=True):
        assert {key: "" if value is None else str(value) for key, value in row.items()} == record


@given(st.floats(-1e6, 1e6), st.sampled_from(sorted(quantities())))
def test_a_file_has_the_metric_value_that_converts_back_to_si(value, name):
    made = column(name, [value])
    # One conversion each way: two roundings.
    assert units.to_si(made.exact(0), quantity(name).metric.unit) == pytest.approx(value, rel=4e-16, abs=1e-12)


def test_a_difference_of_temperatures_has_no_offset():
    assert column("change", [10.0], "temperature", difference=True).exact(0) == 10.0
    assert column("temperature", [283.15]).exact(0) == pytest.approx(10.0, abs=1e-12)


def test_rows_of_mixed_quantities_carry_quantity_and_unit_of_each():
    kinds = [quantity("carry"), quantity("ball_speed")]
    made = table("figures", text("figure", ["a", "b"]), column("published", [200.0, 70.0], "carry"))
    made = table("figures", text("figure", ["a", "b"]), made.columns[1].__class__("published", [200.0, 70.0], kinds))
    assert [list(each.values()) for each in made.records()] == [
        ["a", "carry", "m", 200.0],
        ["b", "ball_speed", "m/s", 70.0],
    ]
    shown = as_text(Result("probe", "Probe", (made,)))
    assert ["a", "yd", "218.7"] in [line.split() for line in shown.splitlines()]
    assert ["b", "mph", "156.6"] in [line.split() for line in shown.splitlines()]


def test_a_transposed_table_shows_every_number_of_its_columns():
    made = table("compared", text("club", ["a", "b"]), column("carry", [200.0, 210.0]), layout="transposed")
    lines = as_text(Result("probe", "Probe", (made,))).splitlines()
    assert ["carry,", "yd", "218.7", "229.7"] in [line.split() for line in lines]


def test_a_unit_asked_for_changes_what_people_read_and_no_file():
    made = table("shots", column("carry", [200.0]))
    result = Result("probe", "Probe", (made,))
    assert "200.0" in as_text(result, {"carry": "m"})
    assert "218.7" in as_text(result)
    assert made.records() == [{"carry_m": 200.0}]


@pytest.mark.parametrize("ending", [".csv", ".tsv", ".parquet"])
def test_a_table_in_a_file_reads_back_to_the_last_digit(tmp_path, ending):
    import pandas

    made = table("shots", text("club", ["a", "b"]), column("carry", [200.0 / 3.0, math.nan]))
    path = write_table(made, tmp_path / f"shots{ending}")
    frame = pandas.read_parquet(path) if ending == ".parquet" else pandas.read_csv(path, sep=None, engine="python")
    assert frame["club"].tolist() == ["a", "b"]
    assert frame["carry_m"][0] == 200.0 / 3.0
    assert math.isnan(frame["carry_m"][1])


def test_unequal_columns_and_notes_without_sentence_or_data_are_refused():
    with pytest.raises(ValueError, match="lengths"):
        table("shots", column("carry", [1.0]), column("side", [1.0, 2.0]))
    with pytest.raises(UnknownNameError):
        note("no-such-note")
    with pytest.raises(KeyError):
        _ = note("shot-launch", ball_speed=70.0).sentence


def test_equal_notes_count_once():
    some = [note("marks-read", column="Spin"), note("marks-read", column="Spin"), note("marks-read", column="Axis")]
    assert len(dict.fromkeys(some)) == 2


def test_a_sentence_says_quantities_in_the_units_people_read():
    made = note("shot-carry", carry=228.6, apex=27.432, landing_angle=math.radians(38.0))
    assert made.sentence == "It carries 250 yd, rises to 30 yd and comes down at 38 deg."
    assert made.to_dict()["data"] == pytest.approx({"carry_m": 228.6, "apex_m": 27.432, "landing_angle_deg": 38.0})


def test_a_sentence_has_other_words_for_what_rounds_to_nothing():
    shape = {"azimuth": math.radians(-0.04), "curve": 0.4 * 0.9144, "shape": "straight shot"}
    assert "on the target line, flies straight and lands 1 yd left" in note("shot-shape", side=-0.6, **shape).sentence
    shape["azimuth"] = math.radians(-10.0)
    assert "starts 10.0 deg left, flies straight" in note("shot-shape", side=-0.6, **shape).sentence


def test_a_mapping_is_read_as_names_with_what_they_stand_for(monkeypatch):
    monkeypatch.setitem(SENTENCES, "paddle", "{values:and}; {counts}; {units}")
    values = {"speed": 44.704, "launch": [math.radians(12.0), math.radians(0.5)], "smash": 1.5}
    made = note("paddle", values=values, counts={"Measured": 3}, units={"Carry": "yd"})
    assert made.sentence == (
        "club speed 100.0 mph, launch angle 12.0 ± 0.5 deg and smash factor 1.500; 3 Measured; Carry (yd)"
    )
    data = made.to_dict()["data"]
    assert data["values"].pop("launch_deg") == pytest.approx([12.0, 0.5])
    assert data["values"] == {"speed_mps": 44.704, "smash": 1.5}
    assert data["counts"] == {"Measured": 3}


def test_long_lists_are_counted_and_whole_numbers_joined_to_ranges(monkeypatch):
    monkeypatch.setitem(SENTENCES, "paddle", "{frames:?frame/frames} {frames:ranges}; {names:2}")
    made = note("paddle", frames=[3, 7, 8, 9, 12, 20, 30, 31, 40], names=["a", "b", "c", "d"])
    assert made.sentence == "frames 3, 7-9, 12, 20 and 2 more; a, b and 2 more"
    assert note("paddle", frames=[5], names=["a"]).sentence == "frame 5; a"


def test_a_note_says_in_which_files_and_shots_it_is_true_and_keeps_its_code():
    general = note("marks-read", column="Spin")
    local = general.of(in_shots=2, of_shots=5).of(at_line=7).of(in_files=["a.csv", "b.csv"])
    assert str(local) == f"a.csv, b.csv: line 7: {general} (in 2 of 5 shots)"
    assert (local.code, local.to_dict()["data"]["in_files"]) == ("marks-read", ["a.csv", "b.csv"])


def test_counts_agree_with_their_words():
    sentence = SENTENCES["coefficients-hidden"]
    assert "{hidden:n coefficient}" in sentence
    assert note("coefficients-hidden", hidden=1, model="m").sentence.startswith("1 coefficient of")
    assert note("coefficients-hidden", hidden=143, model="m").sentence.startswith("143 coefficients of")
