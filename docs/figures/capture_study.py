"""Bias and spread of the estimators of motion capture on 200 swings; writes capture-study.svg and prints the table."""

import warnings
from pathlib import Path

from clubface import plots
from clubface.motion_capture.study import UNITS, Study, study
from clubface.motion_capture.synthetic import Cameras
from clubface.plots.capture import study_figure

COUNT = 200


def cell(found: Study, name: str, quantity: str) -> str:
    """Write bias and spread."""
    digits = 0 if UNITS[quantity] == "deg/s" else 3
    bias, spread = found.bias(name)[quantity], found.spread(name)[quantity]
    return f"{bias:+.{digits}f} ± {spread:.{digits}f}"


def main() -> None:
    """Run the study without and with noise, on different swings."""
    warnings.simplefilter("ignore")
    exact = study(COUNT, cameras=Cameras(), seed=1)
    noisy = study(COUNT, cameras=Cameras(noise=3e-4), seed=2)
    print("| | " + " | ".join(f"{name}" for found in (exact, noisy) for name in found.errors) + " | covers |")
    for quantity, unit in UNITS.items():
        cells = [cell(found, name, quantity) for found in (exact, noisy) for name in found.errors]
        covers = f"{100.0 * noisy.coverage('smoother')[quantity]:.1f}%"
        print(f"| {quantity.replace('_', ' ')}, {unit} | {' | '.join(cells)} | {covers} |")
    print("largest errors without noise:", {key: f"{value:.2g}" for key, value in exact.worst("smoother").items()})
    target = Path(__file__).with_name("capture-study.svg")
    print("wrote", plots.save(study_figure({"no noise": exact, "0.3 mm\nnoise": noisy}), target))


if __name__ == "__main__":
    main()
