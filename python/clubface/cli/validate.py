"""``clubface validate``: models compared with published figures, with tolerances."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, show
from clubface.cli.output import progress_bar
from clubface.equipment.models import DEFAULT_MODEL

app = typer.Typer(add_completion=False)

_MODEL_TEXT = (
    f"A model, or several with commas or repeated; all means every reduced model. {DEFAULT_MODEL} unless given."
)
_MODEL = options.option("--model", metavar="NAME", text=_MODEL_TEXT)
_CHECK_TEXT = "Only this check, or several with commas or repeated, with every figure and its source."
_WITH_TEXT = "A monitor's file whose spins are compared with the model and both camps of published irons. Repeatable."
_WITH = options.option("--with", metavar="FILE", text=_WITH_TEXT)
_CHECK = options.option("--check", metavar="NAME", text=_CHECK_TEXT)
_CAUSES_TEXT = "Also strikes off the centre with one thing changed: closure, inertia or depth of the mass centre."
_CAUSES = typer.Option("--causes", help=_CAUSES_TEXT)


@app.command()
@options.takes(show.FOLDER, options.BALL, show.JSON)
def validate(
    check: Annotated[list[str] | None, _CHECK] = None,
    model: Annotated[list[str] | None, _MODEL] = None,
    causes: Annotated[bool, _CAUSES] = False,
    session: Annotated[list[str] | None, _WITH] = None,
    **texts: Any,
) -> None:
    """Compare models with published figures, and say which of them they meet."""
    from clubface.validation.catalogue import check_named
    from clubface.validation.off_centre import causes as causes_table
    from clubface.validation.own_monitor import own_monitor
    from clubface.validation.run import validate as run

    models = options.model_names(model, DEFAULT_MODEL)
    checks = options.names(check) or None
    for each in checks or ():
        check_named(each)  # before the work: a name that does not exist is found at once
    output = show.Output.check(texts, [texts["ball"], *(session or ())])
    own = own_monitor(session, model=models[0], ball=texts["ball"]).to_result() if session else None
    with progress_bar("checks") as progress:
        result = run(models, checks=checks, ball=texts["ball"], progress=progress).to_result(detailed=bool(checks))
    if causes:
        result = result.replace(tables=(*result.tables, causes_table(models, texts["ball"])))
    if own is not None:
        result = result.replace(tables=(*result.tables, *own.tables), notes=(*result.notes, *own.notes))
    output.show(result)
