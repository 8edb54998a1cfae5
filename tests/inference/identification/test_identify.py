"""Whole identifications: parameters recovered, interrupted and resumed to the same bits, what is warned of."""

from __future__ import annotations

import dataclasses
import json

import numpy as np
import pytest

import clubface
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.inference.identification.checks import contradicted
from clubface.inference.identification.intervals import Profile
from clubface.simulation.inputs import equipped
from synthetic_shots import published, recorded, widths_in_standard_errors

# What 1e-4 means where the true value is 0: of other published displacements, 0.5 mm, and Penner's slope, 0.0029 s/m.
ZERO = {"dcg_x": 5e-8, "cor_slope": 2.9e-7}
QUICK = {"population": 30, "generations": 8, "refined": 3, "folds": 0, "bootstrap": 0, "profiles": ()}


@pytest.mark.parametrize(
    ("model", "club", "cost", "options"),
    [
        ("standard", "driver", "least-squares", {}),
        ("adjusted", "driver", "published", {}),
        ("adjusted", "7-iron", "robust", {}),
        ("slip", "7-iron", "published", {}),
        ("jorgensen", "driver", "published", {}),
        ("volumetric", "driver", "published", {}),
        ("volumetric", "7-iron", "least-squares", {}),
        ("rings", "driver", "published", {"generations": 4, "refined": 2}),
    ],
)
def test_parameters_come_back_from_shots_of_the_same_model(model, club, cost, options):
    shots = recorded(12 if model == "rings" else 30, model, club=club)
    result = clubface.identify(shots, club=club, model=model, cost=cost, **{**QUICK, **options})
    assert result.cost < 1e-8
    for name in result.free:
        true = published(model, club).values[name]
        assert result.parameters.values[name] == pytest.approx(true, rel=1e-4, abs=ZERO.get(name, 0.0))
    assert not any("no launch changes" in each.sentence for each in result.warnings)


FACES = [
    ("response", None),
    ("response", dataclasses.replace(published("response"), includes_face=False).replace(friction=0.4)),
    ("slip", None),
    ("volumetric", dataclasses.replace(published("volumetric"), includes_face=False)),
    ("slip", dataclasses.replace(published("slip"), characteristic_time=None)),
]


@pytest.mark.parametrize(("model", "parameters"), FACES)
def test_a_fit_begins_with_the_shots_of_the_parameters_it_is_given(model, parameters):
    """A face of 230 us counts, or is included, in the fit as in `impact`: at the true parameters nothing is left."""
    club = dataclasses.replace(clubface.club("driver"), characteristic_time=230e-6)
    shots = recorded(8, model, parameters=parameters, club="driver", head=club)
    free = ["friction"] if model in ("response", "volumetric") else ["slip_y"]
    result = clubface.identify(shots, club=club, model=model, parameters=parameters, free=free, **QUICK)
    assert all(each.mae_before <= 1e-12 * each.mean for each in result.deviations.values())
    true = equipped(model, club, None, parameters)[1].values[free[0]]
    assert result.parameters.values[free[0]] == pytest.approx(true, rel=1e-6)
    # Used again with this club, and with one whose face gives less, the set gives the shots of the original.
    for head in (club, dataclasses.replace(club, characteristic_time=200e-6)):
        if parameters is not None and parameters.characteristic_time is None and parameters.includes_face:
            head = club  # It included the face of any club; now that of the club the shots were hit with.
        shot = {"speed": 50.0, "loft": 0.2, "toe": 0.01, "model": model}
        again = clubface.impact(head, **shot, parameters=result.parameters).ball_speed
        assert again == pytest.approx(clubface.impact(head, **shot, parameters=parameters).ball_speed, rel=1e-6)


def test_unidentifiable_parameters_are_reported_and_the_rest_recovered():
    """The shear modulus G and Poisson's ratio nu of the area model enter as G / (1 - nu) alone."""
    result = clubface.identify(recorded(30, "area"), club="driver", model="area", **QUICK)
    values, true = result.parameters.values, published("area").values
    assert {name for name in result.free if result.identified(name) == "not alone"} == {"shear_modulus", "poisson"}
    assert any("poisson" in each.sentence and "no launch changes" in each.sentence for each in result.warnings)
    for name in ("damping", "friction"):
        assert values[name] == pytest.approx(true[name], rel=1e-4)
    stiffness = [each["shear_modulus"] / (1.0 - each["poisson"]) for each in (values, true)]
    assert stiffness[0] == pytest.approx(stiffness[1], rel=1e-4)
    # Its true value is its lower bound.
    assert values["area_damping"] == pytest.approx(0.0, abs=1e-2)
    assert result.intervals["poisson"] == (0.0, 0.499)


SMALL = {
    "club": "driver", "model": "slip", "free": ["cor", "slip_y", "slip_z"], "population": 10, "generations": 4,
    "refined": 2, "folds": 3, "bootstrap": 6, "seed": 3,
}  # fmt: skip


def small(**changes):
    return clubface.identify(recorded(25, "slip", noise=1.0), **{**SMALL, **changes})


