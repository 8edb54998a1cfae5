"""Every number of the paper, as it is printed, made from the package and from what long computations stored in docs.

``paper.typ`` inserts them by name, ``n.driver.loft``, and types none itself. What is quoted from a publication stands
here once, next to its source, unless it is part of the published data of the package.
"""

from __future__ import annotations

import contextlib
import io
import math
import re
import sys
import warnings
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import clubface
from clubface import fem, published_data, units
from clubface.equipment.balls import published_ball
from clubface.equipment.models import models
from clubface.errors import RangeWarning
from clubface.inference.evaluation import contradictions, published
from clubface.inference.evaluation.published_accuracy import wrong_percentages
from clubface.support.arrays import Floats
from clubface.validation import tour
from clubface.validation.benchmark_data import HEADS

ROOT = Path(__file__).parent.parent
EXAMPLE = Path(__file__).with_name("example.py")
sys.path[:0] = [str(ROOT / "docs"), str(ROOT / "docs" / "_ext"), str(ROOT / "studies")]

from benchmark_findings import bias_of, bias_of_magnitudes, mean_magnitude  # noqa: E402
from benchmark_tables import BUSY, element_step, spaced  # noqa: E402
from core_tables import compared  # noqa: E402
from errata_tables import DriverCgReadings, mean_delivery, turned  # noqa: E402
from response_fit import PARTS  # noqa: E402
from run import stored  # noqa: E402
from validation_tables import validation  # noqa: E402

