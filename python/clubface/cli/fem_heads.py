"""``clubface fem ball``, ``head``, ``face`` and ``design``: what a run is made of, and better heads.

``clubface fem ball``, ``head`` and ``face``: what a run is made of, and how a head rebounds.

``clubface fem design``: a better head of shells, proposed by a fast model and judged by finite elements.

The reports of ``clubface fem head`` and ``clubface fem run``: what a head bears, and what an impact came to.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say, say_written
from clubface.cli.output import print_numbers, progress_bar, run_with_progress
from clubface.errors import ClubfaceError, InputError
from clubface.support.files import builtin_names, builtin_path, path_of, prepared_folder, read_input
from clubface.units import fixed, from_si

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from clubface.design.shells.run import Improved
    from clubface.fem.case import Case
    from clubface.fem.heads import MeshedHead
    from clubface.fem.result import Impact
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
        name[2:]: options.parsed(name, text, "length") for name, text in lengths.items() if text is not None
    }
    if not measure and blow is None and (place or safety is not None or ball is not None):
        raise ClubfaceError("--toe, --high, --ball and --safety say how to measure; add --measure or --blow")
    struck: stress.BlowStress | None = None
    speed = None if blow is None else options.parsed("--blow", blow, "speed")
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
    from clubface.fem import files, head_tests
    from clubface.fem.sweep import grid

    toes, highs = grid(toe, "length", "--toe"), grid(high, "length", "--high")
    target = None if folder is None else prepared_folder(folder) / "face.csv"
    with progress_bar("points") as progress:
        rows = head_tests.face_map(
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


STEPS = ("design", "kind", "promised", "found", "beyond limits", "verdict")
"""Names of the columns of a search whose heads are empty."""
_OUTPUT = options.output("FILE", "Write the best head to this TOML file, which fem head and shot read.")


def design(
    study: Annotated[
        str, typer.Argument(metavar="STUDY", help="A TOML file: head, walls that may change, what is best, limits.")
    ],
    target: Annotated[str | None, _OUTPUT] = None,
    picture: Annotated[str | None, options.picture("every design that was judged")] = None,
    workers: Annotated[int | None, typer.Option("--workers", help="Runs at a time; all cores unless given.")] = None,
    report: options.Report = None,
    resume: options.Resume = False,
    as_json: options.Json = False,
) -> None:
    """Find the walls of a head: a fast model proposes them, finite elements judge ball speed, stress and limits."""
    output.check_target("--output", target, (".toml",), (study,))
    output.check_picture(picture, (study,))
    output.check_report(report, (study,))
    output.check_resume(resume, target)
    from clubface.design import shells
    from clubface.design.shells import report as words

    asked = shells.read(study)
    output.check_not_read(target)
    with progress_bar("designs") as progress:
        found = shells.improve(asked, output=target, resume=resume, workers=workers, progress=progress)
    if target is not None:
        say(f"wrote {target}")
    if picture is not None or report is not None:
        from clubface.design.pictures import search_figure

        figure = search_figure(found)
        if picture is not None:
            from clubface import plots

            say(f"wrote {plots.save(figure, picture)}")
        if report is not None:
            _report(found, study, figure, report)
            say(f"wrote {report}")
    if as_json:
        output.print_json(words.document(found))
    else:
        _print(found)


def _report(found: Improved, study: str, figure: Figure, target: str) -> None:
    from clubface.design.shells import report
    from clubface.fem.heads import driver

    heads, rows = report.steps_table(found.chosen, found.study.objective)
    names = [head.replace("\n", " ") or name for head, name in zip(heads, STEPS, strict=True)]
    reporting.write(
        target, title=found.study.title, words=report.gains(found),
        picture=("Every design that finite elements judged", figure),
        columns={name: [row[place] for row in rows] for place, name in enumerate(names)}, show=lambda: _print(found),
        launches=(), conditions={}, given={"study": Path(study).name, "runs of finite elements": str(found.runs)},
        sources=[f"Metal {each.metal.name}: {each.metal.source}" for each in found.searches if each.metal.source],
        files={"the-best-head.toml": driver.text(found.head)},
    )  # fmt: skip


def _print(found: Improved) -> None:
    from clubface.design.shells import report

    asked = found.study
    print_numbers(*report.design_table(found), title=asked.title)
    print()
    if found.chosen.goal.limits:
        print_numbers(*report.limits_table(found.chosen), title="Limits")
        print()
    if len(found.searches) > 1:
        print_numbers(*report.metals_table(found), title="The best head of each metal")
        print()
    of = f" of {found.chosen.metal.name}" if len(found.searches) > 1 else ""
    print_numbers(*report.steps_table(found.chosen, asked.objective), title=f"Designs{of} that finite elements judged")
    print()
    output.print_notes(report.notes(found))


CONTACT = {"time": "us", "normal": "N", "tangential": "N", "toe": "N", "area": "mm2"}
"""What is saved of the contact, with units."""


def write_head(
    target: str,
    of: MeshedHead,
    file: str,
    told: Mapping[str, Any],
    struck: BlowStress | None,
    given: Mapping[str, str],
    show: Callable[[], None],
) -> None:
    """Write the report of a head from ``file``; ``told`` has what was measured, ``given`` how it was struck."""
    picture, columns = None, {}
    if struck is not None:
        from clubface.fem.section_picture import stress_figure

        parts = struck.parts
        when = fixed(struck.surface.time, "us", 0)
        picture = (
            f"The stress of the surface {when} after first touch, a cross where it is largest; and the largest stress "
            "of every part beside where its metal yields",
            stress_figure(struck, of.loft),
        )
        columns = {
            "part": [part.part for part in parts],
            "largest stress (MPa)": [from_si(part.stress, "MPa") for part in parts],
            "yields at (MPa)": [None if (at := part.yield_stress) is None else from_si(at, "MPa") for part in parts],
            "after (us)": [from_si(part.time, "us") for part in parts],
            **{f"{axis} (mm)": [from_si(part.place[place], "mm") for part in parts]
               for place, axis in enumerate(("to the target", "above the face centre", "to the toe"))},
            **{f"by {elements} elements (MPa)": [from_si(part.by_mesh[k][1], "MPa") for part in parts]
               for k, (elements, _) in enumerate(parts[0].by_mesh)},
        }  # fmt: skip
    path = Path(path_of("head", file, "fem_heads"))
    reporting.write(
        target, title=f"The head {of.name}: {'mass and mesh' if struck is None else 'what it bears'}",
        words=_head_words(of, told, struck, given), picture=picture, columns=columns, show=show, launches=(),
        given={"head": of.name, "elements": str(of.elements), **given}, files=_texts(path),
    )  # fmt: skip


def _texts(path: Path) -> dict[str, str]:
    """Return the text of a description by the name of its file; one that is not shipped is in every report."""
    return {path.name: read_input(path).decode("utf-8-sig", errors="replace")}


def _head_words(
    of: MeshedHead, told: Mapping[str, Any], struck: BlowStress | None, given: Mapping[str, str]
) -> Iterator[str]:
    """Say what a head is, and whether it holds, in sentences."""
    allowed = "; the rules of golf allow a driver 5900 g cm2" * (of.club.kind == "wood")
    yield (
        f"The head weighs {fixed(of.club.mass, 'g', 1)}. Against twisting about the vertical it has a moment of inertia"
        f" of {fixed(of.club.iyy, 'g cm2', 0)}{allowed}."
    )
    if "restitution" in told:
        yield (
            f"Its face gives back {100.0 * told['restitution']:.1f} % of the speed at which a ball meets it. The"
            f" pendulum of the rules touches it for {fixed(told['characteristic_time_s'], 'us', 0)}; the rules allow"
            " a driver 239 us, and 257 us with the tolerance."
        )
    parts = () if struck is None else struck.parts
    known = [(part.margin, part.yield_stress, part) for part in parts if part.margin is not None and part.yield_stress]
    for margin, yields, part in known:
        if margin < 0.0:
            yield (
                f"Struck at {given['blow']}, the {part.part} is too weak: the stress there reaches"
                f" {fixed(part.stress, 'MPa', 0)}, and its metal yields at {fixed(yields, 'MPa', 0)}."
            )
    if known and all(margin >= 0.0 for margin, _, _ in known):
        least, _, part = min(known, key=lambda each: each[0])
        yield (
            f"Struck at {given['blow']}, no part yields. Closest to it is the {part.part}, which could bear"
            f" {100.0 * least:.0f} % more stress."
        )
    if len(known) < len(parts):
        others = ", ".join(part.part for part in parts if part.margin is None)
        yield f"At which stress the metal yields is not told for: {others}."
    if struck is not None:
        peak = max(parts, key=lambda part: part.stress)
        ahead, high, toe = (from_si(place, "mm") for place in peak.place)
        yield (
            f"The largest stress, {fixed(peak.stress, 'MPa', 0)}, is that of the {peak.part},"
            f" {reporting.more_or_less(high, 'mm', ('above', 'below'))} the face centre,"
            f" {reporting.more_or_less(toe, 'mm', ('to the toe', 'to the heel'))} and"
            f" {reporting.more_or_less(ahead, 'mm', ('in front of it', 'behind it'))}."
        )
        if peak.spread is not None:
            counts = " and ".join(f"{elements}" for elements, _ in peak.by_mesh[1:])
            yield f"Meshes of {counts} elements change it by {100.0 * peak.spread:.0f} % at most."
        yield from struck.notes()
        yield "Notches, welds and fatigue over many blows are not counted: a real head needs more than this."


def write_run(target: str, found: Impact, case: Case, file: str, show: Callable[[], None]) -> None:
    """Write the report of one impact, the run of a case from ``file``."""
    from clubface.fem.case import FOLDER
    from clubface.fem.pictures import impact_figure

    picture = None
    if len(found.patch["time"]):
        picture = ("Force, spin, radius of the ball and energies while ball and face touch", impact_figure(found))
    path = Path(path_of("case", file, FOLDER))
    columns = {f"{name} ({unit})": from_si(found.contact[name], unit) for name, unit in CONTACT.items()}
    settings = {
        name.replace("_", " "): f"{fixed(value, 'us', 0)}" if name in ("duration", "interval") else str(value)
        for name, value in case.settings.values().items()
        if value is not None
    }
    files = _texts(path)
    if case.ball.name in builtin_names("balls"):
        (text,) = _texts(builtin_path("ball", case.ball.name, "balls")).values()
        files[f"ball {case.ball.name}.toml"] = text
    reporting.write(
        target, title=f"An impact by finite elements: {case.description or case.name}", words=_run_words(found, case),
        picture=picture, columns=columns,
        show=show, launches=() if found.launch is None else [found.launch],
        given={"case": case.name, "ball": case.ball.name, "head": case.club.name if case.club else "a plane",
               "friction": f"{found.friction:g}", "elements": str(found.elements), **settings},
        conditions={} if found.flown() else None, files=files,
    )  # fmt: skip


def _run_words(found: Impact, case: Case) -> Iterator[str]:
    """Say what came of an impact, in sentences."""
    if found.stopped:
        yield f"There is no launch: {found.stopped}."
        return
    out = found.outcome()
    what = case.club.name if case.club else "a rigid plane"
    if "ball_speed" in out:
        aside = from_si(out["azimuth"], "deg")
        sides = ("to the right", "to the left")
        way = "straight" if abs(aside) < 0.05 else reporting.more_or_less(aside, "degrees", sides)
        yield (
            f"The ball {case.ball.name} leaves {what} at {fixed(out['ball_speed'], 'mph', 1)},"
            f" {from_si(out['launch'], 'deg'):.1f} degrees upwards and {way}, and spins backwards with"
            f" {fixed(out['backspin'], 'rpm', 0)}."
        )
    else:
        yield f"The ball {case.ball.name} leaves {what} and spins with {fixed(out['backspin'], 'rpm', 0)}."
    yield (
        f"They touch for {fixed(found.contact_time, 'us', 0)}, and push each other with up to "
        f"{fixed(found.peak_force, 'kN', 1)}."
    )
    if flown := found.flown():
        yield f"In still air the ball would carry {fixed(flown['carry'], 'yd', 0)}."
    yield f"Energies close to {100.0 * found.energy_error:.2f} %, which is how far the computation can be trusted."
