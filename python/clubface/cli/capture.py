"""``clubface capture``: motion capture to deliveries, joined with a monitor's launches, and synthetic swings."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface import units
from clubface.cli import options, output, show
from clubface.cli.failures import Interrupted, print_note
from clubface.cli.output import progress_bar
from clubface.errors import InputError

PICTURES = "path, face and residuals; by default next to the table of -o"
FILE = "FILE"

app = typer.Typer(add_completion=False, no_args_is_help=True, help="Motion capture: C3D files to deliveries.")

Club = Annotated[str, options.option("--club", metavar="CLUB", text="Name of a built-in club, or a TOML file.")]
HAND = options.group(None, hand=(options.Text, None, "right|left", "Hand of the club; default: as in the club's file."))
UNITS = options.group(
    None, units=(options.Text, None, "UNIT", "Unit of length, instead of the unit that the files name.")
)
ROUGHNESS = options.group(None, roughness=(float, 0.6, None, "How sharply the smoother's path may bend."))
READING = options.group(
    None,
    estimator=(str, "smoother", "NAME", "Estimator of the path: smoother, polynomial or linear."),
    ball=(options.Text, None, "NAME|FILE", "The ball; only its radius is used."),
    target=(options.Text, None, "AXIS", "Axis that points to the target: +x, -x, ..."),
    up=(options.Text, None, "AXIS", "Axis that points up."),
    noise=(options.Text, None, '"0.3 mm"', "Standard deviation of a marker; default: estimated."),
)
SWINGS = {"club": (Club, "driver"), **HAND, **options.group(None,
    noise=(str, "0 mm", '"0.3 mm"', "Standard deviation of a marker along each axis."),
    gaps=(float, 0.0, "SHARE", "Fraction of the time that a marker is hidden, 0 to 0.5."),
    seed=(int, 1, "N", "Random seed: the same seed gives the same swings."),
)}  # fmt: skip
"""Options of synthetic swings."""


@app.command()
@options.takes(show.JSON, options.LAYOUT)
def join(
    captured: Annotated[str, options.argument("CAPTURED", "Table of deliveries, written by capture read.")],
    session: Annotated[str, options.argument("SESSION", "The launches: a monitor's file, or a table.")],
    target: Annotated[str, options.output(FILE, "Write the shots, CSV or Parquet.")],
    **texts: Any,
) -> None:
    """Pair captured deliveries with a monitor's launches, in the order in which the shots were hit."""
    from clubface.capture import join as join_shots
    from clubface.shots.reading import read as read_shots
    from clubface.shots.recorded_result import shots_result
    from clubface.shots.tables.writer import KINDS

    shown = show.Output.check(texts | {"target": target}, [captured, session, texts["mapping"]], KINDS)
    shots = join_shots(read_shots(captured), read_shots(session, **{name: texts[name] for name in options.LAYOUT}))
    shots.write(target)
    shown.show(shots_result(shots), write_table=False)


@app.command()
@options.takes(show.JSON, READING, HAND, UNITS, ROUGHNESS, show.plot_option(PICTURES))
def read(
    files: Annotated[list[str], options.argument("FILE...", "C3D files of one session.")],
    markers: Annotated[str, typer.Option("--markers", metavar=FILE, help="TOML file with the meaning of each marker.")],
    club: Club,
    target_file: Annotated[str | None, options.output(FILE, "Write the deliveries, CSV or Parquet.")] = None,
    **texts: Any,
) -> None:
    """Read the delivery and its uncertainty from recordings of swings."""
    from clubface.capture.swing import read_swings
    from clubface.shots.tables.writer import KINDS

    shown = show.Output(texts["as_json"])
    output.check_target("--output", target_file, KINDS, [*files, markers])
    pictures = _picture_file(texts["plot"], target_file, files, markers)
    how = {name: texts[name] for name in (*READING, *HAND, *ROUGHNESS)}
    with progress_bar("swings") as progress:
        swings = read_swings(files, markers, club, **how, unit=texts["units"], progress=progress)
    written = swings.write(target_file) if target_file is not None and len(swings) else []
    if pictures is not None and len(swings):
        from clubface.capture.captured import save_swings

        written.append(save_swings(swings.captured, pictures))
    for each in swings.captured:
        if not each.plausible:
            print_note(f"WARNING: {each.source}: {each.notes[0]}")
    for each in swings.rejected:
        print_note(each.reason)
    if len(swings) or shown.as_json:
        shown.show(swings.to_result(), more=written)
    if swings.interrupted:
        raise Interrupted(f"interrupted: {len(swings)} of {len(files)} swings read")
    if not len(swings):
        raise typer.Exit(2)


