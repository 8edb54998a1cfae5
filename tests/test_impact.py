"""From delivery to launch at the Python boundary: units, shapes, defaults, refusals, tables, histories."""

import math
import os
import subprocess
import sys
import threading

import numpy as np
import pytest

import clubface
from clubface import memory
from clubface.errors import ClubfaceError, InputError, ShotError, UnitError, UnknownNameError
from clubface.models import models
from clubface.parameters import ParameterSet
from clubface.quantities import inputs

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

DRIVE = {"speed": "113 mph", "attack": "-1.3 deg", "loft": "12.8 deg"}
CONTACT = ("volumetric", "rings", "area")


def same(one, other):
    """Equal to the last bit, NaN beside NaN."""
    return np.array_equal(one._values, other._values, equal_nan=True)


def test_a_central_blow_obeys_the_closed_form_of_penner():
    """CG behind the face centre, square face: v = (1 + e) V / (1 + m/M), no spin. Arithmetic alone: 1e-13."""
    shot = clubface.impact(
        "driver", speed=50.0, loft=0.0, static_loft=0.0, cg_y=0.0, cg_z=0.0, ixy=0.0, ixz=0.0, iyz=0.0,
        parameters={"cor": 0.78, "cor_slope": 0.0},
    )  # fmt: skip
    club, ball = clubface.club("driver"), clubface.ball("published")
    assert shot.ball_speed == pytest.approx(1.78 * 50.0 / (1.0 + ball.mass / club.mass), rel=1e-13)
    assert abs(shot.total_spin) < 1e-12


def test_text_with_a_unit_and_the_si_number_give_the_same_bits():
    text = clubface.impact("driver", **DRIVE, toe="8 mm", closure="2400 deg/s")
    number = clubface.impact(
        "driver", speed=113 * 0.44704, attack=math.radians(-1.3), loft=math.radians(12.8), toe=0.008,
        closure=math.radians(2400.0),
    )  # fmt: skip
    assert np.allclose(text._values, number._values, rtol=1e-14, atol=0.0, equal_nan=True)


def test_a_delivery_a_mapping_and_single_values_are_one():
    by_name = clubface.impact("driver", **DRIVE)
    assert same(by_name, clubface.impact("driver", DRIVE))
    assert same(by_name, clubface.impact("driver", clubface.Delivery(**DRIVE)))
    assert same(by_name, clubface.impact("driver", clubface.Delivery(**DRIVE).replace(toe="5 mm"), toe=0.0))


def test_the_loft_left_out_is_that_of_the_club():
    club = clubface.club("7-iron")
    assert same(clubface.impact(club, speed=40.0), clubface.impact(club, speed=40.0, loft=club.loft))
    stronger = clubface.impact(club, speed=40.0, static_loft="28 deg")
    assert stronger.delivery["loft"] == pytest.approx(math.radians(28.0))


def test_outputs_convert_and_carry_their_units():
    shot = clubface.impact("driver", **DRIVE)
    assert shot.get("backspin", "rpm") == pytest.approx(shot.backspin * 30.0 / math.pi, rel=1e-14)
    assert shot.units["peak_force"] == "N"
    assert isinstance(shot.ball_speed, np.floating)
    assert "rpm" in repr(shot)
    with pytest.raises(UnitError, match="backspin"):
        shot.get("backspin", "mm")
    with pytest.raises(UnknownNameError, match="backspin"):
        shot.get("backspn")
    with pytest.raises(AttributeError, match="nonsense"):
        _ = shot.nonsense


@pytest.mark.parametrize("model", models())
def test_a_batch_is_its_shots_one_by_one_to_the_last_bit(model):
    toe = np.linspace(-0.02, 0.02, 5)[:, None]
    speed = np.array([35.0, 51.0, 42.0])
    batch = clubface.impact("driver", speed=speed, toe=toe, model=model, high="2 mm")
    assert batch.ball_speed.shape == batch.shape == (5, 3)
    for i in range(5):
        for j in range(3):
            single = clubface.impact("driver", speed=speed[j], toe=toe[i, 0], model=model, high="2 mm")
            for name, values in zip(single.quantities(), single._values[:, 0], strict=True):
                assert np.array_equal(batch.get(name)[i, j], values, equal_nan=True), name


