"""Conditions choose shots, and nothing else: they are no programs."""

from __future__ import annotations

import numpy as np
import pytest

from clubface.errors import InputError, UnknownNameError
from clubface.shots.conditions import match_shots
from clubface.shots.recorded import RecordedShots
from clubface.units import to_si

NAN = float("nan")
MPH, DEG = to_si(1.0, "mph"), to_si(1.0, "deg")


@pytest.fixture
def shots():
    return RecordedShots(
        deliveries={
            "speed": np.array([100.0, 85.0, 84.0, 70.0]) * MPH,
            "face": np.array([1.0, NAN, -3.0, 2.0]) * DEG,
            "path": np.array([2.0, 0.0, 1.0, 2.0]) * DEG,
        },
        launches={"ball_speed": np.array([148.0, 119.0, NAN, 84.0]) * MPH, "carry": np.array([220.0, 150, 140, 90])},
        clubs=np.array(["Driver", "7 Iron", "7i", ""], dtype=object),
        hand=np.array(["right", "right", "left", "left"], dtype=object),
        rows=np.array([2, 3, 4, 5]),
        source="session.csv",
        format="clubface",
    )


@pytest.mark.parametrize(
    ("condition", "mask", "undecided"),
    [
        ("ball_speed > 118 mph", [1, 1, 0, 0], 1),
        ("ball_speed>118mph", [1, 1, 0, 0], 1),
        ("ball_speed_mph > 118", [1, 1, 0, 0], 1),
        ("ball_speed > 200 km/h", [1, 0, 0, 0], 1),
        ("not ball_speed > 118 mph", [0, 0, 0, 1], 1),
        ("ball_speed != 148 mph", [0, 1, 0, 1], 1),
        ("smash > 1.3 and club == '7i'", [0, 1, 0, 0], 1),
        ("smash > 1.3 or club == '7i'", [1, 1, 1, 0], 1),
        ("club == '7-iron'", [0, 1, 1, 0], 1),
        ("'driver' == club", [1, 0, 0, 0], 1),
        ("club != '7i'", [1, 0, 0, 0], 1),
        ("club in ('7i', 'Dr')", [1, 1, 1, 0], 1),
        ("club not in ['7i']", [1, 0, 0, 0], 1),
        ("hand == 'LEFT'", [0, 0, 1, 1], 0),
        ("80 mph < speed <= 85 mph", [0, 1, 1, 0], 0),
        ("abs(face - path) < 2 deg", [1, 0, 0, 1], 1),
        ("face < 0 or face > 1.5°", [0, 0, 1, 1], 1),
        ("-face > 2 deg", [0, 0, 1, 0], 1),
        ("ball_speed / speed > 1.45", [1, 0, 0, 0], 1),
        ("2 * speed > 180 mph", [1, 0, 0, 0], 0),
        ("smash > 140 %", [1, 1, 0, 0], 1),
        ("carry > 160 yd", [1, 1, 0, 0], 0),
        ("carry > 7000 in and row in (2, 3)", [1, 0, 0, 0], 0),
        ("club == 'Driver' and ball_speed > 999 mph", [0, 0, 0, 0], 0),
    ],
)
def test_a_condition_selects_shots_for_which_it_certainly_holds(shots, condition, mask, undecided):
    result = match_shots(shots, condition)
    assert result.mask.tolist() == [bool(each) for each in mask]
    assert result.undecided == undecided


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        ("ball_speed > 150", r"150 needs a unit: ball_speed is in m/s or mph"),
        ("ball_speed > 150 deg", "of different kinds: speed, angle"),
        ("ball_speed_mph > 150 mph", "ball_speed_mph is a pure number"),
        ("ball_speed", "true or false"),
        ("ball_speed and smash > 1", "neither true nor false"),
        ("club > '7i'", "by == or !="),
        ("club == hand", "quotation marks"),
        ("club == 7", "cannot be compared"),
        ("speed * ball_speed > 3", "cannot be combined"),
        ("club in '7i'", "in needs a list"),
        ("smash is 1", "compare with"),
        ("__import__('os').system('true')", "are known"),
        ("speed.real > 3", "are known"),
        ("[each for each in (1, 2)] == 3", "are known"),
        ("max(speed) > 3 mph", "are known"),
        ("2 ** 9999999 > 1", "cannot be combined"),
        ("smash == True", "not a value of a shot"),
        ("smash >", "a condition on the shots, as in"),
        ("", "a condition on the shots, as in"),
        ("-" * 900 + "smash > 1", "a condition"),
        ("(" * 900, "a condition"),
        ("smash > 1" + " " * 1000, "at most 1000 characters"),
        ("smash > '\0'", "a condition"),
    ],
)
def test_an_invalid_condition_is_refused_and_never_run(shots, condition, message):
    with pytest.raises(InputError, match=message) as caught:
        match_shots(shots, condition)
    assert len(str(caught.value)) < 1500


def test_an_unknown_name_is_reported_with_the_measured_ones(shots):
    with pytest.raises(UnknownNameError, match=r"'smahs'.*did you mean smash"):
        match_shots(shots, "smahs > 1.3")
    with pytest.raises(UnknownNameError, match="ball_speed, carry"):
        match_shots(shots, "backspin > 2000 rpm")
    with pytest.raises(InputError, match="must be in m/s"):
        match_shots(shots, "ball_speed_deg > 2")


def test_shots_without_clubs_say_so(shots):
    from dataclasses import replace

    with pytest.raises(InputError, match="have no club"):
        match_shots(replace(shots, clubs=None), "club == '7i'")
