"""Files of launches back to deliveries, and ``clubface infer``."""

from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface import units
from clubface.errors import FileError, InputError
from clubface.inference import file as files
from clubface.inference.run import CLUB_NOISE
from clubface.shots.recorded import RecordedShots
from command_line import assert_mistake
from deliveries import table as rows_of

OPTIONS = {"club": "driver", "samples": 60, "model": "slip"}
LAUNCH = ["--ball-speed", "159 mph", "--launch", "14.5 deg", "--backspin", "2900 rpm"]


def launches(n=3):
    return RecordedShots(
        deliveries={},
        launches={"ball_speed": np.linspace(69.0, 71.0, n), "launch": np.full(n, 0.25), "backspin": np.full(n, 300.0)},
        rows=np.arange(2, n + 2),
        source="range.csv",
        format="clubface",
    )


def test_every_launch_has_a_row_with_the_same_figures_as_alone(tmp_path):
    shots = launches()
    shots.launches["launch"][1] = np.nan
    report = files.infer_shots(shots, tmp_path / "out.csv", **OPTIONS)
    assert (report.shots, report.without, report.resumed) == (3, 0, 0)
    rows = rows_of(tmp_path / "out.csv")
    assert [row["row"] for row in rows] == ["2", "3", "4"]
    assert rows[1]["launch_deg"] == ""
    alone = clubface.infer({"ball_speed": 71.0, "launch": 0.25, "backspin": 300.0}, **OPTIONS)
    # Six digits are written.
    assert float(rows[2]["club_speed_mph"]) == pytest.approx(units.from_si(alone.mean["speed"], "mph"), rel=1e-5)
    low, high = np.degrees(alone.interval("loft"))
    assert float(rows[2]["loft_from_deg"]) == pytest.approx(low, rel=1e-5)
    assert float(rows[2]["loft_to_deg"]) == pytest.approx(high, rel=1e-5)
    assert float(rows[2]["closure_std [deg/s]"]) == pytest.approx(np.degrees(alone.deviation["closure"]), rel=1e-5)


def test_the_rows_are_deliveries_that_can_be_read(tmp_path):
    files.infer_shots(launches(1), tmp_path / "out.csv", **OPTIONS)
    shots = clubface.read_shots(tmp_path / "out.csv")
    assert set(shots.deliveries) == set(clubface.infer({"ball_speed": 70.0}, **OPTIONS).names)


def test_a_shot_without_a_launch_says_so(tmp_path):
    shots = launches()
    for each in shots.launches.values():
        each[0] = np.nan
    report = files.infer_shots(shots, tmp_path / "out.csv", **OPTIONS)
    assert report.without == 1
    assert rows_of(tmp_path / "out.csv")[0]["remark"] == "no launch quantity was measured"


def test_a_shot_out_of_reach_says_so_and_the_others_are_inferred(tmp_path):
    shots = launches()
    shots.launches["ball_speed"][1] = 2.0  # m/s
    report = files.infer_shots(shots, tmp_path / "out.csv", **OPTIONS)
    assert (report.shots, report.without) == (3, 1)
    rows = rows_of(tmp_path / "out.csv")
    assert "within reach of the prior" in rows[1]["remark"]
    assert rows[1]["loft_deg"] == ""
    assert rows[2]["loft_deg"] != ""


def test_the_noise_of_club_data_is_that_with_which_the_deliveries_are_inferred(tmp_path):
    shots = launches()
    shots.deliveries.update({"attack": np.full(len(shots), 0.02), "speed": np.full(len(shots), 50.0)})
    report = files.infer_shots(shots, tmp_path / "out.csv", delivery_noise={"attack": "0.1 deg"}, **OPTIONS)
    assert set(report.used) == set(report.club_noise) == {"speed", "attack"}
    assert report.club_noise["speed"] == CLUB_NOISE["speed"]
    assert report.club_noise["attack"] == pytest.approx(np.radians(0.1))
    # Far less than the prior leaves open, 2 degrees: the attack angle is known as well as it was measured.
    assert float(rows_of(tmp_path / "out.csv")[0]["attack_std_deg"]) < 0.12
    (used,) = [each for each in report.to_result().notes if each.code == "club-data-used"]
    assert used.data["noise"] == ["speed 1.5 mph", "attack 0.1 deg"]


def test_an_interrupted_file_is_resumed_to_the_same_bytes(tmp_path):
    whole, again = tmp_path / "whole.csv", tmp_path / "again.csv"
    files.infer_shots(launches(), whole, **OPTIONS)

    def stop(done, total):
        if done == 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt, match=r"^2 of \d+ shots are done; they are in .*again\.csv\.unfinished"):
        files.infer_shots(launches(), again, progress=stop, **OPTIONS)
    with pytest.raises(FileError, match="another club, prior or option"):
        files.infer_shots(launches(), again, resume=True, **{**OPTIONS, "seed": 1})
    report = files.infer_shots(launches(), again, resume=True, **OPTIONS)
    assert (report.shots, report.resumed) == (3, 2)
    assert again.read_bytes() == whole.read_bytes()
    assert {each.name for each in tmp_path.iterdir()} == {"whole.csv", "again.csv"}


