"""C3D files and mapping files: what is read, what is refused, and with which words."""

import math
import struct
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from captures import Cameras, random_swing
from clubface.capture.markers import MarkerMap, template
from clubface.capture.recording import Recording, RecordingHeader, check_layout, read_c3d, write_c3d
from clubface.capture.synthetic.laboratory import calibration_map, positions_map
from clubface.errors import FileError, InputError


@pytest.fixture
def recording():
    positions = np.random.default_rng(1).uniform(-2.0, 2.0, (40, 3, 3))
    positions[5:9, 1] = np.nan
    return Recording(labels=("HEAD1", "club:HEAD2", "BALL"), positions=positions, rate=720.0)


@pytest.fixture
def file(recording, tmp_path):
    return write_c3d(recording, tmp_path / "swing.c3d")


def points_at(content):
    """Where the points of a C3D file begin."""
    return (struct.unpack_from("<H", content, 16)[0] - 1) * 512


def test_what_is_written_is_read_back(recording, file):
    result = read_c3d(file)
    assert result.labels == recording.labels
    assert (result.rate, result.first_frame, result.path) == (720.0, 1, str(file))
    assert check_layout(file) == RecordingHeader(3, 0, 40, 1)
    # A file holds mm in single precision: 2000 mm to 1e-4 mm.
    assert np.array_equal(np.isnan(result.positions), np.isnan(recording.positions))
    assert np.nanmax(np.abs(result.positions - recording.positions)) < 1.2e-7
    assert result.times[1] == 1 / 720


def test_invalid_points_and_points_at_the_origin_were_not_seen(file):
    content = bytearray(file.read_bytes())
    start = points_at(content)
    struct.pack_into("<f", content, start + 12, -1.0)  # first frame, first point: its fourth word, the residual
    struct.pack_into("<3f", content, start + 3 * 16 + 2 * 16, 0.0, 0.0, 0.0)  # second frame, third point
    file.write_bytes(content)
    result = read_c3d(file)
    assert np.isnan(result.positions[0, 0]).all()
    assert np.isnan(result.positions[1, 2]).all()
    assert np.isnan(result.positions).any(-1).sum() == 4 + 2


def test_a_marker_is_found_by_its_name_or_after_that_of_its_subject(recording):
    assert np.array_equal(recording.marker("HEAD2"), recording.positions[:, 1], equal_nan=True)
    with pytest.raises(FileError, match=r"no markers HEAD3, TOE; it has: HEAD1, club:HEAD2, BALL"):
        recording.markers(["HEAD1", "HEAD3", "TOE"])
    double = Recording(labels=("a:X", "b:X"), positions=np.zeros((1, 2, 3)), rate=1.0)
    with pytest.raises(FileError, match=r"marker X may be any of a:X, b:X"):
        double.marker("X")


def test_the_unit_of_length_is_the_files_unless_another_is_given(file, recording):
    metres = read_c3d(file, unit="m")
    assert metres.positions[0, 0] == pytest.approx(1e3 * recording.positions[0, 0], rel=1e-6)
    content = file.read_bytes()
    at = content.index(b"UNITS")
    named = bytearray(content)
    named[content.index(b"mm", at) : content.index(b"mm", at) + 2] = b"cm"
    file.write_bytes(named)
    assert read_c3d(file).positions[0, 0] == pytest.approx(10.0 * recording.positions[0, 0], rel=1e-6)
    for letters, message in (
        (b"qq", r"the unit of length 'qq' is unknown"),
        (b"  ", "does not name its unit of length"),
    ):
        named[content.index(b"mm", at) : content.index(b"mm", at) + 2] = letters
        file.write_bytes(named)
        with pytest.raises(FileError, match=message):
            read_c3d(file)
        assert read_c3d(file, unit="mm").positions[0, 0] == pytest.approx(recording.positions[0, 0], rel=1e-6)
    with pytest.raises(InputError, match="units"):
        read_c3d(file, unit="deg")


