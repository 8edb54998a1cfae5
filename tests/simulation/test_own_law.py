"""A law of contact written in Python: the motion it makes, and its place among the other models."""

import ctypes
import inspect
import math
import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface.equipment.models import OWN
from clubface.errors import ClubfaceError, InputError, RunError, ShotError
from clubface.simulation.results import inputs
from clubface.simulation.two_bodies import BALL, BALL_SPIN, BALL_VELOCITY, CLUB, CLUB_MOMENTUM, CLUB_VELOCITY, TwoBodies

pytest.importorskip("scipy")

SHOT = {
    "speed": "108 mph", "attack": "2 deg", "path": "-2 deg", "loft": "13 deg", "face": "1 deg", "lie": "3 deg",
    "toe": "12 mm", "high": "-6 mm", "closure": "1500 deg/s", "pitch_rate": 3.0, "lie_rate": 5.0,
    "ball_backspin": 10.0, "ball_sidespin": 20.0, "ball_riflespin": 5.0,
}  # fmt: skip
"""Everything at once, so that no sign hides behind a zero."""

AREA = {"shear_modulus": "54 MPa", "poisson": 0.398, "damping": "6.35e-3 s/m", "friction": 0.0486}
"""Caldwell and McPhee's driver, which the built-in model area has too."""


def hertz(touch, values):
    """The law of the model area, without its area term."""
    stiffness = 4.0 / 3.0 * values["shear_modulus"] / (1.0 - values["poisson"])
    stiffness /= math.sqrt(1.0 / touch.radius + touch.curvature)
    normal = max(stiffness * touch.depth**1.5 * (1.0 + values["damping"] * touch.rate), 0.0)
    sliding = math.hypot(touch.sliding_y, touch.sliding_z)
    drag = values["friction"] * normal * math.tanh(sliding / 0.01) / sliding if sliding else 0.0
    return normal, -drag * touch.sliding_y, -drag * touch.sliding_z


@pytest.fixture(autouse=True)
def _forget():
    yield
    OWN.clear()


def registered(law=hertz, **parameters):
    return clubface.register_law("mine", law, parameters=parameters or AREA)


def built_in():
    """The set of area that says nothing of its face, as a law of one's own does."""
    return replace(clubface.ParameterSet.builtin("area", "driver"), characteristic_time=None)


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("club", ["driver", "7-iron"])
def test_a_law_in_python_launches_the_ball_as_the_same_law_in_the_core(club, hand):
    registered()
    given = SHOT | {"loft": "28 deg", "accuracy": 1e-11, "hand": hand}
    mine = clubface.impact(club, **given, model="mine")
    core = clubface.impact(club, **given, model="area", parameters=built_in())
    for name in core.quantities():
        # Two methods at 1e-11 a step; the top of the force is sought between steps by a parabola in the core.
        most = 1e-6 if name == "peak_force" else 5e-8
        assert getattr(mine, name) == pytest.approx(getattr(core, name), rel=most, abs=1e-9), name


def test_the_usual_tolerance_gives_the_launch_to_1e_5():
    registered()
    usual, fine = (clubface.impact("driver", **SHOT, model="mine", accuracy=each) for each in (None, 1e-11))
    # The top of the force is sought between steps by a parabola.
    peak = usual._values[-1] / fine._values[-1]
    assert peak == pytest.approx(1.0, rel=3e-5)
    assert usual._values[:-1] == pytest.approx(fine._values[:-1], rel=1e-5)


def test_by_default_a_law_and_the_same_law_in_the_core_agree_to_2e_5_as_the_page_says():
    registered()
    shot = {"speed": "108 mph", "loft": "13 deg"}
    mine = clubface.impact("driver", **shot, model="mine")
    core = clubface.impact("driver", **shot, model="area", parameters=built_in())
    apart = max(abs(getattr(mine, name) / getattr(core, name) - 1.0) for name in ("ball_speed", "launch", "backspin"))
    assert 1e-6 < apart < 2e-5  # neither is exact: seven figures take an accuracy


