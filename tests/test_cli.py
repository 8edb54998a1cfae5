"""The command line: results, mistakes, interruption. Most runs are in this process, those about the process are not."""

import csv
import json
import os
import re
import signal
import subprocess
import sys
import time

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import clubface
from clubface import units

pytest.importorskip("typer")
pytest.importorskip("rich")

from clubface.cli.app import COMMANDS, run

SHOT_KEYS = [
    "model", "ball_speed_mps", "smash", "launch_deg", "azimuth_deg", "backspin_rpm", "sidespin_rpm", "total_spin_rpm",
    "spin_axis_deg", "carry_m", "side_m", "apex_m", "landing_deg", "contact_time_s", "peak_force_n",
]  # fmt: skip
MAIN = "from clubface.cli import main; main()"


class Ran:
    """What one command line did."""

    def __init__(self, status, out, err):
        self.status, self.out, self.err = status, out, err

    @property
    def json(self):
        return json.loads(self.out, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))


@pytest.fixture
def clubface_(capsys, monkeypatch):
    """Run a command line in this process."""
    monkeypatch.setenv("COLUMNS", "120")

    def ran(*arguments):
        status = run(arguments)
        captured = capsys.readouterr()
        return Ran(status, captured.out, captured.err)

    return ran


def process(*arguments, **options):
    """Run a command line in a process of its own."""
    return subprocess.run(
        [sys.executable, "-c", MAIN, *arguments], capture_output=True, text=True, timeout=50, **options
    )


def assert_mistake(ran, *words):
    """One message on the error stream, nothing on the other, status 2."""
    assert ran.status == 2
    assert ran.out == ""
    messages = [line for line in ran.err.splitlines() if not line.startswith("clubface: note:")]
    assert len(messages) == 1
    assert messages[0].startswith("clubface: ")
    for word in words:
        assert word in messages[0]


# shot


def test_a_shot_is_a_row_a_model(clubface_):
    ran = clubface_("shot", "driver", "--speed", "113 mph")
    rows = ran.out.split("─\n")[1].splitlines()[:7]
    assert [row.split()[0] for row in rows] == list(clubface.models())
    assert (ran.status, ran.err) == (0, "")


def test_the_json_of_a_shot_has_exactly_the_promised_keys_and_null_where_there_is_no_value(clubface_):
    rows = clubface_("shot", "driver", "--speed", "113 mph", "--json").json
    assert [row["model"] for row in rows] == list(clubface.models())
    for row in rows:
        assert list(row) == SHOT_KEYS
        contact = clubface.models()[row["model"]].kind == "contact"
        assert [row["contact_time_s"] is None, row["peak_force_n"] is None] == [not contact, not contact]
        assert all(row[key] is not None for key in SHOT_KEYS[:-2])


def test_the_json_of_a_shot_is_what_the_library_computes(clubface_):
    arguments = ["--speed", "113 mph", "--attack", "-1.3 deg", "--loft", "12.8 deg", "--toe", "8 mm", "--high", "-3 mm",
                 "--path", "2 deg", "--face", "1 deg", "--lie", "0.5 deg", "--closure", "2400 deg/s",
                 "--pitch-rate", "300 deg/s", "--lie-rate", "50 deg/s"]  # fmt: skip
    (row,) = clubface_("shot", "driver", *arguments, "--model", "volumetric", "--json").json
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
    assert row["landing_deg"] == flight.get("landing_angle", "deg")
    assert row["contact_time_s"] == shot.contact_time


def test_the_table_shows_what_golfers_read(clubface_):
    ran = clubface_("shot", "driver", "--speed", "113 mph", "--model", "rings")
    cells = ran.out.split("─\n")[1].splitlines()[0].split()
    shot = clubface.impact("driver", speed="113 mph", model="rings")
    assert float(cells[1]) == round(units.from_si(shot.ball_speed, "mph"), 1)
    assert float(cells[5]) == round(shot.get("backspin", "rpm"))
    assert float(cells[9]) == round(units.from_si(clubface.fly(shot).carry, "yd"), 1)
    assert float(cells[11]) == round(shot.contact_time * 1e6)
    assert float(cells[12]) == round(shot.peak_force / 1e3, 1)


