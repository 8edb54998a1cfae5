"""``clubface optimise``: the club that is best for golfers within limits, or the parts that fit them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated, Any

import typer

from clubface.cli import options, output, reporting
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
    report: options.Report = None,
    resume: options.Resume = False,
    as_json: options.Json = False,
) -> None:
    """Find the club that is best for golfers within limits, or the parts that fit them."""
    output.check_target("--output", target, (".toml",), (study,))
    output.check_picture(picture, (study,))
    output.check_report(report, (study,))
    output.check_resume(resume, target)
    from clubface.design.optimisation.fitting import Fitting
    from clubface.design.optimisation.study_file import read

    asked = read(study)
    if isinstance(asked, Fitting):
        _refuse({"--output": target, "--plot": picture})
        _fit(asked, report, as_json)
    else:
        _optimise(asked, target, picture, report, resume, as_json)


def _refuse(given: Mapping[str, str | None]) -> None:
    """Refuse files that a fitting does not write."""
    for option, value in given.items():
        if value is not None:
            raise ClubfaceError(f"{option} is for a club that is designed; leave it out, since the study chooses parts")


def _optimise(
    asked: Any, target: str | None, picture: str | None, report: str | None, resume: bool, as_json: bool
) -> None:
    from clubface.design.optimisation import words
    from clubface.design.optimisation.run import optimise as find

    with progress_bar(lambda _, whole, told: told) as progress:
        found = find(asked, output=target, resume=resume, progress=progress)
    if target is not None:
        say(f"wrote {target}")
    if picture is not None or report is not None:
        from clubface.design.optimisation.figures import optimum_figure

        figure = optimum_figure(found)
        if picture is not None:
            from clubface import plots

            say(f"wrote {plots.save(figure, picture)}")
        if report is not None:
            _report(found, figure, report)
            say(f"wrote {report}")
    if as_json:
        output.print_json(words.document(found))
    else:
        _print(found)


def _report(found: Any, figure: Any, target: str) -> None:
    from clubface.design.optimisation import words

    heads, rows = words.design_table(found)
    reporting.write(
        target, title=found.study.title, words=words.gains(found),
        picture=("Landings with the club at the start and with the optimum, and what changed", figure),
        columns={head.replace("\n", " ") or "field": [row[place] for row in rows] for place, head in enumerate(heads)},
        show=lambda: _print(found), launches=_deliveries(found.study, [found.built]), given=_asked(found.study),
    )  # fmt: skip


def _print(found: Any) -> None:
    from clubface.design.optimisation import words

    asked = found.study
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


def _fit(asked: Any, report: str | None, as_json: bool) -> None:
    from clubface.design.optimisation import words
    from clubface.design.optimisation.fitting import fit

    with progress_bar("combinations") as progress:
        found = fit(asked, progress=progress)

    def show() -> None:
        print_numbers(*words.fit_table(asked, found), title=asked.title)
        print()
        output.print_notes(words.fit_notes(asked, found))

    if report is not None:
        reporting.write(
            report, title=asked.title, words=words.fit_advice(asked, found), picture=None, columns={}, show=show,
            launches=_deliveries(asked, asked.clubs, asked.balls), given=_asked(asked),
        )  # fmt: skip
        say(f"wrote {report}")
    if as_json:
        output.print_json(words.fit_document(asked, found))
    else:
        show()


def _deliveries(asked: Any, clubs: Sequence[Any], balls: Sequence[Any] = (None,)) -> list[Any]:
    """Return the launches of the mean deliveries of the golfers with every club and ball."""
    from clubface.simulation.impact import impact

    setting = asked.setting
    return [
        impact(
            club, golfer.for_hand(club.hand).delivery(), model=setting.model, parameters=setting.parameters,
            ball=setting.ball if ball is None else ball,
        )
        for club in clubs for ball in balls for golfer, _ in asked.golfers
    ]  # fmt: skip


def _asked(asked: Any) -> dict[str, str]:
    """Return for whom, and with how many shots, a study was solved."""
    golfers = ", ".join(golfer.title or golfer.name for golfer, _ in asked.golfers)
    return {"golfers": golfers, "shots": str(asked.shots), "seed": str(asked.seed)}
