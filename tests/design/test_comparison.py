"""Shots side by side: the values are those of single shots, and the contributions add up to the differences."""

import math
import pickle
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import clubface
from clubface.design.comparison import read_deliveries
from clubface.design.contributions import FLOWN, LAUNCHED, NODES, QUANTITIES
from clubface.errors import FileError, InputError, RangeWarning, RuleWarning, ShotError, UnknownNameError
from fem_runs import coarse

pytestmark = [
    pytest.mark.filterwarnings("ignore", category=RuleWarning),
    pytest.mark.filterwarnings("ignore", category=RangeWarning),
]

DRIVE = {"speed": "105 mph", "attack": "3 deg", "loft": "13 deg", "toe": "20 mm", "high": "-4 mm", "path": "-2 deg"}
INERTIA = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
SMOOTH = (*LAUNCHED, "carry", "side", "apex", "landing_angle")
"""All but the ends of the roll, which have kinks."""


def scaled(club, factor, names=INERTIA):
    return club.replace(**{name: getattr(club, name) * factor for name in names})


def two(first, second, **options):
    return clubface.compare({"first": first, "second": second}, **options)


def parts(result):
    made = result.contributions["second"]
    assert made.left_out == ""
    return {each.name: dict(zip(QUANTITIES, row, strict=True)) for each, row in zip(made.changes, made.si, strict=True)}


def assert_adds_up(result, tolerance, quantities=SMOOTH):
    """The remainder is below a share of what was added up, and closes the sum to rounding."""
    made = result.contributions["second"]
    for place, quantity in enumerate(QUANTITIES):
        added = float(made.si[:, place].sum())
        size = float(np.abs(made.si[:, place]).sum())
        difference = result.difference("second", quantity)
        assert added + made.remainder[place] == pytest.approx(difference, abs=1e-9 * (size + abs(difference)) + 1e-15)
        if quantity in quantities:
            # A flight to 1e-9 leaves 2e-8 rad in the angle of landing, which gathers it from first to last.
            assert abs(made.remainder[place]) <= tolerance * size + 5e-8, quantity


def test_values_are_those_of_single_shots_bit_for_bit():
    conditions = {"air": {"altitude": "1600 m"}, "wind": ("3 m/s", 0.0, 0.0)}
    result = two(
        {"club": "driver", "delivery": DRIVE}, {"club": "3-wood", "delivery": DRIVE, "ball": "distance"}, **conditions
    )
    for name, club, ball in (("first", "driver", "modern"), ("second", "3-wood", "distance")):
        launch = clubface.impact(club, DRIVE, ball=ball)
        flight = clubface.fly(launch, **conditions)
        for quantity in QUANTITIES:
            assert result.value(name, quantity) == (launch if quantity in LAUNCHED else flight).get(quantity)
    assert result.difference("second", "carry", "yd") == pytest.approx(
        result.value("second", "carry", "yd") - result.value("first", "carry", "yd"), rel=1e-12
    )


change = st.floats(-1.0, 1.0)


@pytest.mark.parametrize("model", ["response", "standard", "slip"])
@settings(max_examples=12)
@given(
    mass=change, cg=st.tuples(change, change, change), inertia=change, loft=change, bulge=change, roll=change,
    time=change, toe=change, speed=change,
)  # fmt: skip
def test_the_contributions_of_a_changed_head_add_up(model, mass, cg, inertia, loft, bulge, roll, time, toe, speed):
    """Gauss's rule with 8 points is exact to the 15th degree: of smooth changes of a tenth nothing is left.

    The launch is smooth; the flight is integrated with steps that are chosen anew at each point, to 1e-9.
    """
    driver = clubface.club("driver")
    changed = scaled(driver, 1.0 + 0.1 * inertia).replace(
        mass=driver.mass * (1.0 + 0.1 * mass), cg_x=driver.cg_x + 4e-3 * cg[0], cg_y=driver.cg_y + 4e-3 * cg[1],
        cg_z=driver.cg_z + 4e-3 * cg[2], loft=driver.loft + 0.03 * loft, bulge=driver.bulge * (1.0 + 0.2 * bulge),
        roll=driver.roll * (1.0 + 0.2 * roll), characteristic_time=driver.characteristic_time * (1.0 + 0.1 * time),
    )  # fmt: skip
    moved = {**DRIVE, "toe": 0.02 + 0.005 * toe, "speed": 47.0 + 3.0 * speed}
    result = two(
        {"club": driver, "delivery": DRIVE, "model": model}, {"club": changed, "delivery": moved, "model": model}
    )
    assert_adds_up(result, 1e-6)


