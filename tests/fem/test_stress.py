"""The largest stress of a head under a blow: beside runs of metal that yields, and where it is small."""

from dataclasses import replace

import pytest

from clubface import fem
from clubface.fem import stress
from fem_runs import coarse, coarse_head

BLOW = {"speed": "50 m/s", "which": coarse("modern")}


def with_face(head, **metal):
    """The head with a face of another metal."""
    parts = (replace(part, metal=replace(part.metal, **metal)) if part.face else part for part in head.parts)
    return replace(head, parts=tuple(parts))


def face_of(head, **blow):
    [found] = [part for part in stress.peak_stress(head, **{**BLOW, **blow}) if part.part == "face"]
    return found


def test_a_face_yields_where_its_margin_is_negative_and_not_where_it_is_positive():
    head = coarse_head()
    elastic = face_of(head)
    assert elastic.yield_stress is elastic.margin is None
    for share, yields in ((1.05, False), (0.95, True)):
        # Points on both surfaces, where an elastic wall has its largest stress.
        metal = with_face(head, yield_stress=share * elastic.stress, points=7, rule="lobatto")
        # The same elastic stress, whatever would yield: points instead of resultants change rounding alone, 2% for the
        # single precision of fields and peaks between two records.
        found = face_of(metal)
        assert found.stress == pytest.approx(elastic.stress, rel=0.02)
        assert found.margin == pytest.approx(share - 1.0, abs=0.02)
        assert (found.margin < 0.0) is yields
        ran = fem.strike(metal, which=BLOW["which"], speed=BLOW["speed"])
        assert bool(ran.energy["plastic"][-1] > 0.0) is yields


def test_a_thick_face_and_a_slow_blow_have_less_stress():
    head = coarse_head()
    face = head.parts[0].elements
    thick = head.thickness.copy()
    thick[:face] *= 1.5
    found = face_of(head)
    assert face_of(replace(head, thickness=thick)).stress < found.stress
    assert face_of(head, speed="25 m/s").stress < 0.7 * found.stress
    # Where the ball is, and while it is there.
    assert abs(found.place[1]) < 0.01
    assert abs(found.place[2]) < 0.01
    assert 1e-4 < found.time < 4e-4
    assert face_of(head, toe="20 mm").place[2] > 0.01


def test_the_command_shows_stress_beside_yield(clubface_, tmp_path):
    from clubface.support.shipped import builtin_path

    text = builtin_path("head", "7-iron", "fem_heads").read_text().replace("[32, 20, 2]", "[16, 10, 2]")
    file = tmp_path / "iron.toml"
    file.write_text(text + '\n[metal]\nyoungs = "200 GPa"\npoisson = 0.3\ndensity = "7800 kg/m3"\nyield = "300 MPa"\n')
    run = ("fem", "head", str(file), "--blow", "38 m/s", "--ball", "distance")
    [part] = clubface_(*run, "--json").json["stress"]
    [expected] = stress.peak_stress(file, speed="38 m/s", which="distance")
    assert part["stress_pa"] == expected.stress
    assert part["margin"] == pytest.approx(300e6 / expected.stress - 1.0)
    shown = clubface_(*run).out
    assert "yields at" in shown
    assert "300" in shown
    assert "--blow is 'fast'" in clubface_("fem", "head", str(file), "--blow", "fast").err
