"""Energies of the change of volume as formulas: the common one written so, others, and what is refused and where."""

import re

import numpy as np
import pytest

from clubface import _core as core, fem
from clubface.errors import FileError, InputError
from clubface.fem import keyword
from clubface.fem.case import case
from clubface.fem.materials import Material, Maxwell
from fem_runs import drive_case, of_core, write_case

OLD = "poisson = 0.49\n"
COMMON = "bulk/2*(J - 1)^2"
SIMO_TAYLOR = "bulk/4*(J^2 - 1 - 2*log(J))"
LOGARITHMIC = "bulk/2*log(J)^2"
RIVLIN = {"c10": "4 MPa", "c01": "1 MPa"}


def rubber(volumetric, poisson=0.45, law="mooney-rivlin", constants=RIVLIN, **more):
    return Material(law=law, constants=constants, poisson=poisson, volumetric=volumetric, **more)


@pytest.mark.parametrize("element", ["one-point", "full"])
def test_the_common_energy_as_a_formula_is_the_common_energy(tmp_path, element):
    runs = []
    for new in (OLD, OLD + f'volumetric = "{COMMON}"\n'):
        path = write_case(tmp_path, duration=600, old=OLD, new=new)
        ball = tmp_path / "ball.toml"
        ball.write_text(ball.read_text().replace("[[pieces]]", f'element = "{element}"\n\n[[pieces]]', 1))
        runs.append(case(path).run())
    common, written = runs
    assert written.ball.pieces[0].material.volumetric == COMMON
    # Rounding, grown over a thousand steps of contact.
    assert written.peak_force == pytest.approx(common.peak_force, rel=1e-11)
    for name, value in common.outcome().items():
        assert written.outcome()[name] == pytest.approx(value, rel=1e-11), name
    assert written.energy["strain"] == pytest.approx(common.energy["strain"], rel=1e-11, abs=1e-9)


@pytest.mark.parametrize("element", ["one-point", "full"])
@pytest.mark.parametrize("energy", [SIMO_TAYLOR, LOGARITHMIC, "bulk/81*(9*log(J) + J^-9 - 1)"])
def test_energy_is_kept_and_the_change_of_volume_is_another(energy, element):
    # Volumes change by a tenth: what the formula adds to the energy is many times the error of the balance.
    runs = [
        drive_case().replace(ball=of_core(rubber(each, 0.3, maxwell=(Maxwell(0.4, 80e-6),)), element=element)).run()
        for each in (None, energy)
    ]
    common, other = runs
    assert other.energy_error < 1.2 * common.energy_error
    assert 1e-5 < abs(other.peak_force / common.peak_force - 1.0) < 0.05


def test_values_of_energies():
    ratios = np.array([0.8, 1.0, 1.1])
    energy, slope, curvature = np.array(core.fem_volumetric(SIMO_TAYLOR, 3.0, ratios.tolist())).T
    assert energy == pytest.approx(0.75 * (ratios**2 - 1.0 - 2.0 * np.log(ratios)))
    assert slope == pytest.approx(1.5 * (ratios - 1.0 / ratios))
    assert curvature == pytest.approx(1.5 * (1.0 + ratios**-2))


def test_derivatives_by_poisson_go_through_the_energy():
    by, step = "core.poisson", 1e-4
    at = {poisson: of_core(rubber(LOGARITHMIC, poisson)) for poisson in (0.45 - step, 0.45, 0.45 + step)}
    less, middle, more = (fem.sensitivity("driver", speed="100 mph", ball=ball, by=[by]) for ball in at.values())
    difference = (more.values["ball_speed"] - less.values["ball_speed"]) / (2.0 * step)
    assert middle.by("ball_speed", by) == pytest.approx(difference, rel=1e-3)


@pytest.mark.parametrize(
    ("energy", "message"),
    [
        ("bulk/2*(J - 1", 'at character 14, ")" is missing'),
        ("K/2*(J - 1)^2", '"K" is unknown'),
        ("bulk/2*(I1 - 3)", '"I1" is unknown'),
        ("bulk*(J - 1)^2", "with a bulk modulus of 2.000000 bulk"),
        ("bulk/2*J^2", "which is 0.500000 bulk at rest"),
        ("bulk/2*(J - 1)^2 + bulk*(J - 1)", "0.000000 bulk at rest with a pres"),
        ("1/2*(J - 1)^2", "in proportion to bulk"),
        ("bulk/2*(J - 1)^2 - bulk*5*(J - 1)^4", "loses its stiffness where J is"),
        ("bulk*log(J - 1)", "finite at rest"),
        ("", "at character 1"),
    ],
)
def test_a_mistake_in_an_energy_is_named_with_its_line(tmp_path, energy, message):
    with pytest.raises(FileError, match=re.escape(message)) as error:
        case(write_case(tmp_path, old=OLD, new=OLD + f'volumetric = "{energy}"\n'))
    assert error.value.line == 13


def test_an_energy_without_text_or_card_is_refused(tmp_path):
    with pytest.raises(InputError, match="volumetric"):
        rubber(3.0)
    written = case(write_case(tmp_path, old=OLD, new=OLD + f'volumetric = "{SIMO_TAYLOR}"\n'))
    with pytest.raises(InputError, match="volumetric"):
        keyword.write(written, tmp_path / "deck.k")
