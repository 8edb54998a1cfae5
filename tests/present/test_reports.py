"""Reports: one file that loads nothing, texts as they are, data with all digits, and where everything comes from."""

import csv
import html
import io
import re

import numpy as np
import pytest
from hypothesis import given, strategies as st

import clubface
from clubface.errors import InputError
from clubface.present.document import (
    Bullets,
    Data,
    DocumentPicture,
    Heading,
    Paragraph,
    TextTable,
    as_html,
    as_markdown,
    write_document,
)
from clubface.present.drawing import picture_data
from clubface.present.report import provenance_blocks
from clubface.simulation.provenance import provenance_of
from clubface.simulation.shot_result import shot_picture

NUMBERS = st.one_of(st.floats(allow_nan=False, allow_infinity=False), st.integers(-(10**9), 10**9))


@given(st.lists(st.tuples(NUMBERS, st.text(st.characters(codec="utf-8", exclude_characters="\r\x00"))), max_size=5))
def test_the_data_behind_a_table_come_back_with_every_digit(rows):
    text = Data("any", ("a (m)", 'b, "c"'), rows).as_csv()
    headings, *result = csv.reader(io.StringIO(text, newline=""))
    assert headings == ["a (m)", 'b, "c"']
    assert [(type(number)(each[0]), each[1]) for (number, _), each in zip(rows, result, strict=True)] == rows


def test_unknown_values_are_empty_cells():
    assert Data("any", ("a", "b"), [(None, float("nan"))]).as_csv() == "a,b\n,\n"


NASTY = "<script>alert('&')</script> | a"
PIECES = (
    Heading(1, NASTY), Paragraph((NASTY,)), Bullets((NASTY,)),
    TextTable((NASTY, "b"), [(NASTY, "1")], Data("x", ("a",), [(1.0,)])), DocumentPicture(NASTY, "<svg></svg>"),
)  # fmt: skip


def test_a_report_is_one_page_without_scripts_that_loads_nothing():
    page = as_html(PIECES)
    assert "<script" not in page
    assert (
        page.count("&lt;script&gt;") == 8
    )  # once in the title of the window, in three texts, twice in table and picture
    addresses = re.findall(r'(?:src|href|srcset)="([^"]*)"', page)
    assert len(addresses) == 3
    assert all(each.startswith("data:") for each in addresses)
    assert "<script" not in as_markdown(PIECES)
    assert r"\| a | 1 |" in as_markdown(PIECES)


def test_only_pages_and_markdown_are_written(tmp_path):
    with pytest.raises(InputError, match=r"ends in \.html or \.md"):
        write_document(PIECES, tmp_path / "report.pdf")
    assert not list(tmp_path.iterdir())


def test_the_end_of_a_report_has_inputs_versions_and_every_source():
    launch = clubface.impact("driver", {"speed": ["105 mph", "110 mph"], "attack": "-2 deg"}, model="slip")
    blocks = list(provenance_blocks(provenance_of([launch], {"air": "15 C"})))
    table = next(each for each in blocks if isinstance(each, TextTable))
    assert table.rows == [
        ("speed", "105 to 110 mph"),
        ("attack", "-2 deg"),
        ("loft", "9.8 deg"),
        ("air", "15 C"),
    ]
    texts = " ".join(text for each in blocks if isinstance(each, (Paragraph, Bullets)) for text in each.texts)
    assert f"clubface {clubface.__version__}" in texts
    assert "MASc thesis, University of Waterloo, 2023" in texts  # what the model slip calls Caldwell and McPhee (2023)
    assert "Roh" not in texts
    for source in (*launch.club.sources.values(), *launch.ball.sources.values(), launch.parameters.source):
        assert source in texts
    for caveat in launch.parameters.caveats:
        assert caveat in texts


def test_the_report_of_a_shot_has_the_numbers_of_the_shot(clubface_, tmp_path):
    target = tmp_path / "shot.html"
    ran = clubface_("shot", "7-iron", "--speed", "90 mph", "--face", "-3 deg", "--report", str(target))
    assert ran.status == 0
    assert ran.err == f"clubface: wrote {target}\n"
    page = target.read_text()
    launch = clubface.impact("7-iron", {"speed": "90 mph", "face": "-3 deg"})
    flight = clubface.fly(launch)
    words = re.sub(r"<[^>]+>", " ", page)
    assert f"leaves at {launch.get('ball_speed', 'mph'):.1f} mph" in words
    assert f"carries {flight.get('carry', 'yd'):.0f} yd" in words
    assert f"{-flight.get('side', 'yd'):.0f} yd left" in words


