"""Every reader of a file or message, with small valid examples of what it reads."""

from __future__ import annotations

import io
import json
import os
import shutil
import tempfile
import zipfile
from collections.abc import Callable
from contextlib import chdir, suppress
from functools import cache, partial
from pathlib import Path
from random import Random
from typing import NamedTuple

import numpy as np

from clubface import fem, shots as launch_monitor
from clubface.capture.markers import MarkerMap, template
from clubface.capture.recording import read_c3d
from clubface.capture.swing import read_swings
from clubface.capture.synthetic.laboratory import synthesize
from clubface.design.comparison import read_deliveries
from clubface.design.golfer import golfer
from clubface.design.optimisation import study
from clubface.design.shells import study as shells_file
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.parameters import read_sets
from clubface.fem.case import Case
from clubface.inference.file import infer_shots
from clubface.inference.prior import Prior
from clubface.jobs import Job, Store
from clubface.jobs.engine import Place, Row, run_table
from clubface.schema import Document
from clubface.shots import opengolfsim
from clubface.shots.flight_relay import ShotCollector, text_to_object
from clubface.shots.formats import mapping_of
from clubface.shots.live import LiveShots, live_result
from clubface.shots.messages import Broken, Message, MessageError, ObjectStream, recorded
from clubface.shots.open_connect import from_json
from clubface.shots.prediction import predict
from clubface.shots.reading import read_shots
from clubface.shots.recorded import RecordedShots
from clubface.studies import study as studies
from clubface.support.files import DATA
from fem_meshes import FORMATS, HEAD, WHOLE, coarse_walls, stl_binary, write_mesh, write_walls
from fuzz_consistency import ORACLES
from fuzz_mutations import mutated
from fuzz_tables import monitor_table, own_table, own_values, workbook

