"""How far derivatives of the model ``rings`` lie from central differences, over drives that people make."""

import warnings
from functools import cache

import numpy as np

import clubface

STEPS = {
    "speed": 1.0, "attack": np.radians(1.0), "loft": np.radians(1.0), "face": np.radians(1.0), "toe": 1e-3,
    "high": 1e-3, "closure": 10.0,
}  # fmt: skip
"""Changes of each variable that a golfer would notice; derivatives are measured by them."""
OUTPUTS = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")


@cache
def ring_errors(accuracy=None, shots=24):
    """Return the mean and the largest error of each output, as parts of its largest change by any of the variables.

    The differences are taken over half of each change, at an accuracy of 1e-10, so that rings that stick or slip a
    little sooner average out.
    """
    draw = np.random.default_rng(3)
    drives = {
        "speed": draw.uniform(42.0, 52.0, shots), "attack": draw.uniform(-0.05, 0.08, shots),
        "path": draw.uniform(-0.06, 0.06, shots), "loft": draw.uniform(0.15, 0.30, shots),
        "face": draw.uniform(-0.06, 0.06, shots), "toe": draw.uniform(-0.015, 0.015, shots),
        "high": draw.uniform(-0.008, 0.008, shots), "closure": draw.uniform(0.0, 60.0, shots), "model": "rings",
    }  # fmt: skip
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        table = clubface.sensitivity("driver", **drives, variables=[*STEPS], outputs=OUTPUTS, accuracy=accuracy)
        changes = table.si * np.array([*STEPS.values()])[:, None]
        differences = np.zeros_like(changes)
        for column, (name, step) in enumerate(STEPS.items()):
            more, less = (
                clubface.impact("driver", **drives | {name: drives[name] + part * step}, accuracy=1e-10)
                for part in (0.25, -0.25)
            )
            differences[:, column] = [2.0 * (getattr(more, each) - getattr(less, each)) for each in OUTPUTS]
    size = np.abs(differences).max(axis=(1, 2), keepdims=True)
    errors = np.abs(changes - differences) / size
    return np.sqrt((errors**2).mean(axis=(1, 2))), errors.max(axis=(1, 2))
