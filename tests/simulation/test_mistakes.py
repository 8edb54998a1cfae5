"""Mistakes at the Python boundary: each names the parameter, its value and what is allowed."""

import math

import numpy as np
import pytest

import clubface
from clubface.errors import ClubfaceError, InputError, ShotError, UnknownNameError
from clubface.support import processes

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

BAD = [
    ({}, "speed", "missing; give it"),
    ({"speed": math.nan}, "speed", "finite"),
    ({"speed": math.inf}, "speed", "finite"),
    ({"speed": "fast"}, "speed", "finite number"),
    ({"speed": None}, "speed", "missing; give it"),
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
    ({"speed": 50.0, "parameters": {"friction": 2.5}}, "friction", "to 2"),
    ({"speed": 50.0, "parameters": {"frictoin": 0.3}}, "parameter of response", "did you mean friction"),
    ({"speed": 50.0, "parameters": 3}, "parameters", "mapping"),
    ({"speed": 50.0, "model": "area", "accuracy": 3.0}, "accuracy", "1e-2"),
    ({"speed": [50.0, 51.0], "toe": [0.0, 0.0, 0.0]}, "the shapes of the inputs", "broadcast"),
    ({"speed": [50.0, -1.0], "on_error": "ignore"}, "on_error", "raise, nan"),
    ({"speed": 50.0, "on_error": "ignore"}, "on_error", "raise, nan"),
    ({"speed": "113 mhp"}, "speed", "'113 mhp'; it must be in m/s or mph or km/h or ft/s (did you mean mph"),
    ({"speed": [[50.0, 51.0], [52.0]]}, "speed", "of equal length"),
    ({"speed": np.ma.masked_greater([50.0, 51.0], 50.0)}, "speed", "shot 1: speed: NaN"),
    ({"speed": 50.0, "model": None}, "model", "at least one of response, standard"),
    ({"speed": 50.0, "model": "area", "accuracy": "fine"}, "accuracy", "finite number"),
    ({"speed": 50.0, "threads": -1}, "threads", "from 1 to 1024"),
    ({"speed": 50.0, "threads": 1.5}, "threads", "from 1 to 1024"),
    ({"speed": 50.0, "threads": True}, "threads", "from 1 to 1024"),
    ({"delivery": "113 mph"}, "delivery", 'speed="113 mph"'),
    ({"speed": 50.0, "bulge": "50 mm"}, "bulge", "does not reach the corners"),
]


@pytest.mark.parametrize(("values", "parameter", "message"), BAD, ids=[str(each[0]) for each in BAD])
def test_a_mistake_names_parameter_value_and_what_is_allowed(values, parameter, message):
    with pytest.raises(InputError) as caught:
        clubface.impact("driver", **values)
    assert caught.value.parameter == parameter
    assert message in str(caught.value)


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
    with pytest.raises(InputError, match=r"at most \d+ with the free memory .*predict"):
        clubface.impact("driver", speed=column, toe=row)


def test_a_view_larger_than_memory_is_refused_before_it_is_copied():
    """The views are of one number each; as arrays of their own they hold 80 TB."""
    many = np.broadcast_to(50.0, (10_000_000_000_000,))
    column, row = np.full((1_000_000, 1), 70.0), np.zeros((1, 1_000_000))
    asked = {
        "speed": lambda: clubface.impact("driver", speed=many),
        "parameters": lambda: clubface.impact("driver", speed=50.0, parameters={"friction": many}),
        "launch": lambda: clubface.fly({"ball_speed": many, "launch": 0.2}),
        "outer": lambda: clubface.fly({"ball_speed": column, "launch": row}),
        "air": lambda: clubface.fly({"ball_speed": 70.0, "launch": 0.2}, air={"altitude": many}),
    }
    for ask in asked.values():
        with pytest.raises(InputError, match="free memory"):
            ask()


@pytest.mark.parametrize("ask", ["impact", "fly"])
def test_memory_is_enough_for_the_reasons_of_shots_that_all_fail(monkeypatch, ask):
    """Each shot without a result says why, which takes more than its numbers."""
    import tracemalloc

    counted = []
    for module in ("inputs", "flight"):
        monkeypatch.setattr(
            f"clubface.simulation.{module}.check_request", lambda shots, each: counted.append(shots * each)
        )
    wrong, compute = np.full(20_000, -1.0), clubface.fly
    launch = {"ball_speed": 1e3 - wrong, "launch": 0.2, "backspin": 300.0, "sidespin": 0.0}
    tracemalloc.start()
    if ask == "impact":
        result = clubface.impact("driver", speed=wrong, on_error="nan")
    else:
        result = compute(launch, on_error="nan")
    used = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(result.problems) == wrong.size
    assert used < max(counted)


def test_as_many_shots_as_fit_memory_are_computed_and_more_are_refused(monkeypatch):
    """Free memory set to 200 MB, of which half may be used.

    22 outputs of 8 bytes, and 400 bytes for the reason of a shot without a result, make 173611 shots.
    """
    monkeypatch.setattr(processes, "available_memory", lambda: 200_000_000)
    with pytest.raises(InputError, match="at most 173611"):
        clubface.impact("driver", speed=np.full(600_000, 50.0))
    assert clubface.impact("driver", speed=np.full(170_000, 50.0)).shape == (170_000,)
    assert processes.available_memory() > 0


def test_free_memory_is_known_here():
    assert 2**20 < processes.available_memory() < 2**50
