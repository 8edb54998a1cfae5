"""Sessions: tables below one another, several files, dates as people write them, and what changed between them."""

import numpy as np
import pytest

from clubface import present, read_shots, shots as launch_monitor
from clubface.errors import FileError
from clubface.inference.player_report import player_result
from clubface.shots.recorded import iso_dates, session_labels

MPH, DEG = 0.44704, np.pi / 180
SWAPPED = """\
Date,Club,Club Speed,Ball Speed,Launch Direction,Launch Angle,Dyn. Loft
2026-01-01,Driver,100,147,0.1,11,13
2026-01-01,Driver,99,146,0.3,11,13
Club,Date,Ball Speed,Club Speed,Launch Angle,Launch Direction,Dyn. Loft
Driver,2026-01-02,147,100,11,0.1,13
Driver,2026-01-02,146,99,11,0.3,13
"""
HEAD = "Date,Club,Club Speed (mph),Ball Speed (mph),Launch Angle (deg),Carry (yd)\n"


def day(date, speeds):
    return "".join(
        f"{date},Driver,{speed},{1.46 * speed:.1f},12.{place},{2.3 * speed:.1f}\n" for place, speed in enumerate(speeds)
    )


def test_a_second_header_has_its_own_order_of_columns(write):
    shots = launch_monitor.read(write(SWAPPED))
    np.testing.assert_allclose(shots.deliveries["speed"] / MPH, [100, 99, 100, 99])
    np.testing.assert_allclose(shots.launches["azimuth"] / DEG, [0.1, 0.3, 0.1, 0.3])
    assert shots.dates.tolist() == ["2026-01-01"] * 2 + ["2026-01-02"] * 2


def test_a_second_header_has_its_own_units_and_columns(write):
    first = "Club,Club Speed (mph),Ball Speed (mph)\nDriver,100,147\n\n"
    second = "Ball Speed (km/h),Carry (yd),Club Speed (km/h),Club\n236,160,160,7 Iron\n"
    shots = launch_monitor.read(write(first + second))
    np.testing.assert_allclose(shots.launches["ball_speed"], [147 * MPH, 236 / 3.6])
    np.testing.assert_allclose(shots.launches["carry"] / 0.9144, [np.nan, 160])
    assert shots.clubs.tolist() == ["Driver", "7 Iron"]


def test_a_table_of_another_maker_in_the_same_file_is_refused_with_its_line(write):
    text = SWAPPED + "Push/Pull (deg L-/R+),Club Speed (mph)\n1,100\n"
    with pytest.raises(FileError, match="another kind begins here") as refused:
        launch_monitor.read(write(text))
    assert refused.value.line == 7


@pytest.mark.parametrize(
    ("text", "date"),
    [
        ("2024-05-02", "2024-05-02"), ("2024/05/02 10:21:11", "2024-05-02T10:21:11"),
        ("2024-05-02T10:21:11Z", "2024-05-02T10:21:11"), ("02.05.2024 10:21", "2024-05-02T10:21:00"),
        ("05/02/24 1:05:09 PM", "2024-05-02T13:05:09"), ("May 2, 2024", "2024-05-02"), ("2nd May 2024", "2024-05-02"),
        ("2-May-2024", "2024-05-02"), ("2. März 2024", "2024-03-02"), ("2 de mayo de 2024", "2024-05-02"),
        ("2024年5月2日", "2024-05-02"), ("13/05/2024", "2024-05-13"), ("05/13/2024", "2024-05-13"),
        ("range day", "range day"), ("", ""), ("31/31/2024", "31/31/2024"),
    ],
)  # fmt: skip
def test_dates_of_many_spellings_are_days_of_one(text, date):
    assert iso_dates([text]) == ([date], None)


def test_one_day_above_12_tells_the_order_of_all_dates_and_none_is_noted():
    assert iso_dates(["03/04/2024", "25/04/2024"]) == (["2024-04-03", "2024-04-25"], None)
    dates, remark = iso_dates(["03/04/2024"])
    assert dates == ["2024-03-04"]
    assert remark.data["first"] == "month"


def test_several_files_are_sessions_with_date_and_file_and_are_read_back(write, tmp_path):
    first, second = write(HEAD + day("2026-01-01", [100, 99]), "a.csv"), write(HEAD + day("2026-02-01", [103]), "b.csv")
    shots = launch_monitor.read([first, second])
    assert shots.files.tolist() == ["a.csv", "a.csv", "b.csv"]
    assert shots.dates.tolist() == ["2026-01-01", "2026-01-01", "2026-02-01"]
    shots.write(tmp_path / "all.csv")
    again = read_shots(tmp_path / "all.csv")
    assert again.files.tolist() == shots.files.tolist()
    assert again.dates.tolist() == shots.dates.tolist()
    assert session_labels(again).tolist() == ["2026-01-01", "2026-01-01", "2026-02-01"]


