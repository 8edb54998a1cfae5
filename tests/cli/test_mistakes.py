"""Mistakes on the command line: one message on the error stream, status 2, no traceback."""

import sys

import pytest
from hypothesis import given, settings, strategies as st

from command_line import assert_mistake

pytest.importorskip("typer")
pytest.importorskip("rich")

from clubface.cli.app import run


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["shot", "drivr", "--speed", "50 m/s"], ["'drivr'", "did you mean driver"]),
        (["shot", "driver"], ["--speed", "113 mph"]),
        (["shot"], ["CLUB"]),
        (["shot", "driver", "--speed", "105 mph", "--shaft", "titanium"], ["titanium", "graphite"]),
        (["shot", "driver", "--speed", "50 kg"], ["--speed", "m/s", "mass"]),
        (["shot", "driver", "--speed", "fifty"], ["--speed", "'fifty'"]),
        (["shot", "driver", "--speed", "113 mhp"], ["--speed", "'113 mhp'", "did you mean mph"]),
        (["shot", "driver", "--speed", "50 m/s", "--altitude", "20 km"], ["--altitude", "'20 km'", "m or mm"]),
        (["shot", "driver", "--speed", "50 m/s", "--altitude", "20000 m"], ["--altitude", "20000 m", "9100 m"]),
        (["shot", "driver", "--speed", "nan"], ["--speed", "finite"]),
        (["shot", "driver", "--speed", "inf m/s"], ["--speed", "finite"]),
        (["shot", "driver", "--speed", "-50 m/s"], ["--speed", "-50"]),
        (["shot", "driver", "--speed", "0 m/s"], ["speed"]),
        (["shot", "driver", "--speed", "50 m/s", "--loft", "95 deg"], ["loft", "95", "80"]),
        (["shot", "driver", "--speed", "50 m/s", "--toe", "90 mm"], ["--toe", "90", "52.5"]),
        (["shot", "driver", "--speed", "50 m/s", "--attack", "170 deg"], ["attack"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", "volumetrik"], ["did you mean volumetric"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", ","], ["model"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "frictoin=1"], ["did you mean friction"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "friction"], ["--set", "name=value"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "friction=9"], ["friction", "0 to 2"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", "all", "--parameters", "pener"], ["did you mean penner"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", "area", "--parameters", "penner"], ["--model standard"]),
        (["shot", "driver", "--speed", "50 m/s", "--parameters", "penner"], ["--parameters", "--model standard"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "cor=0.8"], ["'cor'", "standard or adjusted or slip"]),
        (["shot", "driver", "--speed", "50 m/s", "--set", "colour=1"], ["'colour'", "friction, time", "in all"]),
        (["shot", "driver", "--speed", "50 m/s", "--parameters", "none.toml"], ["none.toml", "No such file"]),
        (["shot", "none.toml", "--speed", "50 m/s"], ["none.toml", "No such file"]),
        (["shot", "driver", "--speed", "50 m/s", "--ball", "x"], ["ball", "published"]),
        (["shot", "driver", "--speed", "50 m/s", "--hand", "both"], ["hand", "left"]),
        (["shot", "driver", "--speed", "50 m/s", "--air", "temperatur=3"], ["did you mean temperature"]),
        (["shot", "driver", "--speed", "50 m/s", "--temperature", "3 m"], ["--temperature", "length"]),
        (["shot", "driver", "--speed", "50 m/s", "--wind", "1 m/s, 2 m/s, 3 m/s"], ["--wind"]),
        (["shot", "driver", "--speed", "50 m/s", "--wind", "1 m/s, 900 m/s"], ["--wind: 900 m/s"]),
        (["shot", "driver", "--speed", "50 m/s", "--accuracy", "fine"], ["--accuracy"]),
        (["shot", "driver", "--speed", "50 m/s", "--accuracy", "5"], ["--accuracy"]),
        (["shot", "driver", "--speed", "50 m/s", "--accuracy", "1e-6"], ["--accuracy", "leave it out", "volumetric"]),
        (["shot", "driver", "--speed", "50 m/s", "--model", "rings", "--accuracy", "5"], ["--accuracy", "1e-13"]),
        (["shot", "driver", "--speed", "50 m/s", "--plot", "a.doc"], ["--plot", "a.doc", ".png"]),
        (["shot", "driver", "--speed", "50 m/s", "--plot", "/nowhere/a.png"], ["a.png", "a folder that exists"]),
        (["shot", "driver", "--spede", "50 m/s"], ["--spede", "--speed"]),
        (["shoot"], ["did you mean shot"]),
        (["clubs", "x"], ["club"]),
        (["models", "x"], ["model"]),
        (["club", "check", "none.toml"], ["none.toml"]),
        (["club", "new", "-o", "/nowhere/a.toml"], ["/nowhere/a.toml"]),
        (["predict", "none.csv", "--club", "driver"], ["none.csv"]),
        (["predict", "none.csv"], ["--club"]),
        (["sensitivity", "driver", "--speed", "50 m/s", "--output", "spin"], ["output", "backspin"]),
        (["sensitivity", "driver", "--speed", "50 m/s", "--output", "carry"], ["carry", "explain", "compare"]),
        (["sensitivity", "driver", "--speed", "50 m/s", "--by", "hight"], ["did you mean high"]),
        (["sensitivity", "driver", "--speed", "50 m/s", "--model", "all"], ["model"]),
        (["flight", "--ball-speed", "60 m/s"], ["--launch"]),
        (["identify", "none.csv", "--club", "driver"], ["--model is missing", "--model slip"]),
        (["tour", "-o", "/dev/null/out"], ["/dev/null/out"]),
    ],
)  # fmt: skip
def test_a_mistake_is_one_message_and_status_2(clubface_, arguments, words):
    assert_mistake(clubface_(*arguments), *words)


