"""From delivery to launch at the Python boundary: units, shapes, defaults, refusals, tables, histories."""

import inspect
import math
import os
import threading

import numpy as np
import pytest

import clubface
from clubface.equipment.models import DEFAULT_MODEL, models
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError, UnitError, UnknownNameError
from clubface.simulation.results import inputs

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

DRIVE = {"speed": "113 mph", "attack": "-1.3 deg", "loft": "12.8 deg"}


def same(one, other):
    """Equal to the last bit, NaN beside NaN."""
    return np.array_equal(one._values, other._values, equal_nan=True)


def test_a_central_impact_obeys_the_closed_form_of_penner():
    """CG behind the face centre, square face: v = (1 + e) V / (1 + m/M), no spin. Arithmetic alone: 1e-13."""
    shot = clubface.impact(
        "driver", speed=50.0, loft=0.0, static_loft=0.0, cg_y=0.0, cg_z=0.0, ixy=0.0, ixz=0.0, iyz=0.0,
        parameters={"cor": 0.78, "cor_slope": 0.0}, model="standard",
    )  # fmt: skip
    club, ball = clubface.club("driver"), clubface.ball()
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
        parameters={"friction": np.array([0.30, 0.35])},
    )  # fmt: skip
    assert shots.shape == (2, 2)
    alone = clubface.impact("driver", speed=50.0, ball_mass=0.046, parameters={"friction": 0.35})
    assert shots.ball_speed[1, 1] == alone.ball_speed
    assert set(shots.varied) == {"club_mass", "ball_mass", "friction"}


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


def test_parameters_are_those_of_the_family_of_the_club_unless_given(write):
    iron = clubface.impact("9-iron", speed=40.0, model="volumetric")
    assert iron.parameters.club == "7-iron"
    own = ParameterSet.builtin("volumetric", "driver").replace(friction=0.2)
    assert clubface.impact("driver", **DRIVE, model="volumetric", parameters=own).parameters is own
    file = write(own.to_toml(), "own.toml")
    by_file = clubface.impact("driver", **DRIVE, model="volumetric", parameters=file)
    assert same(by_file, clubface.impact("driver", **DRIVE, model="volumetric", parameters={"friction": 0.2}))
    named = clubface.impact("driver", **DRIVE, model="volumetric", parameters="three-dimensional-impact-models")
    assert same(named, clubface.impact("driver", **DRIVE, model="volumetric"))
    with pytest.raises(InputError, match=f"a set of {DEFAULT_MODEL}"):
        clubface.impact("driver", **DRIVE, parameters=own)


def test_a_club_file_is_read_anew_at_every_call(tmp_path):
    file = tmp_path / "own.toml"
    club = clubface.club("driver")
    file.write_text(club.to_toml())
    first = clubface.impact(file, **DRIVE)
    file.write_text(club.replace(mass="180 g").to_toml())
    assert clubface.impact(file, **DRIVE).ball_speed < first.ball_speed


def test_provenance_says_what_a_launch_was_computed_from():
    shots = clubface.impact("driver", speed=[50.0, 51.0], model="volumetric", club_mass="200 g")
    provenance = shots.provenance
    assert provenance["clubface_version"] == clubface.__version__
    assert provenance["model"]["name"] == "volumetric"
    assert provenance["parameters"]["values"]["friction"] == 0.372
    used = shots.parameters
    of_values = [f"{name}: {text}" for name, text in used.value_caveats.items()]
    assert used.caveats
    assert provenance["parameters"]["caveats"] == [*used.caveats, *of_values]
    assert provenance["changed"]["values"] == {"club_mass": 0.2}
    assert "array of shape (2,)" in provenance["delivery"]["values"]["speed"]


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
    assert "volumetric" not in data.attrs["model_name"] == DEFAULT_MODEL
    assert shots.to_xarray(dims=("a", "b"))["launch"].dims == ("a", "b")
    zipped = clubface.impact("driver", speed=[50.0, 51.0], toe=[0.0, 0.01]).to_xarray()
    assert zipped["speed"].dims == zipped["toe"].dims == ("shot",)
    assert clubface.impact("driver", **DRIVE).to_xarray()["ball_speed"].dims == ()


def test_a_delivery_names_every_input_of_its_group():
    own = [name for name, each in inputs().items() if each.group == "delivery"]
    assert own == list(clubface.Delivery.__dataclass_fields__)
    with pytest.raises(UnknownNameError, match="toe"):
        clubface.Delivery(speed=50.0).replace(tow=1.0)


def test_one_model_is_the_default_of_everything():
    from clubface.capture.study import Study
    from clubface.inference.run import infer
    from clubface.shots.prediction import predict
    from clubface.validation.run import validate

    assert DEFAULT_MODEL in models()
    for source, name in (
        (clubface.impact, "model"), (clubface.sensitivity, "model"), (predict, "model"), (infer, "model"),
        (validate, "models"), (Study.launch_errors, "model"),
    ):  # fmt: skip
        assert inspect.signature(source).parameters[name].default is DEFAULT_MODEL, source
    shot = clubface.impact("driver", **DRIVE)
    assert shot.model == DEFAULT_MODEL
    assert same(shot, clubface.impact("driver", **DRIVE, model=DEFAULT_MODEL))
