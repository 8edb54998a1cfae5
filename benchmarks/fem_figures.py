"""The figures of the pages in docs/finite-elements, computed again; with names of sections, theirs alone.

They are kept in docs/fem-figures.json, each section with the commit whose code computed it, and a test compares the
pages with that file. The reference case on meshes goes to the package, which quotes it.
"""

import json
import math
import sys
import warnings
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from unittest import mock

import numpy as np
from numpy.typing import NDArray

import clubface
from clubface import fem
from clubface.design import shells
from clubface.design.shells.engine import FastModel
from clubface.equipment.clubs import Club
from clubface.errors import MeshWarning, RangeWarning
from clubface.fem import head_tests, paper, reduced, stress, sweep
from clubface.fem.case import case
from clubface.fem.heads import Group, MeshHead
from clubface.fem.heads.read import from_toml
from clubface.fem.materials import Material, Maxwell
from clubface.fem.pictures import contacts
from clubface.fem.result import Impact, displaced_centre
from clubface.support.files import builtin_path

sys.path.extend(str(Path(__file__).parent.parent / folder) for folder in ("studies", "docs", "docs/figures"))
import ball_fit
import contact_laws
from run import _command as command, commit

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
    for ball in paper.meshes(fem.ball("reference"), THIRDS):
        row = paper.mesh_row(fem.reference(ball=ball, settings=END))
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


def finer_strikers() -> None:
    """Characteristic time by the striker, and by one with a mesh twice as fine."""
    (finer,) = paper.meshes(head_tests.striker(), (6,))
    for name in ("paper", "7-iron"):
        head = fem.head(name)
        usual = head_tests.characteristic_time(head)
        with mock.patch.object(head_tests, "striker", return_value=finer):
            print_figures(name, ct_us=usual * 1e6, finer_us=head_tests.characteristic_time(head) * 1e6)


FACE, WALL = 3.2e-3, 1.2e-3
"""Thickness [m] of the face of the driver of :func:`own_meshes`, and of its other walls."""
OWN_MESHES = {
    "quadrilaterals": ((36, 12, 25), 0),
    "a few triangles": ((36, 12, 25), 4),
    "finer quadrilaterals": ((72, 24, 25), 0),
    "triangles": ((36, 12, 25), None),
}
"""Elements along the edges, and how many of the quadrilaterals are cut into two triangles; None for all."""


def own_meshes() -> None:
    """Face tests of one driver as a mesh of quadrilaterals, of triangles, and of both."""
    design = from_toml(builtin_path("head", "paper", "fem_heads"))
    assert isinstance(design, fem.DriverHead)
    walls = {**dict.fromkeys(design.thickness, WALL), "face_centre": FACE, "face_edge": FACE}
    for what, (along, cut) in OWN_MESHES.items():
        made = replace(design, thickness=walls, elements=along).mesh()
        parts = [part.name for part in made.parts for _ in range(part.elements)]
        inner = np.linspace(0, len(parts) - 1, (cut or 0) + 2).astype(int)[1:-1]
        divided = set(range(len(parts)) if cut is None else inner.tolist())
        elements = []
        for number, (name, quad) in enumerate(zip(parts, made.quads, strict=True)):
            elements += [(name, each) for each in ([quad[:3], quad[[0, 2, 3]]] if number in divided else [quad])]
        with TemporaryDirectory() as folder:
            file = Path(folder) / "head.inp"
            file.write_text(abaqus(made.nodes, elements))
            groups = tuple(
                Group(name=part.name, thickness=FACE if part.face else WALL, face=part.face) for part in made.parts
            )
            face: dict[str, Any] = {key: design.shape[key] for key in ("loft", "bulge", "roll")}
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", MeshWarning)
                head = MeshHead(name=what, file=file, unit="m", groups=groups, **face).mesh()
        print_figures(
            what,
            triangles=sum(len(each) == 3 for _, each in elements),
            quadrilaterals=sum(len(each) == 4 for _, each in elements),
            elements=head.elements,
            mass_g=head.club.mass * 1e3,
            restitution=head_tests.restitution(head),
            ct_us=head_tests.characteristic_time(head) * 1e6,
        )


OWN_IRON = {
    "loft": "30 deg", "length": "78 mm", "heel_height": "36 mm", "toe_height": "46 mm", "face": "5 mm", "sole": "16 mm",
    "top": "9 mm", "rim": 0.25, "rounding": "3 mm",
}  # fmt: skip
"""The cavity-back iron of the page."""
SIX = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))
"""Corners of the six tetrahedra that a hexahedron is cut into."""


