"""Stress and strain of elements: shapes, axes, invariants, and what ParaView gets."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from clubface.fem import files
from clubface.fem.result import ElementFields, turned
from fem_runs import coarse_drive, shells_case, throw_case

PARAVIEW = {"xx": 0, "yy": 1, "zz": 2, "xy": 3, "yz": 4, "xz": 5}


def whole(tensor):
    xx, yy, zz, xy, xz, yz = tensor
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def fields(stress):
    array = np.array(stress, dtype=float)[None, None]
    return ElementFields(array, array, np.zeros((1, 1)))


def test_fields_are_kept_only_when_asked_for():
    found = coarse_drive()
    assert found.fields is None
    assert found.head_fields is None
    assert throw_case(fields=True, duration="20 us").run().fields is None, "without shapes there is no time to keep"


def test_invariants_of_known_states():
    assert fields([5.0, 0, 0, 0, 0, 0]).von_mises == pytest.approx(5.0)
    assert fields([0, 0, 0, 0, 2.0, 0]).von_mises == pytest.approx(2.0 * np.sqrt(3.0))
    assert fields([-3.0, -3.0, -3.0, 0, 0, 0]).von_mises == pytest.approx(0.0)
    assert fields([-3.0, -6.0, 0.0, 1.0, 0, 0]).pressure == pytest.approx(3.0)


numbers = st.floats(-1e3, 1e3)


@settings(deadline=None)
@given(tensor=st.tuples(*[numbers] * 6), angles=st.tuples(*[st.floats(-3.0, 3.0)] * 3))
def test_tensors_turn(tensor, angles):
    from scipy.spatial.transform import Rotation

    rotation = Rotation.from_euler("xyz", angles).as_matrix()
    found = turned(np.array(tensor), rotation)
    # Rounding of numbers up to a thousand.
    assert whole(found) == pytest.approx(rotation @ whole(tensor) @ rotation.T, abs=1e-9)
    assert fields(found).von_mises == pytest.approx(fields(tensor).von_mises, abs=1e-5)


def test_a_ball_on_a_plane_is_pressed_where_it_touches():
    found = throw_case(frames=5, fields=True, duration="400 us").run()
    told = found.fields
    assert told is not None
    assert told.stress.shape == told.strain.shape == (len(found.frames), found.ball.elements, 6)
    assert not told.plastic_strain.any()
    # Before first touch the ball is free of stress: rounding of moduli of a GPa.
    assert abs(told.stress[0]).max() < 1.0
    frame = int(np.argmax(np.interp(found.frame_times, found.contact["time"], found.contact["normal"])))
    places = found.frames[frame]
    from clubface import _core

    mesh = _core.fem_mesh(found.ball.values())
    middles = places[mesh["elements"].astype(int)].mean(axis=1)
    # The most squeezed element is one of the four at the pole, and squeezed along the plane's normal, x.
    most = int(np.argmax(told.pressure[frame]))
    heights = middles @ found.axes[0]
    assert np.argsort(heights)[:8].tolist().count(most) == 1
    assert told.stress[frame, most, 0] < 0.0
    # The soft core gives way more than the cover: a third of the ball's depth is gone.
    assert told.strain[frame, :, 0].min() < -0.2


def test_paraview_gets_stress_in_the_axes_of_the_world(tmp_path):
    meshlane = pytest.importorskip("meshlane")
    found = shells_case(frames=4, fields=True, duration="300 us").run()
    path = files.write_series(found, tmp_path, "fields")[2]
    cells = meshlane.read(path).cell_data
    for body, told in enumerate((found.fields, found.head_fields)):
        assert told is not None
        stress = told.stress[2] if body == 0 else told.stress[2, :, 0]
        strain = told.strain[2] if body == 0 else told.strain[2, :, 0]
        for element in (0, 7, stress.shape[0] - 1):
            for name, tensor in (("stress", stress), ("strain", strain)):
                exact = found.attitude @ whole(tensor[element]) @ found.attitude.T
                read = cells[name][body][element]
                for component, place in PARAVIEW.items():
                    i, j = ("xyz".index(axis) for axis in component)
                    # Single precision, of the largest component.
                    assert read[place] == pytest.approx(exact[i, j], abs=1e-5 * abs(exact).max())
        mises = told.von_mises[2]
        outer, inner = (mises, mises) if body == 0 else mises.T
        assert cells["von_mises"][body] == pytest.approx(outer, rel=1e-5)
        assert cells["von_mises_inner"][body] == pytest.approx(inner, rel=1e-5)
    # Bending: the two sides of the face differ.
    assert not np.allclose(cells["von_mises"][1], cells["von_mises_inner"][1], rtol=0.1)
