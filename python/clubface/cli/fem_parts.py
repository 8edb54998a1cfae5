"""``clubface fem ball``, ``head`` and ``face``: what a run is made of, and how a head rebounds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import option_values, options, output
from clubface.cli.failures import say, say_written
from clubface.cli.progress import progress_bar, run_with_progress
from clubface.cli.tables import print_numbers
from clubface.errors import ClubfaceError, InputError
from clubface.support.folders import prepared_folder
from clubface.units import from_si

if TYPE_CHECKING:
    from clubface.fem.stress import BlowStress

RULES = {"mass": 0.04593, "diameter": 0.04267}
"""Most a ball may weigh [kg], least it may measure [m]: The Equipment Rules."""


def ball(
    name: Annotated[str, typer.Argument(metavar="NAME|FILE", help="A ball made of pieces.")],
    as_json: options.Json = False,
) -> None:
    """Mesh a ball and report mass, diameter and inertia beside what was asked for and the rules."""
    from clubface import fem

    made = fem.ball(name)
    found = made.properties()
    solid = 0.4 * found["mass"] * found["radius"] ** 2
    document: dict[str, Any] = {
        "name": made.name,
        "mass_kg": found["mass"],
        "diameter_m": 2.0 * found["radius"],
        "inertia_kgm2": found["inertia"],
        "inertia_over_homogeneous": found["inertia"] / solid,
        "core_density_kgm3": found["core_density"],
        "elements": found["elements"],
        "nodes": found["nodes"],
        "conforms": found["mass"] <= RULES["mass"] and 2.0 * found["radius"] >= RULES["diameter"],
    }
    if as_json:
        output.print_json(document)
        return

    asked = "" if made.mass is None else output.number(from_si(made.mass, "g"), 2)
    rows = [
        ["mass, g", output.number(from_si(found["mass"], "g"), 2), asked, "45.93 at most"],
        [
            "diameter, mm",
            output.number(2e3 * found["radius"], 2),
            output.number(1e3 * made.diameter, 2),
            "42.67 at least",
        ],
        ["inertia, g cm2", output.number(from_si(found["inertia"], "g cm2"), 2), "", ""],
        ["inertia over homogeneous", output.number(document["inertia_over_homogeneous"], 4), "", ""],
        ["density of the core, kg/m3", output.number(found["core_density"], 0), "", ""],
        ["elements", str(found["elements"]), "", ""],
    ]
    print_numbers(("", "meshed", "asked for", "rule"), rows, title=made.description or made.name)


def head(
    name: Annotated[str, typer.Argument(metavar="NAME|FILE", help="A meshed head.")],
    measure: Annotated[
        bool, typer.Option("--measure", help="Also simulate restitution and characteristic time; takes seconds.")
    ] = False,
    blow: Annotated[
        str | None,
        options.option("--blow", metavar='"125 mph"', text="Also simulate a blow: stress beside where it yields."),
    ] = None,
    toe: Annotated[
        str | None, options.option("--toe", metavar='"8 mm"', text="With these two: where, to the toe.")
    ] = None,
    high: Annotated[
        str | None, options.option("--high", metavar='"3 mm"', text="With these two: where, above the face centre.")
    ] = None,
    ball: Annotated[
        str | None, options.option("--ball", metavar="NAME|FILE", text="With these two: the ball; modern unless given.")
    ] = None,
    safety: Annotated[
        float | None,
        options.option("--safety", metavar="SHARE", text="With these two: the time step over the stable one."),
    ] = None,
    meshes: Annotated[
        int,
        typer.Option(
            "--meshes",
            metavar="COUNT",
            min=1,
            max=3,
            help="With --blow: on how many meshes, to see how far the stress depends on them; 3 unless given.",
        ),
    ] = 3,
    report: options.Report = None,
    as_json: options.Json = False,
) -> None:
    """Mesh a head and report mass, CG, inertia, how it was tuned and, if wanted, how it rebounds and what it bears."""
    from clubface import fem
    from clubface.fem import head_tests, stress

    output.check_report(report, (name,))
    made = fem.head(name)
    asked = dict(made.asked) if isinstance(made, fem.ShellHead) else {}
    document: dict[str, Any] = {
        "name": made.name,
        "elements": made.elements,
        "mass_kg": made.club.mass,
        "cg_m": list(made.club.cg),
        "inertia_kgm2": [list(row) for row in made.club.inertia],
        "tuning": dict(made.report),
        "asked": asked,
    }
    lengths = {"--toe": toe, "--high": high}
    place: dict[str, Any] = {
        name[2:]: option_values.parsed(name, text, "length") for name, text in lengths.items() if text is not None
    }
    if not measure and blow is None and (place or safety is not None or ball is not None):
        raise ClubfaceError("--toe, --high, --ball and --safety say how to measure; add --measure or --blow")
    struck: stress.BlowStress | None = None
    speed = None if blow is None else option_values.parsed("--blow", blow, "speed")
    if speed is not None and not speed > 0.0:
        raise InputError("--blow", blow, "above 0 m/s")
    if measure:
        document |= run_with_progress(
            lambda progress: {
                "restitution": head_tests.restitution(made, which=ball, **place, safety=safety, progress=progress),
                "characteristic_time_s": head_tests.characteristic_time(
                    made, **place, safety=safety, progress=progress
                ),
            }
        )
    if speed is not None:
        how: dict[str, Any] = {"which": ball, "speed": speed, **place, "safety": safety, "meshes": meshes}
        blown = struck = run_with_progress(lambda progress: stress.blow_stress(name, **how, progress=progress))
        document["stress"] = [
            {
                "part": part.part,
                "stress_pa": part.stress,
                "time_s": part.time,
                "place_m": list(part.place),
                "yield_pa": part.yield_stress,
                "margin": part.margin,
                "meshes": [{"elements": elements, "stress_pa": most} for elements, most in part.by_mesh],
                "spread": part.spread,
            }
            for part in blown.parts
        ]
    if report is not None:
        from clubface.cli.fem_report import write_head

        options_given = {"blow": blow, "toe": toe, "high": high, "ball": ball, "time step over the stable one": safety}
        told = {each: str(value) for each, value in options_given.items() if value is not None}
        write_head(report, made, name, document, struck, told, lambda: _print_head(made, document, struck, blow))
    if as_json:
        output.print_json(document)
    else:
        _print_head(made, document, struck, blow)
    say_written([] if report is None else [report])


def _print_head(made: Any, document: Mapping[str, Any], struck: BlowStress | None, blow: str | None) -> None:
    club, asked = made.club, document["asked"]

    def row(label: str, unit: str, digits: int, value: float, target: str) -> list[str]:
        wanted = output.number(from_si(asked[target], unit), digits) if target in asked else ""
        return [f"{label}, {unit}", output.number(from_si(value, unit), digits), wanted]

    rows = [row("mass", "g", 2, club.mass, "mass")]
    cg, moments = zip("xyz", club.cg, strict=True), zip("xyz", (club.ixx, club.iyy, club.izz), strict=True)
    rows += [row(f"CG to face centre, {axis}", "mm", 2, value, f"cg_{axis}") for axis, value in cg]
    rows.append(row("CG above face normal", "mm", 2, made.cg_above, "cg_above"))
    rows += [row(f"I{axis}{axis}", "g cm2", 0, value, f"i{axis}{axis}") for axis, value in moments]
    trims = dict(made.report)
    if "scale" in trims:
        rows.append(["walls over design", output.number(trims.pop("scale"), 3), ""])
    rows += [[f"added mass {name}, g", output.number(from_si(mass, "g"), 1), ""] for name, mass in trims.items()]
    rows.append(["elements", str(made.elements), ""])
    if "restitution" in document:
        rows.append(["restitution", output.number(document["restitution"], 3), ""])
        rows.append(["characteristic time, us", output.number(from_si(document["characteristic_time_s"], "us"), 0), ""])
    header = ("", "", "asked for") if asked else ("", "")
    print_numbers(header, [each[: len(header)] for each in rows], title=made.description or made.name)
    if struck is not None:
        print_numbers(
            (
                "",
                "largest stress\nMPa",
                "yields at\nMPa",
                "margin\n%",
                "after\nus",
                "above centre\nmm",
                "to the toe\nmm",
            ),
            [_strength(part) for part in struck.parts],
            title=f"a blow at {blow}",
        )
        _print_meshes(struck)
    if any(target.startswith("cg_") for target in asked):
        output.print_notes([output.HELD])


def _print_meshes(struck: BlowStress) -> None:
    """Print how far the stress depends on the mesh."""
    counts = [elements for elements, _ in struck.parts[0].by_mesh]
    if len(counts) > 1:
        print_numbers(
            ("", *(f"{count} elements\nMPa" for count in counts), "spread\n%"),
            [
                [
                    part.part,
                    *(output.number(from_si(most, "MPa"), 0) for _, most in part.by_mesh),
                    output.number(100.0 * (part.spread or 0.0), 0),
                ]
                for part in struck.parts
            ],
            title="the same by finer meshes",
        )
    output.print_notes(struck.notes())


def _strength(part: Any) -> list[str]:
    """Return a row of the table of stresses."""
    bears = ["not told", ""]
    if part.margin is not None:
        bears = [output.number(from_si(part.yield_stress, "MPa"), 0), output.number(100.0 * part.margin, 0)]
    up, toe = (output.number(from_si(place, "mm"), 1) for place in part.place[1:])
    stress, time = output.number(from_si(part.stress, "MPa"), 0), output.number(from_si(part.time, "us"), 0)
    return [part.part, stress, *bears, time, up, toe]


def face(
    name: Annotated[str, typer.Argument(metavar="NAME|FILE", help="A meshed head.")],
    toe: Annotated[str, typer.Option("--toe", metavar="FIRST:LAST:STEP", help="Points, mm to the toe.")] = "-20:20:10",
    high: Annotated[
        str, typer.Option("--high", metavar="FIRST:LAST:STEP", help="Points, mm above the centre.")
    ] = "-8:8:8",
    ball: Annotated[str, typer.Option("--ball", metavar="NAME|FILE", help="A ball made of pieces.")] = "modern",
    folder: options.Folder = None,
    workers: Annotated[int | None, typer.Option("--workers", help="Points at a time; all cores unless given.")] = None,
    as_json: options.Json = False,
) -> None:
    """Simulate restitution and characteristic time over the face of a head, a point a core."""
    from clubface.fem import face_map, files
    from clubface.fem.sweep import grid

    toes, highs = grid(toe, "length", "--toe"), grid(high, "length", "--high")
    target = None if folder is None else prepared_folder(folder) / "face.csv"
    with progress_bar("points") as progress:
        rows = face_map.face_map(
            name, toes=toes, highs=highs, with_ball=ball, output=target, workers=workers, progress=progress
        )
    written = [] if target is None else [target, files.draw_face(rows, target.with_suffix(".png"))]
    if as_json:
        output.print_json(rows)
    else:
        shown = (("toe_mm", 1), ("high_mm", 1), ("restitution", 3), ("characteristic_time_us", 0))
        heads = ("to the toe\nmm", "above centre\nmm", "restitution", "characteristic\ntime, us")
        print_numbers(heads, [[output.number(row[key], digits) for key, digits in shown] for row in rows])
    for reason in dict.fromkeys(row["stopped"] for row in rows if row["stopped"]):
        say(reason)
    say_written(written)
