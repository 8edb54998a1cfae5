"""Material laws written in C: the built-in laws written so, damage and creep by state variables, mistakes."""

import ctypes
import math
import shutil
import subprocess
from dataclasses import replace

import numpy as np
import pytest

from clubface import fem
from clubface.errors import ClubfaceError, FileError, InputError
from clubface.fem import keyword
from clubface.fem.case import case
from clubface.fem.materials import REGISTERED, Material, Maxwell
from fem_runs import drive_case, of_core, write_case

LAW = 'law = "mooney-rivlin"\n'
OWN = 'law = "rivlin-in-c"\n'
RIVLIN = {"c10": "4 MPa", "c01": "1 MPa"}
BRANCH = Maxwell(modulus=0.4, time="80 us")
HEAD = """
#include <math.h>
#include <stddef.h>
#include <string.h>

#define LAW(name) void name(size_t n, const double *c, const double *k, double dt, double *s, double *r)
#define I1(i) (c[i] + c[n + i] + c[2 * n + i])
"""
COMPILED = (
    HEAD
    + """
static const size_t DIAGONAL = 3, SHEARS = 6;

LAW(rivlin) {
    for (size_t i = 0; i < n; i++) {
        double square = 0.0;
        for (size_t row = 0; row < 6; row++) square += (row < 3 ? 1.0 : 2.0) * c[row * n + i] * c[row * n + i];
        double first = I1(i), second = 0.5 * (first * first - square);
        for (size_t row = 0; row < 6; row++)
            r[row * n + i] = -2.0 * k[1] * c[row * n + i] + (row < 3 ? 2.0 * (k[0] + k[1] * first) : 0.0);
        r[6 * n + i] = k[0] * (first - 3.0) + k[1] * (second - 3.0);
    }
}

/* C^-1 of a tensor of determinant one: its cofactors. */
static void inverse(const double *a, double *b) {
    b[0] = a[1] * a[2] - a[5] * a[5]; b[1] = a[0] * a[2] - a[4] * a[4]; b[2] = a[0] * a[1] - a[3] * a[3];
    b[3] = a[4] * a[5] - a[3] * a[2]; b[4] = a[3] * a[5] - a[4] * a[1]; b[5] = a[3] * a[4] - a[5] * a[0];
}

/* Neo-Hookean rubber with a Maxwell branch after Simo (1987). States: the stress that the dashpot has come to, C and
   the stress of the branch when its work was last added up, and the work. */
LAW(creeping) {
    double mu = k[0], modulus = k[1], time = k[2];
    double half = modulus * exp(-0.5 * dt / time), way = 1.0 - exp(-dt / time);
    for (size_t i = 0; i < n; i++) {
        double a[6], b[6], work = 0.0;
        for (size_t row = 0; row < 6; row++) a[row] = c[row * n + i];
        inverse(a, b);
        for (size_t row = 0; row < 6; row++) {
            double one = row < 3 ? 1.0 : 0.0;
            double driving = mu * (one - I1(i) / 3.0 * b[row]);
            double *dashpot = s + row * n + i, *last_c = s + (6 + row) * n + i, *last = s + (12 + row) * n + i;
            double branch = half * (driving - *dashpot);
            r[row * n + i] = mu * one + branch;
            if (dt > 0.0) {
                *dashpot += way * (driving - *dashpot);
                /* C - 1, which is zero before any deformation. */
                work += (row < 3 ? 0.25 : 0.5) * (branch + *last) * (a[row] - one - *last_c);
                *last_c = a[row] - one;
                *last = branch;
            }
        }
        s[18 * n + i] += work;
        r[6 * n + i] = 0.5 * mu * (I1(i) - 3.0);
        r[7 * n + i] = s[18 * n + i];
    }
}

/* Ogden and Roxburgh (1999) on neo-Hookean rubber: softer below the largest energy so far, the state. */
static double integral(double x) { return x * erf(x) + exp(-x * x) / sqrt(3.14159265358979323846); }
LAW(softening) {
    double mu = k[0], strength = k[1], scale = k[2];
    for (size_t i = 0; i < n; i++) {
        double energy = 0.5 * mu * (I1(i) - 3.0), *most = s + i;
        double largest = energy > *most ? energy : *most;
        if (dt > 0.0) *most = largest;
        double below = (largest - energy) / scale, share = 1.0 - erf(below) / strength;
        for (size_t row = 0; row < 6; row++) r[row * n + i] = row < 3 ? share * mu : 0.0;
        double lost = scale / strength * (integral(largest / scale) - integral(0.0));
        r[6 * n + i] = energy - lost + scale / strength * (integral(below) - integral(0.0));
        r[7 * n + i] = lost;
    }
}

/* Mistakes, and fibres along x. */
#define EACH for (size_t i = 0; i < n; i++)
#define RIVLIN rivlin(n, c, k, dt, s, r)
LAW(stressed) { RIVLIN; EACH r[3 * n + i] += 1e5; }
LAW(charged) { RIVLIN; EACH r[6 * n + i] += 1e5; }
LAW(halved) { RIVLIN; for (size_t i = 0; i < 6 * n; i++) r[i] *= 0.5; }
LAW(swapped) { RIVLIN; EACH { double xz = r[4 * n + i]; r[4 * n + i] = r[5 * n + i]; r[5 * n + i] = xz; } }
LAW(by_points) { memset(r, 0, 7 * n * sizeof *r); EACH for (size_t row = 0; row < 3; row++) r[7 * i + row] = k[0]; }
LAW(fibres) { RIVLIN; EACH { double e = c[i] - 1.0; r[i] += 2.0 * k[1] * e; r[6 * n + i] += 0.5 * k[1] * e * e; } }
LAW(silent) { }
LAW(undefined) { RIVLIN; EACH if (I1(i) > 3.1) r[i] = NAN; }
"""
)


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler")
    folder = tmp_path_factory.mktemp("law")
    (folder / "laws.c").write_text(COMPILED)
    subprocess.run([compiler, "-O2", "-shared", "-fPIC", "laws.c", "-o", "laws.so", "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / "laws.so"))


@pytest.fixture(autouse=True)
def _forget():
    yield
    REGISTERED.clear()


def drive(material, **settings):
    return drive_case(**settings).replace(ball=of_core(material)).run()


def assert_same(one, other, most):
    assert one.peak_force == pytest.approx(other.peak_force, rel=most)
    for name, value in other.outcome().items():
        assert one.outcome()[name] == pytest.approx(value, rel=most, abs=1e-9), name


@pytest.mark.parametrize("element", ["one-point", "full"])
def test_a_ball_of_a_law_in_c_is_the_ball_of_the_same_law_in_the_core(tmp_path, library, element):
    fem.register_law("rivlin-in-c", library.rivlin, constants=RIVLIN)
    pieces = f'element = "{element}"\n\n[[pieces]]'
    runs = []
    for new in (LAW, OWN):
        path = write_case(tmp_path, duration=600, old=LAW, new=new)
        ball = tmp_path / "ball.toml"
        ball.write_text(ball.read_text().replace("[[pieces]]", pieces, 1))
        runs.append(case(path).run())
    law, own = runs
    assert own.ball.pieces[0].material.law == "rivlin-in-c"
    # The moduli come from differences, to 1e-12; rounding grows over a thousand steps of contact.
    assert_same(own, law, 1e-8)
    assert own.energy["strain"].max() == pytest.approx(law.energy["strain"].max(), rel=1e-8)
    assert own.energy_error < 1e-3
    assert own.energy_error == pytest.approx(law.energy_error, rel=1e-3)


def test_moduli_of_a_law_in_c(library):
    fem.register_law("rivlin-in-c", library.rivlin, constants=RIVLIN)
    own, law = (
        Material(law=name, constants={"c10": "3 MPa", "c01": "0.7 MPa"}, poisson=0.49)
        for name in ("rivlin-in-c", "mooney-rivlin")
    )
    # Differences of the fourth order.
    assert own.shear == pytest.approx(law.shear, rel=1e-11)
    assert own.bulk == pytest.approx(law.bulk, rel=1e-11)
    for constant in ("c10", "c01"):
        assert own.shear_slope(constant) == pytest.approx(2.0, rel=1e-7)


def test_branches_of_a_material_of_a_law_in_c(library):
    fem.register_law("rivlin-in-c", library.rivlin, constants=RIVLIN)
    own, law = (
        drive(Material(law=name, constants=RIVLIN, poisson=0.49, maxwell=(BRANCH,)))
        for name in ("rivlin-in-c", "mooney-rivlin")
    )
    assert_same(own, law, 1e-8)
    assert own.energy["viscous"][-1] == pytest.approx(law.energy["viscous"][-1], rel=1e-8)


def test_creep_by_state_variables_is_the_creep_of_a_branch(library):
    constants = {"mu": "10 MPa", "modulus": 0.4, "time": "80 us"}
    fem.register_law("creeping", library.creeping, constants=constants, states=19)
    own = Material(law="creeping", constants=constants, poisson=0.49)
    # In no time the branch is a spring: the ball is as stiff as both, and so is its stable step.
    assert own.shear == pytest.approx(14e6, rel=1e-11)
    slow = Material(law="neo-hookean", constants={"shear": "10 MPa"}, poisson=0.49, maxwell=(BRANCH,))
    # The bulk modulus of the built-in law is that of the slow modulus.
    poisson = (3.0 * slow.bulk - 2.0 * own.shear) / (2.0 * (3.0 * slow.bulk + own.shear))
    # Elements of eight points have no hourglass stiffness, which is of the slow modulus there and of the fast one here.
    own, law = (
        drive_case().replace(ball=of_core(each, element="full")).run() for each in (replace(own, poisson=poisson), slow)
    )
    assert_same(own, law, 1e-8)
    assert own.energy_error < 1e-3
    # The trapezoidal rule over every step, and over four steps at a time in the core.
    assert own.energy["plastic"][-1] == pytest.approx(law.energy["viscous"][-1], rel=5e-3)


def test_damage_by_a_state_variable_takes_energy(library):
    constants = {"mu": "10 MPa", "strength": 2.0, "scale": "1 MPa"}
    fem.register_law("softening", library.softening, constants=constants, states=1)
    fem.register_law("rivlin-in-c", library.rivlin, constants=RIVLIN)
    whole = drive(Material(law="rivlin-in-c", constants={"c10": "5 MPa", "c01": 0.0}, poisson=0.49))
    made = Material(law="softening", constants=constants, poisson=0.49)
    damaged = drive(made)
    lost = damaged.energy["plastic"]
    assert np.all(np.diff(lost) >= -1e-12)
    assert lost[-1] > 1.0  # of 100 J
    assert damaged.energy_error < 1e-3
    assert damaged.outcome()["ball_speed"] < whole.outcome()["ball_speed"]
    # Loading is that of rubber without damage.
    assert damaged.peak_force == pytest.approx(whole.peak_force, rel=0.02)
    with pytest.raises(ClubfaceError, match="state variables"):
        replace(made, maxwell=(BRANCH,))


def test_a_law_as_a_function_of_python(library):
    @fem.LawFunction
    def rivlin(count, shapes, constants, step, states, results):
        shape, result = (np.ctypeslib.as_array(each, (rows, count)) for each, rows in ((shapes, 6), (results, 8)))
        weights = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])
        first, square = shape[:3].sum(axis=0), weights @ shape**2
        result[:6] = -2.0 * constants[1] * shape
        result[:3] += 2.0 * (constants[0] + constants[1] * first)
        result[6] = constants[0] * (first - 3.0) + constants[1] * ((first**2 - square) / 2.0 - 3.0)

    fem.register_law("in-python", rivlin, constants=RIVLIN)
    fem.register_law("in-c", library.rivlin, constants=RIVLIN)
    own, compiled = (
        drive(Material(law=name, constants=RIVLIN, poisson=0.49), duration="60 us", threads=2, until_separation=False)
        for name in ("in-python", "in-c")
    )
    assert own.contact["normal"] == pytest.approx(compiled.contact["normal"], rel=1e-9)


