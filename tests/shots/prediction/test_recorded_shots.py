"""Launches for recorded shots: what their file says of them is honoured, whichever command reads it."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

import clubface
from attached_notes import codes, noted
from clubface import shots as launch_monitor
from clubface.errors import FileError, InputError
from clubface.jobs.store import unfinished_folder
from clubface.shots.prediction import predict
from deliveries import table as rows_of

TRACKMAN = Path(__file__).parents[2] / "data" / "launch_monitors" / "trackman.csv"
DEG = np.pi / 180
CONTACT = (
    "club,face_at,player,club_speed_mph,loft_deg,face_deg,toe_mm,high_mm,azimuth_deg\n"
    "Driver,contact,A,100,13,2,15,0,0.4\nDriver,contact,B,101,13,2.5,14,-3,0.5\n7i,contact,B,85,24,0,3,1,0\n"
    "Driver,contact,A,99,12,1,,2,0.1\n"
)


def column(path, name):
    return np.array([float(row[name]) for row in rows_of(path)])


@pytest.fixture
def shots(write):
    return write(CONTACT)


def test_face_angles_of_the_impact_point_are_referred_to_the_face_centre(shots):
    """With a bulge of 305 mm a driver points 2.8 deg more to the right 15 mm towards the toe than at its centre."""
    report = predict(shots, club="driver", only="Driver")
    azimuth = column(report.output, "predicted_azimuth_deg")
    delivery = {"speed": "100 mph", "loft": 13 * DEG, "face": 2 * DEG, "toe": 0.015, "high": 0.0}
    wrong = clubface.impact("driver", delivery).get("azimuth", "deg")
    recorded = launch_monitor.read(shots).select([0])
    right = clubface.impact("driver", launch_monitor.refer(recorded, "driver").delivery()).get("azimuth", "deg")
    # Nine digits are written. What was wrong by degrees is wrong by none.
    assert azimuth[0] == pytest.approx(right[0], rel=1e-8)
    assert abs(wrong - right[0]) > 1.0
    assert noted(report, "referred-contact-face")[0]["club"] == "driver"


def test_a_monitors_file_and_its_table_give_what_evaluate_computes(tmp_path):
    table = tmp_path / "shots.csv"
    launch_monitor.read(TRACKMAN).write(table)
    reports = [
        predict(source, club="driver", only="Driver", output=tmp_path / f"{place}.csv")
        for place, source in enumerate((TRACKMAN, table))
    ]
    assert rows_of(reports[0].output) == rows_of(reports[1].output)
    evaluated = clubface.evaluate(TRACKMAN, only="Driver", models="response")
    for name, heading in (("azimuth", "predicted_azimuth_deg"), ("launch", "predicted_launch_deg")):
        computed = np.degrees(evaluated.predicted["response"][name])
        np.testing.assert_allclose(column(reports[0].output, heading), computed, rtol=1e-8)  # nine digits are written


def test_only_chosen_rows_are_written_as_they_stand(shots):
    report = predict(shots, club="driver", where="club == 'Dr' and face > 1.5 deg")
    assert (report.rows, report.written, report.rejected) == (2, 2, 0)
    assert [row["player"] for row in rows_of(report.output)] == ["A", "B"]
    assert [(each["fulfil"], each["shots"]) for each in noted(report, "condition-fulfilled")] == [(2, 4)]


def test_unmeasured_rows_are_rejected_unless_a_value_is_stated(shots):
    report = predict(shots, club="driver", only="Driver")
    assert report.first_rejects == ((5, 'toe_mm: not measured; --assume "toe=..." states a value'),)
    stated = predict(shots, club="driver", only="Driver", assume={"toe": "0 mm", "closure": "2000 deg/s"})
    assert (stated.written, stated.rejected) == (3, 0)
    assert noted(stated, "value-stated") == [
        {"quantity": "toe", "lacking": 1, "shots": 3, "stated": "0 mm"},
        {"quantity": "closure", "lacking": 3, "shots": 3, "stated": "2000 deg/s"},
    ]
    delivery = {"speed": "99 mph", "loft": 12 * DEG, "face": 1 * DEG, "toe": 0.0, "high": 0.002}
    before = clubface.impact("driver", delivery, model="response").get("azimuth", "deg")
    assert column(stated.output, "predicted_azimuth_deg")[2] != pytest.approx(before, abs=0.01)  # the face closes


def test_rows_keep_their_results_when_others_are_left_out(write):
    lines = CONTACT.splitlines()
    source = write("\n".join([lines[0], lines[3], lines[4], lines[1], lines[3], lines[2]]))
    report = predict(source, club="driver", only="Dr")
    rows = rows_of(report.output)
    assert [(row["player"], row["club_speed_mph"]) for row in rows] == [("A", "100"), ("B", "101")]
    assert [line for line, _ in report.first_rejects] == [3]
    with open(report.rejects, newline="") as file:
        assert [(row["line"], row["club_speed_mph"]) for row in csv.DictReader(file)] == [("3", "99")]


def test_rejected_rows_of_a_monitor_are_reported_once_for_any_chunk_size(tmp_path):
    options = {"club": "7-iron", "only": "7i", "assume": {"speed": "80 mph", "path": 0.0, "attack": 0.0}}
    whole, parts = (
        predict(TRACKMAN, output=tmp_path / f"{rows}.csv", chunk_rows=rows, **options) for rows in (1000, 1)
    )
    assert (whole.written, whole.rejected) == (parts.written, parts.rejected) == (2, 3)
    assert Path(whole.output).read_bytes() == Path(parts.output).read_bytes()
    assert Path(whole.rejects).read_bytes() == Path(parts.rejects).read_bytes()


def test_shots_of_another_club_are_refused_or_noted(shots, write):
    with pytest.raises(InputError, match="several clubs that were hit"):
        predict(shots, club="driver")
    irons = write("club_name,club_speed_mph\n7i,80\n7 Iron,81\n", "irons.csv")
    with pytest.raises(InputError, match=r"the shots name 7i, 7 Iron, not driver.*--mismatch note"):
        predict(irons, club="driver")
    assert not irons.with_name("irons-launches.csv").exists()
    for source, count in ((shots, 4), (irons, 2)):
        report = predict(source, club="driver", mismatch="note", assume={"toe": 0.0})
        assert report.written == count
        assert "club-may-be-other" in codes(report)


def test_a_table_of_deliveries_is_not_treated_as_recorded_shots(write):
    """It names no club, so that nothing can be of another one: a 7-iron's loft on a driver is a question."""
    report = predict(write("club_speed_mph,loft_deg\n100,31\n"), club="driver")
    assert (report.written, report.notes) == (1, ())


