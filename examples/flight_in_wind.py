"""One launch flown in still air, against and with the wind, across it, and on a mountain."""

import clubface

CONDITIONS = {
    "still": {},
    "headwind": {"wind": ("-10 mph", 0.0, 0.0)},
    "tailwind": {"wind": ("10 mph", 0.0, 0.0)},
    "from the left": {"wind": (0.0, 0.0, "10 mph")},
    "at 1600 m": {"air": clubface.Air(altitude="1600 m")},
}


def main() -> dict[str, clubface.Flight]:
    """Fly the published average drive under each condition and print where it lands."""
    launch = {"ball_speed": "171 mph", "launch": "10.4 deg", "backspin": "2545 rpm"}
    flights = {name: clubface.fly(launch, **condition) for name, condition in CONDITIONS.items()}
    print(f"{'':<14}{'carry yd':>9}{'side yd':>9}{'apex yd':>9}{'landing deg':>13}{'time s':>8}")
    for name, flight in flights.items():
        print(
            f"{name:<14}{flight.get('carry', 'yd'):9.1f}{flight.get('side', 'yd'):9.1f}{flight.get('apex', 'yd'):9.1f}"
            f"{flight.get('landing_angle', 'deg'):13.1f}{flight.flight_time:8.2f}"
        )
    return flights


if __name__ == "__main__":
    main()
