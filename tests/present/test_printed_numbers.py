"""Every number that a report on a shot prints is the shot's own, in the unit that stands beside it."""

import csv
import io
import math
import re
from itertools import pairwise

import numpy as np
import pytest

import clubface
from clubface.present.document import (
    Bullets,
    Data,
    DocumentPicture,
    Heading,
    Paragraph,
    TextTable,
    as_html,
    as_markdown,
)
from clubface.present.report import provenance_blocks, report_blocks
from clubface.present.terminal import WIDEST, lay_out
from clubface.simulation.provenance import provenance_of
from clubface.simulation.shot_result import shot_result

# Exact by definition: the mile of 1609.344 m, the yard of 0.9144 m.
SIZES = {
    "mph": 1609.344 / 3600.0, "yd": 0.9144, "deg": math.pi / 180.0, "rpm": 2.0 * math.pi / 60.0, "µs": 1e-6,
    "kN": 1e3, "": 1.0,
}  # fmt: skip
PRINTED = {
    "ball_speed": ("mph", 1), "smash": ("", 3), "launch": ("deg", 1), "azimuth": ("deg", 1), "backspin": ("rpm", 0),
    "sidespin": ("rpm", 0), "total_spin": ("rpm", 0), "spin_axis": ("deg", 1), "carry": ("yd", 1), "side": ("yd", 1),
    "curve": ("yd", 1), "total": ("yd", 1), "apex": ("yd", 1), "landing_angle": ("deg", 1), "contact_time": ("µs", 0),
    "peak_force": ("kN", 1),
}  # fmt: skip
"""What fitters read these quantities in, and how many digits they can use."""


def shot(models=("response",), **delivery):
    launches = {
        name: clubface.impact("7-iron", {"speed": 40.0, "loft": 0.5, **delivery}, model=name) for name in models
    }
    flights = {name: clubface.fly(each) for name, each in launches.items()}
    places = {"response": np.asarray(clubface.trajectory(launches["response"]).position)}
    return launches, flights, list(report_blocks(shot_result(launches, flights, paths=lambda: (places, {}))))


def of_kind(blocks, kind):
    return [each for each in blocks if isinstance(each, kind)]


@pytest.fixture(scope="module")
def two():
    return shot(("response", "slip"), face="-3 deg")


def face_of_the_target():
    """The face angle whose shot lands on the line, by a secant; the CG of an iron lies beside its face centre."""
    ends = [
        float(clubface.fly(clubface.impact("7-iron", speed=40.0, loft=0.5, face=face)).side)
        for face in (0.0, SIZES["deg"])
    ]
    return ends[0] / (ends[0] - ends[1]) * SIZES["deg"]


@pytest.mark.parametrize("place", ["left", "on the target line", "right"])
def test_every_number_of_the_words(place):
    face = {"left": "-3 deg", "on the target line": face_of_the_target(), "right": "3 deg"}[place]
    launches, flights, blocks = shot(face=face)
    launch, flight = launches["response"], flights["response"]
    words = " ".join(of_kind(blocks, Paragraph)[0].texts).replace("7-iron", "club")
    wanted = [
        (launch.delivery["speed"], "mph", 1), (launch.delivery["loft"], "deg", 1), (launch.ball_speed, "mph", 1),
        (launch.launch, "deg", 1), (launch.total_spin, "rpm", 0), (flight.carry, "yd", 0), (flight.apex, "yd", 0),
        (flight.landing_angle, "deg", 0), (abs(launch.azimuth), "deg", 1),
        *([] if place == "on the target line" else [(abs(flight.curve), "yd", 0), (abs(flight.side), "yd", 0)]),
    ]  # fmt: skip
    assert re.findall(r"(\d+(?:\.\d+)?) (mph|deg|rpm|yd)", words) == [
        (f"{value / SIZES[unit]:.{digits}f}", unit) for value, unit, digits in wanted
    ]
    assert place in words


class Offline:
    """A flight that ends a stated way off the line."""

    def __init__(self, flight, yards):
        self._flight, self.side = flight, yards * 0.9144

    def __getattr__(self, name):
        return getattr(self._flight, name)


@pytest.mark.parametrize(
    ("yards", "place"),
    [(0.49, "on the target line"), (-0.49, "on the target line"), (0.51, "1 yd right"), (-0.51, "1 yd left")],
)
def test_a_side_that_rounds_to_zero_is_on_the_target_line(two, yards, place):
    launches, flights, _ = two
    moved = {name: Offline(each, yards) for name, each in flights.items()}
    assert place in shot_result(launches, moved).summary[3].sentence