@pytest.mark.parametrize(
    ("arguments", "kinds"),
    [
        (["predict", "none.csv", "--club", "driver"], ".csv or .tsv or .parquet"),
        (["infer", "--club", "driver", "--ball-speed", "160 mph"], ".csv, .tsv, .parquet"),
        (["identify", "none.csv", "--club", "driver"], ".toml"),
        (["monitor", "read", "none.csv"], ".csv, .tsv, .parquet"),
        (["monitor", "listen"], ".csv, .tsv, .parquet"),
        (["capture", "read", "none.c3d", "--markers", "none.toml", "--club", "driver"], ".csv, .tsv, .parquet"),
        (["capture", "join", "none.csv", "none.csv"], ".csv, .tsv, .parquet"),
        (["capture", "template"], ".toml"),
        (["club", "new"], ".toml"),
    ],
)  # fmt: skip
def test_a_file_of_an_unknown_kind_is_refused_before_any_work(clubface_, tmp_path, monkeypatch, arguments, kinds):
    monkeypatch.chdir(tmp_path)
    assert_mistake(clubface_(*arguments, "-o", "x.txt"), "x.txt", kinds)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "empty"),
        ("attack_deg\n1\n", "speed"),
        ("club_speed_kg\n1\n", "speed"),
        ("club_speed_mph,club_speed_mph\n1,2\n", "club_speed_mph"),
    ],
)
def test_an_unusable_file_of_deliveries_is_one_message(clubface_, write, text, words):
    source = write(text, "in.csv")
    assert_mistake(clubface_("predict", str(source), "--club", "driver"), "in.csv", words)


@settings(max_examples=60)
@given(st.sampled_from(["--speed", "--toe", "--air", "--set", "--wind", "--model", "--hand"]), st.text(max_size=12))
def test_no_text_brings_a_traceback(capsys, option, text):
    status = run(["shot", "driver", "--speed", "50 m/s", "--model", "standard", option, text])
    captured = capsys.readouterr()
    assert status in (0, 2)
    assert "Traceback" not in captured.err
    assert (captured.out == "") == (status == 2)


def test_a_library_that_is_not_installed_is_named_with_its_extra(clubface_, monkeypatch):
    for name in [name for name in sys.modules if name.startswith(("matplotlib", "clubface.plots", "clubface.present"))]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    ran = clubface_("shot", "driver", "--speed", "50 m/s", "--plot", "a.png")
    assert_mistake(ran, "matplotlib", "pip install 'clubface[plots]'")


def test_a_mistake_of_the_program_is_not_blamed_on_the_user(clubface_, monkeypatch):
    monkeypatch.setattr("clubface.simulation.shot_result.shot_result", lambda *_, **__: 1 / 0)
    ran = clubface_("shot", "driver", "--speed", "50 m/s", "--json")
    assert ran.status == 1
    assert "ZeroDivisionError" in ran.err
    assert "not your mistake" in ran.err


def test_a_mistake_in_an_option_says_where_the_options_are_listed(clubface_):
    assert "(clubface shot --help lists the options)" in clubface_("shot", "driver", "--sped", "50 m/s").err