def test_an_option_left_out_takes_the_clubs_own_value_or_zero(clubface_):
    given = ["--loft", "9.8 deg", "--attack", "0 deg", "--path", "0 deg", "--toe", "0 mm", "--closure", "0 deg/s"]
    plain = clubface_("shot", "driver", "--speed", "113 mph", "--json").json
    assert clubface_("shot", "driver", "--speed", "113 mph", *given, "--json").json == plain


@pytest.mark.parametrize("attack", ["-1.3 deg", "-1.3deg", "-0.022689280275926284"])
def test_a_negative_value_is_no_option(clubface_, attack):
    (row,) = clubface_("shot", "driver", "--speed", "113 mph", "--attack", attack, "--model", "standard", "--json").json
    shot = clubface.impact("driver", speed="113 mph", attack="-1.3 deg")
    assert row["launch_deg"] == pytest.approx(shot.get("launch", "deg"), rel=1e-12)


def test_a_bare_number_is_si_and_said_to_be(clubface_):
    ran = clubface_("shot", "driver", "--speed", "50", "--model", "standard", "--json")
    assert ran.json[0]["ball_speed_mps"] == clubface.impact("driver", speed=50.0).ball_speed
    assert ran.err == "clubface: note: --speed 50 has no unit and is taken in m/s\n"


def test_models_are_chosen_by_commas_or_repetition_in_the_order_asked(clubface_):
    commas = clubface_("shot", "driver", "--speed", "50 m/s", "--model", "rings,standard", "--json").json
    repeated = clubface_(
        "shot", "driver", "--speed", "50 m/s", "--model", "rings", "--model", "standard", "--json"
    ).json
    assert [row["model"] for row in commas] == ["rings", "standard"]
    assert commas == repeated


def test_a_left_handed_shot_is_the_mirror_image(clubface_):
    right = clubface_("shot", "driver", "--speed", "50 m/s", "--face", "2 deg", "--toe", "5 mm", "--json").json
    left = clubface_(
        "shot", "driver", "--speed", "50 m/s", "--face", "-2 deg", "--toe", "5 mm", "--hand", "left", "--json"
    ).json
    for one, other in zip(right, left, strict=True):
        # Mirrored arithmetic differs by rounding only.
        assert one["backspin_rpm"] == pytest.approx(other["backspin_rpm"], rel=1e-9)
        assert one["sidespin_rpm"] == pytest.approx(-other["sidespin_rpm"], rel=1e-7)
        assert one["side_m"] == pytest.approx(-other["side_m"], rel=1e-6)


def test_a_setting_changes_the_models_that_have_it(clubface_):
    plain = clubface_("shot", "driver", "--speed", "50 m/s", "--json").json
    changed = clubface_("shot", "driver", "--speed", "50 m/s", "--set", "friction=0.2", "--json").json
    differ = {a["model"] for a, b in zip(plain, changed, strict=True) if a != b}
    assert differ == {"volumetric", "rings", "area"}


