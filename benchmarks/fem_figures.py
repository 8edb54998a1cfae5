"""The figures of the pages in docs/finite-elements, computed again; with names of sections, theirs alone.

They are kept in docs/fem-figures.json, each section with the commit whose code computed it, and a test compares the
pages with that file. The reference case on meshes goes to the package, which quotes it.
"""

import json
import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

import clubface
from clubface import fem
from clubface.equipment.clubs import Club
from clubface.fem import accuracy, head_tests, paper, reduced, sweep
from clubface.fem.case import case
from clubface.fem.heads.read import from_toml
from clubface.fem.result import Impact
from clubface.support.files import builtin_path

sys.path.extend(str(Path(__file__).parent.parent / folder) for folder in ("studies", "docs"))
import ball_fit
from run import commit

RPM = 60.0 / math.tau
END = fem.Settings(until_separation=True)
BALLS = ("reference", "paper", "modern")


STORED = Path(__file__).parent.parent / "docs" / "fem-figures.json"
DIGITS = 7
COMPUTED: dict[str, dict[str, float]] = {}
"""The figures of the section that is being computed, by what they are of."""


def print_figures(what: str, **figures: float) -> None:
    """Print a line of figures, and keep it."""
    COMPUTED[what] = {name: float(f"{value:.{DIGITS}g}") for name, value in figures.items()}
    print(f"{what:34}", "  ".join(f"{name} {value:.6g}" for name, value in figures.items()), flush=True)


def plate(impact: Impact) -> dict[str, float]:
    """Return the figures of a throw at a plane."""
    return {
        "normal": impact.normal_velocity,
        "tangential": impact.tangential_velocity,
        "rpm": impact.backspin * RPM,
        "most_rpm": impact.spin_max * RPM,
        "peak": impact.peak_force,
        "at_us": impact.peak_force_time * 1e6,
        "forward": impact.tangential_max,
        "back": impact.tangential_min,
        "reversal_us": impact.reversal_time * 1e6,
        "contact_us": impact.contact_time * 1e6,
        "energies": impact.energy_error,
    }


def flat_top(impact: Impact, within: float) -> dict[str, float]:
    """Return from when to when the force is nearly at its peak, once single nodes no longer show."""
    force, time = impact.contact["normal"], impact.contact["time"]
    high = time[force > (1.0 - within) * force.max()]
    return {"from_us": high[0] * 1e6, "to_us": high[-1] * 1e6}


def the_reference() -> None:
    """The reference case, by elements and contact."""
    impact = fem.reference()
    print_figures(
        "reference", **plate(impact), restitution=impact.normal_velocity / (35.0 * math.cos(math.radians(11.5)))
    )
    print_figures("top within 5%", **flat_top(impact, 0.05))
    print_figures("eight-point", **plate(fem.reference(element="full")))
    lagrange = fem.reference(settings=fem.Settings(contact="augmented-lagrange"))
    print_figures("augmented Lagrange", **plate(lagrange))
    for name, run in (("penalty", impact), ("augmented Lagrange", lagrange)):
        print_figures(
            f"energy of contact, {name}", **{key: max(abs(run.energy[key])) for key in ("contact", "damping")}
        )


def assumed_head() -> Club:
    """Return a rigid head of the mass of Roh and Lee's with their one moment of inertia about every axis.

    Its CG lies 35 mm behind the face centre. It is that of the keyword deck that OpenRadioss ran.
    """
    none = dict.fromkeys(("ixy", "ixz", "iyz", "cg_z"), 0.0)
    moments = dict.fromkeys(("ixx", "iyy", "izz"), 1526e-7)
    return replace(fem.head("paper").club, mass=0.21, cg_x=34.3e-3, cg_y=7e-3, **moments, **none)


def thin_middle() -> fem.MeshedHead:
    """Return Roh and Lee's head with a face thinner in the middle than at its edge."""
    design = from_toml(builtin_path("head", "paper", "fem_heads"))
    assert isinstance(design, fem.DriverHead)
    walls = {**design.thickness, "face_centre": 1.6e-3, "face_edge": 2.1e-3}
    return fem.head(replace(design, thickness=walls))


def patches(impact: Impact) -> dict[str, dict[str, float]]:
    """Return what stands in Fig. 5 at its moments: nodes under load, and the share that pulls against backspin.

    The first moment is that at which the first node does so by more than a hundredth of a newton.
    """
    patch = impact.patch
    times = np.unique(patch["time"])
    against = patch["tangential"] < -0.01
    moments = {"first against backspin": patch["time"][against].min()}
    moments |= {f"{each} us": each * 1e-6 for each in range(120, 601, 120)}
    moments["last touch"] = impact.last_touch
    figures = {}
    for name, wanted in moments.items():
        moment = float(times[np.argmin(abs(times - wanted))])
        at = patch["time"] == moment
        loaded = patch["normal"][at] > 0.0
        figures[name] = {
            "us": moment * 1e6,
            "nodes": loaded.sum(),
            "against": against[at][loaded].mean(),
            "above": (patch["up"][at][loaded & against[at]] > 0.0).mean() if (loaded & against[at]).any() else 0.0,
            "newtons": patch["tangential"][at].sum(),
        }
    return figures


