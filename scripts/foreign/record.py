"""Results of runs on other machines, for the table of docs/versions.md."""

from __future__ import annotations

import json
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from targets import ROOT, Target

RECORD = ROOT / "docs" / "tested-machines.json"
KIND = ("target", "what")


def record(target: Target, what: str, how: str, results: dict[str, Any], path: Path = RECORD) -> None:
    """Put a result into the file of the documentation, in place of an earlier one of the same kind."""
    run = {
        "target": target.triple,
        "what": what,
        "how": how,
        "date": datetime.now(UTC).date().isoformat(),
        **results,
    }
    runs = json.loads(path.read_text(encoding="utf-8")) if path.exists() else []
    runs = [each for each in runs if any(each[key] != run[key] for key in KIND)]
    runs = sorted([*runs, run], key=lambda each: [each[key] for key in KIND])
    path.write_text(json.dumps(runs, indent=1) + "\n", encoding="utf-8")
