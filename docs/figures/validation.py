"""Models beside published figures: writes validation.svg, and what the finite elements make of them as a file.

The finite elements take some minutes, too long for every build of the pages, which compute the other models themselves.
"""

from __future__ import annotations

import json
from pathlib import Path

from clubface import plots
from clubface.equipment.models import DEFAULT_MODEL
from clubface.validation import Figure, validate
from clubface.validation.figures import validation_figure

HERE = Path(__file__).parent
STORED = HERE.parent / "validation-fem.json"
DRAWN = (DEFAULT_MODEL, "slip", "rings", "fem")
DIGITS = 9


def stored(figures: list[Figure]) -> dict[str, float | None]:
    """Return what is computed, SI, by what it is; None where nothing is."""
    return {
        f"{each.what}: {each.quantity}": None if each.within is None else float(f"{each.computed:.{DIGITS}g}")
        for each in figures
    }


def main() -> None:
    """Compute, write, draw."""
    found = validate(DRAWN, progress=lambda done, of: print(f"{done} of {of}", end="\r", flush=True))
    computed = {check: stored(figures) for check, figures in found.figures["fem"].items()}
    STORED.write_text(json.dumps(computed, indent=1, allow_nan=False) + "\n", encoding="utf-8")
    print("wrote", STORED, plots.save(validation_figure(found), HERE / "validation.svg"))


if __name__ == "__main__":
    main()
