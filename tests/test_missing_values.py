"""What stands for no value, and what is no number, in every container and every argument that takes arrays."""

import math
from fractions import Fraction

import numpy as np
import pytest

import clubface
from clubface import units
from clubface.capture.recording import Recording
from clubface.design.strokes import expected
from clubface.errors import ClubfaceError, InputError
from clubface.inference.evaluation.statistics import monitor_noise
from clubface.inference.identification.simulator import noise_of
from clubface.shots.recorded import RecordedShots

pytestmark = pytest.mark.filterwarnings("ignore")
FLAT = {"ball_speed": 60.0, "launch": 0.2, "backspin": 250.0, "sidespin": 0.0}


def recorded(values, part="deliveries"):
    given = {"deliveries": {}, "launches": {}} | {part: {"speed" if part == "deliveries" else "ball_speed": values}}
    shots = RecordedShots(**given, rows=[1, 2, 3], source="made", format="clubface")
    return (shots.deliveries | shots.launches).popitem()[1]


def golfer_mean(values):
    given = {"variables": ("speed", "attack", "loft"), "covariance": np.diag([1.0, 1e-4, 1e-4])}
    return clubface.Golfer(name="made", mean=values, **given).mean


ENTRIES = {
    "impact, an input": lambda v: clubface.impact("driver", speed=v, on_error="nan").ball_speed,
    "impact, a mapping": lambda v: clubface.impact("driver", {"speed": v}, on_error="nan").ball_speed,
    "impact, a Delivery": lambda v: clubface.impact("driver", clubface.Delivery(speed=v), on_error="nan").ball_speed,
    "impact, a club's mass": lambda v: clubface.impact("driver", speed=45.0, club_mass=v, on_error="nan").ball_speed,
    "fly": lambda v: clubface.fly(FLAT | {"ball_speed": v}, on_error="nan").carry,
    "fly, a spin": lambda v: clubface.fly(FLAT | {"backspin": v, "total_spin": v}, on_error="nan").carry,
    "fly, air": lambda v: clubface.fly(FLAT, air={"altitude": v}, on_error="nan").carry,
    "fly, wind": lambda v: clubface.fly(FLAT, wind=(v, 0.0, 0.0), on_error="nan").carry,
    "fly, a vector": lambda v: (
        clubface.fly({"velocity_x": v, "velocity_y": 10.0, "velocity_z": 0.0}, on_error="nan").carry
    ),
    "strokes": lambda v: expected("fairway", v),
    "shots, a delivery": recorded,
    "shots, a launch": lambda v: recorded(v, "launches"),
    "units": lambda v: units.parse_values(v, "length", name="speed"),
}
"""Arguments in which a missing value leaves its row without a result."""
REFUSING = {
    "a golfer's mean": golfer_mean,
    "a parameter": lambda v: clubface.impact(
        "driver", speed=45.0, model="volumetric", parameters={"layer_stiffness": v}, on_error="nan"
    ),
    "a prior": lambda v: clubface.Prior(name="made", mean={"speed": v}, deviation={"speed": 1.0}),
    "markers in two dimensions": lambda v: Recording(labels=("HEAD1",), positions=[v, v], rate=360.0),
    "points of a map": lambda v: clubface.map_face("driver", speed=45.0, toe=v),
    "best loft": lambda v: clubface.best_loft(v, club="driver").loft,
    "a golfer's shots": lambda v: clubface.golfer("tour driver").deliveries(v),
}
"""Arguments without which there is nothing to compute."""


def pandas():
    return pytest.importorskip("pandas")


def arrow():
    return pytest.importorskip("pyarrow")


MISSING = {
    "a mask": lambda: np.ma.array([50.0, 1e20, 45.0], mask=[False, True, False]),
    "a mask of whole numbers": lambda: np.ma.array([50, 66, 45], mask=[False, True, False]),
    "a mask of objects": lambda: np.ma.array([50.0, 66.0, 45.0], mask=[False, True, False], dtype=object),
    "a mask of texts": lambda: np.ma.array(["50 m/s", "66 m/s", "45 m/s"], mask=[False, True, False], dtype=object),
    "masked in a list": lambda: [50.0, np.ma.masked, 45.0],
    "None in a list": lambda: [50.0, None, 45.0],
    "NaN": lambda: np.array([50.0, math.nan, 45.0]),
    "Float64": lambda: pandas().Series([50.0, None, 45.0], dtype="Float64"),
    "Int64": lambda: pandas().array([50, None, 45], dtype="Int64"),
    "NA of objects": lambda: pandas().Series([50.0, pandas().NA, 45.0], dtype=object),
    "NaT in a list": lambda: [50.0, pandas().NaT, 45.0],
    "Arrow": lambda: arrow().array([50.0, None, 45.0]),
    "nulls of Arrow in a list": lambda: list(arrow().array([50.0, None, 45.0])),
    "Arrow in chunks": lambda: arrow().chunked_array([[50], [None, 45]]),
    "Arrow in pandas": lambda: pandas().Series([50.0, None, 45.0], dtype=pandas().ArrowDtype(arrow().float64())),
    "xarray": lambda: pytest.importorskip("xarray").DataArray(np.ma.array([50.0, 1.0, 45.0], mask=[0, 1, 0])),
}
NO_NUMBERS = {
    "truth values": lambda: np.array([True, False, True]),
    "a truth value in a list": lambda: [50.0, True, 45.0],
    "truth values of pandas": lambda: pandas().Series([True, None, False], dtype="boolean"),
    "truth values of Arrow": lambda: arrow().array([True, None, False]),
    "complex numbers": lambda: np.array([50.0 + 0j, 40.0, 45.0]),
    "a complex number in a list": lambda: [50.0, 40.0 + 0j, np.complex128(45.0)],
    "digits without a unit": lambda: ["50", "40", "45"],
    "an array of digits": lambda: np.array(["50", "40", "45"]),
    "objects": lambda: np.array([50.0, object(), 45.0], dtype=object),
    "a mapping": lambda: {"a": 50.0, "b": 40.0, "c": 45.0},
    "bytes": lambda: np.array([b"50", b"40", b"45"]),
    "dates": lambda: np.array(["2024-01-01", "2024-01-02", "2024-01-03"], dtype="datetime64[D]"),
    "records": lambda: np.array([(50.0,), (40.0,), (45.0,)], dtype=[("speed", float)]),
}
ONE_NUMBER = (np.bool_(True), True, 1j, np.complex128(50.0), object(), "50")