MONITORS = Path(__file__).parents[1] / "data" / "launch_monitors"
TABLE = b"club_speed_mph,attack_deg,path_deg,face [deg],toe_mm,hand,ball_speed_mph,club\n" + b"".join(
    b"%d,%d.5,-1,%d.25,4,right,%d,driver\n" % (90 + row, row % 5, row % 3, 130 + row) for row in range(12)
)
PRIOR = b"""\
title = "mine"
[spread]
speed = ["100 mph", "8 mph"]
loft = ["15 deg", "3 deg"]
[[correlation]]
of = ["speed", "loft"]
value = 0.3
"""
STUDY = b"""\
title = "mine"
club = "driver"
objective = ["carry", "side_spread"]
[[golfer]]
name = "bogey-driver"
weight = 2
[variables]
loft = ["8 deg", "14 deg"]
mass_distribution = "free"
[head]
size = ["115 mm", "62 mm", "124 mm"]
centre = ["-55 mm", "2 mm", "3 mm"]
discretionary_mass = "30 g"
[limits]
cg_y = ["9 mm", "none"]
[rules]
tolerance = true
"""
FITTING = b"""\
title = "mine"
golfer = "bogey-driver"
objective = "strokes"
[hole]
length = "400 yd"
[fit]
clubs = ["driver", "3-wood"]
loft = ["-1 deg", "1 deg"]
[[fit.setting]]
name = "back"
cg_x = "2 mm"
"""
GOLFER = b"""\
title = "mine"
hand = "left"
[mean]
speed = "95 mph"
loft = "14 deg"
[spread]
speed = "1.2 mph"
face = "2 deg"
[[correlation]]
of = ["face", "speed"]
value = -0.3
[mishit]
share = 0.1
scale = 2
[sources]
mishits = "guessed"
mean.speed = "measured"
"""
SHELLS = b"""\
title = "mine"
head = "paper"
objective = "ball_speed"
golfer = "bogey-driver"
ball = "modern"
safety = 1.1
rules = true
designs = 30
radius = 0.15
neighbours = true
[variables.thickness]
face_centre = ["1.6 mm", "4.8 mm"]
[variables.shape]
loft = ["9 deg", "12 deg"]
[delivery]
points = [["0 mm", "0 mm"], ["12 mm", "4 mm"]]
[hardest]
speed = "110 mph"
points = [["0 mm", "0 mm"]]
[limits]
wall_mass = ["none", "195 g"]
[[metals]]
name = "other"
youngs = "114 GPa"
poisson = 0.34
density = "4430 kg/m3"
yield = "910 MPa"
source = "assumed"
"""
SHOT = """
club = "driver"
ball = "modern"
hand = "left"
model = "area"
accuracy = 1e-6
parameters = { friction = 0.3, area_damping = "12 N s/m2" }
air = { temperature = "20 degC", altitude = "100 m", humidity = 0.4 }
wind = { wind_speed = "3 m/s", wind_direction = "20 deg" }
ground = { ground_tilt = "12 deg" }
"""
SWEPT = """
[sweep]
club_mass = { from = "190 g", to = "200 g", step = "10 g" }
"""
HELD = 'held = { speed = "100 mph", attack = "1 deg" }\n'
SWEEPS_OF_KINDS = [
    f"""
[study]
name = "mine"
kind = "impact"
design = "sobol"
samples = 8
seed = 3
chunk = 4
[impact]
outputs = ["carry"]
{SHOT}{HELD}
[sweep]
loft = {{ from = "9 deg", to = "12 deg" }}
toe = ["0 mm", "4 mm"]
""",
    f'[study]\nkind = "comparison"\nseconds = "2 s"\n[comparison]\noutputs = ["carry"]\n{SHOT}{HELD}'
    'other = { club = "3-wood", held = { toe = "1 mm" }, air = { temperature = "5 degC" } }\n'
    '[sweep]\nloft = { from = "9 deg", to = "12 deg", count = 2 }\n',
    f'[study]\nkind = "map"\n[map]\noutputs = ["area"]\ngrid = [5, 5]\nshare = 0.9\nspread_toe = "9 mm"\n'
    f'spread_high = "5 mm"\nabout_toe = "1 mm"\nabout_high = "0 mm"\n{SHOT}{HELD}{SWEPT}',
    '[study]\nkind = "dispersion"\n[dispersion]\ngolfer = "tour-driver"\nshots = 16\nseed = 1\npercentiles = [10]\n'
    f'ellipse = 80\noutputs = ["strokes"]\nhole = {{ length = "400 yd", fairway = "30 yd" }}\n{SHOT}'
    'held = { static_loft = "10 deg" }\n[sweep]\nmean.speed = ["100 mph"]\n',
    f'[study]\nkind = "best-loft"\n[best-loft]\noutputs = ["carry"]\n{SHOT}{HELD}{SWEPT}',
    '[study]\nkind = "optimise"\n[optimise]\nfile = "own.toml"\noutputs = ["loft"]\n'
    '[sweep]\nvariables.loft.most = ["12 deg"]\n',
    '[study]\nkind = "fem"\n[fem]\ncase = "paper"\noutputs = ["steps"]\n[sweep]\nspeed = ["30 m/s"]\n',
    '[study]\nkind = "head"\n[head]\nhead = "paper"\nball = "reference"\ntoe = "0 mm"\nhigh = "0 mm"\n'
    'speed = "40 m/s"\nstriker_speed = "3 m/s"\nimpact_speed = "50 m/s"\nfriction = 0.3\nsafety = 0.5\n'
    'outputs = ["mass"]\n[sweep]\nthickness.face_centre = ["3 mm"]\n',
    '[study]\nkind = "capture"\n[capture]\nclub = "driver"\nhand = "left"\nestimator = "linear"\nseed = 3\nrate = 360\n'
    'noise = "0.5 mm"\ngaps = 0\ngap = 1\nroughness = 100\noutputs = ["speed_error"]\n'
    "[sweep]\nswing = { from = 0, to = 3, step = 1 }\n",
]
"""A study of each kind, with all keys of its table."""
MESSAGE = {
    "DeviceID": "radar", "Units": "Yards", "ShotNumber": 13, "APIversion": "1",
    "BallData": {"Speed": 147.5, "SpinAxis": -13.2, "TotalSpin": 3250.0, "HLA": 2.3, "VLA": 14.3},
    "ClubData": {"Speed": 100.0, "AngleOfAttack": -1.5, "FaceToTarget": 1.25, "Lie": 0.5, "Loft": 14.0, "Path": -2.5},
    "ShotDataOptions": {"ContainsBallData": True, "ContainsClubData": True, "IsHeartBeat": False},
}  # fmt: skip
OTHER = ("other.csv", "conforming.toml", "distance.toml", "published.toml")
"""Files that are read with a mapping alone, or are balls without pieces."""
SWEEP = ("toe", "high", "force", "stopped")


