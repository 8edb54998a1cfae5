"""The installed C library: programs in C and C++ find it by pkg-config and CMake, and compute what the package does."""

import csv
import ctypes
import io
import json
import math
import os
import re
import shutil
import subprocess
import tomllib

import numpy as np
import pytest

import clubface
from c_programs import EXAMPLES, ROOT, STRICT, ran
from clubface.export import inputs_csv
from clubface.simulation.results import inputs
from clubface.support.version import __version__

C = ("cc", "-std=c99")
CXX = ("c++", "-std=c++11", "-x", "c++")
NAMES = ["drive", "batch", "flight", "errors"]


@pytest.fixture(scope="module")
def by_pkg_config(flags, tmp_path_factory):
    """The examples, compiled as C99 with every warning an error."""
    folder = tmp_path_factory.mktemp("programs")
    for name in NAMES:
        ran(*C, *STRICT, EXAMPLES / f"{name}.c", *flags, "-lm", "-o", folder / name)
    return folder


@pytest.fixture(scope="module")
def by_cmake(install, tmp_path_factory):
    """The same, by the CMake project of the examples."""
    if shutil.which("cmake") is None:
        pytest.skip("libclubface is not tested with CMake, which is not installed")
    folder = tmp_path_factory.mktemp("build")
    ran("cmake", "-S", EXAMPLES, "-B", folder, f"-DCMAKE_PREFIX_PATH={install}",
        f"-DCMAKE_C_FLAGS={' '.join(STRICT)}")  # fmt: skip
    ran("cmake", "--build", folder)
    return folder


@pytest.fixture(scope="module", params=["pkg-config", "CMake"])
def programs(request):
    return request.getfixturevalue({"pkg-config": "by_pkg_config", "CMake": "by_cmake"}[request.param])


def equipment_and_swing(source):
    """The club, the ball and the delivery that the table of a program lists."""
    given = {name: float(value) for name, value in re.findall(r'\{"(\w+)",\s*([\d.e+-]+)\}', source)}
    renamed = {"club_mass": "mass", "static_loft": "loft"}
    by_group = {
        group: {name: value for name, value in given.items() if inputs()[name].group == group}
        for group in ("delivery", "club", "ball")
    }
    head = {renamed.get(name, name): value for name, value in by_group["club"].items() if name != "hand"}
    zeros = dict.fromkeys(("cg_z", "ixy", "ixz", "iyz"), 0.0)
    club = clubface.Club(name="of the program", kind="wood", **zeros, **head)
    ball = clubface.Ball(
        name="its ball", **{name.removeprefix("ball_"): each for name, each in by_group["ball"].items()}
    )
    return club, ball, by_group["delivery"]


def test_a_drive_prints_the_launch_the_derivative_and_the_carry_of_the_package(programs):
    printed = ran(programs / "drive")
    club, ball, swing = equipment_and_swing((EXAMPLES / "drive.c").read_text())
    launch = clubface.impact(club, swing, ball=ball, model="response")
    by_toe = clubface.sensitivity(club, swing, ball=ball, model="response", variables=["toe"])
    flight = clubface.fly(launch)
    assert printed.splitlines()[:3] == [
        f"ball speed {launch.ball_speed:.2f} m/s, backspin {launch.get('backspin', 'rpm'):.0f} rpm",
        f"a millimetre more to the toe: {by_toe.value('ball_speed', 'toe') * 1e-3:+.3f} m/s",
        f"carry {flight.carry:.1f} m, {flight.side:.1f} m to the right",
    ]
    assert json.loads(printed.splitlines()[3].removeprefix("refused: "))["input"] == "speed"


def test_the_program_with_the_archive_runs_where_there_is_no_library(by_cmake, tmp_path):
    alone = (by_cmake / "drive-static").rename(tmp_path / "drive")
    shared = ran("ldd", alone) if shutil.which("ldd") else ""
    assert "libclubface" not in shared
    assert ran(alone) == ran(by_cmake / "drive")


