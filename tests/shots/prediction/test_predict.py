"""Files of deliveries: columns by name and unit, every bad row accounted for, interruption and resumption."""

import os

import numpy as np
import pytest

import clubface
from clubface.errors import FileError, InputError
from clubface.shots.prediction import predict
from clubface.shots.tables import row_source
from deliveries import GOOD, table

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")


def test_each_row_is_its_impact_and_flight(write, tmp_path):
    """Written with 9 digits: half a unit of the ninth is at most 5e-9."""
    report = predict(write(GOOD), club="driver", output=tmp_path / "out.csv", model="volumetric")
    rows = table(tmp_path / "out.csv")
    assert [row["id"] for row in rows] == ["a", "b"]
    launch = clubface.impact(
        "driver", speed="113 mph", attack="-1.3 deg", loft="12.8 deg", toe="5 mm", model="volumetric"
    )
    flight = clubface.fly(launch)
    for heading, value in {
        "ball_speed_mps": launch.ball_speed,
        "smash": launch.smash,
        "launch_deg": launch.get("launch", "deg"),
        "azimuth_deg": launch.get("azimuth", "deg"),
        "backspin_rpm": launch.get("backspin", "rpm"),
        "sidespin_rpm": launch.get("sidespin", "rpm"),
        "total_spin_rpm": launch.get("total_spin", "rpm"),
        "spin_axis_deg": launch.get("spin_axis", "deg"),
        "carry_m": flight.carry,
        "side_m": flight.side,
        "apex_m": flight.apex,
        "landing_deg": flight.get("landing_angle", "deg"),
        "contact_time_s": launch.contact_time,
        "peak_force_n": launch.peak_force,
    }.items():
        assert float(rows[0][heading]) == pytest.approx(value, rel=5.1e-9), heading
        assert heading in report.added
    assert (report.rows, report.written, report.rejected, report.rejects) == (2, 2, 0, None)
    assert report.used["impact_toe_mm"] == ("toe", "mm")
    assert report.passed == ("id",)
    assert report.provenance["model"]["name"] == "volumetric"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.csv", "shots.csv"]


def test_a_meshed_ball_is_hit_by_finite_elements(write, tmp_path):
    source = write("club_speed_mps\n40\n")
    smash = {}
    for ball in ("modern", "reference"):
        predict(source, club="driver", output=tmp_path / f"{ball}.csv", model="fem", ball=ball, carry=False)
        smash[ball] = float(table(tmp_path / f"{ball}.csv")[0]["smash"])
        launch = clubface.impact("driver", speed=40.0, model="fem", ball=ball)
        assert smash[ball] == pytest.approx(launch.smash, rel=5.1e-9)
    # The one loses what real balls lose, the other nothing.
    assert smash["modern"] < smash["reference"] - 0.05


def test_unused_columns_are_passed_through_untouched(write, tmp_path):
    text = 'club_speed_mph,"note, long",x\n 113 ,"he said ""so""\nand left",  007\n'
    predict(write(text.replace("\n", "\r\n")), club="driver", output=tmp_path / "out.csv", carry=False)
    body = (tmp_path / "out.csv").read_bytes().decode()
    assert '\n 113 ,"he said ""so""\r\nand left",  007,5' not in body
    assert body.split("\n", 1)[1].startswith(' 113 ,"he said ""so""\r\nand left",  007,7')
    assert "carry_m" not in body


BAD_ROWS = [
    ("c,abc,-1.3,12.8,5", "club_speed_mph: 'abc' is not a number"),
    ("c,,-1.3,12.8,5", "club_speed_mph: the cell is empty"),
    ("c,nan,-1.3,12.8,5", "club_speed_mph: 'nan' is not a finite number"),
    ("c,inf,-1.3,12.8,5", "club_speed_mph: 'inf' is not a finite number"),
    ("c,1_0,-1.3,12.8,5", "club_speed_mph: '1_0' is not a number"),
    ("c,113,-1.3,12.8", "4 cells where there are 5 columns"),
    ("c,113,-1.3,12.8,5,6,7", "7 cells where there are 5 columns; beyond them: '6', '7'"),
    ("c,113,-1.3,12.8,80", "toe: impact at 80.0 mm is outside the face outline; allowed: +-52.5 mm"),
    ("c,-113,-1.3,12.8,5", "speed: -50.5155 must be above 0"),
    ("c,113,-1.3,95,5", "loft: 95 deg"),
    ("c,113,-89,80,5", "the face moves away"),
    ('c,113,-1.3,"12"x,5', "this is not CSV"),
    ('c,113,-1.3,12.8,"5', "a quoted cell that begins here does not end"),
]


