"""``python -m clubface.fem.response BALL FOLDER``: strikes by finite elements and the coefficients fitted to them.

FOLDER gets the table of strikes (an interrupted run goes on after it), the ball's file with the section of the model,
the differences that are left, and their picture.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

from clubface.equipment.balls import ball as rigid_ball
from clubface.errors import ClubfaceError
from clubface.fem.balls import ball
from clubface.fem.response.design import PARTS
from clubface.fem.response.fit import MODEL, PERCENTILES, figure, fit, in_fit, of_clubs, run, summary, weights
from clubface.plots import save
from clubface.support.files import write_text


def main(arguments: list[str]) -> int:
    """Run, fit and write; return the exit status."""
    if len(arguments) != 2:
        print("usage: python -m clubface.fem.response BALL FOLDER", file=sys.stderr)
        return 2
    which, folder = arguments[0], Path(arguments[1])

    def tell(done: int, whole: int) -> None:
        if done % 100 == 0 or done == whole:
            print(f"{done} of {whole} strikes", file=sys.stderr, flush=True)

    try:
        meshed, described = ball(which), rigid_ball(which)
        strikes = run(meshed, PARTS, folder / f"{meshed.name}.csv", progress=tell)
        used = strikes.where(in_fit(strikes, PARTS))
        values = fit(used, weights(used, of_clubs(used, PARTS)))
        values = {name: float(f"{value:.6g}") for name, value in values.items()}
        left = summary(values, strikes, PARTS)
        own = {**described.parameters, MODEL: {**described.parameters.get(MODEL, {}), **values}}
        write_text(folder / f"{meshed.name}.toml", replace(described, parameters=own).to_toml())
        write_text(folder / f"{meshed.name}.json", json.dumps(left, indent=1) + "\n")
        save(figure(values, strikes, PARTS), folder / f"{meshed.name}.svg")
    except KeyboardInterrupt as stopped:
        print(f"interrupted: {stopped}", file=sys.stderr)
        return 130
    except (ClubfaceError, OSError) as error:
        print(f"clubface.fem.response: {error}", file=sys.stderr)
        return 2
    for part, quantities in left.items():
        told = "  ".join(f"{name} {'/'.join(f'{each:.4f}' for each in of)}" for name, of in quantities.items())
        print(f"{part}, percentiles {PERCENTILES}: {told}")
    print(folder / f"{meshed.name}.toml")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
