"""Time at the Python boundary, next to the results it computes."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

import clubface
import clubface._core

DRIVE = {"speed": "108 mph", "attack": "2 deg", "loft": "13 deg"}
MODELS = [model["name"] for model in clubface._core.models()]


@pytest.mark.parametrize("model", MODELS)
def test_one_call(benchmark, model):
    """One impact through the public call; the physics alone is `test_one_call_of_the_core`."""
    club = clubface.Club.builtin("driver")
    launch = benchmark(clubface.impact, club, model=model, speed=48.28, attack=0.0349, loft=0.2269)
    print(f"\n{model}: ball speed {launch.ball_speed:.3f} m/s, backspin {launch.get('backspin', 'rpm'):.1f} rpm")


@pytest.mark.parametrize("model", MODELS)
def test_one_call_of_the_core(benchmark, model):
    """The same impact as columns of the compiled core."""
    club, ball = clubface.Club.builtin("driver"), clubface.ball("published")
    values = {"speed": 48.28, "attack": 0.0349, "loft": 0.2269, **club.inputs(), **ball.inputs()}
    columns = [float(values.get(entry["name"], 0.0)) for entry in clubface._core.inputs()]
    (info,) = [entry for entry in clubface._core.models() if entry["name"] == model]
    parameters = [parameter["default"] for parameter in info["parameters"]]
    outputs, rejects = benchmark(clubface._core.impact, model, columns, parameters, 1)
    assert not rejects
    print(f"\n{model}: ball speed {outputs[0, 0]:.3f} m/s")


@pytest.mark.parametrize("threads", [1, 2])
def test_a_million_impulse_shots(benchmark, threads):
    """A NumPy array of a million speeds, standard model."""
    speed = np.linspace(40.0, 54.0, 1_000_000)
    launch = benchmark.pedantic(
        clubface.impact,
        args=("driver",),
        kwargs={"speed": speed, "loft": 0.2269, "model": "standard", "threads": threads},
        rounds=5,
        warmup_rounds=1,
    )
    print(f"\nball speed {launch.ball_speed[0]:.3f} to {launch.ball_speed[-1]:.3f} m/s")


def test_a_map_of_a_face(benchmark):
    """A driver struck at 101 by 101 points by the default model, flights and all."""
    face_map = benchmark.pedantic(clubface.map_face, args=("driver", DRIVE), rounds=10, warmup_rounds=1)
    print(f"\n{face_map}")


@pytest.mark.parametrize(
    "arguments",
    [
        ["-c", "import clubface"],
        ["-m", "clubface", "shot", "driver", "--speed", "113 mph"],
    ],
    ids=["import clubface", "clubface shot driver"],
)
def test_whole_process(benchmark, arguments):
    """A fresh process, from start to end."""
    result = benchmark.pedantic(
        subprocess.run,
        args=([sys.executable, *arguments],),
        kwargs={"check": True, "capture_output": True, "text": True},
        rounds=7,
        warmup_rounds=2,
    )
    print("\n" + result.stdout)
