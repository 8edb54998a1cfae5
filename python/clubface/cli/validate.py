"""``clubface validate``: models compared with published figures, with tolerances."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, show
from clubface.cli.output import progress_bar
from clubface.equipment.models import DEFAULT_MODEL

app = typer.Typer(add_completion=False)

CHOICE = options.group(None,
    check=(options.Texts, None, "NAME",
           "Only this check, or several, comma-separated or repeated, with every figure and its source."),
    model=(options.Texts, None, "NAME", "A model, or several, comma-separated or repeated; all: every reduced model."
           f" Default {DEFAULT_MODEL}."),
    causes=(bool, False, None,
            "Repeat off-centre strikes with one thing changed: closure, inertia or depth of the centre of mass."),
)  # fmt: skip
_WITH_TEXT = "A monitor's file, whose spins are compared with the model and both camps of published irons. Repeatable."


@app.command()
@options.takes(show.FOLDER, options.BALL, CHOICE, show.JSON)
def validate(
    session: Annotated[list[str] | None, options.option("--with", metavar="FILE", text=_WITH_TEXT)] = None, **texts: Any
) -> None:
    """Compare models with published figures, and show which ones they meet."""
    from clubface.validation.catalogue import check_named
    from clubface.validation.off_centre import causes as causes_table
    from clubface.validation.own_monitor import own_monitor
    from clubface.validation.run import validate as run

    models = options.model_names(texts["model"], DEFAULT_MODEL)
    checks = options.names(texts["check"]) or None
    for each in checks or ():
        check_named(each)  # checked before the work, so that an unknown name is reported at once
    output = show.Output.check(texts, [texts["ball"], *(session or ())])
    own = own_monitor(session, model=models[0], ball=texts["ball"]).to_result() if session else None
    with progress_bar("checks") as progress:
        result = run(models, checks=checks, ball=texts["ball"], progress=progress).to_result(detailed=bool(checks))
    if texts["causes"]:
        result = result.replace(tables=(*result.tables, causes_table(models, texts["ball"])))
    if own is not None:
        result = result.replace(tables=(*result.tables, *own.tables), notes=(*result.notes, *own.notes))
    output.show(result)
