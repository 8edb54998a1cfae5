"""What a strike a groove lower changes in the spin of an iron, cause by cause: `make strike-height`.

Printed are the change of spin by model, and by finite elements with one thing changed at a time: head, shaft, friction,
ball, loft, speed. It stands at one delivery, and at one launch, where the loft is solved. A file of shots with measured
strike heights gives the slope at one launch from measurements: `python studies/strike_height.py shots.csv`, with
`--club "7 Iron"`, `--unit angle=deg` or `--mapping square-strikes.toml` where the file needs them. What is printed is
kept in docs/finite-elements/strike-height.json.
"""

from __future__ import annotations

import argparse
import json
import math
import warnings
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from attached_shaft import effective_inertia
from ball_fit import END

from clubface import Club, club, fem, impact, shots as launch_monitor, units
from clubface.fem.materials import Maxwell

GROOVE = units.parse("3.6 mm", "length")
"""Pitch of the grooves of an iron."""
SHOT = {"speed": "82 mph", "attack": "-3 deg", "loft": "25.5 deg"}
STEP = units.parse("2 deg", "angle")
"""Loft that is added to find the spin at one launch."""
IRON = club("7-iron").replace(characteristic_time=0.0)
FIXED = IRON.replace(ixx=0.5, iyy=0.5, izz=0.57, ixy=0.0, ixz=0.0, iyz=0.0)
"""The head with ten thousand times its inertia [kg m2]."""
MODELS = ("standard", "volumetric", "rings", "response")
CONTACT_TIME = 480e-6
"""How long an iron touches the ball [s]."""
KEPT = Path(__file__).parents[1] / "docs" / "finite-elements" / "strike-height.json"
FIGURES: dict[str, dict[str, float]] = {}
"""The figures of the table that is being computed, by line."""


def keep(line: str, **figures: float) -> None:
    """Keep the figures of a line."""
    FIGURES[line] = {name: float(f"{value:.5g}") for name, value in figures.items()}


class Strike(NamedTuple):
    """Backspin [rpm], launch angle [deg], ball speed [mph], and pitch rate that the head gained, loft up [rad/s]."""

    spin: float
    launch: float
    speed: float
    pitch: float


def compute(head: Club | fem.MeshedHead, shot: Mapping[str, Any], model: str = "fem", **options: Any) -> Strike:
    """Compute one shot with the finite elements or another model."""
    if model == "fem":
        launch: Any = fem.strike(head, shot, settings=END, **options).launch
    else:
        assert isinstance(head, Club)
        launch = impact(head, model=model, **shot)
    spin, up, speed = launch.get("backspin", "rpm"), launch.get("launch", "deg"), launch.get("ball_speed", "mph")
    return Strike(float(spin), float(up), float(speed), float(launch.club_spin_z))


def lower(
    head: Club | fem.MeshedHead, shot: Mapping[str, Any] = SHOT, by: float = GROOVE, **options: Any
) -> tuple[Strike, float]:
    """Return what changes in a lower strike, and the change of spin at the launch of the higher one."""
    below = {**shot, "high": -by}
    more_loft = {**below, "loft": units.parse(shot["loft"], "angle") + STEP}
    centre, low, lofted = (compute(head, each, **options) for each in (shot, below, more_loft))
    change = Strike(*(b - a for a, b in zip(centre, low, strict=True)))
    slope = (lofted.spin - low.spin) / (lofted.launch - low.launch)
    return change, change.spin - slope * change.launch


def print_change(name: str, head: Club | fem.MeshedHead, shot: Mapping[str, Any] = SHOT, **options: Any) -> None:
    """Print one line of a table."""
    change, at_launch = lower(head, shot, **options)
    keep(name.strip(), **change._asdict(), at_launch=at_launch)
    print(
        f"{name:52}{change.spin:+7.0f}{at_launch:+10.0f}{change.launch:+9.2f}{change.speed:+8.1f}{change.pitch:+8.0f}"
    )


