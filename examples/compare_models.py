"""One 7-iron shot with every model: where they agree, and where they differ."""

import clubface


def main() -> clubface.Comparison:
    """Compute the launch with every registered model and print one line each."""
    launches = clubface.impact("7-iron", speed="92 mph", attack="-3.9 deg", loft="22 deg", model="all")
    print(f"{'model':<12}{'ball mph':>9}{'launch deg':>12}{'backspin rpm':>14}{'contact us':>12}{'peak kN':>9}")
    for name, shot in launches.items():
        print(
            f"{name:<12}{shot.get('ball_speed', 'mph'):9.1f}{shot.get('launch', 'deg'):12.2f}"
            f"{shot.get('backspin', 'rpm'):14.0f}{shot.contact_time * 1e6:12.0f}{shot.peak_force / 1e3:9.1f}"
        )
    return launches


if __name__ == "__main__":
    main()