class Reader(NamedTuple):
    """A reader.

    Attributes
    ----------
    ending
        Of the names of its files.
    read
        Reads one file.
    seeds
        Makes the examples.
    share
        How often it is tried, against the others.
    make
        Makes an input; unless given, one of the examples is damaged.
    """

    ending: str
    read: Callable[[Path], object]
    seeds: Callable[[], list[bytes]]
    share: int = 1
    make: Callable[[Random], bytes] | None = None


FOLDERS: list[tempfile.TemporaryDirectory[str]] = []
"""What :func:`_folder` made."""


def _files(folder: Path, pattern: str) -> Callable[[], list[bytes]]:
    return lambda: [each.read_bytes() for each in sorted(folder.glob(pattern)) if each.name not in OTHER]


def _made(what: str) -> Path:
    """Return a folder with files that are made once for a process."""
    return _made_in(what, os.getpid())


def _folder() -> Path:
    """Return a new folder that is removed when this process ends."""
    FOLDERS.append(tempfile.TemporaryDirectory(prefix="clubface-fuzz-"))
    return Path(FOLDERS[-1].name)


@cache
def _made_in(what: str, process: int) -> Path:
    folder = _folder()
    if what == "swings":
        synthesize(folder, 1, seed=3)
    elif what == "mesh":
        write_mesh(folder, "head.msh")
        (folder / "formats").mkdir()
        walls = coarse_walls()._replace(cards=dict.fromkeys(("face", "crown"), (2.0, 114e3, 0.34, 4.43e-9)))
        for name in FORMATS:
            write_walls(folder / "formats", walls, name)
        (folder / "formats" / "binary.stl").write_bytes(stl_binary(walls))
    elif what == "prediction":
        (folder / "in.csv").write_bytes(TABLE)
        with chdir(folder), suppress(StopIteration):  # a journal tells whose it is, the same in every folder
            predict("in.csv", output="out.csv", chunk_rows=4, progress=_stop_at(8), **PREDICT)
    elif what == "inference":
        with chdir(folder), suppress(StopIteration):
            infer_shots(_launches(), "out.csv", progress=_stop_at(2), **INFER)
    if what in ("prediction", "inference"):
        shutil.copytree(folder, folder / "begun")
    return folder


PREDICT = {"club": "driver", "model": "standard", "carry": False}
INFER = {"club": "driver", "samples": 20, "model": "standard"}


def _stop_at(rows: int) -> Callable[[float, int], None]:
    def progress(*done: float) -> None:
        if max(done) >= rows:
            raise StopIteration

    return progress


def _launches() -> RecordedShots:
    launches = {"ball_speed": np.linspace(69.0, 71.0, 4), "launch": np.full(4, 0.25), "backspin": np.full(4, 300.0)}
    return RecordedShots(deliveries={}, launches=launches, rows=np.arange(4), source="range.csv", format="clubface")


def _parquet() -> list[bytes]:
    import pandas

    table, result = pandas.read_csv(io.BytesIO(TABLE)), []
    for options in ({}, {"compression": None}):
        file = io.BytesIO()
        table.to_parquet(file, index=False, **options)
        result.append(file.getvalue())
    return result


def _workbooks() -> list[bytes]:
    from openpyxl import Workbook

    book = Workbook()
    for line in (MONITORS / "flightscope.csv").read_text().splitlines():
        book.active.append(line.split(","))
    file = io.BytesIO()
    book.save(file)
    return [file.getvalue()]


def _predict(path: Path) -> None:
    predict(path, output=path.with_name("predicted.csv"), **PREDICT)


def _deliveries(path: Path) -> None:
    read_deliveries(path, 24)


def _mapped(path: Path) -> None:
    launch_monitor.read(MONITORS / "other.csv", mapping=path)


