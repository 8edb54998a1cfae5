"""Spin as one vector: whichever of backspin, sidespin, total spin and spin axis are known, the others follow."""

import math
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from clubface.errors import InputError
from clubface.simulation.spin import SPINS, complete, parts, wrapped

RPM, DEG = math.pi / 30, math.pi / 180
SUFFICIENT = [
    each
    for count in (2, 3, 4)
    for each in combinations(SPINS, count)
    if each not in (("backspin", "total_spin"), ("sidespin", "total_spin"))
]
INSUFFICIENT = [(), *((each,) for each in SPINS), ("backspin", "total_spin")]
UNITS = {"backspin": RPM, "sidespin": RPM, "total_spin": RPM, "spin_axis": DEG}
balls = st.tuples(st.floats(-9000.0, 12_000.0), st.floats(-4000.0, 4000.0)).filter(
    lambda parts: abs(parts[0]) > 100.0 and abs(parts[1]) > 100.0
)


def vector(back, side):
    return {
        "backspin": back * RPM, "sidespin": side * RPM, "total_spin": math.hypot(back, side) * RPM,
        "spin_axis": math.atan2(side, back),
    }  # fmt: skip


def completed(**values):
    """The spins that follow from some, in rpm and degrees, and the contradictions."""
    result = complete({name: np.array([value * UNITS[name]]) for name, value in values.items()})
    return {name: float(each[0] / UNITS[name]) for name, each in result.values.items()}, result.contradictions


@pytest.mark.parametrize("names", SUFFICIENT, ids="-".join)
@settings(max_examples=25)
@given(ball=balls)
def test_every_sufficient_part_of_a_spin_gives_the_whole(names, ball):
    whole = vector(*ball)
    result = complete({name: np.array([whole[name]]) for name in names})
    assert not result.contradictions
    assert not result.notes
    for name in SPINS:
        # The tangent of an axis near 90 degrees costs digits: 100 rpm beside 12,000 are two of them.
        assert result.values[name][0] == pytest.approx(whole[name], rel=1e-10), name


@pytest.mark.parametrize("names", INSUFFICIENT, ids="-".join)
@settings(max_examples=25)
@given(ball=balls)
def test_spins_that_do_not_follow_stay_unknown(names, ball):
    whole = vector(*ball)
    result = complete({name: np.array([whole[name]]) for name in names})
    assert set(result.values) == set(names)
    assert all(result.values[name][0] == whole[name] for name in names)
    assert bool(result.notes) == ("total_spin" in names)


@settings(max_examples=25)
@given(ball=balls)
def test_spins_as_monitors_round_them_do_not_contradict_each_other(ball):
    whole = vector(*ball)
    for step, degrees in ((1.0, 0.1), (10.0, 1.0)):
        steps = {"backspin": step * RPM, "sidespin": step * RPM, "total_spin": step * RPM, "spin_axis": degrees * DEG}
        result = complete({name: np.array([round(whole[name] / steps[name]) * steps[name]]) for name in SPINS})
        assert not result.contradictions


@settings(max_examples=25)
@given(ball=balls, name=st.sampled_from(["backspin", "sidespin", "total_spin"]), off=st.sampled_from([1.4, 0.6, -1.0]))
def test_one_spin_that_the_three_others_contradict_is_noted_and_left_out(ball, name, off):
    whole = {each: value / UNITS[each] for each, value in vector(*ball).items()}
    result, (contradiction,) = completed(**whole | {name: off * whole[name]})
    assert name not in contradiction.kept
    assert contradiction.given[name] == pytest.approx(off * whole[name] * RPM, rel=1e-14)
    for each, value in whole.items():
        assert result[each] == pytest.approx(value, rel=1e-9, abs=1e-6), each


def test_axes_count_through_a_whole_turn_and_a_topped_ball_has_one_beyond_90_degrees():
    assert wrapped(np.array([352.5, -352.5, 180.0, -180.0, 360.0, 7.5]) * DEG) / DEG == pytest.approx(
        [-7.5, 7.5, 180.0, 180.0, 0.0, 7.5], abs=1e-12
    )
    assert wrapped(np.array([999.0 * DEG])) == 999.0 * DEG  # no direction but a sign for "not measured"
    right, left = (completed(total_spin=8100, spin_axis=axis)[0] for axis in (7.5, 352.5))
    assert left["sidespin"] == pytest.approx(-right["sidespin"], rel=1e-12)
    topped, _ = completed(backspin=-500, sidespin=100)
    assert topped["spin_axis"] == pytest.approx(180 - math.degrees(math.atan(0.2)), rel=1e-12)
    assert completed(backspin=-500, spin_axis=topped["spin_axis"])[0]["sidespin"] == pytest.approx(100, rel=1e-9)


