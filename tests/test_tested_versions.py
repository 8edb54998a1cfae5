"""The runs on the oldest and newest versions of dependencies: what they install, and what of them is on record."""

import json
import re

import pytest

from script_files import load_script

PYTHON = ("python3.11", "3.11.7", False)


@pytest.fixture
def script():
    return load_script("scripts/test_versions.py")


def numbers(version):
    """The numbers of a version without the zeros at its end."""
    parts = [int(part) for part in version.split(".") if part.isdigit()]
    while parts and parts[-1] == 0:
        parts.pop()
    return parts


def all_lines(script, versions):
    return [line for lines in script.requirements(versions).values() for line in lines]


def test_beyond_keeps_lower_bounds_and_drops_upper_ones(script):
    allowed = all_lines(script, "newest")
    beyond = all_lines(script, "beyond")
    assert any("<" in line for line in allowed)
    assert not any("<" in line for line in beyond)
    assert [line.split(",")[0] for line in allowed] == beyond


def test_an_extra_without_wheels_is_left_out_alone_and_with_its_reason(script, monkeypatch):
    def resolve(lines, versions, python):
        if any(line.startswith("ezc3d") for line in lines):
            return [], "ezc3d has no wheels"
        return [re.split("[<>=]", line)[0] + "==1" for line in lines], ""

    monkeypatch.setattr(script, "resolve", resolve)
    exact, left_out = script.resolve_all("oldest", script.Interpreter(*PYTHON))
    assert left_out == {"capture": "ezc3d has no wheels"}
    assert {"numpy==1", "openpyxl==1", "mujoco==1"} <= set(exact)
    assert "ezc3d==1" not in exact


def test_a_run_takes_the_place_of_an_earlier_one_of_the_same_kind(script, monkeypatch, tmp_path):
    monkeypatch.setattr(script, "RECORD", tmp_path / "runs.json")
    run = {"versions": "oldest", "python": "3.11", "machine": "Linux x86_64", "passed": 1}
    for each in (run, run | {"python": "3.13"}, run | {"passed": 2}):
        script.record(each)
    stored = json.loads((tmp_path / "runs.json").read_text())
    assert [(each["python"], each["passed"]) for each in stored] == [("3.11", 2), ("3.13", 1)]


def test_every_lower_bound_was_tested_on_the_oldest_python(script):
    """A bound that changes asks for `make test-oldest PYTHONS=python3.11 RECORD=1`."""
    oldest = script.PROJECT["requires-python"].removeprefix(">=")
    runs = json.loads(script.RECORD.read_text(encoding="utf-8"))
    run = next(each for each in runs if (each["versions"], each["python"]) == ("oldest", oldest))
    assert run["failed"] == 0
    assert run["tests"] == "all"
    for line in all_lines(script, "oldest"):
        name, bound = re.match(r"([\w-]+)>=([\d.]+)", line).groups()
        assert numbers(run["packages"][name]) == numbers(bound), line


def test_an_interpreter_that_is_not_there_is_named(script):
    with pytest.raises(SystemExit, match=r"python9\.9 is no program"):
        script.interpreter("python9.9")
