"""The rows of the tables of ``clubface fem``."""

from __future__ import annotations

RUN_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("ball speed, mph", "ball_speed", "mph", 1),
    ("launch angle, deg", "launch", "deg", 2),
    ("azimuth, deg", "azimuth", "deg", 2),
    ("velocity off the plane, m/s", "normal_velocity", "1", 2),
    ("velocity along it, m/s", "tangential_velocity", "1", 2),
    ("backspin, rpm", "backspin", "rpm", 0),
    ("sidespin, rpm", "sidespin", "rpm", 0),
    ("spin axis, deg", "spin_axis", "deg", 1),
    ("carry, yd", "carry", "yd", 1),
    ("side, yd", "side", "yd", 1),
    ("apex, yd", "apex", "yd", 1),
)
"""Label, key, unit and digits of launch and flight."""
FIGURE_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("peak force, N", "peak_force", "1", 0),
    ("at, us", "peak_force_time", "us", 0),
    ("contact, us", "contact_time", "us", 0),
    ("largest tangential force, N", "tangential_max", "1", 0),
    ("smallest tangential force, N", "tangential_min", "1", 0),
    ("reversal, us", "reversal_time", "us", 0),
    ("largest spin on the way, rpm", "spin_max", "rpm", 0),
    ("contraction, %", "contraction", "%", 1),
    ("at, us ", "contraction_time", "us", 0),
    ("f'", "f_prime", "1", 4),
    ("f", "f", "1", 4),
)
"""The same, of the figures of the contact."""

PAPER_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("ball speed, m/s", "ball_speed_mps", "1", 1),
    ("ball speed, mph", "ball_speed_mps", "mph", 1),
    ("launch angle, deg", "launch_deg", "1", 1),
    ("club speed after, m/s", "club_speed_after_mps", "1", 1),
    ("club speed after, mph", "club_speed_after_mps", "mph", 1),
    ("spin of the launch, rpm", "spin_rpm", "1", 0),
    ("spin of all nodes at take-off, rpm", "ball_spin_rpm", "1", 0),
    ("spin of a section's nodes at take-off, rpm", "section_spin_rpm", "1", 0),
    ("spin if it rolled off, rpm", "rolling_spin_rpm", "1", 0),
    ("velocity along the face at first, m/s", "tangential_first_mps", "1", 2),
    ("least of it, m/s", "tangential_least_mps", "1", 2),
    ("at, us", "tangential_least_time_s", "us", 0),
    ("at take-off, m/s", "tangential_last_mps", "1", 2),
    ("peak force, N", "peak_force_n", "1", 0),
    ("at, us ", "peak_force_time_s", "us", 0),
    ("reversal, us", "reversal_time_s", "us", 0),
    ("contraction, %", "contraction", "%", 1),
    ("at, us  ", "contraction_time_s", "us", 0),
    ("f'", "f_prime", "1", 4),
    ("f", "f", "1", 4),
)
"""Label, key, unit and digits."""

SWEEP_COLUMNS: tuple[tuple[str, str, str, int], ...] = (
    ("speed\nm/s", "speed_mps", "1", 1),
    ("\nmph", "speed_mps", "mph", 1),
    ("loft\ndeg", "loft_deg", "1", 1),
    ("ball\nm/s", "ball_speed_mps", "1", 1),
    ("\nmph", "ball_speed_mps", "mph", 1),
    ("launch\ndeg", "launch_deg", "1", 2),
    ("spin\nrpm", "spin_rpm", "1", 0),
    ("club after\nm/s", "club_speed_after_mps", "1", 1),
    ("\nmph", "club_speed_after_mps", "mph", 1),
    ("peak\nN", "peak_force_n", "1", 0),
    ("f", "f", "1", 4),
)
"""Heading, key, unit and digits of the columns of a sweep."""

REFERENCE_ROWS: tuple[tuple[str, str, str, int], ...] = (
    ("normal rebound, m/s", "normal_mps", "1", 2),
    ("tangential rebound, m/s", "tangential_mps", "1", 2),
    ("spin, rpm", "spin_rpm", "1", 0),
    ("largest spin, rpm", "spin_max_rpm", "1", 0),
    ("peak force, N", "peak_force_n", "1", 0),
    ("at, us", "peak_force_time_s", "us", 0),
    ("contact, us", "contact_time_s", "us", 0),
    ("largest tangential force, N", "tangential_max_n", "1", 0),
    ("smallest tangential force, N", "tangential_min_n", "1", 0),
    ("reversal, us", "reversal_time_s", "us", 0),
)
"""Label, key, unit and digits."""
