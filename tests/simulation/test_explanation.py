"""Why a shot starts and curves as it does: what-ifs, slopes, words for both hands, and a picture to scale."""

import math

import numpy as np
import pytest

import clubface
from clubface.errors import InputError

DEG = math.pi / 180.0
SHOT = {"speed": "105 mph", "attack": "3 deg", "loft": "13 deg", "face": "-2 deg", "path": "-6 deg", "toe": "10 mm",
        "high": "5 mm"}  # fmt: skip
MIRRORED = {**SHOT, "face": "2 deg", "path": "6 deg", "hand": "left"}


@pytest.fixture(scope="module")
def explained():
    return clubface.explain("driver", SHOT)


@pytest.mark.parametrize(
    ("name", "changes"),
    [
        ("struck in the middle", {"toe": 0.0, "high": 0.0}),
        ("face square to the path", {"face": "-6 deg"}),
        ("path to the target", {"path": 0.0}),
        ("face to the target", {"face": 0.0}),
    ],
)
def test_a_what_if_is_that_shot(explained, name, changes):
    launch = clubface.impact("driver", {**SHOT, **changes})
    assert explained.what_ifs[name].launch.azimuth == launch.azimuth
    assert explained.what_ifs[name].flight.curve == clubface.fly(launch).curve


def test_a_what_if_that_changes_nothing_is_left_out():
    straight = clubface.explain("driver", speed="105 mph", loft="13 deg")
    assert straight.what_ifs == {}
    assert [each.code for each in straight.reasons()] == [
        "shot-shape", "explain-shape-limits", "explain-start", "explain-curve-square", "explain-axis", "explain-launch",
        "explain-worth",
    ]  # fmt: skip


def test_a_degree_of_face_and_a_degree_of_path_turn_the_start_by_a_degree_together(explained):
    """A delivery that is turned as a whole launches turned as much; start mostly follows the face (PING: 76 +- 8%)."""
    face, path = (explained.slopes["azimuth", name] for name in ("face", "path"))
    assert face + path == pytest.approx(1.0, abs=1e-9)
    step = 0.01 * DEG
    ends = [clubface.impact("driver", {**SHOT, "face": -2.0 * DEG + each}).azimuth for each in (-step, step)]
    # A central difference over 0.01 degrees has an error of its square.
    assert face == pytest.approx((ends[1] - ends[0]) / (2.0 * step), abs=1e-5)
    assert 0.68 < face < 0.92
    loft, attack = (explained.slopes["launch", name] for name in ("loft", "attack"))
    # Only where neither face nor path point aside do loft and attack add up to a whole degree.
    assert loft + attack == pytest.approx(1.0, abs=0.01)


def note_of(explained, code):
    return next(each for each in explained.reasons() if each.code == code)


def test_what_a_degree_is_worth_is_the_derivative_of_the_landing(explained):
    """In still air a swing turned as a whole lands turned as much: face and path together move it by its distance."""
    worth = note_of(explained, "explain-worth").data
    flight = explained.flight
    along = math.sqrt(flight.carry**2 - flight.side**2)
    # The flight is integrated in steps that follow its direction: it turns with the launch to 1e-6.
    assert worth["face_side"] + worth["path_side"] == pytest.approx(along * DEG, rel=1e-5)
    for name, what, value, size in (("toe", "side", 10e-3, 10e-3), ("loft", "carry", 13.0 * DEG, DEG)):
        step = 0.01 * size
        ends = [
            getattr(clubface.fly(clubface.impact("driver", {**SHOT, name: value + each})), what)
            for each in (-step, step)
        ]
        # A central difference over 2% of the change: its error is the square of that times the curvature.
        assert worth[f"{name}_{what}"] == pytest.approx((ends[1] - ends[0]) / (2.0 * step) * size, rel=1e-3)


def test_a_ball_that_stays_on_the_ground_is_drawn_without_shape_curve_and_worth_of_a_degree():
    topped = clubface.explain("driver", speed="100 mph", attack="-8 deg", loft="2 deg", high="-20 mm", model="standard")
    assert topped.launch.launch < 0.0
    codes = [each.code for each in topped.reasons()]
    assert codes[0] == "shot-too-low"
    assert not [each for each in codes if each == "explain-worth" or each.startswith("explain-curve")]
    assert len(topped.to_result().pictures()) == 1