@pytest.mark.parametrize(("model", "tolerance"), [("volumetric", 1e-4), ("area", 1e-3)])
def test_those_of_a_contact_model_add_up_to_its_accuracy(model, tolerance):
    """Steps of tolerance 1e-9: the launch repeats to some 1e-8 of itself, here some 1e-5 of what is added up.

    The friction of `area` turns round within 0.01 m/s, which costs another digit.
    """
    first = {"club": "driver", "delivery": DRIVE, "model": model, "accuracy": 1e-9}
    second = {**first, "club": scaled(clubface.club("driver"), 1.1).replace(mass="210 g")}
    assert_adds_up(two(first, second, nodes=4), tolerance)


@pytest.mark.parametrize(
    ("field", "value", "name"),
    [("mass", "212 g", "club_mass"), ("cg_x", "36 mm", "cg_x"), ("iyy", "5000 g cm2", "iyy"),
     ("ixy", "-600 g cm2", "ixy"), ("bulge", "260 mm", "bulge"), ("bulge", "flat", "bulge"), ("roll", "flat", "roll"),
     ("characteristic_time", "200 us", "characteristic_time")],
)  # fmt: skip
@pytest.mark.parametrize("model", ["response", "standard"])
def test_a_difference_of_one_thing_is_attributed_to_it(field, value, name, model):
    first = {"club": "driver", "delivery": DRIVE, "model": model}
    second = {**first, "club": clubface.club("driver").replace(**{field: value})}
    result = two(first, second)
    assert list(parts(result)) == [name]
    for quantity in SMOOTH:
        difference = result.difference("second", quantity)
        # The time of the face in the parameters of `standard` is moved by steps, good to some 1e-6.
        assert parts(result)[name][quantity] == pytest.approx(difference, rel=1e-5, abs=1e-8)


def test_the_included_face_time_is_a_contribution_of_its_own():
    """Slopes by it come from steps of 1e-8 s, good to some 1e-6."""
    driver = clubface.club("driver")
    usual = clubface.ParameterSet.builtin("standard", "driver")
    first = {"club": driver, "delivery": DRIVE, "model": "standard", "parameters": usual}
    stiffer = {**first, "parameters": replace(usual, characteristic_time=200e-6)}
    result = two(first, stiffer)
    assert set(parts(result)) == {"included_time"}
    assert parts(result)["included_time"]["ball_speed"] > 0.1  # m/s: the club's face gives more than the one included
    assert_adds_up(result, 1e-5)
    # Parameters of which nobody said which face they include take the club's own for it: a face makes no difference.
    unsaid = {**first, "parameters": replace(usual, characteristic_time=None)}
    result = two(unsaid, {**unsaid, "club": driver.replace(characteristic_time="200 us")})
    assert set(parts(result)) == {"characteristic_time"}
    assert result.difference("second", "ball_speed") == pytest.approx(0.0, abs=1e-12)
    assert parts(result)["characteristic_time"]["ball_speed"] == pytest.approx(0.0, abs=1e-6)


def test_delivery_parameter_and_ball_have_contributions_of_their_own():
    first = {"club": "driver", "delivery": DRIVE}
    result = two(first, {**first, "delivery": {**DRIVE, "loft": "15 deg"}, "parameters": {"friction": 0.3}})
    assert set(parts(result)) == {"loft", "friction"}
    assert_adds_up(result, 1e-6)
    assert parts(result)["loft"]["backspin"] > 0.0 > parts(result)["loft"]["ball_speed"]
    heavier = clubface.ball("modern").replace(mass="44 g")
    result = two(first, {**first, "ball": heavier})
    assert set(parts(result)) == {"ball_mass"}
    # A lighter ball leaves faster and is slowed down more: both are in the one contribution to carry.
    assert_adds_up(result, 1e-6)
    assert parts(result)["ball_mass"]["ball_speed"] > 0.0