def test_energy_and_momentum_are_kept():
    registered()
    course = clubface.history("driver", **SHOT, model="mine", accuracy=1e-10)
    energy = course.kinetic_energy + course.normal_work + course.friction_work
    assert energy == pytest.approx(energy[0], rel=1e-9)
    assert course.normal_work[-1] > 0.0
    assert np.all(np.diff(course.friction_work) >= -1e-12)
    launch, club = course.launch, course.launch.club
    mass, of_ball = club.mass, launch.ball
    momentum = mass * course.club_velocity + of_ball.mass * course.ball_velocity
    assert momentum == pytest.approx(np.tile(momentum[0], (len(course), 1)), rel=1e-9, abs=1e-9)


def test_angular_momentum_of_both_bodies_is_kept():
    registered()
    launch = clubface.impact("driver", **SHOT, model="mine")
    given = {name: float(launch.input(name)) for name in inputs()}
    bodies = TwoBodies(given, hertz, launch.parameters.values)
    states = bodies.run(1e-10).y.T
    total = states[:, CLUB_MOMENTUM] + bodies.ball_inertia * states[:, BALL_SPIN]
    total += bodies.ball_mass * np.cross(states[:, BALL], states[:, BALL_VELOCITY])
    total += bodies.club_mass * np.cross(states[:, CLUB], states[:, CLUB_VELOCITY])
    assert np.abs(total - total[0]).max() < 1e-9 * np.linalg.norm(total[0])


def test_friction_and_normal_force_of_a_history_make_the_momentum_of_the_ball():
    registered()
    course = clubface.history("driver", **SHOT, model="mine", accuracy=1e-10)
    force = np.sqrt(course.normal_force**2 + course.force_y**2 + course.force_z**2)
    gained = np.trapezoid(force, course.time)
    # The force turns with the head, by some degrees: the sum of its sizes is a little more than the size of its sum.
    momentum = course.launch.ball.mass * course.launch.ball_speed
    assert momentum < gained < 1.001 * momentum
    assert course.normal_force.max() == pytest.approx(course.launch.peak_force, rel=1e-3)


def test_batches_comparisons_parameters_and_flights_take_the_law():
    registered()
    toe = np.array([[-0.01, 0.0, 0.01]])
    friction = np.array([[0.02], [0.04]])
    both = clubface.impact(
        "driver", speed="110 mph", toe=toe, model=["mine", "area"], parameters={"mine": {"friction": friction}}
    )
    assert list(both) == ["mine", "area"]
    launch = both["mine"]
    assert launch.shape == (2, 3)
    alone = clubface.impact("driver", speed="110 mph", toe=0.01, model="mine", parameters={"friction": 0.04})
    assert launch.backspin[1, 2] == alone.backspin
    assert launch.provenance["parameters"]["values"]["poisson"] == 0.398
    assert clubface.fly(launch).carry.shape == (2, 3)
    assert clubface.fly(alone).carry > 150.0


def test_a_name_registered_again_has_the_new_law_and_parameters():
    registered()
    before = clubface.impact("driver", speed=45.0, model="mine").backspin
    clubface.register_law("mine", hertz, parameters=AREA | {"friction": 0.0})
    assert before > 50.0
    assert clubface.impact("driver", speed=45.0, model="mine").backspin == pytest.approx(0.0, abs=1e-9)


def test_a_ball_is_never_pulled():
    registered(lambda touch, values: (values["force"] * (touch.depth / 1e-3) * (1.0 + 0.2 * touch.rate), 0.0, 0.0),
               force="3 kN")  # fmt: skip
    assert clubface.history("driver", speed=40.0, model="mine").normal_force.min() == 0.0


