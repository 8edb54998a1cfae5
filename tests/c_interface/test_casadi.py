"""Impact and flight as external functions of CasADi: values, derivatives, and programs that optimise through them."""

import numpy as np
import pytest

import clubface
from c_programs import STRICT, ran
from clubface.errors import InputError
from clubface.export import casadi_source
from clubface.simulation.differentiable import LaunchFunction
from clubface.simulation.results import flight_inputs
from clubface.simulation.sensitivity import flight_derivatives
from command_line import assert_mistake

casadi = pytest.importorskip("casadi", reason="CasADi is not installed")

DELIVERY = ("speed", "attack", "path", "loft", "face", "lie", "toe", "high", "closure", "pitch_rate", "lie_rate")
DRIVE = [48.0, 0.03, 0.02, 0.22, -0.01, 0.03, 0.008, 0.004, 40.0, 2.0, 1.0]
FLIGHT = ("carry", "side", "apex", "landing_angle", "flight_time", "landing_speed", "landing_spin", "curve")
VELOCITY_AND_SPIN = slice(8, 14)
QUIET = {"print_level": 0, "sb": "yes"}


@pytest.fixture
def build(flags, tmp_path):
    """Compile a source as its first lines say, with every warning an error; return the functions that it exports."""

    def built(source, *options):
        (tmp_path / "impact.c").write_text(source)
        library = tmp_path / "impact.so"
        ran(
            "cc", "-std=c99", *STRICT, "-O2", "-shared", "-fPIC", tmp_path / "impact.c", *options, *flags, "-o", library
        )
        return casadi.external("impact", str(library)), casadi.external("flight", str(library))

    return built


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("model", ["response", "standard", "volumetric", "rings"])
def test_launch_and_jacobian_are_those_of_the_package(build, model, hand):
    impact, _ = build(casadi_source("driver", model=model, hand=hand))
    table = clubface.sensitivity(
        "driver", dict(zip(DELIVERY, DRIVE, strict=True)), model=model, hand=hand, variables=DELIVERY
    )
    launch = np.array(impact(DRIVE)).ravel()
    # One code computes both; packs of other widths may differ in the last bits, which a contact magnifies.
    assert launch == pytest.approx([getattr(table.launch, name) for name in table.outputs], rel=1e-10, abs=1e-12)
    jacobian = np.array(impact.jacobian()(DRIVE, launch))
    expected = [[table.value(output, name) for name in DELIVERY] for output in table.outputs]
    assert jacobian == pytest.approx(np.array(expected), rel=1e-8, abs=1e-8)


def test_the_flight_and_its_jacobian_are_those_of_the_package(build):
    wind = (-4.0, 0.0, 2.0)
    _, flight = build(casadi_source("driver", wind=wind, air={"altitude": 1600.0}, ball="distance"))
    launch = {
        "velocity_x": 66.0,
        "velocity_y": 14.0,
        "velocity_z": 1.5,
        "spin_x": -5.0,
        "spin_y": 20.0,
        "spin_z": 260.0,
    }
    ball = clubface.ball("distance")
    given = {**launch, **{f"ball_{name}": getattr(ball, name) for name in ("mass", "radius", "inertia")}}
    flown = clubface.fly(given, wind=wind, air={"altitude": 1600.0})
    landed = np.array(flight(list(launch.values()))).ravel()
    assert landed == pytest.approx([getattr(flown, name) for name in FLIGHT], rel=1e-12)
    exact = flight_derivatives(given, wind=wind, air={"altitude": 1600.0})
    rows = [list(exact.values).index(name) for name in FLIGHT]
    columns = [list(flight_inputs()).index(name) for name in launch]
    jacobian = np.array(flight.jacobian()(list(launch.values()), landed))
    assert np.array_equal(jacobian, exact.jacobian[np.ix_(rows, columns)])


def test_the_gradient_of_a_carry_through_a_graph_is_its_finite_difference(build):
    """Chain rule by CasADi over both functions, with a swing before them and a penalty after them."""
    impact, flight = build(casadi_source("driver", {"lie": 0.02}, model="volumetric", accuracy=1e-10))
    swing = casadi.MX.sym("swing", 3)
    delivery = casadi.vertcat(
        40.0 + 8.0 * casadi.sin(swing[0]), 0.05 * swing[1], 0.01, 0.2 + 0.05 * swing[1] + 0.01 * swing[2], 0.0,
        0.004 * swing[2], 0.0, 30.0 * swing[0], 0.0, 0.0,
    )  # fmt: skip
    carry, side = casadi.vertsplit(flight(impact(delivery)[VELOCITY_AND_SPIN]))[:2]
    value = carry - 0.1 * side**2
    function = casadi.Function("value", [swing], [value])
    gradient = np.array(casadi.Function("gradient", [swing], [casadi.gradient(value, swing)])([1.2, 0.4, 0.7])).ravel()
    step = 1e-3
    for place in range(3):
        points = [np.array([1.2, 0.4, 0.7]) + shift * step * np.eye(3)[place] for shift in (-2, -1, 1, 2)]
        far, near, next_, last = (float(function(point)) for point in points)
        # A difference of fourth order; the contact is integrated to 1e-10 of values near 200, and divided by 1e-3.
        assert (far - 8.0 * near + 8.0 * next_ - last) / (12.0 * step) == pytest.approx(gradient[place], rel=1e-5)


