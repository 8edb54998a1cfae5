"""On a telephone the panels of a picture stand below each other, and all that is written on it fits."""

import re

import pytest

pytest.importorskip("matplotlib")

import itertools

from matplotlib.backends.backend_agg import FigureCanvasAgg

from clubface.present.document import as_html
from clubface.present.drawing import NARROW, draw, draw_narrow
from clubface.present.report import picture_blocks
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Result

NAMES = ("dynamic loft", "characteristic time", "remainder")
LINE = Mark("line", x=[0.0, 1.0], y=[0.0, 1.0], label="a long name of an alternative of the driver")
BARS = Mark("bars", x=[1.0, 2.0, 3.0], y=[0, 1, 2])
TITLE = (
    "Launch and flight of every alternative at a speed of 105 mph and a loft of 12 degrees at sea level in still air"
)


def picture(**options):
    high = Panel([LINE], axis("carry"), axis("apex"), tall=True)
    rows = [[high, Panel([LINE], axis("carry"), axis("side"), equal=True)], [None, Panel([LINE], axis("speed"))]]
    return Picture("test", "A picture", rows, title=TITLE, footnote=TITLE, **options)


def boxes(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return [each.get_window_extent() for each in figure.axes]


@pytest.mark.parametrize("legend", [False, True])
def test_panels_stand_below_each_other_and_every_letter_is_on_the_picture(legend):
    figure = draw_narrow(picture(legend=legend))
    panels = boxes(figure)
    assert len(panels) == 3
    for above, below in itertools.pairwise(panels):
        assert below.y1 < above.y0
    assert figure.get_figwidth() == NARROW
    edges = figure.get_tightbbox()  # inches; a hundredth is less than a letter's edge
    assert edges.x0 >= -0.01
    assert edges.x1 <= NARROW + 0.01
    assert all(each.width > 0.5 * figure.bbox.width for each in panels if each is not panels[1])


def test_a_panel_over_two_rows_is_as_high_as_before():
    wide, narrow = boxes(draw(picture())), boxes(draw_narrow(picture()))
    # Both leave room for titles and labels, which differ; a panel of one row would be half as high.
    assert narrow[0].height == pytest.approx(wide[0].height, rel=0.25)


@pytest.mark.parametrize(("own", "share_y"), [(Axis(), True), (Axis(ticks=False), False)])
def test_panels_that_shared_the_names_of_an_axis_have_them_each(own, share_y):
    panels = [Panel([BARS], y=Axis(names=NAMES)), Panel([BARS], y=own)]
    figure = draw_narrow(Picture("test", "A picture", [panels], share_y=share_y))
    boxes(figure)
    for each in figure.axes:
        assert [label.get_text() for label in each.get_yticklabels()] == list(NAMES)


def test_a_report_has_one_picture_for_screen_and_paper_and_one_for_telephones():
    result = Result("test", "A test", draw=lambda: [picture()])
    (block,) = picture_blocks(result)
    sizes = [float(re.search(r'width="([\d.]+)pt"', svg)[1]) / 72 for svg in (block.svg, block.narrow())]
    assert sizes == pytest.approx([7.2, NARROW], abs=0.01)
    page = as_html([block])
    assert page.count("image/svg+xml") == 3  # both pictures, and the file to save
    assert re.search(r'<source media="screen and \(max-width:\d+px\)" srcset="data:image/svg', page)


@pytest.mark.filterwarnings("error")
def test_flat_panels_to_scale_keep_room_for_their_titles_and_labels():
    """A straight drive from above is a hundredth as high as long; its title and label do not shrink with it."""
    flat = [Panel([LINE], axis("carry"), axis("side", limits=(-0.05, 0.05)), "to scale", equal=True)]
    rows = [flat, flat]
    figure = draw_narrow(Picture("flat", "Flat", rows, heights=[0.64, 0.77], height=3.3, legend=True, title=TITLE))
    assert all(each.height > 0.0 and each.width > 0.5 * figure.bbox.width for each in boxes(figure))