def test_threads_change_no_bit():
    speed = np.linspace(30.0, 55.0, 5000)
    one, two = (clubface.impact("driver", speed=speed, model="volumetric", threads=n) for n in (1, 2))
    assert same(one, two)


def test_club_ball_and_parameter_values_may_be_arrays():
    shots = clubface.impact(
        "driver", speed=50.0, club_mass=["190 g", "204 g"], ball_mass=np.array([[0.045], [0.046]]),
        parameters={"cor": np.array([0.80, 0.82])},
    )  # fmt: skip
    assert shots.shape == (2, 2)
    alone = clubface.impact("driver", speed=50.0, ball_mass=0.046, parameters={"cor": 0.82})
    assert shots.ball_speed[1, 1] == alone.ball_speed
    assert set(shots.varied) == {"club_mass", "ball_mass", "cor"}


@pytest.mark.parametrize("shape", [(0,), (1,), (1, 1), (3, 0)])
def test_shapes_that_hold_little_stay_what_they_are(shape):
    shots = clubface.impact("driver", speed=np.full(shape, 50.0))
    assert shots.ball_speed.shape == shape
    assert "launch" in repr(shots)
    assert len(shots.to_pandas()) == math.prod(shape)


def test_a_flat_face_is_an_infinite_radius():
    """A radius of 1e9 m tilts the face by 1e-11 rad at 10 mm, and the launch by as little."""
    flat = clubface.impact("driver", speed=50.0, bulge="flat", roll=math.inf, toe="10 mm")
    nearly = clubface.impact("driver", speed=50.0, bulge=1e9, roll=1e9, toe="10 mm")
    assert flat.azimuth == pytest.approx(nearly.azimuth, abs=1e-10)
    assert abs(flat.azimuth - clubface.impact("driver", speed=50.0, toe="10 mm").azimuth) > 0.01


def test_the_hand_is_right_left_or_a_sign():
    left = clubface.impact("driver", **DRIVE, toe="8 mm", hand="left")
    assert left.sidespin == -clubface.impact("driver", **DRIVE, toe="8 mm").sidespin
    assert same(left, clubface.impact("driver", **DRIVE, toe="8 mm", hand=-1))
    both = clubface.impact("driver", **DRIVE, toe="8 mm", hand=[1, -1])
    assert both.sidespin[1] == left.sidespin


BAD = [
    ({}, "speed", "given"),
    ({"speed": math.nan}, "speed", "finite"),
    ({"speed": math.inf}, "speed", "finite"),
    ({"speed": "fast"}, "speed", "finite number"),
    ({"speed": None}, "speed", "given"),
    ({"speed": True}, "speed", "finite number"),
    ({"speed": "50 deg"}, "speed", "not an angle"),
    ({"speed": -1.0}, "speed", "above 0"),
    ({"speed": 50.0, "loft": "95 deg"}, "loft", "80 deg"),
    ({"speed": 50.0, "toe": "60 mm"}, "toe", "52.5 mm"),
    ({"speed": 50.0, "high": "-40 mm"}, "high", "27.5 mm"),
    ({"speed": 50.0, "path": "100 deg"}, "path", "90 deg"),
    ({"speed": 50.0, "path": "85 deg", "face": "-20 deg"}, "speed", "moves away"),
    ({"speed": 50.0, "club_mass": 0.0}, "club_mass", "above 0"),
    ({"speed": 50.0, "ixx": -1e-4}, "ixx", "positive definite"),
    ({"speed": 50.0, "ball_inertia": 1.0}, "ball_inertia", "2/3"),
    ({"speed": 50.0, "hand": 2}, "hand", "left-handed"),
    ({"speed": 50.0, "hand": "both"}, "hand", "right, left"),
    ({"speed": 50.0, "tow": 0.0}, "input", "did you mean toe"),
    ({"speed": 50.0, "model": "volumetrik"}, "model", "did you mean volumetric"),
    ({"speed": 50.0, "ball": "publishd"}, "ball", "did you mean published"),
    ({"speed": 50.0, "parameters": {"cor": 1.5}}, "cor", "to 1"),
    ({"speed": 50.0, "parameters": {"color": 1.5}}, "parameter of standard", "did you mean cor"),
    ({"speed": 50.0, "parameters": 3}, "parameters", "mapping"),
    ({"speed": 50.0, "model": "area", "accuracy": 3.0}, "accuracy", "1e-2"),
    ({"speed": [50.0, 51.0], "toe": [0.0, 0.0, 0.0]}, "the shapes of the inputs", "broadcast"),
    ({"speed": [50.0, -1.0], "on_error": "ignore"}, "on_error", "raise, nan"),
]


