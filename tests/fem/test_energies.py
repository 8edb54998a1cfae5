"""Materials by an energy of one's own: the built-in laws written so, what is refused and where, and derivatives."""

import re

import numpy as np
import pytest

from clubface import fem
from clubface.errors import FileError, ImplausibleWarning, InputError
from clubface.fem import keyword
from clubface.fem.case import case
from clubface.fem.materials import Energy, Material
from fem_runs import of_core, write_case

LAW = 'law = "mooney-rivlin"\n'
RIVLIN = 'energy = "c10*(I1-3) + c01*(I2-3)"\n'
YEOH = "c10*(I1-3) + c20*(I1-3)^2"
SETTINGS = fem.Settings(until_separation=True)


def rubber(energy=YEOH, poisson=0.49, **constants):
    constants = constants or {"c10": "4 MPa", "c20": "0.3 MPa"}
    return Material(energy=energy, constants=constants, poisson=poisson, density="1150 kg/m3")


def test_a_ball_whose_file_writes_its_law_as_an_energy_is_the_same_ball(tmp_path):
    law = case(write_case(tmp_path, duration=600)).run()
    written = case(write_case(tmp_path, duration=600, old=LAW, new=RIVLIN))
    core = written.ball.pieces[0].material
    assert (core.law, core.energy, core.constants["c01"]) == ("energy", "c10*(I1-3) + c01*(I2-3)", 1e6)
    assert core.shear == pytest.approx(10e6, rel=1e-14)
    result = written.run()
    # Rounding, grown over a thousand steps of contact.
    assert result.peak_force == pytest.approx(law.peak_force, rel=1e-9)
    for name, value in law.outcome().items():
        assert result.outcome()[name] == pytest.approx(value, rel=1e-8), name
    # Energies of the pieces as well, and none is created.
    assert result.energy["strain"].max() == pytest.approx(law.energy["strain"].max(), rel=1e-8)
    assert result.energy_error < 1e-3


@pytest.mark.parametrize(
    ("new", "line", "message"),
    [
        (RIVLIN.replace("(I2-3)", "(I2-3"), 9, "at character 23"),
        (RIVLIN.replace("I1", "i1"), 9, "at character 6"),
        (RIVLIN.replace("(I2-3)", "(I2-1)"), 9, "zero at rest"),
        (RIVLIN.replace("c10", "poisson"), 9, "poisson is another key"),
        (RIVLIN.replace("c01", "c02"), 11, "unknown key 'c01'"),
        (RIVLIN + 'law = "ogden"\n', 10, "leave it out"),
        (RIVLIN.replace("c01*(I2-3)", "c10*(exp(c01*(I2-3))-1)"), 11, "c01"),
        (RIVLIN.replace("+ c01", "- 5*c01"), 9, "stiff at rest"),
        ("", None, "give a law"),
        ('energy = "c10*(I1-3) + c01*(I2-3) + c30*(I1-3)^3"\n', None, "give c30 as well"),
        ('energy = "1e-5*c10*(I1-3) + 1e-5*c01*(I2-3)"\n', 9, "shear modulus is"),
        ("energy = 4\n", 9, "text in quotes"),
    ],
)
def test_a_mistake_in_an_energy_is_named_with_its_line(tmp_path, new, line, message):
    with pytest.raises(FileError, match=re.escape(message)) as error:
        case(write_case(tmp_path, old=LAW, new=new))
    if line is not None:
        assert error.value.path.endswith("ball.toml")
        assert error.value.line == line


@pytest.mark.parametrize(
    ("energy", "stresses", "numbers"),
    [
        ("c10*(I1-3) + c20*(I1-3)^2 + c30*(I1-3)^3", {"c10", "c20", "c30"}, set()),
        ("mu/(2*b)*(exp(b*(I1-3)) - 1)", {"mu"}, {"b"}),
        ("-mu/2*limit*log(1 - (I1-3)/limit)", {"mu"}, {"limit"}),
        # In proportion to both, but a stress times a stress is none.
        ("c10*((I1-3) + ratio*(I2-3))", {"c10"}, {"ratio"}),
        ("G*sqrt(1 + a*(I1-3)) - G", {"G"}, {"a"}),
    ],
)
def test_the_stresses_among_the_constants_follow_from_the_energy(energy, stresses, numbers):
    dimensions = Energy.read(energy).dimensions
    assert {name for name, each in dimensions.items() if each == "pressure"} == stresses
    assert {name for name, each in dimensions.items() if each == "dimensionless"} == numbers
    # Either is refused with the unit of the other.
    for name in stresses:
        with pytest.raises(InputError):
            Energy.read(energy).constant_value(name, "3 mm")
        assert Energy.read(energy).constant_value(name, "3 MPa") == 3e6
    for name in numbers:
        with pytest.raises(InputError):
            Energy.read(energy).constant_value(name, "3 MPa")


