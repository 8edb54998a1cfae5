"""Heads from one's own meshes: what is read from them, and what is refused."""

import re

import numpy as np
import pytest

from clubface import fem
from clubface.errors import ClubfaceError, FileError
from clubface.fem.heads import MeshHead
from fem_meshes import FACE, GROUPS, HEAD, write_mesh
from fem_runs import coarse, coarse_head


@pytest.mark.parametrize("name", ["head.msh", "head.inp"])
def test_a_custom_mesh_is_read_with_its_groups(tmp_path, write, name):
    write_mesh(tmp_path, name)
    path = write(HEAD.replace("head.msh", name), "own.toml")
    head, design = fem.head(path), coarse_head()
    assert [part.name for part in head.parts] == ["face", "crown", "sole", "skirt"]
    assert [part.elements for part in head.parts] == [part.elements for part in design.parts]
    corners = head.nodes[head.quads] - design.nodes[design.quads]
    assert np.abs(corners).max() < 1e-9
    path.write_text(path.read_text().replace("loft =", 'face_centre = ["1 mm", 1, 0]\nloft ='))
    assert np.abs(fem.head(path).nodes[head.quads] + [1e-3, 1e-3, 0.0] - head.nodes[head.quads]).max() < 1e-12
    assert set(head.thickness[: head.parts[0].elements]) == {2.8e-3}
    a, b, c, d = (head.nodes[head.quads[:, corner]] for corner in range(4))
    areas = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)
    assert head.club.mass == pytest.approx(4430.0 * areas @ head.thickness + 0.06, rel=1e-9)
    # The weight stands low and behind: the CG is below and behind that of the walls alone.
    lighter = fem.head(MeshHead(name="x", file=tmp_path / name, groups=GROUPS, **FACE))
    assert head.club.cg_x > lighter.club.cg_x
    assert head.club.cg_y > lighter.club.cg_y
    result = fem.strike(head, speed="40 m/s", ball=coarse(), settings=fem.Settings(duration=60e-6))
    assert result.peak_force > 1000.0


WEIGHT = '[[masses]]\nname = "weight"\nx = 0.0\ny = 0.0\nz = 0.0\nmass = "1 g"\n'

MISTAKES = [
    ('unit = "mm"', 'unit = "m"', "the head measures"),
    ('unit = "mm"', 'unit = "kg"', "unit"),
    ('file = "head.msh"', 'file = "none.msh"', "there is no such file"),
    ('file = "head.msh"', 'file = "own.toml"', "this mesh cannot be read"),
    ('name = "sole"', 'name = "soul"', "unknown group of the mesh 'sole' (did you mean soul?)"),
    (
        'thickness = "1.4 mm"',
        'thickness = "0 mm"',
        "own.toml:25: thickness of skirt is '0 mm'; it must be 0.2 to 20 mm",
    ),
    (
        'youngs = "110 GPa"',
        'youngs = "-110 GPa"',
        "own.toml:21: youngs of sole is '-110 GPa'; it must be 0.1 to 1000 GPa",
    ),
    ('youngs = "110 GPa"', "poisson = 0.5", "own.toml:21: poisson of sole is 0.5; it must be above -1 and below 0.5"),
    ("face = true", "", "at least one with face = true"),
    ('kind = "mesh"', 'kind = "blade"', "own.toml:2: unknown kind 'blade'; it must be one of driver, iron, mesh"),
    ('loft = "11.5 deg"', 'loft = "115 deg"', "own.toml:5: loft is '115 deg'; it must be 0 to 75 deg"),
    ('mass = "60 g"', 'mass = "60 mm"', "weight"),
    (
        'x = "-40 mm"',
        "x = -40",
        "own.toml:29: x of mass weight is '-40000 mm'; it must be within 300 mm of the face centre",
    ),
    (
        "[[masses]]",
        WEIGHT + "[[masses]]",
        "own.toml:34: name of mass weight is 'weight'; it must be unique",
    ),
    ("[[masses]]", '[[groups]]\nname = "hosel"\nthickness = "2 mm"\n[[masses]]', "belongs to the group 'hosel'"),
    ('unit = "mm"', 'unit = "mm"\nface_centre = [50, 0, 0]', "the nearest node of the face is"),
    ('unit = "mm"', 'unit = "mm"\nface_centre = [0, 0]', "face_centre is [0, 0]; it must be three lengths"),
    ('unit = "mm"', 'unit = "mm"\nface_centre = ["0 kg", 0, 0]', "face_centre is '0 kg'; it must be in m"),
    ('unit = "mm"', 'unit = "mm"\nface_centre = [0, 0, true]', "face_centre is True; it must be three lengths"),
]


@pytest.mark.parametrize(("old", "new", "message"), MISTAKES)
def test_a_mistake_in_a_head_is_named(tmp_path, old, new, message):
    write_mesh(tmp_path)
    path = tmp_path / "own.toml"
    assert old in HEAD
    path.write_text(HEAD.replace(old, new))
    with pytest.raises(ClubfaceError, match=re.escape(message)) as caught:
        _ = fem.head(path).club
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    "change",
    [
        lambda quad: [quad[each] for each in (0, 2, 1, 3)],
        lambda quad: [*quad[:3], quad[0]],
    ],
)
def test_a_mesh_with_bad_elements_is_refused(tmp_path, change):
    path = write_mesh(tmp_path, change=change)
    with pytest.raises(FileError, match=r"head.msh: element 1 is inverted or degenerate"):
        _ = fem.head(MeshHead(name="bad", file=path, groups=GROUPS, **FACE)).club


def test_a_section_of_the_wrong_length_is_named_with_its_line(tmp_path):
    lines = write_mesh(tmp_path).read_text().splitlines()
    (tmp_path / "own.toml").write_text(HEAD)
    for section in ("$Nodes", "$Elements"):
        at = lines.index(section) + 1
        result = int(lines[at])
        for count in (result - 1, result + 1):
            changed = [*lines[:at], str(count), *lines[at + 1 :]]
            (tmp_path / "head.msh").write_text("\n".join(changed) + "\n")
            with pytest.raises(FileError, match=rf"head\.msh:{at + 1}: .* {count} lines, .* {result}$"):
                fem.head(tmp_path / "own.toml")
