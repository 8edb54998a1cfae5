"""Heads by their dimensions: both ends of the range that a message tells are taken, and what is beyond is refused."""

import dataclasses
import re

import pytest

from clubface import fem, units
from clubface.errors import InputError

DRIVER = fem.DriverHead(
    name="one",
    shape={"loft": "10 deg", "bulge": "300 mm", "roll": "300 mm", "width": "110 mm", "depth": "100 mm",
           "crown": "30 mm", "sole": "30 mm", "rounding": "5 mm"},
    thickness=dict.fromkeys(("face_centre", "face_edge", "crown", "sole", "skirt"), "1 mm"),
    target={"mass": "200 g"},
)  # fmt: skip
IRON = fem.IronHead(
    name="one",
    shape={"loft": "32 deg", "length": "75 mm", "heel_height": "30 mm", "toe_height": "50 mm", "face": "3 mm",
           "sole": "15 mm", "top": "5 mm", "rim": 0.2, "rounding": "2 mm"},
)  # fmt: skip
HEADS = {"driver": DRIVER, "iron": IRON}
ENDS = {
    "driver": {
        "loft": "0 to 40 deg", "bulge": "100 to 10000 mm", "roll": "100 to 10000 mm", "width": "50 to 150 mm",
        "depth": "30 to 150 mm", "crown": "8 to 60 mm", "sole": "8 to 60 mm", "rounding": "1 to 20 mm",
    },
    "iron": {
        "loft": "0 to 70 deg", "length": "40 to 120 mm", "heel_height": "10 to 80 mm", "toe_height": "15 to 100 mm",
        "face": "1 to 20 mm", "sole": "1 to 40 mm", "top": "1 to 20 mm", "rim": "0.05 to 0.5",
    },
}  # fmt: skip
"""Beyond all heads that are sold; the corners of an iron have a limit of their own, below."""


def reshaped(head, key, value):
    return dataclasses.replace(head, shape={**head.shape, key: value})


@pytest.mark.parametrize(("kind", "key"), [(kind, key) for kind, ends in ENDS.items() for key in ends])
def test_the_ends_of_every_range_are_taken_and_what_is_beyond_is_refused_with_them(kind, key):
    head, ends = HEADS[kind], ENDS[kind][key]
    low, high, unit = re.fullmatch(r"(\S+) to (\S+)(?: (mm|deg))?", ends).groups()
    low, high = (units.to_si(float(each), unit or "1") for each in (low, high))
    for value in (low, high):
        assert reshaped(head, key, value).shape[key] == value
    for value in (low * 0.999 if low else -1e-3, high * 1.001):
        with pytest.raises(InputError) as caught:
            reshaped(head, key, value)
        assert re.fullmatch(rf"shape\.{key} is .*; it must be {ends}", str(caught.value))


@pytest.mark.parametrize(
    ("head", "least"),
    [(DRIVER, (4, 4, 4)), (IRON, (8, 8, 1))],
    ids=["driver", "iron"],
)
def test_numbers_of_elements(head, least):
    for numbers in (least, (400, 400, 400)):
        assert dataclasses.replace(head, elements=numbers).elements == numbers
    for place in range(3):
        for wrong in (least[place] - 1, 401):
            numbers = tuple(wrong if each == place else least[each] for each in range(3))
            with pytest.raises(InputError, match=r"elements is .* to 400"):
                dataclasses.replace(head, elements=numbers)


def test_the_mass_and_the_walls_of_a_driver():
    for grams in (50, 500):
        assert dataclasses.replace(DRIVER, target={"mass": f"{grams} g"}).target["mass"] == grams * 1e-3
    for grams in (49.9, 500.1):
        with pytest.raises(InputError, match=f"target.mass is '{grams} g'.* 50 to 500 g"):
            dataclasses.replace(DRIVER, target={"mass": f"{grams} g"})
    for scales in ((0.1, 1.0), (1.0, 10.0), (0.1, 10.0)):
        assert dataclasses.replace(DRIVER, scales=scales).scales == scales
    for scales in ((0.099, 2.0), (1.001, 2.0), (0.5, 0.999), (0.5, 10.01)):
        with pytest.raises(InputError, match=r"scales is .*0.1 to 1 and 1 to 10"):
            dataclasses.replace(DRIVER, scales=scales)


def test_the_corners_of_an_iron_are_rounded_by_less_than_half_its_heel():
    assert reshaped(IRON, "rounding", "14.9 mm").shape["rounding"] == pytest.approx(0.0149)
    for value in ("15 mm", "15.1 mm"):
        with pytest.raises(InputError, match=f"shape.rounding is '{value}'.*half of heel_height"):
            reshaped(IRON, "rounding", value)