def _head(path: Path) -> None:
    with suppress(FileNotFoundError):
        shutil.copy(_made("mesh") / "head.msh", path.with_name("head.msh"))
    fem.head(path).club  # noqa: B018 - its mesh is made for it


def _mesh(path: Path) -> None:
    own = path.with_name("own.toml")
    bare = path.suffix == ".stl" and not path.read_bytes().startswith(b"solid")
    own.write_text((WHOLE if bare else HEAD).replace("head.msh", path.name))
    fem.head(own).club  # noqa: B018


def _study(path: Path) -> None:
    path.with_name("own.toml").write_bytes(STUDY)
    asked = studies.read_study(path)
    made = asked.task
    asked.content()
    if asked.kind.name in ("impact", "comparison", "dispersion", "best-loft") and asked.design.count < 100:
        made.run(range(1))


MESHES = (
    ("gmsh", "msh", "gmsh2.msh"), ("gmsh-4", "msh", "gmsh4.msh"), ("gmsh-binary", "msh", "gmsh?-binary.msh"),
    ("abaqus", "inp", "abaqus.inp"), ("nastran", "bdf", "*.[bnf][dae][fsm]"), ("stl", "stl", "*.stl"),
    ("lsdyna", "k", "*.k"), ("meshlane", "vtk", "*.vtk"),
)  # fmt: skip
"""Readers of meshes: name, ending and what examples are called."""


def _meshes(pattern: str) -> Callable[[], list[bytes]]:
    return lambda: [each.read_bytes() for each in sorted(_made("mesh").glob(f"formats/{pattern}"))]


def _parameters(path: Path) -> None:
    read_sets(Document.read(path))


def _markers() -> list[bytes]:
    return [template().encode(), (_made("swings") / "markers.toml").read_bytes()]


def _marker_map(path: Path) -> None:
    MarkerMap.read(path)


def _swing(path: Path) -> None:
    shutil.copy(_made("swings") / "calibration.c3d", path.with_name("calibration.c3d"))
    shutil.copy(_made("swings") / "markers.toml", path.with_name("markers.toml"))
    for each in read_swings([path], path.with_name("markers.toml"), "driver").rejected:
        assert each.reason


def _messages(path: Path, read: Callable[..., Message] = from_json) -> None:
    stream, result = ObjectStream(), []
    data = path.read_bytes()
    for start in range(0, len(data), 4096):
        for each in stream.feed(data[start : start + 4096]):
            if not isinstance(each, Broken):
                with suppress(MessageError):
                    result.append(read(each))
    shots = [each for each in result if each.kind == "shot"]
    if shots:
        recorded(shots)


def _frames(path: Path) -> None:
    """Read frames of Flight Relay, one a line."""
    collector, result = ShotCollector(), []
    for line in path.read_bytes().splitlines():
        if (data := text_to_object(line)) is not None:
            result += collector.feed(data)
    result += collector.rest()
    shots = [each for each in result if isinstance(each, Message) and each.kind == "shot"]
    if shots:
        recorded(shots, protocol="flight-relay")


def _live(path: Path) -> None:
    live = LiveShots(path)
    try:
        if live.shots:
            live_result(live.shots)
    finally:
        live.close()


def _live_files() -> list[bytes]:
    with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as within:
        path = Path(within) / "live.jsonl"
        live = LiveShots(path)
        live.keep(from_json(MESSAGE), "open-connect")
        live.choose("7-iron", "left")
        live.keep(from_json(MESSAGE | {"ShotNumber": 2}), "open-connect")
        live.close()
        return [path.read_bytes()]


