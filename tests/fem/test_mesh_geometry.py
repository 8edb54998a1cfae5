"""Meshes that lie otherwise than their file says, and meshes that are mended on the way."""

import re

import numpy as np
import pytest

from clubface.errors import ClubfaceError, FileError, MeshWarning
from clubface.fem.heads import Group, MeshHead
from fem_meshes import FACE, GROUPS, PARTS, Walls, coarse_walls, write_walls
from fem_runs import coarse_head

pytestmark = [pytest.mark.filterwarnings("ignore::clubface.errors.MeshWarning"), pytest.mark.usefixtures("new_process")]


def read(folder, walls, groups=GROUPS, **changes):
    return MeshHead(name="mine", file=write_walls(folder, walls), groups=groups, **{**FACE, **changes}).mesh()


def placed(matrix):
    walls = coarse_walls()
    return walls._replace(nodes=walls.nodes @ np.array(matrix, float).T)


def turned(axis, angle):
    one, other = ((axis + 1) % 3, (axis + 2) % 3)
    matrix = np.eye(3)
    matrix[one, one] = matrix[other, other] = np.cos(np.radians(angle))
    matrix[other, one] = np.sin(np.radians(angle))
    matrix[one, other] = -matrix[other, one]
    return matrix


@pytest.mark.parametrize(
    ("matrix", "changes", "message"),
    [
        (np.eye(3), {"loft": "14 deg"}, r"loft is '14 deg'.* has 11.5 deg at the face centre"),
        (turned(2, -11.5), {}, r"loft is '11.5 deg'.* has 0 deg at the face centre"),
        (turned(1, 5), {}, r"5 deg to the heel"),
        (np.eye(3), {"bulge": "flat"}, r"bulge is 'flat'.* has 30\d"),
        (np.eye(3), {"roll": "150 mm"}, r"roll is '150 mm'.* has 30\d"),
        (np.eye(3), {"face_centre": (6.0, 0.0, 0.0)}, r"face_centre is '6.0, 0.0, 0.0'.*mm in front of the face"),
        (np.eye(3), {"face_centre": (-6.0, 0.0, 0.0)}, r"face_centre is '-6.0, 0.0, 0.0'.*mm behind the face"),
        (np.eye(3)[[1, 0, 2]], {}, r"x and y are exchanged; write \(y, x, z\)"),
        (np.eye(3)[[0, 2, 1]], {}, r"y and z are exchanged; write \(x, z, y\)"),
        (np.diag([1, -1, 1]), {}, r"y points"),
        (np.diag([-1, 1, -1]), {}, r"x points"),
        (np.eye(3)[[2, 0, 1]], {}, r"exchanged"),
        (np.eye(3) / 25.4, {}, r'unit is .mm.*try unit = "in"'),
        (np.eye(3) / 25.4, {"unit": "cm"}, r'unit is .cm.*try unit = "in"'),
        (np.eye(3) / 10, {"unit": "in"}, r'unit is .in.*try unit = "cm"'),
    ],
)
def test_a_mesh_that_lies_otherwise_than_its_file_is_refused_with_both_values(tmp_path, matrix, changes, message):
    with pytest.raises(ClubfaceError, match=message) as error:
        read(tmp_path, placed(matrix), **changes)
    assert "\n" not in str(error.value)


def test_loft_and_radii_that_are_near_enough_are_taken(tmp_path):
    for changes in ({"loft": "12.2 deg"}, {"bulge": "290 mm"}, {"roll": "330 mm"}):
        read(tmp_path, coarse_walls(), **changes)


def test_bulge_is_the_radius_from_heel_to_toe_and_roll_that_from_sole_to_crown(tmp_path):
    walls = coarse_walls()
    nodes = walls.nodes.copy()
    nodes[:, 0] -= 0.5 * (1 / 190.0 - 1 / 305.0) * nodes[:, 2] ** 2
    read(tmp_path, walls._replace(nodes=nodes), bulge="190 mm")
    with pytest.raises(ClubfaceError, match=r"bulge is '305 mm'.* has 19\d mm"):
        read(tmp_path, walls._replace(nodes=nodes))
    with pytest.raises(ClubfaceError, match=r"roll is '190 mm'.* has 30\d mm"):
        read(tmp_path, walls._replace(nodes=nodes), bulge="190 mm", roll="190 mm")