def test_a_batch_of_a_thousand_strikes_is_that_of_the_package(programs, tmp_path):
    swing = {"speed": "105 mph", "attack": "2 deg", "closure": 40.0}
    (tmp_path / "shot.csv").write_text(inputs_csv("7-iron", swing, model="volumetric"))
    printed = ran(programs / "batch", "volumetric", tmp_path / "shot.csv")
    rows = np.array([[float(each) for each in row] for row in list(csv.reader(io.StringIO(printed)))[1:]])
    toe, high = -0.06 + 0.003 * (np.arange(1000) % 40), -0.024 + 0.002 * (np.arange(1000) // 40)
    launch = clubface.impact("7-iron", swing, toe=toe, high=high, model="volumetric", on_error="nan")
    on_face = ~np.isnan(launch.ball_speed)
    assert 0 < on_face.sum() < 1000
    # Nine digits of results are printed, and a tenth of a millimetre of places.
    for column, expected in enumerate([toe * 1e3, high * 1e3, launch.ball_speed, launch.get("backspin", "rpm"),
                                       launch.get("sidespin", "rpm")]):  # fmt: skip
        assert rows[:, column] == pytest.approx(expected[on_face], rel=5.1e-9, abs=0.051 if column < 2 else 0.0)


def test_a_table_of_another_model_is_refused(programs, tmp_path):
    (tmp_path / "shot.csv").write_text(inputs_csv("driver", {"speed": 45.0}, model="standard"))
    refused = subprocess.run([programs / "batch", "volumetric", tmp_path / "shot.csv"], capture_output=True, text=True)
    assert refused.returncode == 1
    assert "of another model" in refused.stderr


def test_a_flight_is_that_of_the_package(programs):
    carry, side, worth, time, apex = map(float, re.findall(r"[-+]?\d+\.\d+", ran(programs / "flight")))
    launch = {"ball_speed": 70.0, "launch": math.radians(12.0), "azimuth": 0.0, "sidespin": 300.0 * math.pi / 30.0,
              "ball_mass": 0.0459, "ball_radius": 0.02134, "ball_inertia": 8.2e-6}  # fmt: skip
    flown, more, less = (
        clubface.fly({**launch, "backspin": spin * math.pi / 30.0}, wind=(-5.0, 0.0, 0.0))
        for spin in (2600.0, 2650.0, 2550.0)
    )
    assert (carry, side, time) == pytest.approx((flown.carry, flown.side, flown.flight_time), abs=1e-6)
    assert apex == pytest.approx(flown.apex, abs=0.05)  # the highest point of the path, not of the curve through it
    # The central difference over 100 rpm misses the derivative by a part in 1e4: the carry is that curved.
    assert worth == pytest.approx(more.carry - less.carry, rel=1e-3)


def test_errors_name_the_input_and_one_bad_shot_leaves_the_others_alone(programs):
    lines = ran(programs / "errors").splitlines()
    results = dict(line.split(": ", 1) for line in lines)
    assert json.loads(results["no such model"])["input"] == "model"
    assert json.loads(results["tolerance"])["input"] == "tolerance"
    [rejected] = json.loads(results["a miss"])
    assert (rejected["row"], rejected["input"]) == (1, "toe")
    assert results["shot 1"] == "none"
    assert results["shot 0"] == results["shot 2"] != "none"


def test_programs_in_c_plus_plus_compute_the_same(by_pkg_config, flags, tmp_path):
    for name in ("drive", "flight", "errors"):
        ran(*CXX, *STRICT, EXAMPLES / f"{name}.c", *flags, "-lm", "-o", tmp_path / name)
        assert ran(tmp_path / name) == ran(by_pkg_config / name)


def test_the_header_brings_no_other_names_and_every_function_of_the_library(install):
    header = (install / "include" / "clubface.h").read_text()
    code = re.sub(r"//[^\n]*|/\*.*?\*/", "", header, flags=re.DOTALL)
    declared = set(re.findall(r"(\w+)\((?!\*)", code)) - {"defined"}
    assert all(name.startswith("clubface_") for name in declared), declared
    exported = {
        line.split()[-1] for line in ran("nm", "-D", "--defined-only", install / "lib/libclubface.so").splitlines()
    }
    assert {name for name in exported if name.startswith("clubface_")} == declared


def test_the_name_of_the_library_ends_in_the_number_of_its_interface(install):
    library = ctypes.CDLL(str(install / "lib" / "libclubface.so"))
    number = library.clubface_abi()
    assert (install / "lib" / "libclubface.so").resolve().name == f"libclubface.so.{number}.0.0"
    assert f"[libclubface.so.{number}]" in ran("readelf", "-d", install / "lib" / "libclubface.so")
    library.clubface_version.restype = ctypes.c_char_p
    assert library.clubface_version().decode() == __version__
    # What cargo-c would install has the same number.
    manifest = tomllib.loads((ROOT / "crates/clubface-c/Cargo.toml").read_text())
    assert manifest["package"]["metadata"]["capi"]["library"]["version"] == f"{number}.0.0"


def test_make_installs_into_the_prefix():
    planned = ran("make", "--no-print-directory", "-n", "libclubface", "PREFIX=/a folder", cwd=ROOT)
    assert planned.strip() == 'scripts/install-libclubface.sh "/a folder"'


def test_pkg_config_names_what_the_archive_needs(install, tmp_path):
    environment = {**os.environ, "PKG_CONFIG_PATH": str(install / "lib" / "pkgconfig")}
    assert ran("pkg-config", "--modversion", "clubface", env=environment).strip() == __version__
    words = ran("pkg-config", "--static", "--cflags", "--libs", "clubface", env=environment).split()
    needed = [word for word in words if word != "-lclubface"]
    ran(*C, EXAMPLES / "errors.c", install / "lib/libclubface.a", *needed, "-o", tmp_path / "errors")
    assert "shot 1: none" in ran(tmp_path / "errors")


MAJOR, MINOR = map(int, __version__.split(".")[:2])


@pytest.mark.parametrize(("wanted", "fits"), [(f"{MAJOR}.{MINOR}", True), (__version__, True), ("0.0.9", False),
                                              (f"{MAJOR}.{MINOR + 1}", False), (f"{MAJOR + 1}.0", False)])  # fmt: skip
def test_cmake_takes_a_version_of_the_same_series_alone(install, tmp_path, wanted, fits):
    if shutil.which("cmake") is None:
        pytest.skip("libclubface is not tested with CMake, which is not installed")
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.16)\nproject(x NONE)\n"
        f'find_package(clubface {wanted} QUIET)\nmessage(STATUS "found: ${{clubface_FOUND}}")\n'
    )
    printed = ran("cmake", "-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={install}")
    assert ("found: 1" in printed or "found: TRUE" in printed) is fits
