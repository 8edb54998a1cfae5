"""Files of studies, and what is asked of their stores."""

import os
import sys

from clubface import studies
from command_line import MAIN, interruptible

SQUARES = """
[study]
chunk = {chunk}
[empty]
seconds = {seconds}
[sweep]
x = {{ from = 0, to = 1, count = {count} }}
"""
"""A study of squares."""

SHOTS = """
[study]
chunk = {chunk}
[impact]
club = "driver"
held = {{ speed = "105 mph" }}
outputs = ["ball_speed", "backspin", "carry", "side"]
[sweep]
loft = {{ from = "8 deg", to = "14 deg", count = 4 }}
toe = ["-10 mm", "0 mm", "10 mm"]
attack = ["-3 deg", "3 deg"]
"""
"""A study of 24 drives."""


def squares(folder, *, chunk=10, count=200, seconds=0.0, name="squares.toml"):
    path = folder / name
    text = SQUARES.replace("[study]", '[study]\nkind = "empty"')
    path.write_text(text.format(chunk=chunk, count=count, seconds=seconds))
    return path


def shots(folder, *, chunk=5, name="shots.toml", text=SHOTS):
    path = folder / name
    path.write_text(text.format(chunk=chunk))
    return path


def sums(path, **options):
    return studies.join(path, **options).sums


def started(*arguments, path=(), **variables):
    """Start a command line in a process of its own, with folders in which Python looks first."""
    environment = {**os.environ, **variables, "PYTHONPATH": os.pathsep.join([*map(str, path), *filter(None, sys.path)])}
    command = [sys.executable, "-c", MAIN, *map(str, arguments)]
    return interruptible(command, env=environment)