OPENGOLFSIM = b"""\
{"type": "shot", "unit": "metric", "shot": {"ballSpeed": 60.5, "verticalLaunchAngle": 15.4,
 "horizontalLaunchAngle": -2.1, "spinSpeed": 3021, "spinAxis": -0.5}}
"""
FLIGHT_RELAY = b"""\
{"kind": "init", "version": "0.1.0"}
{"device": "E1", "event": {"kind": "shot_trigger", "key": {"shot_id": "a", "shot_number": 4}}}
{"device": "E1", "event": {"kind": "ball_flight", "key": {"shot_id": "a", "shot_number": 4}, "ball": \
{"launch_speed": "67.2mps", "launch_azimuth": -1.3, "launch_elevation": 14.2, "carry_distance": "180.5m", \
"backspin_rpm": 3200, "sidespin_rpm": -450}}}
{"device": "E1", "event": {"kind": "club_path", "key": {"shot_id": "a", "shot_number": 4}, "club": \
{"club_speed": "42.1mps", "path": -2.1, "face_angle": 1.2}}}
{"device": "E1", "event": {"kind": "face_impact", "key": {"shot_id": "a"}, "impact": {"lateral": "0.31in"}}}
{"device": "E1", "event": {"kind": "shot_finished", "key": {"shot_id": "a", "shot_number": 4}}}
"""
CHECKPOINT = {"set of shots": "these"}
VALUES = "values.jsonl"
"""Where the values of a store are."""


def _checkpoint(path: Path) -> None:
    with tempfile.TemporaryDirectory(prefix="clubface-fuzz-") as within:
        folder = Path(within) / "fit.checkpoint"
        _begin_checkpoint(folder)
        shutil.copy(path, next(folder.glob(VALUES)))
        Store(folder, CHECKPOINT).close()


def _begin_checkpoint(folder: Path) -> None:
    with Store(folder, CHECKPOINT) as store:
        for part in range(3):
            value = [0.1 * part, float("nan"), "text"]
            store.keep(f"fold {part}", {"value": value, "evaluations": 3, "impacts": 7, "seconds": 0.5})


def _checkpoints() -> list[bytes]:
    folder = _folder() / "fit.checkpoint"
    _begin_checkpoint(folder)
    return [next(folder.glob(VALUES)).read_bytes()]


def _sweep(path: Path) -> None:
    _fill_sweep(path)


def _fill_sweep(path: Path, *places: Place) -> None:
    def row(place: Place, *_: object) -> Row:
        toe, high = place
        return {"toe": toe, "high": high, "force": 5e3 + toe, "stopped": "an edge, at last" if toe else ""}

    columns = {**dict.fromkeys(SWEEP, float), "stopped": str}
    run_table(Job("runs", places, row), path, {"case": "a case"}, columns, workers=1)


def _sweeps() -> list[bytes]:
    path = _folder() / "sweep.csv"
    _fill_sweep(path, (0.0, 0.0), (0.01, 0.0), (0.02, 0.0))
    return [path.read_bytes()]


def _resumed(what: str, pattern: str, run: Callable[[], object]) -> Reader:
    """Return the reader of the first file of an unfinished work by a pattern; the others are as they should be."""
    store = "out.csv.unfinished"

    def first(folder: Path) -> Path:
        return min((folder / store).glob(pattern))

    def read(path: Path) -> None:
        folder = _made(what)
        for each in folder.glob("out*.csv"):
            each.unlink()
        shutil.rmtree(folder / store, ignore_errors=True)
        shutil.copytree(folder / "begun" / store, folder / store)
        shutil.copy(path, first(folder))
        with chdir(folder):
            run()

    return Reader(Path(pattern).suffix[1:], read, lambda: [first(_made(what) / "begun").read_bytes()])


def _go_on() -> None:
    predict("in.csv", output="out.csv", chunk_rows=4, resume=True, **PREDICT)


def _go_on_inferring() -> None:
    infer_shots(_launches(), "out.csv", resume=True, **INFER)


def _toml(folder: str) -> Callable[[], list[bytes]]:
    return _files(DATA / folder, "*.toml")


def _monitors() -> list[bytes]:
    """Return files of monitors, and some of them in the encodings of other programs and countries."""
    plain = _files(MONITORS, "*.csv")()
    texts = [each.decode("utf-8-sig") for each in plain[:5]]
    foreign = [each.encode(encoding) for each in texts for encoding in ("utf-16", "utf-16-le")]
    return [*plain, *foreign, texts[0].replace("Desc", "備考").encode("shift_jis", "replace")]


def _workbooks() -> list[bytes]:
    return [workbook(own_table(own_values(Random(1)), Random(2))), workbook(monitor_table("rapsodo.csv"))]


