"""Pictures of comparisons and face maps: what they show, in which units, and that their labels are apart."""

import numpy as np
import pytest

import clubface

pytest.importorskip("matplotlib")

from matplotlib.backends.backend_agg import FigureCanvasAgg

from clubface.design.comparison import comparison_picture
from clubface.design.face_map_result import LISTED, face_map_picture
from clubface.present.drawing import draw

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

DRIVE = {"speed": "105 mph", "attack": "3 deg", "loft": "13 deg"}


def panels(figure):
    FigureCanvasAgg(figure).draw()
    return [axes for axes in figure.axes if axes.get_title(loc="left")]


def assert_apart(figure):
    boxes = [axes.get_tightbbox() for axes in panels(figure)]
    for place, box in enumerate(boxes):
        assert figure.bbox.padded(2.0).contains(box.x0, box.y0)
        assert figure.bbox.padded(2.0).contains(box.x1, box.y1)
        assert not any(box.overlaps(other) for other in boxes[place + 1 :])


def test_a_comparison_shows_flights_and_the_largest_contributions():
    swing = {**DRIVE, "toe": "12 mm"}
    clubs = ("driver", "3-wood")
    compared = clubface.compare({name: {"club": name, "delivery": swing} for name in clubs})
    picture = comparison_picture(compared)
    assert_apart(draw(picture, {"carry": "m"}))
    (side,), (above,), bars = picture.rows
    for mark, name in zip(side.marks, clubs, strict=True):
        assert mark.x[-1] == pytest.approx(compared.value(name, "carry"), rel=0.01)
    assert [mark.kind for mark in above.marks].count("line") == 2 * len(clubs)  # flights, and the lines of their starts
    assert bars[0].y.names[-2:] == ["remainder", "difference"]
    *parts, difference = next(panel for panel in bars if panel.title == "carry").marks[0].x
    assert difference == pytest.approx(compared.difference("3-wood", "carry"), rel=1e-12)
    assert sum(parts) == pytest.approx(difference, rel=1e-9)


def test_a_comparison_without_contributions_shows_the_flights_alone():
    sides = {name: {"club": name, "delivery": DRIVE} for name in ("driver", "3-wood")}
    titles = [panel.title for panel in comparison_picture(clubface.compare(sides, split=False)).panels()]
    assert titles == ["from the side, to scale", "from above, to scale"]


@pytest.fixture(scope="module")
def driver():
    return clubface.map_face("driver", DRIVE, grid=(31, 17))


def test_a_map_has_a_panel_for_each_quantity_with_centre_and_sweet_spot(driver):
    picture = face_map_picture(driver)
    figure = draw(picture)
    assert_apart(figure)
    assert [panel.values.quantity.name for panel in picture.panels()] == list(LISTED)
    levels, speeds = panels(figure)[0].collections[0].levels, driver.get("ball_speed", "mph")
    assert levels[0] <= np.nanmin(speeds) < levels[1]
    assert levels[-2] < np.nanmax(speeds) <= levels[-1]
    best = driver.best()
    for panel in picture.panels():
        _, outline, centre, spot = panel.marks
        assert (*centre.x, *centre.y) == (0.0, 0.0)
        assert (*spot.x, *spot.y) == (best.toe, best.high)
        np.testing.assert_allclose([np.ptp(outline.x), np.ptp(outline.y)], [0.105, 0.055], rtol=1e-6)
    assert "assumed: an ellipse" in picture.title


def test_a_difference_of_two_faces_is_drawn_with_zero_in_the_middle_of_its_colours(driver):
    other = clubface.map_face(clubface.club("driver").replace(mass="210 g"), DRIVE, points=(driver.toe, driver.high))
    picture = face_map_picture(clubface.FaceMapDifference(other, driver), ["carry"])
    (axes,) = panels(draw(picture, {"carry": "m"}))
    filled = axes.collections[0]
    assert filled.norm.vmin == -filled.norm.vmax
    assert "less driver" in picture.title


def test_a_map_that_is_the_same_everywhere_can_be_drawn(driver):
    change = clubface.FaceMapDifference(driver, driver)
    assert len(panels(draw(face_map_picture(change, ["carry", "side", "smash"])))) == 3
