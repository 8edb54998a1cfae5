"""Fits and evaluations at the measured launch: lofts that a monitor computed from the ball do not enter."""

import json
from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface.errors import InputError
from clubface.inference.identification.problem import free_parameters, prepared_shots
from clubface.inference.identification.simulator import Simulator
from clubface.shots.measured import measured_shots
from monitor_sessions import session
from synthetic_shots import published

TRUE = {"slip_y": 0.25, "slip_z": 0.25}
QUICK = {
    "club": "7-iron", "model": "slip", "cost": "least-squares", "population": 30, "generations": 8, "refined": 2,
    "folds": 0, "bootstrap": 0, "profiles": (),
}  # fmt: skip


@pytest.fixture(scope="module")
def radar():
    return session("7-iron", 60, ratio=1.137, model="slip", parameters=TRUE)


def test_a_fit_with_lofts_computed_from_the_ball_is_biased_and_one_at_the_measured_launch_is_not(radar):
    usual = clubface.identify(radar, **QUICK)
    at_launch = clubface.identify(radar, **QUICK, compared_at="launch")
    assert at_launch.parameters.values["slip_y"] == pytest.approx(0.25, abs=0.005)
    # The side is known from a spin of some hundred rpm and 0.2 degrees of azimuth.
    assert at_launch.parameters.values["slip_z"] == pytest.approx(0.25, abs=0.05)
    assert usual.parameters.values["slip_y"] > 0.262
    assert usual.intervals["slip_y"][0] > 0.262
    assert usual.parameters.values["slip_z"] > 0.7


def test_fits_say_of_computed_lofts_what_they_are_and_what_to_do(radar):
    usual = clubface.identify(radar, **QUICK)
    assert usual.notes[0].data["ratio"] == pytest.approx(1.137)
    assert usual.notes[1].code == "loft-computed-advice"
    (origin,) = json.loads(json.dumps(usual.to_dict()))["tables"]["loft_origins"]["rows"]
    assert origin["origin"] == "computed from the ball"
    assert origin["ratio"] == pytest.approx(1.137)
    at_launch = clubface.identify(radar, **QUICK, compared_at="launch")
    assert [each.code for each in at_launch.notes[:2]] == ["compared-at-launch", "file-lofts-not-used"]
    assert at_launch.to_dict()["provenance"]["inputs"]["compared_at"] == "launch"
    camera = clubface.identify(session("7-iron", 60, model="slip", parameters=TRUE), **QUICK)
    assert "loft-computed-advice" not in {each.code for each in camera.notes}


def test_lofts_and_faces_of_the_file_change_nothing_at_the_measured_launch(radar):
    shifted = replace(
        radar, deliveries=radar.deliveries | {name: radar.deliveries[name] + 0.02 for name in ("loft", "face")}
    )
    bare = replace(
        radar, deliveries={name: each for name, each in radar.deliveries.items() if name not in ("loft", "face")}
    )
    fits = [clubface.identify(shots, **QUICK, compared_at="launch") for shots in (radar, shifted, bare)]
    assert fits[0].parameters.values == fits[1].parameters.values == fits[2].parameters.values
    assert "static-loft-stands-in" not in {each.code for each in fits[2].notes}


@pytest.mark.parametrize(("model", "free"), [("slip", ["cor", "slip_y", "slip_z"]), ("response", ["friction"])])
@pytest.mark.parametrize("with_azimuth", [True, False])
def test_derivatives_hold_how_loft_and_face_follow_the_parameters(model, free, with_azimuth):
    shots = session("7-iron", 6)
    if not with_azimuth:
        shots = replace(shots, launches={name: each for name, each in shots.launches.items() if name != "azimuth"})
    chosen = free_parameters(published(model, "7-iron"), free)
    prepared = prepared_shots(shots, club="7-iron", parameters=chosen.fixed, compared_at="launch")
    simulator = Simulator(prepared, chosen)
    point = chosen.points(np.array([chosen.fixed.values[name] for name in chosen.names]))
    values, slopes = simulator.derivatives(point)
    assert prepared.met == (["launch", "azimuth"] if with_azimuth else ["launch"])
    assert values == pytest.approx(simulator.launch(point), rel=1e-6)
    for place in range(len(free)):
        step = 1e-4 * np.eye(len(free))[place]
        ends = simulator.launches(np.array([point - step, point + step]))
        expected = (ends[:, 1] - ends[:, 0]) / 2e-4
        # Launches are met to 1e-10 rad, a spin to some 1e-6 rad/s, over 2e-4.
        assert slopes[:, place] == pytest.approx(expected, rel=1e-3, abs=0.02)


