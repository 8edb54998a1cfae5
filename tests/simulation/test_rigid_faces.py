"""A comparison of shots names those whose face is rigid where that of others gives."""

import clubface
from clubface.design.comparison import compare
from clubface.simulation.launch import rigid_faces
from clubface.simulation.shot_result import shot_result
from fem_runs import coarse, coarse_head

SHOT = {"speed": "45 m/s", "loft": "12 deg"}


def rigid():
    return clubface.club("driver").replace(name="own", characteristic_time="0 s")


def names(launches):
    return [name for each in rigid_faces(launches) for name in each.data["names"]]


def test_a_rigid_face_is_named_where_another_gives():
    given, none = clubface.impact("driver", SHOT), clubface.impact(rigid(), SHOT)
    assert names({"driver": given, "own": none}) == ["own"]
    assert names({"driver": given, "other": given}) == []
    assert names({"own": none, "other": none}) == []
    # Parameters fitted to drives include the face of their driver.
    rings = clubface.impact(rigid(), SHOT, model="rings")
    launches = {"response": none, "rings": rings}
    assert names(launches) == ["response"]
    shown = shot_result(launches, {name: clubface.fly(each) for name, each in launches.items()})
    assert [each.data["names"] for each in shown.assumptions if each.code == "rigid-faces"] == [["response"]]


def test_the_face_of_a_mesh_gives():
    mesh = clubface.impact(coarse_head().as_club(), SHOT, model="fem", ball=coarse("modern"))
    assert names({"fem": mesh, "own": clubface.impact(rigid(), SHOT)}) == ["own"]


def test_a_comparison_with_a_rigid_face_says_so_and_why_it_is_not_split():
    for first, last in (("driver", rigid()), (rigid(), "driver")):
        alternatives = {"first": {"club": first, "delivery": SHOT}, "last": {"club": last, "delivery": SHOT}}
        result = compare(alternatives).to_result()
        [note] = [each for each in result.assumptions if each.code == "rigid-faces"]
        assert note.data["names"] == ["last" if first == "driver" else "first"]
        [reason] = [each.data["reason"] for each in result.notes if each.code == "comparison-not-split"]
        assert "250 µs" in reason or "250 us" in reason
        assert "must be" not in reason