def test_contributions_are_the_line_integrals_of_slopes_found_another_way():
    """Midpoints of 100 pieces and central differences of whole shots: both wrong by 1e-4 of a contribution at most."""
    driver = clubface.club("driver")
    second = driver.replace(mass="216 g", cg_x="36 mm")
    result = two({"club": driver, "delivery": DRIVE}, {"club": second, "delivery": DRIVE})
    pieces = 100
    at = (np.arange(pieces) + 0.5) / pieces
    ends = {"club_mass": (driver.mass, second.mass), "cg_x": (driver.cg_x, second.cg_x)}
    line = {name: first + at * (last - first) for name, (first, last) in ends.items()}
    for name, (first, last) in ends.items():
        step = 1e-4 * (last - first)
        sides = [
            clubface.fly(clubface.impact(driver, DRIVE, **{**line, name: line[name] + side * step}))
            for side in (1.0, -1.0)
        ]
        for quantity in ("carry", "side"):
            slope = (getattr(sides[0], quantity) - getattr(sides[1], quantity)) / (2.0 * step)
            expected = float(slope.mean() * (last - first))
            assert parts(result)[name][quantity] == pytest.approx(expected, rel=1e-4)


def test_the_way_back_has_the_opposite_contributions():
    one, other = ({"club": name, "delivery": DRIVE} for name in ("driver", "3-wood"))
    there, back = two(one, other), two(other, one)
    for name, row in parts(there).items():
        for quantity in SMOOTH:
            assert parts(back)[name][quantity] == pytest.approx(-row[quantity], rel=1e-7, abs=1e-9)


def test_ball_speed_gained_by_mass_is_that_of_two_bodies():
    """A head that cannot turn, struck square: v = V (1 + e) M / (M + m), friction without work."""
    driver = clubface.club("driver")
    still = scaled(driver, 1e4).replace(ixy=0.0, ixz=0.0, iyz=0.0, bulge="flat", roll="flat", loft=0.0)
    square = {"speed": 45.0, "loft": 0.0}
    first = {"club": still, "delivery": square, "model": "standard"}
    result = two(first, {**first, "club": still.replace(mass="224 g")})
    m = clubface.ball().mass
    ratio = (0.224 / (0.224 + m)) / (0.204 / (0.204 + m))
    expected = result.value("first", "ball_speed") * (ratio - 1.0)
    # The head still turns a ten-thousandth of what it would.
    assert parts(result)["club_mass"]["ball_speed"] == pytest.approx(expected, rel=1e-3)


def test_more_inertia_keeps_ball_speed_as_published():
    """Golf Digest (2011): 2 % of ball speed is lost 19 mm towards the toe, over 14 drivers.

    What is lost goes with 1 / inertia (a lever d takes the speed of a mass 1 / (1 / M + d^2 / I)), so that a tenth more
    of it saves an eleventh of the loss, 0.18 % of ball speed; heads differ by a quarter in inertia and so in loss.
    Golf Tips (about 2007, Driver Tech 101): an inch off the centre costs 7 to 10 mph with an old driver, and 6 mph with
    one of more inertia.
    """
    driver = clubface.club("driver")
    centre = {"speed": "95 mph", "loft": "15 deg"}
    swing = {**centre, "toe": "0.75 in"}
    result = two({"club": driver, "delivery": swing}, {"club": scaled(driver, 1.1), "delivery": swing})
    middle = two({"club": driver, "delivery": centre}, {"club": scaled(driver, 1.1), "delivery": centre})
    kept = [result.value(name, "ball_speed") / middle.value(name, "ball_speed") for name in ("first", "second")]
    assert 1.0 - kept[0] == pytest.approx(0.02, rel=0.25)
    assert kept[1] - kept[0] == pytest.approx(0.02 * (1.0 - 1.0 / 1.1), rel=0.25)
    assert result.difference("second", "carry") > 0.0
    # Three quarters of what is saved or more are the inertia about the vertical axis, as for a hit towards the toe.
    assert parts(result)["iyy"]["ball_speed"] > 0.75 * result.difference("second", "ball_speed")
    inch = {**swing, "toe": "1 in"}
    for factor, lost in ((1.0, (5.0, 6.5)), (0.55, (7.0, 10.0))):
        speeds = [clubface.impact(scaled(driver, factor), each).get("ball_speed", "mph") for each in (centre, inch)]
        assert lost[0] < speeds[0] - speeds[1] < lost[1]


