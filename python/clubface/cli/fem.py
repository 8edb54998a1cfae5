"""``clubface fem``: finite element impacts.

The rows of the tables of ``clubface fem``.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import Interrupted, say, say_written
from clubface.cli.fem_heads import ball as report_ball, design, face as report_face, head as report_head
from clubface.cli.output import print_numbers, progress_bar, run_with_progress
from clubface.errors import InputError, RunError, Told
from clubface.support.checks import check_choice
from clubface.support.files import prepared_folder
from clubface.units import fixed, from_si

if TYPE_CHECKING:
    from clubface.fem.case import Case


RUN_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("ball speed, mph", "ball_speed", "mph", 1),
    ("launch angle, deg", "launch", "deg", 2),
    ("azimuth, deg", "azimuth", "deg", 2),
    ("velocity off the plane, m/s", "normal_velocity", "1", 2),
    ("velocity along it, m/s", "tangential_velocity", "1", 2),
    ("backspin, rpm", "backspin", "rpm", 0),
    ("sidespin, rpm", "sidespin", "rpm", 0),
    ("spin axis, deg", "spin_axis", "deg", 1),
    ("carry, yd", "carry", "yd", 1),
    ("side, yd", "side", "yd", 1),
    ("apex, yd", "apex", "yd", 1),
)
"""Label, key, unit and digits of launch and flight."""
FIGURE_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("peak force, N", "peak_force", "1", 0),
    ("at, us", "peak_force_time", "us", 0),
    ("contact, us", "contact_time", "us", 0),
    ("largest tangential force, N", "tangential_max", "1", 0),
    ("smallest tangential force, N", "tangential_min", "1", 0),
    ("reversal, us", "reversal_time", "us", 0),
    ("largest spin on the way, rpm", "spin_max", "rpm", 0),
    ("contraction, %", "contraction", "%", 1),
    ("at, us ", "contraction_time", "us", 0),
    ("f'", "f_prime", "1", 4),
    ("f", "f", "1", 4),
)
"""The same, of the figures of the contact."""

PAPER_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("ball speed, m/s", "ball_speed_mps", "1", 1),
    ("ball speed, mph", "ball_speed_mps", "mph", 1),
    ("launch angle, deg", "launch_deg", "1", 1),
    ("club speed after, m/s", "club_speed_after_mps", "1", 1),
    ("club speed after, mph", "club_speed_after_mps", "mph", 1),
    ("spin of the launch, rpm", "spin_rpm", "1", 0),
    ("spin of all nodes at take-off, rpm", "ball_spin_rpm", "1", 0),
    ("spin of a section's nodes at take-off, rpm", "section_spin_rpm", "1", 0),
    ("spin if it rolled off, rpm", "rolling_spin_rpm", "1", 0),
    ("velocity along the face at first, m/s", "tangential_first_mps", "1", 2),
    ("least of it, m/s", "tangential_least_mps", "1", 2),
    ("at, us", "tangential_least_time_s", "us", 0),
    ("at take-off, m/s", "tangential_last_mps", "1", 2),
    ("peak force, N", "peak_force_n", "1", 0),
    ("at, us ", "peak_force_time_s", "us", 0),
    ("reversal, us", "reversal_time_s", "us", 0),
    ("contraction, %", "contraction", "%", 1),
    ("at, us  ", "contraction_time_s", "us", 0),
    ("f'", "f_prime", "1", 4),
    ("f", "f", "1", 4),
)
"""Label, key, unit and digits."""

SWEEP_COLUMNS: tuple[tuple[str, str, str, int], ...] = (
    ("speed\nm/s", "speed_mps", "1", 1),
    ("\nmph", "speed_mps", "mph", 1),
    ("loft\ndeg", "loft_deg", "1", 1),
    ("ball\nm/s", "ball_speed_mps", "1", 1),
    ("\nmph", "ball_speed_mps", "mph", 1),
    ("launch\ndeg", "launch_deg", "1", 2),
    ("spin\nrpm", "spin_rpm", "1", 0),
    ("club after\nm/s", "club_speed_after_mps", "1", 1),
    ("\nmph", "club_speed_after_mps", "mph", 1),
    ("peak\nN", "peak_force_n", "1", 0),
    ("f", "f", "1", 4),
)
"""Heading, key, unit and digits of the columns of a sweep."""

REFERENCE_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("normal rebound, m/s", "normal_mps", "1", 2),
    ("tangential rebound, m/s", "tangential_mps", "1", 2),
    ("spin, rpm", "spin_rpm", "1", 0),
    ("largest spin, rpm", "spin_max_rpm", "1", 0),
    ("peak force, N", "peak_force_n", "1", 0),
    ("at, us", "peak_force_time_s", "us", 0),
    ("contact, us", "contact_time_s", "us", 0),
    ("largest tangential force, N", "tangential_max_n", "1", 0),
    ("smallest tangential force, N", "tangential_min_n", "1", 0),
    ("reversal, us", "reversal_time_s", "us", 0),
)
"""Label, key, unit and digits."""


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

    settings = fem.Settings(contact=contact)
    found = run_with_progress(
        lambda progress: fem.reference(
            which=ball, friction=friction, refine=refine, element=element, settings=settings, progress=progress
        )
    )
    document = {
        "normal_mps": found.normal_velocity,
        "tangential_mps": found.tangential_velocity,
        "spin_rpm": from_si(found.backspin, "rpm"),
        "spin_max_rpm": from_si(found.spin_max, "rpm"),
        "peak_force_n": found.peak_force,
        "peak_force_time_s": found.peak_force_time,
        "contact_time_s": found.contact_time,
        "tangential_max_n": found.tangential_max,
        "tangential_min_n": found.tangential_min,
        "reversal_time_s": found.reversal_time,
        "energy_error": found.energy_error,
        "elements": found.elements,
        "steps": found.steps,
        "wall_s": found.wall,
    }
    if as_json:
        output.print_json(document)
        _end(found)
        return
    from clubface.fem.paper import other_solvers

    # What other solvers found is known of this case alone.
    same = friction == 0.35 and ball == "reference"
    beside, others = other_solvers() if same else ((), {})
    rows = [
        [label, *(output.number(from_si(value, unit), digits) for value in (document[key], *others.get(key, ())))]
        for label, key, unit, digits in REFERENCE_ROWS
    ]
    rows = [[*row, *[""] * (len(beside) + 2 - len(row))] for row in rows]
    title = "Reference case, beside other solvers" if same else "Reference case, varied"
    print_numbers(("", "clubface", *beside), rows, title=title)
    print(_cost(found))
    _end(found)


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
    from clubface.fem import case as cases, files

    output.check_report(report, (case,))
    chosen = cases.case(case)
    if animate and folder is None:
        raise InputError("--animate", Told("without --output"), "give the folder to write to, as in --output out/")
    if frames is not None or (animate and chosen.settings.frames < 2):
        chosen = chosen.replace(settings={"frames": MOVING if frames is None else frames})
    if folder is not None:
        prepared_folder(folder)
    found = run_with_progress(chosen.run)
    written: list[Any] = []

    def show() -> None:
        print_numbers(("", ""), _rows_of(found), title=chosen.description or chosen.name)
        output.print_paragraph(_cost(found))

    try:
        if folder is not None:
            written += files.write_run(found, folder, animation=animate)
        if report is not None:
            from clubface.cli.fem_heads import write_run

            write_run(report, found, chosen, case, show)
            written.append(report)
    finally:  # what took long is shown even where a disk is full
        if as_json:
            output.print_json(files.document(found))
        else:
            show()
    say_written(written)
    _end(found)


@app.command("paper")
def paper(
    case: Annotated[str, typer.Option("--case", metavar="NAME|FILE", help="A variation of the case.")] = "paper",
    folder: options.Folder = None,
    swept: Annotated[
        bool, typer.Option("--sweep/--no-sweep", help="With --output: also redraw Fig. 8, which takes 35 runs.")
    ] = True,
    as_json: options.Json = False,
) -> None:
    """Run the case of Roh and Lee by both methods of contact, beside their figures; with --output redraw theirs."""
    from clubface.fem import case as cases, files, paper as job

    chosen = cases.case(case)
    if folder is not None:
        prepared_folder(folder)
    runs = run_with_progress(lambda progress: job.by_contact(chosen, progress))
    written = []
    try:
        if folder is not None:
            written = files.write_paper(runs, folder)
    finally:
        if as_json:
            output.print_json(job.document(runs))
        else:
            _print_paper(runs)
    say_written(written)
    for found in runs.values():
        _end(found)
    if folder is not None and swept:
        _, written = _sweep(chosen, SPEEDS, LOFTS, folder, published=True)
        say_written(written)


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

    rows, written = _sweep(cases.case(case), speed, loft, folder, workers=workers, published=case == "paper")
    if as_json:
        output.print_json(rows)
    else:
        print_numbers(
            [head for head, *_ in SWEEP_COLUMNS],
            [
                [output.number(from_si(row[key], unit), digits) for _, key, unit, digits in SWEEP_COLUMNS]
                for row in rows
            ],
        )
    say_written(written)


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
        say_written([keyword.write(chosen, target / f"{files.file_stem(chosen.name)}.k")])
        return
    wanted = chosen.replace(settings={"frames": chosen.settings.frames or 51, "fields": True})
    found = run_with_progress(wanted.run)
    say_written(files.write_series(found, target, chosen.name)[-1:])
    _end(found)


def _print_paper(runs: Mapping[str, Any]) -> None:
    """Print the runs by the method of contact beside what was published."""
    from clubface.fem import paper as job

    tables = [job.PUBLISHED, *(job.table(found) for found in runs.values())]
    rows = [
        [label, *(output.number(from_si(each[key], unit), digits) if key in each else "" for each in tables)]
        for label, key, unit, digits in PAPER_ROWS
    ]
    factors = (job.SPIN_FACTOR, *(job.spin_factor(found) for found in runs.values()))
    rows.append(["f that the spin means, Eq. (6)", *(output.number(factor, 4) for factor in factors)])
    title = "The case of Roh and Lee, as published and as computed by each method of contact"
    print_numbers(("", "Roh and Lee", *runs), rows, title=title)
    for found in runs.values():
        print(_cost(found))


def _sweep(
    base: Case, speed: str, loft: str, folder: str | None, *, workers: int | None = None, published: bool
) -> tuple[list[dict[str, Any]], list[Path]]:
    """Run a case over a grid; return the rows, and with a folder the files written there."""
    from clubface.fem import files, sweep as job

    speeds, lofts = job.grid(speed, "speed", "--speed"), job.grid(loft, "angle", "--loft")
    target = prepared_folder(folder) / "sweep.csv" if folder is not None else None
    with progress_bar("runs") as progress:
        rows = job.sweep(base, speeds=speeds, lofts=lofts, output=target, workers=workers, progress=progress)
    if folder is None or target is None:
        return rows, []
    return rows, [target, *files.write_sweep(rows, folder, published=published)]


def _cost(found: Any) -> str:
    steps = f"{found.steps} steps of {found.settings.safety:g} of the stable one"
    counts = f"{found.elements} elements, {steps}, {found.wall:.2f} s"
    # A run that failed keeps what it had until energies were last in balance; its error tells of a later time.
    last = from_si(found.energy["time"][-1:].sum(), "us")
    until = f" until {last:.0f} us, the last record kept" if found.stopped and not found.unfinished else ""
    return f"{counts}; energies close to {found.energy_error:.2%}{until}"


def _rows_of(found: Any) -> list[list[str]]:
    """Return the figures of a run for people."""
    figures = found.outcome() | found.flown() | {key: getattr(found, key) for _, key, _, _ in FIGURE_ROWS}
    return [
        [label, output.number(from_si(figures[key], unit), digits)]
        for label, key, unit, digits in (*RUN_ROWS, *FIGURE_ROWS)
        if key in figures
    ]


def _end(found: Any) -> None:
    """When all that a run has is printed and written: tell if there is no launch, because of Ctrl-C or by itself."""
    if found.interrupted:
        raise Interrupted(f"interrupted at {fixed(found.contact['time'][-1:].sum(), 'us', 0)} of the impact")
    if found.unfinished:
        # As long as was asked for.
        say(found.stopped)
    elif found.stopped:
        raise RunError(found.stopped)