def test_empty_cut_and_foreign_files_are_distinguished(file, tmp_path):
    content = file.read_bytes()
    spoiled = tmp_path / "spoiled.c3d"
    for kept, message in (
        (b"", "the file is empty"),
        (b"speed,attack\n1,2\n", "this is not a C3D file"),
        (content[:300], "cut short: it ends within its parameters, after 300 bytes"),
        (content[:1100], r"the file is cut short"),
        (content[: points_at(content) + 1000], r"the file is cut short: \d+ bytes of at least \d+ for 40 frames"),
        (b"\0" * 4096, "this is not a C3D file"),
    ):
        spoiled.write_bytes(kept)
        with pytest.raises(FileError, match=message) as caught:
            read_c3d(spoiled)
        assert str(caught.value).startswith(str(spoiled))
    with pytest.raises(FileError, match="cannot be read: No such file"):
        read_c3d(tmp_path / "absent.c3d")
    with pytest.raises(FileError, match="cannot be read"):
        read_c3d(tmp_path)


SURVIVOR = """
import sys
from clubface.errors import FileError
from clubface.capture import read_c3d
for path in sys.argv[1:]:
    try:
        print(read_c3d(path).positions.shape)
    except FileError as error:
        print(f"FileError {str(error)[:60]!r}")
"""


def test_damaged_files_are_refused_or_read_but_never_end_the_process(file, tmp_path):
    """Two hundred files with random bytes in header and parameters, in a process of their own."""
    content = file.read_bytes()
    random = np.random.default_rng(3)
    paths = []
    for number in range(200):
        spoiled = bytearray(content)
        for _ in range(int(random.choice([1, 3, 10, 40]))):
            spoiled[int(random.integers(0, points_at(content) + 40))] = int(random.integers(256))
        paths.append(tmp_path / f"{number}.c3d")
        paths[-1].write_bytes(spoiled[: int(random.integers(1, len(spoiled) + 1))] if number % 4 == 0 else spoiled)
    ran = subprocess.run([sys.executable, "-c", SURVIVOR, *paths], capture_output=True, text=True, timeout=60)
    assert ran.returncode == 0, ran.stderr[-500:]
    lines = ran.stdout.splitlines()
    assert len(lines) == 200
    assert sum(line.startswith("FileError") for line in lines) > 60


@settings(max_examples=60)
@given(st.binary(max_size=2000))
def test_any_bytes_are_refused_or_understood(tmp_path_factory, content):
    path = tmp_path_factory.mktemp("bytes") / "any.c3d"
    path.write_bytes(b"\x02\x50" + content)
    with pytest.raises(FileError):
        check_layout(path)


def test_a_mapping_reads_back_as_it_was_written():
    club, cameras = random_swing(1).club, Cameras()
    for made in (positions_map(club, cameras), calibration_map(club, cameras)):
        result = MarkerMap.from_text(made.to_toml())
        assert result.cluster == made.cluster  # lengths of whole mm come back to the last bit
        assert (result.target, result.up, result.ball, result.club) == ("+y", "+z", "BALL", "driver")
        assert {name: tuple(each) for name, each in result.face.items()} == {
            name: pytest.approx(tuple(each)) for name, each in made.face.items()
        }
    line = MarkerMap(
        cluster={"A B": (0.0, 0.0, 0.001), 'C"': (0.1, 0.0, 0.0), "D": (0.0, 0.1, 0.0)}, ball_position=(1.0, 2.0, 3.0),
        target=("NEAR", "FAR"), up="-y", unit="cm", noise=2e-4, accuracy=1e-3,
    )  # fmt: skip
    result = MarkerMap.from_text(line.to_toml())
    assert result.cluster == line.cluster
    assert (result.target, result.unit, result.noise, result.accuracy) == (("NEAR", "FAR"), "cm", 2e-4, 1e-3)
    assert result.ball_position == pytest.approx((1.0, 2.0, 3.0))


