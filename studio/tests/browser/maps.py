"""Print, as JSON, what ``clubface map ... --json`` gives for the maps that the browser tests compare with the pages.

Each map has its quantity over the face, SI, by toe and height in mm to three digits, its best points, areas, and what
scattered impacts cost.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

from clubface import units
from command_line import printed, si

MAPS = Path(__file__).with_name("maps.json")


def difference_in_si(value: float | None, unit: str) -> float | None:
    """Return a difference of two numbers of a unit in SI; None for none."""
    return None if value is None else value * units.size(unit)


def computed(wanted: dict[str, Any]) -> dict[str, Any]:
    """Return what the command prints of a map."""
    given = {name: wanted[name] for name in ("model", "ball", "hand", "minus") if name in wanted}
    given |= wanted["delivery"] | {"quantity": wanted["quantity"], "grid": "41x41", "spread": wanted["spread"]}
    tables = printed(["map", wanted["club"]], given)["tables"]
    table = tables[f"map_{wanted['quantity']}"]
    (value,) = (name for name in table["columns"] if name.startswith((wanted["quantity"], "difference_")))
    unit = table["columns"][value]["unit"]
    read = difference_in_si if "minus" in wanted else si
    points = {
        f"{row['toe_mm']:.3f} {row['high_mm']:.3f}": read(row[value], unit)
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
                "quantity": row["quantity"],
                "mean": None if row["mean"] is None else si(row["mean"], row["unit"]),
                "deviation": difference_in_si(row["deviation"], row["unit"]),
                "loss": difference_in_si(row["loss"], row["unit"]),
            }
            for row in scatter
        ],
    }  # fmt: skip


def main() -> None:
    """Compute every map."""
    json.dump([computed(each) for each in json.loads(MAPS.read_text())], sys.stdout)


if __name__ == "__main__":
    main()