def test_parameters_come_from_a_file_or_by_the_name_of_a_published_set(clubface_, tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text(clubface.ParameterSet.builtin("standard", "driver").replace(cor="0.7").to_toml())
    rows = clubface_("shot", "driver", "--speed", "50 m/s", "--parameters", str(file), "--json").json
    shot = clubface.impact("driver", speed=50.0, parameters={"cor": 0.7})
    assert rows[0]["ball_speed_mps"] == shot.ball_speed
    named = clubface_("shot", "driver", "--speed", "50 m/s", "--parameters", "penner", "--json").json
    assert named[0]["ball_speed_mps"] == clubface.impact("driver", speed=50.0, parameters="penner").ball_speed
    assert named[1:] == rows[1:]


def test_the_air_is_one_text_or_single_options(clubface_):
    shot = ["shot", "driver", "--speed", "50 m/s", "--model", "standard", "--json"]
    text = clubface_(*shot, "--air", "temperature=30 degC, altitude=1600 m, wind=-5 m/s").json
    single = clubface_(*shot, "--temperature", "30 degC", "--altitude", "1600 m", "--wind", "-5 m/s").json
    launch = clubface.impact("driver", speed=50.0)
    flown = clubface.fly(launch, air={"temperature": "30 degC", "altitude": "1600 m"}, wind=("-5 m/s", 0, 0))
    assert text == single
    assert text[0]["carry_m"] == flown.carry
    assert text[0]["carry_m"] != clubface_(*shot).json[0]["carry_m"]


def test_a_crosswind_blows_to_the_right(clubface_):
    (row,) = clubface_(
        "shot", "driver", "--speed", "50 m/s", "--model", "standard", "--wind", "0, 5 m/s", "--json"
    ).json
    assert row["side_m"] > 5.0


def test_caveats_stand_under_the_table_and_not_in_json(clubface_):
    shot = ["shot", "driver", "--speed", "50 m/s", "--model", "adjusted"]
    text = " ".join(clubface_(*shot).out.split())
    assert text.count("lowers backspin by about 600 rpm") == 1
    assert "600" not in clubface_(*shot, "--json").out


def test_the_accuracy_is_passed_on(clubface_):
    shot = ["shot", "driver", "--speed", "50 m/s", "--model", "volumetric", "--json"]
    fine = clubface.impact("driver", speed=50.0, model="volumetric", accuracy=1e-10)
    assert clubface_(*shot, "--accuracy", "1e-10").json[0]["backspin_rpm"] == fine.get("backspin", "rpm")


def test_a_plot_is_written_and_json_stays_alone(clubface_, tmp_path):
    pytest.importorskip("matplotlib")
    file = tmp_path / "shot.svg"
    ran = clubface_("shot", "driver", "--speed", "50 m/s", "--model", "standard,area", "--plot", str(file), "--json")
    assert len(ran.json) == 2
    assert file.read_bytes().startswith(b"<?xml")


# the other commands


def test_every_command_has_help_and_says_json_where_it_computes(clubface_):
    for name in COMMANDS:
        ran = clubface_(name, "--help")
        assert ran.status == 0
        assert name in ran.out
        assert "--json" in ran.out or name == "club"


def test_models_lists_the_registry(clubface_):
    assert [entry["name"] for entry in clubface_("models", "--json").json] == list(clubface.models())
    assert "jorgensen" in clubface_("models").out


def test_a_model_is_shown_with_units_bounds_published_values_sources_and_caveats(clubface_):
    ran = clubface_("models", "volumetric")
    text = " ".join(ran.out.split())
    for words in ("N m s/rad", "0 to 2", "6.25e+09", "Table 8", "0.00253*", "kept as printed", "ten times larger"):
        assert words in text
    entry = clubface_("models", "rings", "--json").json
    (driver,) = [each for each in entry["sets"] if each["club"] == "driver"]
    assert driver["values"]["shear_modulus"] == 5.58e7
    assert "1/100" in driver["value_caveats"]["shear_modulus"]


def test_clubs_lists_clubs_and_balls_and_says_once_that_the_published_ball_is_small(clubface_):
    ran = clubface_("clubs")
    assert ran.out.count("42.60 mm") == 1
    document = clubface_("clubs", "--json").json
    assert [each["name"] for each in document["clubs"]][:2] == ["driver", "3-wood"]
    assert document["clubs"][0]["values"]["mass"] == 0.204
    assert {each["name"] for each in document["balls"]} == {"published", "conforming"}


def test_one_club_is_shown_with_the_source_of_every_value(clubface_):
    ran = clubface_("clubs", "6-iron")
    assert "scaling rule" in ran.out
    document = clubface_("clubs", "6-iron", "--json").json
    assert set(document["sources"]) >= {"mass", "loft", "ixx", "face_width"}
    assert document["values"]["bulge"] is None  # infinite: flat


def test_a_new_club_is_a_club_that_passes_the_check(clubface_, tmp_path):
    file = tmp_path / "mine.toml"
    assert clubface_("club", "new", "mine", "-o", str(file)).status == 0
    ran = clubface_("club", "check", str(file))
    assert ran.status == 0
    assert "a club that can exist" in ran.out
    rows = clubface_("shot", str(file), "--speed", "50 m/s", "--json").json
    assert rows == clubface_("shot", "driver", "--speed", "50 m/s", "--json").json


def test_a_new_club_goes_to_the_screen_or_starts_from_another(clubface_):
    assert clubface.Club.from_text(clubface_("club", "new").out).name == "my-club"
    like = clubface.Club.from_text(clubface_("club", "new", "lob", "--like", "9-iron").out)
    assert like.replace(name="9-iron") == clubface.club("9-iron")


def test_a_file_that_exists_is_not_overwritten(clubface_, tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text("precious")
    assert_mistake(clubface_("club", "new", "-o", str(file)), "exists already")
    assert file.read_text() == "precious"


def test_a_bad_club_file_is_told_with_its_line(clubface_, tmp_path):
    file = tmp_path / "bad.toml"
    file.write_text(clubface.Club.template().replace('mass = "204 g"', 'mass = "-204 g"'))
    line = next(i for i, text in enumerate(file.read_text().splitlines(), 1) if text.startswith("mass"))
    assert_mistake(clubface_("club", "check", str(file)), f"bad.toml:{line}:", "mass")


def test_sensitivities_are_printed_with_their_units(clubface_):
    arguments = ["sensitivity", "driver", "--speed", "113 mph", "--model", "volumetric", "--output", "backspin"]
    (entry,) = clubface_(*arguments, "--by", "high", "--json").json["derivatives"]
    table = clubface.sensitivity("driver", speed="113 mph", model="volumetric")
    assert entry["unit"] == "rpm per mm"
    assert entry["value"] == pytest.approx(table.value("backspin", "high", "rpm per mm"), rel=1e-12)
    text = clubface_(*arguments).out
    assert "high, per mm" in text
    assert "layer_damping, per N m s/rad" in text


def test_a_flight_is_that_of_the_library(clubface_):
    launch = ["--ball-speed", "167 mph", "--launch", "10.9 deg", "--backspin", "2700 rpm", "--sidespin", "-200 rpm"]
    row = clubface_("flight", *launch, "--json").json
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
    assert (ran.json["rows"], ran.json["written"], ran.json["rejected"]) == (3, 2, 1)
    with target.open() as file:
        first = next(csv.DictReader(file))
    shot = clubface.impact("driver", speed="113 mph", attack="-1.3 deg", model="volumetric")
    # The file holds nine digits.
    assert float(first["backspin_rpm"]) == pytest.approx(shot.get("backspin", "rpm"), rel=1e-8)
    assert "fast" in (tmp_path / "out.rejects.csv").read_text()
    assert "1 rejected" in clubface_("predict", str(source), "--club", "driver", "-o", str(target)).out


def test_a_file_without_one_usable_row_is_a_failure(clubface_, tmp_path):
    source = tmp_path / "in.csv"
    source.write_text("club_speed_mph\nfast\n")
    ran = clubface_("predict", str(source), "--club", "driver", "-o", str(tmp_path / "out.csv"))
    assert ran.status == 2
    assert "not one delivery" in ran.err


def test_the_tour_is_compared_and_written(clubface_, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr("clubface.tour.write", lambda result, folder: [folder / f"{len(result.clubs)} clubs"])
    ran = clubface_("tour", "--model", "standard,slip", "-o", str(tmp_path / "out"), "--json")
    assert len(ran.json["rows"]) == 24
    assert ran.err == f"clubface: wrote {tmp_path / 'out' / '12 clubs'}\n"
    assert (tmp_path / "out").is_dir()
    assert "no prediction" in " ".join(clubface_("tour", "--model", "standard").out.split())


# mistakes


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["shot", "drivr", "--speed", "50 m/s"], ["'drivr'", "did you mean driver"]),
        (["shot", "driver"], ["--speed", "113 mph"]),
        (["shot"], ["CLUB"]),
        (["shot", "driver", "--speed", "50 kg"], ["--speed", "m/s", "mass"]),
        (["shot", "driver", "--speed", "fifty"], ["--speed", "'fifty'"]),
        (["shot", "driver", "--speed", "nan"], ["--speed", "finite"]),
        (["shot", "driver", "--speed", "inf m/s"], ["--speed", "finite"]),
        (["shot", "driver", "--speed", "-50 m/s"], ["speed", "-50"]),
        (["shot", "driver", "--speed", "0 m/s"], ["speed"]),
        (["shot", "driver", "--speed", "50 m/s", "--loft", "95 deg"], ["loft", "95", "80"]),
        (["shot", "driver", "--speed", "50 m/s", "--toe", "90 mm"], ["toe", "90", "52.5"]),
        (["shot", "driver", "--speed", "50 m/s", "--attack", "170 deg"], ["attack"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", "volumetrik"], ["did you mean volumetric"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", ","], ["model"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "frictoin=1"], ["did you mean friction"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "friction"], ["--set", "name=value"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "friction=9"], ["friction", "0 to 2"]),
        (["shot", "driver", "--speed", "50 m/s", "--parameters", "pener"], ["did you mean penner"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", "area", "--parameters", "penner"], ["'penner'"]),
        (["shot", "driver", "--speed", "50 m/s", "--parameters", "none.toml"], ["none.toml", "No such file"]),
        (["shot", "none.toml", "--speed", "50 m/s"], ["none.toml", "No such file"]),
        (["shot", "driver", "--speed", "50 m/s", "--ball", "x"], ["ball", "published"]),
        (["shot", "driver", "--speed", "50 m/s", "--hand", "both"], ["hand", "left"]),
        (["shot", "driver", "--speed", "50 m/s", "--air", "temperatur=3"], ["did you mean temperature"]),
        (["shot", "driver", "--speed", "50 m/s", "--temperature", "3 m"], ["--temperature", "length"]),
        (["shot", "driver", "--speed", "50 m/s", "--wind", "1 m/s, 2 m/s, 3 m/s"], ["--wind"]),
        (["shot", "driver", "--speed", "50 m/s", "--accuracy", "fine"], ["--accuracy"]),
        (["shot", "driver", "--speed", "50 m/s", "--accuracy", "5"], ["accuracy"]),
        (["shot", "driver", "--speed", "50 m/s", "--plot", "a.doc"], [".png"]),
        (["shot", "driver", "--speed", "50 m/s", "--plot", "/nowhere/a.png"], ["/nowhere/a.png", "No such file"]),
        (["shot", "driver", "--spede", "50 m/s"], ["--spede", "--speed"]),
        (["shoot"], ["did you mean shot"]),
        (["clubs", "x"], ["club"]),
        (["models", "x"], ["model"]),
        (["club", "check", "none.toml"], ["none.toml"]),
        (["club", "new", "-o", "/nowhere/a.toml"], ["/nowhere/a.toml"]),
        (["predict", "none.csv", "--club", "driver"], ["none.csv"]),
        (["predict", "none.csv"], ["--club"]),
        (["sensitivity", "driver", "--speed", "50 m/s", "--output", "spin"], ["output", "backspin"]),
        (["sensitivity", "driver", "--speed", "50 m/s", "--by", "hight"], ["did you mean high"]),
        (["sensitivity", "driver", "--speed", "50 m/s", "--model", "all"], ["model"]),
        (["flight", "--ball-speed", "60 m/s"], ["--launch"]),
        (["tour", "-o", "/dev/null/out"], ["/dev/null/out"]),
    ],
)  # fmt: skip
def test_a_mistake_is_one_message_and_status_2(clubface_, arguments, words):
    assert_mistake(clubface_(*arguments), *words)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "empty"),
        ("attack_deg\n1\n", "speed"),
        ("club_speed_kg\n1\n", "speed"),
        ("club_speed_mph,club_speed_mph\n1,2\n", "club_speed_mph"),
    ],
)
def test_an_unusable_file_of_deliveries_is_one_message(clubface_, tmp_path, text, words):
    source = tmp_path / "in.csv"
    source.write_text(text)
    assert_mistake(clubface_("predict", str(source), "--club", "driver"), "in.csv", words)


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.sampled_from(["--speed", "--toe", "--air", "--set", "--wind", "--model", "--hand"]), st.text(max_size=12))
def test_no_text_brings_a_traceback(capsys, option, text):
    status = run(["shot", "driver", "--speed", "50 m/s", "--model", "standard", option, text])
    captured = capsys.readouterr()
    assert status in (0, 2)
    assert "Traceback" not in captured.err
    assert (captured.out == "") == (status == 2)


