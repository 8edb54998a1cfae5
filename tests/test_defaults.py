"""Defaults, entered a second time: whoever leaves a value out relies on them, and a slip of the pen changes results.

They are what the pages and docstrings tell. A default that is meant to change is changed here and in the change log.
"""

import dataclasses
import importlib
import inspect
import math

import pytest

DEG, MM = math.pi / 180.0, 1e-3

DEFAULTS = {
    "design.best_loft:best_loft": {"attack": 0.0},
    "design.comparison:compare": {"split": True},
    "design.dispersion:dispersion": {"count": 16_384, "seed": 0, "flight": True},
    "design.variance:ByDerivatives.variance": {"order": 2},
    "design.variance:ByDerivatives.spread": {"order": 2},
    "design.variance:indices": {"count": 1024, "seed": 0},
    "design.golfer:Golfer": {"hand": 1, "mishit_share": 0.0, "mishit_scale": 1.0},
    "design.optimisation.fitting:Fitting": {"shots": 10_000, "seed": 1},
    "design.optimisation.study:DesignStudy": {
        "distributed": False, "conform": True, "tolerance": True, "shots": 10_000, "seed": 1, "starts": 8, "points": 9,
    },
    "design.optimisation.run:optimise": {"resume": False},
    "equipment.clubs:Club": {"hand": 1},
    "equipment.parameters:ParameterSet": {"default": False, "includes_face": True},
    "inference.evaluation.evaluation:evaluate": {"resamples": 2000, "seed": 0},
    "fem.balls:Ball": {"friction": 0.35, "cube": 12},
    "fem.head_tests:restitution": {"threads": 0},
    "fem.head_tests:characteristic_time": {"toe": 0.0, "high": 0.0, "threads": 0},
    "fem.heads.driver:DriverHead": {"scales": (0.5, 2.0), "elements": (36, 12, 25)},
    "fem.heads.iron:IronHead": {"elements": (40, 24, 2)},
    "fem.heads.metal:Hardening": {"modulus": 0.0, "gain": 0.0, "rate": 0.0},
    # Ti-6Al-4V as data sheets have it: 114 GPa, 0.34, 4430 kg/m3.
    "fem.heads.metal:Metal": {"youngs": 114e9, "poisson": 0.34, "density": 4430.0},
    "fem.heads.user_mesh:MeshHead": {"face_centre": (0.0, 0.0, 0.0)},
    "fem.paper:reference": {"friction": 0.35, "refine": 1},
    "fem.settings:Settings": {
        "duration": 1e-3, "interval": 5e-6, "until_separation": False, "bulk_viscosity": 0.0, "frames": 0,
        "fields": False, "threads": 0,
    },
    "inference.identification.run:identify": {
        "population": 200, "generations": 100, "refined": 5, "folds": 5, "bootstrap": 200, "confidence": 0.95,
        "seed": 1, "resume": False,
    },
    "inference.identification.search:search": {"population": 200, "generations": 100, "seed": 1},
    "inference.posterior:Posterior.interval": {"confidence": 0.95},
    "inference.run:infer": {"samples": 2000, "seed": 0},
    "inference.file:infer_shots": {"resume": False},
    "capture.captured:CapturedDelivery.interval": {"level": 0.95},
    "capture.captured:CapturedDelivery.sample": {"seed": 0},
    "capture.geometry:Assumed": {
        "face": 2 * DEG, "loft": 2 * DEG, "lie": 2 * DEG, "delivered_loft": 6 * DEG, "delivered_face": 4 * DEG,
        "delivered_lie": 3 * DEG, "blow": 2 * DEG, "sole": 5 * MM, "toe": 12 * MM, "high": 10 * MM,
    },
    "capture.markers:Markers": {"ball_offset": (0.0, 0.0, 0.0)},
    "capture.recording:Recording": {"first_frame": 1},
    "capture.swing:CapturedSwings": {"interrupted": False},
    "capture.synthetic.laboratory:synthesize": {"count": 10, "seed": 1},
    "capture.synthetic.laboratory:synthesize_bare": {"count": 10, "seed": 1},
    "capture.synthetic.laboratory:Cameras": {
        "origin": (0.35, -0.2, 0.01), "rate": 720.0, "noise": 0.0, "before": 0.25, "after": 0.03, "gaps": 0.0,
        "gap": 4.0, "calibration_frames": 200,
    },
    "shots.prediction:predict": {"carry": True, "chunk_rows": 16_384, "resume": False},
    "simulation.inputs:Delivery": dict.fromkeys(
        (
            "attack", "path", "face", "lie", "toe", "high", "closure", "pitch_rate", "lie_rate", "ball_backspin",
            "ball_sidespin", "ball_riflespin",
        ),
        0.0,
    ),
    "studies.running:status": {"check": False},
    "units:show": {"digits": 6},
    "cli.fem:reference": {"friction": 0.35},
    "cli.capture:read": {"roughness": 0.6},
    "cli.capture:study": {"count": 200, "rate": 720.0, "gaps": 0.0, "seed": 1, "roughness": 0.6},
    "cli.identify:identify": {
        "population": 200, "generations": 100, "refined": 5, "folds": 5, "bootstrap": 200, "profiles": True,
        "confidence": 0.95, "seed": 1, "resume": False,
    },
    # The port that the Open Connect interface is published with.
    "cli.monitor:listen": {"port": 921},
    "cli.monitor:send": {"port": 921},
}  # fmt: skip

