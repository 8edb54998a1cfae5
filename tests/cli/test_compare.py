"""``clubface compare``: its tables, its JSON, its file and its mistakes."""

import csv

import pytest

import clubface
from command_line import assert_mistake

SHOT = ["--speed", "105 mph", "--attack", "3 deg", "--loft", "13 deg", "--toe", "20 mm"]
DRIVE = {"speed": "105 mph", "attack": "3 deg", "loft": "13 deg", "toe": "20 mm"}


@pytest.fixture
def heavier(tmp_path):
    path = tmp_path / "heavier.toml"
    path.write_text(clubface.club("driver").replace(name="heavier", mass="212 g").to_toml())
    return str(path)


def rows(ran, name="alternatives"):
    """The rows of a table of the JSON."""
    return ran.json["tables"][name]["rows"]


def numbers(out, start):
    """The cells of the row that begins so, from the first table that has one."""
    line = next(line for line in out.splitlines() if line.startswith(start))
    return [float(each) for each in line[len(start) :].split()]


def test_two_clubs_stand_side_by_side_with_what_makes_the_difference(clubface_, heavier):
    ran = clubface_("compare", "driver", heavier, *SHOT)
    assert ran.status == 0
    shots = [clubface.fly(clubface.impact(each, DRIVE)).get("carry", "yd") for each in ("driver", heavier)]
    first, second = numbers(ran.out, "carry, yd")
    (difference,) = numbers(ran.out.partition("differences")[2], "carry, yd")
    assert [first, second] == [pytest.approx(each, abs=0.051) for each in shots]
    assert difference == pytest.approx(shots[1] - shots[0], abs=0.0051)
    split = ran.out.partition("change of")[2]
    row, rest, whole = (numbers(split, each) for each in ("clubhead mass  g", "remainder", "difference"))
    assert row[:2] == [204.0, 212.0]
    assert row[6] == whole[4] == pytest.approx(difference, abs=0.011)
    assert set(rest) == {0.0}


def test_every_combination_of_what_is_given_twice_is_named_by_what_differs(clubface_, heavier):
    ran = clubface_(
        "compare", "driver", heavier, *SHOT, "--ball", "modern", "--ball", "distance", "--no-split", "--json"
    )
    assert [each["alternative"] for each in rows(ran)] == [
        "driver, modern", "driver, distance", "heavier, modern", "heavier, distance",
    ]  # fmt: skip
    assert {each["compared_with"] for each in rows(ran, "differences")} == {"driver, modern"}
    models = clubface_("compare", "driver", *SHOT, "--model", "response,standard", "--json")
    assert [each["model"] for each in rows(models)] == ["response", "standard"]
    first = rows(models, "contributions")[0]
    assert (first["change"], first["from"]) == ("model", None)


def test_json_holds_values_differences_and_contributions_that_add_up(clubface_, heavier):
    ran = clubface_("compare", "driver", heavier, *SHOT, "--json")
    (first, second), (difference,), split = (
        rows(ran, name) for name in ("alternatives", "differences", "contributions")
    )
    for key in ("ball_speed_mps", "carry_m", "backspin_rpm"):
        assert difference[key] == pytest.approx(second[key] - first[key], rel=1e-9)
        added = sum(each[key] for each in split if each["part"] in ("contribution", "remainder"))
        assert added == pytest.approx(difference[key], rel=1e-9)
    assert (split[0]["from"], split[0]["unit"]) == (pytest.approx(204.0), "g")
    assert {each["code"] for each in ran.json["notes"]} == {"comparison-shape"}


def test_labels_are_kept_in_tables_words_pictures_and_json(clubface_, heavier, tmp_path):
    labels = ["before", "after: the lesson"]
    arguments = ("compare", "driver", heavier, *SHOT, *(word for each in labels for word in ("--label", each)))
    ran = clubface_(*arguments, "--json", "-o", str(tmp_path / "all.csv"), "--report", str(tmp_path / "report.md"))
    assert [each["alternative"] for each in rows(ran)] == labels
    assert [each["club"] for each in rows(ran)] == ["driver", "heavier"]
    assert [each["name"] for each in ran.notes("comparison-shape")] == labels
    assert {each["alternative"] for each in rows(ran, "contributions")} == {labels[1]}
    with (tmp_path / "all.csv").open() as file:
        assert {each["alternative"] for each in csv.DictReader(file)} == set(labels)
    report = (tmp_path / "report.md").read_text()
    assert report.startswith('# "before" compared with "after: the lesson"')
    compared = clubface.compare({each: {"club": "driver", "delivery": DRIVE} for each in labels})
    drawn = {mark.label for panel in compared.to_result().pictures()[0].panels() for mark in panel.marks}
    assert {f"{each}: push draw" for each in labels} <= drawn