def test_every_number_of_the_table(two):
    launches, flights, blocks = two
    table = of_kind(blocks, TextTable)[0]
    assert [row[0] for row in table.rows] == ["response", "slip"]
    hidden = ("total_spin", "total", "apex", "landing_angle")
    printed = {name: each for name, each in PRINTED.items() if name not in hidden}
    for model, row in zip(launches, table.rows, strict=True):
        for heading, cell, (name, (unit, digits)) in zip(table.headings[1:], row[1:], printed.items(), strict=True):
            assert heading.endswith(f"({unit})") or not unit
            si = float(getattr(launches[model] if hasattr(launches[model], name) else flights[model], name))
            assert cell == ("" if math.isnan(si) else f"{si / SIZES[unit]:.{digits}f}")
    # The model slip has no contact that lasts; nothing else is missing.
    assert [place for place, cell in enumerate(table.rows[1]) if not cell] == [11, 12]
    assert not any(cell == "" for cell in table.rows[0])


def test_headings_stand_one_below_the_other(two):
    levels = [each.level for each in of_kind(two[2], Heading)]
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(later - before <= 1 for before, later in pairwise(levels))
    launch = clubface.impact("driver", {"speed": 48.0}, model="standard")
    with_caveats = of_kind(provenance_blocks(provenance_of([launch])), Heading)
    assert [(each.level, each.text) for each in with_caveats] == [
        (2, "How this was computed"), (3, "Sources"), (3, "What to keep in mind")
    ]  # fmt: skip


def test_inputs_that_were_not_given_are_not_listed(two):
    inputs = of_kind(two[2], TextTable)[1]
    assert [row[0] for row in inputs.rows] == ["speed", "loft", "face", "air", "wind", "ground"]
    assert inputs.data.rows == inputs.rows


BLOCKS = (
    Heading(1, "Title"), Heading(3, "Below"), Paragraph(("One.", "Two.")), Bullets(("first", "second")),
    TextTable(("a", "b", "c"), [("1", "2", "3")], Data("behind", ("a",), [(1.0,)])), TextTable(("d",), [("4",)]),
    DocumentPicture("What it Shows: 3", "<svg></svg>"),
    DocumentPicture("Other", "<svg></svg>", Data("named", ("e",), [(5.0,)])),
)  # fmt: skip


def test_each_piece_is_written_as_what_it_is():
    page = as_html(BLOCKS)
    assert "<title>Title</title>" in page
    for piece in ("<h1>Title</h1>", "<h3>Below</h3>", "<p>One. Two.</p>", "<ul><li>first</li><li>second</li></ul>"):
        assert piece in page
    heads = "".join(f'<th scope="col">{name}</th>' for name in "abc")
    assert page.count(f"<thead><tr>{heads}</tr></thead>") == 1
    assert page.count("<tbody><tr><td>1</td><td>2</td><td>3</td></tr></tbody>") == 1
    saved = re.findall(r'download="([^"]*)" href="data:([^;]*)', page)
    assert saved == [
        ("behind.csv", "text/csv"), ("what-it-shows-3.svg", "image/svg+xml"), ("named.svg", "image/svg+xml"),
        ("named.csv", "text/csv"),
    ]  # fmt: skip
    text = as_markdown(BLOCKS)
    assert text.startswith(
        "# Title\n\n### Below\n\nOne. Two.\n\n* first\n* second\n\n| a | b | c |\n| --- | ---: | ---: |\n| 1 | 2 | 3 |"
    )
    assert text.endswith("\n")
    assert "![Other](data:image/svg+xml;base64," in text


def test_only_what_is_missing_is_an_empty_cell():
    rows = [("a", 0.0, 0, ""), (None, float("nan"), -1.5, "b")]
    assert list(csv.reader(io.StringIO(Data("any", tuple("wxyz"), rows).as_csv()))) == [
        ["w", "x", "y", "z"], ["a", "0.0", "0", ""], ["", "", "-1.5", "b"]
    ]  # fmt: skip


def test_a_long_cell_of_words_is_wrapped_in_a_file_too():
    formula = " + ".join(f"{place} speed" for place in range(100))
    lines = lay_out(["function", "formula"], [["lever", formula], ["peak", "1"]], texts={1})
    assert max(map(len, lines)) <= WIDEST + len("function") + 2
    assert " ".join(" ".join(lines).split()).count("speed") == 100
    # A row of a file stays in one line where its cells are short, however many there are.
    wide = lay_out([f"column {place}" for place in range(40)], [["a short cell"] * 40], texts=set(range(40)))
    assert len(wide) == 3
