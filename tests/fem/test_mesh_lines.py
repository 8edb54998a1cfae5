"""Strikes on lines and corners of a head's mesh: the nodes of the ball belong to what is under them, on either side."""

from functools import cache

import numpy as np
import pytest

import clubface
from clubface import fem
from clubface.fem.heads import Metal, ShellHead, SolidHead, SolidPart
from clubface.fem.heads.meshed import Part
from fem_runs import coarse

LOFT = np.radians(10.5)
RADIUS = 0.3
"""Bulge and roll [m]."""
UP, TOE = np.linspace(-0.024, 0.024, 9), np.linspace(-0.042, 0.042, 15)
"""Lines of the mesh, symmetric about the middle [m]."""


def curved(depth):
    """Nodes of a plate with bulge and roll, so far behind its outer side [m], for the lines of the mesh."""
    y, z = np.meshgrid(UP, TOE, indexing="ij")
    # Bent along lines that are not those of a torus, so that its elements are warped.
    y = y * (1.0 - 4.0 * abs(z))
    x = -(y**2 + z**2) / (2.0 * RADIUS) - depth
    s, c = np.sin(LOFT), np.cos(LOFT)
    return np.stack([c * x - s * y, s * x + c * y, z], axis=-1).reshape(-1, 3)


def cells():
    """Corners of the quadrilaterals, counterclockwise as seen from the ball."""
    index = np.arange(UP.size * TOE.size).reshape(UP.size, TOE.size)
    corners = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    return np.stack([each.reshape(-1) for each in corners], axis=-1)


@cache
def plate(kind):
    """A curved plate of some 200 g, of shells or of hexahedra; a rigid head with a face of its own where it is none."""
    if kind in ("driver", "7-iron"):
        return clubface.club(kind)
    titanium = Metal(youngs=114e9, poisson=0.34, density=4430.0)
    shared = {"name": f"plate of {kind}", "loft": float(LOFT), "bulge": RADIUS, "roll": RADIUS}
    if kind == "shells":
        nodes, quads, thickness = curved(2.5e-3), cells(), 5e-3
        return ShellHead(
            nodes=nodes, quads=quads, thickness=np.full(len(quads), thickness),
            parts=(Part("face", len(quads), titanium, face=True),), added=np.full(len(nodes), 0.11 / len(nodes)),
            **shared,
        )  # fmt: skip
    nodes = np.concatenate([curved(depth) for depth in (6e-3, 3e-3, 0.0)])
    layer, quads = len(nodes) // 3, cells()
    hexahedra = np.concatenate([np.hstack([quads + k * layer, quads + (k + 1) * layer]) for k in range(2)])
    return SolidHead(
        nodes=nodes, parts=(SolidPart(name="head", metal=titanium, hexahedra=hexahedra),), face=quads + 2 * layer,
        added=np.full(len(nodes), 0.09 / len(nodes)), **shared,
    )  # fmt: skip


def struck(head, toe, high):
    return fem.strike(
        head, speed=48.0, loft=head.loft, toe=toe, high=high, ball=coarse("modern"),
        settings=fem.Settings(duration=8e-4),
    )  # fmt: skip


PLACES = {"a line": (0.0, 0.004), "a corner": (TOE[7], 0.0), "another corner": (TOE[8], UP[5])}


@pytest.mark.parametrize("kind", ["shells", "hexahedra", "driver", "7-iron"])
@pytest.mark.parametrize("place", PLACES)
def test_a_strike_on_a_line_of_the_mesh_is_like_those_a_micrometre_away(kind, place):
    toe, high = PLACES[place]
    on = struck(plate(kind), toe, high)
    assert on.stopped is None
    assert not on.over_edge
    # As of strikes within elements; a node that is lost costs more than half a per cent.
    assert on.energy_error < 2e-3
    sides = [struck(plate(kind), toe + move, high - move) for move in (-1e-6, 1e-6)]
    # The launch goes smoothly with the place, backspin by 5e-5 of itself in 1 um, so it is the mean of those on either
    # side. The peak of a force that rings is a little less smooth.
    assert on.peak_force == pytest.approx(np.mean([each.peak_force for each in sides]), rel=1e-4)
    for name in ("ball_speed", "launch", "backspin"):
        assert on.launch.get(name) == pytest.approx(np.mean([float(each.launch.get(name)) for each in sides]), rel=1e-5)


@pytest.mark.parametrize("kind", ["shells", "hexahedra"])
def test_a_symmetric_head_struck_on_its_line_of_symmetry_starts_the_ball_straight(kind):
    result = struck(plate(kind), 0.0, 0.0).launch
    # Elements number their corners one way round, which leaves a millionth of the speed.
    assert abs(float(result.azimuth)) < 2e-5
    assert abs(float(result.sidespin)) < 1e-3 * float(result.backspin)


@pytest.mark.parametrize("kind", ["shells", "hexahedra"])
def test_strikes_to_either_side_are_mirror_images(kind):
    right, left = (struck(plate(kind), toe, 0.002).launch for toe in (TOE[8], -TOE[8]))
    assert float(right.ball_speed) == pytest.approx(float(left.ball_speed), rel=2e-5)
    assert float(right.azimuth) == pytest.approx(-float(left.azimuth), abs=2e-5)
    assert float(right.sidespin) == pytest.approx(-float(left.sidespin), abs=0.02)
