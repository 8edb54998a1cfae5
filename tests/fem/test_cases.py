"""Balls and cases as files: what they give, what is refused and where, whatever stands in them."""

import math
import re
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings, strategies as st

from clubface import fem
from clubface.errors import ClubfaceError, FileError, InputError, UnknownNameError
from clubface.fem import sweep as sweeps
from clubface.fem.case import Case, case, case_names
from fem_runs import BALL, coarse, drive_case, throw_case, write_case


@pytest.mark.parametrize("name", fem.ball_names())
def test_built_in_balls_weigh_what_they_say(name):
    made = fem.ball(name)
    result = made.properties()
    assert result["mass"] == pytest.approx(made.mass, rel=1e-12)
    assert result["radius"] == pytest.approx(made.diameter / 2.0, rel=1e-12)
    assert result["elements"] == made.elements


@pytest.mark.parametrize("name", case_names())
def test_built_in_cases_are_read(name):
    assert case(name).name == name


def test_a_case_reads_its_ball_from_its_own_folder(tmp_path):
    result = case(write_case(tmp_path))
    assert result.ball.name == "soft"
    assert result.ball == replace(fem.Ball.from_toml(tmp_path / "ball.toml"))
    assert result.friction == 0.3
    assert result.settings.duration == pytest.approx(100e-6)
    core, cover = result.ball.pieces
    assert core.material.bulk == pytest.approx(496.67e6, rel=1e-5)
    assert cover.material.youngs == pytest.approx(350e6)
    assert result.run().steps > 10


OGDEN = 'law = "ogden"\nmu1 = "8 MPa"\nalpha1 = 2\nmu2 = "-2 MPa"\nalpha2 = -2'
RIVLIN = 'law = "mooney-rivlin"\nc10 = "4 MPa"\nc01 = "1 MPa"'


def test_ogdens_rubber_with_exponents_of_two_is_mooney_and_rivlins(tmp_path):
    rivlin = case(write_case(tmp_path, duration=600)).run()
    ogden = case(write_case(tmp_path, duration=600, old=RIVLIN, new=OGDEN))
    core = ogden.ball.pieces[0].material
    assert (core.law, core.constants["alpha2"], core.shear) == ("ogden", -2.0, pytest.approx(10e6))
    # Rounding, grown over a thousand steps.
    assert ogden.run().peak_force == pytest.approx(rivlin.peak_force, rel=1e-7)


@pytest.mark.parametrize(
    ("new", "message"),
    [
        (
            OGDEN.replace('mu2 = "-2 MPa"', 'mu2 = "2 MPa"'),
            "ball.toml:12: mu2 of core is '2 MPa'; it must be of the sign of alpha2",
        ),
        (OGDEN.replace("alpha1 = 2", "alpha1 = 0"), "ball.toml:11: alpha1 of core is 0.0; it must be -30 to 30, not 0"),
        (OGDEN.replace("alpha2 = -2", ""), "give alpha2 as well"),
        (OGDEN.replace("alpha1 = 2", 'alpha1 = "2 MPa"'), "ball.toml:11: alpha1 of core is '2 MPa'; it must be"),
        (OGDEN.replace('mu1 = "8 MPa"\nalpha1 = 2\n', ""), "give mu1, alpha1 as well"),
    ],
)
def test_a_mistake_in_ogdens_constants_is_named(tmp_path, new, message):
    with pytest.raises(FileError, match=re.escape(message)):
        case(write_case(tmp_path, old=RIVLIN, new=new))


