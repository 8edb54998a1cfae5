"""Exact derivatives against differences, and the units they are told in."""

import math

import numpy as np
import pytest

import clubface
from clubface.equipment.models import models
from clubface.errors import ClubfaceError, InputError, ShotError, UnitError, UnknownNameError
from clubface.simulation.results import inputs

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

DRIVE = {"speed": "113 mph", "attack": "-1.3 deg", "loft": "12.8 deg", "toe": "6 mm", "high": "3 mm", "face": "1 deg"}
MAIN = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")

STEPS = {"speed": 1e-3, "attack": 1e-4, "loft": 1e-4, "face": 1e-4, "toe": 1e-5, "club_mass": 1e-4, "cg_x": 1e-5,
         "izz": 1e-8, "ball_mass": 1e-5}  # fmt: skip
"""SI; small enough for the error of a central difference, a few 1e-8 here, not to show."""


@pytest.mark.parametrize("model", [name for name, each in models().items() if each.kind == "impulse"])
def test_the_derivatives_of_impulse_models_are_those_of_central_differences(model):
    """Closed forms: a difference is wrong by step^2 and by rounding / step, together below 1e-5 of its size."""
    table = clubface.sensitivity("driver", **DRIVE, model=model, outputs=MAIN)
    compare(table, model, None, 1e-5)


@pytest.mark.parametrize("model", ["volumetric", "area"])
def test_the_derivatives_of_contact_models_are_those_of_central_differences(model):
    """Steps of tolerance 1e-10: launches repeat to some 1e-9, differences over 1e-4 of a value to some 1e-4."""
    table = clubface.sensitivity("driver", **DRIVE, model=model, outputs=MAIN, accuracy=1e-10)
    compare(table, model, 1e-10, 1e-3)


def compare(table, model, accuracy, tolerance):
    """Hold every derivative against a central difference, within ``tolerance`` of the largest effect of its row."""
    centre = {name: table.launch.input(name) for name in STEPS}
    scale = np.max(np.abs(table.si * [abs(STEPS.get(name, 0.0)) for name in table.variables]), axis=1)
    for name, step in STEPS.items():
        sides = [
            clubface.impact("driver", {**DRIVE, name: centre[name] + sign * step}, model=model, accuracy=accuracy)
            for sign in (1.0, -1.0)
        ]
        for row, output in enumerate(MAIN):
            difference = (sides[0].get(output) - sides[1].get(output)) / 2.0
            exact = table.value(output, name) * step
            assert abs(difference - exact) <= tolerance * scale[row], (output, name)


def test_derivatives_by_parameters_are_those_of_differences():
    table = clubface.sensitivity("driver", **DRIVE, model="standard", outputs=["ball_speed"], variables=["cor"])
    low, high = (
        clubface.impact("driver", **DRIVE, model="standard", parameters={"cor": cor}).ball_speed
        for cor in (0.829, 0.831)
    )
    # Ball speed is not quite linear in the COR off centre: second order in 1e-3.
    assert table.value("ball_speed", "cor") == pytest.approx((high - low) / 0.002, rel=1e-6)


def test_every_differentiable_input_and_every_parameter_is_there():
    table = clubface.sensitivity("driver", **DRIVE, model="volumetric")
    differentiable = [name for name, each in inputs().items() if each.differentiable and each.group != "attachment"]
    assert list(table.variables) == differentiable + [each.name for each in models()["volumetric"].parameters]
    assert not {"hand", "face_width", "face_height"} & set(table.variables)
    assert table.si.shape == (len(table.outputs), len(table.variables))
    assert np.isfinite(table.si).all()
    assert "contact_time" in table.outputs
    assert "contact_time" not in clubface.sensitivity("driver", **DRIVE, model="standard").outputs


def test_inertia_that_is_added_is_there_for_an_attached_head_and_by_name():
    added = [name for name, each in inputs().items() if each.group == "attachment"]
    attached = clubface.sensitivity(clubface.club("driver").on_shaft("graphite"), **DRIVE)
    assert set(added) <= set(attached.variables)
    free = clubface.sensitivity("driver", **DRIVE, variables=["added_mass_xx", "club_mass"])
    # A mass that moves with the head in every direction.
    along = [
        clubface.sensitivity("driver", **DRIVE, variables=[f"added_mass_{axis}"]).si for axis in ("xx", "yy", "zz")
    ]
    speed = free.outputs.index("ball_speed")
    assert sum(along)[speed] == pytest.approx(free.si[speed, 1], rel=1e-6)
    assert "added_mass_xx" in clubface.sensitivity("driver", **DRIVE, added_mass_xx=0.01).variables


