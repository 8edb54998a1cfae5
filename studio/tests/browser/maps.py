"""Print, as JSON, what ``clubface map ... --json`` gives for the maps that the browser tests compare with the pages.

Each map has its quantity over the face, SI, by toe and height in mm to three digits, its best points, areas, and what
scattered impacts cost.
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

MAPS = Path(__file__).with_name("maps.json")


def options(wanted: dict[str, Any]) -> list[str]:
    """Return a map as it is typed in the command line."""
    given = {name: wanted[name] for name in ("model", "ball", "hand", "minus") if name in wanted}
    given |= wanted["delivery"] | {"quantity": wanted["quantity"], "grid": "41x41", "spread": wanted["spread"]}
    return ["map", wanted["club"], *(f"--{name.replace('_', '-')}={value}" for name, value in given.items()), "--json"]


def si(value: float | None, unit: str, *, difference: bool = False) -> float | None:
    """Return a number of a unit in SI."""
    if value is None:
        return None
    return value * units.size(unit) if difference else units.parse(f"{value!r} {unit}", units.unit(unit).dimension)


def computed(wanted: dict[str, Any]) -> dict[str, Any]:
    """Return what the command prints of a map."""
    printed, remarks = io.StringIO(), io.StringIO()
    with redirect_stdout(printed), redirect_stderr(remarks):
        status = run(options(wanted))
    if status:
        raise SystemExit(f"{' '.join(options(wanted))}: {remarks.getvalue()}")
    tables = json.loads(printed.getvalue())["tables"]
    table = tables[f"map_{wanted['quantity']}"]
    (value,) = (name for name in table["columns"] if name.startswith((wanted["quantity"], "difference_")))
    unit = table["columns"][value]["unit"]
    points = {
        f"{row['toe_mm']:.3f} {row['high_mm']:.3f}": si(row[value], unit, difference="minus" in wanted)
        for row in table["rows"]
        if row[value] is not None
    }
    best = tables["best_points"]["rows"]
    scatter = [row for row in tables["scatter"]["rows"] if row["quantity"] in ("carry", "ball_speed", "side")]
    return {
        "points": points,
        "best": [
            {
                "sweet_spot": [1e-3 * row["sweet_spot_toe_mm"], 1e-3 * row["sweet_spot_high_mm"]],
                "longest": [1e-3 * row["longest_toe_mm"], 1e-3 * row["longest_high_mm"]],
                "effective_area": 1e-6 * row["effective_area_mm2"], "face_area": 1e-6 * row["face_area_mm2"],
            }
            for row in best
        ],
        "scatter": [
            {
                "quantity": row["quantity"], "mean": si(row["mean"], row["unit"]),
                "deviation": si(row["deviation"], row["unit"], difference=True),
                "loss": si(row["loss"], row["unit"], difference=True),
            }
            for row in scatter
        ],
    }  # fmt: skip


def main() -> None:
    """Compute every map."""
    json.dump([computed(each) for each in json.loads(MAPS.read_text())], sys.stdout)


if __name__ == "__main__":
    main()