MISTAKES = [
    ('thickness = "1.8 mm"', 'thickness = "0 mm"', "ball.toml:17: thickness of cover is '0 mm'"),
    ('thickness = "1.8 mm"', 'thickness = "20 mm"', "less than 80% of the radius"),
    ("poisson = 0.49", "poisson = 0.5", "ball.toml:12: poisson of core is 0.5; it must be -0.9 to 0.4999"),
    ("poisson = 0.40", "poisson = 0.5", "ball.toml:20: poisson of cover is 0.5; it must be -0.9 to 0.4999"),
    ('youngs = "350 MPa"', 'youngs = "-350 MPa"', "ball.toml:19: youngs of cover is '-350 MPa'; it must be above 0"),
    ('c10 = "4 MPa"', 'c10 = "-4 MPa"', "ball.toml:10: c10 of core is '-4 MPa'; it must be zero or above"),
    ('c10 = "4 MPa"', 'c10 = "4 mm"', "ball.toml:10: c10 of core is '4 mm'; it must be in Pa"),
    ('c10 = "4 MPa"\n', "", "give c10 as well"),
    (
        'youngs = "350 MPa"',
        "shear = 0",
        "ball.toml:19: shear of cover is '0 MPa'; it must be such that the shear modulus",
    ),
    ('youngs = "350 MPa"', "youngs = 1e-9", "ball.toml:19: youngs of cover is '1e-15 MPa'; it must be such that"),
    ('mass = "46 g"', 'mass = "46 mm"', "ball.toml:3: mass"),
    ('mass = "46 g"', 'mass = "8 g"', "ball.toml:3: mass is '8 g'; it must be such that the core"),
    ('law = "linear"', 'law = "lineer"', "did you mean linear?"),
    ("cube = 4", "cube = 5", "ball.toml:4: cube is 5; it must be an even whole number"),
    ("cube = 4", "kube = 4", "ball.toml:4: unknown key 'kube' (did you mean cube?)"),
    ('speed = "35 m/s"', 'sped = "35 m/s"', "case.toml:9: unknown key 'sped' (did you mean speed?)"),
    ('speed = "35 m/s"', 'speed = "35 deg"', "case.toml:9: delivery.speed is '35 deg'; it must be in m/s"),
    ('speed = "35 m/s"', 'speed = "0 m/s"', "case.toml:9: speed is '0 m/s'; it must be 0.01 to 150 m/s"),
    ('angle = "11.5 deg"', 'angle = "91 deg"', "case.toml:10: angle is '91 deg'; it must be 0 to 80 deg"),
    ('kind = "plane"', 'kind = "wall"', "case.toml:6: unknown kind of head 'wall'; it must be one of plane, rigid"),
    ('kind = "plane"', 'kind = "plane"\nclub = "driver"', "case.toml:7: club is 'driver'; leave it out for a plane"),
    ("friction = 0.3", "friction = -1", "case.toml:3: friction is -1.0; it must be 0 to 10"),
    ('ball = "./ball.toml"', 'ball = "papr"', "case.toml:2: unknown ball 'papr'"),
    ('ball = "./ball.toml"', 'ball = "./none.toml"', "none.toml: cannot be read"),
    (
        "[run]",
        "[run]\nbulk_viscosity = -1",
        "case.toml:13: run.bulk_viscosity is -1.0; it must be 0 to 1; 0.06 is usual",
    ),
    (
        "[run]",
        '[run]\ncontact = "glue"',
        "case.toml:13: unknown run.contact 'glue'; it must be one of penalty, augmented-lagrange",
    ),
    ("[run]", "[run]\nsafety = 2", "case.toml:13: run.safety is 2.0; it must be 0.05 to 1"),
    ("[run]", "[run]\nuntil_separation = 3", "case.toml:13: run.until_separation is 3; it must be true or false"),
    ('duration = "100 us"', 'duration = "100 mm"', "case.toml:13: run.duration"),
]


@pytest.mark.parametrize(("old", "new", "message"), MISTAKES)
def test_an_error_names_file_line_and_what_is_allowed(tmp_path, old, new, message):
    path = write_case(tmp_path, old=old, new=new)
    with pytest.raises(FileError, match=re.escape(message)) as caught:
        case(path)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("make", "error", "words"),
    [
        (lambda: drive_case().replace(path="-80 deg", face="60 deg"), InputError, "moves away from the ball"),
        (lambda: drive_case().replace(toe="200 mm"), InputError, "outside the face"),
        (lambda: drive_case().replace(lofft="10 deg"), UnknownNameError, "loft"),
        (lambda: Case(name="x", ball=coarse(), head="rigid", delivery={"speed": 35.0}), InputError, "club is missing"),
        (lambda: fem.Settings(safety=1.2), InputError, "the stable step"),
        (lambda: sweeps.sweep(throw_case(), **GRID), UnknownNameError, "loft"),
        (lambda: sweeps.sweep(drive_case(), **GRID, workers=0), InputError, "workers"),
    ],
)
def test_impossible_cases_settings_and_sweeps_are_refused_before_a_run(make, error, words):
    with pytest.raises(error, match=words):
        make()


