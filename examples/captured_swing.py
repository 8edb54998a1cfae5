"""From a captured swing to a launch with its error bar: how much of the uncertainty comes from the cameras."""

import tempfile

import numpy as np

import clubface
from clubface.capture import read_swing
from clubface.capture.synthetic import Cameras, synthesize


def main() -> clubface.Launch:
    """Record one synthetic swing with 0.3 mm of noise, read it and compute a thousand launches within its errors."""
    folder = tempfile.mkdtemp()
    files = synthesize(folder, 1, cameras=Cameras(noise=0.3e-3))
    swing = read_swing(files[0], f"{folder}/markers.toml", "driver")
    print(swing)

    launches = clubface.impact("driver", swing.sample(1000))
    for name, unit in (("ball_speed", "mph"), ("launch", "deg"), ("azimuth", "deg"), ("backspin", "rpm")):
        values = launches.get(name, unit)
        print(f"{name:<12} {np.mean(values):9.2f} ± {np.std(values):.2f} {unit}")
    return launches


if __name__ == "__main__":
    main()
