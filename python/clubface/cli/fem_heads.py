"""``clubface fem ball``, ``head``, ``face`` and ``design``: what a run is made of, and better heads."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, reporting, show
from clubface.cli.failures import say
from clubface.cli.output import print_numbers, progress_bar, run_with_progress
from clubface.errors import ClubfaceError, InputError
from clubface.support.files import prepared_folder

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from clubface.design.shells.run import Improved


def ball(
    name: Annotated[str, typer.Argument(metavar="NAME|FILE", help="A ball made of pieces.")],
    as_json: options.Json = False,
) -> None:
    """Mesh a ball and report mass, diameter and inertia beside what was asked for and the rules."""
    from clubface import fem

    show.Output(as_json).show(fem.ball(name).to_result())


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
    from clubface.fem.head_result import head_result

    shown = show.Output.check({"as_json": as_json, "report": report}, [name])
    made = fem.head(name)
    given = {"blow": blow, "toe": toe, "high": high, "ball": ball, "time step over the stable one": safety}
    lengths = {"--toe": toe, "--high": high}
    place: dict[str, Any] = {
        name[2:]: options.parsed(name, text, "length") for name, text in lengths.items() if text is not None
    }
    if not measure and blow is None and (place or safety is not None or ball is not None):
        raise ClubfaceError("--toe, --high, --ball and --safety say how to measure; add --measure or --blow")
    speed = None if blow is None else options.parsed("--blow", blow, "speed")
    if speed is not None and not speed > 0.0:
        raise InputError("--blow", blow, "above 0 m/s")
    tests, struck = {}, None
    if measure:
        tests = run_with_progress(
            lambda progress: {
                "restitution": head_tests.restitution(made, which=ball, **place, safety=safety, progress=progress),
                "characteristic_time": head_tests.characteristic_time(made, **place, safety=safety, progress=progress),
            }
        )
    if speed is not None:
        how: dict[str, Any] = {"which": ball, "speed": speed, **place, "safety": safety, "meshes": meshes}
        struck = run_with_progress(lambda progress: stress.blow_stress(name, **how, progress=progress))
    inputs = {each: str(value) for each, value in given.items() if value is not None}
    shown.show(head_result(made, tests=tests, blow=struck, inputs=inputs))


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
    from clubface.fem import head_tests
    from clubface.fem.sweep import grid

    toes, highs = grid(toe, "length", "--toe"), grid(high, "length", "--high")
    target = None if folder is None else prepared_folder(folder) / "face.csv"
    with progress_bar("points") as progress:
        rows = head_tests.face_map(
            name, toes=toes, highs=highs, with_ball=ball, output=target, workers=workers, progress=progress
        )
    result = head_tests.face_result(rows, name)
    written = [] if target is None else [target, show.save_picture(result, target.with_suffix(".png"))]
    show.Output(as_json).show(result, more=written)


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
