"""``clubface fem design``: a better head of shells, proposed by a fast model and judged by finite elements."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say
from clubface.cli.progress import progress_bar
from clubface.cli.tables import print_numbers

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from clubface.design.shells.run import Improved

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
    from clubface.design.shells import words

    asked = shells.read(study)
    output.check_not_read(target)
    with progress_bar("designs") as progress:
        found = shells.improve(asked, output=target, resume=resume, workers=workers, progress=progress)
    if target is not None:
        say(f"wrote {target}")
    if picture is not None or report is not None:
        from clubface.design.shells.figures import search_figure

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
    from clubface.design.shells import words
    from clubface.fem.heads import driver_file

    heads, rows = words.steps_table(found.chosen, found.study.objective)
    names = [head.replace("\n", " ") or name for head, name in zip(heads, STEPS, strict=True)]
    reporting.write(
        target, title=found.study.title, words=words.gains(found),
        picture=("Every design that finite elements judged", figure),
        columns={name: [row[place] for row in rows] for place, name in enumerate(names)}, show=lambda: _print(found),
        launches=(), conditions={}, given={"study": Path(study).name, "runs of finite elements": str(found.runs)},
        sources=[f"Metal {each.metal.name}: {each.metal.source}" for each in found.searches if each.metal.source],
        files={"the-best-head.toml": driver_file.text(found.head)},
    )  # fmt: skip


def _print(found: Improved) -> None:
    from clubface.design.shells import words

    asked = found.study
    print_numbers(*words.design_table(found), title=asked.title)
    print()
    if found.chosen.goal.limits:
        print_numbers(*words.limits_table(found.chosen), title="Limits")
        print()
    if len(found.searches) > 1:
        print_numbers(*words.metals_table(found), title="The best head of each metal")
        print()
    of = f" of {found.chosen.metal.name}" if len(found.searches) > 1 else ""
    print_numbers(*words.steps_table(found.chosen, asked.objective), title=f"Designs{of} that finite elements judged")
    print()
    output.print_notes(words.notes(found))
