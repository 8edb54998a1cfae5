"""The fields of GSPro Open Connect v1, with the quantity and unit of each."""

from __future__ import annotations

VERSION = "1"
BALL = {
    "Speed": ("ball_speed", "mph"),
    "SpinAxis": ("spin_axis", "deg"),
    "TotalSpin": ("total_spin", "rpm"),
    "BackSpin": ("backspin", "rpm"),
    "SideSpin": ("sidespin", "rpm"),
    "HLA": ("azimuth", "deg"),
    "VLA": ("launch", "deg"),
    "CarryDistance": ("carry", "yd"),
}
CLUB = {
    "Speed": ("speed", "mph"),
    "AngleOfAttack": ("attack", "deg"),
    "FaceToTarget": ("face", "deg"),
    "Lie": ("lie", "deg"),
    "Loft": ("loft", "deg"),
    "Path": ("path", "deg"),
    "VerticalFaceImpact": ("high", "mm"),
    "HorizontalFaceImpact": ("toe", "mm"),
    "ClosureRate": ("closure", "deg/s"),
}
"""The quantity and unit of each field; of the club, ``SpeedAtImpact`` is not used."""
NEVER_ZERO = ("speed", "loft", "closure")
"""Quantities of the club that are zero only where they were not measured."""
CARRY_UNITS = {
    **dict.fromkeys(("yards", "yard", "yds", "yd"), "yd"),
    **dict.fromkeys(("meters", "metres", "meter", "metre", "m"), "m"),
}
"""What ``Units`` may say, and the unit of the carry that it means."""
LARGEST_NUMBER = 1e9
"""No number of a message comes near it, but for what stands for a value that was not measured."""
LARGEST_VALUE = 1e39
"""The greatest number that such a value can be, of four bytes, is 3.4e38."""
OK, PLAYER, FAILED = 200, 201, 501
HANDS = {"right": "RH", "left": "LH"}
