"""Runs of finite elements that several tests look at, each computed once."""

from dataclasses import replace
from functools import cache

from clubface import fem
from clubface.fem.case import Case, case
from clubface.fem.heads.read import from_toml
from clubface.support.files import builtin_path


def coarse(name="reference"):
    """A ball of few elements, for tests of everything but physics."""
    made = fem.ball(name)
    return replace(made, cube=4, pieces=tuple(replace(piece, layers=1) for piece in made.pieces))


def of_core(material, **changes):
    """A coarse ball whose core is of a material."""
    ball = coarse()
    core, *around = ball.pieces
    return replace(ball, pieces=(replace(core, material=replace(material, density=None)), *around), **changes)


def throw_case(**settings):
    """Roh and Lee's ball, coarse, thrown at a plane as in the reference case."""
    return Case(
        name="throw",
        ball=coarse(),
        head="plane",
        delivery={"speed": "35 m/s", "angle": "11.5 deg"},
        settings=fem.Settings(**settings),
    )


def drive_case(**settings):
    """Roh and Lee's case with a rigid head and a coarse ball."""
    return case("paper-rigid").replace(ball=coarse("paper"), settings=settings)


@cache
def coarse_head():
    """Roh and Lee's head of few shells."""
    return fem.head(replace(from_toml(builtin_path("head", "paper", "fem_heads")), elements=(14, 8, 10)))


def shells_case(**settings):
    """Roh and Lee's case with a coarse head of shells and a coarse ball."""
    return case("paper").replace(ball=coarse("paper"), club=coarse_head(), settings=settings)


@cache
def coarse_shells():
    return shells_case(frames=5).run()


@cache
def reference():
    return fem.reference()


@cache
def coarse_throw():
    return throw_case(frames=5).run()


@cache
def coarse_drive():
    return drive_case(frames=5).run()


TOML = """\
name = "mine"
ball = "./ball.toml"
friction = 0.3

[head]
kind = "plane"

[delivery]
speed = "35 m/s"
angle = "11.5 deg"

[run]
duration = "{duration} us"
"""

BALL = """\
name = "soft"
diameter = "42.8 mm"
mass = "46 g"
cube = 4

[[pieces]]
name = "core"
layers = 1
law = "mooney-rivlin"
c10 = "4 MPa"
c01 = "1 MPa"
poisson = 0.49

[[pieces]]
name = "cover"
layers = 1
thickness = "1.8 mm"
law = "linear"
youngs = "350 MPa"
poisson = 0.40
density = "950 kg/m3"
"""


def write_case(folder, duration=100, old="", new=""):
    """Write a case with a coarse ball, one line of ball or case changed; return its path."""
    (folder / "ball.toml").write_text(BALL.replace(old, new) if old in BALL else BALL)
    path = folder / "case.toml"
    path.write_text(TOML.format(duration=duration).replace(old, new))
    return path
