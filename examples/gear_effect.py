"""A map of the face from one batch: ball speed and sidespin of a driver, hit all over its face.

A toe shot starts right and spins back to the left (gear effect); the bulge is designed so that the two nearly cancel.
"""

import sys

import numpy as np

import clubface


def main(picture: str | None = None) -> clubface.Launch:
    """Compute 41 by 21 impacts in one call and print the row through the face centre; draw the map on request."""
    toe = np.linspace(-0.025, 0.025, 41)[:, None]
    high = np.linspace(-0.012, 0.012, 21)[None, :]
    shots = clubface.impact("driver", speed="113 mph", loft="12.8 deg", toe=toe, high=high)
    middle = high.size // 2
    speed, azimuth = shots.get("ball_speed", "mph"), shots.get("azimuth", "deg")
    sidespin = shots.get("sidespin", "rpm")
    print("toe mm   ball mph   azimuth deg   sidespin rpm")
    for i in range(0, toe.size, 8):
        print(f"{toe[i, 0] * 1e3:6.1f}{speed[i, middle]:11.1f}{azimuth[i, middle]:14.2f}{sidespin[i, middle]:15.0f}")
    if picture:
        draw({"ball speed [mph]": speed, "sidespin [rpm]": sidespin}, toe[:, 0], high[0], picture)
    return shots


def draw(maps: dict[str, np.ndarray], toe: np.ndarray, high: np.ndarray, path: str) -> None:
    """Write the maps, values of shape (toe, high), side by side as one picture; ``toe`` and ``high`` in m."""
    import matplotlib.pyplot as plt

    figure, panels = plt.subplots(1, len(maps), figsize=(10, 3.2), layout="constrained")
    for panel, (title, values) in zip(panels, maps.items(), strict=True):
        filled = panel.contourf(toe * 1e3, high * 1e3, np.transpose(values), levels=15)
        figure.colorbar(filled, ax=panel)
        panel.set(title=title, xlabel="toe [mm]", ylabel="high [mm]", aspect="equal")
    figure.savefig(path)


if __name__ == "__main__":
    main(*sys.argv[1:2])
