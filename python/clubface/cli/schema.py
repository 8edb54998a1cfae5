"""``clubface schema``: the JSON Schema of TOML files, for completion and checks in editors."""

from __future__ import annotations

import json
from typing import Annotated

import typer

from clubface.cli.options import argument

app = typer.Typer(add_completion=False)


@app.command()
def schema(name: Annotated[str | None, argument("[NAME]", "Print the schema of this kind of file.")] = None) -> None:
    """List the kinds of TOML files, or print the JSON Schema of one for an editor."""
    from clubface.schema import FILES, file_schema, json_schema

    print("\n".join(FILES) if name is None else json.dumps(json_schema(file_schema(name), name), indent=2))