@pytest.mark.parametrize(("values", "parameter", "said"), BAD, ids=[str(each[0]) for each in BAD])
def test_a_mistake_names_parameter_value_and_what_is_allowed(values, parameter, said):
    with pytest.raises(InputError) as caught:
        clubface.impact("driver", **values)
    assert caught.value.parameter == parameter
    assert said in str(caught.value)


def test_an_unknown_club_names_the_nearest():
    with pytest.raises(UnknownNameError, match="did you mean driver"):
        clubface.impact("drivr", speed=50.0)
    with pytest.raises(ClubfaceError):
        clubface.impact(["driver"], speed=50.0)


def test_the_first_bad_shot_of_a_batch_is_named_with_its_place():
    speed = np.full((3, 4), 50.0)
    speed[1, 2] = speed[2, 0] = -4.0
    with pytest.raises(ShotError) as caught:
        clubface.impact("driver", speed=speed)
    assert (caught.value.row, caught.value.value, caught.value.others) == ((1, 2), -4.0, 1)
    assert "shot 1, 2: speed" in str(caught.value)


def test_bad_shots_may_stay_nan_and_leave_the_others_alone():
    speed = np.array([50.0, math.nan, 51.0, -1.0])
    shots = clubface.impact("driver", speed=speed, on_error="nan", model="volumetric")
    assert [each.row for each in shots.problems] == [(1,), (3,)]
    assert np.isnan(shots.ball_speed[[1, 3]]).all()
    good = clubface.impact("driver", speed=speed[[0, 2]], model="volumetric")
    assert np.array_equal(shots.ball_speed[[0, 2]], good.ball_speed)


def test_a_request_larger_than_memory_is_refused_before_anything_is_allocated():
    """A million by a million shots are 176 TB; the views that ask for them hold 16 MB."""
    column, row = np.full((1_000_000, 1), 50.0), np.zeros((1, 1_000_000))
    with pytest.raises(InputError, match=r"at most \d+ with the memory free here .*predict"):
        clubface.impact("driver", speed=column, toe=row)


def test_what_fits_is_computed_and_what_does_not_is_told(monkeypatch):
    """Free memory set to 200 MB, of which half may be used: 22 outputs of 8 bytes make 568181 shots."""
    monkeypatch.setattr(memory, "available_memory", lambda: 200_000_000)
    with pytest.raises(InputError, match="at most 568181"):
        clubface.impact("driver", speed=np.full(600_000, 50.0))
    assert clubface.impact("driver", speed=np.full(500_000, 50.0)).shape == (500_000,)
    assert memory.available_memory() > 0


def test_free_memory_is_known_here():
    assert 2**20 < memory.available_memory() < 2**50


def test_progress_rises_to_the_number_of_shots():
    seen = []
    clubface.impact("driver", speed=np.full(20_000, 50.0), model="volumetric", progress=seen.append)
    assert seen == sorted(set(seen))
    assert seen[-1] == 20_000