def test_inputs_without_derivatives_are_changed_first_and_as_a_whole():
    driver = clubface.club("driver")
    first = {"club": driver, "delivery": DRIVE}
    result = two(first, {"club": driver.replace(mass="210 g", hand="left"), "delivery": DRIVE, "model": "standard"})
    made = result.contributions["second"]
    assert [(each.name, each.derivative) for each in made.changes] == [
        ("model", False), ("hand", False), ("club_mass", True),
    ]  # fmt: skip
    assert_adds_up(result, 1e-6)
    other = clubface.impact(driver, DRIVE, model="standard")
    step = other.ball_speed - result.value("first", "ball_speed")
    assert made.of("model", "ball_speed") == pytest.approx(step, rel=1e-12)


def test_the_hand_may_come_from_the_club_or_the_delivery():
    first = {"club": "driver", "delivery": {**DRIVE, "hand": 1.0}}
    clubs = two(
        {"club": "driver", "delivery": DRIVE}, {"club": clubface.club("driver").replace(hand=-1), "delivery": DRIVE}
    )
    rows = two(first, {"club": "driver", "delivery": {**DRIVE, "hand": -1.0}})
    for result in (clubs, rows):
        assert list(parts(result)) == ["hand"]
        assert_adds_up(result, 1e-12)
    assert clubs.difference("second", "side") == rows.difference("second", "side")


def test_equal_shots_differ_by_nothing():
    result = two({"club": "driver", "delivery": DRIVE}, {"club": "driver", "delivery": DRIVE})
    assert parts(result) == {}
    assert not result.contributions["second"].remainder.any()


def test_finite_elements_are_compared_and_split_like_other_models():
    """A tenth of the way from one shot to the other is straight to a part of a hundred: the middle alone is enough."""
    ball = coarse("modern")
    first = {"club": "driver", "delivery": DRIVE, "model": "fem", "ball": ball}
    second = {**first, "club": clubface.club("driver").replace(mass="210 g"), "delivery": {**DRIVE, "toe": "19 mm"}}
    seen = []
    result = two(first, second, progress=lambda done, whole: seen.append((done, whole)))
    assert result.contributions["second"].nodes == NODES[True] == 1
    assert seen == [(1, 1)]
    assert set(parts(result)) == {"toe", "club_mass"}
    assert_adds_up(result, 0.02, ("ball_speed", "azimuth", "carry"))
    alone = clubface.impact("driver", DRIVE, model="fem", ball=ball)
    assert result.value("first", "ball_speed") == alone.ball_speed


def test_another_ball_of_finite_elements_is_changed_as_a_whole():
    first = {"club": "driver", "delivery": DRIVE, "model": "fem", "ball": coarse("modern")}
    result = two(first, {**first, "ball": coarse("distance")})
    assert [each[:1] + each[3:] for each in result.contributions["second"].changes] == [("ball", False)]


def test_the_table_has_every_part_and_can_be_pickled():
    result = two({"club": "driver", "delivery": DRIVE}, {"club": "3-wood", "delivery": DRIVE})
    rows = result.rows()
    assert [row["part"] for row in rows[:3]] == ["value", "value", "difference"]
    assert rows[-1]["part"] == "remainder"
    added = sum(row["carry"] for row in rows if row["part"] in ("contribution", "remainder"))
    assert added == pytest.approx(rows[2]["carry"], rel=1e-12)
    frame = result.to_pandas()
    assert frame.attrs["units"]["carry"] == "m"
    assert list(frame.columns[:3]) == ["alternative", "part", "change"]
    assert pickle.loads(pickle.dumps(result)).rows() == rows
    assert "first: ball_speed" in repr(result)


BOTH = {name: {"club": "driver", "delivery": DRIVE} for name in "ab"}