def test_a_custom_law_refuses_what_other_models_refuse():
    registered()
    with pytest.raises(ShotError, match="outside the face outline"):
        clubface.impact("driver", speed=45.0, toe="90 mm", model="mine")
    with pytest.raises(InputError, match="outside the face outline"):
        clubface.history("driver", speed=45.0, toe="90 mm", model="mine")
    result = clubface.impact("driver", speed=np.array([45.0, -1.0, 45.0]), model="mine", on_error="nan")
    assert np.isnan(result.ball_speed).tolist() == [False, True, False]
    assert result.problems[0].parameter == "speed"
    with pytest.raises(ShotError, match="characteristic_time"):
        clubface.impact("driver", speed=45.0, characteristic_time="100 us", model="mine")


@pytest.mark.parametrize(
    ("law", "message"),
    [
        *(
            (lambda touch, values, states, returned=returned: returned, message)
            for returned, message in (
                ((1.0, 0.0, 0.0), "returned 3 things"),
                ((1.0, 0.0, 0.0, {"stretch": 1.0}), "returned rates of stretch; a law with states"),
                ((1.0, 0.0, 0.0, [1.0]), "returned 1 rates"),
                ((1.0, 0.0, 0.0, [1.0, math.inf]), "inf as the rate of stretch_z"),
            )
        ),
        (lambda touch, values: 1.0, "returned one number, 1.0; a law must return three"),
        (lambda touch, values: (1.0, 0.0), "returned 2 numbers"),
        (lambda touch, values: None, "returned no numbers, None"),
        (lambda touch, values: (1.0, math.nan, 0.0), r"nan as the friction up the face at Touch\(depth=\d"),
        (lambda touch, values: (values["stiffness"], 0.0, 0.0), "KeyError"),
        (lambda touch, values: (math.sqrt(-1.0), 0.0, 0.0), "ValueError"),
    ],
)
def test_a_law_that_fails_says_where(law, message):
    states = STRETCHES if "states" in inspect.signature(law).parameters else None
    clubface.register_law("mine", law, parameters={"friction": 0.1}, states=states)
    with pytest.raises(RunError, match=message):
        clubface.impact("driver", speed=45.0, model="mine")


@pytest.mark.parametrize("wrong", [lambda: math.sqrt(-1.0), lambda: math.nan, lambda: "much"])
def test_a_law_that_fails_in_one_shot_leaves_the_others_alone(wrong):
    registered(lambda touch, values: (wrong() if touch.rate > 44.0 else 3e11 * touch.depth**1.5, 0.0, 0.0))
    speeds = np.array([40.0, 47.0, 41.0])
    result = clubface.impact("driver", speed=speeds, model="mine", on_error="nan")
    assert np.isnan(result.ball_speed).tolist() == [False, True, False]
    assert [each.row for each in result.problems] == [(1,)]
    assert result.ball_speed[2] == clubface.impact("driver", speed=41.0, model="mine").ball_speed
    with pytest.raises(RunError, match="law of contact"):
        clubface.impact("driver", speed=speeds, model="mine")


@pytest.mark.parametrize(
    ("stiffness", "message"),
    [
        (0.0, "normal force is never above 0"),
        (-1e6, "normal force is never above 0"),
        (1e2, "did not part within 10 ms"),
        (1e300, "too stiff"),  # overflows
    ],
)
def test_a_law_that_makes_no_whole_contact_names_the_reason(stiffness, message):
    registered(lambda touch, values: (stiffness * touch.depth, 0.0, 0.0), friction=0.1)
    for computed in (clubface.impact, clubface.history):
        with pytest.raises(ClubfaceError, match=message):
            computed("driver", speed=45.0, model="mine")


