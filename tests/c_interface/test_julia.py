"""The example for Julia: its signatures are held to the header; where there is Julia, it runs."""

import os
import re
import shutil

import numpy as np
import pytest

import clubface
from c_programs import EXAMPLES, ROOT, prototypes, ran
from clubface.export import inputs_csv

PROGRAM = EXAMPLES / "julia" / "drive.jl"
TYPES = {
    "Cstring": {"const char *"},
    "Ptr{Cdouble}": {"const double *", "double *"},
    "Ptr{Cvoid}": {"ClubfaceResult *", "const ClubfaceResult *"},
    "Cvoid": {"void"},
    "Cdouble": {"double"},
    "Csize_t": {"size_t"},
    "Cptrdiff_t": {"ptrdiff_t"},
    "UInt32": {"uint32_t"},
}
"""What a type of Julia stands for in C."""


def ccalls(program):
    """The calls of C in a program: function, types of the arguments, type of what it returns."""
    calls = re.findall(r"@ccall\s+libclubface\.(\w+)\(([^()]*)\)::([\w{}]+)", program)
    return [(name, re.findall(r"::([\w{}]+)", arguments), returned) for name, arguments, returned in calls]


def differences(program):
    """The calls whose signature is another than that of the header."""
    declared = prototypes((ROOT / "crates/clubface-c/include/clubface.h").read_text())
    return [
        name
        for name, arguments, returned in ccalls(program)
        if len(arguments) != len(declared[name][1])
        or any(c not in TYPES[julia] for c, julia in zip(declared[name][1], arguments, strict=True))
        or declared[name][0] not in TYPES[returned]
    ]


def test_every_call_has_the_signature_of_the_header():
    program = PROGRAM.read_text()
    assert len(ccalls(program)) == program.count("@ccall") == 9
    assert differences(program) == []


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("columns::UInt32)::Csize_t", "columns::Cint)::Csize_t"),
        ("rows::Csize_t, 0.0::Cdouble, 0::Csize_t", "rows::Csize_t, 0::Csize_t, 0.0::Cdouble"),
        ("1::Csize_t, 1::Csize_t, flown", "1::Csize_t, flown"),
        ("name::Cstring)::Cptrdiff_t", "name::Cstring)::Csize_t"),
    ],
)
def test_a_wrong_signature_is_noticed(right, wrong):
    program = PROGRAM.read_text()
    assert right in program
    TYPES.setdefault("Cint", {"int32_t"})
    assert len(differences(program.replace(right, wrong))) == 1


def test_the_program_prints_what_the_package_computes(install, tmp_path):
    if shutil.which("julia") is None:
        pytest.skip("the example for Julia is not run: that needs julia")
    swing = {"speed": "105 mph", "attack": "2 deg"}
    (tmp_path / "driver.csv").write_text(inputs_csv("driver", swing, model="volumetric"))
    environment = {**os.environ, "LD_LIBRARY_PATH": str(install / "lib")}
    printed = ran("julia", "--startup-file=no", PROGRAM, "volumetric", tmp_path / "driver.csv", env=environment)
    numbers = [float(each) for each in re.findall(r"-?\d+\.\d+(?:e-?\d+)?", printed)]
    table = clubface.sensitivity("driver", swing, model="volumetric", variables=["loft"])
    toe = clubface.impact("driver", swing, model="volumetric", toe=np.linspace(-0.03, 0.03, 1000)).ball_speed
    expected = [
        table.launch.ball_speed, table.launch.get("backspin", "rpm"), table.value("backspin", "loft") / 6.0,
        clubface.fly(table.launch).carry, toe.max() - toe[-1],
    ]  # fmt: skip
    assert numbers[:4] == pytest.approx(expected[:4], rel=1e-9)
    assert numbers[-1] == pytest.approx(expected[4], abs=1e-9)
