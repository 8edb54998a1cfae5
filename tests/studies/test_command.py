"""The command line of studies: what it prints, and mistakes told in one line with status 2."""

import re

import pytest

from command_line import assert_mistake
from study_files import shots, squares

pytest.importorskip("pyarrow")
pytestmark = pytest.mark.usefixtures("in_this_process")


@pytest.fixture
def study(clubface_):
    """Run ``clubface study``, paths and all."""
    return lambda *arguments: clubface_("study", *map(str, arguments))


def test_a_study_is_run_looked_at_joined_and_summed_up(study, tmp_path):
    path, table, picture = shots(tmp_path), tmp_path / "all.csv", tmp_path / "all.svg"
    first = study("run", path, "--json")
    assert [first.values[name] for name in ("tasks", "chunks", "computed", "kept")] == [24, 5, 5, 0]
    assert first.notes()[-1] == "study-complete"
    assert study("run", path, "--json").values["computed"] == 0
    state = study("status", path, "--check", "--json").values
    assert [state[name] for name in ("chunks", "done", "tasks", "chunk")] == [5, 5, 24, 5]
    ran = study("join", tmp_path / "shots.store", "-o", table)
    assert len(table.read_text().splitlines()) == 25
    sums = {row["column"]: row["sha256"] for row in study("join", path, "--json").rows()}
    assert all(len(each) == 64 and each in ran.out for each in sums.values())
    assert "toe" in sums
    ran = study("summary", path, "--output", "carry,side", "--plot", picture)
    assert "Mean and deviation along toe" in ran.out
    assert picture.read_text().startswith("<?xml")
    ran = study("summary", path, "--json")
    levels = list(dict.fromkeys(row["level_from_mm"] for row in ran.rows("along_toe")))
    assert levels[2] == pytest.approx(10.0, rel=1e-15)
    assert {row["quantity"]: row["count"] for row in ran.rows("overall")}["carry"] == 24


def test_a_summary_is_in_the_units_of_golfers_and_no_finer_than_its_spread(study, tmp_path):
    path = shots(tmp_path)
    study("run", path)
    (carry,) = [row for row in study("summary", path, "--json").rows("overall") if row["quantity"] == "carry"]
    assert carry["unit"] == "m"
    mean, deviation = carry["mean"] / 0.9144, carry["deviation"] / 0.9144
    assert 1.0 <= deviation < 100.0
    digits = 2 if deviation < 10.0 else 1
    (row,) = [line.split() for line in study("summary", path).out.splitlines() if line.startswith("carry")]
    assert row[1:4] == ["yd", f"{mean:.{digits}f}", f"{deviation:.{digits}f}"]


def test_a_tiny_spread_does_not_fill_a_summary_with_digits(study, tmp_path):
    path = tmp_path / "same.toml"
    path.write_text('[impact]\nclub = "driver"\noutputs = ["carry"]\n[sweep]\nspeed = ["50 m/s", "50.00001 m/s"]\n')
    study("run", path)
    (row,) = [line.split() for line in study("summary", path).out.splitlines() if line.startswith("carry")]
    assert [len(each.replace(".", "")) for each in row[2:3]] == [6]


def test_a_range_gives_the_unit_of_its_quantity_if_there_is_one(study, tmp_path):
    path = tmp_path / "ratios.toml"
    path.write_text('[impact]\nclub = "driver"\noutputs = ["smash", "carry"]\n[sweep]\nspeed = ["40 m/s", "50 m/s"]\n')
    study("run", path)
    _, smash, carry = (each["text"] for each in study("summary", path, "--json").json["summary"])
    assert re.fullmatch(r"Smash\D* ranges from 1\.\d+ to 1\.\d+\.", smash)
    assert re.fullmatch(r"Carry\D* ranges from \d+\.\d+ to \d+\.\d+ yd\.", carry)


def test_a_level_in_per_cent_is_written_as_in_every_sentence(study, tmp_path):
    path = tmp_path / "damp.toml"
    path.write_text(
        '[impact]\nclub = "driver"\nheld = { speed = "45 m/s" }\noutputs = ["carry"]\n'
        '[sweep]\nair.humidity = ["10 %", "90 %"]\n'
    )
    study("run", path)
    assert re.findall(r"\d+ ?%", study("summary", path).out) == ["10%", "90%"]


def test_classes_of_an_input_are_printed_no_finer_than_they_are_wide(study, tmp_path):
    """Ten classes of 85 to 120 mph are 3.5 mph wide: their ends are told to a tenth."""
    path = tmp_path / "many.toml"
    path.write_text(
        '[study]\ndesign = "sobol"\nsamples = 64\n[impact]\nclub = "driver"\noutputs = ["carry"]\n'
        '[sweep]\nspeed = { from = "85 mph", to = "120 mph" }\n'
    )
    study("run", path)
    lines = [line.split("mph")[0].strip() for line in study("summary", path).out.splitlines() if " to " in line]
    assert len(lines) == 10
    assert all(re.fullmatch(r"\d{2,3}\.\d to \d{2,3}\.\d", each) for each in lines), lines


