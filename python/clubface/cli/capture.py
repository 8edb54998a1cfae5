"""``clubface capture``: motion capture to deliveries, and synthetic swings.

``clubface capture join``: captured deliveries and a monitor's launches of the same shots, as one table.

Where ``clubface capture read`` puts its pictures.

The tables that ``clubface capture`` prints.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface import units
from clubface.cli import options, output
from clubface.cli.failures import Interrupted, say, say_written
from clubface.cli.output import print_numbers, progress_bar
from clubface.errors import InputError


def join(
    captured: Annotated[
        str, typer.Argument(metavar="CAPTURED", help="Table of deliveries, as capture read writes it.")
    ],
    session: Annotated[str, typer.Argument(metavar="SESSION", help="The launches: a monitor's file, or a table.")],
    target: Annotated[str, options.output("FILE", "Write the shots, CSV or Parquet.")],
    format_: options.Format = None,
    mapping: options.ColumnsFile = None,
    as_json: options.Json = False,
) -> None:
    """Pair captured deliveries with the launches of a monitor, in the order in which the shots were hit."""
    from clubface import capture
    from clubface.shots.reading import read
    from clubface.shots.tables.writer import KINDS

    output.check_target("--output", target, KINDS, [captured, session, mapping])
    shots = capture.join(read(captured), read(session, format=format_, mapping=mapping))
    shots.write(target)
    if as_json:
        document = {"shots": len(shots), "output": target, "rejected": [each._asdict() for each in shots.rejected]}
        output.print_json(document | {"notes": shots.notes})
        return
    print(f"{output.counted(len(shots), 'shot')}: {target}")
    output.print_rejected(shots.rejected, "left out", "--json lists all")
    output.print_notes(shots.notes)


PICTURES = "path, face and residuals; beside the table of -o unless given"


def pictures_of(picture: str | None, table: str | None, files: list[str], mapping: str) -> str | None:
    """Return the file for the pictures, or None.

    A table that is kept gets the pictures by which it can be judged beside it, a page a swing. A command that prints
    leaves no file behind unless it is told to.
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
        say('no picture is written beside the table: pip install "clubface[plots]"')
        return None
    beside = str(Path(table).with_suffix(".pdf"))
    output.check_picture(beside, inputs)
    return beside


ROWS = (
    ("club speed", "speed", "mph", 2), ("attack", "attack", "deg", 2), ("path", "path", "deg", 2),
    ("dynamic loft", "loft", "deg", 2), ("face angle", "face", "deg", 2), ("lie", "lie", "deg", 2),
    ("towards the toe", "toe", "mm", 2), ("high", "high", "mm", 2), ("closure", "closure", "deg/s", 0),
    ("pitch rate", "pitch_rate", "deg/s", 0), ("lie rate", "lie_rate", "deg/s", 0),
)  # fmt: skip
LAUNCH_ROWS = (("ball speed", "ball_speed", "mph", 2), ("launch", "launch", "deg", 2), ("azimuth", "azimuth", "deg", 2))
SHOWN = ROWS[:5] + ROWS[6:9]
"""The columns of a table of many swings."""


def print_study(found: Any) -> None:
    """Print bias, spread and coverage, a row a quantity."""
    from clubface.capture.study import UNITS

    heads = ["", *(f"{name}\n{figure}" for name in found.errors for figure in ("bias", "spread", "covers, %"))]
    figures = {name: (found.bias(name), found.spread(name), found.coverage(name)) for name in found.errors}
    rows = []
    for label, name, _, _ in ROWS:
        digits = 0 if UNITS[name] == "deg/s" else 3
        row = [f"{label}, {UNITS[name]}"]
        for bias, spread, coverage in figures.values():
            row += [output.number(bias[name], digits), output.number(spread[name], digits)]
            row.append(output.number(100.0 * coverage[name], 1))
        rows.append(row)
    noise = f"{units.from_si(found.cameras.noise, 'mm'):g} mm"
    print_numbers(
        heads, rows, title=f"{len(found)} swings, {found.club.name}, markers' noise {noise}: captured less true"
    )


def print_one(found: Any) -> None:
    """Print one delivery, value by value."""
    rows = []
    for label, name, unit, digits in ROWS:
        value, deviation = found.get(name, unit)
        rows.append([f"{label}, {unit}", output.number(value, digits), output.number(deviation, digits)])
    for label, name, unit, digits in LAUNCH_ROWS if found.launch else ():
        value, deviation = (units.from_si(each[name], unit) for each in (found.launch, found.launch_uncertainty))
        rows.append([f"{label}, {unit}", output.number(value, digits), output.number(deviation, digits)])
    print_numbers(("", "", "standard\ndeviation"), rows, title=f"{found.source}: {found.club.name}, {found.estimator}")
    noise = f"markers' noise {units.fixed(found.marker_noise, 'mm', 3)}"
    for known in found.geometry:
        output.print_paragraph(str(known))
    print(f"first touch {found.time:.6f} s, after frame {found.frames[0]}; {found.used} frames used; {noise}")
    output.print_notes(found.notes)