SCALARS = st.one_of(
    st.floats(allow_nan=True), st.integers(-3, 20), st.booleans(), st.none(), st.text(max_size=8),
    st.sampled_from(["4 MPa", "-1 GPa", "0 mm", "46 g", "1e9 m/s", "35 m/s", "linear", "ogden", "5 %"]),
    st.lists(st.integers(), max_size=2), st.dictionaries(st.text(max_size=3), st.integers(), max_size=1),
)  # fmt: skip


@settings(max_examples=60)
@given(line=st.integers(0, 33), value=SCALARS, cut=st.booleans())
def test_any_line_of_ball_or_case_may_be_anything(tmp_path, line, value, cut):
    path = write_case(tmp_path, duration=20)
    texts = {file: file.read_text().splitlines() for file in (tmp_path / "ball.toml", path)}
    file, line = [(file, at) for file, lines in texts.items() for at in range(len(lines))][line]
    key = texts[file][line].partition("=")[0]
    texts[file][line] = key if cut else f"{key}= {_toml(value)}"
    file.write_text("\n".join(texts[file]), encoding="utf-8", errors="replace")
    try:
        result = case(path)
    except ClubfaceError as error:
        message = str(error)
    else:
        if result.ball.elements < 2000:
            assert result.replace(settings={"duration": 20e-6}).run().steps >= 1
        return
    # One line that names the file.
    assert re.search(r"(ball|case)\.toml", message)
    assert len(message.splitlines()) == 1


def _toml(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, dict):
        return "{" + ", ".join(f"k{each} = {each}" for each in value.values()) + "}"
    return "''" if value is None else repr(value)


GRID = {"speeds": [30.0, 40.0], "lofts": [0.15, 0.2]}


def test_a_sweep_gives_a_row_a_run_in_order_and_is_resumed(tmp_path):
    path = tmp_path / "sweep.csv"
    base = drive_case(until_separation=True)
    seen = []
    rows = sweeps.sweep(base, **GRID, output=path, progress=lambda done, whole: seen.append((done, whole)))
    assert [(row["speed_mps"], row["loft_deg"]) for row in rows] == [
        (speed, pytest.approx(loft * 57.29577951308232)) for speed in (30.0, 40.0) for loft in (0.15, 0.2)
    ]
    assert seen == [(1, 4), (2, 4), (3, 4), (4, 4)]
    assert [tuple(row) for row in rows] == [sweeps.COLUMNS] * 4
    text = path.read_text()
    # Cut off in the middle of a line: that run is repeated, the others are not.
    path.write_text(text[: text.rindex(",", 0, len(text) - 20)])
    again = []
    assert sweeps.sweep(base, **GRID, output=path, progress=lambda *at: again.append(at)) != []
    assert again == [(3, 4), (4, 4)]
    kept = sweeps.sweep(base, **GRID, output=path)
    assert kept == rows
    assert path.read_text() == text
    with pytest.raises(FileError, match="not the table of this case"):
        sweeps.sweep(base.replace(friction=0.1), **GRID, output=path)
    with pytest.raises(FileError, match="not the table of this case"):
        sweeps.sweep(base.replace(toe="5 mm"), **GRID, output=path)
    assert len(sweeps.sweep(base.replace(speed="50 m/s", loft="3 deg"), **GRID, output=path)) == 4  # what is swept
    path.write_text("\n".join([*text.splitlines()[:2], "1,2,3", ""]))
    with pytest.raises(FileError, match=r"sweep.csv:3: "):
        sweeps.sweep(base, **GRID, output=path)


@pytest.mark.parametrize(
    "text", ["", "30:60", "30:60:0", "30:60:-5", "a:b:c", "60:30:5", "1e9:inf:1", "nan", "30:31:1e-9"]
)
def test_a_grid_that_makes_no_sense_is_refused(text):
    with pytest.raises(InputError, match="--speed"):
        sweeps.grid(text, "speed", "--speed")