@pytest.mark.parametrize(("row", "reason"), BAD_ROWS)
def test_a_bad_row_is_kept_aside_with_line_and_reason(write, tmp_path, row, reason):
    report = predict(write(GOOD + "\n" + row + "\n"), club="driver", output=tmp_path / "out.csv")
    assert (report.rows, report.written, report.rejected, report.blank) == (3, 2, 1, 1)
    assert [each["id"] for each in table(tmp_path / "out.csv")] == ["a", "b"]
    (kept,) = table(report.rejects)
    assert kept["line"] == "5"
    assert reason in kept["reason"]
    assert "c" in kept["id"]
    assert report.first_rejects[0][0] == 5
    assert reason in str(report)


def test_line_numbers_survive_cells_of_several_lines_blank_lines_and_pieces(write, tmp_path):
    lines = ["id,club_speed_mph", "", '"one\ntwo\nthree",50', "x,bad", "", "y,51", '"p\nq",worse', "z,52"]
    path = write("\n".join(lines))
    for chunk in (1, 2, 100):
        report = predict(path, club="driver", output=tmp_path / "out.csv", chunk_rows=chunk)
        assert [line for line, _ in report.first_rejects] == [6, 9]
        assert [row["line"] for row in table(report.rejects)] == ["6", "9"]
        assert [row["id"] for row in table(tmp_path / "out.csv")] == ["one\ntwo\nthree", "y", "z"]


@pytest.mark.parametrize("chunk", [1, 3, 100])
def test_each_bad_row_is_rejected_for_its_own_reason(write, tmp_path, chunk):
    """Unreadable, refused by the core, of the wrong width, good: in one chunk each keeps its own place."""
    rows = ["a,x,1", "b,100,1", "c,100,80", "d,100", "e,y,1", "f,101,2", "g,100,90", "h,102,3", "i,-1,3", "j,103,4"]
    path = write("id,speed_mph,toe_mm\n" + "\n".join(rows))
    report = predict(path, club="driver", output=tmp_path / "out.csv", chunk_rows=chunk)
    assert [row["id"] for row in table(tmp_path / "out.csv")] == ["b", "f", "h", "j"]
    kept = table(report.rejects)
    assert [(row["line"], row["id"]) for row in kept] == [
        ("2", "a"), ("4", "c"), ("5", "d"), ("6", "e"), ("8", "g"), ("10", "i"),
    ]  # fmt: skip
    reasons = ["'x' is not a number", "80.0 mm", "2 cells", "'y' is not a number", "90.0 mm", "above 0"]
    assert all(text in row["reason"] for text, row in zip(reasons, kept, strict=True))
    for row in table(tmp_path / "out.csv"):
        alone = clubface.impact("driver", speed=row["speed_mph"] + " mph", toe=row["toe_mm"] + " mm")
        assert float(row["ball_speed_mps"]) == pytest.approx(alone.ball_speed, rel=5.1e-9)


def test_long_rows_make_short_chunks(write, tmp_path, monkeypatch):
    """Rows of some thousand characters; a chunk ends after 10000, however many rows it may have."""
    path = write("speed [m/s],note\n" + "".join(f"{40 + row},{'x' * 4000}\n" for row in range(10)))
    whole, cut = tmp_path / "whole.csv", tmp_path / "cut.csv"
    predict(path, club="driver", output=whole)
    done = []
    monkeypatch.setattr(row_source, "LARGEST_CHUNK", 10_000)
    predict(path, club="driver", output=cut, progress=lambda part, rows: done.append(rows))
    assert done == [3, 6, 9, 10]
    assert cut.read_bytes() == whole.read_bytes()


