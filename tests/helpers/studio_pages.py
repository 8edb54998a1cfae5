"""The studio's application in tests: asked in this process, or served by a process of its own."""

import os
import re
import sys
import time

from command_line import MAIN, interruptible

TOKEN = "a-token-for-tests"
HOST = "127.0.0.1:8642"
SITE = {
    "index.html": "<!doctype html><html><head></head></html>",
    "sw.js": "//",
    "assets/a.js": "1",
}


def made_site(folder):
    """A folder with a small site."""
    for name, text in SITE.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def client(site, *, headers=None, **options):
    """A client of the application, whose addresses begin behind the token."""
    from starlette.testclient import TestClient

    from clubface.studio.serve import make_application

    return TestClient(
        make_application(made_site(site), TOKEN, **options), base_url=f"http://{HOST}/{TOKEN}/",
        headers=headers, raise_server_exceptions=False, follow_redirects=False,
    )  # fmt: skip


class Served:
    """``clubface studio`` in a process of its own; ``ports`` are those of the protocols."""

    def __init__(self, folder, *options):
        environment = {**os.environ, "CLUBFACE_STUDIO_SITE": str(made_site(folder / "site"))}
        command = [sys.executable, "-c", MAIN, "studio", "--port", "0", *options]
        errors = folder / f"errors-{time.monotonic_ns()}.txt"
        # Opened twice: to go back in what the process writes to would make it write there.
        with errors.open("wb") as written:
            self.process = interruptible(command, cwd=folder, env=environment, stderr=written)
        self.errors = errors.open(encoding="utf-8")  # closed by end()
        self.address = self.process.stdout.readline().strip()
        self.errors.seek(0)
        printed = self.errors.read()
        assert self.address, printed
        self.ports = {
            name: int(port) for name, port in re.findall(r"(open-connect|opengolfsim|flight-relay): \S+:(\d+)", printed)
        }

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.end()

    def kill(self):
        """End it as a failure of the machine does."""
        self.process.kill()
        self.process.wait()

    def end(self):
        """End it, whatever it does."""
        self.kill()
        self.process.stdout.close()
        self.errors.close()


def session(count=60):
    """Shots of a driver, as a table."""
    import numpy as np

    import clubface

    golfer = clubface.golfer("bogey-driver")
    drawn = golfer.sample(count, seed=3)
    names = {
        "speed": "club_speed_mps",
        "attack": "attack_rad",
        "path": "path_rad",
        "loft": "loft_rad",
        "face": "face_rad",
    }
    names |= {"toe": "toe_m", "high": "high_m"}
    launch = clubface.impact("driver", drawn, on_error="nan")
    columns = {heading: drawn[name] for name, heading in names.items()}
    columns |= {"ball_speed_mps": launch.ball_speed, "launch_rad": launch.launch, "azimuth_rad": launch.azimuth}
    columns |= {"backspin [rad/s]": launch.backspin, "sidespin [rad/s]": launch.sidespin}
    rows = np.column_stack([np.broadcast_to(each, count) for each in columns.values()])
    lines = [",".join([*columns, "club"]), *(",".join([*map(repr, map(float, row)), "driver"]) for row in rows)]
    return "\n".join(lines).encode()


def added(studio, content, name="session.csv", **options):
    """The answer to a file that is dropped."""
    return studio.post("api/files", params={"name": name, **options}, content=content)
