"""The one way from a file to the shots of one club: chosen, checked, completed and referred."""

from __future__ import annotations

import numpy as np
import pytest

import clubface
from clubface import shots
from clubface.errors import InputError, UnitError, UnknownNameError
from clubface.shots.measured import measured_shots, ready_shots

DEG = np.pi / 180
SESSION = (
    "club,hand,face_at,speed_at,club_speed_mph,loft_deg,face_deg,toe_mm,high_mm,ball_speed_mph\n"
    "7i,right,contact,face,85,26,1,,2,118\n7 Iron,right,contact,face,80,25,0,4,0,105\n"
    "Dr,right,contact,face,100,12,2,15,,148\nDriver,right,contact,face,102,13,3,12,5,120\n"
)


@pytest.fixture
def session(write):
    return write(SESSION, "session.csv")


def test_shots_are_chosen_completed_and_then_referred(session):
    result = ready_shots(
        session, only="dr", where="ball_speed > 110 mph", assume={"high": "5 mm", "closure": "2400 deg/s"}
    )
    assert (result.club.name, result.rows.tolist(), result.places.tolist()) == ("driver", [4, 5], [2, 3])
    assert (result.face_at, result.speed_at) == ("face", "cg")
    # What is stated takes part in what follows from it: both face angles are referred from their points of impact.
    measured = shots.read(session).select([2, 3])
    measured.deliveries["high"][0] = 0.005
    measured.deliveries["closure"] = np.full(2, 2400 * DEG)
    for name, values in shots.refer(measured, "driver").deliveries.items():
        np.testing.assert_array_equal(result.deliveries[name], values, err_msg=name)
    assert abs(result.deliveries["face"][0] - 2 * DEG) > 1.5 * DEG
    for expected in (
        ("condition-fulfilled", {"fulfil": 3, "shots": 4, "condition": "ball_speed > 110 mph"}),
        ("value-stated", {"quantity": "high", "lacking": 1, "shots": 2, "stated": "5 mm"}),
        ("value-stated", {"quantity": "closure", "lacking": 2, "shots": 2, "stated": "2400 deg/s"}),
    ):
        assert expected in result.notes


def test_measured_values_are_not_replaced(session):
    result = ready_shots(session, only="7i", assume={"toe": "9 mm", "face": 0.5})
    np.testing.assert_allclose(result.deliveries["toe"], [0.009, 0.004], rtol=1e-14)
    assert ("value-stated-not-used", {"quantity": "face", "stated": "0.5 rad"}) in result.notes
    assert (np.abs(result.deliveries["face"]) < 2 * DEG).all()


def test_shots_that_are_ready_stay_as_they_are(session):
    result = ready_shots(session, only="7i", assume={"toe": "0 mm"})
    assert ready_shots(result) is result
    taken = measured_shots(result)
    assert taken.places.tolist() == [0, 1]
    assert len(taken.notes) == len(set(taken.notes))
    (one,) = result.select([1]).places
    assert one == 1


def test_every_row_of_the_wrong_club_is_refused_or_noted(session):
    with pytest.raises(InputError, match="several clubs"):
        ready_shots(session, club="driver")
    taken = ready_shots(session, club="driver", mismatch="note")
    assert len(taken) == 4
    assert ("club-may-be-other", {"names": ["7i", "7 Iron"], "club": "driver"}) in taken.notes
    with pytest.raises(InputError, match="the shots name 7i, 7 Iron, not driver"):
        ready_shots(session, club="driver", where="club == '7-iron'")


def test_an_unfulfillable_condition_and_invalid_values_are_refused(session):
    with pytest.raises(InputError, match=r"some of the 4 shots meet"):
        ready_shots(session, where="smash > 1.6")
    with pytest.raises(InputError, match="2 lack"):
        ready_shots(session, where="toe > 1 m or high > 1 m")
    with pytest.raises(UnknownNameError, match="toe"):
        ready_shots(session, only="7i", assume={"tow": "0 mm"})
    with pytest.raises(InputError, match=r"assume face is '13'"):
        ready_shots(session, only="7i", assume={"face": "13"})  # degrees were meant, and radians are taken
    with pytest.raises(UnitError, match="assume toe is '0 deg'"):
        ready_shots(session, only="7i", assume={"toe": "0 deg"})


def test_a_wedge_by_its_loft_fits_a_club_by_its_name(write):
    path = write("club,club_speed_mph,loft_deg\n46,70,35\n")
    assert len(ready_shots(path, club="pitching-wedge")) == 1
    with pytest.raises(InputError, match="the shots name 60, not pitching-wedge"):
        ready_shots(write("club,club_speed_mph\n60,70\n"), club=clubface.club("pitching-wedge"))
