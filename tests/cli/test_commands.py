"""The other commands: lists, clubs, sensitivities, flights, files, the tour."""

import csv
import math

import pytest

import clubface
from clubface import units
from command_line import assert_mistake

pytest.importorskip("typer")
pytest.importorskip("rich")

from clubface.cli.app import COMMANDS
from clubface.design.rules import check_result
from clubface.equipment.balls import ball_names


def test_every_command_has_help_and_says_json_where_it_computes(clubface_):
    for name in COMMANDS:
        ran = clubface_(name, "--help")
        assert ran.status == 0
        assert name in ran.out
        assert "--json" in ran.out or name in (
            "club",
            "golfer",
            "fem",
            "monitor",
            "capture",
            "study",
            "export",
            "schema",
            "studio",
        )  # those are groups, but the last two: one prints nothing else, one serves pages


@pytest.mark.parametrize(
    ("command", "own"), [("best-loft", "--club"), ("capture read", "--target"), ("validate", "--check")]
)
def test_help_lists_what_is_computed_before_where_it_is_written(clubface_, command, own):
    words = clubface_(*command.split(), "--help").out.split()
    assert words.index(own) < words.index("--output") < words.index("--json")


def test_models_lists_the_registry(clubface_):
    assert [row["model"] for row in clubface_("models", "--json").rows()] == list(clubface.models())
    assert "jorgensen" in clubface_("models").out
    assert "with area_damping = 0 also energy, friction cone" in " ".join(clubface_("models", "area").out.split())


def test_a_model_is_shown_with_units_bounds_published_values_sources_and_caveats(clubface_):
    ran = clubface_("models", "volumetric")
    text = " ".join(ran.out.split())
    for words in ("N m s/rad", "6.25e+09", "Table 8", "0.00253*", "kept as printed", "ten times larger"):
        assert words in text
    ran = clubface_("models", "rings", "--json")
    (bounds,) = [(row["lower"], row["upper"]) for row in ran.rows("parameters") if row["parameter"] == "friction"]
    assert bounds == (0.0, 2.0)
    (driver,) = [
        row
        for row in ran.rows("published_values")
        if row["club"] == "driver"
        and row["parameter"] == "shear_modulus"
        and row["set"] == "three-dimensional-impact-models"
    ]
    assert driver["value"] == 5.58e7
    assert "1/100" in driver["caveat"]


def test_clubs_lists_clubs_and_balls_and_says_once_that_the_published_ball_is_small(clubface_):
    ran = clubface_("clubs", "--json")
    assert ran.notes().count("small-ball") == 1
    assert {row["club"] for row in ran.rows("clubs")} == set(clubface.equipment.clubs.CLUB_NAMES)
    assert ran.rows("clubs")[0]["club"] == "driver"
    assert ran.rows("clubs")[0]["mass_g"] == pytest.approx(204.0, rel=1e-15)
    assert {row["ball"] for row in ran.rows("balls")} == set(ball_names())


def test_one_club_is_shown_with_the_source_of_every_value(clubface_):
    assert "scaling rule" in clubface_("clubs", "6-iron").out
    rows = {row["field"]: row for row in clubface_("clubs", "6-iron", "--json").rows()}
    assert all(rows[name]["source"] for name in ("mass", "loft", "ixx", "face_width"))
    assert rows["bulge"]["value"] == "flat"
    assert (rows["mass"]["value"], rows["mass"]["unit"]) == (pytest.approx(257.0), "g")


def test_a_new_club_is_a_club_that_passes_the_check(clubface_, tmp_path):
    file = tmp_path / "mine.toml"
    assert clubface_("club", "new", "mine", "-o", str(file)).status == 0
    ran = clubface_("club", "check", str(file))
    assert ran.status == 0
    assert "a club that can exist" in ran.out
    # The characteristic time is a comment in it, since it is optional: the published sets do not need it.
    shot = ["--speed", "50 m/s", "--model", "standard,adjusted,volumetric", "--json"]
    assert clubface_("shot", str(file), *shot).rows() == clubface_("shot", "driver", *shot).rows()