@pytest.mark.parametrize("count", [8, 9, 12, 16, 24])
def test_triangles_of_any_size_have_the_radii_of_the_surface_that_their_corners_lie_on(tmp_path, count):
    across, up = (
        each.ravel() for each in np.meshgrid(np.linspace(-54, 54, count + 1), np.linspace(-29, 29, count + 1))
    )
    back = (across**2 + up**2) / 610.0
    nodes = np.stack([-back, up, across], axis=1) @ turned(2, 11.5).T
    first = [row * (count + 1) + column for row in range(count) for column in range(count)]
    quads = [[each, each + 1, each + count + 2, each + count + 1] for each in first]
    cap = Walls(nodes, {"face": quads})
    for walls in (cap, cap.triangles()):
        read(tmp_path, walls, GROUPS[:1])
        # A degree at 20 mm is a curvature of 0.87/m: 305 mm is not 225 mm.
        with pytest.raises(ClubfaceError, match=r"bulge is '225 mm'.* has 30[3-7] mm"):
            read(tmp_path, walls, GROUPS[:1], bulge="225 mm")


def test_a_mesh_of_a_left_handed_head_is_refused_where_names_of_parts_show_it(tmp_path):
    hosel = {"hosel": ("-12 mm", "12 mm", "40 mm", "16 g")}
    with pytest.raises(ClubfaceError, match=r"z must point from heel to toe: 'hosel' lies .* left-handed"):
        read(tmp_path, coarse_walls(), masses=hosel)
    read(tmp_path, coarse_walls(), masses={"hosel": ("-12 mm", "12 mm", "-40 mm", "16 g")})
    for side, z in (("heel", "-30 mm"), ("toe", "30 mm")):
        read(tmp_path, coarse_walls(), masses={f"{side} weight": ("-40 mm", "-10 mm", z, "9 g")})
        other = z.removeprefix("-") if z.startswith("-") else f"-{z}"
        with pytest.raises(ClubfaceError, match=f"'{side} weight' lies"):
            read(tmp_path, coarse_walls(), masses={f"{side} weight": ("-40 mm", "-10 mm", other, "9 g")})
    swapped = tuple(
        Group(name=each.name, thickness=each.thickness, face=each.face,
              sets=({"crown": "sole", "sole": "crown"}.get(each.name, each.name),)) for each in GROUPS
    )  # fmt: skip
    with pytest.raises(ClubfaceError, match=r"y must point up: '(crown|sole)' lies"):
        read(tmp_path, coarse_walls(), swapped)


def test_a_face_centre_at_the_edge_of_the_face_is_noted(tmp_path):
    shift = np.array([-0.8, 0.0, 22.0])  # a bulge of 305 mm falls back by 0.8 mm there
    with pytest.raises(ClubfaceError, match="to the toe"):
        read(tmp_path, coarse_walls(), face_centre=tuple(shift))
    walls = coarse_walls()
    turn = turned(1, np.degrees(np.arcsin(22.0 / 305.0)))
    nodes = (walls.nodes - shift) @ turn.T
    with pytest.warns(MeshWarning, match="nearer the toe than the middle of the face"):
        read(tmp_path, walls._replace(nodes=nodes), loft="11.4 deg")


def test_normals_that_point_inward_are_turned_with_a_note(tmp_path):
    whole = read(tmp_path, coarse_walls())
    walls = coarse_walls()
    with pytest.warns(MeshWarning, match=f"normals of {len(walls.parts['crown'])} of"):
        part = read(tmp_path, walls.reversed("crown"))
    for name in PARTS:
        walls = walls.reversed(name)
    with pytest.warns(MeshWarning, match="normals of all elements"):
        inside_out = read(tmp_path, walls)
    for head in (part, inside_out):
        a, b, c, d = (head.nodes[head.quads[:, corner]] for corner in range(4))
        area = 0.5 * np.cross(c - a, d - b)
        volume = np.einsum("ij,ij->", area, 0.25 * (a + b + c + d)) / 3.0
        assert volume > 0.0
        assert head.club.mass == pytest.approx(whole.club.mass, rel=1e-12)


