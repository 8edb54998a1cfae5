"""``clubface club``: start a club file of your own, and check one."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface import units
from clubface.cli import options, output, show
from clubface.errors import InputError
from clubface.schema import quoted
from clubface.support.checks import check_choice

if TYPE_CHECKING:
    from clubface.equipment.clubs import Club


WHOLE, INERTIA = "inertia", ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
"""Names in ``--set`` of the whole inertia tensor and of its elements."""

app = typer.Typer(add_completion=False, help="Make and check a club file.", no_args_is_help=True)


@app.command()
@options.takes(options.group(None,
    like=(str | None, None, "CLUB", "Start from this club instead of the commented template."),
    set=(options.Texts, None, '"cg_x=38 mm"',
         "Change a value; several: comma-separated or repeated; inertia=+10% scales the whole tensor."),
))  # fmt: skip
def new(
    name: Annotated[str, options.argument("NAME", "Name of the club.")] = "my-club",
    target: options.Template = None,
    **texts: Any,
) -> None:
    """Write a template of a club file."""
    from clubface.equipment.clubs import Club, club

    like, settings = texts["like"], texts["set"] or []
    source = None if like is None else club(like)
    base = Club.from_text(Club.template(name)) if source is None else source.replace(name=name)
    typed = options.pairs([part for each in settings for part in each.split(",")], "--set")
    words = ", ".join(f"{key} {value}" for key, value in typed.items())
    changes = _changes(base, typed)
    changed = base.replace(**changes)  # raises an error for impossible values
    if source is not None and changes:  # the description of the base club may no longer apply
        changed = changed.replace(description=f"{source.name} with {words}")
    text = changed.to_toml() if source is not None else _template(name, changes)
    output.write_template(text, target, f"fill it in, then try: clubface club check {target}")


def _changes(base: Club, typed: dict[str, str]) -> dict[str, Any]:
    """Return the fields to change; a whole inertia tensor becomes its elements."""
    from clubface.equipment.clubs import CLUB_PROPERTIES

    for key in typed:
        check_choice("change of a club", key, [*CLUB_PROPERTIES, WHOLE])
    whole = typed.pop(WHOLE, None)
    if whole is None:
        return dict(typed)
    factor = _factor(whole)
    scaled = {key: f"{units.from_si(factor * getattr(base, key), 'g cm2'):.6g} g cm2" for key in INERTIA}
    return scaled | typed


def _template(name: str, changes: dict[str, Any]) -> str:
    """Return the commented template with changed values."""
    from clubface.equipment.clubs import Club

    text = Club.template(name)
    for key, value in changes.items():
        other = {"cor": "characteristic_time", "characteristic_time": "cor"}.get(key)
        if other is not None:  # only one of them describes the face
            text = re.sub(rf"^{other} = ", f"# {other} = ", text, flags=re.MULTILINE)
        entry = f"{key} = {quoted(value)}"
        text = re.sub(rf"^(?:# )?{key} = .*?( +#.*)?$", lambda line, new=entry: f"{new:<27} {(line[1] or '').strip()}",
                      text, count=1, flags=re.MULTILINE)  # fmt: skip
    return text


def _factor(text: str) -> float:
    """Return the factor for "+10%" or "-5 %"."""
    result = re.fullmatch(r"([+-]\s*\d+(?:\.\d*)?)\s*%", text)
    if result is None:
        raise InputError(f"--set {WHOLE}", text, 'a change in per cent, as in "inertia=+10%"')
    return 1.0 + float(result[1].replace(" ", "")) / 100.0


@app.command()
@options.takes(show.REPORT, show.JSON)
def check(file: Annotated[str, options.argument("FILE", "A club file (TOML).")], **texts: Any) -> None:
    """Check the mass, inertia and face in a club file, and the limits of the rules."""
    from clubface.design.rules import check_result
    from clubface.equipment.clubs import Club

    output = show.Output.check(texts, [file])
    output.show(check_result(Club.from_toml(file), file))
