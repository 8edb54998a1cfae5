"""Sessions before a monitor: shots that a model makes, with noise, whose loft is measured or computed from the ball."""

import numpy as np

import clubface
from clubface.shots.recorded import RecordedShots

DEG = np.pi / 180.0
USUAL = {"driver": (14.0, 1.0, 46.0), "7-iron": (25.0, -4.0, 36.0), "pitching-wedge": (40.0, -5.0, 32.0)}
"""Dynamic loft [deg], attack angle [deg] and club speed [m/s]."""
ROLLING = 83.36e-7 / (45.9e-3 * 21.3e-3)
"""I / (m R) of the ball of Caldwell and McPhee (2023) [m]."""


def normal_of_ball(launches, ratio):
    """Dynamic loft and face angle [rad] of a normal from which the ball leaves with I w / (m R v_t) = ratio.

    The normal lies in the plane that holds the direction of launch and is perpendicular to the spin axis.
    """
    launch, azimuth = launches["launch"], launches["azimuth"]
    spin = np.hypot(launches["backspin"], launches["sidespin"])
    angle = np.arcsin(np.clip(ROLLING * spin / launches["ball_speed"] / ratio, -1.0, 1.0))
    tilt = np.arctan2(launches["sidespin"], launches["backspin"])
    away = np.array([np.cos(launch) * np.cos(azimuth), np.sin(launch), np.cos(launch) * np.sin(azimuth)])
    up = np.array([-np.sin(launch) * np.cos(azimuth), np.cos(launch), -np.sin(launch) * np.sin(azimuth)])
    right = np.array([-np.sin(azimuth), np.zeros_like(azimuth), np.cos(azimuth)])
    normal = np.cos(angle) * away + np.sin(angle) * (np.cos(tilt) * up - np.sin(tilt) * right)
    return np.arcsin(normal[1]), np.arctan2(normal[2], normal[0])


def session(club, shots, *, seed=1, ratio=None, step=None, noise=1.0, strikes=True, file_club=None, **made):
    """Shots of one club: loft and face measured, or computed from the ball with ``ratio``; angles rounded to ``step``
    [deg]. The monitor's noise is 0.2 degrees and 50 rpm in the launch and 0.25 degrees in face and loft, times
    ``noise``."""
    random = np.random.default_rng(seed)

    def draw(mean, deviation):
        return mean + deviation * random.standard_normal(shots)

    loft, attack, speed = USUAL[club]
    swing = {
        "speed": draw(speed, 0.8), "attack": draw(attack, 1.0) * DEG, "path": draw(0.0, 2.0) * DEG,
        "loft": draw(loft, 1.3) * DEG, "face": draw(0.0, 2.0) * DEG,
    }  # fmt: skip
    strike = {"toe": draw(0.0, 0.006), "high": draw(0.0, 0.004)} if strikes else {}
    shot = clubface.impact(club, swing | strike, **made)
    launches = {
        "ball_speed": shot.ball_speed, "launch": shot.launch + noise * draw(0.0, 0.2) * DEG,
        "azimuth": shot.azimuth + noise * draw(0.0, 0.2) * DEG, "backspin": shot.backspin + noise * draw(0.0, 5.0),
        "sidespin": shot.sidespin + noise * draw(0.0, 5.0),
    }  # fmt: skip
    measured = {name: swing[name] + noise * draw(0.0, 0.25) * DEG for name in ("loft", "face")}
    if ratio is not None:
        measured["loft"], measured["face"] = normal_of_ball(launches, ratio)
    deliveries = {**swing, **strike, **measured}
    for name, values in {**deliveries, **launches}.items():
        if step and name in ("loft", "face", "launch", "azimuth"):
            (deliveries if name in deliveries else launches)[name] = np.round(values / DEG / step) * step * DEG
    return RecordedShots(
        deliveries=deliveries, launches=launches, rows=np.arange(2, shots + 2), source="range.csv", format="clubface",
        clubs=np.array([file_club or club] * shots, dtype=object),
    )  # fmt: skip