def the_paper() -> None:
    """Roh and Lee's case and its variations."""
    impact = paper.paper()
    variations = {
        "paper": impact,
        "rigid head": paper.paper("paper-rigid"),
        "rigid head with assumed CG": paper.paper(case("paper-rigid").replace(club=assumed_head())),
        "friction 0.35": paper.paper(case("paper").replace(friction=0.35)),
        "augmented Lagrange": paper.paper(case("paper").replace(settings={"contact": "augmented-lagrange"})),
        "steps of 0.76, nothing rests": paper.paper(case("paper").replace(settings={"safety": 0.76})),
        "face of 1.6 to 2.1 mm": paper.paper(case("paper").replace(club=thin_middle())),
    }
    for name, run in variations.items():
        print_figures(name, **paper.table(run), f_of_spin=paper.spin_factor(run), energies=run.energy_error)
    print_figures("top within 2%", **flat_top(impact, 0.02))
    print_figures("section in the 400 us after take-off", **section_after(impact, 400e-6))
    for moment, figures in patches(impact).items():
        print_figures(f"patch, {moment}", **figures)
    head = fem.head("paper")
    print_figures(
        "its head", restitution=head_tests.restitution(head), ct_us=head_tests.characteristic_time(head) * 1e6
    )


def section_after(impact: Impact, lasting: float) -> dict[str, float]:
    """Return the spin of Roh and Lee's section of nodes while the ball vibrates so long [s] after take-off."""
    times, spin = paper.section_spin(impact)
    after = spin[(times > impact.last_touch) & (times < impact.last_touch + lasting)] * RPM
    return {"least_rpm": after.min(), "most_rpm": after.max(), "mean_rpm": after.mean()}


def the_sweep() -> None:
    """Roh and Lee's Fig. 8."""
    speeds, lofts = np.arange(30.0, 61.0, 5.0), np.radians(np.arange(8.0, 13.0))
    base = case("paper").replace(settings={"until_separation": True})
    rows = sweep.sweep(base, speeds=speeds.tolist(), lofts=lofts.tolist())
    shape = (len(speeds), len(lofts))
    at = {
        name: np.array([row[name] for row in rows]).reshape(shape)
        for name in ("ball_speed_mps", "spin_rpm", "launch_deg", "f")
    }
    by_speed = np.diff(at["ball_speed_mps"], axis=0) / 5.0
    print_figures("ball speed by club speed", first=by_speed[0].mean(), last=by_speed[-1].mean())
    by_loft = np.diff(at["ball_speed_mps"], axis=1)
    print_figures("ball speed by loft, m/s/deg", least=by_loft.min(), most=by_loft.max())
    by_loft = np.diff(at["launch_deg"], axis=1)
    print_figures(
        "launch angle by loft",
        least=by_loft.min(),
        most=by_loft.max(),
        with_speed=np.ptp(at["launch_deg"], axis=0).max(),
    )
    print_figures(
        "f",
        slow_least=at["f"][0].min(),
        slow_most=at["f"][0].max(),
        fast_least=at["f"][-1].min(),
        fast_most=at["f"][-1].max(),
    )
    spin = at["spin_rpm"]
    off = [
        abs(line - np.polyval(np.polyfit(x, line, 1), x)).max() / np.ptp(line)
        for x, lines in ((speeds, spin.T), (lofts, spin))
        for line in lines
    ]
    print_figures("spin off a line, of its range", most=max(off))


def modern() -> None:
    """What `modern` was fitted to, and what it predicts."""
    for speed in (10.0, 30.0, 38.1, 43.6, 50.0, 57.0):
        impact = fem.throw("modern", speed=speed, settings=END)
        force, time = impact.contact["normal"], impact.contact["time"]
        lasting = np.ptp(time[force > 0.01 * force.max()]) * 1e6
        deflection = impact.contraction * 0.5 * impact.ball.diameter * 1e3
        restitution = impact.normal_velocity / speed
        print_figures(
            f"{speed} m/s",
            restitution=restitution,
            peak=impact.peak_force,
            mm=deflection,
            us=lasting,
            last_us=impact.contact_time * 1e6,
        )


def steps() -> None:
    """What rest changes, and how hard balls may be thrown."""
    for name in BALLS:
        for speed in (35.0, 50.0):
            rests, none = (
                fem.throw(name, speed=speed, angle="11.5 deg", settings=replace(END, safety=safety))
                for safety in (0.75, 0.76)
            )
            speeds = [np.hypot(run.normal_velocity, run.tangential_velocity) for run in (rests, none)]
            changes = {
                "speed": speeds[0] / speeds[1] - 1.0,
                "spin": rests.backspin / none.backspin - 1.0,
                "peak": rests.peak_force / none.peak_force - 1.0,
            }
            print_figures(f"{name}, {speed} m/s: rest changes", **changes)
        hard = fem.throw(name, speed=80.0, settings=END)
        print_figures(f"{name}, 80 m/s", safety=hard.settings.safety or math.nan, energies=hard.energy_error)


