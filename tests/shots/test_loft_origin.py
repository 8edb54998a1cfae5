"""Lofts that a monitor computed from the ball are known by their shots, and measured ones are not taken for such."""

from dataclasses import replace
from math import degrees

import numpy as np
import pytest

from clubface.shots import loft_origin
from clubface.shots.loft_origin import COMPUTED, FROM_MEASUREMENT, UNDECIDED, loft_origins, origin_notes
from clubface.shots.recorded import join_sessions
from clubface.validation import benchmark_data
from monitor_sessions import USUAL, session


def without(shots, *names):
    kept = {name: values for name, values in shots.deliveries.items() if name not in names}
    return replace(shots, deliveries=kept)


@pytest.mark.parametrize("club", USUAL)
@pytest.mark.parametrize("ratio", [1.137, 0.97])
@pytest.mark.parametrize("step", [None, 0.1])
@pytest.mark.parametrize("shots", [8, 60])
def test_a_loft_computed_from_the_ball_is_known_whatever_the_constant_of_the_monitor(club, ratio, step, shots):
    (origin,) = loft_origins(session(club, shots, ratio=ratio, step=step))
    assert (origin.origin, origin.with_face, origin.shots) == (COMPUTED, True, shots)
    # A tenth of a degree in two angles is 0.04 degrees, of the 2 degrees of a drive 2%.
    assert origin.ratio == pytest.approx(ratio, rel=0.03 if step else 1e-9)
    assert degrees(origin.scatter) < 0.08 if step else degrees(origin.scatter) < 1e-6
    assert degrees(origin.rounding) == pytest.approx(0.041 if step else 0.0, abs=1e-3)


@pytest.mark.parametrize("club", USUAL)
@pytest.mark.parametrize("step", [None, 0.1])
def test_it_is_known_without_the_face_angle_too(club, step):
    (origin,) = loft_origins(without(session(club, 30, ratio=1.137, step=step), "face"))
    assert (origin.origin, origin.with_face) == (COMPUTED, False)


@pytest.mark.parametrize("club", USUAL)
@pytest.mark.parametrize("step", [None, 0.1, 1.0])
@pytest.mark.parametrize("model", ["response", "rings"])
@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
def test_measured_lofts_are_not_taken_for_computed_ones(club, step, model):
    origins = [loft_origins(session(club, 40, seed=seed, step=step, model=model))[0].origin for seed in range(8)]
    assert COMPUTED not in origins
    if step != 1.0:  # 40 shots in whole degrees leave some of them undecided
        assert set(origins) == {FROM_MEASUREMENT}


def test_the_measured_lofts_of_the_benchmark_shots_are_measured():
    for club in ("driver", "7-iron"):
        assert loft_origins(benchmark_data.load(club).measured)[0].origin == FROM_MEASUREMENT


def test_whole_degrees_say_nothing_of_few_shots_and_enough_of_many():
    few = [loft_origins(session("7-iron", 8, seed=seed, ratio=1.137, step=1.0))[0].origin for seed in range(8)]
    assert few.count(UNDECIDED) >= 7
    assert loft_origins(session("7-iron", 300, ratio=1.137, step=1.0))[0].origin == COMPUTED


def test_shots_all_alike_have_one_ratio_and_say_nothing():
    first = session("7-iron", 12, noise=0.1).select(np.zeros(12, dtype=int))
    shaken = 0.002 * np.random.default_rng(2).standard_normal(12)
    alike = replace(first, launches=first.launches | {"launch": first.launches["launch"] + shaken})
    (origin,) = loft_origins(alike)
    assert origin.origin == UNDECIDED


def test_some_misread_shots_do_not_hide_a_computed_loft():
    shots = session("driver", 40, ratio=1.137)
    shots.launches["ball_speed"][:8] *= 0.8
    (origin,) = loft_origins(shots)
    assert origin.origin == COMPUTED
    assert origin.ratio == pytest.approx(1.137, rel=1e-9)
    assert origin.ratio_scatter < 1e-6


def test_each_club_of_each_file_is_judged_by_itself():
    mixed = join_sessions([
        replace(session("driver", 20, ratio=1.137), source="radar.csv"),
        replace(session("driver", 20, seed=2), source="camera.csv"),
        replace(session("7-iron", 20, ratio=0.97, seed=3), source="third.csv"),
    ])  # fmt: skip
    result = {(each.file, each.club): each.origin for each in loft_origins(mixed)}
    assert result == {
        ("radar.csv", "driver"): COMPUTED, ("camera.csv", "driver"): FROM_MEASUREMENT,
        ("third.csv", "7-iron"): COMPUTED,
    }  # fmt: skip
    *computed, advice = origin_notes(loft_origins(mixed))
    assert [each.data["in_files"] for each in computed] == [["radar.csv"], ["third.csv"]]
    assert [each.data["ratio"] for each in computed] == pytest.approx([1.137, 0.97], abs=1e-3)
    assert advice.code == "loft-computed-advice"


def test_shots_without_loft_or_launch_or_in_a_handful_have_no_origin():
    shots = session("driver", 20, ratio=1.137)
    assert loft_origins(without(shots, "loft")) == ()
    assert loft_origins(shots.select(slice(0, 4))) == ()
    launches = {name: values for name, values in shots.launches.items() if name != "launch"}
    assert loft_origins(replace(shots, launches=launches)) == ()


@pytest.mark.filterwarnings("error")
def test_monitor_read_says_once_that_lofts_were_computed_and_warns_of_no_ball(tmp_path, clubface_, monkeypatch):
    monkeypatch.setattr("clubface.support.checks._given", {})
    monkeypatch.setattr(loft_origin, "_ball", loft_origin._ball.__wrapped__)
    path = str(tmp_path / "radar.csv")
    session("7-iron", 12, ratio=1.137, step=0.1).write(path)
    result = clubface_("monitor", "read", path, "--json").json
    assert result["tables"]["loft_origins"]["rows"][0]["origin"] == COMPUTED
    codes = [note["code"] for note in result["notes"]]
    assert codes[:2] == ["loft-and-face-computed", "loft-computed-advice"]
    assert len(set(codes)) == len(codes)
    shown = clubface_("monitor", "read", path)
    assert shown.out.count("computed from the ball") == 1
    assert "diameter" not in shown.err