SAME = {
    "cli.evaluate:evaluate": "inference.evaluation.evaluation:evaluate",
    "cli.identify:identify": "inference.identification.run:identify",
    "cli.infer:infer": "inference.file:infer_shots",
    "cli.dispersion:dispersion": "design.dispersion:dispersion",
    "cli.compare:compare": "design.comparison:compare",
    "cli.predict:predict": "shots.prediction:predict",
    "cli.capture:synthesize": "capture.synthetic.laboratory:synthesize",
    "cli.fem:reference": "fem.paper:reference",
    "cli.optimise:optimise": "design.optimisation.run:optimise",
}
"""Commands and the functions they stand for."""


def found(name):
    module, _, path = name.partition(":")
    thing = importlib.import_module(f"clubface.{module}")
    for part in path.split("."):
        thing = getattr(thing, part)
    return thing


def numbers(thing):
    """Return the defaults of a function or class that are numbers, yes or no, or tuples of them."""
    if dataclasses.is_dataclass(thing):
        given = {each.name: each.default for each in dataclasses.fields(thing) if each.init}
    else:
        given = {name: each.default for name, each in inspect.signature(thing).parameters.items()}
    return {
        name: value
        for name, value in given.items()
        if isinstance(value, int | float)
        or (isinstance(value, tuple) and value and all(isinstance(each, int | float) for each in value))
    }


@pytest.mark.parametrize("name", DEFAULTS)
def test_a_default_is_what_the_pages_tell(name):
    has = numbers(found(name))
    if not name.startswith("cli."):  # commands also have flags, see below
        assert set(has) == set(DEFAULTS[name])
    for key, value in DEFAULTS[name].items():
        assert has[key] == pytest.approx(value, rel=1e-15), key
        assert isinstance(has[key], bool) == isinstance(value, bool), key


@pytest.mark.parametrize("command", SAME)
def test_a_command_and_its_function_have_the_same_defaults(command):
    ours, theirs = numbers(found(command)), numbers(found(SAME[command]))
    assert {key: ours[key] for key in ours.keys() & theirs.keys()} == {
        key: theirs[key] for key in ours.keys() & theirs.keys()
    }
    assert ours.keys() & theirs.keys()


ON = {("compare", "split"), ("paper", "swept"), ("identify", "profiles"), ("predict", "carry")}
"""Flags that are on unless turned off: with them left out a result lacks a part."""


def test_no_other_flag_of_a_command_is_on_unless_given():
    from importlib.resources import files

    on = set()
    for path in (files("clubface") / "cli").iterdir():
        if path.name.endswith(".py") and not path.name.startswith("_"):
            module = importlib.import_module(f"clubface.cli.{path.name[:-3]}")
            for name, thing in inspect.getmembers(module, inspect.isfunction):
                if thing.__module__ == module.__name__ and not name.startswith("_"):
                    on |= {(name, key) for key, value in numbers(thing).items() if value is True}
    assert on == ON