def test_a_mistake_of_the_program_is_told_from_one_of_the_user(clubface_, monkeypatch):
    monkeypatch.setattr("clubface.cli.shot.value", lambda *of: 1 / 0)
    ran = clubface_("shot", "driver", "--speed", "50 m/s", "--json")
    assert ran.status == 1
    assert "ZeroDivisionError" in ran.err
    assert "not yours" in ran.err


# width


@pytest.mark.parametrize("width", [40, 80, 120])
def test_no_line_of_a_table_exceeds_the_terminal(clubface_, monkeypatch, width):
    monkeypatch.setenv("COLUMNS", str(width))
    for arguments in (["shot", "driver", "--speed", "113 mph"], ["clubs"], ["models"], ["tour", "--model", "standard"]):
        ran = clubface_(*arguments)
        assert max(len(line) for line in ran.out.splitlines()) <= width
        assert "…" not in ran.out


def test_a_narrow_terminal_repeats_the_models_and_loses_no_column(clubface_, monkeypatch):
    monkeypatch.setenv("COLUMNS", "60")
    out = clubface_("shot", "driver", "--speed", "113 mph").out.split("\n* ")[0]
    assert out.count("volumetric") == 2
    assert len(re.findall(r"^volumetric(.*)$", out, re.MULTILINE)) == 2
    assert sum(len(line.split()) - 1 for line in out.splitlines() if line.startswith("volumetric")) == 12