def test_the_chunk_size_changes_no_byte(write, tmp_path):
    rng = np.random.default_rng(3)
    drawn = zip(rng.normal(105, 9, 120), rng.normal(0, 30, 120), strict=True)
    rows = [f"{i},{speed:.2f},{toe:.1f}" for i, (speed, toe) in enumerate(drawn)]
    path = write("id,speed_mph,toe_mm\n" + "\n".join(rows))
    result = []
    for chunk in (1, 7, 1_000_000):
        report = predict(path, club="driver", output=tmp_path / "out.csv", chunk_rows=chunk)
        assert report.written + report.rejected == 120
        assert 0 < report.rejected < 24
        result.append([(tmp_path / "out.csv").read_bytes(), (tmp_path / "out.rejects.csv").read_bytes()])
    assert result[0] == result[1] == result[2]


@pytest.mark.parametrize(
    "heading",
    [
        "speed [mph]",
        "club_speed_mph",
        "Club Speed (mph)",
        "Clubhead Speed mph",
        "CLUB_SPEED_MPH",
        "club-speed_mph",
        "Club_Speed_Mph",
        "Club Speed [Mph]",
    ],
)
def test_a_column_is_known_by_many_names(write, tmp_path, heading):
    with_a_mark_and_tabs = f"\ufeff{heading}\tclub_mass_g\r\n113\t205\r\n"
    report = predict(write(with_a_mark_and_tabs), club="driver", output=tmp_path / "out.csv")
    assert (report.used[heading], report.used["club_mass_g"]) == (("speed", "mph"), ("club_mass", "g"))
    expected = clubface.impact("driver", speed="113 mph", club_mass="205 g").ball_speed
    assert float(table(report.output, "\t")[0]["ball_speed_mps"]) == pytest.approx(expected, rel=5.1e-9)


def test_a_column_without_a_unit_is_refused_until_the_unit_is_given(write, tmp_path):
    path = write("speed,toe_mm\n112,5\n")
    with pytest.raises(FileError, match=r"shots.csv:1: the column 'speed' names no unit.*--unit speed=mph"):
        predict(path, club="driver", output=tmp_path / "out.csv")
    report = predict(path, club="driver", output=tmp_path / "out.csv", units={"speed": "mph"})
    assert report.used["speed"] == ("speed", "mph")
    assert (tmp_path / "out.csv").read_text().splitlines()[1].startswith("112,5,")


def test_a_misspelt_column_is_pointed_out(write, tmp_path):
    report = predict(write("speed_mph,atack_deg,weather\n50,5,1\n"), club="driver", output=tmp_path / "out.csv")
    assert report.passed == ("atack_deg", "weather")
    assert report.notes == (("column-misspelled", {"column": "atack_deg", "near": "attack"}),)


def test_measured_launches_in_the_file_are_not_written_over(write, tmp_path):
    source = write("speed_mph,launch_deg\n100,11\n")
    predict(source, club="driver", output=tmp_path / "one.csv")
    (row,) = table(tmp_path / "one.csv")
    assert row["launch_deg"] == "11"
    assert float(row["predicted_launch_deg"]) != 11.0
    report = predict(tmp_path / "one.csv", club="driver", output=tmp_path / "two.csv")
    assert "predicted_predicted_launch_deg" in report.added


def test_the_hand_of_a_row_wins_over_that_of_the_club(write, tmp_path):
    path = write("speed_mph,toe_mm,hand\n100,8,right\n100,8,Left\n100,8,both\n")
    report = predict(path, club="driver", output=tmp_path / "out.csv")
    right, left = (float(row["sidespin_rpm"]) for row in table(tmp_path / "out.csv"))
    assert right == -left != 0.0
    assert report.first_rejects == ((4, "hand: 'both' is not right or left"),)
    predict(write("speed_mph,toe_mm\n100,8\n"), club="driver", hand="left", output=tmp_path / "out.csv")
    assert float(table(tmp_path / "out.csv")[0]["sidespin_rpm"]) == left