def _damaged_workbook(random: Random) -> bytes:
    """Return a workbook with a damaged part, whole as an archive: damage to an archive is seen before it is read."""
    source = zipfile.ZipFile(io.BytesIO(random.choice(_workbooks())))
    names, file = source.namelist(), io.BytesIO()
    chosen = random.choice(names)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in names:
            data = source.read(name)
            archive.writestr(name, mutated(data, data, random) if name == chosen else data)
    return file.getvalue()


def _recipes(make: Callable[[Random], bytes]) -> Callable[[], list[bytes]]:
    return lambda: [make(Random(number)) for number in range(3)]


def _tables() -> list[bytes]:
    return [TABLE, TABLE.replace(b",", b";").replace(b".", b","), TABLE.replace(b",", b"\t")]


READERS = {
    "shots": Reader("csv", read_shots, _tables, 4),
    "shots-tsv": Reader("tsv", read_shots, _tables),
    "shots-parquet": Reader("parquet", read_shots, _parquet, 3),
    "monitor-excel": Reader("xlsx", launch_monitor.read, _workbooks, 2),
    "monitor": Reader("csv", launch_monitor.read, _monitors, 8),
    "workbook": Reader("xlsx", launch_monitor.read, _workbooks, 1),
    "workbook-part": Reader("xlsx", launch_monitor.read, _workbooks, 2, _damaged_workbook),
    "predict": Reader("csv", _predict, _tables, 2),
    "predict-parquet": Reader("parquet", _predict, _parquet),
    "deliveries": Reader("csv", _deliveries, _tables),
    "mapping": Reader("toml", mapping_of, _files(MONITORS, "*.toml"), 2),
    "mapped": Reader("toml", _mapped, _files(MONITORS, "*.toml")),
    "club": Reader("toml", Club.from_toml, lambda: [*_toml("clubs")(), Club.template().encode()], 2),
    "ball": Reader("toml", Ball.from_toml, lambda: [*_toml("balls")(), Ball.template().encode()], 2),
    "parameters": Reader("toml", _parameters, _toml("parameters"), 2),
    "prior": Reader("toml", Prior.from_toml, lambda: [PRIOR]),
    "study": Reader("toml", study.read, lambda: [STUDY, FITTING]),
    "sweep-study": Reader("toml", _study, lambda: [each.encode() for each in SWEEPS_OF_KINDS], 2),
    "shells": Reader("toml", shells_file.read, lambda: [SHELLS]),
    "golfer": Reader("toml", golfer, lambda: [GOLFER]),
    "fem-ball": Reader("toml", fem.Ball.from_toml, _toml("balls")),
    "fem-head": Reader("toml", _head, lambda: [*_toml("fem_heads")(), HEAD.encode()]),
    "fem-case": Reader("toml", Case.from_toml, _toml("fem_cases")),
    "markers": Reader("toml", _marker_map, _markers),
    **{f"mesh-{name}": Reader(ending, _mesh, _meshes(pattern)) for name, ending, pattern in MESHES},
    "c3d": Reader("c3d", read_c3d, lambda: [(_made("swings") / "calibration.c3d").read_bytes()], 6),
    "swing": Reader("c3d", _swing, lambda: [(_made("swings") / "swing-001.c3d").read_bytes()], 1),
    "messages": Reader("json", _messages, lambda: [json.dumps(MESSAGE).encode() * 2], 4),
    "opengolfsim": Reader("json", partial(_messages, read=opengolfsim.from_json), lambda: [OPENGOLFSIM * 2], 2),
    "flight-relay": Reader("json", _frames, lambda: [FLIGHT_RELAY], 2),
    "live": Reader("jsonl", _live, _live_files, 2),
    "checkpoint": Reader("json", _checkpoint, _checkpoints, 2),
    "sweep": Reader("csv", _sweep, _sweeps, 2),
    "resumed-prediction": _resumed("prediction", "parts/*.csv", _go_on),
    "resumed-prediction-record": _resumed("prediction", VALUES, _go_on),
    "resumed-prediction-content": _resumed("prediction", "job.json", _go_on),
    "resumed-inference-record": _resumed("inference", VALUES, _go_on_inferring),
    **{name: Reader("json", read, _recipes(make), share, make) for name, (read, make, share) in ORACLES.items()},
}  # fmt: skip
"""By name. A meshed head costs a tenth of a second and is tried least."""