@pytest.mark.parametrize("ending", ["csv", "parquet"])
def test_an_interrupted_run_over_chosen_rows_goes_on_where_it_stopped(write, tmp_path, ending):
    if ending == "parquet":
        pytest.importorskip("pyarrow")
    lines = CONTACT.splitlines()
    source = write("\n".join([lines[0], *lines[1:] * 5, "Driver,contact,A,fast,13,2,15,0,0"]))
    options = {"club": "driver", "only": "Driver", "assume": {"toe": "2 mm"}}
    whole = predict(source, output=tmp_path / f"whole.{ending}", **options)
    assert (whole.written, whole.rejected) == (15, 1)

    def stop(part, rows):
        if rows >= 5:
            raise KeyboardInterrupt

    target = tmp_path / f"parts.{ending}"
    with pytest.raises(KeyboardInterrupt):
        predict(source, output=target, chunk_rows=3, progress=stop, **options)
    assert unfinished_folder(target).exists()
    report = predict(source, output=target, chunk_rows=4, resume=True, **options)
    assert (report.written, report.rejected) == (15, 1)
    assert report.resumed >= 5
    if ending == "csv":
        assert target.read_bytes() == Path(whole.output).read_bytes()
    else:
        import pyarrow.parquet as parquet

        assert parquet.read_table(target).equals(parquet.read_table(whole.output))


def test_a_resumed_run_of_other_choices_is_another_run(shots, tmp_path):
    def stop(part, rows):
        raise KeyboardInterrupt

    options = {"club": "driver", "only": "Driver", "output": tmp_path / "out.csv", "chunk_rows": 1}
    with pytest.raises(KeyboardInterrupt):
        predict(shots, progress=stop, assume={"toe": "0 mm"}, **options)
    with pytest.raises(FileError, match="another choice of shots"):
        predict(shots, resume=True, assume={"toe": "9 mm"}, **options)


def test_a_monitors_file_becomes_parquet_with_what_was_measured(tmp_path):
    parquet = pytest.importorskip("pyarrow.parquet")
    report = predict(TRACKMAN, club="7-iron", only="7i", output=tmp_path / "out.parquet")
    table = parquet.read_table(report.output)
    assert table["club"].to_pylist() == ["7 Iron"]
    assert table["toe_mm"].to_pylist() == [None]
    assert table["predicted_launch_deg"].to_pylist()[0] > 15.0
    assert [line for line, _ in report.first_rejects] == [6, 7, 8, 9]


def test_a_file_without_club_speeds_says_so(write):
    with pytest.raises(FileError, match="no shot has a measured club speed"):
        predict(write("club,club_speed_mph,loft_deg\nDriver,,12\n"), club="driver")