def test_the_flight_behind_the_picture_ends_where_the_ball_lands():
    path = clubface.trajectory(clubface.impact("driver", {"speed": 45.0}))
    headings, rows = picture_data(shot_picture({"response": path.position}))
    assert headings[:4] == ["panel", "mark", "x", "y"]
    side, above = (
        [row for row in rows if row[0].startswith(panel) and row[1] == "response"][-1]
        for panel in ("from the side", "from above")
    )
    end = np.asarray(path.position)[-1] / 0.9144
    assert (side[2], side[3], above[3]) == pytest.approx(tuple(end), rel=1e-12, abs=1e-12)


def test_a_report_of_another_kind_is_refused_before_any_work(clubface_, tmp_path):
    ran = clubface_("shot", "driver", "--speed", "90 mph", "--report", str(tmp_path / "shot.pdf"))
    assert ran.status == 2
    assert "--report" in ran.err
    assert ".html" in ran.err


@pytest.mark.parametrize(
    ("text", "links"),
    [
        ("after doi 10.3390/proceedings2020049047, Table 1", ["https://doi.org/10.3390/proceedings2020049047"]),
        ("(golfdigest.com/story/one, 2008).", ["https://golfdigest.com/story/one"]),
        ("see https://a.org/b?c=1&d=<x>.", ["https://a.org/b?c=1&amp;d="]),
        ("javascript:alert(1) and data:text/html,x", []),
        ("5 m/s of driver.com", []),
        ('https://a.org/"onclick="x', ["https://a.org/"]),
    ],
)
def test_addresses_of_sources_are_links_and_nothing_else_is(text, links):
    page = as_html([Heading(1, "t"), Bullets([text])])
    assert re.findall(r'<a href="([^"]*)">', page) == links
    assert re.sub(r"<[^>]+>", "", page.partition("<li>")[2].partition("</li>")[0]) == html.escape(text)


def printed(page):
    """Headings and rows of the tables of a page as paper shows them, with the size of their letters [pt]."""
    tables = []
    for around, style, body in re.findall(r'<div class="([^"]*)"[^>]*><table([^>]*)>(.*?)</table>', page, re.DOTALL):
        if "screen" not in around.split():
            size = re.search(r"--print:([\d.]+)pt", style)
            rows = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in re.findall(r"<tr>(.*?)</tr>", body)]
            tables.append((9.0 if size is None else float(size[1]), rows))
    return tables


@pytest.mark.parametrize("count", [1, 5, 10, 14, 40])
def test_a_table_of_any_width_is_printed_whole_and_legibly(count):
    columns = range(count)
    rows = [[f"{row - 9000.5 * k:.3f}" for k in columns] for row in range(3)]
    table = TextTable([f"quantity {k} (m/s)" for k in columns], rows)
    parts = printed(as_html([table]))
    assert parts
    # Together they hold every column once and in order, the first in each.
    assert all(rows[0][0] == "quantity 0 (m/s)" for _, rows in parts)
    for line, expected in enumerate([table.headings, *table.rows]):
        result = [expected[0], *(cell for _, rows in parts for cell in rows[line][1:])]
        assert result == list(expected)
    for size, rows in parts:
        assert 6.0 <= size <= 9.0
        # A4 is 210 mm wide with margins of 18 mm, 493 pt; digits of the widest usual type take 0.64 of their size.
        assert sum(max(map(len, column)) for column in zip(*rows[1:], strict=True)) * 0.64 * size < 493.0
    assert (len(parts) > 1) is (count > 13)


def test_numbers_are_never_broken_over_lines_and_long_words_are():
    page = as_html([TextTable(("file", "SHA-256", "bytes"), [("head.msh", "ab" * 32, "123456789")])])
    assert "td{white-space:nowrap}" in page
    assert re.findall(r"<td( class=\"text\")?>", page) == ["", ' class="text"', ""]
