"""``clubface shot``: its table, its JSON and its options."""

import math
import re

import pytest

import clubface
from clubface import units
from clubface.equipment.models import DEFAULT_MODEL
from clubface.equipment.parameters import RANGES
from command_line import assert_mistake

SHOT_KEYS = [
    "model", "ball_speed_mps", "smash", "launch_deg", "azimuth_deg", "backspin_rpm", "sidespin_rpm", "total_spin_rpm",
    "spin_axis_deg", "carry_m", "side_m", "curve_m", "total_m", "apex_m", "landing_angle_deg", "contact_time_us",
    "peak_force_kN", "shot_shape",
]  # fmt: skip


def test_a_shot_is_one_answer_by_the_default_model(clubface_):
    ran = clubface_("shot", "driver", "--speed", "113 mph", "--toe", "8 mm")
    assert ran.out.splitlines()[2] == f"driver, ball modern, by {DEFAULT_MODEL}"
    assert "--model all" in ran.out.splitlines()[-1]
    assert "--model all" not in clubface_("shot", "driver", "--speed", "113 mph", "--model", DEFAULT_MODEL).out


def test_all_models_are_a_row_each(clubface_):
    ran = clubface_("shot", "driver", "--speed", "113 mph", "--model", "all")
    rows = ran.out.split("─\n")[1].splitlines()[: len(clubface.models())]
    assert [row.split()[0] for row in rows] == list(clubface.models())
    assert (ran.status, ran.err) == (0, "")


def test_the_json_of_a_shot_has_exactly_the_promised_keys_and_null_where_there_is_no_value(clubface_):
    rows = clubface_("shot", "driver", "--speed", "113 mph", "--model", "all", "--json").rows()
    assert [row["model"] for row in rows] == list(clubface.models())
    for row in rows:
        assert list(row) == SHOT_KEYS
        contact = clubface.models()[row["model"]].kind == "contact" or row["model"] == "response"
        assert [row["contact_time_us"] is None, row["peak_force_kN"] is None] == [not contact, not contact]
        assert all(row[key] is not None for key in {*SHOT_KEYS} - {"contact_time_us", "peak_force_kN"})


def test_the_json_of_a_shot_is_what_the_library_computes(clubface_):
    arguments = ["--speed", "113 mph", "--attack", "-1.3 deg", "--loft", "12.8 deg", "--toe", "8 mm", "--high", "-3 mm",
                 "--path", "2 deg", "--face", "1 deg", "--lie", "0.5 deg", "--closure", "2400 deg/s",
                 "--pitch-rate", "300 deg/s", "--lie-rate", "50 deg/s"]  # fmt: skip
    (row,) = clubface_("shot", "driver", *arguments, "--model", "volumetric", "--json").rows()
    shot = clubface.impact(
        "driver", speed="113 mph", attack="-1.3 deg", loft="12.8 deg", toe="8 mm", high="-3 mm", path="2 deg",
        face="1 deg", lie="0.5 deg", closure="2400 deg/s", pitch_rate="300 deg/s", lie_rate="50 deg/s",
        model="volumetric",
    )  # fmt: skip
    flight = clubface.fly(shot)
    assert row["ball_speed_mps"] == shot.ball_speed
    assert row["smash"] == shot.smash
    assert row["sidespin_rpm"] == shot.get("sidespin", "rpm")
    assert row["azimuth_deg"] == shot.get("azimuth", "deg")
    assert (row["carry_m"], row["side_m"], row["apex_m"]) == (flight.carry, flight.side, flight.apex)
    assert row["landing_angle_deg"] == flight.get("landing_angle", "deg")
    assert row["contact_time_us"] == shot.get("contact_time", "us")


