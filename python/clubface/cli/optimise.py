"""``clubface optimise``: the club that is best for golfers within limits, or the parts that fit them."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Any

import typer

from clubface.cli import options, output, show
from clubface.cli.output import progress_bar

app = typer.Typer(add_completion=False)


@app.command()
@options.takes(
    show.table_option(
        "Write the best club to this TOML file, for clubface shot; or all combinations of a fitting, CSV."
    ),
    show.plot_option("the landings, and the front, bounds or parts"), show.REPORT,
    options.RESUME, options.WORTH, show.JSON,
)  # fmt: skip
def optimise(
    study: Annotated[str, options.argument("STUDY", "A TOML file: what may change, the objective, for whom.")],
    **texts: Any,
) -> None:
    """Find the best club for golfers within limits, or the parts that fit them best."""
    from clubface.design.optimisation.fitting import Fitting
    from clubface.design.optimisation.fitting_run import fit
    from clubface.design.optimisation.run import optimise as find_optimum
    from clubface.design.optimisation.study import read

    shown = show.Output.check(texts, (study,), (".toml", ".csv"))
    files = {"output": shown.target, "resume": texts["resume"]}
    output.check_resume(texts["resume"], shown.target)
    asked = read(study)
    if texts["worth"]:
        asked = replace(asked, worth={**asked.worth, **options.pairs(texts["worth"], "--worth")})
    output.check_not_read(shown.target)
    if isinstance(asked, Fitting):
        output.check_target("--output", shown.target, (".csv",))
        with progress_bar("combinations", kept=shown.target) as progress:
            result = fit(asked, **files, progress=progress).to_result()
    else:
        output.check_target("--output", shown.target, (".toml",))
        with progress_bar(lambda done, whole, step: step, kept=shown.target) as progress:
            result = find_optimum(asked, **files, progress=progress).to_result()
    shown.show(result, write_table=False)
