"""Numbers that options cannot have are refused in one line that names the option, before any work begins."""

from __future__ import annotations

import pytest
import typer
from typer.core import TyperGroup

pytest.importorskip("ezc3d")
pytest.importorskip("pyarrow")

from clubface.cli.app import app
from command_line import assert_mistake

HUGE = "1" + "0" * 30
SHOT = ("--speed", "110 mph", "--model", "area")
ARGUMENTS = {
    "shot": ("driver", *SHOT), "predict": ("shots.csv", "--club", "driver", "--model", "area", "-o", "out.csv"),
    "identify": ("shots.csv", "--club", "driver", "--model", "slip", "-o", "fit.toml"),
    "sensitivity": ("driver", *SHOT),
    "explain": ("driver", *SHOT), "compare": ("driver", "3-wood", *SHOT), "map": ("driver", *SHOT),
    "monitor listen": ("--port", "0"),
    "monitor send": ("shots.csv",), "dispersion": ("tour-driver",),
    "best-loft": ("--speed", "100 mph", "--model", "area"),
    "evaluate": ("shots.csv", "--club", "driver"), "fem head": ("paper", "--measure"), "fem face": ("paper",),
    "infer": ("--ball-speed", "150 mph", "--launch", "12 deg", "--club", "driver"),
    "fem design": ("faster_face.toml",),
    "fem reference": (), "fem run": ("paper",), "fem sweep": (), "capture synthesize": ("-o", "swings"),
    "capture read": ("swing.c3d", "--markers", "markers.toml", "--club", "driver"), "capture study": (),
    "export casadi": ("driver", "-o", "impact.c"),
    "study run": ("study.toml",), "studio": ("--site", "nowhere"),
}  # fmt: skip
"""What a command needs beside the option; files that are not there are not missed, where nothing is read before."""
NUMBERS = ("0", "-1", "nan", "inf", HUGE, "")
TEXTS = {
    ("map", "--grid"): ("0x0", "1x1", "-3x5", "nanxnan", "2x2", "99999x99999", "5"),
    ("study run", "--shard"): ("3/2", "0/2", "-1/2", "1/0", "a/b", "nan", "1/1/1", ""),
    ("monitor send", "--shot"): ("0", "-1", "5:2", "99", "nan", ""),
    ("monitor send", "--pause"): ("-1", "nan", HUGE, ""), ("monitor send", "--timeout"): NUMBERS,
    ("monitor listen", "--timeout"): NUMBERS, ("fem face", "--toe"): ("0:10:0", "0:10:-1", "nan", ""),
    ("fem sweep", "--speed"): ("30:45:0", "nan", ""), ("fem sweep", "--loft"): ("8:10:0", "nan", ""),
    ("fem head", "--impact-speed"): NUMBERS, ("capture study", "--noise"): ("-1", "nan", HUGE, ""),
    ("dispersion", "--hole"): NUMBERS, ("map", "--spread"): ("0", "-1", "nan", "0 mm x 5 mm", ""),
}  # fmt: skip
"""Texts of options that hold numbers, and what is none of theirs."""
TAKEN = {
    ("--folds", "0"), ("--bootstrap", "0"), ("--seed", "0"), ("--gaps", "0"), ("--frames", "0"), ("--friction", "0"),
    ("--port", "0"), ("--open-connect", "0"), ("--opengolfsim", "0"), ("--roughness", HUGE),
}  # fmt: skip
"""Numbers that mean something: none, the seed 0, any free port, a track as smooth as can be."""


def commands(group, path=()):
    if isinstance(group, TyperGroup):
        for name in group.list_commands(typer.Context(group)):
            yield from commands(group.get_command(typer.Context(group), name), (*path, name))
    else:
        yield " ".join(path), group


NUMERIC = [
    (name, option.opts[0])
    for name, command in commands(typer.main.get_command(app))
    for option in command.params
    if "int" in option.type.name or "float" in option.type.name
]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "shots.csv").write_text(
        "club_speed_mph,attack_deg,loft_deg,ball_speed_mph,launch_deg,backspin_rpm\n"
        + "".join(f"{100 + i},{i % 5 - 2},{11 + i % 4},{146 + i % 9},{12 + i % 3},{2500 + 9 * i}\n" for i in range(20))
    )
    (tmp_path / "study.toml").write_text('[impact]\nclub = "driver"\n[sweep]\nspeed = ["100 mph"]\n')
    monkeypatch.chdir(tmp_path)


def test_every_command_with_a_number_is_tried():
    assert {name for name, _ in (*NUMERIC, *TEXTS)} <= ARGUMENTS.keys()


@pytest.mark.parametrize(
    ("name", "option", "values"), [*((*each, NUMBERS) for each in NUMERIC), *((*each, TEXTS[each]) for each in TEXTS)]
)
def test_a_number_that_an_option_cannot_have_is_refused_in_one_line(clubface_, folder, name, option, values):
    for value in values[:2] if name.startswith("fem") else values:  # heads take long to be read
        read_first = name in ("fem design", "capture read") and value != ""
        if (option, value) not in TAKEN and not read_first:
            ran = clubface_(*name.split(), *ARGUMENTS[name], f"{option}={value}")
            assert_mistake(ran)
            assert option in ran.err or option.strip("-").replace("-", " ") in ran.err, (value, ran.err)
