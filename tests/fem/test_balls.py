"""The balls of the catalogue: what published plate tests say of them, and by how much their spins differ."""

from functools import cache

import numpy as np
import pytest

import clubface
from clubface import fem
from clubface.errors import InputError
from clubface.fem.balls import node_masses

pytest.importorskip("scipy")

import ball_fit as study


@cache
def figures(name):
    return study.figures(fem.ball(name), study.targets())


@pytest.mark.parametrize(("target", "at"), [(each, at) for at, each in enumerate(study.targets())])
def test_modern_is_within_what_plate_tests_leave_open(target, at):
    # The fit, which has shots to meet as well, leaves its largest residual, 1.6, at the free head: 2 deviations.
    assert figures("modern")[at] == pytest.approx(target["value"], abs=2.0 * target["deviation"])


@pytest.mark.parametrize("name", ["modern", "distance"])
def test_both_balls_have_the_restitution_of_balls_sold_today(name):
    at = {(each["speed"], each["quantity"]): value for each, value in zip(study.targets(), figures(name), strict=True)}
    by_speed = {round(speed, 1): value for (speed, quantity), value in at.items() if quantity == "restitution"}
    # 125, 143 and 160 ft/s as the constants were fitted: in the third digit, which the mesh moves by some 0.001.
    assert [by_speed[speed] for speed in (38.1, 43.6, 48.8)] == pytest.approx([0.809, 0.797, 0.769], abs=0.002)


def test_the_contact_of_a_drive_is_as_deep_as_measured():
    result = fem.strike(study.HEAD, speed=48.8, settings=study.END)
    assert 6e-3 <= result.contraction * 0.5 * result.ball.diameter <= 10e-3


@pytest.mark.parametrize(
    ("club", "least", "most"),
    [
        # Ionomer against urethane covers, means over robot tests: 24 to 178 balls, none of whose figures made a ball.
        ("driver", -13.0, -4.0),
        ("7-iron", -8.0, -1.0),
        ("pitching-wedge", -25.0, 0.0),
    ],
)
def test_distance_spins_less_than_modern_as_published(club, least, most):
    spins = [
        clubface.impact(study.CLUBS[club], study.SHOTS[club], model="fem", ball=name).backspin
        for name in ("modern", "distance")
    ]
    assert least <= 100.0 * (spins[1] / spins[0] - 1.0) <= most


@pytest.mark.parametrize(
    ("model", "name"),
    [*((model, name) for model in ("standard", "volumetric") for name in fem.ball_names()), ("fem", "distance")],
)
@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
def test_every_ball_of_pieces_serves_every_model_by_name_and_as_an_object(model, name):
    launches = [clubface.impact("driver", speed=45.0, model=model, ball=each) for each in (name, fem.ball(name))]
    assert [launch.ball.name for launch in launches] == [name, name]
    # Reduced models take the inertia of round spheres, or that of the mesh: 0.08% apart.
    assert launches[0].backspin == pytest.approx(launches[1].backspin, rel=1e-3)


def test_the_friction_of_a_ball_applies_unless_another_is_given():
    shot = {"speed": 45.0, "loft": "30 deg", "model": "fem"}
    own = clubface.impact("7-iron", ball="distance", **shot)
    assert own.parameters.values["friction"] == fem.ball("distance").friction == 0.25
    assert "of the ball distance" in own.parameters.source
    same = clubface.impact("7-iron", ball="distance", parameters={"friction": 0.25}, **shot)
    other = clubface.impact("7-iron", ball="distance", parameters={"friction": 0.35}, **shot)
    assert own.backspin == same.backspin != other.backspin
    assert fem.throw("distance", speed=20.0, settings=study.END).friction == 0.25


def test_a_changed_ball_is_meshed_as_changed():
    light = clubface.ball("modern").replace(mass="44 g")
    assert fem.ball(light).properties()["mass"] == pytest.approx(44e-3, rel=1e-12)
    assert fem.ball(clubface.ball("modern")) == fem.ball("modern")


@pytest.mark.parametrize("ball", ["conforming", clubface.ball("conforming")])
def test_a_ball_without_pieces_is_refused_by_finite_elements(ball):
    with pytest.raises(InputError, match="distance, modern, modern-2026, paper, reference"):
        clubface.impact("driver", speed=45.0, model="fem", ball=ball)


def test_the_nodes_of_a_mesh_share_its_mass():
    made = fem.ball("reference")
    shares, properties = node_masses(made.mesh), made.properties()
    assert shares.sum() == pytest.approx(1.0, rel=1e-12)
    nodes = made.mesh["nodes"]
    # Of parallelepipeds in place of the elements: inertia to some per cent, and no moment about the centre.
    inertia = properties["mass"] * (shares @ (nodes[:, 0] ** 2 + nodes[:, 1] ** 2))
    assert inertia == pytest.approx(properties["inertia"], rel=0.03)
    assert abs(shares @ nodes).max() < 1e-9
    corners = nodes[made.mesh["elements"].astype(int)]
    volume = np.abs(np.einsum("ij,ij->i", np.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0]),
                              corners[:, 4] - corners[:, 0]))  # fmt: skip
    heaviest = int(np.argmax(shares))
    touching = (made.mesh["elements"].astype(int) == heaviest).any(axis=1)
    density = np.asarray(made.mesh["density"])[made.mesh["piece"]]
    # In the cube of the middle, elements are nearly parallelepipeds.
    expected = (volume * density)[touching].sum() / 8.0 / properties["mass"]
    assert shares[heaviest] == pytest.approx(expected, rel=0.1)
