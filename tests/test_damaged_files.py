"""Damaged and hostile files: one line, soon, and within little memory; and values that no shot has."""

import re
import struct
import time
import tracemalloc

import numpy as np
import pytest

import clubface
from clubface import fem, shots as launch_monitor
from clubface.errors import ClubfaceError, FileError, InputError, UnitError
from clubface.jobs import Job, Store
from clubface.jobs.engine import run_table
from clubface.schema.document import MOST_PARTS, Document
from clubface.shots.reading import read_shots
from clubface.shots.tables.cells import NUMBER
from fem_meshes import HEAD, write_mesh

MEMORY = 60_000_000
"""Bytes: many times the largest of the files, and a fortieth of what they took."""
PATIENCE = 5.0
"""Seconds, some hundred times what it takes; it took half a minute."""


def refused(read, *words):
    """Refuse soon, within memory, with one line that has these words."""
    tracemalloc.start()
    began = time.monotonic()
    with pytest.raises(ClubfaceError) as caught:
        read()
    taken, peak = time.monotonic() - began, tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    text = str(caught.value)
    assert text.isprintable()
    assert len(text) < 400
    for word in words:
        assert word in text
    assert taken < PATIENCE
    assert peak < MEMORY


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("x = 1\na" + ".a" * 40_000 + " = 1\n", 2),
        ('x = 1\n"a"' + ' . "a"' * 20_000 + " = 1\n", 2),
        ("\n[a" + ".a" * 40_000 + "]\n", 2),
        ("x = 1\ny = " + "[" * 40_000 + "]" * 40_000, 2),
        ("x = 1\ny = " + "{a=" * 40_000, 2),
        ("a = [\n" * 40, 17),
    ],
)
def test_toml_of_many_parts_or_levels_is_refused_before_it_is_parsed(write, text, line):
    path = write(text, "club.toml")
    refused(lambda: clubface.club(path), f"club.toml:{line}: ", "nested too deeply")


def test_dots_and_brackets_in_texts_and_comments_are_no_depth():
    dots = "a." * 100
    text = f'a = "{dots}["  # {dots}{"[" * 50}\nb = """\n{dots}\n\\"""{dots}"""\nc = \'{dots}\'\nd.e = [[1.5]]\n'
    assert Document(text).data == {"a": dots + "[", "b": f'{dots}\n"""{dots}', "c": dots, "d": {"e": [[1.5]]}}
    deepest = "[" * MOST_PARTS + "]" * MOST_PARTS
    assert Document(f"a = {deepest}").data
    with pytest.raises(FileError, match=r":1: .*nested too deeply"):
        Document(f"a = [{deepest}]")


def test_a_whole_number_that_toml_does_not_have_is_refused():
    with pytest.raises(FileError, match=r"<text>:2: b holds a whole number of more than 64 bits"):
        Document("a = 1\nb = [[0x" + "f" * 5000 + "]]\n")
    with pytest.raises(FileError, match="a whole number has thousands of digits"):
        Document("a = 1" + "0" * 5000)


COLUMNS = "club_speed_mph,ball_speed_mph\n"


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("," * 1_900_000, 1, "some 1900001 cells; a table has at most 2000"),
        (COLUMNS + "100,140\n" + "," * 1_900_000, 3, "some 1900001 cells"),
        (COLUMNS + ("100,140\n" * 300) + ("," * 1_900_000 + "\n") * 3, 302, "some 1900001 cells"),
        (",".join(f"ball_speedx{place}_mph" for place in range(90_000)) + ",speed\n", 1, "some 90001 cells"),
        (COLUMNS + ('"' + "a" * 100_000 + '\n",') * 300, 2, "longer than 2 MB"),
    ],
)
@pytest.mark.parametrize("read", [read_shots, launch_monitor.read])
def test_a_row_that_no_table_has_is_named_by_its_line(write, read, text, line, words):
    path = write(text, "shots.csv")
    refused(lambda: read(path), f"shots.csv:{line}: the row that begins here", words)


@pytest.mark.parametrize("cell", ["-" + "," * 100_000 + "x1", "1" + " " * 100_000 + "x1", "L" + " " * 100_000 + "x"])
def test_a_long_cell_that_is_nearly_a_number_is_looked_at_once(cell):
    began = time.monotonic()
    assert NUMBER.fullmatch(cell) is None
    assert time.monotonic() - began < PATIENCE


def test_a_reject_repeats_no_more_than_a_few_cells(write):
    shots = read_shots(write(COLUMNS + "100,140\n" + "1," * 1000 + "\n" + "9" * 5000 + ",1\n"))
    long, number = shots.rejected
    assert long.reason == "1001 cells where there are 2 columns; beyond them: '1', '1', '1', ..."
    assert re.fullmatch(r"club_speed_mph: '9{20,30} \.\.\. 9{5,15}' is not a finite number", number.reason)


