"""Stress and strain of elements: shapes, axes, invariants, and what ParaView gets."""

import numpy as np
import pytest
from hypothesis import given, strategies as st

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
    result = coarse_drive()
    assert result.fields is None
    assert result.head_fields is None
    assert throw_case(fields=True, duration="20 us").run().fields is None, "without shapes there is no time to keep"


def test_invariants_of_known_states():
    assert fields([5.0, 0, 0, 0, 0, 0]).von_mises == pytest.approx(5.0)
    assert fields([0, 0, 0, 0, 2.0, 0]).von_mises == pytest.approx(2.0 * np.sqrt(3.0))
    assert fields([-3.0, -3.0, -3.0, 0, 0, 0]).von_mises == pytest.approx(0.0)
    assert fields([-3.0, -6.0, 0.0, 1.0, 0, 0]).pressure == pytest.approx(3.0)


numbers = st.floats(-1e3, 1e3)


@given(tensor=st.tuples(*[numbers] * 6), angles=st.tuples(*[st.floats(-3.0, 3.0)] * 3))
def test_tensors_turn(tensor, angles):
    from scipy.spatial.transform import Rotation

    rotation = Rotation.from_euler("xyz", angles).as_matrix()
    result = turned(np.array(tensor), rotation)
    # Rounding of numbers up to a thousand.
    assert whole(result) == pytest.approx(rotation @ whole(tensor) @ rotation.T, abs=1e-9)
    assert fields(result).von_mises == pytest.approx(fields(tensor).von_mises, abs=1e-5)


def test_a_ball_on_a_plane_is_pressed_where_it_touches():
    result = throw_case(frames=5, fields=True, duration="400 us").run()
    fields = result.fields
    assert fields is not None
    assert fields.stress.shape == fields.strain.shape == (len(result.frames), result.ball.elements, 6)
    assert not fields.plastic_strain.any()
    # Before first touch the ball is free of stress: rounding of moduli of a GPa.
    assert abs(fields.stress[0]).max() < 1.0
    frame = int(np.argmax(np.interp(result.frame_times, result.contact["time"], result.contact["normal"])))
    places = result.frames[frame]
    from clubface import _core

    mesh = _core.fem_mesh(result.ball.values())
    middles = places[mesh["elements"].astype(int)].mean(axis=1)
    # The most squeezed element is one of the four at the pole, and squeezed along the plane's normal, x.
    most = int(np.argmax(fields.pressure[frame]))
    heights = middles @ result.axes[0]
    assert np.argsort(heights)[:8].tolist().count(most) == 1
    assert fields.stress[frame, most, 0] < 0.0
    # The soft core gives way more than the cover: a third of the ball's depth is gone.
    assert fields.strain[frame, :, 0].min() < -0.2


def test_paraview_gets_stress_in_the_axes_of_the_world(tmp_path):
    meshlane = pytest.importorskip("meshlane")
    result = shells_case(frames=4, fields=True, duration="300 us").run()
    path = files.write_series(result, tmp_path, "fields")[2]
    cells = meshlane.read(path).cell_data
    for body, fields in enumerate((result.fields, result.head_fields)):
        assert fields is not None
        stress = fields.stress[2] if body == 0 else fields.stress[2, :, 0]
        strain = fields.strain[2] if body == 0 else fields.strain[2, :, 0]
        for element in (0, 7, stress.shape[0] - 1):
            for name, tensor in (("stress", stress), ("strain", strain)):
                exact = result.attitude @ whole(tensor[element]) @ result.attitude.T
                read = cells[name][body][element]
                for component, place in PARAVIEW.items():
                    i, j = ("xyz".index(axis) for axis in component)
                    # Single precision, of the largest component.
                    assert read[place] == pytest.approx(exact[i, j], abs=1e-5 * abs(exact).max())
        mises = fields.von_mises[2]
        outer, inner = (mises, mises) if body == 0 else mises.T
        assert cells["von_mises"][body] == pytest.approx(outer, rel=1e-5)
        assert cells["von_mises_inner"][body] == pytest.approx(inner, rel=1e-5)
    # Bending: the two sides of the face differ.
    assert not np.allclose(cells["von_mises"][1], cells["von_mises_inner"][1], rtol=0.1)