@pytest.mark.parametrize("delimiter", [";", ","])
def test_decimal_commas_are_read_and_written_and_quoted_among_commas(write, tmp_path, delimiter):
    text = 'id;club_speed [mph];toe [mm]\nx;"113,5";"1,5"\ny;1.000;2\nz;99;0\n'
    path = write(text.replace(";", delimiter))
    report = predict(path, club="driver", output=tmp_path / "out.csv")
    rows = table(tmp_path / "out.csv", delimiter)
    plain = clubface.impact("driver", speed="113.5 mph", toe="1.5 mm")
    assert "." not in "".join(rows[0].values())
    assert float(rows[0]["ball_speed_mps"].replace(",", ".")) == pytest.approx(plain.ball_speed, rel=5.1e-9)
    assert [row["id"] for row in rows] == ["x", "z"]
    ((line, reason),) = report.first_rejects  # a thousand miles an hour, since a comma marks the decimals
    assert (line, "447.04 must be at most" in reason) == (3, True)


BAD_FILES = [
    (b"", 1, "empty"),
    (b"\n\r\n\n", 1, "empty"),
    (b"a,b\n1,2\n", 1, "no column for the clubhead speed"),
    (b"113,-1.3\n110,2\n", 1, "there are: 113, -1.3"),
    (b"\n\nclub_speed_mph\n", 3, "no deliveries"),
    (b"club_speed_mm\n1\n", 1, "is 'mm'; it must be in m/s"),
    (b"club_speed [knots]\n1\n", 1, "is 'knots'; it must be in m/s"),
    (b"speed,club_speed_mph\n1,2\n", 1, "both give the speed"),
    (b"speed,x,x\n1,2,3\n", 1, "'x' is there twice"),
    (b"\xff\xfes\0p", None, "this UTF-16 text is damaged"),
    (b"PAR1", None, "end in .parquet"),
    (b"speed\r1\r2\r", 1, "carriage return"),
    (b'"speed\n1\n', 1, "does not end"),
    (b"speed\n" + b"1" * 2_000_001, 2, "longer than 2 MB"),
]


@pytest.mark.parametrize(("content", "line", "message"), BAD_FILES, ids=[each[2] for each in BAD_FILES])
def test_a_file_that_is_no_table_of_deliveries_is_refused_with_the_line(write, tmp_path, content, line, message):
    path = write(content)
    with pytest.raises(FileError, match=message.replace("(", r"\(")) as caught:
        predict(path, club="driver", output=tmp_path / "out.csv")
    assert (caught.value.path, caught.value.line) == (str(path), line)
    assert [each.name for each in tmp_path.iterdir()] == ["shots.csv"]


def test_paths_that_cannot_be_are_refused(write, tmp_path):
    path = write(GOOD)
    for output, words in ((path, "must not be the file that is read"), (tmp_path / "no" / "out.csv", "no folder"),
                         (tmp_path / "out.xlsx", "must end in"), (tmp_path / "dir.csv", "is a folder")):  # fmt: skip
        (tmp_path / "dir.csv").mkdir(exist_ok=True)
        with pytest.raises(FileError, match=words):
            predict(path, club="driver", output=output)
    with pytest.raises(FileError, match="a different file from the output"):
        predict(path, club="driver", output=tmp_path / "out.csv", rejects=tmp_path / "out.csv")
    with pytest.raises(FileError, match="No such file"):
        predict(tmp_path / "none.csv", club="driver")
    for chunk in (0, 1.5, True, 1_000_001):
        with pytest.raises(InputError, match="chunk_rows"):
            predict(path, club="driver", chunk_rows=chunk)
    with pytest.raises(InputError, match="temperature"):
        predict(path, club="driver", air={"temperature": 3.0})
    with pytest.raises(InputError, match="single number"):
        predict(path, club="driver", parameters={"friction": np.array([0.3, 0.35])})
    assert path.read_text() == GOOD


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes with a name")
def test_a_pipe_is_refused(tmp_path):
    path = tmp_path / "pipe"
    os.mkfifo(path)
    writer = os.open(path, os.O_RDWR)
    with pytest.raises(FileError, match="save it as a file"):
        predict(path, club="driver")
    os.close(writer)


def test_default_names_are_beside_the_input(write, tmp_path):
    report = predict(write(GOOD + "c,bad,1,2,3\n"), club="driver")
    assert report.output == str(tmp_path / "shots-launches.csv")
    assert report.rejects == str(tmp_path / "shots-launches.rejects.csv")
    assert predict(write(GOOD), club="driver").rejects is None
    assert not (tmp_path / "shots-launches.rejects.csv").exists()