# the process


def test_the_installed_entry_point_is_this_function():
    ran = process("--version")
    assert ran.stdout == f"clubface {clubface.__version__}\n"
    assert ran.returncode == 0


def test_a_shot_loads_nothing_slow_that_it_does_not_need():
    code = (
        "import sys; from clubface.cli import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "slow = {'pandas', 'xarray', 'matplotlib', 'pyarrow', 'rich', 'scipy'}\n"
        "print(sorted(slow & set(sys.modules)), file=sys.stderr)"
    )
    command = [sys.executable, "-c", code, "shot", "driver", "--speed", "113 mph"]
    for option in ([], ["--json"]):
        ran = subprocess.run([*command, *option], capture_output=True, text=True, check=True)
        assert ran.stderr == "[]\n"


def test_a_rule_warning_is_one_note(tmp_path):
    file = tmp_path / "big.toml"
    file.write_text(clubface.Club.template("big").replace("5679 g cm2", "6400 g cm2"))
    ran = process("shot", str(file), "--speed", "50 m/s", "--json")
    assert ran.stderr.count("\n") == 1
    assert ran.stderr.startswith("clubface: note: big: moment of inertia")
    assert len(json.loads(ran.stdout)) == len(clubface.models())


def test_a_reader_that_goes_away_is_no_error():
    for arguments in (["models", "--json"], ["models"], ["shot", "driver", "--speed", "50 m/s"]):
        command = [sys.executable, "-c", MAIN, *arguments]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
            assert child.stdout is not None
            assert child.stderr is not None
            child.stdout.close()
            assert child.stderr.read() == ""
        assert child.returncode == 141


def test_a_terminal_without_greek_letters_gets_its_table():
    ran = process("shot", "driver", "--speed", "50 m/s", env={**os.environ, "PYTHONIOENCODING": "ascii"})
    assert ran.returncode == 0
    assert "volumetric" in ran.stdout
    assert "-----" in ran.stdout


def test_ctrl_c_ends_with_one_line_and_status_130(tmp_path):
    source, target = tmp_path / "in.csv", tmp_path / "out.csv"
    source.write_text("club_speed_mph\n" + "113\n" * 300_000)
    command = [sys.executable, "-c", MAIN, "predict", str(source), "--club", "driver", "--model", "rings"]
    with subprocess.Popen([*command, "-o", str(target)], stderr=subprocess.PIPE, text=True) as child:
        started = time.monotonic()
        while not list(tmp_path.glob("*.part*")) and child.poll() is None and time.monotonic() - started < 30:
            time.sleep(0.02)
        child.send_signal(signal.SIGINT)
        assert child.stderr is not None
        said = child.stderr.read()
    assert child.returncode == 130
    assert said.startswith("clubface: interrupted")
    assert said.count("\n") == 1
    assert not target.exists()