def test_derivatives_are_shown_in_the_units_people_use():
    table = clubface.sensitivity("driver", **DRIVE)
    assert table.unit("backspin", "toe") == "rpm per mm"
    assert table.unit("ball_speed", "speed") == "mph per mph"
    assert table.unit("backspin", "loft") == "rpm per deg"
    si = table.value("backspin", "toe")
    assert table.value("backspin", "toe", "rpm per mm") == pytest.approx(si * 30.0 / math.pi / 1e3, rel=1e-14)
    row, column = table.outputs.index("backspin"), table.variables.index("toe")
    assert table.values[row, column] == pytest.approx(table.value("backspin", "toe", "rpm per mm"), rel=1e-14)
    frame = pytest.importorskip("pandas") and table.to_pandas()
    assert frame.loc["toe [mm]", "backspin [rpm]"] == table.values[row, column]
    assert frame.attrs["units"]["toe"] == "mm"
    assert "per mm of toe" in repr(table)
    assert float(table.to_xarray().sel(output="backspin", variable="toe")) == si


def test_units_outputs_and_variables_can_be_chosen():
    table = clubface.sensitivity(
        "driver", **DRIVE, outputs=["backspin", "ball_speed"], variables=["toe", "friction"],
        units={"toe": "in", "ball_speed": "km/h"},
    )  # fmt: skip
    assert (table.outputs, table.variables) == (("backspin", "ball_speed"), ("toe", "friction"))
    assert table.unit("ball_speed", "toe") == "km/h per in"
    full = clubface.sensitivity("driver", **DRIVE)
    assert table.value("ball_speed", "toe") == full.value("ball_speed", "toe")


@pytest.mark.parametrize(
    ("values", "error", "message"),
    [
        ({"speed": [50.0, 51.0], "toe": [0.0, 0.06]}, ShotError, "60.0 mm"),
        ({"speed": 50.0, "toe": 0.06}, ShotError, "52.5 mm"),
        ({"speed": 50.0, "outputs": ["spin"]}, UnknownNameError, "did you mean"),
        ({"speed": 50.0, "variables": ["hand"]}, UnknownNameError, "variable"),
        ({"speed": 50.0, "variables": ["toe", "toe"]}, InputError, "without repeats"),
        ({"speed": 50.0, "units": {"toe": "mph"}}, UnitError, "toe"),
        ({"speed": 50.0, "units": {"tow": "mm"}}, UnknownNameError, "toe"),
    ],
)
def test_errors_of_users_name_the_value(values, error, message):
    with pytest.raises(error, match=message.replace(".", r"\.")):
        clubface.sensitivity("driver", **values)


BATCH = {"speed": np.array([47.0, 49.0, 51.0]), "loft": np.array([[0.2], [0.24]]), "toe": 4e-3, "high": -2e-3}
"""Shots of shape (2, 3), in SI."""


@pytest.mark.parametrize("model", ["slip", "volumetric", "response"])
def test_a_batch_of_derivatives_is_the_loop_over_its_shots_bit_for_bit(model):
    table = clubface.sensitivity("driver", BATCH, model=model, outputs=MAIN)
    assert table.si.shape == (len(MAIN), len(table.variables), 2, 3)
    for row, column in np.ndindex(2, 3):
        shot = {**BATCH, "speed": float(BATCH["speed"][column]), "loft": float(BATCH["loft"][row, 0])}
        one = clubface.sensitivity("driver", shot, model=model, outputs=MAIN)
        assert one.variables == table.variables
        assert np.array_equal(one.si, table.si[:, :, row, column])
        assert np.array_equal(one.values, table.values[:, :, row, column])


def test_a_batch_of_derivatives_is_that_of_central_differences():
    table = clubface.sensitivity("driver", BATCH, model="slip", outputs=MAIN, variables=["speed", "loft", "toe"])
    for name, step in (("speed", 1e-3), ("loft", 1e-4), ("toe", 1e-5)):
        high, low = (
            clubface.impact("driver", {**BATCH, name: BATCH[name] + sign * step}, model="slip") for sign in (1.0, -1.0)
        )
        for output in MAIN:
            difference = (high.get(output) - low.get(output)) / (2.0 * step)
            scale = np.abs(difference).max() + 1e-3
            # Second order in the step, and rounding over it: below 1e-5, as for single shots.
            assert table.value(output, name) == pytest.approx(difference, rel=1e-5, abs=1e-5 * scale), (output, name)


def test_derivatives_by_arrays_of_parameters_and_of_shots_that_cannot_be_computed():
    frictions = np.array([0.3, 0.35])
    table = clubface.sensitivity(
        "driver", speed=50.0, parameters={"friction": frictions}, outputs="backspin", variables="friction"
    )
    one = clubface.sensitivity(
        "driver", speed=50.0, parameters={"friction": 0.35}, outputs="backspin", variables="friction"
    )
    assert table.value("backspin", "friction")[1] == one.value("backspin", "friction")
    part = clubface.sensitivity("driver", speed=50.0, toe=[0.0, 0.2], model="slip", outputs=MAIN, on_error="nan")
    assert np.isfinite(part.si[..., 0]).all()
    assert np.isnan(part.si[..., 1]).all()
    (problem,) = part.launch.problems
    assert (problem.row, problem.parameter) == ((1,), "toe")


