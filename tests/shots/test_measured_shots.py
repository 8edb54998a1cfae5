"""Recorded shots made ready for comparison: what is taken, what is dropped, and the notes on it."""

import numpy as np
import pytest

import clubface
from attached_notes import codes
from clubface import shots as launch_monitor
from clubface.errors import InputError
from clubface.shots.measured import measured_shots
from clubface.shots.recorded import RecordedShots

NAN = float("nan")


def recorded(n=4, clubs=None, **changes):
    deliveries = {"speed": np.full(n, 50.0), "loft": np.full(n, 0.25), "toe": np.zeros(n)}
    launches = {"ball_speed": np.full(n, 70.0), "launch": np.full(n, 0.2), "backspin": np.full(n, 300.0)}
    for name, values in changes.items():
        target = deliveries if name in ("speed", "loft", "toe", "attack") else launches
        if values is None:
            target.pop(name)
        else:
            target[name] = np.asarray(values, dtype=float)
    return RecordedShots(
        deliveries=deliveries,
        launches=launches,
        clubs=None if clubs is None else np.array(clubs, dtype=object),
        rows=np.arange(2, n + 2),
        source="range.csv",
        format="clubface",
    )


def test_complete_shots_of_a_named_club_are_taken_as_they_are():
    shots = measured_shots(recorded(clubs=["7 Iron"] * 4, loft=[0.4] * 4), quantities=("launch", "backspin"))
    assert shots.club.name == "7-iron"
    assert list(shots.launch) == ["launch", "backspin"]
    assert (len(shots), shots.dropped) == (4, ())
    assert list(shots.rows) == [2, 3, 4, 5]


def test_a_shot_without_a_delivery_value_or_without_any_launch_is_dropped_with_its_row_and_reason():
    shots = measured_shots(
        recorded(
            speed=[50, NAN, 50, 50],
            ball_speed=[70, 70, NAN, NAN],
            launch=[0.2, 0.2, 0.2, NAN],
            backspin=[300, 300, 300, NAN],
        ),
        club="driver",
    )
    assert list(shots.rows) == [2, 4]
    assert shots.dropped == ((3, "speed was not measured"), (5, "no launch quantity was measured"))
    assert np.isnan(shots.launch["ball_speed"][1])


def test_values_taken_as_zero_or_static_are_noted():
    zero = ["attack", "path", "face", "lie", "high", "closure", "pitch_rate", "lie_rate"]
    assert measured_shots(recorded(), club="driver").notes == (("taken-as-zero", {"quantities": zero}),)
    notes = measured_shots(recorded(loft=None), club="driver").notes
    driver = clubface.club("driver")
    assert notes[-1] == ("static-loft-stands-in", {"club": "driver", "static_loft": driver.loft})
    # A column without a single value is no column.
    assert measured_shots(recorded(loft=[NAN] * 4), club="driver").notes == notes


def test_the_wrong_club_is_refused_or_noted():
    # 0.25 rad are 14.3 degrees; the 7-iron has 30.5.
    with pytest.raises(InputError, match=r"club is '7-iron'.*median dynamic loft is 14.3 deg.*--mismatch note"):
        measured_shots(recorded(), club="7-iron")
    notes = measured_shots(recorded(), club="7-iron", mismatch="note").notes
    (other,) = (each.data for each in notes if each.code == "median-loft-of-other-club")
    assert (other["club"], other["delivered_loft"]) == ("7-iron", pytest.approx(0.25))
    assert "median-loft-of-other-club" not in codes(measured_shots(recorded(), club="driver"))
    with pytest.raises(InputError, match="the shots name 7i, not driver"):
        measured_shots(recorded(clubs=["7i"] * 4), club="driver")
    # Chosen by its name, it is meant; so is one whose name says nothing of its kind.
    assert len(measured_shots(recorded(clubs=["7i"] * 4), club="driver", only="7i")) > 0
    assert len(measured_shots(recorded(clubs=["G425"] * 4), club="driver")) > 0


def test_shots_of_several_clubs_are_not_mixed():
    several = recorded(clubs=["Driver", "Driver", "7i", "7i"], loft=[0.25, 0.25, 0.4, 0.4])
    with pytest.raises(InputError, match=r"several clubs that were hit: Driver \(2\), 7i \(2\)"):
        measured_shots(several, club="driver")
    assert len(measured_shots(several, club="7-iron", only="7I")) == 2
    with pytest.raises(InputError, match=r"one of the clubs that were hit: Driver \(2\)"):
        measured_shots(several, club="driver", only="putter")
    with pytest.raises(InputError, match="name no club"):
        measured_shots(recorded(), club="driver", only="7i")


def test_a_club_that_is_not_built_in_must_be_given():
    with pytest.raises(InputError, match="the shots name 'My Gamer'"):
        measured_shots(recorded(clubs=["My Gamer"] * 4))
    assert measured_shots(recorded(clubs=["7i", "7 Iron"] * 2, loft=[0.4] * 4)).club.name == "7-iron"
    with pytest.raises(InputError, match="the shots name none"):
        measured_shots(recorded())
    own = clubface.club("driver").replace(name="mine")
    assert measured_shots(recorded(clubs=["7i"] * 4), club=own).club is own


def test_shots_that_cannot_be_compared_are_refused_with_the_reason():
    with pytest.raises(InputError, match="speed of the clubhead; measured of the deliveries: loft, toe"):
        measured_shots(recorded(speed=None), club="driver")
    with pytest.raises(InputError, match="measured in at least one"):
        measured_shots(recorded(speed=[NAN] * 4), club="driver")
    with pytest.raises(InputError, match="with a measured launch: sidespin"):
        measured_shots(recorded(), club="driver", quantities=("sidespin",))
    with pytest.raises(InputError, match="2: no launch quantity"):
        measured_shots(recorded(launch=[NAN] * 4), club="driver", quantities=("launch",))


def test_club_data_of_a_monitor_is_referred_however_the_shots_are_given(tmp_path):
    """By name of a file, as read with or without its club, and from a table of clubface written of them."""
    path = tmp_path / "track.csv"
    head = "Club,Club Speed,Swing Direction,Dyn. Loft,Face Angle,Impact Offset,Impact Height,Ball Speed\n"
    units = ",[mph],[deg],[deg],[deg],[mm],[mm],[mph]\n"
    path.write_text(head + units + "Driver,100,1,12,0,10,0,145\n7 Iron,80,1,29,0,10,0,110\n")
    read = launch_monitor.read(path)
    read.write(tmp_path / "own.csv")
    both = [path, read, launch_monitor.read(path, club="driver"), tmp_path / "own.csv"]
    both.append(launch_monitor.read(tmp_path / "own.csv", club={"Driver": "driver"}))
    for shots in both:
        result = measured_shots(shots, club="driver", only="Driver")
        # A driver's bulge of 305 mm turns the normal by 1.9 degrees over 10 mm, towards the toe.
        assert result.delivery["face"] == pytest.approx(-np.arcsin(10 / 305), rel=0.03)
        assert len(set(result.notes)) == len(result.notes)
    # An iron is flat.
    assert measured_shots(path, club="7-iron", only="7 Iron").delivery["face"] == pytest.approx(0.0, abs=1e-12)