def test_derivatives_by_the_constants_of_a_law_in_c(library):
    fem.register_law("rivlin-in-c", library.rivlin, constants=RIVLIN)
    slopes = []
    for name in ("rivlin-in-c", "mooney-rivlin"):
        ball = of_core(Material(law=name, constants=RIVLIN, poisson=0.49, maxwell=(BRANCH,)))
        by = ["core.c10", "core.c01", "core.maxwell.0.modulus", "speed"]
        derivatives = fem.sensitivity("driver", speed="100 mph", ball=ball, by=by)
        slopes.append([derivatives.by(output, each) for output in ("ball_speed", "backspin") for each in by])
    # Differences of 1e-12, grown over the contact.
    assert slopes[0] == pytest.approx(slopes[1], rel=1e-6)


@pytest.mark.parametrize(
    ("function", "message"),
    [
        ("stressed", r"function is stressed with a stress of 1\.000000e5 Pa at rest; it must be free of stress"),
        ("charged", "with an energy of 1.000000e5 J/m3 at rest"),
        ("halved", "with a stress that does 0.5"),
        ("swapped", "in the rows xx, yy, zz, xy, xz, yz"),
        ("by_points", "must be|a stress|shear modulus"),
        ("silent", "seven finite numbers"),
        ("fibres", "isotropic"),
    ],
)
def test_a_mistake_in_a_law_is_found_when_it_is_registered(library, function, message):
    with pytest.raises(InputError, match=message):
        fem.register_law(function, getattr(library, function), constants=RIVLIN)
    assert function not in fem.laws()


