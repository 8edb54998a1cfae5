"""The listing of the paper, from its first import on."""

import clubface

drive = {"speed": "105 mph", "loft": "12 deg"}
shot = clubface.impact("driver", drive)
table = clubface.sensitivity("driver", drive)
speed = shot.get("ball_speed", "mph")
slope = table.value("backspin", "loft", "rpm per deg")
print(f"{speed:.1f} mph, {slope:.0f} rpm per degree of loft")