def test_a_grid_holds_both_ends():
    assert sweeps.grid("30:60:15", "speed", "--speed") == [30.0, 45.0, 60.0]
    assert sweeps.grid("8,9.5", "angle", "--loft") == pytest.approx([0.13962634, 0.16580628])


def test_a_ball_as_text_of_one_piece_needs_a_mass_or_a_density(tmp_path):
    path = tmp_path / "one.toml"
    text = BALL[: BALL.index('[[pieces]]\nname = "cover"')].replace('mass = "46 g"\n', "")
    path.write_text(text)
    with pytest.raises(FileError, match="mass is missing; give it, or the density of the core"):
        fem.ball(path)
    path.write_text(text + 'density = "1100 kg/m3"\n')
    assert fem.ball(path).properties()["core_density"] == 1100.0


@pytest.mark.parametrize("speed", [["35 m/s"], [35.0, 40.0]])
def test_several_values_are_for_a_sweep(speed):
    with pytest.raises(InputError, match=r"speed is .*one value"):
        drive_case().replace(speed=speed).run()


def test_an_object_that_is_no_settings_or_piece_is_refused():
    wrong: Any = {"duration": 1e-3}
    with pytest.raises(InputError, match=r"it must be a clubface\.fem\.Settings"):
        fem.reference(settings=wrong)
    made = coarse()
    with pytest.raises(InputError, match="Pieces, from the inside out"):
        replace(made, pieces="abc")
    with pytest.raises(InputError, match="each with a name of its own"):
        replace(made, pieces=(made.pieces[0], replace(made.pieces[1], name="core")))


def test_lofts_of_a_sweep_are_written_as_they_were_given(tmp_path):
    base = drive_case(duration=20e-6)
    (row,) = sweeps.sweep(base, speeds=[40.0], lofts=[math.radians(11.0)], output=tmp_path / "sweep.csv")
    assert row["loft_deg"] == 11.0
    # Found again in the table, also with the rounding of earlier tables: nothing is run.
    path = tmp_path / "sweep.csv"
    path.write_text(path.read_text().replace(",11.0,", ",10.999999999999998,"))
    ran = []
    (again,) = sweeps.sweep(
        base, speeds=[40.0], lofts=[math.radians(11.0)], output=path, progress=lambda *at: ran.append(at)
    )
    assert (again["steps"], again["loft_deg"], ran) == (row["steps"], pytest.approx(11.0, abs=1e-9), [(1, 1)])


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"duration": 0.5e-6}, "duration is '0.5 us'; it must be 1 us to 0.1 s"),
        ({"duration": 0.11}, "duration is '110000 us'"),
        ({"interval": 0.005e-6}, "interval is '0.005 us'; it must be 0.01 us to the duration"),
        ({"duration": 100e-6, "interval": 101e-6}, "interval is '101 us'"),
        ({"safety": 0.04}, "safety is 0.04; it must be 0.05 to 1"),
        ({"bulk_viscosity": 1.1}, "bulk_viscosity is 1.1; it must be 0 to 1"),
        ({"bulk_viscosity": -0.1}, "bulk_viscosity is -0.1"),
        ({"frames": 10_001}, "frames is 10001"), ({"threads": 1025}, "threads is 1025"),
    ],
)  # fmt: skip
def test_settings_beyond_their_limits_are_shown_in_the_unit_of_the_limit(given, message):
    with pytest.raises(InputError) as caught:
        fem.Settings(**given)
    assert str(caught.value).startswith(message)


def test_settings_at_their_limits_are_kept_as_given():
    for values in (
        {"duration": 1e-6, "interval": 1e-8, "safety": 0.05, "bulk_viscosity": 0.0, "frames": 0, "threads": 0},
        {"duration": 0.1, "interval": 0.1, "safety": 1.0, "bulk_viscosity": 1.0, "frames": 10_000, "threads": 1024},
    ):
        made = fem.Settings(**values)
        assert {name: getattr(made, name) for name in values} == values
