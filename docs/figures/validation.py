"""Models compared with published figures: writes validation.svg, and what the finite elements make of them as a file.

The finite elements take some minutes, too long for every build of the pages, which compute the other models themselves.
``--fem CHECK ...`` computes them for these checks alone, and for none of them without a name; the others stay stored.
"""

from __future__ import annotations

import argparse
import json
import math
from pathlib import Path

from clubface import plots
from clubface.equipment.models import DEFAULT_MODEL
from clubface.present.drawing import draw
from clubface.validation import Figure, validate
from clubface.validation.catalogue import CHECKS
from clubface.validation.run import validation_picture

HERE = Path(__file__).parent
STORED = HERE.parent / "validation-fem.json"
DRAWN = (DEFAULT_MODEL, "slip", "rings")
DIGITS = 9


def key(each: Figure) -> str:
    """Return the name under which a figure is stored."""
    return f"{each.case}: {each.quantity}"


def stored(figures: list[Figure]) -> dict[str, float | None]:
    """Return what is computed, SI, by what it is; None where nothing is."""
    return {key(each): None if each.within is None else float(f"{each.computed:.{DIGITS}g}") for each in figures}


def progress(done: int, whole: int) -> None:
    """Show how many checks are done."""
    print(f"{done} of {whole}", end="\r", flush=True)


def main() -> None:
    """Compute, write, draw."""
    parser = argparse.ArgumentParser(description="Draw validation.svg and store what finite elements compute.")
    names = [each.name for each in CHECKS]
    parser.add_argument("--fem", nargs="*", choices=names, metavar="CHECK", help="the checks to compute; all without")
    wanted = parser.parse_args().fem
    wanted = names if wanted is None else wanted
    computed = json.loads(STORED.read_text(encoding="utf-8")) if set(wanted) != set(names) else {}
    if wanted:
        by_fem = validate("fem", checks=wanted, progress=progress).figures["fem"]
        computed |= {check: stored(figures) for check, figures in by_fem.items()}
    STORED.write_text(json.dumps({name: computed[name] for name in names}, indent=1) + "\n", encoding="utf-8")
    result = validate(DRAWN)
    result.figures["fem"] = {
        check: [
            each._replace(computed=math.nan if (value := computed[check][key(each)]) is None else value)
            for each in figures
        ]
        for check, figures in result.figures[DEFAULT_MODEL].items()
    }
    print("wrote", STORED, plots.save(draw(validation_picture(result)), HERE / "validation.svg"))


if __name__ == "__main__":
    main()
