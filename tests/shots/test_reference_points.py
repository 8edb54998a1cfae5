"""Club data referred from where a monitor takes it to the centre of gravity and the face centre."""

import math

import numpy as np
import pytest

import clubface
from attached_notes import noted
from clubface import shots as launch_monitor
from clubface.errors import FileError, UnknownNameError
from clubface.shots import refer
from clubface.shots.reading import read_shots
from clubface.shots.recorded import RecordedShots

pytestmark = [
    pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning"),
    pytest.mark.filterwarnings("ignore::clubface.errors.ImplausibleWarning"),
]

DEG = math.pi / 180
DRIVER = clubface.club("driver")


def shots(count=1, speed_at="cg", face_at="face", **deliveries):
    columns = {name: np.full(count, value) if np.ndim(value) == 0 else value for name, value in deliveries.items()}
    hand = columns.pop("hand", None)
    return RecordedShots(
        deliveries=columns,
        launches={},
        rows=np.arange(count),
        source="made",
        format="trackman",
        hand=hand,
        speed_at=speed_at,
        face_at=face_at,
    )


def test_on_a_wall_the_ball_leaves_along_the_normal_that_was_referred():
    """The core's own geometry: a head too heavy to recoil that moves along its normal at the point of contact sends the
    ball along it. So the normal measured there, referred to the face centre and delivered, must be that direction.
    """
    rng = np.random.default_rng(5)
    count = 200
    measured = {"loft": rng.uniform(5, 40, count) * DEG, "face": rng.uniform(-9, 9, count) * DEG}
    where = {"toe": rng.uniform(-0.04, 0.04, count), "high": rng.uniform(-0.02, 0.02, count)}
    where["lie"] = rng.uniform(-6, 6, count) * DEG
    hand = rng.choice(["right", "left"], count).astype(object)
    club = DRIVER.replace(bulge="280 mm", roll="350 mm")
    result = refer(shots(count, face_at="contact", speed=40.0, hand=hand, **measured, **where), club)
    wall = {"club_mass": 1e3, "ixx": 1e3, "iyy": 1e3, "izz": 1e3, "ixy": 0.0, "ixz": 0.0, "iyz": 0.0}
    delivery = result.delivery() | {"attack": measured["loft"], "path": measured["face"]}
    launch = clubface.impact(club, delivery=delivery, **wall)
    # The head weighs 20 000 balls: it gives way, and the ball leaves aside, by no more than 1e-4 of the direction.
    np.testing.assert_allclose(launch.launch, measured["loft"], atol=1e-4)
    np.testing.assert_allclose(launch.azimuth, measured["face"], atol=1e-4)
    # And where nothing is referred, bulge and roll show: by degrees.
    off = clubface.impact(club, delivery=delivery | measured, **wall)
    assert np.abs(off.azimuth - measured["face"]).max() > 5 * DEG


def test_bulge_and_roll_alone_turn_the_normal_by_the_arc_sine_of_offset_over_radius():
    club = DRIVER.replace(bulge="300 mm", roll="250 mm")
    result = refer(shots(face_at="contact", loft=0.0, face=5 * DEG, toe=0.015, high=0.0), club)
    np.testing.assert_allclose(result.deliveries["face"], 5 * DEG - math.asin(15 / 300), rtol=1e-13)
    result = refer(shots(face_at="contact", loft=15 * DEG, face=-5 * DEG, toe=0.0, high=-0.01), club)
    np.testing.assert_allclose(result.deliveries["loft"], 15 * DEG + math.asin(10 / 250), rtol=1e-13)
    np.testing.assert_allclose(result.deliveries["face"], -5 * DEG, rtol=1e-13)


def test_the_toe_of_a_left_hander_is_on_the_other_side():
    given = {"loft": 12 * DEG, "toe": 0.012, "high": 0.004, "lie": 2 * DEG}
    right = refer(shots(face_at="contact", face=3 * DEG, hand=["right"], **given), "driver")
    left = refer(shots(face_at="contact", face=-3 * DEG, hand=["left"], **given), "driver")
    np.testing.assert_allclose(left.deliveries["face"], -right.deliveries["face"], rtol=1e-14)
    np.testing.assert_allclose(left.deliveries["loft"], right.deliveries["loft"], rtol=1e-14)


