"""Swings, recordings and set-ups that several tests of motion capture share."""

import math

import numpy as np
import pytest

pytest.importorskip("ezc3d")

from clubface.capture.reduction import QUANTITIES
from clubface.capture.setup import prepare
from clubface.capture.swing import capture
from clubface.capture.synthetic.laboratory import Cameras, positions_map
from clubface.capture.synthetic.synthetic_swing import random_swing

SHOWN = {
    name: math.degrees(1.0)
    if name in ("attack", "path", "loft", "face", "lie")
    else 1e3
    if name in ("toe", "high")
    else 1.0
    for name in QUANTITIES
}
"""From SI to m/s, degrees, mm and rad/s."""


CLEAN_CAMERAS = Cameras()


def captured(swing, cameras, *, seed=1, mapping=None, **options):
    """Record a swing and read it back."""
    mapping = mapping or positions_map(swing.club, cameras)
    return capture(cameras.record(swing, seed), prepare(mapping, swing.club, **options))


def errors(measured, swing):
    """Captured less true values, in the units of SHOWN, in the order of QUANTITIES."""
    return np.array([(getattr(measured.delivery, name) - swing.truth[name]) * SHOWN[name] for name in QUANTITIES])


def deviations(measured):
    """The stated standard deviations in the same units and order."""
    return np.array([measured.uncertainty[name] * SHOWN[name] for name in QUANTITIES])


def swings(count, **options):
    return [random_swing(seed, **options) for seed in range(count)]


def world_cameras(**options):
    """Cameras whose axes are those of the world."""
    return Cameras(target="+x", up="+y", origin=(0.0, 0.0, 0.0), **options)


def damaged(positions, number, first, last, some, random):
    """Return positions of markers, some of them hidden, shifted, cut, shuffled, reversed or scaled between two frames;
    which of these follows from the number."""
    match number % 6:
        case 0:
            positions[first:last, some] = np.nan
        case 1:
            positions[first:last, some] += random.normal(size=3) * 10.0 ** random.uniform(-4, 1)
        case 2:
            positions = positions[first : last + 2]
        case 3:
            positions[first:, some] = positions[first:, random.permutation(some)]
        case 4:
            positions = np.repeat(positions[:: random.choice([1, -1])], 2, axis=0)
        case 5:
            positions[first:last] *= 10.0 ** random.uniform(-3, 3)
    return positions
