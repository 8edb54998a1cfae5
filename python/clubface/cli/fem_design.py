"""``clubface fem design``: a better head of shells, proposed by a fast model and judged by finite elements."""

from __future__ import annotations

from typing import Annotated

import typer

from clubface.cli import options, output
from clubface.cli.failures import say
from clubface.cli.progress import progress_bar
from clubface.cli.tables import print_numbers
from clubface.errors import ClubfaceError

_OUTPUT = options.output("FILE", "Write the best head to this TOML file, which fem head and shot read.")


def design(
    study: Annotated[
        str, typer.Argument(metavar="STUDY", help="A TOML file: head, walls that may change, what is best, limits.")
    ],
    target: Annotated[str | None, _OUTPUT] = None,
    picture: Annotated[str | None, options.picture("every design that was judged")] = None,
    workers: Annotated[int | None, typer.Option("--workers", help="Runs at a time; all cores unless given.")] = None,
    resume: options.Resume = False,
    as_json: options.Json = False,
) -> None:
    """Find the walls of a head: a fast model proposes them, finite elements judge ball speed, stress and limits."""
    output.check_target("--output", target, (".toml",), (study,))
    output.check_picture(picture, (study,))
    if resume and target is None:
        raise ClubfaceError("--output is missing; what is finished is kept beside it, so --resume needs it")
    from clubface.design import shells
    from clubface.design.shells import words

    asked = shells.read(study)
    with progress_bar("designs") as progress:
        found = shells.improve(asked, output=target, resume=resume, workers=workers, progress=progress)
    if target is not None:
        say(f"wrote {target}")
    if picture is not None:
        from clubface import plots
        from clubface.design.shells.figures import search_figure

        say(f"wrote {plots.save(search_figure(found), picture)}")
    if as_json:
        output.print_json(words.document(found))
        return
    print_numbers(*words.design_table(found), title=asked.title)
    print()
    if found.chosen.goal.limits:
        print_numbers(*words.limits_table(found.chosen), title="Limits")
        print()
    if len(found.searches) > 1:
        print_numbers(*words.metals_table(found), title="The best head of each metal")
        print()
    print_numbers(*words.steps_table(found.chosen, asked.objective), title="Designs that finite elements judged")
    print()
    output.print_notes(words.notes(found))
