"""One drive with the two-layer ball model: the launch in SI and in golf units."""

import clubface


def main() -> clubface.Launch:
    """Compute and print the launch."""
    shot = clubface.impact("driver", speed="113 mph", attack="-1.3 deg", loft="12.8 deg", model="volumetric")
    print(f"ball speed {shot.ball_speed:.2f} m/s, backspin {shot.backspin:.1f} rad/s")
    print(f"ball speed {shot.get('ball_speed', 'mph'):.1f} mph, backspin {shot.get('backspin', 'rpm'):.0f} rpm")
    print(f"launch {shot.get('launch', 'deg'):.1f} deg, {shot.contact_time * 1e6:.0f} us in contact")
    return shot


if __name__ == "__main__":
    main()