def solid_meshes() -> None:
    """One iron of hexahedra, of tetrahedra, and with the front half of its blade bonded on, under one strike."""

    def strike(what: str, head: fem.MeshedHead) -> None:
        run = fem.strike(head, settings=END, speed="38 m/s", loft="30 deg", friction=0.3)
        print_figures(what, elements=head.elements, speed=run.normal_velocity, backspin=run.backspin * RPM,
                      steps=run.steps, seconds=run.wall)  # fmt: skip

    def own(nodes: NDArray[Any], groups: dict[str, NDArray[Any]], *bonds: fem.Bond) -> fem.MeshedHead:
        lines = ["*NODE", *(f"{number}, {x:.9g}, {y:.9g}, {z:.9g}" for number, (x, y, z) in enumerate(nodes, 1))]
        number = 0
        for name, elements in groups.items():
            lines.append(f"*ELEMENT, TYPE=C3D{elements.shape[1]}, ELSET={name}")
            for row in elements.tolist():
                number += 1
                lines.append(", ".join(map(str, (number, *(corner + 1 for corner in row)))))
        metal = {"youngs": 193e9, "poisson": 0.29, "density": 7800.0}
        parts = tuple(Group(name=name, metal=metal, face=place == 0) for place, name in enumerate(groups))
        with TemporaryDirectory() as folder, warnings.catch_warnings():
            warnings.simplefilter("ignore", MeshWarning)
            file = Path(folder) / "head.inp"
            file.write_text("\n".join([*lines, ""]))
            return MeshHead(name="iron", file=file, unit="m", loft=math.radians(30.0), groups=parts, bonds=bonds).mesh()

    for elements in ((20, 12, 2), (40, 24, 4)):
        made = fem.IronHead(name="iron", shape=OWN_IRON, elements=elements).mesh()
        strike(f"{made.elements} hexahedra", made)
    made = fem.IronHead(name="iron", shape=OWN_IRON, elements=(20, 12, 2)).mesh()
    strike("tetrahedra", own(made.nodes, {"head": made.hexahedra[:, SIX].reshape(-1, 4)}))
    # The front layer as a part with nodes of its own.
    front = np.arange(made.elements) >= made.elements // 2
    used, places = np.unique(made.hexahedra[front], return_inverse=True)
    plate = (len(made.nodes) + places).reshape(-1, 8)[:, SIX].reshape(-1, 4)
    nodes = np.concatenate([made.nodes, made.nodes[used]])
    strike("bonded", own(nodes, {"face": plate, "body": made.hexahedra[~front]}, fem.Bond(part="face", to="body")))


def abaqus(nodes: NDArray[Any], elements: list[tuple[str, NDArray[Any]]]) -> str:
    """Return a mesh of named triangles and quadrilaterals as an Abaqus deck."""
    lines = ["*NODE", *(f"{number}, {x:.9g}, {y:.9g}, {z:.9g}" for number, (x, y, z) in enumerate(nodes, 1))]
    for number, (name, corners) in enumerate(elements, 1):
        lines.append(f"*ELEMENT, TYPE=S{len(corners)}, ELSET={name}")
        lines.append(", ".join(map(str, (number, *(corner + 1 for corner in corners)))))
    return "\n".join(lines) + "\n"


MESHES_OF_IRON = ((32, 20, 2), (48, 30, 3), (64, 40, 4))


def stresses() -> None:
    """Stresses of a face in a hard impact, on the meshes of the page."""
    iron = from_toml(builtin_path("head", "7-iron", "fem_heads"))
    assert isinstance(iron, fem.IronHead)
    centres: list[float] = []

    def keep(run: Impact) -> Impact:
        assert run.head_fields is not None
        centres.append(float(run.head_fields.von_mises.max()) * 1e-6)
        return run

    with mock.patch.object(stress, "strike", lambda *given, **more: keep(fem.strike(*given, **more))):
        for elements in MESHES_OF_IRON:
            (part,) = stress.peak_stress(replace(iron, elements=elements), speed="95 mph")
            print_figures(" × ".join(map(str, elements)), centre_mpa=centres[-1], surface_mpa=part.stress * 1e-6)
    (part,) = stress.peak_stress("7-iron", speed="95 mph", meshes=3)
    print_figures("7-iron, three meshes", spread=part.spread or 0.0)
    parts = {part.part: part for part in stress.peak_stress("paper", speed="50 m/s")}
    print_figures("paper at 50 m/s", face_mpa=parts["face"].stress * 1e-6)