def test_shots_of_one_day_are_one_session_whatever_the_hour(write):
    times = ("2026-01-01 10:00", "2026-01-01 10:01", "2026-01-02 9:30")
    shots = launch_monitor.read(write(HEAD + "".join(day(time, [100]) for time in times)))
    assert session_labels(shots).tolist() == ["2026-01-01", "2026-01-01", "2026-01-02"]


def test_files_of_one_name_are_distinguished_by_their_folders(tmp_path):
    paths = [tmp_path / month / "range.csv" for month in ("may", "june")]
    for place, path in enumerate(paths):
        path.parent.mkdir()
        path.write_text(HEAD + day("", [100 + place]))
    shots = launch_monitor.read(paths)
    assert shots.files.tolist() == session_labels(shots).tolist() == ["may/range.csv", "june/range.csv"]


def test_the_hand_of_shots_is_not_known_where_only_one_of_the_files_says_it(write):
    speeds = "Club Speed (mph),Ball Speed (mph)"
    left = write(f"Handed,{speeds}\nleft,100,146\n", "left.csv")
    both = write(f"{speeds}\n99,145\n", "unknown.csv")
    assert launch_monitor.read([left, both]).hand is None
    assert launch_monitor.read([left, write(f"Hand,{speeds}\nright,98,144\n", "c.csv")]).hand.tolist() == [
        "left", "right"
    ]  # fmt: skip


def test_shots_of_overlapping_exports_and_of_a_file_given_twice_count_once(write):
    first = write(HEAD + day("2026-01-01", [100, 99]), "a.csv")
    both = write(HEAD + day("2026-01-01", [100, 99]) + day("2026-02-01", [100, 98]), "b.csv")
    shots = launch_monitor.read([first, both, first])
    assert len(shots) == 4
    assert ("shots-in-earlier-file", {"left": 2, "shots": 4, "in_files": ["b.csv"]}) in shots.notes


def test_equal_shots_of_one_file_and_shots_of_one_number_are_no_duplicates(write):
    same = HEAD + day("2026-01-01", [100]) * 2
    assert len(launch_monitor.read(write(same, "a.csv"))) == 2
    single = [write("Club,Ball Speed (mph)\nDriver,147\n", name) for name in ("c.csv", "d.csv")]
    assert len(launch_monitor.read(single)) == 2


def test_files_of_different_makers_and_rejected_rows_keep_their_names(write):
    own = write(HEAD + day("2026-03-01", [101]) + "2026-03-01,Driver,x,147,12,230\n", "own.csv")
    shots = launch_monitor.read([write(SWAPPED, "trackman.csv"), own])
    assert shots.format == "trackman and clubface"
    assert shots.rejected[0].reason.startswith("own.csv: Club Speed (mph): 'x'")
    assert shots.face_at == "contact"  # only one of the files has face data


def test_a_report_says_what_changed_from_session_to_session_and_how_sure_that_is(write, tmp_path):
    old = day("2026-01-01", [98, 99, 100, 97, 99, 98])
    new = day("2026-02-01", [104, 105, 103, 104, 106, 104])
    shots = launch_monitor.read(write(HEAD + new + old))
    result = player_result(shots)
    (sessions,) = (part for club in result.parts for part in club.parts if part.kind == "sessions")
    rows = sessions.tables[0].records()
    assert [(row["session"], row["shots"]) for row in rows] == [("2026-01-01", 6), ("2026-02-01", 6)]
    assert [row["speed_mps"] / MPH for row in rows] == pytest.approx([98.5, 104.0])
    text = present.write_report(result, tmp_path / "report.md").read_text()
    assert text.index("| 2026-01-01 | 6 | 98.5") < text.index("| 2026-02-01 | 6 | 104.0")
    notes = {next(iter(each.data["change"])): each for each in sessions.notes}
    assert notes["speed"].code == "player-session-changed"
    assert notes["speed"].data["change"]["speed"] == pytest.approx(5.5 * MPH)
    # Student's t of Welch's 10 degrees of freedom, 2.228, times the root of pi / 2 and of both variances over six,
    # which are 1.1 and 1.0667 mph squared.
    margin = 2.228 * np.sqrt(np.pi / 2 * (1.1 + 1.0667) / 6)
    assert notes["speed"].data["margin"]["speed"] == pytest.approx(margin * MPH, rel=1e-3)
    assert notes["launch"].code == "player-session-no-sure-change"
    one = present.write_report(player_result(launch_monitor.read(write(HEAD + new))), tmp_path / "one.md")
    assert "session to session" not in one.read_text()