@pytest.mark.parametrize("name", ["head.msh", "head.inp"])
@pytest.mark.parametrize("value", ["nan", "1e300", "99999999999", "1_0", "zwei", ""])
def test_a_damaged_coordinate_of_a_mesh_is_named_by_its_line(tmp_path, write, name, value):
    write_mesh(tmp_path, name)
    path = tmp_path / name
    lines = path.read_text().splitlines()
    place = next(place for place, line in enumerate(lines) if re.match(r"5[ ,]", line))
    lines[place] = re.sub(r"(?<=[ ,]) ?-?\d+\.\d+(e[-+]\d+)?", value, lines[place], count=1)
    path.write_text("\n".join(lines))
    own = write(HEAD.replace("head.msh", name), "own.toml")
    refused(lambda: fem.head(own), f"{name}:{place + 1}: ", "coordinate")


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("\n5 ", "\n1e9 ", "number of a node"),
        ("\n5 ", "\n1000000000 ", "number of a node"),
        ("$Nodes\n667\n", "$Nodes\n667000000\n", "667000000 lines, but has 667"),
        ("142 144 145 143", "142 144 145 9999", "node 9999, which does not exist"),
    ],
)
def test_a_damaged_number_of_a_mesh_is_named_by_its_line(tmp_path, write, old, new, words):
    path = write_mesh(tmp_path)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    own = write(HEAD, "own.toml")
    refused(lambda: fem.head(own), "head.msh:", words)


@pytest.mark.parametrize(
    "damage",
    [
        lambda data: b"[" * 100_000,
        lambda data: b'{"a":' * 100_000,
        lambda data: data.replace(b"\n", b"\n\xff", 1),
        lambda data: data[:-5],
        lambda data: data.replace(b"0.125", b"0.126"),
        lambda data: data.replace(b"fold 1", b"fold 2"),
        lambda data: b"[]",
        lambda data: b"",
    ],
)
def test_damaged_parts_of_a_store_are_computed_again(tmp_path, damage):
    path, content = tmp_path / "fit.checkpoint", {"set of shots": "these"}
    value = {"value": [0.125, 2.0], "evaluations": 1, "other": float("nan")}
    with Store(path, content) as store:
        store.keep("fold 1", value)
    with Store(path, content) as store:
        assert repr(store["fold 1"]) == repr(value)
    kept = path / "values.jsonl"
    damaged = damage(kept.read_bytes())
    assert damaged != kept.read_bytes()
    kept.write_bytes(damaged)
    with Store(path, content) as store:
        assert "fold 1" not in store
        store.keep("fold 1", value)
    with Store(path, content) as store:
        assert repr(store["fold 1"]) == repr(value)


@pytest.mark.parametrize(
    ("damage", "line"),
    [
        (lambda data: data.replace(b"5000", b"50\xff0"), 3),
        (lambda data: data.replace(b"5000", b'"5000'), 3),
        (lambda data: data.replace(b"5000", b"1" * 140_000), 3),
        (lambda data: data.replace(b"5000", b"5000,1"), 3),
        (lambda data: data.replace(b"5000", b"five"), 3),
        (lambda data: data.replace(b"# case", b"\0 case"), 1),
    ],
)
def test_a_damaged_table_of_a_sweep_is_one_line(tmp_path, damage, line):
    path = tmp_path / "sweep.csv"

    def table(*places):
        job = Job("runs", places, lambda place, *_: {"toe": place[0], "high": place[1], "force": 5000})
        run_table(job, path, {"case": "a case"}, dict.fromkeys(("toe", "high", "force"), float), workers=1)

    table((0.0, 0.0))
    table()
    path.write_bytes(damage(path.read_bytes()))
    refused(table, f"sweep.csv:{line}: ")


def nested(levels):
    value = [0.0]
    for _ in range(levels):
        value = [value]
    return value


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda shot: shot(on_error=["nan"]), "unknown on_error ['nan']"),
        (lambda shot: shot(on_error=np.array(["nan", "raise"])), "unknown on_error array"),
        (lambda shot: shot(model=np.array(["slip", "area"]).reshape(2, 1)), "model is array"),
        (lambda shot: shot(model=[["slip"]]), "model is [['slip']]"),
        (lambda shot: shot(toe=np.zeros((1,) * 33)), "toe is an array of 33 dimensions; it must be one of at most 32"),
        (lambda shot: shot(toe=nested(40)), "toe is an array of 41 dimensions"),
        (lambda shot: shot(toe=nested(5000)), "toe is"),
        (lambda shot: shot(parameters={1: 2.0}), "unknown parameter of response 1"),
        (lambda shot: clubface.fly(shot(), wind=np.array(3.0)), "wind is array(3.)"),
        (lambda shot: clubface.fly(shot(), wind=(np.zeros((1,) * 33), 0.0, 0.0)), "an array of 33 dimensions"),
        (lambda shot: shot().get("ball_speed", ["mph"]), "ball_speed is ['mph']; it must be text, such as m/s"),
        (lambda shot: clubface.sensitivity("driver", speed=50.0, model=["slip"]), "model is ['slip']"),
        (lambda shot: clubface.history("driver", speed=50.0, model=np.array(["slip", "area"])), "model is array"),
        (lambda shot: clubface.club("driver").replace(sources=3), "sources is 3"),
    ],
)
def test_a_value_of_another_kind_is_an_error_of_the_package(call, words):
    refused(lambda: call(lambda **given: clubface.impact("driver", **{"speed": 50.0, **given})), words)