def answer(result):
    document = result.to_dict()
    return json.dumps({**document, "values": {**document["values"], "wall_time_s": 0.0}})


class Stop:
    """Presses Ctrl-C when so many parts are finished."""

    def __init__(self, after):
        self.left = after

    def __call__(self, stage, done, total, best):
        self.left -= 1
        if self.left == 0:
            raise KeyboardInterrupt


# 4 generations, 2 refinements, 3 folds, 6 samples, 3 profiles: 18 parts.
@pytest.mark.parametrize("after", [1, 3, 4, 5, 8, 12, 17])
def test_an_interrupted_identification_resumes_to_the_same_bits(tmp_path, after):
    path = tmp_path / "fit.json"
    with pytest.raises(KeyboardInterrupt, match=r"kept in .*fit\.json; the same command"):
        small(checkpoint=path, progress=Stop(after))
    with pytest.raises(KeyboardInterrupt):
        small(checkpoint=path, progress=Stop(1), resume=True)
    assert answer(small(checkpoint=path, resume=True)) == answer(small())
    assert not path.exists()


def test_the_number_of_threads_changes_no_bit():
    assert answer(small(threads=1)) == answer(small(threads=3))


def test_another_seed_searches_elsewhere_and_finds_the_same_fit():
    one, other = small(), small(seed=4)
    assert answer(one) != answer(other)
    assert one.cost == pytest.approx(other.cost, rel=1e-6)


def test_a_checkpoint_of_something_else_is_refused(tmp_path):
    path = tmp_path / "fit.json"
    with pytest.raises(KeyboardInterrupt):
        small(checkpoint=path, progress=Stop(5))
    for changes in (
        {"seed": 4},
        {"free": ["slip_y"]},
        {"cost": "robust"},
        {"parameters": {"cor": 0.8}, "free": "slip_y"},
    ):
        with pytest.raises(FileError, match="begun with another"):
            small(checkpoint=path, resume=True, **changes)
    with pytest.raises(FileError, match="another set of shots"):
        clubface.identify(recorded(25, "slip", noise=1.0, seed=9), checkpoint=path, resume=True, **SMALL)
    # Damage, of what it is of and of what is finished: deep nesting and letters of another encoding as well.
    record = (path / "job.json").read_bytes()
    for name in ("job.json", "values.jsonl"):
        for content in (b"", b"[1]", b"\xff", b"[" * 100_000):
            (path / name).write_bytes(content)
            with pytest.raises(FileError, match="begun as other work, whose record is damaged"):
                small(checkpoint=path, resume=True, seed=4)
    (path / "job.json").write_bytes(record)
    assert answer(small(checkpoint=path, resume=True)) == answer(small())
    path = tmp_path / "mine.json"
    path.write_text("{}")
    for resume in (True, False):
        with pytest.raises(FileError, match="not a record of unfinished work"):
            small(checkpoint=path, resume=resume)
    assert path.read_text() == "{}"
    with pytest.raises(FileError, match="there is no folder"):
        small(checkpoint=tmp_path / "none" / "fit.json")
    assert small(checkpoint=tmp_path / "none.json", resume=True).cost > 0.0


def test_the_number_of_evaluations_is_that_of_the_published_search():
    result = small(folds=0, bootstrap=0, profiles=())
    assert result.evaluations >= 40 + 2 * 2
    assert result.impacts == result.evaluations * 25
    assert result.method == "information"
    assert np.isnan(result.cost_holdout)


def test_the_hold_out_and_the_intervals_say_what_a_fit_is_worth():
    result = small(folds=5, bootstrap=60, noise={"backspin": "60 rpm"})
    # Held out, a fit is worse than on what it was made from; three parameters on 25 shots cost it little.
    assert result.cost < result.cost_holdout < 1.5 * result.cost
    # The held-out launches themselves: the published cost of them is the one stated.
    assert result.held_out is not None
    measured = np.array([recorded(25, "slip", noise=1.0).launches[name] for name in result.deviations])
    parts = np.abs(result.held_out - measured).mean(axis=1) / np.abs(measured).mean(axis=1)
    assert parts.sum() == pytest.approx(result.cost_holdout, rel=1e-12)
    assert set(result.intervals) == {"cor", "slip_y", "slip_z"}
    # 60 samples know an end of an interval to 15%; the cost costs up to twice the least error there can be.
    ratios = widths_in_standard_errors(result)
    assert all(0.7 < ratio < 2.5 for ratio in ratios.values()), ratios
    assert result.deviations["backspin"].mae < result.deviations["backspin"].mae_holdout


def test_the_parameters_are_a_set_to_use_and_to_write(write):
    result = small()
    path = write(result.to_toml(), "fit.toml")
    read = clubface.ParameterSet.from_toml(path)
    assert dict(read.values) == dict(result.parameters.values)
    assert "95% intervals: cor 0.8" in read.caveats[-1]
    launch = clubface.impact("driver", speed=50.0, model="slip", parameters=result.parameters)
    assert launch.ball_speed == clubface.impact("driver", speed=50.0, model="slip", parameters=path).ball_speed
    text = repr(result)
    assert text.startswith("Parameters of slip from 25 shots with driver")
    assert "slip_y" in text
    assert "backspin" in text


