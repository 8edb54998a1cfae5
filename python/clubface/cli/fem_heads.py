"""``clubface fem ball``, ``head``, ``face`` and ``design``: what a run is made of, and better heads."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, output, show
from clubface.cli.output import progress_bar, run_with_progress
from clubface.errors import ClubfaceError, InputError
from clubface.support.files import prepared_folder


def ball(
    name: Annotated[str, typer.Argument(metavar="NAME|FILE", help="A ball made of pieces.")],
    as_json: options.Json = False,
) -> None:
    """Mesh a ball; compare mass, diameter and inertia with what was asked for and with the rules."""
    from clubface import fem

    show.Output(as_json).show(fem.ball(name).to_result())


def head(
    name: Annotated[str, typer.Argument(metavar="NAME|FILE", help="A meshed head.")],
    measure: Annotated[
        bool, typer.Option("--measure", help="Also simulate restitution and characteristic time; takes seconds.")
    ] = False,
    blow: Annotated[
        str | None,
        options.option(
            "--blow", metavar='"125 mph"', text="Also simulate a blow: the stress, and where the metal yields."
        ),
    ] = None,
    toe: Annotated[
        str | None, options.option("--toe", metavar='"8 mm"', text="With --measure or --blow: how far towards the toe.")
    ] = None,
    high: Annotated[
        str | None,
        options.option("--high", metavar='"3 mm"', text="With --measure or --blow: how far above the face centre."),
    ] = None,
    ball: Annotated[
        str | None,
        options.option("--ball", metavar="NAME|FILE", text="With --measure or --blow: the ball; modern unless given."),
    ] = None,
    safety: Annotated[
        float | None,
        options.option(
            "--safety", metavar="SHARE", text="With --measure or --blow: the time step over the stable one."
        ),
    ] = None,
    meshes: Annotated[
        int,
        typer.Option(
            "--meshes",
            metavar="COUNT",
            min=1,
            max=3,
            help="With --blow: number of meshes, to see how far the stress depends on the mesh; 3 unless given.",
        ),
    ] = 3,
    report: options.Report = None,
    as_json: options.Json = False,
) -> None:
    """Mesh a head and report mass, CG, inertia, how it was tuned and, on request, restitution and stress."""
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
                "restitution": head_tests.restitution(made, ball=ball, **place, safety=safety, progress=progress),
                "characteristic_time": head_tests.characteristic_time(made, **place, safety=safety, progress=progress),
            }
        )
    if speed is not None:
        how: dict[str, Any] = {"ball": ball, "speed": speed, **place, "safety": safety, "meshes": meshes}
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
    """Simulate restitution and characteristic time over the face of a head, one point on each core."""
    from clubface.fem import head_tests
    from clubface.fem.sweep import grid

    toes, highs = grid(toe, "length", "--toe"), grid(high, "length", "--high")
    target = None if folder is None else prepared_folder(folder) / "face.csv"
    with progress_bar("points") as progress:
        rows = head_tests.face_map(
            name, toes=toes, highs=highs, ball=ball, output=target, workers=workers, progress=progress
        )
    result = head_tests.face_result(rows, name)
    written = [] if target is None else [target, show.save_picture(result, target.with_suffix(".png"))]
    show.Output(as_json).show(result, more=written)


@options.takes(
    show.table_option("Write the best head to this TOML file, which fem head and shot read."),
    show.plot_option("every design that was judged"), show.REPORT, {"resume": (options.Resume, False)}, show.JSON,
)  # fmt: skip
def design(
    study: Annotated[
        str, typer.Argument(metavar="STUDY", help="A TOML file: head, walls that may change, what is best, limits.")
    ],
    workers: Annotated[int | None, typer.Option("--workers", help="Runs at a time; all cores unless given.")] = None,
    **texts: Any,
) -> None:
    """Find the walls of a head: a fast model proposes them, finite elements judge ball speed, stress and limits."""
    from clubface.design.shells import improve, read

    shown = show.Output.check(texts, (study,), (".toml",))
    output.check_resume(texts["resume"], shown.target)
    asked = read(study)
    output.check_not_read(shown.target)
    with progress_bar("designs") as progress:
        result = improve(asked, output=shown.target, resume=texts["resume"], workers=workers, progress=progress)
    shown.show(result.to_result(), write_table=False)
