"""Point masses that are printed for a designer have the moments of the head, and lie in it."""

import numpy as np
import pytest

from clubface import club
from clubface.design.feasibility import Envelope, Volume, of_club, pseudo_inertia, room_inside
from clubface.design.optimisation.result import placement_table
from clubface.design.optimisation.study import Head
from clubface.design.optimisation.variables import NEAR, PointMass, placement
from clubface.errors import InputError
from fem_runs import coarse_head

BOX = Volume(shape="box", centre=(-0.055, 0.002, 0.003), size=(0.115, 0.062, 0.124))
AROUND = Volume(shape="ellipsoid", centre=(-0.055, -0.003, 0.003), size=(0.15, 0.09, 0.16))


def moments(result):
    rows = np.array([[*each.place, 1.0] for each in result])
    return np.einsum("n,ni,nj->ij", [each.mass for each in result], rows, rows)


@pytest.mark.parametrize("volume", [BOX, AROUND])
def test_ten_masses_at_most_have_the_moments_of_the_discretionary_mass(volume):
    base = pseudo_inertia(of_club(club("driver")))
    envelope = Envelope(volume=volume, shell=base * (1.0 - 0.03 / 0.204), budget=0.03)
    result = placement(envelope, base)
    assert 1 <= len(result) <= 10
    half = np.array([*(0.5 * np.array(volume.size)), 1.0])
    # Moments are in parts of mass and half size.
    assert np.abs((moments(result) - envelope.placed(base)) / np.outer(half, half)).max() < NEAR * 0.03
    for each in result:
        part = (np.array(each.place) - volume.centre) / half[:3]
        assert np.abs(part).max() <= 1.0 + 1e-9 if volume.shape == "box" else np.linalg.norm(part) <= 1.0 + 1e-9


def test_nothing_is_printed_where_no_masses_in_the_volume_come_near():
    """All mass beyond the box, by a quarter of its length."""
    place = np.array([*(np.array(BOX.centre) - [0.0625 * 1.5, 0.0, 0.0]), 1.0])
    envelope = Envelope(volume=BOX, shell=np.zeros((4, 4)), budget=0.03)
    assert placement(envelope, 0.03 * np.outer(place, place)) == []


@pytest.mark.parametrize(
    "parts", [[(-1.0, 0.83, 0.01), (-0.77, -0.99, -0.11)], [(-1.0, 1.0, -1.0), (0.31, -0.2, 0.77)]]
)
def test_masses_between_places_of_the_grid_are_found(parts):
    """Two masses have moments that no other places have but those of one line, which a grid misses."""
    places = np.array([[*(np.array(BOX.centre) + 0.5 * np.array(BOX.size) * each), 1.0] for each in parts])
    wanted = np.einsum("n,ni,nj->ij", [0.02, 0.01], places, places)
    result = placement(Envelope(volume=BOX, shell=np.zeros((4, 4)), budget=0.03), wanted)
    half = np.array([*(0.5 * np.array(BOX.size)), 1.0])
    assert np.abs((moments(result) - wanted) / np.outer(half, half)).max() < NEAR * 0.03


def test_a_point_mass_at_a_place_of_the_grid_is_found_there():
    place = np.array(BOX.centre) + 0.5 * np.array(BOX.size) * [-1.0, 0.5, -0.5]
    row = np.array([*place, 1.0])
    envelope = Envelope(volume=BOX, shell=np.zeros((4, 4)), budget=0.03)
    (one,) = placement(envelope, 0.02 * np.outer(row, row))
    assert one.mass == pytest.approx(0.02)
    assert one.place == pytest.approx(tuple(place), abs=1e-12)


def test_point_masses_side_by_side_are_one_row_with_the_mass_of_all():
    at = (-0.1, 0.03, -1e-6)
    nearby = (-0.1, 0.03 - 1e-4, 1e-5)
    far = (-0.1, -0.03, 0.0)
    masses = [PointMass(0.006, at), PointMass(0.005, far), PointMass(0.004, nearby), PointMass(1e-8, (0.0, 0.0, 0.0))]
    table = placement_table(masses)
    assert list(table.shown_rows) == [0, 1]
    assert table["mass"].values == pytest.approx([0.010, 0.005, 1e-8])
    assert [table[name].values[0] for name in "xyz"] == pytest.approx(at)


def test_the_room_in_a_ball_is_the_ball_and_in_a_box_the_ellipsoid_of_its_sides():
    on_a_ball = np.random.default_rng(1).normal(size=(20_000, 3))
    on_a_ball *= 0.03 / np.linalg.norm(on_a_ball, axis=1)[:, None]
    far = Volume(shape="box", centre=(0.0, 0.0, 0.0), size=(0.2, 0.2, 0.2))
    assert room_inside(on_a_ball, far).size == pytest.approx((0.058,) * 3, rel=2e-3)
    corners = np.array([[x, y, z] for x in (-0.1, 0.0) for y in (-0.03, 0.03) for z in (-0.06, 0.06)])
    result = room_inside(corners, far)
    assert result.size == pytest.approx((0.098, 0.058, 0.118), rel=2e-3)
    assert result.centre == pytest.approx((-0.05, 0.0, 0.0), abs=1e-4)
    half = Volume(shape="box", centre=(-0.05, 0.0, 0.03), size=(0.1, 0.06, 0.06))
    assert room_inside(corners, half).centre[2] == pytest.approx(0.03, abs=1e-3)
    with pytest.raises(InputError, match="outside the mesh of the club"):
        room_inside(corners, Volume(shape="box", centre=(0.2, 0.0, 0.0), size=(0.1, 0.06, 0.06)))


def test_masses_of_a_meshed_head_lie_inside_its_mesh_and_not_at_a_corner_of_the_box():
    head = coarse_head()
    low, high = head.nodes.min(axis=0), head.nodes.max(axis=0)
    box = Volume(shape="box", centre=tuple(0.5 * (low + high)), size=tuple(high - low))
    base = head.as_club()
    envelope = Head(volume=box, discretionary=0.03).envelope(base)
    # All of the mass far back, high and at the toe, in the ellipsoid's direction of a corner of the box.
    half = 0.5 * np.array(envelope.volume.size)
    place = np.append(envelope.volume.centre + half * np.array([-1.0, 1.0, 1.0]) / np.sqrt(3.0), 1.0)
    result = placement(envelope, envelope.shell + 0.03 * np.outer(place, place))
    assert result
    out = np.random.default_rng(0).normal(size=(3000, 3))
    out /= np.linalg.norm(out, axis=1)[:, None]
    for each in result:
        assert (out @ np.array(each.place) <= (head.nodes @ out.T).max(axis=0) + 1e-6).all()
    corner = np.append(high * [0, 1, 1] + low * [1, 0, 0], 1.0)
    assert placement(envelope, envelope.shell + 0.03 * np.outer(corner, corner)) == []
