"""How well motion capture reads synthetic swings; writes capture-study.svg and docs/capture-study.json."""

import json
import warnings
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from clubface import plots, units
from clubface.capture.reduction import QUANTITIES
from clubface.capture.study import UNITS, Study, bare_study, study, study_picture
from clubface.capture.synthetic.laboratory import Cameras
from clubface.present.drawing import draw

FOLDER = Path(__file__).parent
STORED = FOLDER.parent / "capture-study.json"
COUNT, BARE = 200, 100
"""Swings that are read with a ball and without."""
WORKERS = 5
NOISES = (0.0, 3e-4)
"""Of the markers [m], in the table of launches."""
CLUBS = {"driver": "right", "7-iron": "left"}
"""Clubs, and the hand of the player in the studies of intervals."""
LAUNCHES = {"ball_speed": "mph", "launch": "deg", "azimuth": "deg", "backspin": "rpm", "sidespin": "rpm"}


def launch_errors(club: str, estimator: str) -> dict[str, list[float]]:
    """Return mean absolute errors that captured deliveries alone make in a launch [LAUNCHES], by noise."""
    errors: dict[str, list[float]] = {quantity: [] for quantity in LAUNCHES}
    for noise in NOISES:
        result = study(120, club=club, cameras=Cameras(noise=noise), estimators=(estimator,), seed=2)
        for quantity, values in result.launch_errors(estimator, model="standard").items():
            errors[quantity].append(units.from_si(np.abs(values).mean(), LAUNCHES[quantity]))
    return errors


def speed_shares(result: Study, estimator: str) -> dict[str, float]:
    """Return the mean and the largest error of the speed, in parts of it."""
    place = QUANTITIES.index("speed")
    parts = result.errors[estimator][:, place] / result.truth[:, place]
    return {"mean": float(parts.mean()), "worst": float(np.abs(parts).max())}


def bare_intervals(club: str) -> dict[str, Any]:
    """Return what readings without a ball come to by calibration: refused swings, spreads [UNITS], 90% intervals."""
    result = bare_study(BARE, club=club, hand=CLUBS[club], seed=5)
    refused = {way: np.isnan(errors[:, 0]) for way, errors in result.errors.items()}
    return {
        "refused": {way: int(each.sum()) for way, each in refused.items()},
        "refused_by_all": int(np.logical_and.reduce(list(refused.values())).sum()),
        "coverage": {way: result.coverage(way, 0.9) for way in result.errors},
        "spread": {
            way: {
                name: units.from_si(np.nanstd(errors[:, place], ddof=1), UNITS[name])
                for place, name in enumerate(QUANTITIES)
            }
            for way, errors in result.errors.items()
        },
        "touch_us": {way: units.from_si(np.nanstd(each, ddof=1), "us") for way, each in result.touches.items()},
    }


def rounded(value: Any) -> Any:
    """Return a document with six digits of each number."""
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    if isinstance(value, list):
        return [rounded(each) for each in value]
    return float(f"{value:.6g}") if isinstance(value, (float, np.floating)) else value


def estimated(noise: float, seed: int) -> Study:
    """Return the errors of all estimators on drives."""
    return study(COUNT, cameras=Cameras(noise=noise), seed=seed)


def intervals(club: str) -> dict[str, float]:
    """Return how often 95% intervals of the smoother hold the truth in 400 swings."""
    cameras = Cameras(noise=3e-4)
    return study(400, club=club, hand=CLUBS[club], cameras=cameras, estimators=("smoother",), seed=2).coverage(
        "smoother"
    )


def main() -> None:
    """Run the studies side by side, those without and with noise on different swings."""
    warnings.simplefilter("ignore")
    with ProcessPoolExecutor(WORKERS) as pool:
        bare = {club: pool.submit(bare_intervals, club) for club in CLUBS}
        covered = {club: pool.submit(intervals, club) for club in CLUBS}
        both = {label: pool.submit(estimated, *each) for label, each in {"exact": (0.0, 1), "noisy": (3e-4, 2)}.items()}
        launches = {
            club: {name: pool.submit(launch_errors, club, name) for name in ("smoother", "linear")} for club in CLUBS
        }
    exact, noisy = (each.result() for each in both.values())
    document = {
        "swings": COUNT,
        "bare_swings": BARE,
        "errors": {
            label: {name: {"bias": each.bias(name), "spread": each.spread(name)} for name in each.errors}
            for label, each in {"exact": exact, "noisy": noisy}.items()
        },
        "coverage": noisy.coverage("smoother"),
        "worst": exact.worst("smoother"),
        "speed": {name: speed_shares(exact, name) for name in exact.errors},
        "launches": {
            club: {name: each.result() for name, each in sorted(results.items())} for club, results in launches.items()
        },
        "intervals": {club: each.result() for club, each in covered.items()},
        "bare": {club: each.result() for club, each in bare.items()},
    }
    STORED.write_text(json.dumps(rounded(document), indent=1) + "\n", encoding="utf-8")
    picture = draw(study_picture({"no noise": exact, "0.3 mm\nnoise": noisy}))
    print("wrote", STORED, plots.save(picture, FOLDER / "capture-study.svg"))


if __name__ == "__main__":
    main()
