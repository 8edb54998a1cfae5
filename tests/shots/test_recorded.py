"""Recorded shots: one table of deliveries and launches, read, completed, selected and written."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st

import clubface
from attached_notes import noted
from clubface import shots as launch_monitor
from clubface.errors import ClubfaceError, FileError, InputError, UnknownNameError
from clubface.shots.reading import read_shots
from clubface.shots.recorded import RecordedShots, RejectedRow

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

MPH, DEG, RPM = 0.44704, math.pi / 180, math.pi / 30

TEXT = """\
Club,Handedness,club_speed_mph,Attack Angle [deg],impact_toe_mm,ball_speed_mph,launch_deg,spin_rpm,Spin Axis (deg),\
Carry (yd),note
Driver,right,100,-2,5,150,12,3000,30,250,first
7-iron,L,90,,-3,,18,,,,
,R,,,,,,,,,nothing at all
Driver,R,101,x,0,150,12,3000,30,250,no number
Driver,R,101,1,0,150,12,3000
Driver,,101,1,0,150,12,3000,30,250,no hand
"""


def shots(**changes):
    values = {
        "deliveries": {"speed": [50.0, 40.0]},
        "launches": {"backspin": [300.0, np.nan], "sidespin": [-40.0, np.nan]},
        "rows": [2, 3],
        "source": "made",
        "format": "clubface",
    }
    return RecordedShots(**(values | changes))


def test_every_value_comes_in_si_with_its_line_and_empty_cells_are_nan(write):
    result = read_shots(write(TEXT))
    assert result.rows.tolist() == [2, 3]
    assert result.clubs.tolist() == ["Driver", "7-iron"]
    assert result.hand.tolist() == ["right", "left"]
    expected = {
        "speed": [100 * MPH, 90 * MPH],
        "attack": [-2 * DEG, math.nan],
        "toe": [0.005, -0.003],
        "ball_speed": [150 * MPH, math.nan],
        "launch": [12 * DEG, 18 * DEG],
        "total_spin": [3000 * RPM, math.nan],
        "spin_axis": [math.pi / 6, math.nan],
        "backspin": [3000 * RPM * math.sqrt(3) / 2, math.nan],
        "sidespin": [1500 * RPM, math.nan],
        "carry": [250 * 0.9144, math.nan],
    }
    assert set(expected) == set(result.deliveries) | set(result.launches)
    for name, values in expected.items():
        # A unit conversion costs one rounding, the cosine and sine another: 4 ulp is 1e-15.
        np.testing.assert_allclose((result.deliveries | result.launches)[name], values, rtol=1e-15, err_msg=name)
    assert result.rejected == (
        RejectedRow(4, "nothing was measured: every cell of a delivery or launch is empty"),
        RejectedRow(5, "Attack Angle [deg]: 'x' is not a number"),
        RejectedRow(6, "8 cells where there are 11 columns"),
        RejectedRow(7, "Handedness: the cell is empty"),
    )
    assert (result.source.endswith("shots.csv"), result.format, len(result)) == (True, "clubface", 2)


def test_backspin_and_sidespin_give_total_and_axis_and_measured_values_stay():
    result = shots().launches
    np.testing.assert_allclose(result["total_spin"], [math.hypot(300, 40), np.nan], rtol=1e-15)
    np.testing.assert_allclose(result["spin_axis"], [-math.atan(40 / 300), np.nan], rtol=1e-15)
    given = {"backspin": [99.45, np.nan], "total_spin": [100.0, 100.0], "spin_axis": [0.1, -0.1]}
    result = shots(launches=given).launches
    np.testing.assert_allclose(result["backspin"], [99.45, 100 * math.cos(0.1)], rtol=1e-15)
    np.testing.assert_allclose(result["sidespin"], [100 * math.sin(0.1), -100 * math.sin(0.1)], rtol=1e-15)


def test_contradicting_spins_are_noted_once_with_line_and_values():
    given = {
        "backspin": [2650 * RPM, 2500 * RPM],
        "sidespin": [1703 * RPM, 0.0],
        "total_spin": [3000 * RPM, 2500 * RPM],
    }
    result = shots(launches=given)
    (data,) = noted(result, "spins-contradict")
    assert (data["at_line"], data["kept"]) == (2, ["backspin", "sidespin"])
    assert data["spins"] == {name: values[0] for name, values in given.items()}
    np.testing.assert_allclose(result.launches["total_spin"][0], math.hypot(2650, 1703) * RPM, rtol=1e-12)
    assert result.select([True, False]).notes == result.notes


def test_a_changed_spin_changes_those_that_follow_from_it():
    """Backspin was measured, total spin follows: a corrected backspin does not contradict the old total."""
    result = shots()
    launches = result.launches | {"backspin": 1.1 * result.launches["backspin"]}
    corrected = replace(result, launches=launches)
    assert corrected.notes == ()
    np.testing.assert_allclose(corrected.launches["total_spin"], [math.hypot(330, 40), np.nan], rtol=1e-12)
    assert set(corrected.derived) == {"backspin", "sidespin", "total_spin", "spin_axis"}
    assert np.isnan(corrected.derived["backspin"]).all()


def test_what_is_written_is_read_back(write, tmp_path):
    pytest.importorskip("pyarrow")
    result = read_shots(write(TEXT))
    for name in ("out.csv", "out.parquet", "out.tsv"):
        result.write(tmp_path / name)
        again = read_shots(tmp_path / name)
        assert again.clubs.tolist() == result.clubs.tolist()
        assert again.hand.tolist() == result.hand.tolist()
        for kind in ("deliveries", "launches"):
            first, second = getattr(result, kind), getattr(again, kind)
            assert list(first) == list(second)
            for quantity, values in first.items():
                # To the unit of the column and back: two roundings each way.
                np.testing.assert_allclose(second[quantity], values, rtol=1e-15, err_msg=quantity)
        assert again.notes == again.rejected == ()
    assert not list(tmp_path.glob("*.part*"))
    assert (tmp_path / "out.csv").read_text().startswith("club,hand,club_speed_mph,attack_deg,toe_mm,ball_speed_mph,")


def test_every_quantity_has_a_column_that_is_read_as_itself(tmp_path):
    from clubface.shots.tables.headings import LAUNCH_QUANTITIES
    from clubface.simulation.results import inputs

    deliveries = {name: [0.005 + place / 1000] for place, name in enumerate(inputs()) if name != "hand"}
    deliveries["speed"] = [0.3]  # no ball is much faster than its club
    launches = {name: [0.25 + place / 100] for place, name in enumerate(LAUNCH_QUANTITIES)}
    launches |= {"backspin": [300.0], "sidespin": [-40.0]}
    launches |= {"total_spin": [math.hypot(300, 40)], "spin_axis": [math.atan2(-40, 300)]}  # one vector
    shots(deliveries=deliveries, launches=launches, rows=[1]).write(tmp_path / "all.csv")
    result = read_shots(tmp_path / "all.csv")
    for name, values in (deliveries | launches).items():
        np.testing.assert_allclose((result.deliveries | result.launches)[name], values, rtol=1e-15, err_msg=name)
    assert result.notes == ()


def test_the_table_that_is_written_can_be_predicted(write, tmp_path):
    read_shots(write(TEXT)).select([0]).write(tmp_path / "out.csv")
    report = clubface.predict(tmp_path / "out.csv", club="driver", carry=False)
    assert (report.written, report.rejected) == (1, 0)
    assert report.used["toe_mm"] == ("toe", "mm")


def test_a_selection_keeps_the_shots_asked_for_and_delivers_them_with_their_hand(write):
    result = read_shots(write(TEXT))
    for which in ([False, True], [1], slice(1, None), 1, np.array([1])):
        picked = result.select(which)
        assert (len(picked), picked.rows[0], picked.hand[0], picked.clubs[0]) == (1, 3, "left", "7-iron")
        assert picked.launches["launch"].tolist() == [18 * DEG]
        assert picked.rejected == result.rejected
    assert result.delivery()["hand"].tolist() == [1.0, -1.0]
    launch = clubface.impact("driver", delivery=result.select([0]).delivery())
    assert launch.shape == (1,)
    with pytest.raises(InputError, match="2 shots"):
        result.select([2])
    with pytest.raises(InputError, match="2 shots"):
        result.select([True])


def test_a_data_frame_has_a_row_a_shot_and_says_its_units(write):
    pytest.importorskip("pandas")
    frame = read_shots(write(TEXT)).to_pandas()
    assert frame.columns[:4].tolist() == ["row", "club", "hand", "speed"]
    assert frame["row"].tolist() == [2, 3]
    assert frame.attrs["units"]["backspin"] == "rad/s"
    assert frame.attrs["units"]["toe"] == "m"
    assert frame.attrs["rejected"][0][0] == 4


def test_arrays_that_do_not_fit_are_refused_with_their_name():
    with pytest.raises(InputError, match=r"speed is .*\(3,\)"):
        shots(deliveries={"speed": [1.0, 2.0, 3.0]})
    with pytest.raises(UnknownNameError, match="did you mean backspin"):
        shots(launches={"back_spin": [1.0, 2.0]})
    with pytest.raises(UnknownNameError, match="ball_speed"):
        shots(deliveries={"ball_speed": [1.0, 2.0]})
    with pytest.raises(InputError, match="hand is 'Left'"):
        shots(hand=["right", "Left"])
    with pytest.raises(InputError, match="clubs"):
        shots(clubs=["driver"])


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "empty"),
        (b"speed_mph\n", "there are no shots"),
        (b"speed_mph\nx\ny\nz\nw\n", "line 2: speed_mph: 'x' is not a number; .*and 1 more"),
        (b"date,player\n1,2\n", "no column is of a delivery or a launch.*there are: date, player"),
        (b"hand\nright\n", "no column is of"),
        (b"ball_speed_rpm\n1\n", "is 'rpm'; it must be in m/s"),
        (b"launch_deg,launch_angle_deg\n1,2\n", "both give the launch"),
        (b"launch_deg,launch_deg\n1,2\n", "there twice"),
        (b"\xff\xfes\x00p", "this UTF-16 text is damaged"),
        (b'speed_mph\n"1', "does not end"),
    ],
)
def test_a_file_that_cannot_be_used_is_refused_with_the_reason(write, content, message):
    with pytest.raises(FileError, match=message):
        read_shots(write(content))


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    for path in (tmp_path / "missing.csv", tmp_path):
        with pytest.raises(FileError, match="cannot be read"):
            read_shots(path)
    with pytest.raises(FileError, match=r"\.csv or .*\.parquet"):
        shots().write(tmp_path / "shots.xlsx")
    with pytest.raises(FileError, match="cannot be written"):
        shots().write(tmp_path / "no folder" / "shots.csv")


cells = st.one_of(st.sampled_from(["113", "-1", "nan", "1e400", "", "1_0", "L", '"', "9,5"]), st.text(max_size=4))
texts = st.lists(st.lists(cells, max_size=4).map(",".join), max_size=5).map("\n".join)
heads = st.sampled_from(
    ["speed", "speed_mph,toe_mm", "ball_speed [m/s];club", "hand,launch_deg,club", "spin [rpm]", "a,b", ""]
)


@settings(max_examples=50)
@given(
    content=st.one_of(
        st.binary(max_size=60),
        st.tuples(heads, texts).map(lambda parts: "\n".join(parts).encode("utf-8", "surrogatepass")),
    )
)
@example(content=b"hand,launch_deg,club\n,1,\n")
def test_whatever_a_file_holds_only_an_error_of_the_package_comes_out(tmp_path, content):
    path = tmp_path / "fuzz.csv"
    path.write_bytes(content)
    try:
        result = read_shots(path)
    except ClubfaceError:
        return
    assert len(result) > 0
    assert not set(result.rows) & {each.line for each in result.rejected}


def test_given_units_apply_to_columns_without_a_unit(tmp_path):
    """By quantity or dimension; a heading with a unit keeps it, and a column without a unit is refused."""
    file = tmp_path / "shots.csv"
    file.write_text("speed,path,face_deg,ball_speed,toe\n100,2,3,160,10\n")
    units = {"speed": "mph", "angle": "deg", "ball_speed": "km/h"}
    with pytest.raises(FileError, match=r"the column 'toe' names no unit.*--unit length=mm"):
        launch_monitor.read(file, units=units)
    shots = launch_monitor.read(file, units=units | {"toe": "mm"})
    assert shots.deliveries["speed"][0] == pytest.approx(44.704)
    assert shots.deliveries["path"][0] == pytest.approx(2.0 * DEG)
    assert shots.deliveries["face"][0] == pytest.approx(3.0 * DEG)
    assert shots.launches["ball_speed"][0] == pytest.approx(160.0 / 3.6)
    assert shots.deliveries["toe"][0] == pytest.approx(0.01)
    with pytest.raises(InputError, match="the unit of speed is 'deg'"):
        launch_monitor.read(file, units={"speed": "deg"})