def print_many(found: Any) -> None:
    """Print a table of swings, and the mean of each standard deviation."""
    from pathlib import Path

    heads = ("swing", *(f"{label}\n{unit}" for label, _, unit, _ in SHOWN))
    rows = [
        [Path(each.source).name, *(output.number(each.get(name, unit)[0], digits) for _, name, unit, digits in SHOWN)]
        for each in found.captured
    ]
    deviations = found.uncertainty.deliveries
    means = [float(units.from_si(deviations[name].mean(), unit)) for _, name, unit, _ in SHOWN]
    last = [output.number(mean, digits) for mean, (*_, digits) in zip(means, SHOWN, strict=True)]
    rows.append(["standard deviation", *last])
    print_numbers(heads, rows, summary=True)
    shared = [str(each) for each in found.captured[0].geometry]
    for known in shared:
        if all(known in map(str, each.geometry) for each in found.captured):
            output.print_paragraph(known)
    output.print_notes(found.shots.notes)


app = typer.Typer(add_completion=False, no_args_is_help=True, help="Motion capture: C3D files to deliveries.")
app.command("join")(join)

Club = Annotated[str, options.option("--club", metavar="CLUB", text="Name of a built-in club, or a TOML file.")]
Hand = Annotated[
    str | None, options.option("--hand", metavar="right|left", text="Hand of the club; its own unless given.")
]
Unit = Annotated[
    str | None,
    options.option("--units", metavar="UNIT", text="Unit of length, in place of the one that the files name."),
]
Noise = Annotated[
    str, typer.Option("--noise", metavar='"0.3 mm"', help="Standard deviation of a marker along an axis.")
]
Gaps = Annotated[
    float, typer.Option("--gaps", metavar="PART", help="Part of the time in which a marker is hidden, 0 to 0.5.")
]
Rate = Annotated[float, typer.Option("--rate", metavar="HZ", help="Frames per second.")]
Roughness = Annotated[
    float, typer.Option("--roughness", metavar="NUMBER", help="How much the path of the smoother may bend.")
]
Seed = Annotated[int, typer.Option("--seed", help="The same seed gives the same swings.")]
FILE, SEVERAL = "FILE", "FILE..."


@app.command("read")
def read(
    files: Annotated[list[str], typer.Argument(metavar=SEVERAL, help="C3D files of one session.")],
    markers: Annotated[str, typer.Option("--markers", metavar=FILE, help="TOML file that says which marker is what.")],
    club: Club,
    estimator: Annotated[
        str, typer.Option("--estimator", metavar="NAME", help="How a path is read: smoother, polynomial or linear.")
    ] = "smoother",
    hand: Hand = None,
    ball: Annotated[
        str | None, typer.Option("--ball", metavar="NAME|FILE", help="The ball, whose radius is used.")
    ] = None,
    target: Annotated[
        str | None,
        options.option(
            "--target", metavar="AXIS", text="Axis of the laboratory that points to the target: +x, -x, ..."
        ),
    ] = None,
    up: Annotated[
        str | None, options.option("--up", metavar="AXIS", text="Axis of the laboratory that points up.")
    ] = None,
    units: Unit = None,
    roughness: Roughness = 0.6,
    noise: Annotated[
        str | None,
        options.option(
            "--noise",
            metavar='"0.3 mm"',
            text="Standard deviation of a marker along an axis; estimated unless given.",
        ),
    ] = None,
    target_file: Annotated[str | None, options.output(FILE, "Write the deliveries, CSV or Parquet.")] = None,
    picture: Annotated[str | None, options.picture(PICTURES)] = None,
    as_json: options.Json = False,
) -> None:
    """Read the delivery, with its uncertainty, from recordings of swings."""
    from clubface.capture.swing import read_swings
    from clubface.shots.tables.writer import KINDS

    output.check_target("--output", target_file, KINDS, [*files, markers])
    pictures = pictures_of(picture, target_file, files, markers)
    with progress_bar("swings") as progress:
        found = read_swings(
            files, markers, club, estimator=estimator, roughness=roughness, hand=hand, ball=ball, target=target, up=up,
            unit=units, noise=noise,
            progress=progress,
        )  # fmt: skip
    written = found.write(target_file) if target_file is not None and len(found) else []
    if pictures is not None and len(found):
        from clubface.capture.picture import save_swings

        written.append(save_swings(found.captured, pictures))
    for each in found.captured:
        if not each.plausible:
            say(f"WARNING: {each.source}: {each.notes[0]}")
    if as_json:
        documents: Any = [each.document() for each in found.captured]
        rejected = [each.reason for each in found.rejected]
        output.print_json(
            documents[0] if len(files) == 1 and documents else {"swings": documents, "rejected": rejected}
        )
    elif len(found) == 1:
        print_one(found.captured[0])
    elif len(found):
        print_many(found)
    for each in found.rejected:
        say(each.reason)
    say_written(written)
    if found.interrupted:
        raise Interrupted(f"interrupted: {len(found)} of {len(files)} swings read")
    if not len(found):
        raise typer.Exit(2)


