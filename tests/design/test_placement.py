"""Point masses that are printed for a designer have the moments of the head, and lie in it."""

from types import SimpleNamespace

import numpy as np
import pytest

from clubface import club
from clubface.design.feasibility import Envelope, Volume, of_club, pseudo_inertia
from clubface.design.optimisation.placement import NEAR, PointMass, placement
from clubface.design.optimisation.words import placement_table

BOX = Volume(shape="box", centre=(-0.055, 0.002, 0.003), size=(0.115, 0.062, 0.124))
AROUND = Volume(shape="ellipsoid", centre=(-0.055, -0.003, 0.003), size=(0.15, 0.09, 0.16))


def moments(found):
    rows = np.array([[*each.place, 1.0] for each in found])
    return np.einsum("n,ni,nj->ij", [each.mass for each in found], rows, rows)


@pytest.mark.parametrize("volume", [BOX, AROUND])
def test_ten_masses_at_most_have_the_moments_of_the_discretionary_mass(volume):
    base = pseudo_inertia(of_club(club("driver")))
    envelope = Envelope(volume=volume, shell=base * (1.0 - 0.03 / 0.204), budget=0.03)
    found = placement(envelope, base)
    assert 1 <= len(found) <= 10
    half = np.array([*(0.5 * np.array(volume.size)), 1.0])
    # Moments are in parts of mass and half size.
    assert np.abs((moments(found) - envelope.placed(base)) / np.outer(half, half)).max() < NEAR * 0.03
    for each in found:
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
    found = placement(Envelope(volume=BOX, shell=np.zeros((4, 4)), budget=0.03), wanted)
    half = np.array([*(0.5 * np.array(BOX.size)), 1.0])
    assert np.abs((moments(found) - wanted) / np.outer(half, half)).max() < NEAR * 0.03


def test_a_point_mass_at_a_place_of_the_grid_is_found_there():
    place = np.array(BOX.centre) + 0.5 * np.array(BOX.size) * [-1.0, 0.5, -0.5]
    row = np.array([*place, 1.0])
    envelope = Envelope(volume=BOX, shell=np.zeros((4, 4)), budget=0.03)
    (one,) = placement(envelope, 0.02 * np.outer(row, row))
    assert one.mass == pytest.approx(0.02)
    assert one.place == pytest.approx(tuple(place), abs=1e-12)


def test_point_masses_side_by_side_are_one_row_with_the_mass_of_all():
    at = (-0.1, 0.03, -1e-6)
    beside = (-0.1, 0.03 - 1e-4, 1e-5)
    far = (-0.1, -0.03, 0.0)
    masses = [PointMass(0.006, at), PointMass(0.005, far), PointMass(0.004, beside), PointMass(1e-8, (0.0, 0.0, 0.0))]
    _, rows = placement_table(SimpleNamespace(placed=lambda: masses))  # type: ignore[arg-type]
    assert rows == [["1", "10.0", "-100.0", "30.0", "0.0"], ["2", "5.0", "-100.0", "-30.0", "0.0"]]