def test_second_derivatives_are_differences_of_the_first_and_symmetric(build):
    impact, flight = build(casadi_source("driver", {"speed": 48.0, "lie": 0.0}, model="response"))
    x = casadi.MX.sym("x", 9)
    carry = flight(impact(x)[VELOCITY_AND_SPIN])[0]
    at = np.array([0.03, 0.02, 0.22, -0.01, 0.008, 0.004, 40.0, 2.0, 1.0])
    hessian = np.array(casadi.Function("hessian", [x], [casadi.hessian(carry, x)[0]])(at))
    gradient = casadi.Function("gradient", [x], [casadi.gradient(carry, x)])
    scale = np.array([0.2, 0.2, 0.2, 0.2, 0.02, 0.02, 50.0, 50.0, 50.0])  # sizes of angles, lengths and rates in golf
    steps = 1e-4 * scale
    differences = np.array(
        [np.array(gradient(at + step) - gradient(at - step)).ravel() / (2.0 * step.max()) for step in np.diag(steps)]
    )
    assert np.array_equal(hessian, hessian.T)
    # Of a flight second derivatives are good to 1e-6 of the largest, every variable scaled by its size.
    scaled, expected = hessian * np.outer(scale, scale), differences * np.outer(scale, scale)
    assert scaled == pytest.approx(expected, abs=1e-6 * np.abs(expected).max())


def test_a_model_without_second_derivatives_has_none_here(build):
    impact, _ = build(casadi_source("driver", model="rings"))
    x = casadi.MX.sym("x", 11)
    with pytest.raises(RuntimeError):
        casadi.hessian(impact(x)[0], x)
    assert "jac_jac_impact" not in casadi_source("driver", model="volumetric")
    assert "jac_jac_impact" in casadi_source("driver", model="volumetric", accuracy=1e-10)


@pytest.mark.parametrize("hessian", ["exact", "limited-memory"])
def test_ipopt_finds_the_loft_and_the_attack_angle_of_the_longest_carry(build, hessian):
    """The best loft is where its derivative vanishes; hitting up is worth distance, so attack is at the bound."""
    impact, flight = build(casadi_source("driver", {"speed": "105 mph"}, variables=["attack", "loft"]))
    problem = casadi.Opti()
    attack, loft = problem.variable(), problem.variable()
    carry = flight(impact(casadi.vertcat(attack, loft))[VELOCITY_AND_SPIN])[0]
    problem.minimize(-carry / 100.0)
    problem.subject_to(problem.bounded(-0.08, attack, 0.08))
    problem.subject_to(problem.bounded(0.1, loft, 0.4))
    problem.set_initial(loft, 0.2)
    problem.solver("ipopt", {"print_time": False}, {**QUIET, "tol": 1e-9, "hessian_approximation": hessian})
    solution = problem.solve()
    assert solution.value(attack) == pytest.approx(0.08, abs=1e-6)
    lofts = solution.value(loft) + np.linspace(-0.02, 0.02, 41)
    carries = clubface.fly(clubface.impact("driver", speed="105 mph", attack=0.08, loft=lofts)).carry
    assert carries.argmax() == 20
    # Ipopt widens the bound by 1e-8, which is worth a micrometre of carry.
    assert solution.value(carry) == pytest.approx(carries[20], abs=1e-5)


def test_ipopt_finds_the_swing_behind_a_launch(build):
    """Speed, loft and attack angle from ball speed, launch angle and backspin that the package computed from others."""
    wanted = {"speed": 47.0, "attack": 0.035, "loft": 0.21}
    measured = ["ball_speed", "launch", "backspin"]
    impact, _ = build(casadi_source("driver", variables=list(wanted), quantities=measured))
    launch = clubface.impact("driver", wanted)
    x = casadi.MX.sym("x", 3)
    scales = casadi.DM([50.0, 0.2, 250.0])
    misfit = (impact(x) - casadi.DM([getattr(launch, name) for name in measured])) / scales
    options = {"ipopt": {**QUIET, "tol": 1e-12}, "print_time": False}
    solver = casadi.nlpsol("solver", "ipopt", {"x": x, "f": casadi.sumsqr(misfit)}, options)
    result = solver(x0=[42.0, 0.0, 0.25], lbx=[20.0, -0.2, 0.0], ubx=[70.0, 0.2, 0.6])
    assert np.array(result["x"]).ravel() == pytest.approx(list(wanted.values()), rel=1e-5)


