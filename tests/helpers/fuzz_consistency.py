"""Oracles that need no expected values: what is said in two ways is read in one, and what is broken costs itself alone.

The input of such a reader is a recipe, a line of JSON with the seed of all that is drawn, so that a finding is small.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable
from contextlib import chdir
from functools import cache
from itertools import pairwise
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

import clubface
from clubface import shots
from clubface.errors import ClubfaceError
from clubface.shots.open_connect import MessageError, from_json, recorded
from clubface.shots.prediction import predict
from clubface.studies.study import read_study
from fem_meshes import FORMATS, HEAD, coarse_walls, write_walls
from fuzz_tables import (
    MONITOR_FILES,
    SHOTS,
    STEPS,
    InconsistentError,
    Rows,
    monitor_table,
    own_table,
    own_values,
    read_rows,
    same_shots,
    some_way,
    written,
)
from toml_types import WRONG, all_places, flaw_of, must_be_refused, with_value

MADE_BY = [name for name in MONITOR_FILES if name != "other.csv"]
USUAL = {"speed": "mph", "angle": "deg", "length": "mm", "spin": "rpm", "distance": "yd"}


def recipe(**given: Any) -> bytes:
    """Return a recipe as it is kept."""
    return json.dumps(given).encode()


def written_in_two_ways(path: Path) -> None:
    """The same table in another encoding, format, order and with rows and columns that say nothing more."""
    given = json.loads(path.read_bytes())
    random = Random(given["seed"])
    with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as name:
        folder = Path(name)
        if given["of"] == "clubface":
            values = own_values(random)
            first, rows = own_table(values, random, USUAL), own_table(values, random)
        else:
            first = rows = monitor_table(given["of"])
            if given["way"]["format"] == "xlsx":  # which has no rows that are too short
                first = rows = [[*row, *[""] * (len(rows[-1]) - len(row))] for row in rows]
        plain = read_rows(first, folder)
        steps = set(given["steps"])
        if "second_header" in steps:  # below it summaries would be those of a table of few shots
            steps.discard("summaries")
        for step in sorted(steps, key=list(STEPS).index):
            rows = STEPS[step](rows, random)
        ending, data = written(rows, given["way"])
        same_shots(plain, read_rows(rows, folder, "other.csv", ending, data))


def ways(random: Random) -> bytes:
    """Draw a recipe for :func:`written_in_two_ways`."""
    steps = random.sample(list(STEPS), random.choice((0, 1, 1, 2, 3)))
    return recipe(
        of=random.choice(["clubface"] * 4 + MADE_BY), steps=steps, way=some_way(random), seed=random.randrange(2**32)
    )


def without_units(path: Path) -> None:
    """A table without units, or with units on some columns: refused, or read as with them."""
    given = json.loads(path.read_bytes())
    random = Random(given["seed"])
    values = own_values(random)
    kept = {name: unit for name, unit in USUAL.items() if random.random() < given["share"]}
    with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as name:
        plain = read_rows(own_table(values, random, USUAL), Path(name))
        bare: Rows = own_table(values, random, kept)
        try:
            result = read_rows(bare, Path(name), "bare.csv")
        except ClubfaceError:
            return
        same_shots(plain, result)


def bare(random: Random) -> bytes:
    """Draw a recipe for :func:`without_units`."""
    return recipe(share=random.choice((0.0, 0.5, 0.8)), seed=random.randrange(2**32))


def in_several_files(path: Path) -> None:
    """Shots in several files, each written in its own way and one of them given twice, are those of one file."""
    given = json.loads(path.read_bytes())
    random = Random(given["seed"])
    values = own_values(random)
    ends = [0, *sorted(random.sample(range(1, SHOTS), given["files"] - 1)), SHOTS]
    with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as name:
        folder, paths = Path(name), []
        plain = read_rows(own_table(values, random, USUAL), folder)
        for number, (start, stop) in enumerate(pairwise(ends)):
            rows = own_table({key: each[start:stop] for key, each in values.items()}, random)
            ending, data = written(rows, some_way(random))
            paths.append(folder / f"session-{number}.{ending}")
            paths[-1].write_bytes(data)
        again = [random.choice(paths)] if given["again"] else []
        same_shots(plain, shots.read([*paths, *again]))


def several(random: Random) -> bytes:
    """Draw a recipe for :func:`in_several_files`."""
    return recipe(files=random.randint(2, 4), again=random.random() < 0.5, seed=random.randrange(2**32))


PAIRS = (("backspin", "sidespin"), ("total_spin", "spin_axis"), ("backspin", "spin_axis"), ("sidespin", "total_spin"))
"""Spins that settle the vector, for balls that are not topped; sidespin with the axis does where they are not small."""


def spins(path: Path) -> None:
    """Any spins that settle the vector give it whole, whichever are written beside them."""
    given = json.loads(path.read_bytes())
    random = Random(given["seed"])
    back = [random.choice((300.0, 2600.0, 9000.0)) * random.uniform(0.8, 1.2) for _ in range(SHOTS)]
    side = [each * random.uniform(-0.3, 0.3) for each in back]
    whole = {
        "backspin": back, "sidespin": side, "total_spin": np.hypot(back, side).tolist(),
        "spin_axis": np.degrees(np.arctan2(side, back)).tolist(),
    }  # fmt: skip
    names = [*given["pair"], *given["more"]]
    wrap = 360.0 if given["wrap"] else 0.0
    heads = [f"{name}_deg" if name == "spin_axis" else f"{name}_rpm" for name in names]
    cells = [[f"{each + wrap * (name == 'spin_axis' and each < 0):.6f}" for each in whole[name]] for name in names]
    speeds = [f"{100 + place}" for place in range(SHOTS)]
    rows = [["ball_speed_mph", "launch_deg", *heads]]
    rows += [[speed, "12", *row] for speed, *row in zip(speeds, *cells, strict=True)]
    with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as name:
        result = read_rows(rows, Path(name)).launches
    for name in whole:
        unit = np.pi / (180 if name == "spin_axis" else 30)
        if name not in result:
            raise InconsistentError(f"{name} does not follow from {names}")
        if not np.allclose(result[name], np.array(whole[name]) * unit, rtol=1e-3, atol=1e-2):
            raise InconsistentError(f"{name} is {result[name][:3] / unit} instead of {whole[name][:3]}, from {names}")


def some_spins(random: Random) -> bytes:
    """Draw a recipe for :func:`spins`."""
    pair = random.choice(PAIRS)
    rest = [name for name in ("backspin", "sidespin", "total_spin", "spin_axis") if name not in pair]
    more = random.sample(rest, random.randint(0, len(rest)))
    return recipe(pair=pair, more=more, wrap=random.random() < 0.3, seed=random.randrange(2**32))


SIDEWAYS = ("path", "face", "azimuth", "sidespin")


def mirrored(path: Path) -> None:
    """The shots of a left-hander in a mirror are those of a right-hander, read and computed."""
    given = json.loads(path.read_bytes())
    random = Random(given["seed"])
    values = own_values(random)
    values |= {name: [0.1] * SHOTS for name in ("path", "face") if name not in values}
    image = {name: [-each for each in numbers] if name in SIDEWAYS else numbers for name, numbers in values.items()}
    with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as name:
        both = []
        for hand, each in (("right", values), ("left", image)):
            rows = own_table(each, Random(given["seed"]), USUAL)
            rows = [[*row, "hand" if place == 0 else hand] for place, row in enumerate(rows)]
            both.append(read_rows(rows, Path(name)))
    one, two = both
    signs = {**dict.fromkeys((*SIDEWAYS, "spin_axis"), -1.0)}
    for part in ("deliveries", "launches"):
        for name, numbers in getattr(one, part).items():
            if not np.allclose(numbers * signs.get(name, 1.0), getattr(two, part)[name], rtol=1e-9, equal_nan=True):
                raise InconsistentError(f"{name} is not mirrored as it is read")
    launches = [
        clubface.impact("driver", {**each.deliveries, "hand": hand}, model=given["model"], on_error="nan")
        for each, hand in zip(both, (1.0, -1.0), strict=True)
    ]
    for name, sign in {"ball_speed": 1.0, "launch": 1.0, "azimuth": -1.0, "backspin": 1.0, "sidespin": -1.0}.items():
        right, left = (np.asarray(getattr(each, name)) for each in launches)
        if not np.allclose(right * sign, left, rtol=1e-7, atol=1e-6, equal_nan=True):
            raise InconsistentError(f"{name} of the launch is not mirrored: {right[:3]} and {left[:3]}")


def mirror(random: Random) -> bytes:
    """Draw a recipe for :func:`mirrored`."""
    return recipe(model=random.choice(("response", "standard", "slip")), seed=random.randrange(2**32))


MESSAGE: dict[str, Any] = {
    "DeviceID": "radar", "Units": "Yards", "ShotNumber": 13, "APIversion": "1",
    "BallData": {"Speed": 147.5, "SpinAxis": -13.2, "TotalSpin": 3250.0, "HLA": 2.3, "VLA": 14.3, "CarryDistance": 240},
    "ClubData": {"Speed": 100.0, "AngleOfAttack": -1.5, "FaceToTarget": 1.25, "Lie": 0.5, "Loft": 14.0, "Path": -2.5},
    "ShotDataOptions": {"ContainsBallData": True, "ContainsClubData": True, "IsHeartBeat": False},
}  # fmt: skip
BROKEN: tuple[Any, ...] = (None, "", "n/a", "-", [], {}, True, [1.0], {"x": 1}, "1e400", -9999.0, 1e300, "12,5,1")


def one_field(path: Path) -> None:
    """A field of the club that is broken costs that field, and not the shot or another field."""
    given = json.loads(path.read_bytes())
    whole, broken = (json.loads(json.dumps(MESSAGE)) for _ in range(2))
    part, name = given["field"]
    if given["absent"]:
        del broken[part][name], whole[part][name]
    else:
        broken[part][name] = given["value"]
    both = []
    for each in (whole, broken):
        try:
            both.append(recorded([from_json(each)]))
        except MessageError as error:
            if part == "ClubData":
                raise InconsistentError(f"the shot is lost: {error}") from error
            return
    for part in ("deliveries", "launches"):
        for key, numbers in getattr(both[0], part).items():
            other = getattr(both[1], part).get(key)
            if key not in OF_FIELD.get(name, ()) and (other is None or not np.allclose(numbers, other, equal_nan=True)):
                raise InconsistentError(f"{key} is {other} instead of {numbers}, as {name} is {given['value']!r}")


OF_FIELD = {
    "Speed": ("speed", "ball_speed", "smash"), "AngleOfAttack": ("attack",), "FaceToTarget": ("face",), "Lie": ("lie",),
    "Loft": ("loft",), "Path": ("path",), "CarryDistance": ("carry",),
}  # fmt: skip
FIELDS = [("ClubData", name) for name in MESSAGE["ClubData"]] + [("BallData", "CarryDistance")]


def field(random: Random) -> bytes:
    """Draw a recipe for :func:`one_field`."""
    return recipe(field=random.choice(FIELDS), value=random.choice(BROKEN), absent=random.random() < 0.05)


CLUB = clubface.club("driver")
EDITED = {"club.toml": CLUB, "other.toml": CLUB.replace(name="other", mass="230 g", loft="14 deg")}


def edited(path: Path) -> None:
    """A file that is edited during a run changes nothing in its result, or ends it in one line."""
    given = json.loads(path.read_bytes())
    results = []
    for edits in (False, True):
        with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as name, chdir(name):
            folder = Path(name)
            for each, club in EDITED.items():
                (folder / each).write_text(club.to_toml())
            (folder / "in.csv").write_text(
                "club_speed_mph,loft_deg\n" + "".join(f"{90 + i},{i % 9 + 8}\n" for i in range(24))
            )
            (folder / "study.toml").write_text(
                '[study]\nchunk = 4\n[impact]\nclub = "club.toml"\noutputs = ["ball_speed"]\n'
                '[sweep]\nspeed = { from = "90 mph", to = "113 mph", count = 24 }\n'
            )

            def edit(*done: Any, at: int = given["at"], folder: Path = folder, edits: bool = edits) -> None:
                if edits and max(map(float, done[-1:])) >= at:
                    (folder / given["file"]).write_bytes((folder / given["by"]).read_bytes())

            try:
                results.append(RUNS[given["run"]](edit))
            except ClubfaceError:
                if not edits:
                    raise
                return
    if results[0] != results[1]:
        raise InconsistentError(f"{given['file']}, edited during the run, changes its result")


def _predict(edit: Any) -> bytes:
    predict("in.csv", club="club.toml", model="standard", carry=False, output="out.csv", chunk_rows=4, progress=edit)
    return Path("out.csv").read_bytes()


def _study(edit: Any) -> list[list[Any]]:
    asked = read_study("study.toml")
    task = asked.kind.prepare(asked)
    result = []
    for start in range(0, asked.design.count, 4):
        edit(start)
        result.append(task.run(range(start, start + 4)).columns["ball_speed"].tolist())
    return result


RUNS = {"predict": _predict, "study": _study}


def edits(random: Random) -> bytes:
    """Draw a recipe for :func:`edited`."""
    file = random.choice(("club.toml", "club.toml", "in.csv", "study.toml"))
    by = random.choice(["other.toml", "study.toml", "in.csv"])
    return recipe(run=random.choice(list(RUNS)), file=file, by=by, at=random.randrange(24))


TYPES_OF = (
    "club",
    "ball",
    "parameters",
    "prior",
    "study",
    "golfer",
    "mapping",
    "fem-ball",
    "markers",
    "shells",
    "sweep-study",
)
"""Readers of TOML whose keys are given values of wrong types; those of meshes and cases take long."""


@cache
def _keys(reader: str) -> list[tuple[str, Any]]:
    from fuzz_readers import READERS

    return [(text, place) for data in READERS[reader].seeds() for text in [data.decode()] for place in all_places(text)]


def wrong_type(path: Path) -> None:
    """A value of the wrong type under a key is refused with file, line and key."""
    from fuzz_readers import READERS

    given = json.loads(path.read_bytes())
    text, place = _keys(given["reader"])[given["key"] % len(_keys(given["reader"]))]
    raw = WRONG[given["raw"] % len(WRONG)]
    value, document = with_value(text, place, raw)
    file = path.with_name("in.toml")
    file.write_text(document, encoding="utf-8")
    refused = must_be_refused(value, raw) and not (given["reader"] == "ball" and place[0] in ("cube", "pieces"))
    if flaw := flaw_of(READERS[given["reader"]].read, file, place, refused):
        raise InconsistentError(f"{'.'.join(map(str, place))} = {raw}: {flaw}")


def some_type(random: Random) -> bytes:
    """Draw a recipe for :func:`wrong_type`."""
    return recipe(reader=random.choice(TYPES_OF), key=random.randrange(10**6), raw=random.randrange(10**6))


def meshed_in_two_ways(path: Path) -> None:
    """A mesh in another format, with other numbers of its nodes and elements, or with a part turned, is one head."""
    from clubface import fem

    given, made = json.loads(path.read_bytes()), []
    random = Random(given["seed"])
    plain = coarse_walls()
    walls = plain.reversed(given["turned"]) if given["turned"] else plain
    order = random.sample(range(len(walls.nodes)), len(walls.nodes))
    place = {old: new for new, old in enumerate(order)}
    parts = {name: [[place[each] for each in row] for row in rows] for name, rows in walls.parts.items()}
    walls = walls._replace(
        nodes=walls.nodes[order], parts={name: random.sample(rows, len(rows)) for name, rows in parts.items()}
    )
    plain = plain.triangles() if given["format"].endswith("stl") else plain  # which has nothing else
    for each, name in ((plain, "abaqus.inp"), (walls, given["format"])):
        with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as folder:
            write_walls(Path(folder), each, name)
            own = Path(folder, "own.toml")
            own.write_text(HEAD.replace("head.msh", name))
            club = fem.head(own).club
        made.append([club.mass, club.cg_x, club.cg_y, club.cg_z, 1e2 * club.ixx, 1e2 * club.iyy, 1e2 * club.izz])
    if not np.allclose(*made, rtol=1e-3, atol=2e-5):
        raise InconsistentError(f"mass, CG and inertia are {made[1]} instead of {made[0]}")


def some_mesh(random: Random) -> bytes:
    """Draw a recipe for :func:`meshed_in_two_ways`."""
    turned = random.choice(["", *coarse_walls().parts])
    return recipe(format=random.choice(list(FORMATS)), turned=turned, seed=random.randrange(2**32))


def _whole(read: Callable[[Path], None]) -> Callable[[Path], None]:
    """Return an oracle for which a refusal is a finding: what it writes is as it should be."""

    def checked(path: Path) -> None:
        try:
            read(path)
        except ClubfaceError as error:
            raise InconsistentError(f"refused: {error}") from error

    return checked


ORACLES = {
    "written-in-two-ways": (_whole(written_in_two_ways), ways, 8), "without-units": (_whole(without_units), bare, 2),
    "in-several-files": (_whole(in_several_files), several, 2), "spins": (_whole(spins), some_spins, 2),
    "mirrored": (_whole(mirrored), mirror, 1),
    "one-field": (_whole(one_field), field, 2), "edited": (_whole(edited), edits, 1),
    "meshed-in-two-ways": (_whole(meshed_in_two_ways), some_mesh, 1), "wrong-type": (_whole(wrong_type), some_type, 4),
}  # fmt: skip
"""Reader, maker of recipes, and how often it is tried."""
