"""Print, as JSON, what ``clubface shot ... --json`` gives for the shots that the browser tests compare with the pages.

Each shot is its row, SI, by the names of the quantities.
"""

from __future__ import annotations

import io
import json
import sys
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

from clubface import units
from clubface.cli.app import run

SHOTS = Path(__file__).with_name("shots.json")


def options(shot: dict[str, Any]) -> list[str]:
    """Return a shot as it is typed in the command line."""
    given = {name: shot[name] for name in ("model", "ball", "hand") if name in shot} | shot["delivery"]
    return ["shot", shot["club"], *(f"--{name.replace('_', '-')}={value}" for name, value in given.items()), "--json"]


def computed(shot: dict[str, Any]) -> dict[str, float]:
    """Return the row of a shot, SI."""
    printed, remarks = io.StringIO(), io.StringIO()
    with redirect_stdout(printed), redirect_stderr(remarks):
        status = run(options(shot))
    if status:
        raise SystemExit(f"{' '.join(options(shot))}: {remarks.getvalue()}")
    table = json.loads(printed.getvalue())["tables"]["shots"]
    return {
        column["quantity"]: units.parse(
            f"{table['rows'][0][name]!r} {column['unit']}", units.unit(column["unit"]).dimension
        )
        for name, column in table["columns"].items()
        if "quantity" in column and table["rows"][0][name] is not None
    }


def main() -> None:
    """Compute every shot."""
    json.dump([computed(shot) for shot in json.loads(SHOTS.read_text())], sys.stdout)


if __name__ == "__main__":
    main()