def test_every_shot_of_every_point_meets_its_launch_whatever_company_it_is_in():
    shots = session("driver", 7)
    chosen = free_parameters(published("slip"), ["cor", "slip_y"])
    prepared = prepared_shots(shots, club="driver", parameters=chosen.fixed, compared_at="launch")
    simulator = Simulator(prepared, chosen)
    points = np.array([[0.3, 0.4], [0.5, 0.6], [0.7, 0.2]])
    together = simulator.launches(points)
    alone = simulator.of(prepared.select(np.array([4, 2]))).launch(points[1])
    assert np.array_equal(together[:, 1, [4, 2]], alone)
    values = dict(zip(chosen.names, chosen.values(points[1]).tolist(), strict=True))
    one = clubface.impact_at_launch(
        "driver", {name: each[4] for name, each in shots.deliveries.items() if name not in ("loft", "face")},
        launch=shots.launches["launch"][4], azimuth=shots.launches["azimuth"][4], model="slip", parameters=values,
    )  # fmt: skip
    assert alone[list(prepared.quantities).index("backspin"), 0] == pytest.approx(one.launch.backspin, rel=1e-7)


def test_a_shot_that_no_loft_launches_so_is_left_out_with_its_row():
    shots = session("7-iron", 12)
    shots.launches["launch"][3] = 1.4
    computed = clubface.identify(shots, **QUICK, compared_at="launch")
    assert [(each.line, "no loft" in each.reason) for each in computed.dropped] == [(5, True)]
    result = clubface.evaluate(shots, club="7-iron", models="slip", compared_at="launch", resamples=100)
    assert [(each.line, "no loft" in each.reason) for each in result.failed] == [(5, True)]


def test_an_evaluation_at_the_measured_launch_sees_the_model_that_made_the_shots(radar):
    how = {"club": "7-iron", "models": "slip", "resamples": 100, "parameters": {"slip": TRUE}}
    usual, at_launch = (clubface.evaluate(radar, **how, compared_at=each) for each in ("delivery", "launch"))
    spin = [each.sizes["backspin"]["slip"] for each in (usual, at_launch)]
    assert spin[0].bias_interval.high < 0.0
    # 0.2 degrees in the 7 between launch and normal are 3% of the spin of a shot, 0.4% of the mean of 60.
    assert spin[1].bias == pytest.approx(0.0, abs=0.01 * at_launch.mean["backspin"])
    assert at_launch.quantities == ["ball_speed", "backspin", "sidespin"]
    assert at_launch.to_dict()["values"]["compared_at"] == "launch"
    assert usual.to_dict()["tables"]["loft_origins"]["rows"][0]["origin"] == "computed from the ball"
    assert "loft-computed-advice" in {each["code"] for each in usual.to_dict()["notes"]}


def test_what_measurement_alone_explains_holds_the_noise_of_the_launch_that_is_met():
    # Mean errors of 0.2 degrees and 50 rpm, as the monitor's are taken to be.
    shots = session("7-iron", 40, noise=1.25, model="slip", parameters=TRUE)
    how = {"club": "7-iron", "models": "slip", "resamples": 100, "parameters": {"slip": TRUE}}
    at_launch = clubface.evaluate(shots, **how, compared_at="launch")
    assert at_launch.floor["backspin"] == pytest.approx(at_launch.sizes["backspin"]["slip"].mae, rel=0.25)
    assert at_launch.floor["backspin"] > 1.3 * clubface.evaluate(shots, **how).floor["backspin"]


def test_matched_quantities_must_be_measured_and_are_not_compared(radar):
    with pytest.raises(InputError, match="launch"):
        clubface.identify(radar, **QUICK, compared_at="launch", quantities=["backspin", "launch"])
    with pytest.raises(InputError, match="compared_at"):
        clubface.identify(radar, **QUICK, compared_at="impact")
    bare = replace(radar, launches={name: each for name, each in radar.launches.items() if name != "launch"})
    with pytest.raises(InputError, match="launch angle"):
        measured_shots(bare, compared_at="launch")