def test_the_sweet_spot_of_a_flat_face_that_is_struck_squarely_is_ahead_of_the_mass_centre():
    """An impact along the normal through the mass centre turns no head; with roll a lower strike has less loft."""
    driver = clubface.club("driver")
    flat = driver.replace(roll=1e4, bulge=1e4)
    square = {"speed": "105 mph", "attack": "3 deg", "loft": "3 deg", "high": "5 mm"}
    best = clubface.explain(flat, square).sweet_spot.changes
    assert best["high"] == pytest.approx(driver.cg_height, abs=0.5e-3)  # the lines are searched in such steps
    assert best["toe"] == pytest.approx(-driver.cg_z, abs=0.5e-3)  # from the CG to the centre
    lofted = {**square, "loft": "14 deg"}
    rolled, unrolled = (clubface.explain(each, lofted).sweet_spot.changes["high"] for each in (driver, flat))
    assert rolled < unrolled - 2e-3 < driver.cg_height - 2e-3


def test_the_sweet_spot_gives_more_ball_speed_than_any_strike_on_a_grid():
    iron = {"speed": "80 mph", "attack": "-4 deg", "loft": "24 deg", "high": "-10 mm"}
    explained = clubface.explain("7-iron", iron)
    toe, high = np.meshgrid(np.linspace(-0.02, 0.02, 21), np.linspace(-0.015, 0.015, 31))
    speeds = clubface.impact("7-iron", {**iron, "toe": toe, "high": high}, on_error="nan").ball_speed
    # Half a millimetre beside the top of a hill that falls by 1% in 4 mm is 0.02% lower.
    assert explained.sweet_spot.launch.ball_speed > np.nanmax(speeds) * (1.0 - 2e-4)
    assert note_of(explained, "explain-sweet-spot").data["high"] == explained.sweet_spot.changes["high"] < -3e-3


@pytest.mark.parametrize("hand", ["right", "left"])
def test_the_face_that_a_tilted_club_would_have_is_that_of_its_turned_normal(hand):
    lie, loft = 3.0 * DEG, 30.0 * DEG
    explained = clubface.explain("7-iron", speed="80 mph", loft=loft, lie=lie, hand=hand)
    normal = np.array([math.cos(loft), math.sin(loft), 0.0])  # forward, up, right
    sign = 1.0 if hand == "right" else -1.0  # toe up: for a right-handed club the right goes up and the top goes left
    turn = np.array([[1.0, 0.0, 0.0], [0.0, math.cos(lie), sign * math.sin(lie)],
                     [0.0, -sign * math.sin(lie), math.cos(lie)]])  # fmt: skip
    forward, _, right = turn @ normal
    assert note_of(explained, "lie-held").data["turned_face"] == pytest.approx(math.atan2(right, forward), abs=1e-12)
    level = clubface.explain("7-iron", speed="80 mph", loft=loft, hand=hand)
    assert "lie-held" not in [each.code for each in level.reasons()]


@pytest.mark.parametrize("hand", ["right", "left"])
def test_the_face_at_the_strike_is_drawn_turned_by_the_bulge(hand):
    toe, loft = 20e-3, 13.0 * DEG
    explained = clubface.explain("driver", speed="105 mph", loft=loft, toe=toe, hand=hand)
    # A normal of the arc of the bulge leans by asin(toe / bulge) in the plane of the loft.
    lean = math.asin(toe / 0.305)
    turn = math.atan2(math.sin(lean), math.cos(lean) * math.cos(loft)) * (1.0 if hand == "right" else -1.0)
    assert note_of(explained, "explain-start-bulge").data["turned_face"] == pytest.approx(turn, abs=1e-12)
    (picture,) = explained.to_result().pictures()
    arrow = next(each for each in picture.panels()[1].marks if each.kind == "line" and each.style == 2)
    assert math.atan2(arrow.x[1] - arrow.x[0], arrow.y[1] - arrow.y[0]) == pytest.approx(turn, abs=1e-12)
    assert picture.panels()[3].x.reversed == (hand == "left")  # the toe is where it is in the view from above


def test_the_shot_itself_is_drawn_beside_strikes_elsewhere():
    low = clubface.explain("driver", speed="105 mph", loft="13 deg", high="-14 mm")
    (picture,) = low.to_result().pictures()
    side = picture.panels()[4]
    struck = next(each for each in side.marks if each.label == "as struck")
    assert max(struck.y) == pytest.approx(low.flight.apex, abs=0.1)  # the path is drawn in pieces of its flight
    middle = clubface.explain("driver", speed="105 mph", loft="13 deg")
    assert "as struck" not in [each.label for each in middle.to_result().pictures()[0].panels()[4].marks]


