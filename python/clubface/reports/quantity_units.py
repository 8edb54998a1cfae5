"""In which unit, and with how many digits, people read each quantity of a launch and its flight."""

from __future__ import annotations

SHOWN = {
    "ball_speed": ("mph", 1), "smash": ("1", 3), "launch": ("deg", 1), "azimuth": ("deg", 1), "backspin": ("rpm", 0),
    "sidespin": ("rpm", 0), "total_spin": ("rpm", 0), "spin_axis": ("deg", 1), "carry": ("yd", 1), "side": ("yd", 1),
    "total": ("yd", 1), "total_side": ("yd", 1), "apex": ("yd", 1), "landing_angle": ("deg", 1),
    "contact_time": ("us", 0), "peak_force": ("kN", 1),
}  # fmt: skip
"""Unit and digits after the point, by quantity."""