def test_a_law_as_stiff_as_stone_is_an_elastic_collision():
    registered(lambda touch, values: (1e20 * touch.depth, 0.0, 0.0))
    stone = clubface.impact("driver", speed=45.0, model="mine")
    club, ball = stone.club, stone.ball
    velocity, spin = (
        np.array([getattr(stone, f"{name}_{axis}") for axis in "xyz"]) for name in ("club_velocity", "club_spin")
    )
    # The contact lasts 60 ps, in which the head, square at its static loft, does not turn.
    energy = club.mass * velocity @ velocity + spin @ np.array(club.inertia) @ spin + ball.mass * stone.ball_speed**2
    assert energy == pytest.approx(club.mass * 45.0**2, rel=1e-6)
    assert stone.total_spin == pytest.approx(0.0, abs=1e-9)


def spring(touch, values, states):
    """Roh and Lee's mechanism: the ball holds to the face by a spring along it, within the limit of friction."""
    normal = values["stiffness"] * touch.depth**1.5 * (1.0 + values["damping"] * touch.rate)
    normal = np.maximum(normal, 0.0)
    stretch_y, stretch_z = states["stretch_y"], states["stretch_z"]
    pull = values["tangential"] * np.hypot(stretch_y, stretch_z)
    limit = values["friction"] * normal
    slides = pull > limit
    share = limit / pull if slides else 1.0
    # Where it slides, the spring relaxes to what friction holds.
    rates = {
        "stretch_y": touch.sliding_y - (stretch_y * (1.0 - share) / 2e-6 if slides else 0.0),
        "stretch_z": touch.sliding_z - (stretch_z * (1.0 - share) / 2e-6 if slides else 0.0),
    }
    return normal, -values["tangential"] * stretch_y * share, -values["tangential"] * stretch_z * share, rates


SPRING = {"stiffness": 3.4e7, "damping": "0.006 s/m", "friction": 0.4, "tangential": 3e6}
STRETCHES = {"stretch_y": "0.1 mm", "stretch_z": "0.1 mm"}


def test_a_spring_along_the_face_turns_the_friction_round_as_roh_and_lee_found():
    clubface.register_law("mine", spring, parameters=SPRING, states=STRETCHES)
    iron = {"speed": "85 mph", "attack": "-4 deg", "loft": "25 deg"}
    course = clubface.history("7-iron", **iron, model="mine", accuracy=1e-9)
    assert course.force_y.max() > 500.0
    assert course.force_y.min() < -500.0
    energy = course.kinetic_energy + course.normal_work + course.friction_work
    assert energy == pytest.approx(energy[0], rel=1e-6)
    # By the core and by SciPy: the spring is held to the limit of friction where it slides, which is not smooth.
    launch = clubface.impact("7-iron", **iron, model="mine", accuracy=1e-9)
    assert launch.backspin == pytest.approx(course.launch.backspin, rel=1e-4)
    # It rolls faster than without slip: the spring gives back what it took.
    rolling = clubface.impact("7-iron", **iron, model="mine", parameters={"tangential": 1e5})
    assert launch.backspin != pytest.approx(rolling.backspin, rel=0.05)


def test_time_slip_and_place_are_those_of_the_contact():
    seen = []

    def law(touch, values):
        seen.append(touch)
        return hertz(touch, AREA_SI)

    registered(law)
    clubface.history("driver", **SHOT, model="mine")
    first, last = seen[0], max(seen, key=lambda touch: touch.time)
    assert first.time == first.slip_y == first.slip_z == 0.0
    # 12 mm towards the toe and 6 mm low, along the face: a face of 305 mm bulge bends by 1%.
    assert (first.toe, first.high) == pytest.approx((12e-3, -6e-3), rel=1e-2)
    assert last.time == pytest.approx(5e-4, rel=0.2)
    seen.sort(key=lambda touch: touch.time)
    slid = np.trapezoid([touch.sliding_y for touch in seen], [touch.time for touch in seen])
    assert abs(last.slip_y) > 1e-4
    # The stages of a step lie a little off the course.
    assert last.slip_y == pytest.approx(slid, rel=2e-2)


