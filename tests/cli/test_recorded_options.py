"""Every command that reads shots takes the same options and obeys the same file."""

from __future__ import annotations

import csv
import re
from dataclasses import replace
from pathlib import Path

import pytest

from clubface.shots.reading import read_shots
from clubface.validation.benchmark_data import FOLDER
from command_line import assert_mistake

pytest.importorskip("typer")
pytest.importorskip("pyarrow")

SHOTS = str(FOLDER / "7-iron.parquet")
TRACKMAN = str(Path(__file__).parents[1] / "data" / "launch_monitors" / "trackman.csv")
GARMIN = "Club Type,Club Speed,Ball Speed,Launch Direction,Carry Deviation Distance\n7 Iron,36,52,1,2\n"
FAST = "speed > 82 mph and abs(face) < 3 deg"


def commands(tmp_path):
    """Each command that works on shots, with what makes it quick."""
    return {
        "evaluate": ["--models", "slip", "--resamples", "100", "--json"],
        "identify": [
            "--model", "slip", "--free", "slip_y", "--population", "4", "--generations", "1", "--folds", "0",
            "--bootstrap", "0", "--no-profiles", "--refined", "1", "--json", "--checkpoint", str(tmp_path / "kept"),
        ],
        "infer": ["-o", str(tmp_path / "inferred.csv"), "--samples", "50", "--json"],
        "predict": ["--club", "7-iron", "-o", str(tmp_path / "launches.csv"), "--json"],
        "monitor summary": ["--json"],
        "monitor read": ["--json"],
    }  # fmt: skip


def notes_of(ran):
    notes = [each["text"] if isinstance(each, dict) else each for each in ran.json.get("notes", [])]
    return " ".join([*notes, *ran.json.get("warnings", []), ran.err.replace("\n", " ")])


@pytest.mark.parametrize("name", ["evaluate", "identify", "infer", "predict", "monitor summary", "monitor read"])
def test_every_command_takes_a_condition(clubface_, tmp_path, name):
    condition = FAST + " and row <= 12"
    ran = clubface_(*name.split(), SHOTS, *commands(tmp_path)[name], "--where", condition)
    assert ran.status == 0, ran.err
    assert "of 120 shots meet speed > 82 mph" in notes_of(ran)
    assert_mistake(
        clubface_(*name.split(), SHOTS, *commands(tmp_path)[name], "--where", "speed > 82"), "--where", "needs a unit"
    )


@pytest.mark.parametrize("name", ["evaluate", "identify", "infer", "predict"])
def test_every_command_refuses_another_club_and_takes_stated_values(clubface_, tmp_path, name):
    arguments = [*commands(tmp_path)[name], "--where", "row <= 12"]
    arguments = [each for each in arguments if each not in ("--club", "7-iron")]
    assert_mistake(clubface_(name, SHOTS, *arguments, "--club", "driver"), "the shots name 7-iron, not driver")
    ran = clubface_(
        name,
        SHOTS,
        *arguments,
        "--club",
        "8-iron",
        "--mismatch",
        "note",
        "--assume",
        "toe=1 mm",
        "--hand",
        "right",
    )
    assert ran.status == 0, ran.err
    message = notes_of(ran)
    assert "the shots name 7-iron, not 8-iron: is this the right club?" in message
    assert "toe was measured in every shot" in message


@pytest.mark.parametrize("name", ["evaluate", "infer", "predict", "monitor summary"])
def test_every_command_reads_a_monitors_file_with_given_units(clubface_, tmp_path, write, name):
    path = str(write(GARMIN, "garmin.csv"))
    assert_mistake(clubface_(*name.split(), path, *commands(tmp_path)[name]), "--unit speed=mph")
    units = ["--unit", "speed=m/s", "--unit", "length=m"]
    ran = clubface_(*name.split(), path, *commands(tmp_path)[name], *units)
    assert ran.status == 0, ran.err


def test_predict_of_a_file_and_of_its_table_agree(clubface_, tmp_path):
    table = str(tmp_path / "shots.csv")
    assert clubface_("monitor", "read", TRACKMAN, "-o", table).status == 0
    result = []
    for source in (TRACKMAN, table):
        target = tmp_path / "launches.csv"
        ran = clubface_("predict", source, "--club", "driver", "--only", "Dr", "-o", str(target))
        assert ran.status == 0
        assert "converted to the face centre of driver" in ran.out
        with target.open(newline="") as file:
            result.append([row["predicted_azimuth_deg"] for row in csv.DictReader(file)])
    assert result[0] == result[1]
    assert len(result[0]) == 1


@pytest.mark.parametrize("name", ["evaluate", "identify", "infer", "golfer estimate", "predict", "monitor read",
                                  "monitor summary", "monitor report", "monitor send", "compare"])  # fmt: skip
def test_every_command_that_reads_a_file_refuses_numbers_without_a_unit_and_takes_the_options_it_prints(
    clubface_, tmp_path, write, name
):
    shots = replace(read_shots(SHOTS).select(slice(0, 10)), players=None).columns()
    heads = {"club_speed_mph": "Club Speed", "attack_deg": "Attack Angle"}
    plain = [heads.get(each, re.sub(r"_[a-z]+$| \[.*", "", each) if each != "club" else each) for each in shots]
    rows = zip(*shots.values(), strict=True)
    path = str(write("\n".join([",".join(plain), *(",".join(map(str, row)) for row in rows)]), "plain.csv"))
    more = {
        "golfer estimate": ["-o", str(tmp_path / "golfer.toml")],
        "monitor read": [],
        "monitor report": ["-o", str(tmp_path / "report.md")],
        "monitor send": ["--port", "9", "--timeout", "0.01 s"],
    }
    arguments = [path, *(commands(tmp_path) | more).get(name, [])]
    arguments = ["7-iron", "--deliveries", path, "--no-split"] if name == "compare" else arguments
    refused = clubface_(*name.split(), *arguments)
    assert refused.status == 2
    assert "Attack Angle" in refused.err
    assert "Club Speed" in refused.err
    printed = re.findall(r"--unit \S+", refused.err)
    ran = clubface_(*name.split(), *arguments, *" ".join(printed).split())
    if name == "monitor send":
        assert "no simulator" in ran.err or "cannot" in ran.err, ran.err
    else:
        assert ran.status == 0, ran.err