EARLIER = {
    "core": Material(
        law="mooney-rivlin",
        constants={"c10": 6.75e6, "c01": 0.5e6},
        poisson=0.49,
        maxwell=(Maxwell(modulus=0.597, time=58.5e-6),),
    ),
    "cover": Material.linear(237e6, 0.43, density=950.0, maxwell=[Maxwell(modulus=2.55, time=3.2e-6)]),
}
"""The materials of an earlier ball `modern`, which OpenRadioss was given."""
RADIOSS = {
    "Roh and Lee": (50.16, 10.13, 1948, 6840, 264),
    "rigid head": (48.85, 9.73, 1899, 6804, 220),
    "yielding face": (65.33, 10.19, 3121, 9113, 264),
    "plane, earlier modern": (35.82, 25.45, 8709, 11761, 212),
    "plane, reference": (32.60, 10.26, 1252, 8757, 280),
}
"""What OpenRadioss found: speed [m/s], launch angle [deg], backspin [rpm], peak force [N] and its time [us]."""
RADIOSS_REVERSAL = {"Roh and Lee": 305, "yielding face": 284}
"""When the force along the face reverses [us], by OpenRadioss."""


def openradioss() -> None:
    """The cases that were run in OpenRadioss too."""
    modern = fem.ball("modern")
    earlier = replace(
        modern,
        pieces=tuple(replace(piece, material=EARLIER[piece.name]) for piece in modern.pieces),
    )
    head = fem.head("paper")
    assert isinstance(head, fem.ShellHead)
    yielding = replace(
        head,
        parts=tuple(
            replace(part, metal=replace(part.metal, yield_stress=500e6)) if part.face else part for part in head.parts
        ),
    )
    fast = case("paper").replace(speed=50.0)
    runs = {
        "Roh and Lee": case("paper").run(),
        "rigid head": case("paper-rigid").replace(club=assumed_head()).run(),
        "yielding face": fast.replace(club=yielding).run(),
        "plane, earlier modern": fem.throw(earlier, speed=50.0, angle="30 deg", friction=0.3, settings=END),
        "plane, reference": fem.reference(settings=END),
    }
    for name, run in runs.items():
        if name.startswith("plane"):
            row = paper.mesh_row(run)
            launch = {key: row[key] for key in ("ball_speed_mps", "angle_deg", "backspin_rpm")}
        else:
            outcome = run.outcome()
            launch = {
                "ball_speed_mps": outcome["ball_speed"],
                "angle_deg": math.degrees(outcome["launch"]),
                "backspin_rpm": outcome["backspin"] * RPM,
            }
        others: dict[str, float] = dict(zip(("speed", "angle", "spin", "peak", "at"), RADIOSS[name], strict=True))
        if name in RADIOSS_REVERSAL:
            others["reversal"] = RADIOSS_REVERSAL[name]
        print_figures(
            name,
            **launch,
            peak_n=run.peak_force,
            at_us=run.peak_force_time * 1e6,
            reversal_us=run.reversal_time * 1e6,
            **{f"radioss_{key}": value for key, value in others.items()},
        )
    print_figures("elastic face", ball_speed_mps=fast.run().outcome()["ball_speed"])


