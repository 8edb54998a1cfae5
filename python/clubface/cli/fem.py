"""``clubface fem``: finite element impacts of meshed balls and heads."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clubface.cli import options, show
from clubface.cli.failures import Interrupted, print_note, print_written
from clubface.cli.fem_heads import ball as report_ball, design, face as report_face, head as report_head
from clubface.cli.output import progress_bar, run_with_progress
from clubface.errors import InputError, RunError, Wording
from clubface.support.checks import check_choice
from clubface.support.files import prepared_folder
from clubface.units import fixed

if TYPE_CHECKING:
    from clubface.fem.case import Case
    from clubface.fem.result import Impact
    from clubface.results.result import Result

app = typer.Typer(
    add_completion=False,
    no_args_is_help=True,
    help="Finite elements: impacts of meshed balls and heads, and better heads.",
)
app.command("ball")(report_ball)
app.command("head")(report_head)
app.command("face")(report_face)
app.command("design")(design)

Friction = Annotated[float, typer.Option("--friction", metavar="NUMBER", help="Coefficient of friction.")]
Refine = Annotated[
    int, typer.Option("--refine", metavar="TIMES", help="How many times finer the mesh is along every edge, 1 to 8.")
]
BallOption = Annotated[str, typer.Option("--ball", metavar="NAME|FILE", help="A ball made of pieces.")]
MOVING = 81
"""Pictures of an animation."""
SPEEDS, LOFTS = "30:60:5", "8:12:1"
"""Of Fig. 8 of Roh and Lee."""


@app.command("reference")
def reference(
    friction: Friction = 0.35,
    refine: Refine = 1,
    element: Annotated[
        str, typer.Option("--element", metavar="one-point|full", help="Kind of elements.")
    ] = "one-point",
    ball: BallOption = "reference",
    contact: Annotated[
        str,
        typer.Option("--contact", metavar="penalty|augmented-lagrange", help="How nodes are kept out of the plane."),
    ] = "penalty",
    as_json: options.Json = False,
) -> None:
    """Throw the ball of Roh and Lee at a rigid plane, the case on which solvers are compared."""
    from clubface import fem
    from clubface.fem.impact_result import reference_result

    settings = fem.Settings(contact=contact)
    impact = run_with_progress(
        lambda progress: fem.reference(
            ball=ball, friction=friction, refine=refine, element=element, settings=settings, progress=progress
        )
    )
    # What other solvers gave is known of this case alone.
    result = reference_result(impact, published=friction == 0.35 and ball == "reference")
    show.Output(as_json).show(result)
    _end(impact)


@app.command("run")
def run(
    case: Annotated[str, typer.Argument(metavar="CASE", help="A built-in case, or a TOML file.")],
    folder: options.Folder = None,
    frames: Annotated[
        int | None,
        typer.Option(
            "--frames", metavar="NUMBER", help="Number of deformed shapes to keep; that of the case unless given."
        ),
    ] = None,
    animate: Annotated[
        bool, typer.Option("--animate", help="With --output: also write a moving picture (GIF).")
    ] = False,
    report: options.Report = None,
    as_json: options.Json = False,
) -> None:
    """Run a case: ball, head, delivery and settings in one TOML file."""
    from clubface.fem import case as cases
    from clubface.fem.impact_result import impact_result

    output = show.Output.check({"as_json": as_json, "report": report}, [case])
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
    finally:  # what took long is shown even where a disk is full
        output.show(result, more=written)
    _end(impact)


@app.command("paper")
def paper(
    case: Annotated[str, typer.Option("--case", metavar="NAME|FILE", help="A variation of the case.")] = "paper",
    folder: options.Folder = None,
    swept: Annotated[
        bool, typer.Option("--sweep/--no-sweep", help="With --output: also redraw Fig. 8, which takes 35 runs.")
    ] = True,
    as_json: options.Json = False,
) -> None:
    """Run the case of Roh and Lee by both methods of contact; compare with their figures; --output redraws them."""
    from clubface.fem import case as cases, paper as published
    from clubface.fem.impact_result import paper_result

    chosen = cases.case(case)
    if folder is not None:
        prepared_folder(folder)
    runs = run_with_progress(lambda progress: published.by_contact(chosen, progress))
    result = paper_result(runs)
    written: list[Path] = []
    try:
        written = _write(result, folder)
    finally:
        show.Output(as_json).show(result, more=written)
    for impact in runs.values():
        _end(impact)
    if folder is not None and swept:
        _, written = _sweep(chosen, SPEEDS, LOFTS, folder, published=True)
        print_written(written)


@app.command("sweep")
def sweep(
    speed: Annotated[str, typer.Option("--speed", metavar="FIRST:LAST:STEP", help="Clubhead speeds, m/s.")] = SPEEDS,
    loft: Annotated[str, typer.Option("--loft", metavar="FIRST:LAST:STEP", help="Lofts, deg.")] = LOFTS,
    case: Annotated[str, typer.Option("--case", metavar="NAME|FILE", help="The case that is varied.")] = "paper",
    folder: options.Folder = None,
    workers: Annotated[
        int | None, typer.Option("--workers", help="Number of runs at a time; all cores unless given.")
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Run a case over speeds and lofts, one run on each core; with --output it can be resumed."""
    from clubface.fem import case as cases

    result, written = _sweep(cases.case(case), speed, loft, folder, workers=workers, published=case == "paper")
    show.Output(as_json).show(result, more=written)