WORDS = ("none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
TOUR_DRIVE = {"speed": "113 mph", "attack": "-1.3 deg", "loft": "12.8 deg"}
"""The average drive of the PGA Tour of 2019, as the README has it."""
KINDS = {
    "response": "impulse, fitted to finite elements", "standard": "impulse", "adjusted": "impulse", "slip": "impulse",
    "jorgensen": "impulse", "volumetric": "contact, two-layer ball", "rings": "contact, stick and slip",
    "area": "contact, area term", "fem": "finite elements",
}  # fmt: skip
"""What each model is, in the words of the table of models."""


REFERENCE = (
    ("velocity along the normal, m/s", "normal", "normal_velocity_mps", 1.0, 1.0, 2),
    ("velocity along the plane, m/s", "tangential", "tangential_velocity_mps", 1.0, 1.0, 2),
    ("spin, rpm", "rpm", "backspin_rpm", 1.0, 1.0, 0),
    ("peak force, kN", "peak", "peak_force_n", 1.0, 1e-3, 2),
    ("peak of friction, N", "forward", "tangential_max_n", 1.0, 1.0, 0),
    ("the same, reversed, N", "back", "tangential_min_n", 1.0, 1.0, 0),
    ("reversal, µs", "reversal_us", "reversal_time_s", 1e6, 1.0, 0),
    ("contact, µs", "contact_us", "contact_time_s", 1e6, 1.0, 0),
)
"""Of the reference case: words, names of ours and of the others, how many of our units theirs is, scale, digits."""


def number(value: float, digits: int = 0, sign: bool = False) -> str:
    """Write a number with a fixed count of decimals, thousands set apart and a minus that is one."""
    written = f"{value:{'+' if sign else ''},.{digits}f}"
    if abs(value) < 1e4:
        written = written.replace(",", "")
    return written.replace("-", "−")


def each_number(values: Iterable[float], digits: int = 0) -> list[str]:
    """Write several numbers."""
    return [number(each, digits) for each in values]


def to(value: float, unit: str) -> float:
    """Return an SI value in a unit."""
    return float(units.from_si(value, unit))


def all_numbers() -> dict[str, dict[str, Any]]:
    """Return the numbers of the paper by section and name."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RangeWarning)
        sections = (
            release, example, drive, driver_cg, moduli, sets, errata, identification, roh_and_lee, verification,
            response, accuracy, cost, shaft, limits,
        )  # fmt: skip
        return {each.__name__: each() for each in sections}


def release() -> dict[str, Any]:
    """Version and date, of CITATION.cff."""
    text = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    return {name: line_of(text, f"{key}: (.+)") for name, key in (("version", "version"), ("date", "date-released"))}


def line_of(text: str, pattern: str) -> str:
    """Return what the group of a pattern matches in the one line that begins with it."""
    (value,) = re.findall(rf"^{pattern}", text, re.MULTILINE)
    return value


def example() -> dict[str, Any]:
    """What the listing prints."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(EXAMPLE.read_text(encoding="utf-8"), EXAMPLE, "exec"), {})
    return {"printed": printed.getvalue().rstrip()}


def drive() -> dict[str, Any]:
    """The strike of the first picture, as docs/figures/impact.py computes it."""
    struck = fem.strike(fem.head("paper"), speed="105 mph", ball="modern", friction=0.35)
    assert struck.launch is not None
    return {
        "speed": "105",
        "peak": number(struck.peak_force / 1e3, 1),
        "peak_time": number(1e6 * struck.peak_force_time),
        "squeezed": number(100 * struck.contraction),
        "reversal": number(1e6 * struck.reversal_time),
        "most_spin": number(to(struck.spin_max, "rpm")),
        "spin": number(to(struck.backspin, "rpm")),
        "end": number(1e6 * struck.last_touch),
        "ball_speed": number(struck.launch.get("ball_speed", "mph")),
    }


class CgReadings(NamedTuple):
    """Readings of the vector from the driver's CG to its face centre, forward and up [mm].

    Attributes
    ----------
    loft
        Of the head [rad].
    printed
        As Caldwell and McPhee print it.
    face
        As Danaei and co-workers print it, in the frame of the face.
    once, twice
        The same, turned by the loft once, into the frame of the club, and twice.
    """

    loft: float
    printed: Floats
    face: Floats
    once: Floats
    twice: Floats


def cg_readings() -> CgReadings:
    """Return the readings of the driver's CG."""
    head, face = clubface.club("driver-as-printed"), DriverCgReadings.IN_FRAME_OF_FACE
    printed = 1e3 * np.array(head.cg)[:2]
    return CgReadings(head.loft, printed, face, turned(face, head.loft), turned(face, 2.0 * head.loft))


def driver_cg() -> dict[str, Any]:
    """The vector that was turned twice, and what the difference does to a drive."""
    reading = cg_readings()
    needed = math.atan2(*reading.printed[::-1]) - math.atan2(-reading.face[1], reading.face[0])  # y pointing down
    strikes = published_data.table("best-strike-blackmore")
    low, centred = (clubface.impact("driver-as-printed", TOUR_DRIVE, high=high).ball_speed for high in (-0.012, 0.0))
    if low < centred:
        raise AssertionError("the printed driver is no longer faster 12 mm below its centre")
    spin, spin_printed = (
        clubface.impact(name, TOUR_DRIVE).get("backspin", "rpm") for name in ("driver", "driver-as-printed")
    )
    return {
        "loft": number(math.degrees(reading.loft), 1),
        "printed": each_number(reading.printed, 1),
        "once": each_number(reading.once, 1),
        "twice": each_number(reading.twice, 1),
        "face_x": number(reading.face[0], 1),
        "face_y": number(-reading.face[1], 1),
        "printed_length": number(np.hypot(*reading.printed), 2),
        "face_length": number(np.hypot(*reading.face), 2),
        "above": number(above_normal(reading.once, reading.loft), 1),
        "below": number(-above_normal(reading.printed, reading.loft), 1),
        "nominal": number(above_normal(*DriverCgReadings.NOMINAL), 1),
        "needed": number(math.degrees(needed), 1),
        "best": each_number((1e3 * strikes[name][0] for name in ("best", "best_least", "best_most")), 1),
        "spin": number(spin),
        "spin_printed": number(spin_printed),
        "least_error": number(
            min(to(each.mae["backspin"], "rpm") for each in published().values() if each.club == "driver")
        ),
        "low": "12",
    }


def above_normal(vector: Floats, loft: float) -> float:
    """Return how far the CG lies above the normal through the face centre, for a vector in the frame of the club."""
    return vector[0] * math.sin(loft) - vector[1] * math.cos(loft)


def moduli() -> dict[str, Any]:
    """A drive by the model of rings, with the shear modulus as printed and with a hundredth of it."""
    rows = {}
    for name, options in (
        ("printed", {"parameters": "three-dimensional-impact-models/as-printed"}),
        ("hundredth", {}),
    ):
        shot = clubface.impact(
            HEADS["driver"], mean_delivery("driver"), model="rings", ball=published_ball(), **options
        )
        rows[name] = {
            "time": number(shot.get("contact_time", "us")),
            "peak": number(shot.get("peak_force", "kN"), 1),
            "spin": number(shot.get("backspin", "rpm")),
            "modulus": number(shot.parameters.values["shear_modulus"] / 1e9, 2),
        }
    measured = published_data.table("drive-contact-time")
    return {
        **rows,
        "measured_time": each_number(1e6 * measured[name][0] for name in ("contact_time_least", "contact_time_most")),
        "measured_spin": number(to(published()["rings", "driver"].mean["backspin"], "rpm")),
    }


def sets() -> dict[str, Any]:
    """Pairs of published parameter sets that their published errors do not allow, and those left with three changes."""
    every = contradictions()
    volumetric, adjusted, rings = (
        clubface.ParameterSet.builtin(*pair)
        for pair in (("volumetric", "driver"), ("adjusted", "driver"), ("rings", "7-iron"))
    )
    left = contradictions({
        ("volumetric", "driver"): volumetric.replace(layer_damping=10 * volumetric.values["layer_damping"]),
        ("adjusted", "driver"): adjusted.replace(dcg_y=0.0, dcg_z=0.0),
        ("rings", "7-iron"): rings.replace(ring_modulus=7.4e7),
    })  # fmt: skip
    return {
        "pairs": number(len(every)),
        "most": number(max(abs(each.difference) / each.allowed for each in every), 1),
        "left": WORDS[len(left)],
        "most_left": number(max(abs(each.difference) / each.allowed for each in left), 2),
    }


def errata() -> dict[str, Any]:
    """What is quoted from the publications as it stands there."""
    printed = [
        clubface.ParameterSet.builtin("area", club, "three-dimensional-impact-models/as-printed").values["area_damping"]
        for club in ("driver", "7-iron")
    ]
    return {
        "eta": each_number(printed),
        "contact": ["400", "600"],  # Roh and Lee, introduction [ms]
        "percentages": number(sum(len(list(wrong_percentages(each))) for each in published().values())),
    }


def identification() -> dict[str, Any]:
    """What the identification on shots whose truth is known found (docs/findings.json)."""
    clubs = stored("docs/findings.json")["clubs"]
    fits = [fit for club in clubs.values() for fit in club["fits"].values()]
    warned = " ".join(
        sentence for fit in fits if fit["settings"]["model"] == "volumetric" for sentence in fit["warnings"]
    )
    times = [float(each) for each in re.findall(r"contact lasts (\d+) us", warned)]
    own = [fit for club in clubs.values() for fit in club["own"].values()]
    held = [low <= fit["true"][name] <= high for fit in own for name, (low, high) in fit["intervals"].items()]
    errors = [(each.mae["azimuth"], each.std["azimuth"]) for each in published().values() if each.std]
    biases = [math.degrees(bias(*each)) for each in errors for bias in (bias_of, bias_of_magnitudes)]
    confidence = {fit["settings"]["confidence"] for fit in fits}
    (certain,) = confidence
    return {
        "drives": number(clubs["driver"]["fits"]["volumetric"]["shots"]),
        "irons": number(clubs["7-iron"]["fits"]["volumetric"]["shots"]),
        "models": WORDS[len(clubs["driver"]["fits"])],
        "overfit": number(max(100 * (fit["cost_holdout"] / fit["cost"] - 1) for fit in fits), 1),
        "confidence": number(100 * certain),
        "stiffness": significant(clubs["driver"]["own"]["volumetric"]["intervals"]["stiffness"], 1e9),
        "times": each_number((min(times), max(times))),
        "parameters": number(len(held)),
        "held": number(sum(held)),
        "expected": number(certain * len(held)),
        "unbiased": number(mean_magnitude(0.0, 1.0), 1),
        "ratios": each_number(extremes(mae / std for mae, std in errors), 1),
        "biases": each_number(extremes(biases), 1),
    }


def extremes(values: Iterable[float]) -> tuple[float, float]:
    """Return the least and the greatest value."""
    every = list(values)
    return min(every), max(every)


def significant(values: Sequence[float], unit: float) -> list[str]:
    """Write values of different size with two digits each, in a unit."""
    return [number(each / unit, 1 if each < 10 * unit else 0) for each in values]


def roh_and_lee() -> dict[str, Any]:
    """The case of Roh and Lee: as printed, and as the finite elements have it."""
    printed, ours = fem.paper.PUBLISHED, stored("docs/fem-figures.json")["paper"]["figures"]["paper"]
    compared_figures = {
        "ball_speed": ("ball_speed_mps", 1.0, 1), "launch": ("launch_deg", 1.0, 1), "peak": ("peak_force_n", 1.0, 0),
        "reversal": ("reversal_time_s", 1e6, 0),
    }  # fmt: skip
    return {
        "printed_factor": number(printed["f"], 4),
        "factor": number(fem.paper.SPIN_FACTOR, 3),
        "spin": number(printed["section_spin_rpm"]),
        "factor_spin": number(printed["section_spin_rpm"] * printed["f"] / fem.paper.SPIN_FACTOR),
        "section": number(ours["section_spin_rpm"]),
        "launch_spin": number(ours["spin_rpm"]),
        **{
            name: each_number((scale * printed[key], scale * ours[key]), digits)
            for name, (key, scale, digits) in compared_figures.items()
        },
    }


def verification() -> dict[str, Any]:
    """How near the finite elements come to other programs and to finer meshes (docs/fem-figures.json)."""
    kept = stored("docs/fem-figures.json")
    decks = [each for each in kept["OpenRadioss"]["figures"].values() if "radioss_speed" in each]
    case = kept["reference"]["figures"]["reference"]
    others = stored("python/clubface/data/published_impacts.toml")["reference"]["figures"]
    meshes = kept["meshes"]["figures"]
    coarse, finest = meshes["9504 elements"], max(meshes.values(), key=lambda each: each["elements"])
    return {
        "others": WORDS[len(others["backspin_rpm"])],
        "rows": [
            [words, *each_number([scale * case[ours], *(scale * unit * each for each in others[theirs])], digits)]
            for words, ours, theirs, unit, scale, digits in REFERENCE
        ],
        "velocity": number(max(
            apart(case["normal"], others["normal_velocity_mps"]),
            apart(case["tangential"], others["tangential_velocity_mps"]),
        ), 1),
        "spin": number(apart(case["rpm"], others["backspin_rpm"]), 1),
        "peak": number(apart(case["peak"], others["peak_force_n"]), 1),
        "decks": WORDS[len(decks)],
        "deck_speed": number(max(apart(each["ball_speed_mps"], [each["radioss_speed"]]) for each in decks), 1),
        "deck_spin": number(max(apart(each["backspin_rpm"], [each["radioss_spin"]]) for each in decks), 1),
        "elements": number(coarse["elements"]),
        "finest": number(finest["elements"]),
        "mesh_speed": number(apart(finest["ball_speed_mps"], [coarse["ball_speed_mps"]]), 1),
        "mesh_spin": number(apart(finest["backspin_rpm"], [coarse["backspin_rpm"]]), 1),
    }  # fmt: skip


def apart(ours: float, theirs: Iterable[float]) -> float:
    """Return the largest difference of a value from others, in per cent of them."""
    return max(100 * abs(ours / each - 1) for each in theirs)


def response() -> dict[str, Any]:
    """How near the default model comes to finite elements that it was not fitted to (studies/response/modern.json)."""
    differences = stored("studies/response/modern.json")
    face = stored("studies/face_spring.json")["today"]
    less = [100 * (1 - face["spring"][loft]["backspin"] / face["shells"][loft]["backspin"]) for loft in ("15", "10")]
    return {
        "strikes": number(sum(part.count for part in PARTS.values() if not part.held_out)),
        "clubs": at_most(differences["clubs, held out"]),
        "heads": at_most(differences["heads, held out"]),
        "less_spin": each_number(less),
    }


def at_most(differences: dict[str, list[float]]) -> list[str]:
    """Write what 95 of 100 differences of speed [%] and direction [degrees] are below, rounded upwards."""
    bounds = (100 * differences["speed"][1], math.degrees(differences["direction"][1]))
    return each_number((math.ceil(each * 100 - 1e-9) / 100 for each in bounds), 2)


def accuracy() -> dict[str, Any]:
    """How near the models come to published figures, and what a shot costs."""
    checked, averages = validation(), [compared(name) for name in tour.TABLES]
    reduced = list(models())
    errors = {name: tour.mean_absolute_error(averages, name) for name in reduced}
    costs = stored("docs/benchmarks.json")["models"]
    rows = [
        [
            name, KINDS[name], f"{checked.verdict(name).met} of {checked.verdict(name).of}",
            *(number(to(errors[name][quantity], unit), digits) for quantity, unit, digits in
              (("ball_speed", "mph", 1), ("spin", "rpm", 0), ("carry", "yd", 1))),
            spaced(costs[name]["shot"]), spaced(costs[name]["derivatives"]),
        ]
        for name in reduced
    ]  # fmt: skip
    verdict = checked.verdict("fem")
    rows.append(
        ["fem", KINDS["fem"], f"{verdict.met} of {verdict.of}", "–", "–", "–", spaced(costs["fem"]["call"]), "–"]
    )
    tolerances = [checked.summary("response", check) for check in ("tour-driver", "tour-irons")]
    (speed, drive_spin), (_, iron_spin) = ([each.tolerances[1] for each in check] for check in tolerances)
    verdict = checked.verdict("response")
    return {
        "rows": rows,
        "models": WORDS[len(reduced)],
        "met": number(verdict.met),
        "of": number(verdict.of),
        "others_met": each_number(extremes(checked.verdict(name).met for name in reduced if name != "response")),
        "averages": number(sum(len(each.averages) for each in averages)),
        "lofts": WORDS[sum(int(each.loft_is_published.sum()) for each in averages)],
        "speed_tolerance": number(100 * speed, 1),
        "spin_tolerances": each_number((100 * drive_spin, 100 * iron_spin)),
    }


def cost() -> dict[str, Any]:
    """What runs take (docs/benchmarks.json), and on which machine."""
    times = stored("docs/benchmarks.json")
    run, machine = times["elements"]["reference"][0], times["models"]["measured"]
    load = max(section["measured"]["load"] or 0.0 for section in times.values())
    search = times["identification"]["standard"]
    return {
        "processor": machine["processor"],
        "date": machine["date"],
        "load": f"{load:.0f}" if load > BUSY else "",
        "element_step": element_step(run["wall"], run["steps"], run["elements"]),
        "elements": number(run["elements"]),
        "run": spaced(run["wall"]),
        "lulesh": number(1e9 * times["lulesh"]["runs"][0]["element_step"]),
        "million": spaced(times["flights"]["drives"]["1"]),
        "search_impacts": number(search["impacts"] / 1e6),
        "search": spaced(search["processor"]),
    }


def shaft() -> dict[str, Any]:
    """The driver free and on its shaft; the ball speeds by studies/shaft_impact.py as docs/shaft.md has them."""
    page = (ROOT / "docs" / "shaft.md").read_text(encoding="utf-8")
    free, matrix, beam = (
        float(line_of(page, rf"\| driver, centre \| {kind} \| ([\d.]+)")) for kind in ("free", "matrix", "beam")
    )
    alone = clubface.club("driver")
    slopes = []
    for club in (alone, alone.on_shaft("graphite")):
        heel, toe = (
            clubface.impact(club, speed="108 mph", loft="13 deg", toe=toe).get("sidespin", "rpm")
            for toe in (-0.015, 0.015)
        )
        slopes.append(abs(toe - heel) / 30)
    return {
        "masses": each_number(1e3 * each.effective_mass for each in (alone, alone.on_shaft("graphite"))),
        "gain": number(beam - free, 2),
        "matrix_gain": number(matrix - free, 2),
        "sidespin": each_number(slopes, 1),
    }


def limits() -> dict[str, Any]:
    """Where the models are wrong."""
    short = {name: -to(iron_spin_error(name), "rpm") for name in models()}
    others = [each for name, each in short.items() if name not in ("response", "rings")]
    fits = [each["error_percent"] for each in stored("docs/finite-elements/ball-fit.json")["spins"]]
    robots = [
        next(each.bias for each in validation().summary(name, "irons-at-launch") if each.quantity == "spin")
        for name in ("response", "rings")
    ]
    return {
        "response": number(short["response"]),
        "rings": number(short["rings"]),
        "others": each_number(extremes(others)),
        "robots": each_number((100 * each for each in robots), 1),
        "fit": [number(each, 1, sign=True) for each in extremes(fits)],
    }


def iron_spin_error(model: str) -> float:
    """Return the mean error of a model in the spin of irons and wedges over the tour averages [rad/s]."""
    errors = [
        spin - row.spin
        for each in map(compared, tour.TABLES)
        for row, spin in zip(each.averages, each.values[model]["spin"], strict=True)
        if "iron" in row.club or "wedge" in row.club
    ]
    return float(np.mean(errors))
