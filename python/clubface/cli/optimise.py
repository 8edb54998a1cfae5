"""``clubface optimise``: the club that is best for golfers within limits, or the parts that fit them."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import say
from clubface.cli.progress import progress_bar
from clubface.cli.tables import print_numbers
from clubface.errors import ClubfaceError

app = typer.Typer(add_completion=False)

_OUTPUT = options.output("FILE", "Write the best club to this TOML file, which clubface shot reads.")


@app.command()
def optimise(
    study: Annotated[
        str, typer.Argument(metavar="STUDY", help="A TOML file: what may change, what is best, for whom.")
    ],
    target: Annotated[str | None, _OUTPUT] = None,
    picture: Annotated[str | None, options.picture("the landings, and the front or the bounds")] = None,
    resume: options.Resume = False,
    as_json: options.Json = False,
) -> None:
    """Find the club that is best for golfers within limits, or the parts that fit them."""
    output.check_target("--output", target, (".toml",), (study,))
    output.check_picture(picture, (study,))
    if resume and target is None:
        raise ClubfaceError("--output is missing; what is finished is kept beside it, so --resume needs it")
    from clubface.design.optimisation.fitting import Fitting
    from clubface.design.optimisation.study_file import read

    asked = read(study)
    if isinstance(asked, Fitting):
        _fit(asked, target, picture, as_json)
    else:
        _optimise(asked, target, picture, resume, as_json)


def _optimise(asked: Any, target: str | None, picture: str | None, resume: bool, as_json: bool) -> None:
    from clubface.design.optimisation import words
    from clubface.design.optimisation.run import optimise as find

    with progress_bar(lambda _, whole, told: told) as progress:
        found = find(asked, output=target, resume=resume, progress=progress)
    if target is not None:
        say(f"wrote {target}")
    if picture is not None:
        from clubface import plots
        from clubface.design.optimisation.figures import optimum_figure

        say(f"wrote {plots.save(optimum_figure(found), picture)}")
    if as_json:
        output.print_json(words.document(found))
        return
    print_numbers(*words.design_table(found), title=asked.title)
    print()
    print_numbers(*words.shots_table(found), title="On fresh shots")
    print()
    print_numbers(*words.limits_table(found), title="Limits")
    heads, rows = words.placement_table(found)
    if rows:
        print()
        print_numbers(heads, rows, title="One way to place the discretionary mass, seen from the face centre")
    if found.front:
        print()
        print_numbers(*words.front_table(found), title="Clubs than which none is better in both objectives")
    print()
    output.print_notes(words.notes(found))


def _fit(asked: Any, target: str | None, picture: str | None, as_json: bool) -> None:
    if target is not None or picture is not None:
        option = "--output" if target is not None else "--plot"
        raise ClubfaceError(f"{option} is for a club that is designed; leave it out, since the study chooses parts")
    from clubface.design.optimisation import words
    from clubface.design.optimisation.fitting import fit

    with progress_bar("combinations") as progress:
        found = fit(asked, progress=progress)
    if as_json:
        output.print_json(words.fit_document(asked, found))
        return
    print_numbers(*words.fit_table(asked, found), title=asked.title)
    print()
    output.print_notes(words.fit_notes(asked, found))