def test_a_set_of_parameters_and_a_setting_are_compared_and_shared(clubface_):
    sets = ["three-dimensional-impact-models", "penner"]
    given = [each for name in sets for each in ("--parameters", name)]
    ran = clubface_("compare", "driver", *SHOT, "--model", "standard", *given, "--json")
    assert ran.status == 0, ran.err
    assert [each["parameters"] for each in rows(ran)] == sets
    ran = clubface_("compare", "driver", "3-wood", *SHOT, "--set", "friction=0.3", "--json")
    assert ran.status == 0, ran.err
    changed = [each["change"] for each in rows(ran, "contributions")]
    assert "club_mass" in changed
    assert "friction" not in changed


def test_deliveries_come_from_options_or_from_rows(clubface_, write):
    common = ["compare", "driver", "--speed", "105 mph"]
    ran = clubface_(*common, "--delivery", "loft=10 deg", "--delivery", "loft=14 deg", "--json")
    low, high = rows(ran)
    assert (low["alternative"], high["alternative"]) == ("loft=10 deg", "loft=14 deg")
    assert [each["change"] for each in rows(ran, "contributions") if each["part"] == "contribution"] == ["loft"]
    path = write("name,loft_deg\nlow,10\nhigh,14\n", "d.csv")
    read = rows(clubface_(*common, "--deliveries", str(path), "--json"))
    assert [each["alternative"] for each in read] == ["low", "high"]
    assert read[1]["carry_m"] == pytest.approx(high["carry_m"], rel=1e-12)


def test_the_table_is_in_the_units_asked_for(clubface_, heavier):
    yards = clubface_("compare", "driver", heavier, *SHOT)
    metres = clubface_("compare", "driver", heavier, *SHOT, "--unit", "carry=m", "--unit", "ball_speed=m/s")
    assert numbers(metres.out, "carry, m")[0] == pytest.approx(0.9144 * numbers(yards.out, "carry, yd")[0], abs=0.1)
    speeds = [numbers(each.out, f"ball speed, {unit}")[0] for each, unit in ((metres, "m/s"), (yards, "mph"))]
    assert speeds[0] == pytest.approx(0.44704 * speeds[1], abs=0.1)


