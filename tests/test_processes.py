"""Results travel between processes, and forked processes compute."""

import copy
import multiprocessing
import os
import pickle
import signal
import time
import warnings
from concurrent.futures import ProcessPoolExecutor

import numpy as np
import pytest

import clubface
from clubface import fem
from clubface.errors import RuleWarning
from fem_runs import coarse

SPEEDS = np.linspace(30.0, 60.0, 20_000)
"""More shots than one thread takes."""


def _examples():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuleWarning)
        launch = clubface.impact("driver", speed=[40.0, 50.0], toe="5 mm")
        return {
            "club": clubface.club("driver"),
            "ball": clubface.ball("modern"),
            "launch": launch,
            "comparison": clubface.impact("7-iron", speed=40.0, model=["standard", "volumetric"]),
            "history": clubface.history("driver", speed=50.0, model="volumetric"),
            "flight": clubface.fly(launch),
            "sensitivity": clubface.sensitivity("driver", speed=50.0),
            "parameters": launch.parameters,
            "fem ball": fem.ball("paper"),
            "head": fem.head("paper"),
        }


EXAMPLES = _examples()


def exact(value):
    """All numbers and texts of a result, arrays as their bytes, to compare two results bit for bit."""
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    if isinstance(value, (list, tuple)):
        return [exact(each) for each in value]
    if hasattr(value, "items"):
        return {key: exact(each) for key, each in value.items()}
    if hasattr(value, "__dict__") and type(value).__module__.startswith("clubface"):
        return type(value).__name__, {key: exact(each) for key, each in vars(value).items()}
    return sorted(value) if isinstance(value, frozenset) else repr(value)


@pytest.mark.parametrize("name", EXAMPLES)
def test_pickled_and_copied_results_are_equal_bit_for_bit(name):
    example = EXAMPLES[name]
    for copied in (pickle.loads(pickle.dumps(example)), copy.deepcopy(example)):
        assert type(copied) is type(example)
        assert exact(copied) == exact(example)
        assert repr(copied) == repr(example)


def test_a_posterior_travels():
    pytest.importorskip("scipy")
    launch = {"ball_speed": "160 mph", "launch": "12 deg", "azimuth": 0.0, "backspin": "2500 rpm", "sidespin": 0.0}
    result = clubface.infer(launch, club="driver", samples=200)
    for copied in (pickle.loads(pickle.dumps(result)), copy.deepcopy(result)):
        assert exact(copied) == exact(result)
        assert copied.mean == result.mean


def test_a_copied_parameter_set_computes_the_same_launch():
    launch = clubface.impact("driver", speed=SPEEDS[:10])
    again = clubface.impact(
        copy.deepcopy(clubface.club("driver")), speed=SPEEDS[:10], parameters=copy.deepcopy(launch.parameters)
    )
    assert exact(again.ball_speed) == exact(launch.ball_speed)


def test_mappings_of_a_result_cannot_be_changed():
    values = EXAMPLES["parameters"].values
    for change in (lambda: values.update(friction=1.0), lambda: values.pop("friction"), values.clear):
        with pytest.raises(TypeError, match="cannot be changed"):
            change()
    with pytest.raises(TypeError, match="cannot be changed"):
        values["friction"] = 1.0


def _carry(launch):
    return clubface.fly(launch)


def test_results_go_to_a_spawned_process_and_back():
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as pool:
        (result,) = pool.map(_carry, [EXAMPLES["launch"]])
    assert exact(result) == exact(EXAMPLES["flight"])


def _many_shots():
    return clubface.impact("driver", speed=SPEEDS).ball_speed


def _meshed_ball():
    settings = fem.Settings(duration=20e-6, threads=2)
    return fem.strike("driver", speed="40 m/s", ball=coarse(), settings=settings).peak_force


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not fork")
@pytest.mark.filterwarnings("ignore:This process .* is multi-threaded:DeprecationWarning")
@pytest.mark.parametrize("compute", [_many_shots, _meshed_ball], ids=["reduced", "finite elements"])
def test_a_process_forked_after_a_threaded_call_computes_on_threads_of_its_own(compute):
    expected = exact(compute())
    child = os.fork()
    if not child:
        same = exact(compute()) == expected
        os._exit(0 if same else 1)
    ends = time.monotonic() + 30.0  # it takes some 0.3 s
    ended = 0
    while not ended and time.monotonic() < ends:
        ended, status = os.waitpid(child, os.WNOHANG)
        time.sleep(0.02)
    if not ended:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        pytest.fail("the forked process waits for threads that it does not have")
    assert status == 0