def test_processes_write_the_bytes_of_this_one(tmp_path, monkeypatch):
    files.infer_shots(launches(6), tmp_path / "here.csv", **OPTIONS)
    monkeypatch.setattr(files, "FEWEST_FOR_PROCESSES", 1)
    monkeypatch.setattr(files, "processors", lambda: 2)
    monkeypatch.setattr(files, "in_sequence", None)
    report = files.infer_shots(launches(6), tmp_path / "there.csv", **OPTIONS)
    assert (report.shots, report.resumed) == (6, 0)
    assert (tmp_path / "there.csv").read_bytes() == (tmp_path / "here.csv").read_bytes()


def test_files_that_cannot_be_written_or_hold_no_launch_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"ending in \.csv"):
        files.infer_shots(launches(), tmp_path / "out.parquet", **OPTIONS)
    with pytest.raises(FileError, match="no folder"):
        files.infer_shots(launches(), tmp_path / "none" / "out.csv", **OPTIONS)
    nothing = RecordedShots(
        deliveries={"speed": np.ones(1)}, launches={}, rows=np.ones(1), source="x", format="clubface"
    )
    with pytest.raises(InputError, match="measured launch"):
        files.infer_shots(nothing, tmp_path / "out.csv", **OPTIONS)


def test_one_launch_is_printed_with_what_goes_together(clubface_):
    ran = clubface_("infer", "--club", "driver", *LAUNCH, "--model", "slip", "--samples", "300")
    text = " ".join(ran.out.split())
    assert "attack and loft are tied" in text
    assert "The launch says nothing about" in text
    assert "narrower" in text


def test_json_draws_and_picture_are_written(clubface_, tmp_path):
    pytest.importorskip("matplotlib")
    draws, picture = tmp_path / "draws.csv", tmp_path / "pairs.png"
    ran = clubface_(
        "infer", "--club", "7-iron", "--ball-speed", "117 mph", "--launch", "19 deg", "--backspin", "6500 rpm",
        "--samples", "80", "--model", "slip", "--set", "slip_y=0.1", "--noise", "backspin=100 rpm", "--seed", "4",
        "--json", "-o", str(draws), "--plot", str(picture),
    )  # fmt: skip
    document = ran.json
    assert document["values"]["seed"] == 4
    assert {row["parameter"]: row["value"] for row in document["tables"]["parameters"]["rows"]}["slip_y"] == 0.1
    noise = {row["quantity"]: row["noise"] for row in document["tables"]["measured"]["rows"]}
    assert noise["backspin"] == pytest.approx(100.0)
    assert len(clubface.read_shots(draws)) == 80
    assert picture.exists()


def test_a_file_of_launches_is_inferred(clubface_, write, tmp_path):
    source = write("club,ball_speed_mph,launch_deg\nDriver,159,14\nDriver,150,13\n")
    target = tmp_path / "out.csv"
    ran = clubface_("infer", str(source), "-o", str(target), "--samples", "50")
    assert ran.out.startswith(f"2 of 2 launches inferred: {target}\n")
    assert len(rows_of(target)) == 2


def test_mistakes_are_one_message(clubface_, write, tmp_path):
    source = str(write("ball_speed_mph,launch_deg\n159,14\n"))
    assert_mistake(clubface_("infer", *LAUNCH), "--club is missing")
    assert_mistake(clubface_("infer", "--club", "driver"), "give at least one of --ball-speed, --launch")
    assert_mistake(clubface_("infer", "--club", "driver", *LAUNCH, "--prior", "elit"), "did you mean elite")
    assert_mistake(clubface_("infer", "--club", "driver", *LAUNCH, "--plot", "x.bmp"), "x.bmp")
    assert_mistake(clubface_("infer", source, "--club", "driver"), "--output is missing")
    assert_mistake(clubface_("infer", source, "--club", "driver", "-o", source), "another output file")
    assert_mistake(clubface_("infer", "--club", "driver", "--ball-speed", "159"), '"159 mph"', "bare number is in m/s")
    assert_mistake(clubface_("infer", "--club", "driver", "--ball-speed", "159 m/s"), "within reach of the prior")
    assert_mistake(clubface_("infer", source, *LAUNCH, "--club", "driver"), "--ball-speed is for one launch")


def test_a_file_is_not_resumed_with_other_shots(tmp_path):
    shots, output = launches(), tmp_path / "out.csv"

    def stop(done, total):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        files.infer_shots(shots, output, progress=stop, **OPTIONS)
    launch = {name: values.copy() for name, values in shots.launches.items()}
    launch["launch"][2] += 1e-9
    for what, changed in {
        "set of measured shots": replace(shots, launches=launch),
        "another set of measured shots": replace(shots, deliveries={"attack": np.full(3, 0.05)}),
        "set of measured shots;": replace(shots, hand=np.array(["left"] * 3, dtype=object)),
        "point of measurement": replace(shots, speed_at="face"),
    }.items():
        with pytest.raises(FileError, match=what):
            files.infer_shots(changed, output, resume=True, **OPTIONS)
    assert files.infer_shots(shots, output, resume=True, **OPTIONS).resumed == 1
