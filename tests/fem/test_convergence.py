"""Four meshes of the reference case: the default one is fine enough for the launch."""

import math
from dataclasses import replace

import pytest

from clubface import fem

MESHES = ((8, 4, 2), (12, 6, 3), (16, 8, 4), (20, 10, 5))
"""Elements along the cube, layers of core and cover around it; the second is the default."""


@pytest.mark.study
def test_the_launch_converges_with_the_mesh():
    result = []
    made = fem.ball("reference")
    for cube, *layers in MESHES:
        pieces = tuple(replace(piece, layers=count) for piece, count in zip(made.pieces, layers, strict=True))
        ball = replace(made, cube=cube, pieces=pieces)
        settings = fem.Settings(until_separation=True)
        run = fem.throw(ball, speed="35 m/s", angle="11.5 deg", friction=0.35, settings=settings)
        angle = math.atan2(run.tangential_velocity, run.normal_velocity)
        result.append((math.hypot(run.normal_velocity, run.tangential_velocity), run.backspin, angle))
    (_, default, _, finest) = result
    assert default[0] == pytest.approx(finest[0], rel=0.005)
    assert default[1] == pytest.approx(finest[1], rel=0.02)
    # The angle changes by the 1.5% of the velocity along the plane, as with hexahedra of eight points.
    assert default[2] == pytest.approx(finest[2], abs=math.radians(0.2))