def test_shares_and_damage_are_noted(study, tmp_path):
    path = squares(tmp_path)
    assert study("run", path, "--shard", "1/2", "--json").notes("study-left")[0]["chunks"] == 10
    missing = [row["chunk"] for row in study("status", path, "--json").rows() if row["state"] == "missing"]
    assert missing == list(range(1, 20, 2))
    (tmp_path / "squares.store" / "parts" / "0000" / "00000002.parquet").write_bytes(b"")
    assert study("run", path, "--json").notes("study-parts-mended") == [{"parts": 1, "shown": [2]}]


def test_the_state_of_a_study_counts_the_missing_chunks_that_it_does_not_list(study, tmp_path):
    path = squares(tmp_path, chunk=2)
    study("run", path, "--shard", "1/2")
    state = study("status", path, "--json")
    values, listed = state.values, len(state.rows())
    left = values["chunks"] - values["done"]
    assert left > listed
    assert state.notes("study-chunks-not-listed") == [{"chunks": left - listed, "left": left}]
    study("run", path)
    assert not study("status", path, "--json").notes("study-chunks-not-listed")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("[study]", "[study", ("this is not TOML",)),
        ("[study]", "[studies]", ("unknown key 'studies'", "did you mean study")),
        ("[study]", '[study]\nkind = "putts"', (":3:", "unknown study.kind 'putts'")),
        ("[study]", '[study]\ndesign = "sobolev"', ("unknown study.design 'sobolev'", "did you mean sobol")),
        ("[study]", "[study]\nseed = 1", ("leave it out of the design grid",)),
        ("[study]", '[study]\nseconds = "2 s"', ("since the chunk is given",)),
        ("chunk = 5", "chunk = 0", (":3:", "a whole number from 1 to 500000")),
        ("chunk = 5", 'seconds = "1 h"', ("seconds",)),
        ("[impact]", "[impacts]", ("unknown key 'impacts'",)),
        ('club = "driver"', "", ("club is missing",)),
        ('club = "driver"', 'club = "drivr"', ("unknown club 'drivr'", "did you mean driver")),
        ('club = "driver"', 'club = "no.toml"', ("no.toml", "cannot be read")),
        ('club = "driver"', 'club = "driver"\nmodel = "are"', ("unknown model 'are'", "did you mean area")),
        ('club = "driver"', 'club = "driver"\nweather = 1', ("unknown key 'weather'",)),
        ('speed = "105 mph"', 'lie = "1 deg"', ("speed is missing", "give it under [sweep]")),
        ('speed = "105 mph"', 'speed = "105 mph", loft = "9 deg"', ("loft is held and swept",)),
        ('speed = "105 mph"', 'speed = "105 deg"', ("speed", "not an angle")),
        ('speed = "105 mph"', 'sped = "105 mph"', ("unknown key 'sped'", "did you mean speed")),
        ('"carry", "side"', '"carri"', ("'carri'", "did you mean carry")),
        ("loft =", "lofts =", (":9:", "unknown input 'lofts'", "did you mean loft")),
        ("count = 4", "count = 4.5", (":9:", "a whole number from 1")),
        ('"8 deg"', '"8 mph"', (":9:", "not a speed")),
        ('["-10 mm", "0 mm", "10 mm"]', "[]", (":10:", "at least one value")),
        ('["-10 mm", "0 mm", "10 mm"]', '"-10 mm"', (":10:", "a list, or a table")),
        ("attack =", 'table = "a.csv"\nattack =', ('write design = "table"',)),
    ],
)
def test_a_mistake_in_the_file_is_reported_and_nothing_is_written(study, tmp_path, old, new, words):
    path = shots(tmp_path)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    assert_mistake(study("run", path), "shots.toml" if "no.toml" not in words else "no.toml", *words)
    assert [each.name for each in tmp_path.iterdir()] == ["shots.toml"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("run", "none.toml"), ("none.toml", "cannot be read")),
        (("run", "{}", "--workers", "0"), ("--workers is 0",)),
        (("run", "{}", "--shard", "5/4"), ("--shard is '5/4'",)),
        (("run", "{}", "--workers", "2", "--scheduler", "localhost:1"), ("--workers", "leave it out")),
        (("status", "{}"), ("no part of this study is finished yet",)),
        (("join", "{}", "-o", "all.xls"), ("--output", ".parquet")),
        (("summary", "{}", "--plot", "all.gif"), ("--plot", ".png")),
    ],
)
def test_a_mistake_in_the_options_is_reported(study, tmp_path, arguments, words):
    path = squares(tmp_path)
    assert_mistake(study(*(each.format(path) for each in arguments)), *words)


def test_a_quantity_that_the_study_lacks_is_reported(study, tmp_path):
    path = squares(tmp_path)
    study("run", path)
    assert_mistake(study("summary", path, "--output", "carry"), "unknown quantity of the study 'carry'")


def test_the_table_of_a_study_is_not_written_over(study, tmp_path):
    table, path = tmp_path / "drives.csv", tmp_path / "drives.toml"
    table.write_text("speed (mph)\n100\n")
    path.write_text(
        '[study]\ndesign = "table"\n[impact]\nclub = "driver"\noutputs = ["carry"]\n[sweep]\ntable = "drives.csv"\n'
    )
    study("run", path)
    assert_mistake(study("join", path, "-o", table), str(table))
    assert table.read_text() == "speed (mph)\n100\n"