AREA_SI = {"shear_modulus": 54e6, "poisson": 0.398, "damping": 6.35e-3, "friction": 0.0486}


def smooth(touch, values):
    """The law ``hertz`` by functions of NumPy, which take numbers that carry derivatives."""
    stiffness = 4.0 / 3.0 * values["shear_modulus"] / (1.0 - values["poisson"])
    stiffness /= np.sqrt(1.0 / touch.radius + touch.curvature)
    normal = np.maximum(stiffness * touch.depth**1.5 * (1.0 + values["damping"] * touch.rate), 0.0)
    sliding = np.hypot(touch.sliding_y, touch.sliding_z)
    drag = values["friction"] * normal * np.tanh(sliding / 0.01) / sliding if sliding else 0.0 * normal
    return normal, -drag * touch.sliding_y, -drag * touch.sliding_z


def test_derivatives_are_those_of_the_same_law_in_the_core():
    registered(smooth)
    variables = ["speed", "loft", "attack", "toe", "high", "friction", "shear_modulus", "club_mass", "ball_mass", "iyy"]
    outputs = ["ball_speed", "launch", "azimuth", "backspin", "sidespin", "contact_time"]
    given = SHOT | {"accuracy": 1e-10, "variables": variables, "outputs": outputs}
    mine = clubface.sensitivity("driver", **given, model="mine")
    # The law of area without its area term.
    set_of_area = built_in()
    core = clubface.sensitivity(
        "driver", **given, model="area",
        parameters=replace(set_of_area, values={**set_of_area.values, **AREA_SI, "area_damping": 0.0}),
    )  # fmt: skip
    size = np.abs(core.si).max(axis=0)
    # Steps of two methods at 1e-10, whose lengths carry no derivatives.
    assert np.abs(mine.si - core.si).max() <= 1e-4 * size.max()
    assert (np.abs(mine.si - core.si) <= 1e-4 * size).all()
    batch = clubface.sensitivity("driver", **given | {"toe": [0.0, 0.012]}, model="mine")
    assert batch.si[..., 1] == pytest.approx(mine.si, rel=1e-9, abs=1e-12)


def test_derivatives_go_through_the_states_of_a_law():
    clubface.register_law("mine", spring, parameters=SPRING, states=STRETCHES)
    iron = {"speed": 38.0, "attack": -0.07, "loft": 0.35, "model": "mine", "accuracy": 1e-10}

    def backspin(tangential):
        return clubface.impact("7-iron", **iron, parameters={"tangential": tangential}).backspin

    slope = clubface.sensitivity("7-iron", **iron, parameters={"tangential": 2e6}, variables=["tangential"])
    difference = (backspin(2.02e6) - backspin(1.98e6)) / 4e4
    # Differences over 1% of the spring, of a contact with a limit of friction that it meets at some instant.
    assert slope.value("backspin", "tangential") == pytest.approx(difference, rel=2e-2)


def test_a_law_without_derivatives_says_what_to_use():
    registered()
    with pytest.raises(RunError, match=r"no derivatives: .*; use functions of NumPy"):
        clubface.sensitivity("driver", speed=45.0, model="mine")


COMPILED = """
#include <complex.h>
#include <math.h>
#include <string.h>

#define LAW(name, number, root, power, hyperbolic) \
    void name(const number *t, const number *v, const number *s, number *out) { \
        number stiffness = 4.0 / 3.0 * v[0] / (1.0 - v[1]) / root(1.0 / t[5] + t[4]); \
        number normal = stiffness * power(t[0], 1.5) * (1.0 + v[2] * t[1]); \
        if (REAL(normal) < 0.0) normal = 0.0; \
        number sliding = root(t[2] * t[2] + t[3] * t[3]); \
        number drag = v[3] * normal * hyperbolic(sliding / 0.01) / sliding; \
        out[0] = normal; out[1] = -drag * t[2]; out[2] = -drag * t[3]; \
    }
#define REAL(x) creal(x)
LAW(law, double, sqrt, pow, tanh)
LAW(complex_law, double complex, csqrt, cpow, ctanh)
"""