def test_the_template_is_a_mapping():
    result = MarkerMap.from_text(template())
    assert result.face["FACE_TOE"].toe == pytest.approx(0.03)
    assert result.accuracy == pytest.approx(3e-4)
    assert result.calibration_path.name == "calibration.c3d"


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ("[face] ", "[fce] ", 20, r"unknown key 'fce' \(did you mean face\?\)"),
        ('HEAD1 = "seen"', 'HEAD1 = ["1 mm", "2 mm"]', 5, "HEAD1 is .*three lengths in a list"),
        (
            'HEAD1 = "seen"',
            'HEAD1 = ["1 mm", "2 mm", "3 mm"]',
            None,
            r"by its positions and by \[face\]; keep one",
        ),
        ('high = "18 mm"', 'hgh = "18 mm"', 23, "unknown key .hgh. .did you mean high"),
        ('toe = "30 mm", ', "", 22, r"keys of \[face.FACE_TOE\] are missing: toe"),
        ('toe = "30 mm"', 'toe = "30 deg"', 22, "in m or mm"),
        ('"0.3 mm"           # standard', '"-1 mm" # standard', 16, "accuracy is '-1 mm'; it must be from 0 mm"),
        ('target = "+y"', 'target = "+z"', 31, r"perpendicular to the up axis, \+z"),
        ('target = "+y"', 'target = "north"', 31, r"one of \+x, -x"),
        ('target = "+y"', "target = 3", 31, "an axis in quotes or a list of two markers"),
        ('marker = "BALL"', "", 25, "without marker and position"),
        ('file = "calibration.c3d"', "file = 7", 15, "calibration.file is 7; it must be text in quotes"),
        ('# unit = "mm"', 'unit = "furlong"', 33, "in m or mm"),
        ("# [noise]", '[noise]\nmarker = "0 mm"', None, "marker is '0 mm'; it must be above 0 mm"),
        ("[ball]", "[ball", None, "this is not TOML"),
    ],
)
def test_a_mistake_in_a_mapping_is_reported_with_its_line(old, new, line, message):
    text = template()
    assert old in text
    with pytest.raises(FileError, match=message) as caught:
        MarkerMap.from_text(text.replace(old, new, 1), "map.toml")
    if line is not None:
        assert caught.value.line == line


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"cluster": {"A": None, "B": None}}, "2 markers.*at least 3"),
        ({"face": {}}, "not placed on the club; give one of these: positions"),
        (
            {"by": None, "calibration": "x.c3d", "face": {}, "cluster": dict.fromkeys("ABC", (0.0, 0.0, 0.0))},
            "leave it out, or give by = .face. or by = .address.",
        ),
        ({"ball_position": (0.0, 0.0, 0.0)}, "given twice"),
        ({"up": "z"}, r"up is 'z'; it must be one of \+x"),
    ],
)
def test_a_mapping_from_code_is_checked_as_well(changes, message):
    from dataclasses import replace

    good = MarkerMap.from_text(template())
    with pytest.raises(InputError, match=message):
        replace(good, **changes)
    assert math.isclose(good.face["FACE_TOP"].standoff, 0.002)


def test_a_file_that_is_one_byte_too_short_is_refused_and_one_that_just_fits_is_read(file):
    content = file.read_bytes()
    # 40 frames of 3 points of 4 numbers of 4 bytes.
    needed = points_at(content) + 40 * 3 * 4 * 4
    file.write_bytes(content[:needed])
    assert check_layout(file) == RecordingHeader(3, 0, 40, 1)
    assert read_c3d(file).positions.shape == (40, 3, 3)
    file.write_bytes(content[: needed - 1])
    with pytest.raises(FileError, match=f"cut short: {needed - 1} bytes of at least {needed} for 40 frames"):
        check_layout(file)


def test_a_header_of_another_number_of_points_or_of_frames_that_end_first_is_damaged(file):
    content = file.read_bytes()
    for at, value, message in (
        (2, 4, "4 points, POINT:USED 3"), (2, 0, "0 points"),
        (6, 41, "data end before"),
    ):  # fmt: skip
        spoiled = bytearray(content)
        struct.pack_into("<H", spoiled, at, value)
        file.write_bytes(spoiled)
        with pytest.raises(FileError, match=message):
            check_layout(file)
    # One frame: first and last are the same.
    single = bytearray(content)
    struct.pack_into("<H", single, 6, 40)
    file.write_bytes(single)
    assert check_layout(file).frames == 1


def test_without_a_parameter_the_frames_are_those_of_the_header(file):
    content = bytearray(file.read_bytes())
    # Name, offset to the next parameter (2 bytes), type, number of dimensions and these, then the value.
    at = content.index(b"FRAMES", 512) + len("FRAMES")
    at += 4 + content[at + 3]
    assert struct.unpack_from("<H", content, at) == (40,)
    struct.pack_into("<H", content, at, 0)
    file.write_bytes(content)
    assert check_layout(file).frames == 40
