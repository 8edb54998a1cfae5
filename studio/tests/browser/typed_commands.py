"""Print, as JSON, what commands give that a page shows, each typed as it stands there.

``python typed_commands.py COMMANDS.json``: a list of ``clubface shot ...`` commands, run in the folder of the list.
Each shot is its row, SI, by the names of the quantities.
"""

from __future__ import annotations

import io
import json
import os
import shlex
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

from clubface import units
from clubface.cli.app import run


def row(command: str) -> dict[str, float]:
    """Return the first shot that a command prints, SI."""
    output, remarks = io.StringIO(), io.StringIO()
    with redirect_stdout(output), redirect_stderr(remarks):
        status = run([*shlex.split(command)[1:], "--json"])
    if status:
        raise SystemExit(f"{command}: {remarks.getvalue()}")
    table = json.loads(output.getvalue())["tables"]["shots"]
    values = table["rows"][0]
    return {
        column["quantity"]: units.parse(f"{values[name]!r} {column['unit']}", units.unit(column["unit"]).dimension)
        for name, column in table["columns"].items()
        if "quantity" in column and values[name] is not None
    }


def main(path: str) -> None:
    """Run every command."""
    commands = json.loads(Path(path).read_text())
    os.chdir(Path(path).parent)
    json.dump([row(each) for each in commands], sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
