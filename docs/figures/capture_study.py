"""Bias and spread of the estimators of motion capture on 200 swings; writes capture-study.svg, prints the tables."""

import warnings
from pathlib import Path

import numpy as np

from clubface import plots, units
from clubface.capture.study import UNITS, Study, study, study_picture
from clubface.capture.synthetic.laboratory import Cameras
from clubface.present.drawing import draw

COUNT = 200
LAUNCHES = {"ball_speed": "mph", "launch": "deg", "azimuth": "deg", "backspin": "rpm", "sidespin": "rpm"}


def cell(result: Study, name: str, quantity: str) -> str:
    """Write bias and spread."""
    digits = 0 if UNITS[quantity] == "deg/s" else 3
    bias, spread = result.bias(name)[quantity], result.spread(name)[quantity]
    return f"{bias:+.{digits}f} ± {spread:.{digits}f}"


def launch_table(club: str) -> None:
    """Print the mean absolute errors that captured deliveries alone make in a launch, by noise of the markers."""
    cells: dict[str, list[str]] = {quantity: [] for quantity in LAUNCHES}
    for name in ("linear", "smoother"):
        for noise in (0.0, 1e-4, 3e-4, 5e-4):
            result = study(120, club=club, cameras=Cameras(noise=noise), estimators=(name,), seed=2)
            for quantity, errors in result.launch_errors(name, model="standard").items():
                error = units.from_si(np.abs(errors).mean(), LAUNCHES[quantity])
                cells[quantity].append(f"{error:.0f}" if LAUNCHES[quantity] == "rpm" else f"{error:.2f}")
    for quantity, row in cells.items():
        print(f"| {club}: {quantity}, {LAUNCHES[quantity]} | {' | '.join(row)} |")


def main() -> None:
    """Run the study without and with noise, on different swings."""
    warnings.simplefilter("ignore")
    exact = study(COUNT, cameras=Cameras(), seed=1)
    noisy = study(COUNT, cameras=Cameras(noise=3e-4), seed=2)
    print("| | " + " | ".join(f"{name}" for result in (exact, noisy) for name in result.errors) + " | covers |")
    for quantity, unit in UNITS.items():
        cells = [cell(result, name, quantity) for result in (exact, noisy) for name in result.errors]
        covers = f"{100.0 * noisy.coverage('smoother')[quantity]:.1f}%"
        print(f"| {quantity.replace('_', ' ')}, {unit} | {' | '.join(cells)} | {covers} |")
    print("largest errors without noise:", {key: f"{value:.2g}" for key, value in exact.worst("smoother").items()})
    for club in ("driver", "7-iron"):
        launch_table(club)
    target = Path(__file__).with_name("capture-study.svg")
    print("wrote", plots.save(draw(study_picture({"no noise": exact, "0.3 mm\nnoise": noisy})), target))


if __name__ == "__main__":
    main()
