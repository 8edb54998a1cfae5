"""The mirror image of a shot: which signs change for a left-hander, and which do not."""

import clubface


def main() -> tuple[clubface.Launch, clubface.Launch]:
    """Print a toe-side push by a right-hander, and the left-handed shot that is its reflection in the target line."""
    delivery = clubface.Delivery(speed="105 mph", attack="2 deg", loft="13 deg", toe="10 mm", closure="2000 deg/s")
    right = clubface.impact("driver", delivery, path="3 deg", face="1 deg", hand="right")
    left = clubface.impact("driver", delivery, path="-3 deg", face="-1 deg", hand="left")
    for name, shot in {"right-handed": right, "left-handed": left}.items():
        print(
            f"{name:<13} ball speed {shot.get('ball_speed', 'mph'):.1f} mph, "
            f"azimuth {shot.get('azimuth', 'deg'):+.2f} deg, sidespin {shot.get('sidespin', 'rpm'):+.0f} rpm"
        )
    return right, left


if __name__ == "__main__":
    main()