def test_values_of_an_energy():
    # W and its derivatives in closed form; the derivative of an exponential has itself in it.
    energy, constants = Energy.read("mu/(2*b)*(exp(b*(I1-3)) - 1) + c01*(I2-3)"), {"mu": 1e7, "b": 0.4, "c01": 2e6}
    first, second = np.array([3.0, 3.5, 4.2]), np.array([3.0, 3.4, 5.0])
    growth = np.exp(0.4 * (first - 3.0))
    expected = [1e7 / 0.8 * (growth - 1.0) + 2e6 * (second - 3.0), 0.5e7 * growth, np.full(3, 2e6)]
    assert energy.values(constants, np.column_stack([first, second])) == pytest.approx(np.column_stack(expected))


def test_an_energy_that_softens_is_warned_of():
    with pytest.warns(ImplausibleWarning, match="at a stretch of"):
        rubber(c10="4 MPa", c20="-0.9 MPa")
    with pytest.warns(ImplausibleWarning, match="is not a number"):
        rubber("-mu/2*limit*log(1 - (I1-3)/limit)", mu="10 MPa", limit=0.7)


def test_moduli_and_their_slopes_follow_from_the_energy():
    made = rubber("c10*(I1-3) + c01*(I2-3) + c11*(I1-3)*(I2-3)", c10="4 MPa", c01="1 MPa", c11="9 MPa")
    assert made.shear == pytest.approx(10e6, rel=1e-14)
    assert made.bulk == pytest.approx(2.0 * 10e6 * 1.49 / (3.0 * 0.02), rel=1e-12)
    assert [made.shear_slope(name) for name in ("c10", "c01", "c11")] == [2.0, 2.0, 0.0]


def test_derivatives_by_the_constants_of_an_energy():
    ball = of_core(rubber())
    by = ("core.c10", "core.c20", "core.poisson", "speed")
    assert set(by) <= set(fem.variables("driver", ball=ball))
    shot = {"speed": 45.0, "loft": 0.2}
    result = fem.sensitivity("driver", ball=ball, by=by, friction=0.2, settings=SETTINGS, **shot)

    def launch(c20):
        varied = of_core(rubber(c10=4e6, c20=c20))
        return fem.strike("driver", ball=varied, friction=0.2, settings=SETTINGS, **shot).outcome()

    low, high = launch(0.3e6 * (1 - 1e-5)), launch(0.3e6 * (1 + 1e-5))
    for name in ("ball_speed", "launch", "backspin"):
        difference = (high[name] - low[name]) / 6.0
        # A node that touches a step sooner or later kinks what it changes: differences are no better than that.
        assert result.by(name, "core.c20") == pytest.approx(difference, rel=2e-4), name
        assert result.by(name, "core.c20") != 0.0


def test_an_energy_makes_no_keyword_deck(tmp_path):
    chosen = case(write_case(tmp_path, old=LAW, new=RIVLIN))
    with pytest.raises(InputError, match="LS-DYNA"):
        keyword.write(chosen, tmp_path / "deck.k")


def test_law_and_energy_exclude_each_other():
    with pytest.raises(InputError, match="leave it out"):
        Material(law="ogden", energy=YEOH, constants={"c10": 4e6, "c20": 1e5}, poisson=0.49)
    with pytest.raises(InputError, match="give a law"):
        Material(constants={"c10": 4e6}, poisson=0.49)
    with pytest.raises(InputError, match="c20"):
        rubber(c10=4e6)
    for energy in (["c10"], 4.0, "\ud800", "c10*(I1-3) + \x00"):
        with pytest.raises(InputError, match="energy"):
            Material(energy=energy, constants={"c10": 4e6}, poisson=0.49)
    with pytest.raises(InputError, match="c30"):
        rubber(c10=4e6, c20=1e5, c30=1e4)
