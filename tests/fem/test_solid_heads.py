"""Solid heads of one's own mesh: tetrahedra and hexahedra from files, bonds, and what is refused."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from clubface import fem
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.fem.geometry import area_vectors, tetrahedron_volumes
from clubface.fem.heads import Bond, Group, MeshHead
from clubface.fem.result import SurfaceRecovery
from fem_runs import coarse, coarse_head
from solid_meshes import abaqus_solids, gmsh_solids, lsdyna_solids, nastran_solids, tetrahedra_of

SHAPE = {
    "loft": "30 deg", "length": "78 mm", "heel_height": "36 mm", "toe_height": "46 mm", "face": "5 mm", "sole": "16 mm",
    "top": "9 mm", "rim": 0.25, "rounding": "3 mm",
}  # fmt: skip
BLADE = {**SHAPE, "toe_height": "36 mm", "face": "8 mm", "sole": "8 mm", "top": "8 mm", "rounding": "0 mm"}
STEEL = {"youngs": "193 GPa", "poisson": 0.29, "density": "7800 kg/m3"}
FLAT = {"loft": "30 deg", "unit": "mm"}
ROOT = Path(__file__).parents[2]
pytestmark = [pytest.mark.filterwarnings("ignore::clubface.errors.MeshWarning"), pytest.mark.usefixtures("new_process")]


def iron(shape=SHAPE, elements=(20, 12, 2)):
    return fem.IronHead(name="iron", shape=shape, elements=elements).mesh()


def read(path, *names, bonds=(), **changes):
    names = names or ("head",)
    groups = tuple(Group(name=name, metal=STEEL, face=place == 0) for place, name in enumerate(names))
    return MeshHead(name="mine", file=path, groups=groups, bonds=bonds, **{**FLAT, **changes}).mesh()


def launch(head, **changes):
    # The usual ball: under one with a few heavy nodes, light nodes of a face sink in.
    how = {"speed": "38 m/s", "loft": "30 deg", "friction": 0.3, **changes}
    run = fem.strike(head, settings=fem.Settings(until_separation=True), **how)
    assert run.stopped is None
    assert run.energy_error < 0.01
    return run


@cache
def blade():
    """A blade in one piece, and how it launches."""
    made = iron(BLADE, (18, 10, 2))
    return made, launch(made)


WRITERS = {"gmsh.msh": gmsh_solids, "abaqus.inp": abaqus_solids, "nastran.bdf": nastran_solids, "dyna.k": lsdyna_solids}


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.parametrize("corners", [4, 8])
def test_every_format_gives_the_same_solid_head(tmp_path, name, corners):
    made = iron()
    elements = made.hexahedra if corners == 8 else tetrahedra_of(made.hexahedra)
    path = WRITERS[name](tmp_path / name, made.nodes * 1e3, {"head": elements.tolist()})
    head = read(path)
    assert (len(head.hexahedra), len(head.tetrahedra)) == ((len(elements), 0) if corners == 8 else (0, len(elements)))
    # Coordinates have 8 digits; quadrilaterals that are not flat enclose a little more or less than tetrahedra.
    assert head.club.mass == pytest.approx(made.club.mass, rel=1e-6 if corners == 8 else 2e-3)
    assert head.loft == pytest.approx(np.radians(30.0))
    # The side that the ball meets is the whole face of the blade, in one piece.
    face = {tuple(np.round(place, 7)) for place in head.nodes[np.unique(head.face)][:, [0, 1, 2]]}
    assert {tuple(np.round(place, 7)) for place in made.nodes[np.unique(made.face)]} <= face
    normal = [np.cos(head.loft), np.sin(head.loft), 0.0]
    assert np.abs(head.nodes[np.unique(head.face)] @ normal).max() < 1e-6


def test_tetrahedra_launch_as_hexahedra_do(tmp_path):
    # The same solid by another element. Hexahedra of four layers launch 0.07% faster than tetrahedra of two and as much
    # slower in spin, and hexahedra of two 0.03% and 0.2%.
    made, one = blade()
    path = gmsh_solids(tmp_path / "head.msh", made.nodes * 1e3, {"head": tetrahedra_of(made.hexahedra).tolist()})
    other = launch(read(path))
    assert other.normal_velocity == pytest.approx(one.normal_velocity, rel=1e-3)
    assert other.backspin == pytest.approx(one.backspin, rel=5e-3)
    assert other.peak_force == pytest.approx(one.peak_force, rel=5e-3)


def thickened(head):
    """Return the walls of a head of shells as one layer of hexahedra: nodes [m] and elements."""
    area = area_vectors(head.nodes, head.quads)
    normals, walls, sizes = np.zeros((len(head.nodes), 3)), np.zeros(len(head.nodes)), np.zeros(len(head.nodes))
    each = np.linalg.norm(area, axis=1)
    np.add.at(normals, head.quads, area[:, None])
    np.add.at(walls, head.quads, (head.thickness * each)[:, None])
    np.add.at(sizes, head.quads, each[:, None])
    half = 0.5 * (walls / sizes)[:, None] * normals / np.linalg.norm(normals, axis=1)[:, None]
    quads = head.quads.astype(int)
    return np.concatenate([head.nodes - half, head.nodes + half]), np.concatenate([quads, quads + len(half)], axis=1)


@pytest.mark.study
def test_a_wood_of_one_layer_of_tetrahedra_launches_as_one_of_shells(tmp_path):
    # Walls of 2 to 3 mm as shells of 8 mm and as tetrahedra between the same lines.
    shells = coarse_head()
    shells = replace(shells, added=np.zeros(len(shells.nodes)))
    nodes, hexahedra = thickened(shells)
    part_of = shells.part_of_elements()
    groups = {part.name: tetrahedra_of(hexahedra[part_of == place]).tolist() for place, part in enumerate(shells.parts)}
    metal = {key: getattr(shells.parts[0].metal, key) for key in ("youngs", "poisson", "density")}
    solid = MeshHead(
        name="wood", file=gmsh_solids(tmp_path / "wood.msh", nodes * 1e3, groups), loft=shells.loft,
        groups=tuple(Group(name=part.name, metal=metal, face=part.face) for part in shells.parts),
        bulge=shells.bulge, roll=shells.roll,
    ).mesh()  # fmt: skip
    # At folds of the middle surface the two fill space differently.
    assert solid.club.mass == pytest.approx(shells.club.mass, rel=0.01)
    how = {"speed": "40 m/s", "loft": shells.loft}
    one, other = launch(shells, **how), launch(solid, **how)
    assert other.normal_velocity == pytest.approx(one.normal_velocity, rel=4e-3)
    assert other.backspin == pytest.approx(one.backspin, rel=0.01)
    assert other.peak_force == pytest.approx(one.peak_force, rel=0.03)


def insert(made, kind):
    """Return groups of a blade whose front layer is a part of its own with its own nodes, and all nodes [mm]."""
    normal = [np.cos(made.loft), np.sin(made.loft), 0.0]
    depth = made.nodes[made.hexahedra].mean(axis=1) @ normal
    front = depth > np.median(np.unique(depth.round(6)))
    plate, back = made.hexahedra[front], made.hexahedra[~front]
    used, places = np.unique(plate, return_inverse=True)
    nodes = np.concatenate([made.nodes, made.nodes[used]]) * 1e3
    plate = len(made.nodes) + places.reshape(plate.shape)
    return nodes, {"plate": (tetrahedra_of(plate) if kind == "tetrahedra" else plate).tolist(), "body": back.tolist()}


@pytest.mark.parametrize("kind", ["tetrahedra", pytest.param("hexahedra", marks=pytest.mark.study)])
def test_a_bonded_plate_is_as_one_piece(tmp_path, kind):
    # A blade in one piece, and one whose front half is another mesh, bonded to the rest.
    made, one = blade()
    nodes, groups = insert(made, kind)
    path = gmsh_solids(tmp_path / "two.msh", nodes, groups)
    head = read(path, "plate", "body", bonds=(Bond(part="plate", to="body"),))
    assert head.club.mass == pytest.approx(made.club.mass, rel=1e-6)
    other = launch(head)
    assert other.normal_velocity == pytest.approx(one.normal_velocity, rel=2e-3)
    assert other.backspin == pytest.approx(one.backspin, rel=0.01)


def test_seams_close_without_a_bond(tmp_path):
    # Hexahedra on both sides, with nodes of their own at the same places: one piece.
    made, one = blade()
    nodes, groups = insert(made, "hexahedra")
    path = gmsh_solids(tmp_path / "two.msh", nodes, groups)
    head = read(path, "plate", "body")
    assert len(head.nodes) == len(made.nodes)
    assert launch(head).normal_velocity == pytest.approx(one.normal_velocity, rel=1e-6)


def test_parts_have_metals_of_their_own(tmp_path):
    made = iron(BLADE, (18, 10, 2))
    nodes, groups = insert(made, "hexahedra")
    path = gmsh_solids(tmp_path / "two.msh", nodes, groups)
    light = {"youngs": "110 GPa", "poisson": 0.34, "density": "4430 kg/m3"}
    parts = (Group(name="plate", metal=light, face=True), Group(name="body", metal=STEEL))
    head = MeshHead(name="mine", file=path, groups=parts, **FLAT).mesh()
    assert head.club.mass == pytest.approx(0.5 * made.club.mass * (1.0 + 4430.0 / 7800.0), rel=1e-9)
    stress = fem.stress.impact_stress(head, speed="20 m/s", ball=coarse())
    assert [part.part for part in stress.parts] == ["plate", "body"]
    assert all(part.stress > 1e7 for part in stress.parts)


def test_the_outside_of_tetrahedra_is_closed_and_looks_outwards(tmp_path):
    made = iron(elements=(12, 8, 2))
    path = gmsh_solids(tmp_path / "head.msh", made.nodes * 1e3, {"head": tetrahedra_of(made.hexahedra).tolist()})
    head = read(path)
    sides = head.parts[0].outside()
    areas = area_vectors(head.nodes, sides)
    assert areas.sum(axis=0) == pytest.approx(0.0, abs=1e-12)
    # The divergence theorem, and every triangle counts as much as its three brothers.
    volume = np.einsum("ij,ij->", areas, head.nodes[sides[:, :3]].mean(axis=1)) / 3.0
    assert volume == pytest.approx(tetrahedron_volumes(head.nodes, head.tetrahedra).sum(), rel=1e-9)
    assert np.einsum("ij,ij->i", areas.reshape(-1, 4, 3)[:, 3], areas.reshape(-1, 4, 3)[:, 0]).min() > 0.0


def test_stress_that_is_linear_is_exact_at_the_surface_of_tetrahedra(tmp_path):
    made = iron(elements=(12, 8, 1))
    path = gmsh_solids(tmp_path / "head.msh", made.nodes * 1e3, {"head": tetrahedra_of(made.hexahedra).tolist()})
    head = read(path)
    recovery = SurfaceRecovery.of_mesh(head.nodes, head.tetrahedra)
    assert recovery.extrapolated.all()
    assert len(recovery.nodes) == len(np.unique(recovery.quads))
    slopes = np.array([[3e9, -1e9, 2e9], [0.0, 5e9, 1e9]]).T
    of_elements = 1e8 + head.nodes[head.tetrahedra].mean(axis=1) @ slopes
    # Rounding.
    at_nodes = recovery.at_nodes(of_elements[None])[0]
    assert at_nodes == pytest.approx(1e8 + head.nodes[recovery.nodes] @ slopes, abs=1.0)


def test_one_layer_of_tetrahedra_sees_how_a_wall_bends(tmp_path):
    # Of blades of 12 by 8 hexahedra in four layers come to 251 MPa and tetrahedra in one layer to 279; on finer ones
    # the two approach each other. One layer of hexahedra sees 60.
    options = {"speed": "42 m/s", "ball": coarse("modern")}
    one, four = (iron(elements=(12, 8, layers)) for layers in (1, 4))
    path = gmsh_solids(tmp_path / "head.msh", one.nodes * 1e3, {"head": tetrahedra_of(one.hexahedra).tolist()})
    bent, reference, flat = (
        fem.stress.impact_stress(head, **options).parts[0].stress for head in (read(path), four, one)
    )
    assert bent == pytest.approx(reference, rel=0.12)
    assert flat < 0.5 * reference


def test_groups_of_surfaces_are_left_out_beside_solids(tmp_path):
    made = iron()
    path = gmsh_solids(
        tmp_path / "both.msh", made.nodes * 1e3, {"head": made.hexahedra.tolist()}, sides=made.face[:, :3].tolist()
    )
    assert read(path).elements == made.elements


def test_nodes_in_any_order_make_the_same_head(tmp_path):
    made = iron()
    tetrahedra = tetrahedra_of(made.hexahedra)
    turned = tetrahedra[:, [0, 2, 1, 3]]
    volumes = [tetrahedron_volumes(made.nodes, each) for each in (tetrahedra, turned)]
    assert (volumes[0] * volumes[1] < 0.0).all()
    masses = []
    for number, each in enumerate((tetrahedra, turned)):
        path = gmsh_solids(tmp_path / f"{number}.msh", made.nodes * 1e3, {"head": each.tolist()})
        masses.append(read(path).club.mass)
    assert masses[0] == masses[1]


def test_impossible_solid_heads_are_refused(tmp_path):
    made = iron()
    nodes, hexahedra = made.nodes * 1e3, made.hexahedra.tolist()

    def written(name, groups):
        return gmsh_solids(tmp_path / name, nodes, groups)

    wedge = [each[:6] for each in hexahedra[:1]]
    with pytest.raises(FileError, match="1 wedges, such as element"):
        read(written("wedge.msh", {"head": [*hexahedra, *wedge]}))
    flat = [hexahedra[0][0], hexahedra[0][1], hexahedra[0][2], hexahedra[0][0]]
    with pytest.raises(FileError, match="degenerate"):
        read(written("flat.msh", {"head": [*tetrahedra_of(made.hexahedra).tolist(), flat]}))
    mixed = {"plate": tetrahedra_of(made.hexahedra[:400]).tolist(), "body": hexahedra[400:]}
    with pytest.raises(FileError, match="shares a side with a hexahedron"):
        read(written("mixed.msh", mixed), "plate", "body")
    path = written("good.msh", {"head": hexahedra})
    with pytest.raises(InputError, match="thickness of head"):
        MeshHead(name="mine", file=path, groups=(Group(name="head", thickness="2 mm", face=True),), **FLAT).mesh()
    with pytest.raises(UnknownNameError):
        read(path, bonds=(Bond(part="insert", to="head"),))
    # A plate before a body, with half a millimetre between them.
    made = iron(BLADE, (18, 10, 2))
    nodes, groups = insert(made, "tetrahedra")
    normal = [np.cos(made.loft), np.sin(made.loft), 0.0]
    nodes[len(made.nodes) :] += 0.5 * np.array(normal)
    path = gmsh_solids(tmp_path / "open.msh", nodes, groups)
    with pytest.raises(InputError, match="connected to no other part"):
        read(path, "plate", "body")
    with pytest.raises(InputError, match=r"open: no side of an element is within 0\.100 mm"):
        read(path, "plate", "body", bonds=(Bond(part="plate", to="body"),))
    assert read(path, "plate", "body", bonds=(Bond(part="plate", to="body", within=6e-4),)).elements


def test_a_solid_head_is_a_file_like_any_other(tmp_path):
    made = iron()
    gmsh_solids(tmp_path / "head.msh", made.nodes * 1e3, {"head": tetrahedra_of(made.hexahedra).tolist()})
    file = tmp_path / "solid.toml"
    file.write_text(
        'name = "solid"\nkind = "mesh"\nfile = "head.msh"\nloft = "30 deg"\n'
        '[[groups]]\nname = "head"\nface = true\nyoungs = "193 GPa"\npoisson = 0.29\ndensity = "7800 kg/m3"\n'
        '[[masses]]\nname = "hosel"\nx = "-4 mm"\ny = "5 mm"\nz = "-30 mm"\nmass = "40 g"\n'
    )
    head = fem.head(file)
    assert head.club.mass == pytest.approx(made.club.mass + 0.04, rel=2e-3)
    # Masses at places leave mass and CG exact.
    bare = read(tmp_path / "head.msh").club
    place = np.array([-4e-3, 5e-3, -30e-3])
    cg = (bare.mass * -np.array(bare.cg) + 0.04 * place) / (bare.mass + 0.04)
    assert -np.array(head.club.cg) == pytest.approx(cg, abs=1e-10)
    settings = fem.Settings(duration=60e-6, frames=2, fields=True)
    run = fem.strike(head, speed="30 m/s", loft="30 deg", ball=coarse(), settings=settings)
    written = fem.files.write_series(run, tmp_path, "solid")
    meshlane = pytest.importorskip("meshlane")
    cells = meshlane.read(written[1]).cells
    assert [(block.type, len(block.data)) for block in cells][1] == ("tetra10", head.elements)


def test_the_iron_of_the_page_is_the_example():
    page = (ROOT / "docs" / "finite-elements" / "heads.md").read_text()
    example = (ROOT / "examples" / "own_iron.toml").read_text().partition("\n")[2]
    assert f"```toml\n{example}```" in page
    head = fem.head(ROOT / "examples" / "own_iron.toml")
    assert [part.name for part in head.parts] == ["face", "body"]
    assert len(head.parts[0].tetrahedra) == head.elements - len(head.parts[1].hexahedra) > 0