def test_closure_carries_the_face_centre_to_the_left_of_the_centre_of_gravity():
    """omega x r for a square, level head: the face centre gains closure * cg_x to the left, closure * cg_z forward."""
    rate = 2500 * DEG
    club = DRIVER.replace(cg_x="40 mm", cg_y="10 mm", cg_z="2 mm")
    given = {"speed": 50.0, "attack": 0.0, "path": 0.0, "loft": club.loft, "face": 0.0, "closure": rate}
    result = refer(shots(speed_at="face", **given, hand=["right"]), club).deliveries
    forward, right = 50.0 - rate * 0.002, rate * 0.040
    np.testing.assert_allclose(result["speed"], math.hypot(forward, right), rtol=1e-14)
    np.testing.assert_allclose(result["path"], math.atan2(right, forward), rtol=1e-14)
    assert result["path"][0] / DEG == pytest.approx(2.0, abs=0.01)  # the two to three degrees TrackMan writes of
    mirrored = refer(shots(speed_at="face", **given, hand=["left"]), club).deliveries
    np.testing.assert_allclose(mirrored["path"], -result["path"], rtol=1e-14)


def test_the_arm_from_centre_of_gravity_to_face_turns_with_loft_and_face_angle():
    """Delofted by 9.8 deg the arm (40, 0) points down by as much; open by 90 deg it points right."""
    club = DRIVER.replace(cg_x="40 mm", cg_y="0 mm", cg_z="0 mm", loft="10 deg")
    rate = 30.0
    given = {"speed": 50.0, "path": 0.0, "closure": 0.0, "pitch_rate": rate, "lie": 0.0}
    result = refer(shots(speed_at="face", loft=-20 * DEG, face=0.0, **given), club).deliveries
    # r = 40 mm (cos 30, -sin 30, 0); omega = rate z; omega x r = rate * 40 mm (sin 30, cos 30, 0).
    x, y = 50.0 - rate * 0.04 * 0.5, -rate * 0.04 * math.cos(30 * DEG)
    np.testing.assert_allclose(result["speed"], math.hypot(x, y), rtol=1e-14)
    assert "attack" not in result
    given["closure"] = rate
    result = refer(shots(speed_at="face", loft=10 * DEG, face=90 * DEG, **given), club).deliveries
    # r = 40 mm z; omega x r = rate y x r = rate * 40 mm x, and the pitch rate about z does not move it.
    np.testing.assert_allclose(result["speed"], 50.0 - rate * 0.04, rtol=1e-14)


def test_the_lie_rate_moves_the_face_centre_up_and_towards_the_heel():
    """omega x r for the lie rate w alone: omega = (-w, 0, 0), r = (x, y, z) from the CG, so (0, w z, -w y)."""
    club = DRIVER.replace(cg_x="40 mm", cg_y="10 mm", cg_z="4 mm")
    rate = 20.0
    given = {"speed": 50.0, "attack": 0.0, "path": 0.0, "loft": club.loft, "face": 0.0, "closure": 0.0}
    result = refer(shots(speed_at="face", **given, lie_rate=rate, hand=["right"]), club).deliveries
    # The face centre lies towards the toe and above: it gains rate * 4 mm up and rate * 10 mm towards the heel.
    up, right = -rate * 0.004, rate * 0.010
    np.testing.assert_allclose(result["attack"], math.atan2(up, math.hypot(50.0, right)), rtol=1e-12)
    np.testing.assert_allclose(result["path"], math.atan2(right, 50.0), rtol=1e-12)