@pytest.mark.skipif(os.name == "nt", reason="no such signal")
def test_ctrl_c_stops_a_long_batch_on_the_way():
    """Three million ring shots take minutes; the interrupt comes after a fifth of a second."""
    import signal

    seen = []
    timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        clubface.impact("driver", speed=np.full(3_000_000, 50.0), model="rings", progress=seen.append)
    timer.join()
    assert max(seen, default=0) < 1_000_000


def test_several_models_give_a_launch_each():
    everything = clubface.impact("driver", **DRIVE, model="all")
    assert list(everything) == list(models())
    some = clubface.impact("driver", **DRIVE, model=["standard", "area"], parameters={"area": {"area_damping": 500.0}})
    assert list(some) == ["standard", "area"]
    assert some["standard"].backspin == everything["standard"].backspin
    assert some["area"].backspin != everything["area"].backspin
    table = some.to_pandas()
    assert list(table["model"]) == ["standard", "area"]
    assert table.attrs["units"]["backspin"] == "rad/s"
    with pytest.raises(UnknownNameError, match="volumetric"):
        clubface.impact("driver", **DRIVE, model=["standard"], parameters={"volumetric": None})
    with pytest.raises(InputError, match="at least one"):
        clubface.impact("driver", **DRIVE, model=[])


def test_parameters_are_those_of_the_family_of_the_club_unless_given(tmp_path):
    iron = clubface.impact("9-iron", speed=40.0, model="volumetric")
    assert iron.parameters.club == "7-iron"
    own = ParameterSet.builtin("volumetric", "driver").replace(friction=0.2)
    assert clubface.impact("driver", **DRIVE, model="volumetric", parameters=own).parameters is own
    file = tmp_path / "own.toml"
    file.write_text(own.to_toml())
    by_file = clubface.impact("driver", **DRIVE, model="volumetric", parameters=file)
    assert same(by_file, clubface.impact("driver", **DRIVE, model="volumetric", parameters={"friction": 0.2}))
    named = clubface.impact("driver", **DRIVE, model="volumetric", parameters="three-dimensional-impact-models")
    assert same(named, clubface.impact("driver", **DRIVE, model="volumetric"))
    with pytest.raises(InputError, match="a set of standard"):
        clubface.impact("driver", **DRIVE, parameters=own)


def test_a_club_file_is_read_anew_at_every_call(tmp_path):
    file = tmp_path / "own.toml"
    club = clubface.club("driver")
    file.write_text(club.to_toml())
    first = clubface.impact(file, **DRIVE)
    file.write_text(club.replace(mass="150 g").to_toml())
    assert clubface.impact(file, **DRIVE).ball_speed < first.ball_speed


def test_provenance_says_what_a_launch_was_computed_from():
    shots = clubface.impact("driver", speed=[50.0, 51.0], model="volumetric", club_mass="200 g")
    told = shots.provenance
    assert told["clubface_version"] == clubface.__version__
    assert told["model"]["name"] == "volumetric"
    assert told["parameters"]["values"]["friction"] == 0.372
    used = shots.parameters
    of_values = [f"{name}: {text}" for name, text in used.value_caveats.items()]
    assert used.caveats
    assert told["parameters"]["caveats"] == [*used.caveats, *of_values]
    assert told["changed"]["values"] == {"club_mass": 0.2}
    assert "array of shape (2,)" in told["delivery"]["values"]["speed"]


