"""``clubface optimise``: the club that is best for golfers within limits, or the parts that fit them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say
from clubface.cli.output import print_numbers, progress_bar

app = typer.Typer(add_completion=False)

_OUTPUT = options.output(
    "FILE", "Write the best club to this TOML file, which clubface shot reads; or of a fitting all parts, CSV."
)


@app.command()
def optimise(
    study: Annotated[
        str, typer.Argument(metavar="STUDY", help="A TOML file: what may change, what is best, for whom.")
    ],
    target: Annotated[str | None, _OUTPUT] = None,
    picture: Annotated[str | None, options.picture("the landings, and the front, the bounds or the parts")] = None,
    report: options.Report = None,
    resume: options.Resume = False,
    as_json: options.Json = False,
) -> None:
    """Find the club that is best for golfers within limits, or the parts that fit them."""
    output.check_target("--output", target, (".toml", ".csv"), (study,))
    output.check_picture(picture, (study,))
    output.check_report(report, (study,))
    output.check_resume(resume, target)
    from clubface.design.optimisation.fitting import Fitting
    from clubface.design.optimisation.study import read

    asked = read(study)
    output.check_not_read(target)
    if isinstance(asked, Fitting):
        output.check_target("--output", target, (".csv",))
        _fit(asked, target, picture, report, resume, as_json)
    else:
        output.check_target("--output", target, (".toml",))
        _optimise(asked, target, picture, report, resume, as_json)


def _optimise(
    asked: Any, target: str | None, picture: str | None, report: str | None, resume: bool, as_json: bool
) -> None:
    from clubface.design.optimisation import result
    from clubface.design.optimisation.run import optimise as find

    with progress_bar(lambda _, whole, told: told) as progress:
        found = find(asked, output=target, resume=resume, progress=progress)
    if target is not None:
        say(f"wrote {target}")
    if picture is not None or report is not None:
        from clubface.design.pictures import optimum_figure

        figure = optimum_figure(found)
        if picture is not None:
            from clubface import plots

            say(f"wrote {plots.save(figure, picture)}")
        if report is not None:
            _report(found, figure, report)
            say(f"wrote {report}")
    if as_json:
        output.print_json(result.document(found))
    else:
        _print(found)


def _report(found: Any, figure: Any, target: str) -> None:
    from clubface.design.optimisation import result

    heads, rows = result.design_table(found)
    reporting.write(
        target, title=found.study.title, words=result.gains(found),
        picture=("Landings with the club at the start and with the optimum, and what changed", figure),
        columns={head.replace("\n", " ") or "field": [row[place] for row in rows] for place, head in enumerate(heads)},
        show=lambda: _print(found), launches=_deliveries(found.study, [found.study.club, found.built]),
        files={"the-best-club.toml": found.built.to_toml()}, **_asked(found.study),
    )  # fmt: skip


def _print(found: Any) -> None:
    from clubface.design.optimisation import result

    asked = found.study
    print_numbers(*result.design_table(found), title=asked.title)
    print()
    print_numbers(*result.shots_table(found), title="On fresh shots")
    print()
    print_numbers(*result.limits_table(found), title="Limits")
    heads, rows = result.placement_table(found)
    if rows:
        print()
        print_numbers(heads, rows, title="One way to place the discretionary mass, seen from the face centre")
    if found.front:
        print()
        print_numbers(*result.front_table(found), title="Clubs than which none is better in both objectives")
    print()
    output.print_notes(result.notes(found))


def _fit(asked: Any, target: str | None, picture: str | None, report: str | None, resume: bool, as_json: bool) -> None:
    from clubface.design.optimisation import fitting_run
    from clubface.design.optimisation.fitting_run import fit, table

    with progress_bar("combinations") as progress:
        found = fit(asked, output=target, resume=resume, progress=progress)
    if target is not None:
        say(f"wrote {target}")

    def show() -> None:
        print_numbers(*fitting_run.best_table(asked, found), title=asked.title)
        print()
        output.print_notes(fitting_run.notes(asked, found))

    if picture is not None or report is not None:
        from clubface.design.pictures import fit_figure

        figure = fit_figure(asked, found)
        if picture is not None:
            from clubface import plots

            say(f"wrote {plots.save(figure, picture)}")
        if report is not None:
            data = table(asked, found)
            reporting.write(
                report, title=asked.title, words=fitting_run.advice(asked, found),
                picture=("Landings with the best parts, and how far behind the others are", figure),
                columns=dict(zip(data.headings, zip(*data.rows, strict=True), strict=True)), show=show,
                launches=_deliveries(asked, asked.clubs, asked.balls), **_asked(asked),
            )  # fmt: skip
            say(f"wrote {report}")
    if as_json:
        output.print_json(fitting_run.document(asked, found))
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


def _asked(asked: Any) -> dict[str, Any]:
    """Return for whom, with how many shots and in which air a study was solved, as ``reporting.write`` takes it."""
    from clubface.design.golfer import golfer_sources

    golfers = ", ".join(
        (golfer.title or golfer.name) + (f" (weight {weight:g})" if len(asked.golfers) > 1 else "")
        for golfer, weight in asked.golfers
    )
    given = {"golfers": golfers, "shots": str(asked.shots), "seed": str(asked.seed)}
    if asked.hole is not None:
        given["hole"] = asked.hole.describe()
    return {
        "given": given, "conditions": {name: getattr(asked.setting, name) for name in ("air", "wind", "ground")},
        "sources": [each for golfer, _ in asked.golfers for each in golfer_sources(golfer)],
    }  # fmt: skip