def test_the_error_of_a_unit_that_is_no_text_is_about_the_unit():
    with pytest.raises(UnitError) as caught:
        clubface.units.unit(["mph"])
    assert isinstance(caught.value, InputError)


@pytest.fixture(scope="module")
def session(tmp_path_factory):
    pytest.importorskip("ezc3d")
    from clubface.capture.synthetic.laboratory import synthesize

    folder = tmp_path_factory.mktemp("session")
    synthesize(folder, 3, seed=1)
    return folder


def parameters_of(content):
    """Where each parameter of a C3D file begins with its type, by its name, and its group, by the same."""
    at, result = (content[0] - 1) * 512 + 4, {}
    while content[at]:
        length, group = abs(struct.unpack_from("b", content, at)[0]), struct.unpack_from("b", content, at + 1)[0]
        label = content[at + 2 : at + 2 + length].decode()
        if group > 0:
            result[f"{group}:{label}"] = (at + 1, at + 4 + length)
        step = struct.unpack_from("<h", content, at + 2 + length)[0]
        at += 2 + length + step
    return result


@pytest.mark.parametrize(
    ("name", "place", "value", "words"),
    [
        ("2:SCALE", 0, 1, "POINT:SCALE is not a number"),  # an empty array takes the place of the scale of points
        ("1:RATE", 1, 255, "POINT:RATE is not a number"),
        ("1:FRAMES", 1, 255, "POINT:FRAMES is not a number"),
        ("2:USED", 1, 255, "ANALOG:USED is not a number"),
        ("4:RATE", 1, 255, "ROTATION:RATE is not a number"),
    ],
)
def test_a_c3d_file_that_crashes_the_library_is_refused_before(session, tmp_path, name, place, value, words):
    from clubface.capture.recording import read_c3d

    content = bytearray((session / "calibration.c3d").read_bytes())
    content[parameters_of(content)[name][place]] = value
    path = tmp_path / "bad.c3d"
    path.write_bytes(content)
    refused(lambda: read_c3d(path), "bad.c3d: this C3D file is damaged: ", words)


def test_a_crash_of_the_library_is_one_bad_file_and_the_rest_is_read(session, tmp_path, monkeypatch):
    from clubface.capture import recording
    from clubface.capture.swing import read_swings

    dies = tmp_path / "library.py"
    dies.write_text(
        (recording.LIBRARY._file).read_text()
        + "\n\nwhole = contents\n\n\ndef contents(path):\n    import os, signal\n"
        + "    if path.endswith('002.c3d'):\n        os.kill(os.getpid(), signal.SIGSEGV)\n    return whole(path)\n"
    )
    monkeypatch.setattr(recording, "LIBRARY", type(recording.LIBRARY)(dies))
    result = read_swings([session / f"swing-00{each}.c3d" for each in (1, 2, 3)], session / "markers.toml", "driver")
    assert result.places == (1, 3)
    (bad,) = result.rejected
    assert "swing-002.c3d: this C3D file cannot be read: the library that reads it crashed (SIGSEGV)" in bad.reason


def test_endless_work_and_all_memory_end_the_process_apart_and_nothing_else(tmp_path, monkeypatch):
    from clubface.support import processes

    library = tmp_path / "library.py"
    library.write_text(
        "def endless():\n    while True:\n        pass\n\n\ndef all_memory():\n    return len(bytearray(2**45))\n\n\n"
        "def echo(value):\n    print('noise')\n    return value\n\n\ndef broken():\n    raise ValueError('a\\nb')\n"
    )
    monkeypatch.setattr(processes, "LEAST_TIME", 0.5)
    process = processes.IsolatedProcess(library)
    with pytest.raises(processes.IsolatedError, match="takes longer than"):
        process.call("endless")
    monkeypatch.setattr(processes, "LEAST_TIME", 60.0)  # what follows ends by itself, however busy the machine is
    with pytest.raises(processes.IsolatedError, match="more memory"):
        process.call("all_memory")
    with pytest.raises(processes.IsolatedError, match=r"^a b$"):
        process.call("broken")
    assert process.call("echo", {"points": np.arange(3.0)})["points"].tolist() == [0.0, 1.0, 2.0]