def test_file_and_picture_are_written(clubface_, heavier, tmp_path):
    pytest.importorskip("matplotlib")
    table, picture = tmp_path / "all.csv", tmp_path / "all.svg"
    ran = clubface_("compare", "driver", heavier, "3-wood", *SHOT, "-o", str(table), "--plot", str(picture))
    assert ran.status == 0, ran.err
    with table.open() as file:
        figures = list(csv.DictReader(file))
    assert figures[0]["alternative"] == "driver"
    assert {row["part"] for row in figures} == {"value", "difference", "contribution", "remainder"}
    mine = [row for row in figures if row["alternative"] == "3-wood"]
    added = sum(float(row["carry_m"]) for row in mine if row["part"] in ("contribution", "remainder"))
    assert added == pytest.approx(float(next(row for row in mine if row["part"] == "difference")["carry_m"]))
    assert picture.read_text().startswith("<?xml")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["driver"], ["nothing to compare", "--ball modern --ball distance"]),
        (["driver", "driver"], ["driver", "given once"]),
        (["driver", "drivr"], ["did you mean driver"]),
        (["driver", "3-wood", "--unit", "carry=kg"], ["--unit", "kg", "yd"]),
        (["driver", "3-wood", "--unit", "cary=m"], ["did you mean carry"]),
        (["driver", "3-wood", "--nodes", "0"], ["--nodes", "1 to 64"]),
        (["driver", "--delivery", "lofft=3 deg", "--delivery", "loft=4 deg"], ["did you mean loft"]),
        (["driver", "--delivery", "loft=4 deg", "--delivery", "loft=4 deg"], ["--delivery", "given once"]),
        (["driver", "--delivery", "loft=4 deg", "--deliveries", "none.csv"], ["give one of them"]),
        (["driver", "--deliveries", "none.csv"], ["none.csv"]),
        (["driver", "3-wood", "-o", "a.txt"], ["--output", ".csv"]),
        (["driver", "3-wood", "--set", "frictoin=1"], ["did you mean friction"]),
        (["driver", "3-wood", "--parameters", "penner"], ["penner", "--model standard"]),
        (["driver", "3-wood", "--toe", "90 mm"], ["--toe", "90"]),
        (["driver", "3-wood", "--ball", "x"], ["ball"]),
        (["driver", "3-wood", "--label", "mine"], ["--label", "given 2 times", "driver; 3-wood"]),
        (["driver", "3-wood", "--label", "mine", "--label", "mine"], ["--label", "given once"]),
        (["driver", "3-wood", "--label", "mine", "--label", ""], ["--label", "not empty"]),
        (["driver", "3-wood", "--nodes", "5", "--no-split"], ["--nodes", "--no-split"]),
        (["driver", "3-wood", "--json", "--unit", "carry=m"], ["--unit", "--json"]),
        (["driver", "3-wood", "--accuracy", "1e-6"], ["--accuracy", "leave it out", "volumetric"]),
        (["driver", "3-wood", "--air", "humidity=0.1, humidity=0.2"], ["--air", "given once"]),
        (["driver", "--delivery", "loft=4 deg", "--delivery", "loft=4deg"], ["--delivery", "given once"]),
        (["driver", "--delivery", "loft=4 deg, loft=5 deg", "--delivery", "toe=0 mm"], ["--delivery", "given once"]),
        (["driver", "--delivery", "speed=45 m/s", "--delivery", "speed=46 m/s"], ["--speed has no effect"]),
        (["driver", "3-wood", "5-wood", "--model", "all", "--ball", "modern", "--ball", "distance"], ["at most 24"]),
    ],
)
def test_a_mistake_is_one_message(clubface_, arguments, words):
    assert_mistake(clubface_("compare", *arguments, "--speed", "105 mph"), *words)


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        ("centre,100,0\nheel,100,-90\n", ["--toe of heel: ", "outside the face"]),
        ('centre,100,0\n"a\nb",100,1\n', [":3: the name 'a\\nb' is not printable text"]),
    ],
)
def test_a_row_that_cannot_be_struck_is_named(clubface_, write, rows, words):
    file = str(write(f"name,speed_mph,toe_mm\n{rows}", "swings.csv"))
    assert_mistake(clubface_("compare", "driver", "--deliveries", file), *words)


def test_an_option_that_every_row_sets_is_refused(clubface_, write):
    file = str(write("speed_mph,loft_deg\n100,12\n101,13\n"))
    assert_mistake(
        clubface_("compare", "driver", "--deliveries", file, "--loft", "10 deg"), "--loft has no effect", file
    )
    assert clubface_("compare", "driver", "--deliveries", file, "--toe", "5 mm", "--no-split").status == 0


def test_a_column_that_is_nearly_an_input_is_remarked_on(clubface_, write):
    file = str(write("speed_mph,lofft_deg\n100,12\n101,13\n"))
    message = clubface_("compare", "driver", "--deliveries", file, "--no-split").err
    assert "the column lofft_deg is not used; did you mean loft?" in message


def test_the_speed_must_be_given(clubface_):
    assert_mistake(clubface_("compare", "driver", "3-wood"), "--speed is missing")


def test_equal_clubs_are_noted(clubface_, tmp_path):
    same = tmp_path / "same.toml"
    assert clubface_("club", "new", "same", "-o", str(same)).status == 0
    ran = clubface_("compare", "driver", str(same), "--speed", "105 mph", "--json")
    notes = [(each["code"], each["data"]) for each in ran.json["notes"]]
    assert ("comparison-same", {"name": "same", "first": "driver"}) in notes
    assert "remainder" not in ran.out