def test_the_check_of_a_club_includes_the_rules(clubface_, tmp_path):
    file = tmp_path / "heavy.toml"
    changes = "iyy=5950 g cm2, characteristic_time=230 us"
    assert clubface_("club", "new", "heavy", "--set", changes, "-o", str(file)).status == 0
    lines = [" ".join(line.split()) for line in clubface_("club", "check", str(file)).out.splitlines()]
    assert "moment of inertia, vertical axis g cm2 5950 5900 100 conforms within the tolerance" in lines
    assert "characteristic time of the face µs 230 239 18 conforms" in lines
    assert not any("volume" in line for line in lines)  # a club file knows none


@pytest.mark.parametrize(
    ("club", "value", "code"),
    [
        ("driver", "characteristic_time=240 us", "club-conforms"),
        ("driver", "characteristic_time=270 us", "club-does-not-conform"),
        ("driver", "characteristic_time=0 s", "club-partly-judged"),
        ("7-iron", "loft=50 deg", "club-possible"),
    ],
)
def test_the_last_line_of_a_check_sums_up_the_rules(clubface_, tmp_path, club, value, code):
    file = tmp_path / "mine.toml"
    assert clubface_("club", "new", "mine", "--like", club, "--set", value, "-o", str(file)).status == 0
    [hint] = check_result(clubface.club(str(file)), str(file)).hints
    assert hint.code == code
    assert " ".join(clubface_("club", "check", str(file)).out.split()).endswith(" ".join(hint.sentence.split()))


def test_a_face_stated_by_its_restitution_is_noted_with_what_comes_nearer(tmp_path):
    driver = clubface.club("driver")
    assert "time-of-cor" not in [each.code for each in check_result(driver, "mine.toml").notes]
    notes = {each.code: each for each in check_result(driver.replace(cor=0.82), "mine.toml").notes}
    assert notes["time-of-cor"].data["restitution"] == 0.82
    assert "0.820" in notes["time-of-cor"].sentence
    assert "0.007" in notes["time-of-cor"].sentence


def test_a_new_club_goes_to_the_screen_or_starts_from_another(clubface_):
    assert clubface.Club.from_text(clubface_("club", "new").out).name == "my-club"
    like = clubface.Club.from_text(clubface_("club", "new", "lob", "--like", "9-iron").out)
    assert like.replace(name="9-iron") == clubface.club("9-iron")


def test_a_new_club_may_differ_from_the_one_it_starts_from(clubface_):
    driver = clubface.club("driver")
    text = clubface_("club", "new", "mine", "--set", "cg_x=38 mm, iyy=5200 g cm2", "--set", "cor=0.82").out
    result = clubface.Club.from_text(text)
    assert result == driver.replace(name="mine", description="", cg_x="38 mm", iyy="5200 g cm2", cor=0.82, sources={})
    assert "about the vertical axis" in text
    text = clubface_("club", "new", "heavy", "--like", "driver", "--set", "inertia=-10 %, loft=11 deg").out
    described = clubface.Club.from_text(text).description
    assert described != clubface.club("driver").description  # of another head; it says what was changed
    assert "driver" in described
    assert "11 deg" in described
    result = clubface.Club.from_text(text)
    assert result.ixy == pytest.approx(0.9 * driver.ixy, rel=1e-5)
    assert result.iyy == pytest.approx(0.9 * driver.iyy, rel=1e-5)
    assert 'iyy = "5111.1 g cm2"' in text
    assert result.loft == pytest.approx(math.radians(11.0))
    # What was changed is no longer what the source says.
    assert {"mass", "cg_x"} <= set(result.sources)
    assert not {"loft", "ixx", "iyy"} & set(result.sources)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ("cgx=1 mm", "did you mean cg_x"),
        ("inertia=10", "per cent"),
        ("cg_x=10 kg", "not a mass"),
        ("cg_x", "name=value"),
    ],
)
def test_an_impossible_change_of_a_new_club_is_reported(clubface_, change, message):
    assert_mistake(clubface_("club", "new", "--set", change), message)


def test_a_file_that_exists_is_not_overwritten(clubface_, write):
    file = write("precious", "mine.toml")
    assert_mistake(clubface_("club", "new", "-o", str(file)), "exists already")
    assert file.read_text() == "precious"


def test_a_bad_club_file_is_reported_with_its_line(clubface_, write):
    file = write(clubface.Club.template().replace('mass = "204 g"', 'mass = "-204 g"'), "bad.toml")
    line = next(i for i, text in enumerate(file.read_text().splitlines(), 1) if text.startswith("mass"))
    assert_mistake(clubface_("club", "check", str(file)), f"bad.toml:{line}:", "mass")