@pytest.mark.parametrize(
    ("alternatives", "options", "error", "words"),
    [
        ({"a": {"club": "driver", "delivery": DRIVE}}, {}, InputError, "2 to 24"),
        ([1, 2], {}, InputError, "a mapping"),
        ({"a": {"club": "driver"}, "b": {}}, {}, InputError, "delivery"),
        ({"a": {"club": "driver", "delivery": DRIVE, "bal": 1}, "b": {}}, {}, UnknownNameError, "ball"),
        ({"a": 1, "b": 2}, {}, InputError, "an Alternative"),
        ({name: {"club": "driver", "delivery": {"speed": [40.0, 50.0]}} for name in "ab"}, {}, InputError, "single"),
        ({name: {"club": "driver", "delivery": {"speed": 50.0, "toe": "9 cm"}} for name in "ab"}, {}, ShotError, "toe"),
        ({1: BOTH["a"], 2: BOTH["b"]}, {}, InputError, "name"),
        ({"": BOTH["a"], "b": BOTH["b"]}, {}, InputError, "name"),
        ({name: {**each, "model": ["response"]} for name, each in BOTH.items()}, {}, InputError, "model"),
        ({name: {**each, "model": "all"} for name, each in BOTH.items()}, {}, InputError, "model"),
        (BOTH, {"nodes": 0}, InputError, "1 to 64"),
        (BOTH, {"nodes": 5, "split": False}, InputError, "nodes"),
    ],
)  # fmt: skip
def test_impossible_comparisons_are_refused(alternatives, options, error, words):
    with pytest.raises(error, match=words):
        clubface.compare(alternatives, **options)


def test_without_a_split_there_are_no_contributions():
    assert clubface.compare(BOTH, split=False).contributions == {}


def test_an_unknown_contribution_is_an_error():
    result = clubface.compare(
        {name: {"club": "driver", "delivery": {**DRIVE, "toe": toe}} for name, toe in (("a", 0.0), ("b", 0.01))}
    ).contributions["b"]
    for change, quantity in (("loft", "carry"), ("toe", "cary")):
        with pytest.raises(UnknownNameError):
            result.of(change, quantity)


def test_rows_of_a_file_are_deliveries(write):
    text = "name,club_speed_mph,loft_deg,toe_mm\nlow,105,10,0\nhigh,105,14,5\n"
    result = read_deliveries(write(text), 24)
    assert list(result) == ["low", "high"]
    assert result["high"] == pytest.approx({"speed": 46.9392, "loft": math.radians(14.0), "toe": 0.005})
    assert list(read_deliveries(write("club_speed_mph\n100\n105\n"), 24)) == ["line 2", "line 3"]
    for text, words in (
        ("name,club_speed_mph\na,100\na,105\n", "'a' is used twice"),
        ("name,club_speed_mph\na,fast\n", "line 2|fast"),
        ("name,club_speed_mph\n", "no row"),
        ("club_speed_mph\n" + "100\n" * 25, "more than 24"),
        ("name,club_speed_mph\na\n", "2"),
    ):
        with pytest.raises(FileError, match=words):
            read_deliveries(write(text), 24)
    assert set(FLOWN) < set(QUANTITIES)


def _lesson(**after):
    swing = {"speed": "95 mph", "loft": "14 deg", "path": "-3 deg", "face": "2 deg"}
    fields = {"before": {"club": "driver", "delivery": swing}, "after": {"club": "driver", "delivery": swing | after}}
    return clubface.compare(fields).to_result()


def test_of_swings_that_differ_most_to_the_side_the_side_is_split_in_words_and_drawn_to_one_scale():
    lesson = _lesson(path="1 deg", face="0 deg")
    codes = [each.code for each in lesson.summary]
    assert "comparison-main-cause-side" in codes
    bars = {each.x.quantity.name: each.x.limits for each in lesson.pictures()[0].panels() if each.x.label == "change"}
    assert next(iter(bars)) == "side"
    assert bars["side"] == bars["carry"] != bars["ball_speed"]  # both are yards


def test_one_change_alone_is_the_difference_and_has_no_bars():
    lesson = _lesson(face="0 deg")
    assert not [each for each in lesson.summary if each.code.startswith("comparison-main-cause")]
    assert len(lesson.pictures()[0].panels()) == 2  # the flights