def with_mass_centre(depth: float | None = None, above: float | None = None) -> Club:
    """Return the 7-iron with the face centre so far [m] ahead of its mass centre, and above it along the face."""
    normal, up = face_axes()
    own = np.array(IRON.cg[:2])
    x, y = normal * (own @ normal if depth is None else depth) + up * (own @ up if above is None else above)
    return IRON.replace(cg_x=float(x), cg_y=float(y))


def face_axes() -> tuple[Any, Any]:
    """Return the normal of the face and its up direction in the vertical plane, at the static loft."""
    sine, cosine = math.sin(IRON.loft), math.cos(IRON.loft)
    return np.array([cosine, sine]), np.array([-sine, cosine])


def on_a_shaft() -> Club:
    """Return the rigid head that gains the speed and pitch rate of the head on a steel shaft in one contact.

    Along the target line and in pitch, which carry the effect; the shaft's greater mass along itself is left out.
    """
    whole = effective_inertia(IRON.mass, np.array(IRON.inertia), CONTACT_TIME)
    planar = np.linalg.inv(np.linalg.inv(whole)[np.ix_([0, 5], [0, 5])])
    mass = float(planar[0, 0])
    rise = -float(planar[0, 1]) / mass
    pitch = float(planar[1, 1]) - mass * rise**2
    return IRON.replace(
        mass=mass, cg_y=IRON.cg_y - rise, izz=pitch, ixx=2.0 * IRON.ixx, iyy=2.0 * IRON.iyy, ixy=0.0, ixz=0.0, iyz=0.0
    )


def with_cover(*branches: Maxwell) -> fem.Ball:
    """Return the default ball with another viscosity of its cover."""
    ball = fem.ball("modern")
    core, cover = ball.pieces
    return replace(ball, pieces=(core, replace(cover, material=replace(cover.material, maxwell=branches))))


def print_models() -> None:
    """Print the change by model, with the mass centre where it is and in the plane of the face."""
    flat = with_mass_centre(depth=0.0)
    for model in (*MODELS, "fem"):
        print_change(model, IRON, model=model)
        print_change(f"  {model}, mass centre in the plane of the face", flat, model=model)


def print_causes() -> None:
    """Print the change by finite elements with one thing changed at a time."""
    print_change("7-iron as it is", IRON)
    print_change("head that cannot turn", FIXED)
    print_change("inertia in pitch times 4", IRON.replace(izz=4.0 * IRON.izz))
    print_change("head on a steel shaft", on_a_shaft())
    for depth in (10e-3, 15e-3):
        print_change(f"mass centre {1e3 * depth:.0f} mm behind the face", with_mass_centre(depth=depth))
    print_change("mass centre level with the face centre", with_mass_centre(above=0.0))
    for friction in (0.2, 0.7, 2.0):
        print_change(f"friction {friction}", IRON, friction=friction)
    print_change("elastic cover", IRON, ball=with_cover())
    print_change("cover that relaxes more (1.0, 100 us)", IRON, ball=with_cover(Maxwell(1.0, 100e-6)))
    for name, other in (("loft", "18 deg"), ("loft", "32 deg"), ("speed", "60 mph"), ("speed", "95 mph")):
        print_change(f"{name} {other}", IRON, {**SHOT, name: other})


def print_meshed() -> None:
    """Print the change by the meshed 7-iron, and by a rigid head of its mass and inertia, which other code computes."""
    head = fem.head("7-iron")
    print_change("meshed 7-iron", head)
    print_change("rigid head with its mass and inertia", head.club)


def print_turning() -> None:
    """Print what a face that turns at a steady rate does to the spin, and what its mean loft alone would do."""
    loft, rate = units.parse(SHOT["loft"], "angle"), 100.0
    turned = 0.5 * rate * CONTACT_TIME
    centred = FIXED.replace(cg_x=0.0, cg_y=0.0, cg_z=0.0)
    for model in ("volumetric", "rings", "response", "fem"):
        turning, lofts = (
            [compute(centred, {**SHOT, name: value}, model).spin for value in values]
            for name, values in (("pitch_rate", (-rate, rate)), ("loft", (loft - turned, loft + turned)))
        )
        change, mean_loft = (turning[1] - turning[0]) / 2.0, (lofts[1] - lofts[0]) / 2.0
        keep(model, spin=change, mean_loft=mean_loft)
        print(f"{model:52}{change:+7.0f}{mean_loft:+10.0f}")


