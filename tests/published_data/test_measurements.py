"""The published figures: every file is complete, and says what its source says."""

import re
import tomllib
from pathlib import Path

import numpy as np
import pytest

from clubface import published_data, units
from clubface.errors import FileError, InputError, UnitError, UnknownNameError

FOLDER = Path(published_data.__file__).parent / "data" / "measurements"
PAGE = Path(__file__).parents[2] / "docs" / "measurements.md"


def test_every_subject_is_on_the_page():
    shown = re.findall(r"^```\{published-tables\} (\S+)$", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(shown) == sorted(published_data.subjects())


def test_no_two_tables_have_one_name_and_no_file_is_left_over():
    assert len(set(published_data.names())) == len(published_data.names())
    entries = [entry for path in FOLDER.glob("*.toml") for entry in tomllib.loads(path.read_text())["table"]]
    assert {entry["file"] for entry in entries if "file" in entry} == {path.name for path in FOLDER.glob("*.csv")}


@pytest.mark.parametrize("name", published_data.names())
def test_a_table_is_whole_and_tells_its_source(name):
    table = published_data.table(name)
    assert {len(column) for column in table.columns.values()} == {len(table)} != {0}
    for column, unit in table.units.items():
        assert table[column].dtype == np.float64
        assert units.unit(unit).symbol == unit
        assert np.isfinite(table[column]).any()
        assert not np.isinf(table[column]).any()
    # Who and when, then what: "TrackMan (2019), PGA Tour averages, ..."
    assert re.match(r"[^(]+ \((\d{4}|undated)\), \w", table.source)


FIGURES = [  # Typed again by hand from the sources as quoted: table, row, column, unit, value.
    ("dynamic-lofts", 3, "dynamic_loft", "deg", 23.6),  # LPGA Tour, 6-iron
    ("dynamic-lofts", 12, "dynamic_loft", "deg", 16.5),  # women of handicap 15
    ("drives-of-21-golfers", 0, "backspin", "rpm", 2383),
    ("plate-cor-1994", 1, "restitution", "1", 0.72),  # Lieberman and Johnson, 50 m/s
    ("plate-cor-three-piece", 0, "speed", "ft/s", 143),  # US 6,932,721: above 0.8015 at 143 ft/s ...
    ("plate-cor-three-piece", 0, "speed", "m/s", 43.5864),  # ... which is 143 times 0.3048 m/s
    ("plate-cor-reduced-distance", 0, "restitution_most", "%", 79),
    ("plate-contact-time-claim", 0, "contact_time_least", "us", 400),
    ("drop-cor-titleist", 1, "restitution", "1", 0.907),  # Pro V1
    ("optimum-trackman-2010", 28, "dynamic_loft", "deg", 11.0),  # carry, 120 mph, 0 degrees
    ("optimum-trackman-2010", 59, "spin", "rpm", 1636),  # total, 120 mph, 5 degrees
    ("optimum-ping-2019", 5, "launch", "deg", 10.4),  # 180 mph, 0 degrees
    ("launch-share-range", 0, "share_most", "%", 83),
    ("launch-shares-vertical", 1, "share", "%", 81),  # PING 2020, 7-iron
    ("launch-shares-trackman", 2, "share", "%", 70),  # pitching wedge
    ("launch-shares-horizontal", 1, "spread", "%", 3),  # PING 2018, 7-iron
    ("standard-shots-trackman", 1, "spin", "rpm", 5956),  # 6-iron
    ("drives-by-handicap", 3, "ball_speed", "mph", 133),  # male average
    ("curvature-trackman", 1, "curve", "yd", 44),  # PGA Tour driver, 5 degrees open
    ("head-after-impact", 0, "steeper_most", "deg", 6),
    ("spin-peak", 0, "spin_loft_still_gripping", "deg", 53.2),
    ("robot-7-irons-2026", 0, "spin", "rpm", 4429),  # PING i540
    ("robot-7-irons-2026", 25, "dynamic_loft", "deg", 29.3),  # Wilson Staff Model CB
    ("robot-7-irons-launch-2026", 5, "spin", "rpm", 6007),  # Wilson Staff CB
    ("robot-wedge-covers-2025", 2, "launch", "deg", 36.5),
    ("driver-toe-hits-2011", 0, "ball_speed_share", "%", 98),
    ("driver-height-2014", 0, "spin_change", "rpm", -800),
    ("strike-offsets-trackman", 1, "spin_axis", "deg", 20),
    ("gear-effect-2016", 0, "sidespin_added", "rpm", 40.1),
    ("plate-granite-2002", 0, "restitution", "1", 0.9),
    ("tangential-restitution", 0, "restitution_most", "1", 0.3),
    ("head-without-spring", 0, "restitution_least", "1", 0.768),
    ("drive-contact-time", 0, "contact_time_most", "us", 500),
    ("head-danaei-2020", 0, "iyy", "g cm2", 5679),
    ("heads-irons-2022-2026", 0, "inertia_vertical", "g cm2", 2830),  # Maltby M980 ...
    ("heads-irons-2022-2026", 0, "cg_height", "in", 0.72),  # ... 0.779 less 0.059 inches
    ("heads-means-drivers", 2, "inertia_vertical", "g cm2", 4500),  # 2020
    ("heads-means-cg", 0, "height", "mm", 31),  # drivers
    ("head-hybrid-2009", 0, "mass", "g", 242.6),
    ("ball-limits", 0, "mass_most", "g", 45.93),
    ("head-inertia-limit", 0, "inertia_most", "g cm2", 5900),
    ("head-volume-limit", 0, "volume_most", "cm3", 460),
    ("head-dimension-limits", 0, "sole_to_crown_most", "in", 2.8),
    ("spring-effect-limit", 0, "characteristic_time_most", "us", 239),
    ("strokes-to-hole-out", 9, "tee", "1", 2.92),  # 100 yards
    ("putts-to-hole-out", 6, "putts", "1", 1.50),  # 8 feet
]


@pytest.mark.parametrize(("name", "row", "column", "unit", "value"), FIGURES)
def test_figures_are_those_of_the_source(name, row, column, unit, value):
    # Converting to SI and back rounds in the last digits.
    assert published_data.table(name).get(column, unit)[row] == pytest.approx(value, rel=1e-12)


def test_the_driver_of_trackman_launches_near_its_dynamic_loft_at_every_speed():
    """Shares of the way from path to face of 0.845 to 0.856 at the mean of each speed: a mistyped cell leaves them."""
    optimum = published_data.table("optimum-trackman-2010")
    shares = (optimum["launch"] - optimum["attack"]) / (optimum["dynamic_loft"] - optimum["attack"])
    for speed in np.unique(optimum["club_speed"]):
        assert 0.83 < shares[optimum["club_speed"] == speed].mean() < 0.87


@pytest.mark.parametrize(
    ("name", "sums"),
    [
        ("pga-2019", (1148, -43.8, 1607, 166.3, 69232)),
        ("lpga-2019", (886, -19.9, 1243, 184.8, 60519)),
        ("pga-2023", (1173, -37.7, 1645, 164.2, 69098)),
        ("lpga-2023", (908, -19.2, 1267, 183.6, 59516)),
    ],
)
def test_averages_of_tours_have_the_sums_of_another_transcription(name, sums):
    """Club speed, attack, ball speed, launch and spin summed over clubs elsewhere: a mistyped cell shows."""
    table = published_data.table(name)
    columns = {"club_speed": "mph", "attack": "deg", "ball_speed": "mph", "launch": "deg", "spin": "rpm"}
    result = [table.get(column, unit).sum() for column, unit in columns.items()]
    assert result == pytest.approx(sums, rel=1e-12)


def test_the_robots_irons_have_the_sums_of_the_transcription():
    """Dynamic loft, spin, carry, landing angle and apex summed over 26 heads: a mistyped cell shows."""
    table = published_data.table("robot-7-irons-2026")
    columns = {"dynamic_loft": "deg", "spin": "rpm", "carry": "yd", "landing_angle": "deg", "apex": "ft"}
    result = [table.get(column, unit).sum() for column, unit in columns.items()]
    assert result == pytest.approx([662.4, 140516, 3953.1, 1170.7, 2181.0], rel=1e-12)


def test_an_unknown_table_or_column_names_the_nearest():
    with pytest.raises(UnknownNameError, match="pga-2019"):
        published_data.table("pga-2018")
    averages = published_data.table("pga-2019")
    with pytest.raises(UnknownNameError, match="ball_speed"):
        averages["ballspeed"]
    with pytest.raises(InputError, match="one of numbers"):
        averages.get("club", "mph")
    with pytest.raises(UnitError, match="mph"):
        averages.get("ball_speed", "deg")
    with pytest.raises(ValueError, match="read-only"):
        averages["ball_speed"][0] = 0.0


WHOLE = """[[table]]
name = "cor"
title = "Restitution"
kind = "measured"
source = "A. Author (2001), Balls, Journal 1, 2-3"
conditions = "A plate."
columns = ["ball", "speed [mph]"]
rows = [["x", 90], ["y", nan]]
"""


def test_a_whole_file_is_read(write):
    (table,) = published_data.read(write(WHOLE, "x.toml")).values()
    assert table["speed"][0] == pytest.approx(40.2336, rel=1e-12)  # 90 times 0.44704
    assert np.isnan(table["speed"][1])


@pytest.mark.parametrize(
    ("whole", "planted", "message"),
    [
        ('["y", nan]', '["y"]', r"x\.toml:8: table cor: row 2 is \['y'\]; it must be 2 cells"),
        ('["y", nan]', '["y", "fast"]', "x.toml:8: table cor: speed in row 2 is 'fast'; it must be a number in mph"),
        ('["y", nan]', "[3, nan]", "ball in row 2 is 3; it must be words"),
        ('["y", nan]', '["", nan]', "ball in row 2 is ''"),
        ('[["x", 90], ["y", nan]]', "[]", "at least one row"),
        ("[mph]", "[mhp]", "'mhp'.*did you mean mph"),
        ("speed [mph]", "ball", "column is 'ball'"),
        ('conditions = "A plate."', "", r"x\.toml:1: these keys of \[table\] are missing: conditions"),
        ('"A plate."', '" "', "x.toml:6: conditions of cor is .*not empty"),
        ('"A plate."', "2", "conditions of cor is 2; it must be text"),
        ('kind = "measured"', 'kind = "mesured"', "x.toml:4: unknown kind of cor 'mesured'.*did you mean measured"),
        ("conditions", "condition", "unknown key 'condition'.*did you mean conditions"),
        (
            'columns = ["ball", "speed [mph]"]\nrows = [["x", 90], ["y", nan]]',
            'file = "no.csv"',
            "no.csv: table cor: .*No such file",
        ),
    ],
)
def test_a_planted_error_is_found_with_its_line(write, whole, planted, message):
    assert WHOLE.count(whole) == 1
    with pytest.raises(FileError, match=message):
        published_data.read(write(WHOLE.replace(whole, planted), "x.toml"))


@pytest.mark.parametrize(
    ("rows", "message"),
    [("x,90,1", "it must be 2 cells"), ("x", "it must be 2 cells"), ("x,fast", "a number in mph"), (",90", "ball in")],
)
def test_a_planted_error_in_a_csv_file_is_found(write, rows, message):
    write(f"ball,speed [mph]\nz,80\n{rows}\n", "x.csv")
    text = WHOLE.replace('columns = ["ball", "speed [mph]"]\nrows = [["x", 90], ["y", nan]]', 'file = "x.csv"')
    with pytest.raises(FileError, match=rf"x\.csv: table cor: .*{message}"):
        published_data.read(write(text, "x.toml"))


def test_a_second_table_of_one_name_is_found(write):
    with pytest.raises(FileError, match=r"x\.toml:11: name of cor is 'cor'"):
        published_data.read(write(f"{WHOLE}\n{WHOLE}", "x.toml"))


def test_lofts_that_trackman_computed_from_the_ball_are_marked_wherever_their_spin_stands_beside_them():
    # I w / (m R v sin(loft - launch)) of the rows, with I = 0.400 m R^2 and R = 21.3 mm: the ratio that the text names.
    for name, least, most in (
        ("standard-shots-trackman", 1.12, 1.16),
        ("drives-by-handicap", 1.12, 1.25),
        ("optimum-trackman-2010", 1.03, 1.20),
    ):  # fmt: skip
        table = published_data.table(name)
        along = table["ball_speed"] * np.sin(table["dynamic_loft"] - table["launch"])
        ratios = 0.400 * 0.0213 * table["spin"] / along
        assert ((ratios > least) & (ratios < most)).all()
        assert set(table.derived) == {"dynamic_loft"}
    chart = published_data.table("optimum-trackman-2010").derived["dynamic_loft"]
    assert "1.123" in chart
    assert "0.026" in chart
    marked = {name for name in published_data.names() if published_data.table(name).derived}
    trackman = {
        name
        for name in published_data.names()
        if "dynamic_loft" in published_data.table(name).columns
        and published_data.table(name).source.startswith("TrackMan")
    }
    assert marked == trackman


@pytest.mark.parametrize("derived", ['{ loft = "so" }', '{ spin = "" }', '"spin"', "{ spin = 1 }"])
def test_a_mark_of_a_column_that_is_not_there_or_has_no_reason_is_refused(derived, tmp_path):
    path = tmp_path / "own.toml"
    path.write_text(
        '[[table]]\nname = "own"\ntitle = "Own"\nkind = "measured"\nsource = "A (2020), B"\nconditions = "None."\n'
        f'derived = {derived}\ncolumns = ["spin [rpm]"]\nrows = [[2500]]\n'
    )
    with pytest.raises(FileError, match="derived"):
        published_data.read(path)