def test_invalid_constants_and_names_are_refused(library):
    for name in ("mooney-rivlin", "energy", "two words", "", 3):
        with pytest.raises(InputError, match="name"):
            fem.register_law(name, library.rivlin, constants=RIVLIN)
    for function in (3, "rivlin", lambda *given: None):
        with pytest.raises(InputError, match="function"):
            fem.register_law("mine", function, constants=RIVLIN)
    for states in (-1, 65, 1.5, "3"):
        with pytest.raises(InputError, match="states"):
            fem.register_law("mine", library.rivlin, constants=RIVLIN, states=states)
    for constants in ({"poisson": 1.0}, {"a b": 1.0}, {3: 1.0}, {"c10": "3 bananas"}, {"c10": math.nan}, 4):
        with pytest.raises(ClubfaceError):
            fem.register_law("mine", library.rivlin, constants=constants)
    with pytest.raises(InputError, match="stiff at rest"):
        fem.register_law("mine", library.rivlin, constants={"c10": "-4 MPa", "c01": "1 MPa"})
    fem.register_law("mine", library.rivlin, constants=RIVLIN)
    for constants, message in (
        ({"c10": "4 MPa"}, "c01"),
        ({"c10": "4 MPa", "c01": "1 mm"}, "c01"),
        ({"c10": "-4 MPa", "c01": "1 MPa"}, "stiff at rest"),
        ({"c10": "4 Pa", "c01": "1 Pa"}, "shear modulus is"),
    ):
        with pytest.raises(ClubfaceError, match=message):
            Material(law="mine", constants=constants, poisson=0.49)


def test_a_mistake_in_a_file_is_named_with_its_line(tmp_path, library):
    fem.register_law("rivlin-in-c", library.rivlin, constants={"c10": "4 MPa", "c02": "1 MPa"})
    with pytest.raises(FileError, match="unknown key 'c01'") as error:
        case(write_case(tmp_path, old=LAW, new=OWN))
    assert error.value.line == 11
    with pytest.raises(FileError, match="rivlin-in-d"):
        case(write_case(tmp_path, old=LAW, new='law = "rivlin-in-d"\n'))


def test_a_law_that_gives_no_number_stops_the_run(library):
    fem.register_law("undefined", library.undefined, constants=RIVLIN)
    result = drive(Material(law="undefined", constants=RIVLIN, poisson=0.49))
    assert "energy balance" in str(result.stopped)


def test_a_custom_law_has_no_card(tmp_path, library):
    fem.register_law("rivlin-in-c", library.rivlin, constants=RIVLIN)
    written = case(write_case(tmp_path, old=LAW, new=OWN))
    with pytest.raises(InputError, match="card"):
        keyword.write(written, tmp_path / "deck.k")
