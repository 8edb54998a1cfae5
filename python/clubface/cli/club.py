"""``clubface club``: start a club file of one's own, and check one."""

from __future__ import annotations

from typing import Annotated

import typer

from clubface.cli import options, output

app = typer.Typer(add_completion=False, help="Make and check a club file.", no_args_is_help=True)


@app.command()
def new(
    name: Annotated[str, typer.Argument(metavar="NAME", help="Name of the club.")] = "my-club",
    like: Annotated[
        str | None,
        options.option("--like", metavar="CLUB", text="Start from this club instead of the explained template."),
    ] = None,
    target: options.Template = None,
) -> None:
    """Write a template of a club file."""
    from clubface.equipment.clubs import Club, club

    text = Club.template(name) if like is None else club(like).replace(name=name).to_toml()
    output.write_template(text, target, f"fill it in, then try: clubface club check {target}")


@app.command()
def check(
    file: Annotated[str, typer.Argument(metavar="FILE", help="A club file (TOML).")],
    as_json: options.Json = False,
) -> None:
    """Check the mass, the inertia and the face of a club file, and the limits of the rules."""
    from clubface.cli.clubs import describe, print_club
    from clubface.equipment.clubs import Club

    found = Club.from_toml(file)
    if as_json:
        output.print_json(describe(found))
    else:
        print_club(found)
        print(f"\n{file}: a club that can exist")
