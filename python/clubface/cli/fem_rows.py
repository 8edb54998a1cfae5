"""The rows of the tables of ``clubface fem``."""

from __future__ import annotations

import math
from typing import Any

RPM, DEG = 30.0 / math.pi, 180.0 / math.pi

REBOUND = ("normal_velocity", "tangential_velocity")
RUN_ROWS: tuple[tuple[str, str, float, int], ...] = (
    ("ball speed, m/s", "ball_speed", 1.0, 2),
    ("launch angle, deg", "launch", DEG, 2),
    ("azimuth, deg", "azimuth", DEG, 2),
    ("velocity off the plane, m/s", "normal_velocity", 1.0, 2),
    ("velocity along it, m/s", "tangential_velocity", 1.0, 2),
    ("backspin, rpm", "backspin", RPM, 0),
    ("sidespin, rpm", "sidespin", RPM, 0),
)
"""Label, key, scale and digits of the launch."""
FIGURE_ROWS: tuple[tuple[str, str, float, int], ...] = (
    ("peak force, N", "peak_force", 1.0, 0),
    ("at, us", "peak_force_time", 1e6, 0),
    ("contact, us", "contact_time", 1e6, 0),
    ("largest tangential force, N", "tangential_max", 1.0, 0),
    ("smallest tangential force, N", "tangential_min", 1.0, 0),
    ("reversal, us", "reversal_time", 1e6, 0),
    ("largest spin on the way, rpm", "spin_max", RPM, 0),
    ("contraction, %", "contraction", 100.0, 1),
    ("at, us ", "contraction_time", 1e6, 0),
    ("f'", "f_prime", 1.0, 4),
    ("f", "f", 1.0, 4),
)
"""The same, of the figures of the contact."""

PAPER_ROWS: tuple[tuple[str, str, float, int], ...] = (
    ("ball speed, m/s", "ball_speed_mps", 1.0, 1),
    ("launch angle, deg", "launch_deg", 1.0, 1),
    ("club speed after, m/s", "club_speed_after_mps", 1.0, 1),
    ("spin, rpm", "spin_rpm", 1.0, 0),
    ("peak force, N", "peak_force_n", 1.0, 0),
    ("at, us", "peak_force_time_s", 1e6, 0),
    ("reversal, us", "reversal_time_s", 1e6, 0),
    ("contraction, %", "contraction", 100.0, 1),
    ("at, us ", "contraction_time_s", 1e6, 0),
    ("f'", "f_prime", 1.0, 4),
    ("f", "f", 1.0, 4),
)
"""Label, key, scale and digits."""

REFERENCE_ROWS: tuple[tuple[Any, ...], ...] = (
    ("normal rebound, m/s", "normal_mps", 1.0, 2, "32.08", "32.06", "32.31"),
    ("tangential rebound, m/s", "tangential_mps", 1.0, 2, "5.82", "5.82", "5.75"),
    ("spin, rpm", "spin_rpm", 1.0, 0, "1216", "1221", "1286"),
    ("largest spin, rpm", "spin_max_rpm", 1.0, 0, "3735", "3749", ""),
    ("peak force, N", "peak_force_n", 1.0, 0, "8637", "8708", "8925"),
    ("at, us", "peak_force_time_s", 1e6, 0, "278", "282", "295"),
    ("contact, us", "contact_time_s", 1e6, 0, "626", "624", "601"),
    ("largest tangential force, N", "tangential_max_n", 1.0, 0, "843", "851", "833"),
    ("smallest tangential force, N", "tangential_min_n", 1.0, 0, "-727", "-678", "-667"),
    ("reversal, us", "reversal_time_s", 1e6, 0, "307", "305", "305"),
)
"""Label, key, scale, digits, and what independent open solvers gave."""
