"""What the comparison of two recordings of the command line calls the same, moved, converted, refined and lost."""

import json
import runpy
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).parents[1] / "scripts"
compare_output = runpy.run_path(str(SCRIPTS / "golden_comparison.py"))["compare_output"]
BEFORE = {"speed_mph": 112.34567890123, "shots": [1.25, 2.5], "notes": ["a note"], "model": "slip"}


def compared(after, before=BEFORE, output="1.out", rest=()):
    texts = [each if isinstance(each, str) else json.dumps(each) for each in (before, after)]
    return compare_output(output, *texts, list(rest))


def test_equal_outputs_do_not_differ():
    assert compared(BEFORE) is None


def test_a_number_that_moves_is_kept():
    difference = compared(
        {"launch": {"speed_mph": 112.34567890123}, "shots": [2.5, 1.25], "notes": [], "model": "slip"}
    )
    assert (difference.removed, difference.added, difference.texts) == (
        ["speed_mph", "notes[]"],
        ["launch.speed_mph"],
        ["a note"],
    )
    assert len(difference.moved) == 2
    assert (difference.changed, difference.kept.lost, difference.kept.fewer, difference.bad) == ([], [], [], False)


def test_a_number_that_is_in_si_now_is_kept():
    difference = compared(
        {name: BEFORE[name] for name in ("shots", "notes", "model")} | {"speed": 112.34567890123 * 0.44704}
    )
    assert (difference.kept.same, difference.kept.converted, difference.kept.lost, difference.bad) == (2, 1, [], False)


@pytest.mark.parametrize("value", [112.34567890123 * (1 + 1e-11), -112.34567890123, 112.3])
def test_a_number_that_changes_under_its_key_is_listed(value):
    difference = compared(BEFORE | {"speed_mph": value})
    assert len(difference.changed) == 1
    assert difference.bad


def test_a_number_that_goes_is_lost_and_one_that_stands_once_instead_of_twice_is_not():
    difference = compared({"shots": [1.25]}, before={"shots": [1.25, 1.25, 7.77]})
    assert [each.place for each in difference.kept.lost] == ["shots[2]"]
    assert [each.value for each in difference.kept.fewer] == [1.25]
    assert difference.bad


def test_a_printed_number_may_get_more_digits_but_no_other_value():
    printed = "speed,carry (yd)\n112.3,255.0\n"
    difference = compared("speed,carry (yd)\n112.345678901234,233.1720012345\n", printed, "files/a.html.saved/a.csv")
    assert (difference.kept.refined, difference.kept.lost, difference.bad) == (2, [], False)
    difference = compared("speed,carry (yd)\n112.445678901234,255.0\n", printed, "files/a.html.saved/a.csv")
    assert [each.value for each in difference.kept.lost] == [112.3]
    assert difference.bad


def test_recordings_are_compared_run_by_run(tmp_path):
    for name, speed, status in (("one", 1.5, 0), ("two", 1.5, 0), ("three", 1.6, 2)):
        folder = tmp_path / name / "shot" / "json"
        folder.mkdir(parents=True)
        (folder / "commands.json").write_text(json.dumps([{"command": "shot driver", "status": status}]))
        (folder / "1.out").write_text(json.dumps({"speed": speed, "wall_s": len(name)}))
    for other, status, words in (("two", 0, "1 the same to the last byte"), ("three", 1, "1 to look at")):
        asked = [
            sys.executable,
            SCRIPTS / "golden_outputs.py",
            "compare",
            tmp_path / "one",
            tmp_path / other,
            "-o",
            tmp_path / "report.md",
        ]
        ran = subprocess.run(asked, capture_output=True, text=True, check=False)
        assert (ran.returncode, words in ran.stdout) == (status, True)
    assert "speed: 1.5 -> 1.6" in (tmp_path / "report.md").read_text()


def test_every_run_has_commands_and_a_name_of_two_parts_at_most():
    document = tomllib.loads((SCRIPTS / "golden_runs.toml").read_text())
    runs = document["run"] | document["long"]
    assert len(runs) == len(document["run"]) + len(document["long"]) > 120
    assert all(lines.strip() and name.count("/") <= 1 for name, lines in runs.items())
