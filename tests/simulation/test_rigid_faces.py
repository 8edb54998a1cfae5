"""Which faces are rigid where others give: said of shots side by side."""

import clubface
from clubface.design.comparison import compare
from clubface.simulation.launch import rigid_faces

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
    assert names({"response": none, "rings": rings}) == ["response"]


def test_a_comparison_with_a_rigid_face_says_so_and_why_it_is_not_split():
    for first, last in (("driver", rigid()), (rigid(), "driver")):
        alternatives = {"first": {"club": first, "delivery": SHOT}, "last": {"club": last, "delivery": SHOT}}
        result = compare(alternatives).to_result()
        [note] = [each for each in result.assumptions if each.code == "rigid-faces"]
        assert note.data["names"] == ["last" if first == "driver" else "first"]
        [reason] = [each.data["reason"] for each in result.notes if each.code == "comparison-not-split"]
        assert "250 µs" in reason or "250 us" in reason
        assert "must be" not in reason