def test_a_lie_with_the_toe_up_turns_the_arm_from_the_centre_of_gravity_to_the_face():
    """With the toe straight up, what pointed to the toe points up, and what pointed up points to the heel."""
    club = DRIVER.replace(cg_x="40 mm", cg_y="10 mm", cg_z="4 mm", loft="0 deg")
    rate = 20.0
    given = {"speed": 50.0, "attack": 0.0, "path": 0.0, "loft": 0.0, "face": 0.0, "lie": 90 * DEG}
    result = refer(shots(speed_at="face", **given, closure=rate, hand=["right"]), club).deliveries
    # r = (40, 4, -10) mm; omega = (0, rate, 0); omega x r = rate (-10, 0, -40) mm.
    forward, right = 50.0 + rate * 0.010, rate * 0.040
    np.testing.assert_allclose(result["speed"], math.hypot(forward, right), rtol=1e-12)
    np.testing.assert_allclose(result["path"], math.atan2(right, forward), rtol=1e-12)
    result = refer(shots(speed_at="face", **given, closure=0.0, pitch_rate=rate, hand=["right"]), club).deliveries
    # omega = (0, 0, rate); omega x r = rate (-4, 40, 0) mm.
    np.testing.assert_allclose(result["attack"], math.atan2(-rate * 0.040, 50.0 + rate * 0.004), rtol=1e-12)


def test_shots_that_lack_what_is_needed_stay_as_measured_and_are_counted():
    given = {"speed": [50.0, 50.0], "path": [0.01, 0.02], "loft": [0.2, math.nan], "face": [0.0, 0.1]}
    measured = shots(
        2, speed_at="face", face_at="contact", **given, toe=[0.01, math.nan], high=[0.0, 0.01], closure=[math.nan, 40.0]
    )
    result = refer(measured, "driver")
    assert result.deliveries["path"][0] == 0.01
    assert result.deliveries["path"][1] != 0.02
    assert result.deliveries["face"][0] != 0.0
    assert result.deliveries["face"][1] == 0.1
    assert math.isnan(result.deliveries["loft"][1])
    for code in ("not-referred-contact-face", "not-referred-motion"):
        assert noted(result, code) == [{"lacking": 1, "shots": 2}]
    assert measured.deliveries["face"].tolist() == [0.0, 0.1]
    assert (result.speed_at, result.face_at) == ("unknown", "unknown")  # some are referred and some not
    again = refer(result, "driver")
    assert again.deliveries["path"].tolist() == result.deliveries["path"].tolist()
    without = shots(speed_at="face", face_at="contact", speed=50.0, path=0.01, face=0.1)
    assert (refer(without, "driver").speed_at, refer(without, "driver").face_at) == ("face", "contact")


def test_shots_are_referred_once_even_over_a_file(tmp_path):
    measured = shots(
        speed_at="face", face_at="contact", speed=50.0, path=0.0, face=0.0, toe=0.01, high=0.0, closure=40.0
    )
    measured.write(tmp_path / "measured.csv")
    result = read_shots(tmp_path / "measured.csv")
    assert (result.speed_at, result.face_at) == ("face", "contact")
    referred = refer(result, "driver")
    assert referred.deliveries["path"][0] > 0.02
    assert refer(referred, "driver").deliveries["path"] == referred.deliveries["path"]
    referred.write(tmp_path / "referred.csv")
    assert (read_shots(tmp_path / "referred.csv").speed_at, read_shots(tmp_path / "referred.csv").face_at) == (
        "cg",
        "face",
    )
    (tmp_path / "mixed.csv").write_text("speed [m/s],speed_at\n50,face\n51,cg\n")
    with pytest.raises(FileError, match="'speed_at' holds cg, face"):
        read_shots(tmp_path / "mixed.csv")


def test_each_club_name_of_a_file_may_have_its_own_club(write):
    text = "Club,Club Speed,Swing Direction,Dyn. Loft,Face Angle,Impact Offset,Impact Height\n"
    text += ",[mph],[deg],[deg],[deg],[mm],[mm]\n"
    path = write(text + "Driver,100,1,12,0,10,0\n7 Iron,80,1,24,0,10,0\n9 Iron,80,1,24,0,10,0\n")
    result = launch_monitor.read(path, club={"Driver": "driver", "7 Iron": "7-iron"}).deliveries["face"]
    assert result[0] == pytest.approx(-math.asin(10 / 305), rel=0.03)  # the loft adds 1/cos(12 deg)
    assert result[1:].tolist() == [pytest.approx(0.0, abs=1e-15), 0.0]  # an iron is flat; no club for the last
    with pytest.raises(UnknownNameError, match="did you mean 7 Iron"):
        launch_monitor.read(path, club={"7 iron": "7-iron"})
