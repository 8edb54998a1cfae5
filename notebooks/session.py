"""Write ``session.csv``: drives of a golfer who is known, as a TrackMan would show them.

The notebook on fitting takes the file as if it knew nothing of the golfer, and so it can be checked. The golfer is the
shipped ``handicap-10-driver``, the model the default one; errors of measurement are assumed.
"""

import csv
import sys
from pathlib import Path

import numpy as np

import clubface
from clubface.design.golfer import golfer
from clubface.shots.reference_points import as_seen
from clubface.units import from_si

COUNT, SEED = 60, 24
COLUMNS = {
    "speed": ("Club Speed", "mph", 0.3, 1), "attack": ("Attack Angle", "deg", 0.2, 1),
    "path": ("Club Path", "deg", 0.2, 1), "loft": ("Dyn. Loft", "deg", 0.2, 1), "face": ("Face Angle", "deg", 0.2, 1),
    "ball_speed": ("Ball Speed", "mph", 0.2, 1), "launch": ("Launch Angle", "deg", 0.1, 1),
    "azimuth": ("Launch Direction", "deg", 0.1, 1), "total_spin": ("Spin Rate", "rpm", 40.0, 0),
    "spin_axis": ("Spin Axis", "deg", 0.5, 1), "carry": ("Carry Flat - Length", "yds", 1.0, 1),
    "side": ("Carry Flat - Side", "yds", 1.0, 1), "toe": ("Impact Offset", "mm", 1.0, 0),
    "high": ("Impact Height", "mm", 1.0, 0),
}  # fmt: skip
"""Heading, unit, standard error and decimals of each column; the errors are assumed."""


def main(path: Path) -> None:
    """Write the session."""
    random = np.random.default_rng(SEED)
    deliveries = golfer("handicap-10-driver").sample(COUNT, seed=SEED)
    # The order of quasi-random shots is no accident, that of a session is.
    order = random.permutation(COUNT)
    deliveries = {name: values[order] for name, values in deliveries.items()}
    launch = clubface.impact("driver", deliveries)
    flight = clubface.fly(launch)
    seen = as_seen(deliveries, clubface.club("driver"), speed_at="cg", face_at="contact")
    shown = []
    for name, (_, unit, error, decimals) in COLUMNS.items():
        values = seen[name] if name in seen else getattr(launch if hasattr(launch, name) else flight, name)
        values = from_si(values, unit) + error * random.standard_normal(COUNT)
        shown.append([f"{each:.{decimals}f}" for each in values])
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["Club", *(heading for heading, *_ in COLUMNS.values())])
        writer.writerow(["", *(f"[{unit}]" for _, unit, *_ in COLUMNS.values())])
        writer.writerows(["Driver", *row] for row in zip(*shown, strict=True))


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).with_name("session.csv")))