def test_a_fit_at_a_bound_is_warned_of():
    # The true slip ratio is -0.0103.
    shots = recorded(20, "slip", noise=0.1)
    result = clubface.identify(shots, club="driver", model="slip", bounds={"slip_y": (-0.01, 0.5)}, **QUICK)
    assert {"parameter": "slip_y", "side": "lower", "bound": "-0.01"} in [each.data for each in result.warnings]
    # A value at a bound is not found but stopped; the others are found.
    assert result.at_bound == ("slip_y",)
    assert {name: result.identified(name) for name in result.free if name != "slip_y"} == {"slip_z": "yes"}
    assert result.identified("slip_y") == "at its bound"
    rows = {row["parameter"]: row for row in result.to_dict()["tables"]["parameters"]["rows"]}
    assert (rows["slip_y"]["identified"], rows["slip_y"]["at_bound"]) == ("at its bound", True)
    assert clubface.identify(shots, club="driver", model="slip", **QUICK).warnings == ()


def test_a_parameter_whose_interval_does_not_hold_its_value_is_not_called_identified():
    result = clubface.identify(recorded(20, "slip", noise=0.1), club="driver", model="slip", **QUICK)
    assert result.identified("slip_z") == "yes"
    value = float(result.parameters.values["slip_z"])
    for interval in ((value + 0.01, value + 0.02), (value - 0.02, value - 0.01)):
        moved = dataclasses.replace(result, intervals={**result.intervals, "slip_z": interval})
        assert moved.identified("slip_z") == "contradicted"
        warned = contradicted(result.parameters.values, moved.intervals, {})
        assert (warned[0].code, warned[0].data) == ("fit-contradicted", {"names": ["slip_z"]})
    held = Profile("slip_z", np.array([]), np.array([]), (value + 0.01, value + 0.02), (True, True))
    assert dataclasses.replace(result, profiles={"slip_z": held}).identified("slip_z") == "contradicted"
    assert contradicted(result.parameters.values, result.intervals, {}) == []


def test_a_fit_that_makes_a_quantity_worse_says_so():
    # Backspin 30% too high, which takes another slip ratio; with it, the launch angle is that of no shot.
    shots = recorded(25, "slip")
    spoiled = {**shots.launches, "backspin": 1.3 * shots.launches["backspin"]}
    shots = dataclasses.replace(shots, launches=spoiled)
    result = clubface.identify(shots, club="driver", model="slip", free=["slip_y"], **QUICK)
    better, spoilt = result.deviations["backspin"], result.deviations["launch"]
    assert better.mae < better.mae_before
    assert spoilt.mae > spoilt.mae_before
    (warned,) = [each.data["names"] for each in result.warnings if each.code == "fit-worse"]
    names = [name.split()[0] for name in warned]
    assert "launch" in names
    assert "backspin" not in names
    assert "deg before)" in warned[names.index("launch")]
    # Before is the published set, which is impact's own.
    launch = clubface.impact("driver", shots.delivery(), model="slip")
    off = np.mean(np.abs(launch.backspin - shots.launches["backspin"]))
    assert better.mae_before == pytest.approx(off, rel=1e-9)


def test_an_unphysical_contact_is_warned_of():
    shots = recorded(20, "area")
    options = {"club": "driver", "model": "area", "free": ["friction", "damping"], **QUICK}
    # G 17 times too large: contact of some 170 us at 36 kN.
    warned = {
        each.code for each in clubface.identify(shots, parameters={"shear_modulus": "9e8 Pa"}, **options).warnings
    }
    assert warned >= {"fit-contact-time", "fit-peak-force"}
    warned = {each.code for each in clubface.identify(shots, **options).warnings}
    assert not warned & {"fit-contact-time", "fit-peak-force"}


def test_an_evaluation_finds_the_cost_of_the_fit():
    result = small()
    shots = recorded(25, "slip", noise=1.0)
    evaluated = clubface.evaluate(
        shots, club="driver", models=["slip"], parameters={"slip": result.parameters}, resamples=100
    )
    assert evaluated.cost("slip") == pytest.approx(result.cost, rel=1e-12)


@pytest.mark.parametrize(
    ("changes", "text"),
    [
        ({"population": 2}, "population is 2; it must be a whole number from 4"),
        ({"folds": 1}, "folds is 1"),
        ({"generations": 1.5}, "generations is 1.5"),
        ({"confidence": 95}, "confidence is 95"),
        ({"profiles": ["friction"]}, "profiles is 'friction'"),
        ({"quantities": ["carry"]}, "carry"),
        ({"model": "fem"}, "one with derivatives"),
        ({"parameters": {"cor": np.array([0.8, 0.81])}}, "a single number"),
        ({"mismatch": "ignore"}, "refuse"),
    ],
)
def test_an_option_out_of_its_range_is_named(changes, text):
    with pytest.raises((InputError, UnknownNameError), match=text):
        small(**changes)
