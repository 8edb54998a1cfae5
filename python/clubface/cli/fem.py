"""``clubface fem``: finite element impacts, balls and heads, tests of heads, and the design of heads."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, show
from clubface.cli.failures import Interrupted, print_note, print_written
from clubface.cli.output import progress_bar, run_with_progress
from clubface.errors import ClubfaceError, InputError, RunError, Wording
from clubface.support.checks import check_choice, check_count
from clubface.support.files import file_stem, prepared_folder
from clubface.units import fixed

if TYPE_CHECKING:
    from clubface.fem.case import Case
    from clubface.fem.result import Impact
    from clubface.results.result import Result

app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Finite elements: impacts of meshed balls and heads, better heads."
)

CaseArgument = Annotated[str, options.argument("CASE", "A built-in case, or a TOML file.")]
HeadArgument = Annotated[str, options.argument("NAME|FILE", "A meshed head.")]
CASE = options.group(None, case=(str, "paper", "NAME|FILE", "The case to vary."))
BALL = "A ball made of pieces."
WORKERS = options.group(None, workers=(int | None, None, "N", "Number of runs at a time; default: all cores."))
REFERENCE = options.group(
    None,
    friction=(float, 0.35, "NUMBER", "Coefficient of friction."),
    refine=(int, 1, "TIMES", "Refinement of the mesh along every edge, 1 to 8."),
    element=(str, "one-point", "one-point|full", "Element type."),
    ball=(str, "reference", "NAME|FILE", BALL),
    contact=(str, "penalty", "penalty|augmented-lagrange", "Contact method."),
    meshes=(int, 1, "COUNT", "Number of meshes, 1 to 6, each with a third more elements along every edge."),
)
MOVING = 81
"""Number of frames in an animation."""
SPEEDS, LOFTS = "30:60:5", "8:12:1"
"""The case of Fig. 8 in Roh and Lee."""
GRID = options.group(
    None,
    speed=(str, SPEEDS, "FIRST:LAST:STEP", "Clubhead speeds, m/s."),
    loft=(str, LOFTS, "FIRST:LAST:STEP", "Lofts, deg."),
)
FACE = options.group(
    None,
    toe=(str, "-20:20:10", "FIRST:LAST:STEP", "Points, mm towards the toe."),
    high=(str, "-8:8:8", "FIRST:LAST:STEP", "Points, mm above the centre."),
    ball=(str, "modern", "NAME|FILE", BALL),
)
TESTS = options.group(
    "Tests",
    measure=(bool, False, None, "Also simulate restitution and characteristic time; takes seconds."),
    impact_speed=(str | None, None, '"125 mph"', "Also simulate an impact: the stress, and where the metal yields."),
    toe=(str | None, None, '"8 mm"', "With --measure or --impact-speed: how far towards the toe."),
    high=(str | None, None, '"3 mm"', "With --measure or --impact-speed: how far above the face centre."),
    ball=(str | None, None, "NAME|FILE", "With --measure or --impact-speed: the ball; default modern."),
    safety=(float | None, None, "SHARE", "With --measure or --impact-speed: time step over the stable one."),
    meshes=(int, 3, "COUNT", "With --impact-speed: number of meshes, 1 to 3, to compare the stress."),
)
OLD_TESTS = {"blow": "impact_speed"}


@app.command("ball")
@options.takes(show.JSON)
def ball(name: Annotated[str, options.argument("NAME|FILE", BALL)], **texts: Any) -> None:
    """Mesh a ball; compare mass, diameter and inertia with the specified values and with the rules."""
    from clubface import fem

    show.Output.check(texts).show(fem.ball(name).to_result())


@app.command("head")
@options.takes(TESTS, show.REPORT, show.JSON, options.renamed(**OLD_TESTS))
def head(name: HeadArgument, **texts: Any) -> None:
    """Mesh a head and report mass, CG, inertia, how it was tuned and, on request, restitution and stress."""
    from clubface import fem
    from clubface.fem import head_tests, stress
    from clubface.fem.head_result import head_result

    options.take_renamed(texts, **OLD_TESTS)
    shown = show.Output.check(texts, [name])
    meshes = check_count("--meshes", texts["meshes"], 1, 3)
    made = fem.head(name)
    given = {name: texts[name] for name in ("impact_speed", "toe", "high", "ball")}
    given["time step over the stable one"] = texts["safety"]
    place: dict[str, Any] = {
        each: options.parsed(f"--{each}", given[each], "length") for each in ("toe", "high") if given[each] is not None
    }
    how: dict[str, Any] = {**place, "ball": texts["ball"], "safety": texts["safety"]}
    if not texts["measure"] and texts["impact_speed"] is None and any(value is not None for value in given.values()):
        raise ClubfaceError("--toe, --high, --ball and --safety need --measure or --impact-speed; add one of them")
    speed = None if texts["impact_speed"] is None else options.parsed("--impact-speed", texts["impact_speed"], "speed")
    if speed is not None and not speed > 0.0:
        raise InputError("--impact-speed", texts["impact_speed"], "above 0 m/s")
    tests, struck = {}, None
    if texts["measure"]:
        tests = run_with_progress(
            lambda progress: {
                "restitution": head_tests.restitution(made, **how, progress=progress),
                "characteristic_time": head_tests.characteristic_time(
                    made, safety=texts["safety"], **place, progress=progress
                ),
            }
        )
    if speed is not None:
        struck = run_with_progress(
            lambda progress: stress.impact_stress(name, speed=speed, **how, meshes=meshes, progress=progress)
        )
    inputs = {each: str(value) for each, value in given.items() if value is not None}
    shown.show(head_result(made, tests=tests, stress=struck, inputs=inputs))


@app.command("face")
@options.takes(FACE, show.FOLDER, WORKERS, show.JSON)
def face(name: HeadArgument, **texts: Any) -> None:
    """Simulate restitution and characteristic time over the face of a head, one point per core."""
    from clubface.fem import head_tests
    from clubface.fem.sweep import grid

    toes, highs = (grid(texts[each], "length", f"--{each}") for each in ("toe", "high"))
    target = None if texts["folder"] is None else prepared_folder(texts["folder"]) / "face.csv"
    with progress_bar("points") as progress:
        rows = head_tests.face_map(
            name, toes=toes, highs=highs, ball=texts["ball"], output=target, workers=texts["workers"],
            progress=progress,
        )  # fmt: skip
    result = head_tests.face_result(rows, name)
    written = [] if target is None else [target, show.save_picture(result, target.with_suffix(".png"))]
    show.Output(texts["as_json"]).show(result, more=written)


@app.command("design")
@options.takes(
    show.table_option("Write the best head to this TOML file, for fem head and shot."),
    show.plot_option("all designs that were computed"), show.REPORT, options.RESUME, WORKERS,
    show.JSON,
)  # fmt: skip
def design(
    study: Annotated[str, options.argument("STUDY", "A TOML file: head, walls that may change, objective, limits.")],
    **texts: Any,
) -> None:
    """Find the best walls of a head: a fast model proposes designs, finite elements check speed, stress and limits."""
    from clubface.design.shells import improve, read

    shown = show.Output.check(texts, (study,), (".toml",))
    output.check_resume(texts["resume"], shown.target)
    asked = read(study)
    output.check_not_read(shown.target)
    how = {name: texts[name] for name in ("resume", "workers")}
    with progress_bar("designs", kept=shown.target) as progress:
        result = improve(asked, output=shown.target, **how, progress=progress)
    shown.show(result.to_result(), write_table=False)


@app.command("reference")
@options.takes(REFERENCE, show.JSON)
def reference(**texts: Any) -> None:
    """Throw the ball of Roh and Lee at a rigid plane, the case used to compare solvers."""
    from clubface import fem
    from clubface.fem.impact_result import reference_result
    from clubface.fem.paper import DEFAULT, meshes

    count = check_count("--meshes", texts["meshes"], 1, 6)
    settings = fem.Settings(contact=texts["contact"])
    how = {name: texts[name] for name in ("ball", "friction", "refine", "element")}
    impact = run_with_progress(lambda progress: fem.reference(**how, settings=settings, progress=progress))
    finer: list[Impact] = []
    if count > 1 and not impact.stopped:
        for each in meshes(fem.ball(how["ball"]), range(DEFAULT + 1, DEFAULT + count)):
            run_finer = partial(fem.reference, **how | {"ball": each}, settings=settings)
            finer.append(run_with_progress(lambda progress, run=run_finer: run(progress=progress)))
    # Results of other solvers are known for this case only.
    published = how["friction"] == 0.35 and how["ball"] == "reference"
    result = reference_result(impact, published=published, finer=finer)
    show.Output.check(texts).show(result)
    _end(impact)


@app.command("run")
@options.takes(
    show.FOLDER,
    options.group(None,
        frames=(int | None, None, "NUMBER", "Number of deformed shapes to keep; default: as in the case."),
        animate=(bool, False, None, "With --output: also write an animation (GIF)."),
    ),
    show.REPORT, show.JSON,
)  # fmt: skip
def run(case: CaseArgument, **texts: Any) -> None:
    """Run a case: ball, head, delivery and settings from one TOML file."""
    from clubface.fem import case as cases
    from clubface.fem.impact_result import impact_result

    folder, frames, animate = (texts.pop(name) for name in ("folder", "frames", "animate"))
    shown = show.Output.check(texts, [case])
    chosen = cases.case(case)
    if animate and folder is None:
        raise InputError("--animate", Wording("without --output"), "give the folder to write to, as in --output out/")
    if frames is not None or (animate and chosen.settings.frames < 2):
        chosen = chosen.replace(settings={"frames": MOVING if frames is None else frames})
    if folder is not None:
        prepared_folder(folder)
    impact = run_with_progress(chosen.run)
    result = impact_result(impact, chosen.name, chosen.description)
    written: list[Path] = []
    try:
        written = _write(result, folder)
        if folder is not None and animate and len(impact.frames) > 1:
            from clubface.fem.section_picture import moving_section
            from clubface.present.drawing import animate as write_animation

            written.append(write_animation(moving_section(impact), Path(folder) / "impact.gif"))
    finally:  # show long computations even if the disk is full
        shown.show(result, more=written)
    _end(impact)


@app.command("paper")
@options.takes(
    CASE, show.FOLDER,
    options.group(None, sweep=(bool, True, None, "With --output: also redraw Fig. 8, which takes 35 runs.")),
    show.JSON,
)  # fmt: skip
def paper(**texts: Any) -> None:
    """Run the case of Roh and Lee with both contact methods; compare with their figures; --output redraws them."""
    from clubface.fem import case as cases, paper as published
    from clubface.fem.impact_result import paper_result

    chosen, folder = cases.case(texts["case"]), texts["folder"]
    if folder is not None:
        prepared_folder(folder)
    runs = run_with_progress(lambda progress: published.by_contact(chosen, progress))
    result = paper_result(runs)
    written: list[Path] = []
    try:
        written = _write(result, folder)
    finally:
        show.Output(texts["as_json"]).show(result, more=written)
    for impact in runs.values():
        _end(impact)
    if folder is not None and texts["sweep"]:
        _, written = _sweep(chosen, SPEEDS, LOFTS, folder, published=True)
        print_written(written)


@app.command("sweep")
@options.takes(GRID, CASE, show.FOLDER, WORKERS, show.JSON)
def sweep(**texts: Any) -> None:
    """Run a case over speeds and lofts, one run per core; with --output it can be resumed.

    To sweep anything else in case, ball and head, use a study of the kind fem: clubface study run STUDY.
    """
    from clubface.fem import case as cases

    case, published = cases.case(texts["case"]), texts["case"] == "paper"
    speed, loft, folder, workers = (texts[name] for name in ("speed", "loft", "folder", "workers"))
    result, written = _sweep(case, speed, loft, folder, workers=workers, published=published)
    show.Output(texts["as_json"]).show(result, more=written)


_FORMATS = "lsdyna writes a keyword deck, vtu deformed shapes over time."


@app.command("export")
def export(
    case: CaseArgument = "paper",
    form: Annotated[str, typer.Option("--format", metavar="lsdyna|vtu", help=_FORMATS)] = "vtu",
    folder: Annotated[str, typer.Option("--output", "-o", metavar="FOLDER", help="Write to this folder.")] = "out",
) -> None:
    """Write a case as a keyword deck, or run it and write its shapes for ParaView."""
    from clubface.fem import case as cases, files, keyword

    check_choice("--format", form, ("lsdyna", "vtu"))
    chosen = cases.case(case)
    target = prepared_folder(folder)
    if form == "lsdyna":
        print_written([keyword.write(chosen, target / f"{file_stem(chosen.name)}.k")])
        return
    impact = run_with_progress(chosen.replace(settings={"frames": chosen.settings.frames or 51, "fields": True}).run)
    print_written(files.write_series(impact, target, chosen.name)[-1:])
    _end(impact)


def _sweep(
    base: Case, speed: str, loft: str, folder: str | None, *, workers: int | None = None, published: bool
) -> tuple[Result, list[Path]]:
    """Run a case over a grid; return the result and the files written to a folder, if one is given."""
    from clubface.fem import sweep as sweeps

    speeds, lofts = sweeps.grid(speed, "speed", "--speed"), sweeps.grid(loft, "angle", "--loft")
    target = prepared_folder(folder) / "sweep.csv" if folder is not None else None
    with progress_bar("runs") as progress:
        rows = sweeps.sweep(base, speeds=speeds, lofts=lofts, output=target, workers=workers, progress=progress)
    result = sweeps.sweep_result(rows, published=published)
    return result, [] if target is None else [target, show.save_picture(result, target.with_suffix(".png"))]


def _write(result: Result, folder: str | None) -> list[Path]:
    """Write figures, histories and pictures to a folder, if one is given."""
    if folder is None:
        return []
    from clubface.present.drawing import draw
    from clubface.present.report import write_json, write_table
    from clubface.present.style import save

    target = prepared_folder(folder)
    result = result.replace(provenance=result.provenance.with_files())
    written = [write_json(result, target / "figures.json")]
    written += [write_table(each, target / f"{each.name}.csv") for each in result.tables]
    return written + [save(draw(each), target / f"{each.name}.png") for each in result.pictures()]


def _end(impact: Impact) -> None:
    """After printing and writing the results of a run, report why there is no launch, if there is none."""
    if impact.interrupted:
        raise Interrupted(f"interrupted at {fixed(impact.contact['time'][-1:].sum(), 'us', 0)} of the impact")
    if impact.unfinished:  # it ran for the requested time
        print_note(str(impact.stopped))
    elif impact.stopped:
        raise RunError(impact.stopped)