@pytest.mark.parametrize(
    ("spins", "kept"),
    [
        ({"backspin": 2650, "total_spin": 2600}, ()),
        ({"sidespin": -700, "total_spin": 600}, ()),
        ({"backspin": -500, "spin_axis": 10}, ()),
        ({"sidespin": 300, "spin_axis": -10}, ()),
        ({"total_spin": -2500, "spin_axis": 10}, ("spin_axis",)),
        ({"backspin": 2650, "sidespin": 1703, "total_spin": 2650}, ("backspin", "sidespin")),
        ({"backspin": 2650, "sidespin": 300, "spin_axis": -6.5}, ("backspin", "sidespin")),
        ({"backspin": 3000, "total_spin": 2650, "spin_axis": 40}, ("total_spin", "spin_axis")),
        ({"backspin": 2500, "sidespin": 300, "total_spin": 2518, "spin_axis": -6.8}, ("backspin", "total_spin",
                                                                                        "spin_axis")),
        # Programs write 0 for an axis that was not measured.
        ({"backspin": 2500, "sidespin": -300, "total_spin": 2518, "spin_axis": 0}, ("backspin", "sidespin",
                                                                                     "total_spin")),
        # A total spin below what its parts make is never right; one of 2% above may hold what turns about the launch.
        ({"backspin": 2650, "sidespin": 1703, "total_spin": 3135}, ("backspin", "sidespin")),
        ({"backspin": 2650, "sidespin": 1703, "total_spin": 3250}, ("backspin", "sidespin")),
        ({"backspin": 1, "sidespin": 2, "total_spin": 3250, "spin_axis": -13}, ("total_spin", "spin_axis")),
    ],
)  # fmt: skip
def test_of_spins_that_contradict_each_other_the_rule_says_what_is_kept(spins, kept):
    result, (contradiction,) = completed(**spins)
    assert set(contradiction.kept) == set(kept)
    assert all(result[name] == pytest.approx(spins[name], rel=1e-12, abs=1e-12) for name in kept)
    assert [name for name in spins if math.isnan(result[name])] == (
        [] if len(kept) > 1 else list(spins)[: 2 - len(kept)]
    )


def test_a_sidespin_of_a_few_turns_or_an_axis_of_nearly_a_right_angle_says_nothing_of_the_backspin():
    assert set(completed(sidespin=30, spin_axis=1)[0]) == {"sidespin", "spin_axis"}
    assert set(completed(backspin=20, spin_axis=90)[0]) == {"backspin", "spin_axis"}
    assert completed(sidespin=30.0, spin_axis=1.2)[0]["backspin"] == pytest.approx(30 / math.tan(1.2 * DEG), rel=1e-12)


def test_total_spin_and_sidespin_leave_a_topped_ball_out_and_say_so():
    result = complete({"total_spin": np.array([300.0]), "sidespin": np.array([-40.0])})
    assert result.values["backspin"] == pytest.approx([math.sqrt(300**2 - 40**2)], rel=1e-12)
    assert result.notes == (("spin-not-topped", {}),)


def test_a_total_spin_that_holds_the_spin_about_the_direction_of_launch_contradicts_nothing():
    result = complete({"backspin": np.array([290.0]), "sidespin": np.array([-40.0]), "total_spin": np.array([295.0])})
    assert (result.contradictions, result.values["total_spin"][0]) == ((), 295.0)


@pytest.mark.parametrize(
    ("given", "back", "side", "assumed"),
    [
        ({"backspin": 300.0}, 300.0, 0.0, "sidespin"),
        ({"total_spin": 300.0}, 300.0, 0.0, "axis"),
        ({"total_spin": 301.0, "backspin": 300.0}, 300.0, 0.0, "sidespin"),
        ({"sidespin": 40.0}, 0.0, 40.0, "backspin"),
        ({}, 0.0, 0.0, "spin"),
        ({"total_spin": 50.0, "sidespin": 30.0}, 40.0, 30.0, "topped"),
        ({"total_spin": 50.0, "spin_axis": math.atan(0.75)}, 40.0, 30.0, None),
    ],
)
def test_a_computation_that_needs_the_whole_vector_says_what_it_assumes(given, back, side, assumed):
    result = parts(given)
    assert result[:2] == pytest.approx((back, side), rel=1e-12)
    assert (assumed in result[2]) if assumed else not result[2]


@pytest.mark.parametrize(
    "given",
    [
        {"spin_axis": 0.1},
        {"backspin": 2.0, "spin_axis": math.pi / 2},
        {"backspin": 300.0, "total_spin": 200.0},
        {"backspin": np.array([1.0, 300.0]), "sidespin": 0.0, "total_spin": np.array([1.0, 200.0])},
    ],
)
def test_a_computation_does_not_go_on_with_spins_that_make_no_vector(given):
    with pytest.raises(InputError, match="spin"):
        parts(given)