def print_gear_effect() -> None:
    """Print the gear effect in closed form: a rolling ball, and a ball on a spring along the face.

    The head gains the pitch rate W, so the face under the ball gains the speed c W along itself, c being the depth of
    the mass centre. A rolling ball takes all of it with the impulse c W / (1/m (7/2) + 1/M + c^2/I). On a spring along
    the face that gives the tangential restitution e = -cos(f), f being 2 pi times the contact time over the period, a
    speed gained as under a force of half a sine is taken but for (pi^2/2) (1 - e)/(pi^2 - f^2).
    """
    ball = fem.ball("modern").rigid
    depth = float(np.array(IRON.cg[:2]) @ face_axes()[0])
    for model in ("standard", "fem"):
        pitch = lower(IRON, model=model)[0].pitch
        mobility = (1.0 + ball.mass * ball.radius**2 / ball.inertia) / ball.mass + 1.0 / IRON.mass + depth**2 / IRON.izz
        rolling = -depth * pitch / mobility * ball.radius / ball.inertia
        difference = lower(IRON, model=model)[0].spin - lower(with_mass_centre(depth=0.0), model=model)[0].spin
        keep(model, rolling=units.from_si(rolling, "rpm"), computed=difference)
        name = f"{model}: rolling ball {units.from_si(rolling, 'rpm'):+.0f}, computed"
        print(f"{name:52}{difference:+7.0f}")
    for restitution in (0.0, 0.3, 0.6):
        phase = math.acos(-restitution)
        share = 1.0 - math.pi**2 / 2.0 * (1.0 - restitution) / (math.pi**2 - phase**2)
        keep(f"spring with tangential restitution {restitution}", share=share)
        print(f"{f'spring with tangential restitution {restitution}: share':52}{share:7.2f}")


def print_driver() -> None:
    """Print the spin of drives by strike height at one launch [rpm/mm]."""
    driver = club("driver").replace(characteristic_time=0.0)
    shot = {"speed": "100 mph", "attack": "0 deg", "loft": "14 deg"}
    for model in ("standard", "response", "fem"):
        slope = -lower(driver, shot, by=5e-3, model=model)[1] / 5.0
        keep(model, rpm_a_mm=slope)
        print(f"{model:52}{slope:+17.0f}")


def print_shaft() -> None:
    """Print what the shaft changes of a centred strike."""
    shaft = on_a_shaft()
    free, held = compute(IRON, SHOT), compute(shaft, SHOT)
    keep("free", **free._asdict())
    keep("on a shaft", **held._asdict(), grams=1e3 * (shaft.mass - IRON.mass), pitch_inertia=shaft.izz / IRON.izz)
    print(f"{'free: ball speed, pitch':52}{free.speed:35.1f}{free.pitch:+8.0f}")
    print(f"{'on a shaft':52}{held.speed:35.1f}{held.pitch:+8.0f}")


def print_pair() -> None:
    """Print the two 8-irons of the article: 85 mph, 17 mm to the toe and a groove lower beside a solid one."""
    head = club("8-iron").replace(characteristic_time=0.0)
    shot = {"speed": "85 mph", "attack": "-3 deg", "loft": "29 deg"}
    solid, toe = ({**shot, "toe": toe, "high": high} for toe, high in (("-3 mm", 0.0), ("17 mm", -GROOVE)))
    for model in ("standard", "response", "fem"):
        change = Strike(*(b - a for a, b in zip(compute(head, solid, model), compute(head, toe, model), strict=True)))
        keep(model, **change._asdict())
        print(f"{model:52}{change.spin:+7.0f}{change.launch:+19.2f}{change.speed:+8.1f}")