@pytest.mark.parametrize("shift", [0.0, 0.004])
def test_nodes_along_the_seams_of_parts_are_merged(tmp_path, shift):
    walls = coarse_walls()
    with pytest.warns(MeshWarning, match=r"\d+ nodes within .* are merged"):
        head = read(tmp_path, walls.apart(shift))
    assert len(head.nodes) == len(coarse_head().nodes)
    with pytest.raises(ClubfaceError, match="in one piece"):
        read(tmp_path, walls.apart(0.5))


def test_errors_of_elements_name_the_numbers_of_the_file(tmp_path):
    walls = coarse_walls()
    text = write_walls(tmp_path, walls).read_text()
    # Elements and nodes far from 1, as CAD programs number them.
    shifted = re.sub(r"(?m)^(\d+), (\d+), (\d+), (\d+), (\d+)$", lambda row: ", ".join(
        [str(int(row[1]) + 70_000), *(str(int(each) + 5_000) for each in row.groups()[1:])]), text)  # fmt: skip
    shifted = re.sub(
        r"(?m)^(\d+)(, [-\d.e]+, [-\d.e]+, [-\d.e]+)$", lambda row: f"{int(row[1]) + 5_000}{row[2]}", shifted
    )
    shifted = re.sub(r"(?m)^1, \d+, 1$", "70001, 79999, 1", shifted)
    row = next(line for line in shifted.splitlines() if line.startswith("70123, "))
    number, a, b, c, d = row.split(", ")
    path = tmp_path / "head.inp"
    for bad, message in (
        (f"{number}, {a}, {c}, {b}, {d}", "element 70123 is inverted or degenerate"),
        (f"{number}, {a}, {b}, {b}, {d}", "element 70123 is inverted or degenerate: it lists a node twice"),
        (f"{row}\n70999, {b}, {c}, {d}, {a}", "elements 70123 and 70999 have the same nodes"),
        (f"{number}, {a}, {b}, {c}, 99999", "element 70123 refers to node 99999, which does not exist"),
    ):
        path.write_text(shifted.replace(row, bad))
        with pytest.raises(FileError, match=message):
            MeshHead(name="mine", file=path, groups=GROUPS, **FACE).mesh()
    path.write_text(shifted)
    assert MeshHead(name="mine", file=path, groups=GROUPS, **FACE).mesh().elements == coarse_head().elements


def test_walls_that_meet_in_a_t_are_named(tmp_path):
    walls = coarse_walls()
    a, b = walls.parts["crown"][40][:2]
    nodes = np.vstack([walls.nodes, walls.nodes[[a, b]] - [0.0, 5.0, 0.0]])
    rib = [b, a, len(walls.nodes), len(walls.nodes) + 1]
    parts = {**walls.parts, "crown": [*walls.parts["crown"], rib]}
    with pytest.raises(FileError, match=r"elements \d+, \d+, \d+ share the edge"):
        read(tmp_path, walls._replace(nodes=nodes, parts=parts))


def test_a_quadrilateral_with_a_straight_angle_is_cut_into_triangles(tmp_path):
    walls = coarse_walls()
    quad = walls.parts["crown"][30]
    nodes = walls.nodes.copy()
    nodes[quad[1]] = 0.5 * (nodes[quad[0]] + nodes[quad[2]])
    with pytest.warns(MeshWarning, match="nearly 180 degrees"):
        head = read(tmp_path, walls._replace(nodes=nodes))
    assert head.elements > coarse_head().elements


def test_the_face_of_a_head_of_one_group_is_what_looks_at_the_ball(tmp_path):
    walls = coarse_walls()
    one = walls._replace(parts={"shell": [each for rows in walls.parts.values() for each in rows]})
    with pytest.warns(MeshWarning, match="elements of shell"):
        head = read(tmp_path, one, (Group(name="shell", thickness="1.4 mm", face=True),))
    face, rest = head.parts
    assert face.face
    assert not rest.face
    assert 0.8 * len(walls.parts["face"]) < face.elements < 1.6 * len(walls.parts["face"])