@app.command("markers")
def markers(
    file: Annotated[str, typer.Argument(metavar=FILE, help="A C3D file.")],
    units: Unit = None,
    as_json: options.Json = False,
) -> None:
    """List the markers of a recording: how often each is seen, where and how fast."""
    import numpy as np

    from clubface.capture.recording import read_c3d

    found = read_c3d(file, unit=units)
    rows = []
    for label, seen in zip(found.labels, found.positions.swapaxes(0, 1), strict=True):
        known = np.isfinite(seen).all(-1)
        steps = np.linalg.norm(np.diff(seen, axis=0), axis=-1) * found.rate
        first = seen[known][0] if known.any() else np.full(3, np.nan)
        fastest = float(np.nanmax(steps)) if np.isfinite(steps).any() else float("nan")
        rows.append({"label": label, "frames": int(known.sum()), "first_m": first.tolist(), "fastest_mps": fastest})
    if as_json:
        output.print_json({"rate_hz": found.rate, "frames": len(found.positions), "markers": rows})
        return
    cells = [
        [row["label"], str(row["frames"]), *(output.number(1e3 * each, 1) for each in row["first_m"]),
         output.number(row["fastest_mps"], 1)]
        for row in rows
    ]  # fmt: skip
    title = f"{file}: {len(found.positions)} frames at {found.rate:g} Hz"
    print_numbers(("marker", "frames\nseen", "first x\nmm", "y\nmm", "z\nmm", "fastest\nm/s"), cells, title=title)


@app.command("template")
def template(
    file: Annotated[
        str | None, typer.Argument(metavar=FILE, help="A C3D file, whose markers are named in the mapping.")
    ] = None,
    target_file: options.Template = None,
) -> None:
    """Print an explained mapping file to start your own from."""
    from clubface.capture.markers import template as text
    from clubface.capture.recording import read_c3d

    written = text() if file is None else text(read_c3d(file, unit="mm").labels)
    output.write_template(written, target_file, "fill it in, then give it as --markers")


@app.command("synthesize")
def synthesize(
    folder: Annotated[str, typer.Option("--output", "-o", metavar="FOLDER", help="Write to this folder.")],
    count: Annotated[int, typer.Option("--count", metavar="NUMBER", help="Number of swings.")] = 10,
    club: Club = "driver",
    hand: Hand = None,
    noise: Noise = "0 mm",
    gaps: Gaps = 0.0,
    rate: Annotated[
        float | None,
        options.option("--rate", metavar="HZ", text="Frames per second; 720, or 360 with --bare, unless given."),
    ] = None,
    seed: Seed = 1,
    bare: Annotated[
        bool, typer.Option("--bare", help="Three markers on the head, an address, no ball and no calibration.")
    ] = False,
) -> None:
    """Write swings whose delivery is known exactly, with calibration, mapping file and truth."""
    from clubface.capture.synthetic.laboratory import BARE_RATE, Cameras, synthesize as write_usual, synthesize_bare

    write = synthesize_bare if bare else write_usual
    usual = BARE_RATE if bare else Cameras.rate
    cameras = Cameras(
        rate=usual if rate is None else rate, noise=units.parse(noise, "length", name="--noise"), gaps=gaps
    )
    with progress_bar("swings") as progress:
        files = write(
            folder, count, club=club, hand=hand, cameras=cameras, seed=seed,
            progress=progress,
        )  # fmt: skip
    say(f"wrote {count} swings, {', '.join(each.name for each in files[count:])} to {folder}")


@app.command("study")
def study(
    count: Annotated[int, typer.Option("--count", metavar="NUMBER", help="Number of swings.")] = 200,
    club: Club = "driver",
    hand: Hand = None,
    noise: Noise = "0.3 mm",
    gaps: Gaps = 0.0,
    rate: Rate = 720.0,
    roughness: Roughness = 0.6,
    seed: Seed = 1,
    picture: Annotated[str | None, options.picture("bias and spread")] = None,
    checkpoint: Annotated[
        str | None,
        options.option(
            "--checkpoint",
            metavar="FOLDER",
            text="Keep the swings that are read here; the same command goes on after them.",
        ),
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Compare the estimators on swings whose truth is known: bias, spread, coverage."""
    from clubface.capture.study import study as run
    from clubface.capture.synthetic.laboratory import Cameras

    output.check_picture(picture)
    cameras = Cameras(rate=rate, noise=units.parse(noise, "length", name="--noise"), gaps=gaps)
    with progress_bar("swings") as progress:
        found = run(
            count, club=club, hand=hand, cameras=cameras, roughness=roughness, seed=seed, checkpoint=checkpoint,
            progress=progress,
        )  # fmt: skip
    try:
        if picture is not None:
            from clubface import plots
            from clubface.capture.picture import study_figure

            told = "no noise" if cameras.noise == 0.0 else f"{units.from_si(cameras.noise, 'mm'):g} mm noise"
            say(f"wrote {plots.save(study_figure({told: found}), picture)}")
    finally:  # what took long is shown even where a disk is full
        if as_json:
            output.print_json(found.document())
        else:
            print_study(found)
