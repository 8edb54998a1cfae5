"""The examples for MATLAB, run by Octave as far as it goes, and their signatures held to the header."""

import json
import os
import re
import shutil

import numpy as np
import pytest

import clubface
from c_programs import EXAMPLES, OCTAVE, ROOT, STRICT, prototypes, ran
from clubface.export import inputs_csv
from clubface.simulation.results import inputs, outputs

MATLAB = EXAMPLES / "matlab"
SWING = {"speed": "105 mph", "attack": "2 deg", "toe": 0.006, "closure": 40.0}


@pytest.fixture(scope="module")
def octave(install, tmp_path_factory):
    """Run statements in Octave, with the functions of the examples and `driver.csv`; return what they print."""
    for tool in ("octave-cli", "mkoctfile"):
        if shutil.which(tool) is None:
            pytest.skip(f"the examples for MATLAB are not run: that needs {tool} (Debian: octave and octave-dev)")
    folder = tmp_path_factory.mktemp("octave")
    (folder / "driver.csv").write_text(inputs_csv("driver", SWING, model="volumetric"))
    for source in (MATLAB / "clubface_launch.c", OCTAVE / "call_library.c"):
        ran("mkoctfile", "--mex", *STRICT, source, f"-I{install}/include", f"-I{MATLAB}", f"-L{install}/lib",
            "-lclubface", f"-Wl,-rpath,{install}/lib", cwd=folder)  # fmt: skip

    def run(statements):
        paths = f"addpath('{MATLAB}'); addpath('{OCTAVE}');"
        environment = {**os.environ, "HOME": str(folder)}
        return ran("octave-cli", "-q", "--no-history", "--eval", paths + statements, cwd=folder, env=environment)

    return run


def read(printed):
    """The value that `disp(jsonencode(...))` printed last."""
    return json.loads(printed.strip().splitlines()[-1])


def test_a_mex_function_computes_a_thousand_strikes_and_their_derivatives(octave):
    call = "[toe, loss, slopes] = strikes('volumetric', 'driver.csv'); disp(jsonencode({toe, loss, slopes}))"
    toe, loss, slopes = map(np.array, read(octave(call)))
    swing = {**SWING, "toe": np.linspace(-0.03, 0.03, 1000)}
    table = clubface.sensitivity("driver", swing, model="volumetric", variables=["loft", "toe"])
    assert toe == pytest.approx(swing["toe"], abs=1e-15)
    # The places of Octave and NumPy differ in their last bits, and the fast setting steps over a contact a little
    # differently then: some 1e-9 of the speed, and 1e-6 of its derivatives, are left.
    speed = clubface.impact("driver", swing, model="volumetric").ball_speed
    assert loss == pytest.approx(speed.max() - speed, abs=1e-8)
    expected = [[table.value(output, name) for name in ("loft", "toe")] for output in ("backspin", "sidespin")]
    assert slopes == pytest.approx(np.moveaxis(np.array(expected), 2, 0), rel=1e-6, abs=1e-3)


def test_a_mex_function_gives_one_shot_as_a_row(octave):
    call = "[a, p] = read_shot('driver.csv'); v = clubface_launch('volumetric', a, p, {'launch', 'smash'});"
    launch = clubface.impact("driver", SWING, model="volumetric")
    assert read(octave(call + "disp(jsonencode(v))")) == pytest.approx([launch.launch, launch.smash], rel=1e-14)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("'volumetric', a, p, {'ball_sped'}", "there is no output 'ball_sped'"),
        ("'volumetrik', a, p, {'ball_speed'}", "the model is unknown"),
        ("'volumetric', a(1:3), p, {'ball_speed'}", "as many columns"),
        ("'volumetric', a, p(1:3), {'ball_speed'}", "as many numbers"),
        ("'volumetric', a, p, 'ball_speed'", "in a cell"),
        ("'volumetric', a, p", "give model"),
    ],
)
def test_a_mex_function_refuses_what_is_not_right(octave, arguments, message):
    call = f"[a, p] = read_shot('driver.csv'); try, clubface_launch({arguments}), catch e, disp(e.message), end"
    assert message in octave(call)


def test_a_mex_function_warns_of_a_miss_and_keeps_the_other_shots(octave):
    call = (
        "[a, p, names] = read_shot('driver.csv'); b = [a; a]; b(1, strcmp(names, 'toe')) = 0.4;"
        "v = clubface_launch('volumetric', b, p, {'ball_speed'}); [message, id] = lastwarn();"
        "disp(jsonencode({isnan(v), id, message}))"
    )
    missing, identifier, message = read(octave(call))
    assert missing == [True, False]
    assert identifier == "clubface:shots"
    assert "outside the face outline" in message


def test_loadlibrary_gives_launch_derivatives_and_carry(octave, install):
    """Octave has no loadlibrary: one that knows these functions alone stands in, so that the example itself runs."""
    call = f"[l, J, c] = drive('{install}', 'volumetric', 'driver.csv'); disp(jsonencode({{l, J, c}}))"
    launch, jacobian, carry = read(octave(call))
    table = clubface.sensitivity("driver", SWING, model="volumetric")
    for place, name in enumerate(outputs()):
        assert launch[place] == pytest.approx(getattr(table.launch, name), rel=1e-12, abs=1e-12), name
    speed, toe = list(outputs()).index("ball_speed"), list(inputs()).index("toe")
    assert jacobian[speed][toe] == pytest.approx(table.value("ball_speed", "toe"), rel=1e-9)
    assert carry == pytest.approx(clubface.fly(table.launch).carry, rel=1e-12)


def test_an_error_of_the_library_is_one_of_matlab(octave, install):
    call = (
        "text = strrep(fileread('driver.csv'), 'speed,46.9392', 'speed,-1'); f = fopen('bad.csv', 'w'); fputs(f, text);"
        f"fclose(f); try, drive('{install}', 'volumetric', 'bad.csv'), catch e, disp(e.message), end"
    )
    assert "must be above 0 m/s" in octave(call)


def test_the_header_for_loadlibrary_declares_what_the_header_does():
    """Types that loadlibrary does not know become those that it does."""
    whole = prototypes((ROOT / "crates/clubface-c/include/clubface.h").read_text())
    reduced = prototypes((MATLAB / "clubface_matlab.h").read_text())
    assert len(reduced) == 11
    for name, (returned, arguments) in reduced.items():
        expected = [whole[name][0], *whole[name][1]]
        assert [returned, *arguments] == [each.replace("ClubfaceResult", "void") for each in expected], name


def test_the_script_calls_functions_with_the_arguments_that_they_take():
    reduced = prototypes((MATLAB / "clubface_matlab.h").read_text())
    calls = re.findall(r"calllib\('libclubface', '(\w+)'((?:, [^,()]+)*)\)", (MATLAB / "drive.m").read_text())
    assert len(calls) >= 7
    for name, arguments in calls:
        assert arguments.count(",") == len(reduced[name][1]), name