def _picture_file(picture: str | None, table: str | None, files: list[str], mapping: str) -> str | None:
    """Return the file for the pictures, or None.

    A table written to a file gets pictures next to it, one page per swing, for checking. Without a table, pictures are
    written only on request.
    """
    inputs = [*files, mapping]
    if picture is not None:
        output.check_picture(picture, inputs)
        if len(files) > 1 and Path(picture).suffix.lower() != ".pdf":
            raise InputError("--plot", picture, "a file ending in .pdf, since several swings make several pages")
        return picture
    if table is None:
        return None
    if find_spec("matplotlib") is None:
        print_note('no picture is written next to the table: pip install "clubface[plots]"')
        return None
    sibling_file = str(Path(table).with_suffix(".pdf"))
    output.check_picture(sibling_file, inputs)
    return sibling_file


@app.command()
@options.takes(show.JSON, UNITS)
def markers(file: Annotated[str, options.argument(FILE, "A C3D file.")], **texts: Any) -> None:
    """List the markers of a recording: how often each is seen, where and how fast."""
    from clubface.capture.recording import read_c3d

    show.Output.check(texts).show(read_c3d(file, unit=texts["units"]).to_result())


@app.command()
def template(
    file: Annotated[str | None, options.argument(FILE, "A C3D file; the mapping lists its markers.")] = None,
    target_file: options.Template = None,
) -> None:
    """Print a commented mapping file to start your own from."""
    from clubface.capture.markers import template as text
    from clubface.capture.recording import read_c3d

    written = text() if file is None else text(read_c3d(file, unit="mm").labels)
    output.write_template(written, target_file, "fill it in, then give it as --markers")


@app.command()
@options.takes(SWINGS, options.group(None,
    count=(int, 10, "NUMBER", "Number of swings."),
    rate=(float | None, None, "HZ", "Frames per second; default 720, or 360 with --bare."),
    bare=(bool, False, None, "Only three markers on the head and an address: no ball, no calibration."),
))  # fmt: skip
def synthesize(
    folder: Annotated[str, typer.Option("--output", "-o", metavar="FOLDER", help="Write to this folder.")], **texts: Any
) -> None:
    """Write swings with an exactly known delivery, with calibration, mapping file and truth."""
    from clubface.capture.synthetic.laboratory import BARE_RATE, Cameras, synthesize as write_usual, synthesize_bare

    write, usual = (synthesize_bare, BARE_RATE) if texts["bare"] else (write_usual, Cameras.rate)
    count, swings = texts["count"], _swings(texts, usual if texts["rate"] is None else texts["rate"])
    with progress_bar("swings") as progress:
        files = write(folder, count, **swings, progress=progress)
    print_note(f"wrote {count} swings, {', '.join(each.name for each in files[count:])} to {folder}")


@app.command()
@options.takes(
    SWINGS | {"noise": (SWINGS["noise"][0], "0.3 mm")}, show.plot_option("bias and spread"), show.JSON,
    options.group(None,
        count=(int, 200, "NUMBER", "Number of swings."),
        rate=(float, 720.0, "HZ", "Frames per second."),
        checkpoint=(options.Text, None, "FOLDER", "Keep finished work here, so that the same command continues."),
    ), ROUGHNESS,
)  # fmt: skip
def study(**texts: Any) -> None:
    """Compare the estimators on swings with a known delivery: bias, spread, coverage."""
    from clubface.capture.study import study as run

    shown = show.Output.check(texts)
    with progress_bar("swings") as progress:
        result = run(
            texts["count"], **_swings(texts, texts["rate"]), roughness=texts["roughness"],
            checkpoint=texts["checkpoint"], progress=progress,
        )  # fmt: skip
    shown.show(result.to_result())


def _swings(texts: dict[str, Any], rate: float) -> dict[str, Any]:
    """Return the synthetic swings chosen by the options: club, hand, laboratory and seed."""
    from clubface.capture.synthetic.laboratory import Cameras

    noise = units.parse(texts["noise"], "length", name="--noise")
    cameras = Cameras(rate=rate, noise=noise, gaps=texts["gaps"])
    return {"club": texts["club"], "hand": texts["hand"], "cameras": cameras, "seed": texts["seed"]}