def test_a_head_is_designed_with_its_mass_and_a_parameter_as_variables(build):
    names = ["club_mass", "cg_x", "ball_mass", "cor", "loft"]
    impact, flight = build(casadi_source("driver", {"speed": 48.0}, variables=names, model="standard"))
    function = LaunchFunction("driver", {"speed": 48.0}, names, model="standard")
    at = np.array([0.2, 0.04, 0.0459, 0.8, 0.2])
    values, jacobian = function.values_and_jacobian(at)
    assert np.array(impact(at)).ravel() == pytest.approx(values, rel=1e-12, abs=1e-12)
    assert np.array(impact.jacobian()(at, values)) == pytest.approx(jacobian, rel=1e-10, abs=1e-10)
    assert flight.size1_in(0) == 7  # a ball whose mass is a variable flies with it


def test_code_that_casadi_generates_through_it_computes_the_same(build, flags, tmp_path):
    """As solvers do that compile what CasADi generates, such as acados."""
    source = casadi_source("driver", {"speed": 48.0}, variables=["loft", "attack"])
    impact, flight = build(source)
    x = casadi.MX.sym("x", 2)
    carry = flight(impact(x)[VELOCITY_AND_SPIN])[0]
    function = casadi.Function("stage", [x], [carry, casadi.gradient(carry, x)])
    generator = casadi.CodeGenerator("stage.c")
    generator.add(function)
    generator.generate(f"{tmp_path}/")
    library = tmp_path / "stage.so"
    ran("cc", "-O1", "-shared", "-fPIC", tmp_path / "stage.c", tmp_path / "impact.c", *flags, "-o", library)
    compiled = casadi.external("stage", str(library))
    for one, other in zip(function([0.2, 0.03]), compiled([0.2, 0.03]), strict=True):
        assert np.array_equal(np.array(one), np.array(other))


def test_many_shots_run_on_several_threads(build):
    impact, _ = build(casadi_source("driver", {"speed": 48.0}, variables=["loft"], quantities=["ball_speed"]))
    lofts = np.linspace(0.1, 0.4, 64)
    expected = clubface.impact("driver", speed=48.0, loft=lofts).ball_speed
    for kind in ("serial", "thread"):
        speeds = np.array(impact.map(64, kind, *([2] if kind == "thread" else []))(lofts[None, :])).ravel()
        assert speeds == pytest.approx(expected, rel=1e-12)


def test_a_shot_that_cannot_be_computed_fails_with_its_reason(build, capfd):
    impact, _ = build(casadi_source("driver"))
    with pytest.raises(RuntimeError):
        impact([48.0, 0.0, 0.0, 0.2, 0.0, 0.0, 0.4, 0.0, 0.0, 0.0, 0.0])
    assert "outside the face outline" in capfd.readouterr().err


def test_a_library_with_other_columns_is_refused(build, capfd):
    source = casadi_source("driver")
    assert "#define OUTPUTS 22" in source
    impact, _ = build(source.replace("#define OUTPUTS 22", "#define OUTPUTS 23"))
    with pytest.raises(RuntimeError):
        impact(DRIVE)
    assert "export it again" in capfd.readouterr().err


@pytest.mark.parametrize(
    ("given", "options", "words"),
    [
        ({}, {"variables": ["loff"]}, ["loff", "loft"]),
        ({}, {"variables": []}, ["variables", "one or more"]),
        ({"loft": 0.2}, {"variables": ["loft"]}, ["loft", "given and a variable"]),
        ({}, {"variables": ["loft", "loft"]}, ["loft", "twice"]),
        ({}, {"variables": ["speed", "face_width"]}, ["face_width", "plain number"]),
        ({}, {"quantities": ["carry"]}, ["carry", "ball_speed"]),
        ({"loft": [0.1, 0.2]}, {}, ["an array"]),
        ({}, {"variables": ["loft"]}, ["speed"]),
        ({}, {"model": "fem"}, ["fem", "response"]),
    ],
)
def test_inputs_that_cannot_be_exported_are_named(given, options, words):
    with pytest.raises(InputError) as refused:
        casadi_source("driver", given, **options)
    for word in words:
        assert word in str(refused.value)


def test_the_command_writes_the_same_source(clubface_, tmp_path):
    path = tmp_path / "impact.c"
    options = "--by loft,attack --quantity ball_speed --model volumetric --accuracy 1e-10 -o"
    exported = clubface_(
        "export", "casadi", "driver", "--speed", "105 mph", "--wind", "-5 m/s", *options.split(), str(path)
    )
    assert exported.status == 0, exported.err
    expected = casadi_source(
        "driver", {"speed": "105 mph"}, variables=["loft", "attack"], quantities=["ball_speed"], model="volumetric",
        accuracy=1e-10, wind=(-5.0, 0.0, 0.0),
    )  # fmt: skip
    assert path.read_text() == expected
    assert_mistake(clubface_("export", "casadi", "driver", "--by", "loff", "-o", str(path)), "loff", "loft")
