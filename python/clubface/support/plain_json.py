"""Results as JSON has them: numbers, texts, lists and mappings, nothing else."""

from __future__ import annotations

import math
from typing import Any


def plain(value: Any) -> Any:
    """Return ``value`` made of what JSON has; numpy numbers and arrays included."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict) or hasattr(value, "items"):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return value