def derivatives() -> None:
    """Derivatives of a drive compared with differences."""
    given = {"speed": 45.0, "loft": 0.2}

    def launch(**changes: float) -> dict[str, float]:
        return fem.strike("driver", {**given, **changes}, ball="modern", settings=END).outcome()

    exact = fem.sensitivity("driver", given, ball="modern", by=["speed", "loft"])
    for name, widths in (("speed", (0.3, 1.0, 2.0)), ("loft", (0.003, 0.01, 0.03))):
        for quantity in ("ball_speed", "launch", "backspin"):
            slopes = {}
            for width in widths:
                high, low = (launch(**{name: given[name] + sign * width}) for sign in (0.5, -0.5))
                slopes[f"over_{width}"] = (high[quantity] - low[quantity]) / width
            print_figures(f"{quantity} by {name}", exact=exact.by(quantity, name), **slopes)


THIRDS = (2, 3, 4, 5, 6, 9)
"""Meshes of the reference case, in thirds of the elements of the default one along every edge."""


def meshes() -> None:
    """The reference case on other meshes."""
    for ball in accuracy.meshes(fem.ball("reference"), THIRDS):
        row = accuracy.mesh_row(fem.reference(ball=ball, settings=END))
        print_figures(f"{row['elements']:.0f} elements", **row)


def models() -> None:
    """Agreement with the reduced models, and launches of a driver."""
    for club, given in (("driver", {"speed": 50.0, "loft": "12 deg"}), ("7-iron", {"speed": 38.0, "loft": "28 deg"})):
        impact = fem.strike(club, given, ball="modern", settings=END)
        for model in reduced.LAWS:
            same = reduced.equivalent(impact, model)
            print_figures(
                f"{club}, {model}", error=same.error, longer=same.contact_time / same.reference_contact_time - 1.0
            )
    for name in ("reference", "modern"):
        launch = fem.strike("driver", ball=name, settings=END, speed=45.0).outcome()
        print_figures(f"driver at 45 m/s, {name}", smash=launch["ball_speed"] / 45.0, rpm=launch["backspin"] * RPM)


FACES = (1.85, 2.3, 2.6, 3.2, 4.0)
"""Thicknesses of Roh and Lee's face at its centre [mm]; the edge is thinner by 0.1 mm."""


def heads() -> None:
    """Characteristic time and restitution of faces, and the restitution of a spring with that time."""
    design = from_toml(builtin_path("head", "paper", "fem_heads"))
    assert isinstance(design, fem.DriverHead)
    for centre in FACES:
        walls = {**design.thickness, "face_centre": centre * 1e-3, "face_edge": (centre - 0.1) * 1e-3}
        head = fem.head(replace(design, thickness=walls))
        time = head_tests.characteristic_time(head)
        spring = head.club.replace(characteristic_time=time)
        print_figures(
            f"{centre} mm",
            ct_us=time * 1e6,
            shells=head_tests.restitution(head),
            spring=head_tests.restitution(spring),
            rigid=head_tests.restitution(head.club),
        )


def distance() -> None:
    """Compare the balls `distance` and `modern` by shots of the robot tests."""
    for club in ("driver", "7-iron", "pitching-wedge"):
        for name, friction in (("modern", None), ("distance", None), ("distance", fem.ball("modern").friction)):
            parameters = None if friction is None else {"friction": friction}
            launch = clubface.impact(club, ball_fit.SHOTS[club], model="fem", ball=name, parameters=parameters)
            figures = {key: float(launch.get(key, unit)) for key, unit in
                       (("ball_speed", "mph"), ("launch", "deg"), ("backspin", "rpm"))}  # fmt: skip
            print_figures(f"{club}, {name}" + ("" if friction is None else ", friction of modern"), **figures)


SECTIONS = {
    "reference": the_reference,
    "paper": the_paper,
    "sweep": the_sweep,
    "modern": modern,
    "steps": steps,
    "derivatives": derivatives,
    "models": models,
    "distance": distance,
    "heads": heads,
    "meshes": meshes,
}


def compute(section: str) -> dict[str, dict[str, float]]:
    """Return the figures of a section by what they are of, printed while they are computed."""
    COMPUTED.clear()
    SECTIONS[section]()
    return dict(COMPUTED)


def main() -> None:
    """Compute the sections that are named, or all, and keep them."""
    source = commit()
    for section in sys.argv[1:] or SECTIONS:
        print(f"\n{section}")
        figures = compute(section)
        if section == "meshes":
            rows = [{"thirds": thirds, **row} for thirds, row in zip(THIRDS, figures.values(), strict=True)]
            accuracy.STORED.write_text(json.dumps({"commit": source, "rows": rows}, indent=1) + "\n", encoding="utf-8")
        kept = json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}
        kept[section] = {"commit": source, "figures": figures}
        ordered = {name: kept[name] for name in SECTIONS if name in kept}
        STORED.write_text(json.dumps(ordered, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