def design() -> None:
    """The example of a better head, and what the fast model makes of its start; two minutes of one core."""
    example = Path(__file__).parent.parent / "examples" / "faster_face.toml"
    with TemporaryDirectory() as folder:
        head = Path(folder) / "faster.toml"
        designed = command(f"clubface fem design {example} -o {head}")
        shot = command(f'clubface shot {head} --speed "100 mph" --model response,fem')
    best = {row["quantity"]: row["best"] for row in designed.document["tables"]["best"]["rows"]}
    print_figures(
        "best head",
        start_mph=designed("start", "mph", table="best", quantity="ball_speed"),
        mph=designed("best", "mph", table="best", quantity="ball_speed"),
        ct_us=best["characteristic_time"],
        face_centre_mm=best["thickness.face_centre"],
        face_edge_mm=best["thickness.face_edge"],
        designs=len(designed.document["tables"]["designs"]["rows"]),
        runs=designed("runs"),
    )
    for row in designed.document["tables"]["metals"]["rows"]:
        print_figures(row["metal"], mph=clubface.units.from_si(row["ball_speed_mps"], "mph"))
    print_figures("shot", **{model: shot("ball_speed", "mph", model=model) for model in ("response", "fem")})
    study = shells.read(example)
    metal = next(each for each in study.choices if each.name == designed("metal"))
    promised = FastModel(study)(study.at(study.start(), metal))
    for quantity in ("characteristic_time", "stress"):
        unit = {"characteristic_time": "us", "stress": "MPa"}[quantity]
        start = designed("start", unit, table="limits", metal=metal.name, quantity=quantity)
        print_figures(
            f"fast model at the start, {quantity}", short=1.0 - clubface.units.from_si(promised[quantity], unit) / start
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


def contact_models() -> None:
    """Roh and Lee's case by finite elements and by the contact models, with the signs of friction that drives up."""
    impact = case("paper").run()
    contact = impact.contact
    courses = {"fem": (contact["time"], contact["normal"], contact["tangential"], impact.contact_time)}
    shorter = {"fem": impact.contraction}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RangeWarning)
        for name, over in contacts(impact).items():
            courses[name] = (over.time, over.normal_force, -np.asarray(over.force_y), over.time[-1])
            shorter[name] = float(np.max(over.penetration)) / (0.5 * impact.ball.diameter)
    for name, (time, normal, along, last) in courses.items():
        reversal = time[np.flatnonzero((along[1:] < 0.0) & (along[:-1] >= 0.0))]
        print_figures(
            name,
            contact_us=last * 1e6,
            peak=normal.max(),
            forward=along.max(),
            back=along.min(),
            forward_us=time[along.argmax()] * 1e6,
            shorter=shorter[name],
            **({"reversal_us": reversal[0] * 1e6} if len(reversal) else {}),
        )


def area_figures(impact: Impact, term: reduced.AreaTerm) -> dict[str, float]:
    """Return the figures of the area term of one impact, with the greatest area over that of the law."""
    deepest = int(term.sinking.argmax())
    law = math.pi * 0.5 * impact.ball.diameter * term.sinking[deepest]
    return {
        "friction": impact.friction,
        "sliding": term.sliding,
        "eta": term.damping,
        "explained": term.explained,
        "free_mu": term.free_friction,
        "free_eta": term.free_damping,
        "free_explained": term.free_explained,
        "area": term.area[deepest] / law,
    }


def area_terms() -> None:
    """Arakawa's area term of impacts without one, and how far the mass centre of the ball `reference` moves."""
    for name, (impact, term) in contact_laws.area_terms().items():
        print_figures(name, **area_figures(impact, term))
    for friction in contact_laws.FRICTIONS:
        for angle in contact_laws.ANGLES:
            impact = fem.throw("reference", speed=35.0, angle=math.radians(angle), friction=friction, settings=END)
            moved = {f"moved_{key}_mm": value * 1e3 for key, value in displaced_centre(impact)._asdict().items()}
            figures = area_figures(impact, reduced.area_term(impact))
            print_figures(f"reference, {friction:g}, {angle:g}°", **figures, **moved)
    (fine,) = paper.meshes(fem.ball("reference"), (6,))
    impact = fem.reference(ball=fine, settings=END)
    print_figures("reference, 76032 elements", **area_figures(impact, reduced.area_term(impact)))


def displaced_centres() -> None:
    """The displaced mass centre [mm] by club, loft and speed."""
    for name, curve in contact_laws.displacements().items():
        for speed, displacement in curve.items():
            print_figures(
                f"{name}, {speed:g} m/s", **{key: value * 1e3 for key, value in displacement._asdict().items()}
            )
    for club in contact_laws.MEAN:
        speed, displacement = contact_laws.published(club)
        figures = {key: value * 1e3 for key, value in displacement._asdict().items()}
        print_figures(f"{club}, published", speed=speed, **figures)


SECTIONS = {
    "reference": the_reference,
    "paper": the_paper,
    "sweep": the_sweep,
    "modern": modern,
    "steps": steps,
    "derivatives": derivatives,
    "models": models,
    "design": design,
    "distance": distance,
    "heads": heads,
    "meshes": meshes,
    "finer strikers": finer_strikers,
    "own meshes": own_meshes,
    "solid meshes": solid_meshes,
    "stresses": stresses,
    "OpenRadioss": openradioss,
    "contact models": contact_models,
    "area terms": area_terms,
    "displaced centres": displaced_centres,
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
            paper.STORED.write_text(json.dumps({"commit": source, "rows": rows}, indent=1) + "\n", encoding="utf-8")
        kept = json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}
        kept[section] = {"commit": source, "figures": figures}
        ordered = {name: kept[name] for name in SECTIONS if name in kept}
        STORED.write_text(json.dumps(ordered, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