# What is printed: label, SI by definition of the unit, and digits. Each number is compared with the library's.
PRINTED = {
    "ball_speed": ("ball speed", 0.44704, 1), "smash": ("smash factor", 1.0, 3),
    "launch": ("launch angle", math.pi / 180, 1), "azimuth": ("launch direction", math.pi / 180, 1),
    "backspin": ("backspin", math.pi / 30, 0), "sidespin": ("sidespin", math.pi / 30, 0),
    "total_spin": ("total spin", math.pi / 30, 0), "spin_axis": ("spin axis", math.pi / 180, 1),
    "carry": ("carry", 0.9144, 1), "side": ("side", 0.9144, 1), "curve": ("curve", 0.9144, 1),
    "total": ("total", 0.9144, 1), "apex": ("apex", 0.9144, 1), "landing_angle": ("landing angle", math.pi / 180, 1),
    "contact_time": ("contact time", 1e-6, 0), "peak_force": ("peak force", 1e3, 1),
}  # fmt: skip
COLUMNS = [name for name in PRINTED if name not in ("total_spin", "total", "apex", "landing_angle")]
OFF_CENTRE = ["shot", "driver", "--speed", "113 mph", "--toe", "8 mm", "--face", "-4 deg", "--loft", "12 deg"]


def expected(model):
    """Return the quantities of the shot off centre in the units printed, as the library has them in SI."""
    shot = clubface.impact("driver", speed="113 mph", toe="8 mm", face="-4 deg", loft="12 deg", model=model)
    flight = clubface.fly(shot)
    quantities = {name: shot if name in shot.quantities() else flight for name in PRINTED}
    return {name: getattr(quantities[name], name) / factor for name, (_, factor, _) in PRINTED.items()}


def test_every_number_of_the_list_is_the_librarys_in_the_unit_beside_it(clubface_):
    lines = clubface_(*OFF_CENTRE, "--model", "rings").out.split("\n\n")[0].splitlines()[2:]
    shown = {line.split("  ")[0]: line.split("  ")[-1].split() for line in lines}
    assert list(shown) == [label for label, _, _ in PRINTED.values()]
    values = expected("rings")
    for name, (label, _, digits) in PRINTED.items():
        # The number is rounded to the digits printed.
        assert float(shown[label][0]) == pytest.approx(values[name], abs=0.5001 * 10.0**-digits), name
    side = {
        name: "right" if values[name] > 0.0 else "left"
        for name in ("azimuth", "sidespin", "spin_axis", "side", "curve")
    }
    assert {name: shown[PRINTED[name][0]][2] for name in side} == side
    units_shown = [shown[label][1] for label, _, _ in PRINTED.values() if label != "smash factor"]
    assert units_shown == ["mph", "deg", "deg", "rpm", "rpm", "rpm", "deg", *["yd"] * 5, "deg", "µs", "kN"]


