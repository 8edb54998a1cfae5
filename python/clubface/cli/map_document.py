"""What ``clubface map`` found as JSON has it, and as a table of a file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from clubface.cli.quantity_units import KEYS
from clubface.units import from_si, size


def document(found: Any, maps: Sequence[Any], spreads: Sequence[Any], names: Sequence[str]) -> dict[str, Any]:
    """Return maps, what scattered impacts cost on them, and the values of ``names`` over the grid, as JSON has them."""
    told = []
    for place, each in enumerate(maps):
        best, carry = each.best(), each.best("carry")
        entry = {
            "club": each.centre.club.name, "ball": each.centre.ball.name, "model": each.centre.model,
            "parameters": each.centre.parameters.name, "outline": each.outline.told, "interpolated": each.interpolated,
            "face_area_mm2": from_si(each.outline.area(), "mm2"), "area_98_mm2": from_si(each.area(), "mm2"),
            "sweet_spot": {"toe_mm": 1e3 * best.toe, "high_mm": 1e3 * best.high, "ball_speed_mps": best.value},
            "longest_carry": {"toe_mm": 1e3 * carry.toe, "high_mm": 1e3 * carry.high, "carry_m": carry.value},
        }  # fmt: skip
        if spreads:
            entry["spread"] = _spread_document(spreads[place])
        told.append(entry)
    whole: dict[str, Any] = {
        "clubs": told, "grid": [len(found.toe), len(found.high)],
        "toe_mm": (1e3 * found.toe).tolist(), "high_mm": (1e3 * found.high).tolist(),
    }  # fmt: skip
    kind = "map" if len(maps) == 1 else "difference"
    wanted = {key: of for key, of in KEYS.items() if of[0] in names}
    whole[kind] = {key: (found.get(name) / size(unit)).tolist() for key, (name, unit) in wanted.items()}
    return whole


def _spread_document(spread: Any) -> dict[str, Any]:
    def cells(part: Mapping[str, float]) -> dict[str, float]:
        return {key: part[name] / size(unit) for key, (name, unit) in KEYS.items()}

    return {
        "toe_mm": 1e3 * spread.toe, "high_mm": 1e3 * spread.high, "toe_deviation_mm": 1e3 * spread.toe_deviation,
        "high_deviation_mm": 1e3 * spread.high_deviation, "missed": spread.missed, "mean": cells(spread.mean),
        "deviation": cells(spread.deviation), "loss": cells(spread.loss),
    }  # fmt: skip


def columns(found: Any) -> dict[str, Any]:
    """Return the map as a long table, in the units of its headings."""
    table = found.columns()
    told = {f"{name}_mm": from_si(table[name], "mm") for name in ("toe", "high")}
    told |= {key: table[name] / size(unit) for key, (name, unit) in KEYS.items()}
    if hasattr(found, "second"):
        told = {key if key in ("toe_mm", "high_mm") else f"difference_{key}": each for key, each in told.items()}
    return told
