"""Flight at the Python boundary: launches and launch monitors' numbers in, distances out."""

import math
import warnings

import numpy as np
import pytest

import clubface
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import AssumptionWarning, InputError, ShotError, UnitError, UnknownNameError
from clubface.simulation.launch import vectors

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

TOUR_DRIVE = {"ball_speed": "171 mph", "launch": "10.4 deg", "backspin": "2545 rpm"}


def drive(**values):
    return clubface.impact("driver", speed="113 mph", attack="-1.3 deg", loft="12.8 deg", **values)


def test_a_launch_flies_as_its_vectors_do():
    launch = drive(toe="9 mm", face="1 deg")
    by_hand = clubface.fly({name: launch.get(name) for name in launch.quantities() if name[-2:] in ("_x", "_y", "_z")
                            and not name.startswith("club")})  # fmt: skip
    assert clubface.fly(launch).carry == by_hand.carry
    assert clubface.fly(launch).side == by_hand.side


@pytest.mark.parametrize("azimuth", [-0.2, 0.0, 0.3])
def test_the_terms_of_a_launch_monitor_are_those_of_a_launch(azimuth):
    """Backspin is (w_z v_x - w_x v_z) / |v_level|, sidespin -w_y: the definitions of a launch, arithmetic to 1e-14."""
    result = vectors({"ball_speed": 70.0, "launch": 0.2, "azimuth": azimuth, "backspin": 300.0, "sidespin": 40.0})
    v = np.array([result[f"velocity_{axis}"] for axis in "xyz"])
    w = np.array([result[f"spin_{axis}"] for axis in "xyz"])
    level = math.hypot(v[0], v[2])
    assert np.linalg.norm(v) == pytest.approx(70.0, rel=1e-14)
    assert math.atan2(v[1], level) == pytest.approx(0.2, rel=1e-14)
    assert math.atan2(v[2], v[0]) == pytest.approx(azimuth, abs=1e-15)
    assert (w[2] * v[0] - w[0] * v[2]) / level == pytest.approx(300.0, rel=1e-14)
    assert -w[1] == 40.0
    tilted = vectors({"ball_speed": 70.0, "launch": 0.2, "azimuth": azimuth, "total_spin": 300.0, "spin_axis": 0.1})
    assert -tilted["spin_y"] == pytest.approx(300.0 * math.sin(0.1), rel=1e-14)


def test_any_spins_that_settle_the_others_fly_the_same_ball():
    """2650 rpm of backspin at 40 degrees are 3459.33 rpm in all, 2223.61 rpm of them to the right."""
    start = {"ball_speed": 64.0, "launch": 0.23}
    spins = {"backspin": "2650 rpm", "spin_axis": "40 deg", "total_spin": "3459.3294 rpm", "sidespin": "2223.6140 rpm"}
    carries = [
        clubface.fly(start | {name: spins[name] for name in pair}).carry
        for pair in (spins, ("backspin", "spin_axis"), ("total_spin", "spin_axis"), ("sidespin", "spin_axis"))
    ]
    assert carries == pytest.approx(carries[:1] * 4, rel=1e-6)


@pytest.mark.usefixtures("new_process")
def test_a_flight_says_which_spin_it_assumes():
    with pytest.warns(AssumptionWarning, match="sidespin"):
        clubface.fly(TOUR_DRIVE)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        clubface.fly({**TOUR_DRIVE, "sidespin": 0.0})


def test_spin_wind_and_air_take_the_ball_where_they_should():
    still = clubface.fly(TOUR_DRIVE)
    assert clubface.fly({**TOUR_DRIVE, "sidespin": "400 rpm"}).side > 5.0
    assert clubface.fly(TOUR_DRIVE, wind=(0, 0, "10 mph")).side > 5.0
    assert clubface.fly(TOUR_DRIVE, wind={"wind_z": "-10 mph"}).side < -5.0
    assert clubface.fly(TOUR_DRIVE, wind=("-10 mph", 0, 0)).carry < still.carry - 5.0
    assert clubface.fly(TOUR_DRIVE, air=clubface.Air(altitude="1600 m")).carry > still.carry + 5.0
    assert clubface.fly(TOUR_DRIVE, air={"temperature": "5 degC"}).carry < still.carry


def test_altitude_sets_the_pressure_of_the_standard_atmosphere():
    """ISO 2533: 89 874.6 Pa at 1000 m (its table is to 0.1 Pa)."""
    assert clubface.Air(altitude="1000 m").pressure == pytest.approx(89874.6, abs=1.0)
    high = clubface.Air(altitude=np.array([0.0, 1000.0]))
    assert high.pressure.shape == (2,)
    assert high.pressure[0] == 101325.0


def test_soft_ground_shortens_the_run():
    firm, soft = (clubface.fly(TOUR_DRIVE, ground={"rolling_friction": friction}) for friction in (0.06, 0.4))
    assert soft.carry == firm.carry
    assert soft.total < firm.total