def test_every_number_of_the_table_is_the_librarys_in_the_unit_of_its_column(clubface_, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    head, body = clubface_(*OFF_CENTRE, "--model", "rings,standard").out.split("─\n")
    for line in body.splitlines()[:2]:
        model, *cells = line.split()
        quantities = expected(model)
        # A model of the impulse has neither contact time nor force.
        names = COLUMNS if model == "rings" else COLUMNS[:-2]
        for name, cell in zip(names, cells, strict=True):
            assert float(cell) == pytest.approx(quantities[name], abs=0.5001 * 10.0 ** -PRINTED[name][2]), (model, name)
    units_row = ["model", "mph", "factor", "deg", "deg", "rpm", "rpm", "deg", "yd", "yd", "yd", "µs", "kN"]
    assert head.splitlines()[-2].split() == units_row


def test_an_option_left_out_takes_the_clubs_own_value_or_zero(clubface_):
    given = ["--loft", "9.8 deg", "--attack", "0 deg", "--path", "0 deg", "--toe", "0 mm", "--closure", "0 deg/s"]
    plain = clubface_("shot", "driver", "--speed", "113 mph", "--json").json
    assert plain.pop("assumptions")
    asked = clubface_("shot", "driver", "--speed", "113 mph", *given, "--json").json
    assert asked.pop("assumptions") == []
    assert asked == plain


@pytest.mark.parametrize("attack", ["-1.3 deg", "-1.3deg", "-0.022689280275926284"])
def test_a_negative_value_is_no_option(clubface_, attack):
    (row,) = clubface_("shot", "driver", "--speed", "113 mph", "--attack", attack, "--json").rows()
    shot = clubface.impact("driver", speed="113 mph", attack="-1.3 deg")
    assert row["launch_deg"] == pytest.approx(shot.get("launch", "deg"), rel=1e-12)


def test_a_bare_number_is_si_and_noted(clubface_):
    ran = clubface_("shot", "driver", "--speed", "50", "--json")
    assert ran.rows()[0]["ball_speed_mps"] == clubface.impact("driver", speed=50.0).ball_speed
    assert ran.err == "clubface: note: --speed 50 has no unit and is read in m/s\n"


@pytest.mark.parametrize(
    ("given", "asked"),
    [
        (["--speed", "105"], '--speed "105 mph"'),
        (["--speed", "48 m/s", "--loft", "12"], '--loft "12 deg"'),
        (["--speed", "48 m/s", "--attack", "-1.3"], '--attack "-1.3 deg"'),
        (["--speed", "48 m/s", "--toe", "8"], '--toe "8 mm"'),
        (["--speed", "48 m/s", "--closure", "2400"], '--closure "2400 deg/s"'),
        (["--speed", "48 m/s", "--temperature", "30"], '--temperature "30 degC"'),
        (["--speed", "48 m/s", "--wind", "50"], '--wind "50 mph"'),
    ],
)
def test_a_bare_number_that_no_shot_has_in_si_is_asked_for_its_unit(clubface_, given, asked):
    assert_mistake(clubface_("shot", "driver", *given), "has no unit; give it, as in " + asked, "a bare number is in")


def test_models_are_chosen_by_commas_or_repetition_in_the_order_asked(clubface_):
    commas = clubface_("shot", "driver", "--speed", "50 m/s", "--model", "rings,standard", "--json").rows()
    repeated = clubface_(
        "shot", "driver", "--speed", "50 m/s", "--model", "rings", "--model", "standard", "--json"
    ).rows()
    assert [row["model"] for row in commas] == ["rings", "standard"]
    assert commas == repeated


def test_a_left_handed_shot_is_the_mirror_image(clubface_):
    right = clubface_("shot", "driver", "--speed", "50 m/s", "--face", "2 deg", "--toe", "5 mm", "--json").rows()
    left = clubface_(
        "shot", "driver", "--speed", "50 m/s", "--face", "-2 deg", "--toe", "5 mm", "--hand", "left", "--json"
    ).rows()
    for one, other in zip(right, left, strict=True):
        # Mirrored arithmetic differs by rounding only.
        assert one["backspin_rpm"] == pytest.approx(other["backspin_rpm"], rel=1e-9)
        assert one["sidespin_rpm"] == pytest.approx(-other["sidespin_rpm"], rel=1e-7)
        assert one["side_m"] == pytest.approx(-other["side_m"], rel=1e-6)


def test_a_setting_changes_the_models_that_have_it(clubface_):
    every = ["shot", "driver", "--speed", "50 m/s", "--model", "all", "--json"]
    plain = clubface_(*every).rows()
    changed = clubface_(*every, "--set", "friction=0.2").rows()
    differ = {a["model"] for a, b in zip(plain, changed, strict=True) if a != b}
    assert differ == {"response", "volumetric", "rings", "area"}


def test_parameters_come_from_a_file_or_by_the_name_of_a_published_set(clubface_, write):
    file = write(clubface.ParameterSet.builtin("standard", "driver").replace(cor="0.7").to_toml(), "mine.toml")
    place = list(clubface.models()).index("standard")
    every = ["shot", "driver", "--speed", "50 m/s", "--model", "all", "--json"]
    rows = clubface_(*every, "--parameters", str(file)).rows()
    shot = clubface.impact("driver", speed=50.0, model="standard", parameters={"cor": 0.7})
    assert rows[place]["ball_speed_mps"] == shot.ball_speed
    named = clubface_(*every, "--parameters", "penner").rows()
    shot = clubface.impact("driver", speed=50.0, model="standard", parameters="penner")
    assert named[place]["ball_speed_mps"] == shot.ball_speed
    assert [row for row in named if row != named[place]] == [row for row in rows if row != rows[place]]


def test_the_air_is_one_text_or_single_options(clubface_):
    shot = ["shot", "driver", "--speed", "50 m/s", "--json"]
    text = clubface_(*shot, "--air", "temperature=30 degC, altitude=1600 m, wind=-5 m/s").rows()
    single = clubface_(*shot, "--temperature", "30 degC", "--altitude", "1600 m", "--wind", "-5 m/s").rows()
    launch = clubface.impact("driver", speed=50.0)
    flown = clubface.fly(launch, air={"temperature": "30 degC", "altitude": "1600 m"}, wind=("-5 m/s", 0, 0))
    assert text == single
    assert text[0]["carry_m"] == flown.carry
    assert text[0]["carry_m"] != clubface_(*shot).rows()[0]["carry_m"]


def test_a_crosswind_blows_to_the_right(clubface_):
    (row,) = clubface_("shot", "driver", "--speed", "50 m/s", "--wind", "0, 5 m/s", "--json").rows()
    assert row["side_m"] > 5.0


@pytest.mark.usefixtures("without_pictures")
def test_a_loft_that_was_not_given_stands_in_the_first_line(clubface_, tmp_path):
    report, picture = tmp_path / "report.md", tmp_path / "shot.svg"
    for command, clubs in (
        (("shot", "7-iron", "--attack", "-3 deg", "--report", str(report)), ["7-iron 30.5 deg"]),
        (("shot", "7-iron", "--path", "-3 deg", "--report", str(picture.with_suffix(".html"))), ["7-iron 30.5 deg"]),
        (("compare", "driver", "7-iron", "--no-split", "--report", str(report)), ["driver 9.8 deg", "7-iron 30.5 deg"]),
        (("map", "driver", "--grid", "5x5", "--report", str(report)), ["driver 9.8 deg"]),
        (("sensitivity", "driver", "--by", "toe", "--report", str(report)), ["driver 9.8 deg"]),
    ):  # fmt: skip
        ran = clubface_(*command, "--speed", "40 m/s")
        first = " ".join(ran.out.split("\n\n")[0].split())
        assert all(each in first for each in clubs), command
        (assumed,) = clubface_(*command[:-2], "--speed", "40 m/s", "--json").json["assumptions"]
        assert (assumed["code"], assumed["data"], assumed["text"]) == ("static-loft", {"clubs": clubs}, first)
        if command[-1].endswith(".md"):
            heading, paragraph, *_ = report.read_text().split("\n\n")
            assert heading.startswith("# ")
            assert paragraph == first
        given = clubface_(*command[:-2], "--speed", "40 m/s", "--loft", "20 deg")
        assert "ssumed" not in given.out.splitlines()[0]


def test_files_of_deliveries_and_golfers_without_a_loft_say_so_too(clubface_, write, tmp_path):
    golfer = 'title = "A"\nclub = "driver"\n[mean]\nspeed = "100 mph"\nattack = "1 deg"\n[spread]\nspeed = "2 mph"\n'
    spread = clubface_("dispersion", str(write(golfer, "golfer.toml")), "--count", "256", "--no-shares", "--json")
    assert spread.json["assumptions"][0]["data"] == {"clubs": ["driver 9.8 deg"]}
    with_loft = golfer.replace("[spread]", 'loft = "13 deg"\n[spread]')
    spread = clubface_("dispersion", str(write(with_loft, "lofted.toml")), "--count", "256", "--no-shares", "--json")
    assert spread.json["assumptions"] == []
    for file, text, assumed in (
        ("a.csv", "speed_mph,attack_deg\n105,3\n", [{"clubs": ["driver 9.8 deg"]}]),
        ("b.csv", "speed_mph,loft_deg\n105,13\n", []),
    ):
        target = str(tmp_path / f"launches-{file}")
        ran = clubface_("predict", str(write(text, file)), "--club", "driver", "-o", target, "--json")
        assert [each["data"] for each in ran.json["assumptions"]] == assumed


@pytest.mark.usefixtures("without_pictures")
def test_the_caveats_of_a_variant_of_a_published_set_stand_before_every_result(clubface_, write, tmp_path):
    variant = "three-dimensional-impact-models/as-printed"
    swing = ("--speed", "48 m/s", "--loft", "13 deg", "--model", "rings")
    deliveries, target = str(write("speed_mph,loft_deg\n105,13\n", "a.csv")), str(tmp_path / "launches.csv")
    report = tmp_path / "report.md"
    for command in (
        ("shot", "driver", *swing),
        ("compare", "driver", "7-iron", "--no-split", *swing),
        ("map", "driver", "--grid", "5x5", *swing),
        ("sensitivity", "driver", "--by", "toe", *swing),
        ("explain", "driver", *swing),
        ("predict", deliveries, "--club", "driver", "-o", target, "--model", "rings"),
    ):
        notes = clubface_(*command, "--parameters", variant, "--json").json["assumptions"]
        caveats = list(clubface.ParameterSet.builtin("rings", "driver", variant).caveats)
        assert [(each["code"], each["data"]["caveats"]) for each in notes] == [("variant-caveats", caveats)], command
        assert clubface_(*command, "--json").json["assumptions"] == [], command
        if command[0] in ("shot", "compare"):
            clubface_(*command, "--parameters", variant, "--report", str(report))
            assert notes[0]["text"] in report.read_text()
    swing = {"speed": 48.0, "loft": "13 deg"}
    launch = clubface.impact("driver", **swing, model="rings", parameters=variant)
    for shown in (repr(launch), repr(clubface.fly(launch)), launch.to_result()._repr_html_()):
        assert launch.parameters.caveats[0] in " ".join(shown.split())


def test_what_was_assumed_is_in_the_titles_of_pictures(clubface_):
    launch = clubface.impact("driver", speed="40 m/s", attack="2 deg")
    compared = clubface.compare({name: {"club": name, "delivery": {"speed": 40.0}} for name in ("driver", "3-wood")})
    face = clubface.map_face("driver", speed=40.0, grid=(5, 5))
    for result in (compared.to_result(), face.to_result()):
        assert all("9.8 deg" in each.title for each in result.pictures())
    assert "9.8 deg" in repr(launch).splitlines()[0]
    assert (
        "9.8 deg"
        in launch.to_result().assumptions[0].sentence
        == clubface.fly(launch).to_result().assumptions[0].sentence
    )


def test_a_note_says_where_the_caveats_of_the_models_stand(clubface_):
    shot = ["shot", "driver", "--speed", "50 m/s", "--loft", "12 deg", "--json"]
    assert clubface_(*shot, "--model", "adjusted").notes("caveats-listed") == [{"model": "adjusted"}]
    assert clubface_(*shot, "--model", "all").notes("caveats-listed") == [{"model": "NAME"}]
    assert not clubface_(*shot, "--model", "slip").notes("caveats-listed")  # has none
    text = " ".join(clubface_("models", "adjusted").out.split())
    assert text.count("lowers backspin by about 600 rpm") == 1


def test_a_note_names_the_models_whose_spin_is_beyond_the_aerodynamic_data(clubface_):
    # The aerodynamics were fitted to spin parameters up to 1: a putt-like speed at a wedge's loft is beyond.
    slow = ["shot", "pitching-wedge", "--speed", "3 m/s", "--loft", "65 deg", "--model", "standard,slip", "--json"]
    assert clubface_(*slow).notes("outside-aerodynamic-data") == [{"models": ["standard", "slip"]}]
    assert clubface_(*slow).notes("caveats-listed") == [{"model": "standard"}]


def test_the_accuracy_is_passed_on(clubface_):
    shot = ["shot", "driver", "--speed", "50 m/s", "--model", "volumetric", "--json"]
    fine = clubface.impact("driver", speed=50.0, model="volumetric", accuracy=1e-10)
    assert clubface_(*shot, "--accuracy", "1e-10").rows()[0]["backspin_rpm"] == fine.get("backspin", "rpm")


def test_a_plot_is_written_and_json_stays_alone(clubface_, tmp_path):
    pytest.importorskip("matplotlib")
    file = tmp_path / "shot.svg"
    ran = clubface_("shot", "driver", "--speed", "50 m/s", "--model", "standard,area", "--plot", str(file), "--json")
    assert len(ran.rows()) == 2
    assert file.read_bytes().startswith(b"<?xml")


@pytest.mark.parametrize("width", [40, 80, 120])
def test_no_line_of_a_table_exceeds_the_terminal(clubface_, monkeypatch, width):
    monkeypatch.setenv("COLUMNS", str(width))
    for arguments in (
        ["shot", "driver", "--speed", "113 mph", "--model", "all"],
        ["shot", "driver", "--speed", "50 m/s"],
        ["clubs"],
        ["models"],
        ["tour", "--model", "standard"],
    ):
        ran = clubface_(*arguments)
        assert max(len(line) for line in ran.out.splitlines()) <= width
        assert "…" not in ran.out


def test_a_narrow_terminal_repeats_the_models_and_loses_no_column(clubface_, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    out = clubface_("shot", "driver", "--speed", "113 mph", "--model", "all").out
    rows = re.findall(r"^volumetric (.*)$", out, re.MULTILINE)
    assert len(rows) > 1
    assert sum(len(row.split()) for row in rows) == 12


def test_outside_its_range_the_default_model_says_so_in_one_line(clubface_):
    fastest = units.from_si(RANGES[DEFAULT_MODEL]["speed"][1], "mph")
    assert clubface_("shot", "driver", "--speed", f"{fastest - 1} mph", "--toe", "5 mm").err == ""
    ran = clubface_(
        "shot", "driver", "--speed", f"{fastest + 1} mph", "--attack", "-9 deg", "--loft", "64 deg", "--json"
    )
    assert ran.err.count("\n") == 1
    assert ran.err.startswith(
        f"clubface: note: outside the range of {DEFAULT_MODEL}: clubhead speed 146.4 mph (valid: 22.37 to"
    )
    assert "angle between path and face normal 73 deg (valid: 0 to 72 deg)" in ran.err
    assert len(ran.rows()) == 1


def test_published_sets_outside_theirs_and_a_model_without_gear_effect_share_one_line(clubface_):
    inside = ["shot", "driver", "--speed", "101 mph", "--model", "all"]
    assert clubface_(*inside).err == ""
    ran = clubface_("shot", "driver", "--speed", "90 mph", "--model", "all", "--toe", "5 mm")
    assert ran.err == (
        "clubface: note: outside the range of adjusted, slip, volumetric, rings, area: clubhead speed 90 mph"
        " (valid: 101 to 118 mph); jorgensen has no gear effect off centre\n"
    )
    assert clubface_("shot", "7-iron", "--speed", "60 mph", "--model", "adjusted").err == ""  # none is published


def test_the_total_of_a_low_shot_is_an_interval(clubface_):
    """Of a ball that comes down at 12 degrees no measured run is published; of the average drive on tour it is."""
    options = ("flight", "--ball-speed", "145 mph", "--launch", "6.4 deg", "--backspin", "1106 rpm")
    ran = clubface_(*options, "--json")
    totals = ran.values
    assert ran.notes("run-not-measured")[0]["soft_total_m"] == totals["total_soft_m"]
    assert totals["total_soft_m"] < totals["total_m"] < totals["total_firm_m"]
    drive = ("flight", "--ball-speed", "171 mph", "--launch", "10.4 deg", "--backspin", "2545 rpm")
    assert "total_soft_m" not in clubface_(*drive, "--json").values


def test_a_club_on_a_shaft_hits_harder_and_says_what_it_weighs(clubface_, tmp_path):
    command = ("shot", "driver", "--speed", "105 mph", "--loft", "13 deg")
    path = tmp_path / "shaft.toml"
    path.write_text(clubface.Shaft.builtin("graphite").to_toml())
    free, graphite, own = (
        clubface_(*command, *shaft, "--json").json for shaft in ((), ("--shaft", "graphite"), ("--shaft", str(path)))
    )
    speeds = [each["tables"]["shots"]["rows"][0]["ball_speed_mps"] for each in (free, graphite, own)]
    club = clubface.club("driver").on_shaft("graphite")
    assert speeds[1] == speeds[2] == clubface.impact(club, speed="105 mph", loft="13 deg").ball_speed > speeds[0]
    (note,) = [each for each in graphite["notes"] if each["code"] == "attached-head"]
    assert note["data"]["attached_club_mass_g"] == pytest.approx(1e3 * club.effective_mass, rel=1e-12)