@pytest.mark.parametrize("container", MISSING)
@pytest.mark.parametrize("entry", ENTRIES)
def test_a_value_that_is_masked_or_missing_is_computed_with_nowhere(entry, container):
    given = MISSING[container]()
    if container == "a mask of texts" and entry not in ("impact, an input", "fly", "shots, a delivery"):
        pytest.skip("texts with a unit of speed")
    result = np.asarray(ENTRIES[entry](given))
    assert np.isnan(result).tolist() == [False, True, False]
    usual = np.asarray(ENTRIES[entry](np.array([50.0, math.nan, 45.0])))
    np.testing.assert_array_equal(result, usual)


@pytest.mark.parametrize("container", [each for each in MISSING if each != "NaN"])
@pytest.mark.parametrize("entry", REFUSING)
def test_functions_without_gaps_refuse_missing_values(entry, container):
    with pytest.raises(InputError):
        REFUSING[entry](MISSING[container]())


@pytest.mark.parametrize("container", NO_NUMBERS)
@pytest.mark.parametrize("entry", ENTRIES | REFUSING)
def test_values_without_numbers_are_refused_with_the_name_of_the_argument(entry, container):
    given = NO_NUMBERS[container]()
    if entry == "a parameter" and container in ("digits without a unit", "an array of digits"):
        pytest.skip("a parameter without a unit")
    with pytest.raises(
        ClubfaceError,
        match=r"speed|club_mass|layer_stiffness|altitude|wind|spin|velocity_x|distance|mean|toe|uniform|positions",
    ):
        (ENTRIES | REFUSING)[entry](given)


@pytest.mark.parametrize(
    "value", ONE_NUMBER, ids=lambda value: f"{type(value).__name__} {value}".split(" object at")[0]
)
@pytest.mark.parametrize(
    "entry",
    [
        lambda v: clubface.impact("driver", speed=v),
        lambda v: clubface.impact("driver", speed=[v]),
        lambda v: clubface.fly(FLAT | {"ball_speed": v}),
        lambda v: clubface.trajectory(FLAT | {"ball_speed": v}),
        lambda v: clubface.history("driver", speed=v),
        lambda v: clubface.sensitivity("driver", speed=v),
        lambda v: clubface.infer({"ball_speed": v}, club="driver"),
        lambda v: clubface.best_loft(v, club="driver"),
        lambda v: clubface.map_face("driver", speed=v),
    ],
    ids=["impact", "batch", "fly", "trajectory", "history", "sensitivity", "infer", "best loft", "map"],
)
def test_one_value_that_is_no_number_is_refused_with_its_name(entry, value):
    with pytest.raises(InputError, match="speed"):
        entry(value)


@pytest.mark.parametrize(
    "entry",
    [
        lambda: clubface.Hole(length="430"),
        lambda: clubface.club("driver").replace(bulge="305"),
        lambda: clubface.ball().replace(mass="45.9"),
        lambda: clubface.infer({"ball_speed": 60.0}, club="driver", noise={"backspin": "100"}),
        lambda: monitor_noise({"backspin": "100"}),
        lambda: noise_of(("backspin",), {"backspin": "80"}),
    ],
)
def test_lengths_masses_and_noise_as_digits_without_a_unit_are_refused(entry):
    with pytest.raises(InputError, match="text with its unit"):
        entry()


def test_numbers_of_every_kind_are_numbers():
    for value in (50, np.float32(50), np.int8(50), Fraction(50), np.array(50.0)):
        assert clubface.impact("driver", speed=value).ball_speed == clubface.impact("driver", speed=50.0).ball_speed


def test_names_and_hands_that_are_masked_are_not_there():
    names = np.ma.array(["driver", "7-iron"], mask=[False, True], dtype=object)
    shots = RecordedShots(
        deliveries={"speed": [50.0, 40.0]}, launches={}, clubs=names, players=["Anna", None], rows=[1, 2],
        source="made", format="clubface",
    )  # fmt: skip
    assert (shots.clubs.tolist(), shots.players.tolist()) == (["driver", ""], ["Anna", ""])
    with pytest.raises(InputError, match="hand"):
        RecordedShots(
            deliveries={"speed": [50.0, 40.0]}, launches={}, hand=np.ma.array(["right", "left"], mask=[0, 1]),
            rows=[1, 2], source="made", format="clubface",
        )  # fmt: skip


def test_a_marker_that_is_masked_was_not_seen():
    places = np.ma.array(np.arange(12.0).reshape(2, 2, 3), mask=False)
    places[1, 0] = np.ma.masked
    result = Recording(labels=("HEAD1", "HEAD2"), positions=places, rate=360.0)
    assert np.isnan(result.marker("HEAD1")).tolist() == [[False] * 3, [True] * 3]
    assert not np.isnan(result.marker("HEAD2")).any()