@app.command("export")
def export(
    case: Annotated[str, typer.Argument(metavar="CASE", help="A built-in case, or a TOML file.")] = "paper",
    form: Annotated[
        str, typer.Option("--format", metavar="lsdyna|vtu", help="lsdyna writes a keyword deck, vtu shapes over time.")
    ] = "vtu",
    folder: Annotated[str, typer.Option("--output", "-o", metavar="FOLDER", help="Write to this folder.")] = "out",
) -> None:
    """Write a case as a keyword deck, or run it and write its shapes for ParaView."""
    from clubface.fem import case as cases, files, keyword

    check_choice("--format", form, ("lsdyna", "vtu"))
    chosen = cases.case(case)
    target = prepared_folder(folder)
    if form == "lsdyna":
        print_written([keyword.write(chosen, target / f"{files.file_stem(chosen.name)}.k")])
        return
    impact = run_with_progress(chosen.replace(settings={"frames": chosen.settings.frames or 51, "fields": True}).run)
    print_written(files.write_series(impact, target, chosen.name)[-1:])
    _end(impact)


def _sweep(
    base: Case, speed: str, loft: str, folder: str | None, *, workers: int | None = None, published: bool
) -> tuple[Result, list[Path]]:
    """Run a case over a grid; return the result, and with a folder the files written there."""
    from clubface.fem import sweep as sweeps

    speeds, lofts = sweeps.grid(speed, "speed", "--speed"), sweeps.grid(loft, "angle", "--loft")
    target = prepared_folder(folder) / "sweep.csv" if folder is not None else None
    with progress_bar("runs") as progress:
        rows = sweeps.sweep(base, speeds=speeds, lofts=lofts, output=target, workers=workers, progress=progress)
    result = sweeps.sweep_result(rows, published=published)
    return result, [] if target is None else [target, show.save_picture(result, target.with_suffix(".png"))]


def _write(result: Result, folder: str | None) -> list[Path]:
    """Write figures, histories and pictures to a folder where one is given."""
    if folder is None:
        return []
    from clubface.present.drawing import draw
    from clubface.present.files import write_json, write_table
    from clubface.present.style import save

    target = prepared_folder(folder)
    result = result.replace(provenance=result.provenance.with_files())
    written = [write_json(result, target / "figures.json")]
    written += [write_table(each, target / f"{each.name}.csv") for each in result.tables]
    return written + [save(draw(each), target / f"{each.name}.png") for each in result.pictures()]


def _end(impact: Impact) -> None:
    """When all that a run has is printed and written: say why there is no launch, if there is none."""
    if impact.interrupted:
        raise Interrupted(f"interrupted at {fixed(impact.contact['time'][-1:].sum(), 'us', 0)} of the impact")
    if impact.unfinished:  # as long as was asked for
        print_note(str(impact.stopped))
    elif impact.stopped:
        raise RunError(impact.stopped)