@pytest.fixture(scope="module")
def compiled(tmp_path_factory):
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler")
    folder = tmp_path_factory.mktemp("law")
    (folder / "law.c").write_text(COMPILED)
    subprocess.run([compiler, "-O2", "-shared", "-fPIC", "law.c", "-o", "law.so", "-lm"], cwd=folder, check=True)
    library = ctypes.CDLL(str(folder / "law.so"))
    return library.law, library.complex_law


def test_a_compiled_law_is_the_same_law(compiled):
    law, complex_law = compiled
    registered(smooth)
    slopes = {"variables": ["loft", "toe", "friction", "poisson"], "outputs": ["ball_speed", "backspin", "sidespin"]}
    in_python = clubface.impact("driver", **SHOT, model="mine")
    course = clubface.history("driver", **SHOT, model="mine")
    derivatives = clubface.sensitivity("driver", **SHOT, **slopes, model="mine").si
    clubface.register_law("mine", law, parameters=AREA, complex_law=complex_law)
    assert clubface.impact("driver", **SHOT, model="mine")._values == pytest.approx(in_python._values, rel=1e-10)
    assert clubface.history("driver", **SHOT, model="mine").force_y == pytest.approx(course.force_y, rel=1e-6, abs=1e-3)
    # The complex power and root round otherwise.
    assert clubface.sensitivity("driver", **SHOT, **slopes, model="mine").si == pytest.approx(derivatives, rel=1e-6)
    clubface.register_law("mine", law, parameters=AREA)
    with pytest.raises(InputError, match="complex_law"):
        clubface.sensitivity("driver", speed=45.0, model="mine")


@pytest.mark.parametrize("states", [5, {"a": "0 mm"}, {"a": "3 bananas"}, {f"s{i}": 1.0 for i in range(25)}])
def test_invalid_states_are_refused(states):
    with pytest.raises(ClubfaceError):
        clubface.register_law("mine", spring, states=states)


@pytest.mark.parametrize("name", ["area", "fem", "all", "two words", 3])
def test_a_name_must_be_a_new_word(name):
    with pytest.raises(InputError, match="name"):
        clubface.register_law(name, hertz)


def test_invalid_laws_and_parameters_are_refused():
    with pytest.raises(InputError, match="law"):
        clubface.register_law("mine", 3)
    with pytest.raises(ClubfaceError, match="stiffness"):
        registered(stiffness="3 bananas")
    with pytest.raises(InputError, match="stiffness"):
        registered(stiffness=math.nan)
    for given in (5, [1.0], {5: 1.0}, {"": 1.0}, {"a b": 1.0}):
        with pytest.raises(InputError, match=r"^(parameters|name of a parameter) is"):
            clubface.register_law("mine", hertz, parameters=given)


def test_a_custom_law_serves_comparisons_and_maps():
    registered()
    swing = {"speed": "110 mph", "loft": "13 deg"}
    compared = clubface.compare(
        {name: {"club": "driver", "delivery": swing | {"loft": name}, "model": "mine"} for name in ("13 deg", "14 deg")}
    )
    assert compared.difference("14 deg", "launch") > 0.0
    result = clubface.map_face("driver", **swing, model="mine", grid=(5, 3))
    middle = clubface.impact("driver", **swing, model="mine")
    assert result.at(0.0, 0.0)["ball_speed"] == pytest.approx(middle.ball_speed, rel=1e-3)


def test_functions_for_compiled_models_refuse_a_custom_law_and_unknown_names_list_it():
    registered()
    with pytest.raises(InputError, match="one with derivatives"):
        clubface.explain("driver", speed=45.0, model="mine")
    with pytest.raises(InputError, match="mine"):
        clubface.impact("driver", speed=45.0, model="mime")