@pytest.mark.parametrize(
    ("place", "exact"),
    [(("-40 mm", "-24 mm", "0 mm"), 2e-2), (("-70 mm", "10 mm", "12 mm"), 3e-2), (("-12 mm", "5 mm", "-38 mm"), 3e-2)],
)
def test_mass_and_cg_of_added_masses_are_exact_and_errors_of_the_inertia_are_noted(tmp_path, place, exact):
    bare = read(tmp_path, coarse_walls()).club
    with pytest.warns(MeshWarning, match=r"a moment of inertia [\d.]+% off") as caught:
        head = read(tmp_path, coarse_walls(), masses={"weight": (*place, "25 g")}).club
    point = np.array([float(each.split()[0]) for each in place]) * 1e-3
    assert head.mass == pytest.approx(bare.mass + 0.025, rel=1e-12)
    cg = (bare.mass * -np.array(bare.cg) + 0.025 * point) / head.mass
    assert np.abs(-np.array(head.cg) - cg).max() < 1e-9

    def about(club, mass):
        arm = -np.array(club.cg) if club is not None else point
        return mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))

    asked = np.array(bare.inertia) + about(bare, bare.mass) + about(None, 0.025)
    asked -= head.mass * (cg @ cg * np.eye(3) - np.outer(cg, cg))
    missed = np.abs(np.diag(head.inertia) / np.diag(asked) - 1.0).max()
    assert missed < exact
    (text,) = [str(each.message) for each in caught if "moment of inertia" in str(each.message)]
    assert float(re.search(r"inertia ([\d.]+)%", text)[1]) == pytest.approx(100.0 * missed, rel=0.3, abs=0.1)


def test_the_sides_of_a_wall_and_loose_parts_are_pieces_that_are_refused(tmp_path):
    walls = coarse_walls()
    count, middle = len(walls.nodes), walls.nodes.mean(axis=0)
    inner = [[each + count for each in row[::-1]] for _, row in walls.elements]
    skins = walls._replace(
        nodes=np.vstack([walls.nodes, middle + 0.97 * (walls.nodes - middle)]),
        parts={**walls.parts, "skirt": walls.parts["skirt"] + inner},
    )
    with pytest.raises(FileError, match=r"in 2 that share"):
        read(tmp_path, skins)
    with pytest.raises(FileError, match=r"in 4 that .* smallest are 0\.08\d* from the others"):
        read(tmp_path, walls.apart(0.05))


@pytest.mark.filterwarnings("default::clubface.errors.MeshWarning")
def test_a_hole_in_the_head_is_noted(tmp_path):
    walls = coarse_walls()
    with pytest.warns(MeshWarning, match="the surface is open"):
        read(tmp_path, walls._replace(parts={**walls.parts, "crown": walls.parts["crown"][:-30]}))


@pytest.mark.filterwarnings("default::clubface.errors.MeshWarning")
def test_a_face_group_that_ends_in_the_middle_of_the_face_is_noted(tmp_path):
    walls = coarse_walls()
    high = [float(walls.nodes[row].mean(axis=0)[1]) for row in walls.parts["face"]]
    upper = [row for row, at in zip(walls.parts["face"], high, strict=True) if at > -3.0]
    lower = [row for row, at in zip(walls.parts["face"], high, strict=True) if at <= -3.0]
    parts = {**walls.parts, "face": upper, "sole": walls.parts["sole"] + lower}
    with pytest.warns(MeshWarning, match=r"elements of sole continue the face within 12 mm .* face = true"):
        read(tmp_path, walls._replace(parts=parts))


@pytest.mark.filterwarnings("error::clubface.errors.MeshWarning")
def test_a_closed_head_with_its_whole_face_is_read_without_a_word(tmp_path):
    assert read(tmp_path, coarse_walls()).parts[0].face
