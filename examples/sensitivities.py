"""What a drive is sensitive to: exact derivatives, and the scatter in launch caused by a scatter in delivery."""

import math

import clubface

SPREAD = {"speed": (1.0, "mph"), "attack": (1.0, "deg"), "loft": (1.5, "deg"), "face": (2.0, "deg"), "toe": (8.0, "mm")}
"""Standard deviations assumed for a player's delivery."""


def main() -> dict[str, float]:
    """Print the table of derivatives and the scatter in launch that follows for small, independent spreads."""
    table = clubface.sensitivity(
        "driver",
        speed="113 mph",
        attack="-1.3 deg",
        loft="12.8 deg",
        model="volumetric",
        outputs=("ball_speed", "launch", "azimuth", "backspin", "sidespin"),
        variables=tuple(SPREAD),
    )
    print(table)
    scatter = {}
    for output, unit in {"ball_speed": "mph", "launch": "deg", "backspin": "rpm", "sidespin": "rpm"}.items():
        parts = [table.value(output, name, f"{unit} per {per}") * size for name, (size, per) in SPREAD.items()]
        scatter[output] = math.hypot(*parts)
        print(f"scatter of {output}: {scatter[output]:.3g} {unit}")
    return scatter


if __name__ == "__main__":
    main()
