"""Second derivatives of launches and flights as functions of a row of numbers: how good the differences are."""

import numpy as np
import pytest

import clubface
from clubface.simulation import differentiable
from clubface.simulation.differentiable import ROUGH, FlightFunction, LaunchFunction
from clubface.simulation.results import flight_inputs, flight_outputs

DRIVE = {"speed": 48.0, "attack": 0.03, "path": 0.02, "loft": 0.22, "face": -0.01, "lie": 0.03, "toe": 0.008,
         "high": 0.004, "closure": 40.0}  # fmt: skip
SIZES = np.array([48.0, 0.2, 0.2, 0.22, 0.2, 0.2, 0.02, 0.02, 50.0])
MOTION = tuple(f"{name}_{axis}" for name in ("velocity", "spin") for axis in "xyz")


def launch(model):
    """A launch by the drive, at the face centre for a model without gear effect, and the sizes of its variables."""
    place = {} if clubface.models()[model].gear_effect else {"toe": 0.0, "high": 0.0}
    values = DRIVE | place
    return LaunchFunction("driver", values, values, model=model), np.array([*values.values()]), SIZES


def flight():
    """A flight by velocity and spin of a drive, and their sizes."""
    started = clubface.impact("driver", DRIVE)
    values = {name: each.default for name, each in flight_inputs().items()} | clubface.ball().inputs()
    values |= {name: float(getattr(started, name)) for name in MOTION}
    point = np.array([values[name] for name in MOTION])
    outputs = [name for name in flight_outputs() if name not in ROUGH]
    return FlightFunction(values, MOTION, outputs=outputs), point, np.abs(point)


@pytest.mark.parametrize(
    ("made", "stated"),
    [(lambda model=model: launch(model), 1e-9) for model in ("response", "standard", "adjusted", "slip", "jorgensen")]
    + [(flight, 1e-6)],
    ids=["response", "standard", "adjusted", "slip", "jorgensen", "flight"],
)
def test_second_derivatives_are_as_good_as_stated(made, stated, monkeypatch):
    """Of differences of fourth order, half the step leaves a sixteenth of the error, but for rounding."""
    second = []
    for step in (differentiable.STEP, 0.5 * differentiable.STEP):
        monkeypatch.setattr(differentiable, "STEP", step)
        function, point, size = made()
        second.append(function.hessian(point) * size * size[:, None])
    largest = np.abs(function.values_and_jacobian(point)[1] * size).max(-1)[:, None, None]
    known = np.isfinite(second[0])
    assert known.sum() > 100
    assert (np.isfinite(second[1]) == known).all()
    assert np.abs((second[0] - second[1]) / largest)[known].max() < stated
    assert np.abs(second[0] / largest)[known].max() > 1e-2
