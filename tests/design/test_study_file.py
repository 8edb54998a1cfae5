"""A study file is read strictly: what is wrong is told with file, line and what to write instead."""

import math

import pytest

from clubface import ball, club
from clubface.design.golfer import golfer, to_toml
from clubface.design.optimisation.study import from_text, read
from clubface.errors import ClubfaceError

GOOD = """title = "t"
club = "driver"
golfer = "bogey-driver"
objective = "strokes"

[hole]
length = "400 yd"

[variables]
loft = ["8 deg", "14 deg"]
cg_x = ["38 mm", "44 mm"]

[head]
size = ["115 mm", "62 mm", "124 mm"]
centre = ["-55 mm", "2 mm", "3 mm"]
discretionary_mass = "30 g"

[limits]
carry = ["150 yd", "none"]
"""


def test_values_are_read_with_their_units():
    parsed = from_text(GOOD + '[air]\naltitude = "1600 m"\n[mass]\nspeed_exponent = 0.2\n[rules]\nconform = false\n')
    assert parsed.bounds["loft"] == pytest.approx((math.radians(8.0), math.radians(14.0)))
    assert parsed.limits["carry"] == (pytest.approx(137.16), math.inf)
    assert parsed.head.volume.size == pytest.approx((0.115, 0.062, 0.124))
    assert parsed.setting.speed_exponent == 0.2
    assert parsed.setting.air == {"altitude": "1600 m"}
    assert not parsed.conform
    assert parsed.hole.length == pytest.approx(365.76)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('golfer = "bogey-driver"\n', "", "golfer"),
        ('"strokes"', '"distance"', "objective 'distance'"),
        ('"strokes"', '["carry", "side_spread", "ellipse"]', "objective is"),
        ('["8 deg", "14 deg"]', '"10 deg"', "least and greatest"),
        ('["8 deg", "14 deg"]', '["14 deg", "8 deg"]', "least and greatest"),
        ('["8 deg", "14 deg"]', '["8 mm", "14 mm"]', "loft"),
        ("cg_x =", "cg_w =", "did you mean"),
        ("carry =", "carrry =", "did you mean"),
        ("carry =", "roll =", "does not change"),
        ("carry =", 'roll = ["none", "1 m"]\ncarry =', "limits.roll is given; leave it out"),
        ('["150 yd", "none"]', '["none", "none"]', "least and greatest"),
        ('["8 deg", "14 deg"]', "[8, 14]", r"variables\.loft is '458\.\d+ deg'; it must be 0 to 75 deg"),
        ('["8 deg", "14 deg"]', '["-1e9 deg", "14 deg"]', r"variables\.loft .* 0 to 75 deg"),
        ('["38 mm", "44 mm"]', '["38 mm", "44 mm"]\nbulge = ["1 mm", "300 mm"]', r"variables\.bulge: .* larger radii"),
        ('["38 mm", "44 mm"]', '["38 mm", "44 mm"]\nlie = ["-91 deg", "1 deg"]', r"variables\.lie .* -90 to 90 deg"),
        ('"30 g"', '"30 g"\nvolume = "0 cm3"', "head.volume is '0 cm3'; it must be above 0"),
        ('title = "t"', 'title = "t"\npoints = 5', "points is 5; leave it out"),
        ("[hole]", "[air]\nhumidity = 2\n[hole]", "humidity is '2'; it must be from 0 to 1$"),
        ("[hole]", '[air]\ntemperature = "-300 degC"\n[hole]', "temperature is '-26.85 K'; it must be from 233"),
        ('"bogey-driver"', '"nobody"', "nobody"),
        ('"driver"\n', '"no-driver"\n', "no-driver"),
        ('"30 g"', '"300 g"', "discretionary_mass"),
        ('"62 mm"', '"-62 mm"', "size"),
        ('title = "t"', 'title = "t"\nshots = 0', "shots"),
        ('title = "t"', 'title = "t"\nmodel = "fem"', "model"),
        ('title = "t"', 'title = "t"\nwind = "5 mph"', "wind"),
        ('["38 mm", "44 mm"]', '["38 mm", "44 mm"]\nmass_distribution = "free"', "under \\[limits\\]"),
        ('["38 mm", "44 mm"]', '["38 mm", "44 mm"]\nmass_distribution = "fixed"', "free"),
        ('["38 mm", "44 mm"]', '["38 mm", "44 mm"]\nbulge = ["0 mm", "300 mm"]', "above 0"),
    ],
)
def test_a_mistake_is_reported_with_what_to_write_instead(old, new, message):
    assert old in GOOD
    with pytest.raises(ClubfaceError, match=message) as error:
        from_text(GOOD.replace(old, new))
    assert "\n" not in str(error.value)


def test_mass_properties_need_a_head():
    text = GOOD[: GOOD.index("[head]")]
    with pytest.raises(ClubfaceError, match="head"):
        from_text(text)


@pytest.mark.parametrize(
    ("line", "message"),
    [('clubs = "driver"', "list of names"), ('clubs = ["driver"]\nballs = []', "list of names"),
     ('clubs = ["driver"]\nfoo = 1', "foo"),
     ('clubs = ["driver"]\n[[fit.setting]]\nname = "a"\nbulge = "1 mm"', "unknown key .bulge."),
     ('clubs = ["driver"]\n[[fit.setting]]\nloft = "1 deg"', "name"),
     ('clubs = ["driver"]\n[[fit.setting]]\nname = "a"\n[[fit.setting]]\nname = "a"\nlie = "1 deg"', "name of a is"),
     ('clubs = ["driver"]\nloft = ["-10 deg", "0 deg"]', "fit.loft is '-0.2 deg'; it must be 0 to 75 deg"),
     ('clubs = ["driver"]\nlie = ["0 deg", "2 deg"]\n[[fit.setting]]\nname = "a"\nlie = "89 deg"', "fit.lie")],
)  # fmt: skip
def test_a_mistake_in_a_fitting_is_reported(line, message):
    with pytest.raises(ClubfaceError, match=message):
        from_text(f'title = "t"\ngolfer = "bogey-driver"\nobjective = "carry"\n[fit]\n{line}\n')


def test_files_of_a_study_are_looked_for_in_its_folder(tmp_path, monkeypatch):
    (tmp_path / "mine.toml").write_text(club("driver").replace(name="mine").to_toml())
    (tmp_path / "distance.toml").write_text(ball("distance").replace(name="soft").to_toml())
    (tmp_path / "me.toml").write_text(to_toml(golfer("bogey-driver").replace(name="me")))
    monkeypatch.chdir("/")
    study = tmp_path / "study.toml"
    study.write_text(
        GOOD.replace('"driver"', '"mine.toml"\nball = "./distance.toml"').replace('"bogey-driver"', '"./me.toml"')
    )
    parsed = read(study)
    assert (parsed.club.name, parsed.golfers[0][0].name, parsed.setting.ball.name) == ("mine", "me", "soft")
    study.write_text(
        'title = "t"\nobjective = "carry"\n[[golfer]]\nname = "me.toml"\n'
        '[fit]\nclubs = ["driver", "mine.toml"]\nballs = ["distance.toml"]\n'
    )
    parsed = read(study)
    assert ([each.name for each in parsed.clubs], parsed.golfers[0][0].name, parsed.balls[0].name) == (
        ["driver", "mine"],
        "me",
        "soft",
    )