def test_a_batch_of_derivatives_has_its_shots_as_dimensions():
    table = clubface.sensitivity("driver", BATCH, model="slip", outputs=["backspin"], variables=["toe", "cor"])
    array = pytest.importorskip("xarray") and table.to_xarray()
    assert array.dims == ("output", "variable", "loft", "speed")
    assert float(array.sel(output="backspin", variable="toe", speed=49.0)[1]) == table.si[0, 0, 1, 1]
    rows = table.to_result().to_dict()["tables"]["derivatives"]["rows"]
    assert len(rows) == 2 * 2 * 3
    assert {"dim_0": 1, "dim_1": 2, "output": "backspin", "variable": "toe"}.items() <= rows[-2].items()
    assert rows[-2]["value"] == table.values[0, 0, 1, 2]
    assert "shape (2, 3)" in repr(table)


def test_a_derivative_is_asked_for_by_its_names_and_unit():
    table = clubface.sensitivity("driver", **DRIVE)
    with pytest.raises(UnitError, match="rpm per mm"):
        table.value("backspin", "toe", "rpm/mm")
    with pytest.raises(UnitError, match="toe"):
        table.value("backspin", "toe", "rpm per deg")
    with pytest.raises(UnknownNameError, match="did you mean"):
        table.value("backspin", "tow")


def test_a_flat_face_does_not_depend_on_how_flat_it_is():
    table = clubface.sensitivity("7-iron", speed=40.0, outputs=MAIN, variables=["bulge", "roll"])
    assert np.all(table.si == 0.0)


EXPLAINED = {
    "friction-lowers-spin": ({}, "friction", 0.1),
    "high-strike-lowers-spin": ({}, "high", 1e-3),
    "attack-at-held-loft": ({}, "attack", math.radians(1.0)),
}
"""Notes whose data are the loss of backspin over a step of an input."""


@pytest.mark.parametrize("code", EXPLAINED)
def test_a_sign_that_surprises_is_explained_with_the_loss_that_two_launches_have(code):
    _, name, step = EXPLAINED[code]
    table = clubface.sensitivity("driver", **DRIVE, model="response")
    (result,) = [each for each in table.to_result().notes if each.code == code]

    def spin(value):
        given = {"parameters": {"friction": value}} if name == "friction" else {name: value}
        return clubface.impact("driver", **{**DRIVE, **given}, model="response").backspin

    centre = 0.35 if name == "friction" else table.launch.input(name)
    lost = spin(centre - 0.05 * step) - spin(centre + 0.05 * step)
    assert lost > 0.0
    # A tenth of the step, over which the curvature does not show.
    assert result.data["backspin"] == pytest.approx(10.0 * lost, rel=2e-3)


def test_signs_are_explained_only_where_they_are_so():
    def codes(club, **shot):
        return {each.code for each in clubface.sensitivity(club, **shot).to_result().notes}

    grips, slides = {"speed": "100 mph", "loft": "12 deg"}, {"speed": "80 mph", "loft": "62 deg"}
    assert "friction-lowers-spin" in codes("driver", **grips)
    # A ball that slides throughout gains spin from friction.
    assert "friction-lowers-spin" not in codes("lob-wedge", **slides)
    assert "toe-strike-curves-back" in codes("driver", **grips)
    left = codes("driver", hand="left", **grips)
    assert "toe-strike-curves-back" in left


def test_every_printed_derivative_names_its_step():
    result = clubface.sensitivity("driver", **DRIVE, model="slip").to_result().table()
    assert all(", per " in each for each in result["per"].values)


def test_products_with_vectors_are_those_of_the_whole_table():
    toe = np.array([-0.01, 0.0, 0.012])
    table = clubface.sensitivity("driver", speed=48.0, loft="12 deg", toe=toe, variables=["loft", "toe", "friction"])
    change = table.jvp({"loft": "1 deg", "toe": [1e-3, 2e-3, 0.0]})
    assert list(change) == list(table.outputs)
    row = table.outputs.index("backspin")
    expected = table.si[row, 0] * math.radians(1.0) + table.si[row, 1] * np.array([1e-3, 2e-3, 0.0])
    assert change["backspin"] == pytest.approx(expected)
    weighed = table.vjp({"backspin": 2.0, "ball_speed": [1.0, 0.0, -1.0]})
    assert list(weighed) == ["loft", "toe", "friction"]
    # <u, J v> is <u J, v>, shot by shot.
    v = {"loft": 0.3, "toe": -0.2, "friction": 0.7}
    one = 2.0 * table.jvp(v)["backspin"] + np.array([1.0, 0.0, -1.0]) * table.jvp(v)["ball_speed"]
    assert one == pytest.approx(sum(weighed[name] * value for name, value in v.items()))
    alone = clubface.sensitivity("driver", speed=48.0, variables=["loft"])
    assert isinstance(alone.jvp({"loft": "1 deg"})["backspin"], float)
    assert alone.jvp({})["backspin"] == 0.0
    for wrong in (
        lambda: alone.jvp({"lift": 1.0}),
        lambda: alone.jvp({"loft": "1 m"}),
        lambda: alone.vjp({"carry": 1.0}),
    ):
        with pytest.raises(ClubfaceError):
            wrong()
