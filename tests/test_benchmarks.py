"""The results that stand next to the times of docs/benchmarks.md are those of the package."""

import json

import pytest

import clubface
from clubface import fem
from script_files import ROOT, load_script

measure = load_script("benchmarks/measure.py")
STORED = json.loads((ROOT / "docs" / "benchmarks.json").read_text(encoding="utf-8"))


def test_every_section_is_there_and_says_where_it_was_measured():
    assert set(STORED) == {*measure.SECTIONS, "lulesh"}
    assert all(set(each["measured"]) == set(measure.machine()) for each in STORED.values())


@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
@pytest.mark.parametrize("model", [name for name in STORED["models"] if name not in ("measured", "fem")])
def test_the_timed_drive_of_a_model_is_the_drive_of_today(model):
    launch = clubface.impact("driver", measure.DRIVE, model=model)
    computed = {"ball_speed": float(launch.ball_speed), "backspin": float(launch.backspin)}
    assert {name: STORED["models"][model][name] for name in computed} == measure.rounded(computed)


def test_the_timed_reference_case_is_that_of_the_package():
    run = fem.reference()
    for stored in STORED["elements"]["reference"][: len(measure.THREADS)]:
        here = measure.rounded({"steps": run.steps, "backspin": run.backspin, "peak_force": run.peak_force})
        assert {name: stored[name] for name in here} == here
    assert STORED["browser"]["reference"]["steps"] == run.steps