def test_tables_hold_inputs_units_and_provenance():
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    toe, high = np.linspace(-0.02, 0.02, 4)[:, None], np.linspace(-0.01, 0.01, 3)
    shots = clubface.impact("driver", **DRIVE, toe=toe, high=high)
    table = shots.to_pandas()
    assert isinstance(table, pandas.DataFrame)
    assert list(table.columns[:2]) == ["toe", "high"]
    assert table["backspin"].to_numpy() == pytest.approx(shots.backspin.ravel(), rel=0, abs=0)
    assert table.attrs["units"]["toe"] == "m"
    data = shots.to_xarray()
    assert isinstance(data, xarray.Dataset)
    assert data["backspin"].dims == ("toe", "high")
    assert float(data["backspin"].sel(toe=toe[1, 0], high=high[2])) == shots.backspin[1, 2]
    assert data["backspin"].attrs["units"] == "rad/s"
    assert data["toe"].attrs["units"] == "m"
    assert all(isinstance(value, str) for value in data.attrs.values())
    assert "volumetric" not in data.attrs["model_name"] == "standard"
    assert shots.to_xarray(dims=("a", "b"))["launch"].dims == ("a", "b")
    zipped = clubface.impact("driver", speed=[50.0, 51.0], toe=[0.0, 0.01]).to_xarray()
    assert zipped["speed"].dims == zipped["toe"].dims == ("shot",)
    assert clubface.impact("driver", **DRIVE).to_xarray()["ball_speed"].dims == ()


def test_a_single_shot_loads_no_table_library():
    code = (
        "import sys, clubface; clubface.impact('driver', speed=50.0); "
        "print(sorted({'pandas', 'xarray', 'pyarrow', 'matplotlib'} & set(sys.modules)))"
    )
    found = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == "[]"


@pytest.mark.parametrize("model", CONTACT)
def test_a_history_runs_from_first_touch_to_the_launch(model):
    contact = clubface.history("driver", **DRIVE, toe="8 mm", model=model)
    shot = clubface.impact("driver", **DRIVE, toe="8 mm", model=model)
    assert contact.time[0] == 0.0
    assert np.all(np.diff(contact.time) > 0.0)
    assert contact.normal_force.min() >= 0.0
    # The peak lies between two steps; the steps of the fast setting are about a twentieth of the contact.
    assert contact.normal_force.max() == pytest.approx(shot.peak_force, rel=0.02)
    for axis, name in enumerate("xyz"):
        assert contact.ball_velocity[-1, axis] == pytest.approx(shot.get(f"velocity_{name}"), abs=1e-9)
        assert contact.ball_spin[-1, axis] == pytest.approx(shot.get(f"spin_{name}"), abs=1e-7)
    assert contact.launch.ball_speed == pytest.approx(shot.ball_speed, rel=1e-12)
    assert contact.get("time", "us")[-1] == pytest.approx(contact.time[-1] * 1e6)


def test_histories_make_tables():
    pytest.importorskip("xarray")
    rings = clubface.history("driver", **DRIVE, model="rings")
    data = rings.to_xarray()
    assert data["ring_slip"].dims == ("time", "ring")
    assert data["ball_spin"].dims == ("time", "axis")
    assert data["club_attitude"].sizes["component"] == 4
    assert data["normal_force"].attrs["units"] == "N"
    table = clubface.history("driver", **DRIVE, model="area").to_pandas()
    assert {"time", "normal_force", "ball_spin_z", "club_attitude_w"} <= set(table.columns)
    assert "ring_slip" not in dir(clubface.history("driver", **DRIVE, model="area"))


def test_only_single_shots_by_contact_models_have_a_history():
    with pytest.raises(InputError, match="volumetric, rings, area"):
        clubface.history("driver", **DRIVE, model="standard")
    with pytest.raises(InputError, match="one shot"):
        clubface.history("driver", speed=[50.0, 51.0])
    with pytest.raises(ShotError, match=r"52\.5 mm"):
        clubface.history("driver", speed=50.0, toe=0.06)


def test_a_delivery_names_every_input_of_its_group():
    own = [name for name, each in inputs().items() if each.group == "delivery"]
    assert own == list(clubface.Delivery.__dataclass_fields__)
    with pytest.raises(UnknownNameError, match="toe"):
        clubface.Delivery(speed=50.0).replace(tow=1.0)