def print_measured(path: Path, club_name: str | None, **reading: Any) -> None:
    """Print the spin of shots in a file by strike height at one launch, with 95% of a bootstrap.

    The spin is fitted, robustly, on launch less attack angle, attack angle, club speed, strike height and the strike
    towards the toe with its square.
    """
    shots = launch_monitor.read(path, **reading)
    if club_name is not None:
        assert shots.clubs is not None
        shots = shots.select(shots.clubs == club_name)
    speed, attack, toe, high = (np.asarray(shots.deliveries[name]) for name in ("speed", "attack", "toe", "high"))
    launch, spin = (np.asarray(shots.launches[name]) for name in ("launch", "total_spin"))
    ball_speed = np.asarray(shots.launches["ball_speed"])
    rows = np.column_stack([high, launch - attack, attack, speed, toe, toe**2, np.ones_like(high)])
    solid = np.isfinite(rows).all(1) & np.isfinite(spin) & (ball_speed > 1.15 * speed) & (np.abs(toe) < 0.03)
    rows, spin = rows[solid], units.from_si(spin[solid], "rpm")
    rng = np.random.default_rng(37)
    draws = (rng.integers(len(spin), size=len(spin)) for _ in range(400))
    low, high_end = np.percentile([robust(rows[each], spin[each])[0] for each in draws], [2.5, 97.5]) * 1e-3
    slope = robust(rows, spin)[0] * 1e-3
    keep(f"{path.stem}, {club_name or 'all'}", shots=len(spin), rpm_a_mm=slope, low=low, high=high_end)
    print(f"{path}: {len(spin)} shots, {slope:+.0f} rpm a mm higher (95%: {low:+.0f} to {high_end:+.0f})")


def robust(rows: Any, values: Any) -> Any:
    """Return the coefficients of a linear fit by Huber's weights, without residuals beyond four deviations."""
    weights, fit = np.ones(len(values)), np.zeros(rows.shape[1])
    for _ in range(40):
        root = np.sqrt(weights)
        fit = np.linalg.lstsq(rows * root[:, None], values * root, rcond=None)[0]
        residual = np.abs(values - rows @ fit)
        deviation = 1.4826 * np.median(residual)
        weights = np.where(residual > 4.0 * deviation, 0.0, np.minimum(1.0, 1.345 * deviation / (residual + 1e-9)))
    return fit


TABLES: dict[str, Callable[[], None]] = {
    "by model": print_models,
    "finite elements": print_causes,
    "a head that deforms": print_meshed,
    "face turning 100 rad/s, and its mean loft alone": print_turning,
    "gear effect in closed form": print_gear_effect,
    "centred strike with and without a shaft": print_shaft,
    "driver, rpm a mm higher at one launch": print_driver,
    "two 8-irons, 17 mm to the toe and a groove lower": print_pair,
}


def main() -> None:
    """Print the tables, or the slope of the files given, and keep what is printed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("shots", nargs="*", type=Path, help="files with measured strike heights")
    parser.add_argument("--club", help="its shots alone")
    parser.add_argument("--mapping", type=Path, help="what the columns of the files mean")
    parser.add_argument("--unit", action="append", default=[], help="of columns that name none: angle=deg")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    kept = json.loads(KEPT.read_text(encoding="utf-8")) if KEPT.is_file() else {}
    if given.shots:
        FIGURES.update(kept.get("measured", {}))
        for path in given.shots:
            print_measured(path, given.club, mapping=given.mapping, units=dict(each.split("=") for each in given.unit))
        kept["measured"] = dict(FIGURES)
    else:
        kept["groove_mm"] = units.from_si(GROOVE, "mm")
        print(f"{'7-iron at 82 mph, 3.6 mm lower':52}   spin at launch   launch   speed   pitch")
        print(f"{'':52}    rpm       rpm      deg     mph   rad/s")
        for name, table in TABLES.items():
            print(f"\n{name}", flush=True)
            FIGURES.clear()
            table()
            kept[name] = dict(FIGURES)
    KEPT.write_text(json.dumps(kept, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
