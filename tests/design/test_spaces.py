"""The space that a head is assumed to fill: every built-in head fits into its own."""

from pathlib import Path

import numpy as np
import pytest

from clubface import club
from clubface.design.feasibility import DRIVER_VOLUME, FREE, IRON, Envelope, of_club, pseudo_inertia, usual_space
from clubface.design.optimisation.study import read
from clubface.equipment.clubs import CLUB_NAMES
from clubface.fem.heads.meshed import mesh_of
from clubface.support.files import DATA

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("name", CLUB_NAMES)
def test_every_built_in_head_fits_into_its_space(name):
    head = club(name)
    space, moments = usual_space(head), pseudo_inertia(of_club(head))
    envelope = Envelope(volume=space.volume, shell=moments * (1.0 - space.free / head.mass), budget=space.free)
    assert [each.reason for each in envelope.margins(moments) if not each.met] == []


def test_the_space_of_a_driver_is_that_of_the_example():
    head = read(EXAMPLES / "better_driver.toml").head
    space = usual_space(club("driver"))
    assert (head.volume, head.discretionary) == (space.volume, FREE)
    assert head.displaced == pytest.approx(space.displaced)


def test_the_space_of_an_iron_is_the_box_around_its_mesh():
    places = mesh_of(club(Path(DATA) / "fem_heads" / "7-iron.toml")).places
    least, most = places.min(axis=0), places.max(axis=0)
    # Rounded to a hundredth of a millimetre.
    assert np.abs(0.5 * (least + most) - IRON.centre).max() < 1e-5
    assert np.abs(most - least - IRON.size).max() < 1e-5


def test_other_heads_are_as_much_smaller_as_their_faces():
    space = usual_space(club("3-wood"))
    assert space.displaced == pytest.approx(DRIVER_VOLUME * (75 / 105) ** 3)
    assert space.origin == "assumed: that of a driver of 460 cm3 times 0.714, as the widths of the faces"