def test_a_strike_on_the_toe_is_geared_towards_the_heel():
    square = clubface.explain("driver", speed="105 mph", loft="13 deg", toe="15 mm")
    middle = square.what_ifs["struck in the middle"]
    assert square.launch.azimuth > middle.launch.azimuth + 2.0 * DEG  # the bulge
    assert square.flight.curve < middle.flight.curve - 5.0
    (reason,) = (each for each in square.reasons() if each.code == "explain-curve-strike")
    assert reason.data == {"curve": square.flight.curve, "middle_curve": middle.flight.curve}


def test_words_of_the_mirrored_shot_have_the_other_sides_and_the_same_openness(explained):
    swapped = {"right": "left", "left": "right"}
    mirrored = clubface.explain("driver", **MIRRORED)
    words = [each.sentence for each in explained.reasons()]
    assert any("4.0 deg open" in each for each in words)
    turned = [" ".join(swapped.get(word.strip(".,;:"), word.strip(".,;:")) for word in each.split()) for each in words]
    plain = [" ".join(word.strip(".,;:") for word in each.sentence.split()) for each in mirrored.reasons()]
    assert turned == plain


def test_strikes_high_and_low_launch_and_spin_as_the_gear_effect_has_it(explained):
    low, middle, high = (explained.strikes[name].launch for name in ("low", "middle", "high"))
    assert low.launch < middle.launch < high.launch
    assert low.backspin > middle.backspin > high.backspin
    heel, toe = (explained.strikes[name].launch for name in ("heel", "toe"))
    assert heel.azimuth < middle.azimuth < toe.azimuth


def drawn(panel):
    return {each.label.split(" ")[0].rstrip(","): each for each in panel.marks if each.label}


@pytest.mark.parametrize("shot", [SHOT, MIRRORED, {"speed": "80 mph", "loft": "10 deg", "attack": "-3 deg"}])
def test_the_picture_has_all_directions_to_scale(shot):
    explained = clubface.explain("driver", **shot)
    (picture,) = explained.to_result().pictures()
    panels = picture.panels()
    assert all(each.equal for each in panels)
    lines = drawn(panels[0])
    wanted = {"path": explained.launch.input("path"), "face": explained.launch.input("face"),
              "start": float(explained.launch.azimuth)}  # fmt: skip
    for name, angle in wanted.items():
        (_, along), (_, across) = lines[name].x, lines[name].y
        assert math.atan2(across, along) == pytest.approx(angle, abs=1e-12)
    # The curve is drawn across the start line, from it to the landing.
    (x0, x1), (y0, y1) = lines["curve"].x, lines["curve"].y
    assert math.hypot(x1 - x0, y1 - y0) == pytest.approx(abs(explained.flight.curve), abs=2e-3)
    way = np.array([math.cos(wanted["start"]), math.sin(wanted["start"])])
    assert float(way @ [x1 - x0, y1 - y0]) == pytest.approx(0.0, abs=1e-9)
    # The lift stands across the axis and leans to where the ball curves.
    axis = next(each for each in panels[2].marks if each.kind == "line" and each.size == 2.0)
    assert (axis.y[1] < axis.y[0]) == (explained.launch.spin_axis > 0.0)


@pytest.mark.parametrize(("changes", "words"), [({"model": "fem"}, "derivatives"), ({"toe": [0.0, 0.01]}, "single")])
def test_inexplicable_shots_are_refused(changes, words):
    with pytest.raises(InputError, match=words):
        clubface.explain("driver", speed="105 mph", **changes)


def test_the_command_and_the_report_of_a_shot_have_words_and_picture(clubface_, tmp_path):
    shot = ("driver", "--speed", "105 mph", "--loft", "13 deg", "--face", "1 deg", "--path", "-3 deg")
    ran = clubface_("explain", *shot, "--plot", str(tmp_path / "explain.svg"), "--json")
    assert (tmp_path / "explain.svg").read_bytes().startswith(b"<?xml")
    assert ran.rows("what_if")[0]["what if"] == "as struck"
    report = tmp_path / "report.md"
    clubface_("shot", *shot, "--report", str(report))
    page = report.read_text()
    assert "Why the ball starts and curves as it does" in page
    for each in ran.json["summary"]:
        assert each["text"] in page


@pytest.mark.parametrize(("hand", "named"), [("right", False), ("left", True)])
def test_the_first_line_says_that_a_club_is_left_handed(clubface_, hand, named):
    for command in ("shot", "explain"):
        shown = clubface_(command, "driver", "--speed", "90 mph", "--loft", "14 deg", "--hand", hand).out
        assert ("left-handed" in shown.splitlines()[0]) == named
