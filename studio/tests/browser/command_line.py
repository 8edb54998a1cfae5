"""Print, as JSON, what the command line gives with ``--json`` for what the browser tests compare with the pages.

``command_line.py flights.json`` prints the row of each shot of a file, SI, by the names of the quantities;
``command_line.py dispersions.json`` the statistics of each golfer's shots, by quantity and by part.
"""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Mapping
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any

from clubface import units
from clubface.cli.app import run
from clubface.simulation.flight import conditions as flight_inputs_of

HERE = Path(__file__).parent
COUNT = 4096
HOLE = "400 yd"


def conditions(given: Mapping[str, str]) -> dict[str, str]:
    """Return wind, air and ground as options; the wind, which a page has by where it comes from, by its components."""
    rest = {name: value for name, value in given.items() if name not in ("wind", "wind_from")}
    if "wind" not in given:
        return rest
    from_ = units.parse(given["wind_from"], "angle")
    blowing = flight_inputs_of(
        None, {"wind_speed": given["wind"], "wind_direction": from_ + units.parse("180 deg", "angle")}
    )
    return {**rest, "wind": f"{blowing['wind_x']!r} m/s, {blowing['wind_z']!r} m/s"}


def printed(command: list[str], given: Mapping[str, str]) -> dict[str, Any]:
    """Return what a command prints as JSON."""
    arguments = [*command, *(f"--{name.replace('_', '-')}={value}" for name, value in given.items()), "--json"]
    output, remarks = io.StringIO(), io.StringIO()
    with redirect_stdout(output), redirect_stderr(remarks):
        status = run(arguments)
    if status:
        raise SystemExit(f"{' '.join(arguments)}: {remarks.getvalue()}")
    return json.loads(output.getvalue())


def si(value: float, unit: str) -> float:
    """Return a printed number in SI."""
    return units.parse(f"{value!r} {unit}", units.unit(unit).dimension)


def shot(listed: Mapping[str, Any]) -> dict[str, float]:
    """Return the row of a shot, SI."""
    given = {name: listed[name] for name in ("model", "ball", "hand") if name in listed}
    return row(printed(["shot", listed["club"]], given | listed["delivery"] | conditions(listed.get("conditions", {}))))


def row(result: Mapping[str, Any]) -> dict[str, float]:
    """Return the first shot that a command printed, SI."""
    table = result["tables"]["shots"]
    return {
        column["quantity"]: si(table["rows"][0][name], column["unit"])
        for name, column in table["columns"].items()
        if "quantity" in column and table["rows"][0][name] is not None
    }


def dispersion(listed: Mapping[str, Any]) -> dict[str, Any]:
    """Return means, spreads and quantiles of a golfer's shots, SI, and the strokes on a hole."""
    given = {"hand": listed["hand"], "count": str(COUNT), "hole": HOLE} | conditions(listed["conditions"])
    result = printed(["dispersion", listed["golfer"], "--no-shares"], given)
    (strokes,) = result["tables"]["strokes"]["rows"]
    parts: dict[str, Any] = {"strokes": strokes["strokes_after"], "lost": result["values"]["lost"]}
    for row in result["tables"]["quantities"]["rows"]:
        zero = si(0.0, row["unit"])
        for name, value in row.items():
            if name in ("mean", "spread") or name.startswith("quantile_"):
                offset = zero if name == "spread" else 0.0
                parts[f"{row['quantity']} {name.removeprefix('quantile_')}"] = si(value, row["unit"]) - offset
    return parts


def main(name: str) -> None:
    """Compute every entry of a file."""
    each = dispersion if name.startswith("dispersions") else shot
    json.dump([each(listed) for listed in json.loads((HERE / name).read_text())], sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