def test_sensitivities_are_printed_with_their_units(clubface_):
    arguments = ["sensitivity", "driver", "--speed", "113 mph", "--model", "volumetric", "--output", "backspin"]
    (entry,) = clubface_(*arguments, "--by", "high", "--json").rows()
    table = clubface.sensitivity("driver", speed="113 mph", model="volumetric")
    assert entry["unit"] == "rpm per mm"
    assert entry["value"] == pytest.approx(table.value("backspin", "high", "rpm per mm"), rel=1e-12)
    text = clubface_(*arguments).out
    assert "high, per mm" in text
    assert "layer_damping, per N m s/rad" in text


def test_a_flight_is_that_of_the_library(clubface_):
    launch = ["--ball-speed", "167 mph", "--launch", "10.9 deg", "--backspin", "2700 rpm", "--sidespin", "-200 rpm"]
    row = clubface_("flight", *launch, "--json").values
    flown = clubface.fly(
        {"ball_speed": "167 mph", "launch": "10.9 deg", "backspin": "2700 rpm", "sidespin": "-200 rpm"}
    )
    assert row["carry_m"] == pytest.approx(flown.carry, rel=1e-12)
    assert row["side_m"] < 0.0
    assert f"{units.from_si(flown.carry, 'yd'):.1f}" in clubface_("flight", *launch).out


def test_a_file_of_deliveries_is_predicted_and_bad_rows_are_kept_aside(clubface_, tmp_path):
    source, target = tmp_path / "in.csv", tmp_path / "out.csv"
    source.write_text("club_speed_mph,attack_deg\n113,-1.3\nfast,0\n105,2\n")
    ran = clubface_("predict", str(source), "--club", "driver", "--model", "volumetric", "-o", str(target), "--json")
    assert [ran.json["values"][name] for name in ("rows", "written", "rejected")] == [3, 2, 1]
    with target.open() as file:
        first = next(csv.DictReader(file))
    shot = clubface.impact("driver", speed="113 mph", attack="-1.3 deg", model="volumetric")
    # The file holds nine digits.
    assert float(first["backspin_rpm"]) == pytest.approx(shot.get("backspin", "rpm"), rel=1e-8)
    assert "fast" in (tmp_path / "out.rejects.csv").read_text()
    assert "1 rejected" in clubface_("predict", str(source), "--club", "driver", "-o", str(target)).out


def test_a_file_without_one_usable_row_is_a_failure(clubface_, tmp_path, write):
    source = write("club_speed_mph\nfast\n", "in.csv")
    ran = clubface_("predict", str(source), "--club", "driver", "-o", str(tmp_path / "out.csv"))
    assert ran.status == 2
    assert "not one delivery" in ran.err


def test_every_table_of_averages_is_compared_and_summed_up(clubface_, tmp_path):
    pytest.importorskip("matplotlib")
    ran = clubface_("tour", "--averages", "all", "--model", "standard", "-o", str(tmp_path), "--json")
    rows = ran.json["tables"]["clubs"]["rows"]
    assert list(dict.fromkeys(each["averages"] for each in rows)) == ["pga-2023", "pga-2019", "lpga-2019"]
    assert sorted(each.name for each in tmp_path.iterdir()) == ["lpga-2019", "pga-2019", "pga-2023"]
    assert (tmp_path / "pga-2019" / "tour-launch.png").stat().st_size > 1000
    spins = [abs(row["spin_error_rpm"]) for row in rows]
    assert len(spins) == 34
    means = {(each["averages"], each["model"]): each for each in ran.json["tables"]["mean_absolute_error"]["rows"]}
    assert means["all", "standard"]["spin_rpm"] == pytest.approx(sum(spins) / 34, rel=1e-8)
    several = clubface_("tour", "--averages", "pga-2019,lpga-2019", "--model", "standard,slip")
    # The hybrid of the PGA Tour, at 100 mph, and the three woods of the LPGA Tour.
    assert several.err == (
        "clubface: note: outside the range of slip: clubhead speed in 4 of 22 shots (valid: 101 to 118 mph)\n"
    )
    assert several.out.startswith("PGA Tour averages of 2019 and LPGA Tour averages of 2019, by standard")
    assert clubface_("tour", "--averages", "pga").status == 2
