"""Derivatives of finite element launches against differences of whole runs."""

from dataclasses import replace

import pytest

from clubface import club, fem
from clubface.errors import InputError, ShotError, UnknownNameError
from fem_runs import coarse, coarse_head

SETTINGS = fem.Settings(until_separation=True)
BALL = coarse("modern")
SOFT = coarse("modern-2026")
"""Its branches stiffen it less, so that a hard drive turns elements inside out with the longest steps."""
OUTPUTS = ("ball_speed", "launch", "backspin")


def launch(club="driver", ball=BALL, **values):
    friction = values.pop("friction", 0.2)
    given = {"speed": 45.0, "loft": 0.2, **values}
    return fem.strike(club, ball=ball, friction=friction, settings=SETTINGS, **given).outcome()


def differences(run, at, step):
    """Central differences of a run, by the launch quantities."""
    low, high = run(at - step), run(at + step)
    return {name: (high[name] - low[name]) / (2.0 * step) for name in OUTPUTS}


def check(result, name, expected):
    for output in OUTPUTS:
        # A node that touches a step sooner or later kinks what it changes: differences are no better than that.
        assert result.by(output, name) == pytest.approx(expected[output], rel=2e-4, abs=1e-9), (name, output)


def test_derivatives_with_a_rigid_head():
    names, values = ("speed", "loft", "friction", "characteristic_time"), (45.0, 0.2, 0.2, 250e-6)
    result = fem.sensitivity("driver", speed=45.0, loft=0.2, by=names, ball=BALL, friction=0.2, settings=SETTINGS)
    for name, at in zip(names, values, strict=True):
        check(result, name, differences(lambda value, name=name: launch(**{name: value}), at, 1e-6 * at))


def test_derivatives_by_thickness_and_modulus_of_a_face():
    head = coarse_head()
    names = ("head.face.thickness", "head.face.youngs", "friction")
    result = fem.sensitivity(head, speed=45.0, loft=0.2, by=names, ball=BALL, friction=0.2, settings=SETTINGS)
    count = head.parts[0].elements
    mean = float(head.thickness[:count].mean())

    def walls(value):
        thickness = head.thickness.copy()
        thickness[:count] *= value / mean
        # The derivative leaves the delivered club alone: its CG is that of the head as designed.
        return launch(changed(thickness=thickness))

    def metal(value):
        first, *rest = head.parts
        return launch(changed(parts=(replace(first, metal=replace(first.metal, youngs=value)), *rest)))

    def changed(**values):
        other = replace(head, **values)
        other.__dict__["club"] = head.club
        return other

    check(result, names[0], differences(walls, mean, 1e-6 * mean))
    check(result, names[1], differences(metal, head.parts[0].metal.youngs, 1e5))
    check(result, names[2], differences(lambda value: launch(head, friction=value), 0.2, 2e-7))
    # A thicker face gives less, so the ball leaves slower.
    assert result.by("ball_speed", names[0]) < 0.0


@pytest.mark.parametrize(("name", "piece"), [("reference", 0), ("reference", 1), ("ogden", 0)])
def test_derivatives_by_the_constants_in_the_file_of_a_ball(name, piece):
    made = coarse("reference")
    if name == "ogden":
        rubber = replace(made.pieces[0].material, law="ogden", constants={"mu1": 4e6, "alpha1": 3.0})
        made = replace(made, pieces=(replace(made.pieces[0], material=rubber), *made.pieces[1:]))
    material = made.pieces[piece].material
    names = (*material.constants, "poisson")
    by = [f"{made.pieces[piece].name}.{each}" for each in names]
    result = fem.sensitivity("driver", speed=45.0, loft=0.2, by=by, ball=made, friction=0.2, settings=SETTINGS)

    def changed(key, value):
        values = {key: value} if key == "poisson" else {"constants": {**material.constants, key: value}}
        pieces = list(made.pieces)
        pieces[piece] = replace(pieces[piece], material=replace(material, **values))
        return launch(ball=replace(made, pieces=tuple(pieces)))

    for key, full in zip(names, by, strict=True):
        at = getattr(material, key) if key == "poisson" else material.constants[key]
        # Steps so short that the time step, which has 64 values in a factor of two, stays.
        check(result, full, differences(lambda value, key=key: changed(key, value), at, 1e-6 * at))


def test_derivatives_by_the_size_of_a_piece():
    """Where the shapes of elements are variables too, whatever else is differentiated by stays as it is."""
    result = fem.sensitivity(
        "driver", speed=45.0, loft=0.2, by=("speed", "core.radius"), ball=BALL, friction=0.2, settings=SETTINGS
    )
    alone = fem.sensitivity("driver", speed=45.0, loft=0.2, by="speed", ball=BALL, friction=0.2, settings=SETTINGS)
    for output in OUTPUTS:
        # The same operations in another order, some fused.
        assert result.by(output, "speed") == pytest.approx(alone.by(output, "speed"), rel=1e-8, abs=1e-12)

    core, cover = BALL.pieces

    def with_core(radius):
        outer = BALL.diameter / 2.0
        return launch(ball=replace(BALL, pieces=(core, replace(cover, thickness=outer - radius))))

    at = BALL.diameter / 2.0 - cover.thickness
    check(result, "core.radius", differences(with_core, at, 1e-6 * at))


def test_four_variables_take_one_run_whatever_they_change():
    runs = set()

    def watch(done, count):
        runs.add(count)

    names = ("core.c10", "core.poisson", "cover.shear", "speed")
    result = fem.sensitivity(
        "driver", speed=45.0, loft=0.2, by=names, ball=BALL, friction=0.2, settings=SETTINGS, progress=watch
    )
    assert runs == {1}
    # One at a time they are the same.
    for name in names:
        alone = fem.sensitivity("driver", speed=45.0, loft=0.2, by=name, ball=BALL, friction=0.2, settings=SETTINGS)
        for output in OUTPUTS:
            assert result.by(output, name) == pytest.approx(alone.by(output, name), rel=1e-12), (name, output)


def test_a_hard_drive_takes_the_shorter_steps_of_its_run():
    setup = {"speed": 100.0, "loft": 0.2, "ball": SOFT, "friction": 0.2, "settings": SETTINGS}
    rigid = club("driver").replace(characteristic_time=0.0)
    run = fem.strike(rigid, **setup)
    assert run.settings.safety < fem.strike(rigid, **setup | {"speed": 45.0}).settings.safety
    result = fem.sensitivity(rigid, by="speed", **setup)
    # The same operations, but on numbers with derivatives.
    assert result.values["ball_speed"] == pytest.approx(run.launch.ball_speed, rel=1e-9)
    with pytest.raises(ShotError, match="choose a smaller `safety`"):
        fem.sensitivity(rigid, by="speed", **setup | {"settings": replace(SETTINGS, safety=0.9)})


def test_a_solid_head_is_refused():
    with pytest.raises(InputError, match="shell head"):
        fem.variables(fem.head("7-iron"))


def test_an_unknown_variable_is_named():
    assert {"speed", "friction", "core.radius"} <= set(fem.variables("driver", ball=BALL))
    known = fem.variables(coarse_head(), ball=BALL)
    assert "head.crown.thickness" in known
    assert "club_mass" not in known
    with pytest.raises(UnknownNameError, match=r"head\.face\.thickness"):
        fem.sensitivity(coarse_head(), speed=45.0, by="head.face.thicknes", ball=BALL)