def test_arrays_of_launch_and_air_broadcast():
    flights = clubface.fly(drive(toe=np.array([-0.01, 0.0, 0.01])), air={"temperature": [[280.0], [300.0]]})
    assert flights.shape == (2, 3)
    alone = clubface.fly(drive(toe=0.01), air={"temperature": 300.0})
    assert flights.carry[1, 2] == alone.carry
    pytest.importorskip("xarray")
    data = flights.to_xarray()
    assert data["carry"].dims == ("temperature", "toe")
    assert data.attrs["impact_model_name"] == DEFAULT_MODEL


def test_every_model_of_a_comparison_flies():
    flights = clubface.fly(drive(model=["standard", "area"]))
    assert list(flights) == ["standard", "area"]
    assert flights["area"].provenance["impact"]["model"]["name"] == "area"


def test_shots_without_a_launch_have_no_flight_and_keep_their_reason():
    launch = clubface.impact("driver", speed=[50.0, -1.0, 45.0], on_error="nan")
    flights = clubface.fly(launch)
    assert np.isfinite(flights.carry[[0, 2]]).all()
    assert np.isnan(flights.carry[1])
    assert [(each.row, each.parameter) for each in flights.problems] == [((1,), "speed")]
    with pytest.raises(ShotError, match="temperature"):
        clubface.fly(launch, air={"temperature": [300.0, 300.0, 10.0]})


def test_a_trajectory_ends_where_the_flight_lands():
    launch = drive(toe="5 mm")
    flight, path = clubface.fly(launch), clubface.trajectory(launch)
    assert math.hypot(path.position[-1, 0], path.position[-1, 2]) == pytest.approx(flight.carry, abs=1e-3)
    assert path.position[-1, 2] == pytest.approx(flight.side, abs=1e-3)
    assert path.time[-1] == pytest.approx(flight.flight_time, abs=1e-4)
    assert path.position[:, 1].max() == pytest.approx(flight.apex, abs=0.01)
    assert abs(path.position[-1, 1]) < 1e-6
    assert path.velocity[0] == pytest.approx([launch.velocity_x, launch.velocity_y, launch.velocity_z], rel=1e-15)
    pytest.importorskip("xarray")
    assert path.to_xarray()["position"].dims == ("time", "axis")
    assert list(path.to_pandas().columns[:2]) == ["time", "position_x"]


def test_a_topped_ball_still_flies_or_rolls():
    flight = clubface.fly({"ball_speed": 30.0, "launch": -0.1, "backspin": 0.0})
    assert flight.carry == pytest.approx(0.0, abs=1e-9)
    assert flight.total > 0.0


@pytest.mark.parametrize(
    ("launch", "options", "error", "message"),
    [
        (3.0, {}, InputError, "Launch or a mapping"),
        ({}, {}, InputError, "velocity_x"),
        ({"ball_speed": 70.0}, {}, InputError, "launch"),
        ({"ball_speed": "70 deg", "launch": 0.1}, {}, UnitError, "ball_speed"),
        ({"ball_sped": 70.0}, {}, UnknownNameError, "did you mean ball_speed"),
        ({"ball_speed": 70.0, "launch": 0.1, "velocity_x": 3.0}, {}, InputError, "velocity_x"),
        ({"ball_speed": 70.0, "launch": 0.1, "total_spin": 100.0, "backspin": 300.0}, {}, InputError, "total spin"),
        ({"ball_speed": 70.0, "launch": 0.1, "spin_axis": 1.0}, {}, InputError, "total_spin"),
        ({"ball_speed": math.nan, "launch": 0.1}, {}, InputError, "finite"),
        ({"ball_speed": 700.0, "launch": 0.1}, {}, ShotError, "velocity_x"),
        (TOUR_DRIVE, {"wind": 3.0}, InputError, "three values"),
        (TOUR_DRIVE, {"wind": {"wind_w": 3.0}}, UnknownNameError, "wind_x"),
        (TOUR_DRIVE, {"air": 3.0}, InputError, "Air"),
        (TOUR_DRIVE, {"air": {"temp": 3.0}}, UnknownNameError, "did you mean temperature"),
        (TOUR_DRIVE, {"air": {"temperature": "3 m"}}, UnitError, "temperature"),
        (TOUR_DRIVE, {"air": {"altitude": 0.0, "pressure": 1e5}}, InputError, "altitude"),
        (TOUR_DRIVE, {"air": {"humidity": "140 %"}}, ShotError, "humidity"),
        (TOUR_DRIVE, {"air": {"altitude": "20000 m"}}, InputError, "altitude is '20000 m'.*9100 m"),
        (TOUR_DRIVE, {"threads": 0}, InputError, "threads"),
        (TOUR_DRIVE, {"ground": {"grass": 1.0}}, UnknownNameError, "grass"),
        (TOUR_DRIVE, {"on_error": "skip"}, UnknownNameError, "on_error"),
        ({"ball_speed": [70.0, 71.0], "launch": [0.1, 0.2, 0.3]}, {}, InputError, "broadcast"),
    ],
)
def test_a_mistake_is_reported(launch, options, error, message):
    with pytest.raises(error, match=message):
        clubface.fly(launch, **options)


def test_a_trajectory_is_of_one_ball():
    with pytest.raises(InputError, match="one ball"):
        clubface.trajectory(drive(toe=[0.0, 0.01]))
