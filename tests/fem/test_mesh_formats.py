"""Meshes as mesh generators write them: the same head from every format, its sets, cards and point masses."""

import re
from dataclasses import replace

import numpy as np
import pytest

from clubface import fem
from clubface.errors import ClubfaceError, FileError, MeshWarning
from clubface.fem.heads import Group, MeshHead
from clubface.fem.heads.added_mass import spread
from fem_meshes import (
    FACE,
    FORMATS,
    GROUPS,
    HEAD,
    PARTS,
    abaqus,
    coarse_walls,
    gmsh_2,
    gmsh_4,
    lsdyna,
    nastran,
    stl_binary,
    write_walls,
)
from fem_runs import coarse_head, shells_case

TITANIUM = (114e3, 0.34, 4.43e-9)
"""MPa and t/mm3."""
WALLS = {"face": 2.8, "crown": 1.3, "sole": 1.6, "skirt": 1.4}
pytestmark = [pytest.mark.filterwarnings("ignore::clubface.errors.MeshWarning"), pytest.mark.usefixtures("new_process")]


def needs(name):
    if "binary.msh" in name or name.endswith(".vtk"):
        pytest.importorskip("meshlane")


def read(path, groups=GROUPS, **changes):
    return MeshHead(name="mine", file=path, groups=groups, **{**FACE, **changes}).mesh()


def numbered(name):
    """Groups by number, for formats without names."""
    if not name.endswith(".vtk"):
        return GROUPS
    return tuple(
        Group(name=each.name, thickness=each.thickness, face=each.face, sets=(str(place),))
        for place, each in enumerate(GROUPS, 1)
    )


@pytest.mark.parametrize("name", FORMATS)
def test_every_format_gives_the_same_head(tmp_path, name):
    needs(name)
    head, design = read(write_walls(tmp_path, coarse_walls(), name), numbered(name)), coarse_head()
    assert [part.name for part in head.parts] == list(PARTS)
    low, high = (limit(head.nodes, axis=0) for limit in (np.min, np.max))
    assert np.abs(low - design.nodes.min(axis=0)).max() < 1e-7
    assert np.abs(high - design.nodes.max(axis=0)).max() < 1e-7
    whole = read(write_walls(tmp_path, coarse_walls(), "abaqus.inp")).club
    split = 1e-2 if name == "text.stl" else 1e-6  # masses at nodes: a finer mesh is a little more compact
    assert head.club.mass == pytest.approx(whole.mass, rel=split)
    assert head.club.izz == pytest.approx(whole.izz, rel=split)


@pytest.fixture(scope="module")
def quadrilaterals(tmp_path_factory):
    """The club of the coarse head as it is."""
    return read(write_walls(tmp_path_factory.mktemp("head"), coarse_walls(), "abaqus.inp")).club


@pytest.mark.parametrize("name", [name for name in FORMATS if name not in ("text.stl", "unstructured.vtk")])
@pytest.mark.parametrize("what", ["triangles", "mixed", "with_edge_nodes"])
def test_triangles_and_elements_of_second_order_are_taken(tmp_path, quadrilaterals, name, what):
    if name == "gmsh2-binary.msh" and what == "with_edge_nodes":
        pytest.skip("written by meshlane from corners")
    needs(name)
    walls = coarse_walls()
    if what == "mixed":
        lone = iter([True, False, False] * 300)
        walls = walls.change(lambda row: [row[:3], [row[0], *row[2:]]] if next(lone) else [row])
    else:
        walls = getattr(walls, what)()
    with pytest.warns(MeshWarning, match="corners" if what == "with_edge_nodes" else "split into three"):
        head = read(write_walls(tmp_path, walls, name), numbered(name))
    plain = coarse_head()
    each_edge_twice = np.sort(np.stack([head.quads, np.roll(head.quads, -1, axis=1)], axis=-1), axis=-1).reshape(-1, 2)
    assert (np.unique(each_edge_twice, axis=0, return_counts=True)[1] == 2).all()
    # At most two triangles each, and of each triangle three quadrilaterals.
    times = len(head.quads) / len(plain.quads)
    assert 1.0 < times < 6.0 if what == "mixed" else times == (6.0 if what == "triangles" else 1.0)
    assert head.club.mass == pytest.approx(quadrilaterals.mass, rel=1e-3)
    assert head.club.iyy == pytest.approx(
        quadrilaterals.iyy, rel=6e-3
    )  # masses at nodes: a finer mesh is a little more compact


def test_few_triangles_split_few_quadrilaterals(tmp_path):
    number = iter(range(10_000))
    walls = coarse_walls().change(lambda row: [row[:3], [row[0], *row[2:]]] if next(number) in (300, 420) else [row])
    head = read(write_walls(tmp_path, walls))
    assert len(coarse_head().quads) < len(head.quads) < 1.3 * len(coarse_head().quads)


def test_binary_stl_is_one_group_of_triangles(tmp_path):
    path = tmp_path / "head.stl"
    path.write_bytes(stl_binary(coarse_walls()))
    whole = (Group(name="shell", thickness="1.4 mm", face=True),)
    with pytest.warns(MeshWarning, match="no groups|neither groups"):
        head = read(path, whole)
    even = tuple(replace(each, thickness="1.4 mm") for each in GROUPS)
    assert head.club.mass == pytest.approx(read(write_walls(tmp_path, coarse_walls()), even).club.mass, rel=1e-3)
    with pytest.raises(FileError, match="belongs to no group"):
        read(path)


@pytest.mark.parametrize("name", ["own.MSH", "own.txt", "own.dat"])
def test_a_mesh_is_known_by_what_stands_in_it(tmp_path, name):
    for write in (abaqus, nastran, gmsh_2, lsdyna):
        path = tmp_path / name
        path.write_text(write(coarse_walls()))
        assert read(path).elements == coarse_head().elements


def test_sets_of_the_mesh_generator_do_not_matter(tmp_path):
    text = abaqus(coarse_walls())
    assert "Surface1" in text
    (tmp_path / "head.inp").write_text(text)
    assert [part.name for part in read(tmp_path / "head.inp").parts] == list(PARTS)


def test_groups_are_named_in_any_case_by_number_and_as_several_sets(tmp_path):
    path = write_walls(tmp_path, coarse_walls(), "free.bdf")
    groups = (
        Group(name="FACE", thickness="3 mm", face=True),
        Group(name="2", thickness="1 mm"),
        Group(name="rest", thickness="1 mm", sets=("sole", "4")),
    )
    head = read(path, groups)
    assert [part.elements for part in head.parts][2] == sum(part.elements for part in coarse_head().parts[2:])
    with pytest.raises(FileError, match=r"unknown group of the mesh 'sole'.* its sets, .* face \(\d+\)|2 \("):
        read(path, groups[:2])


def test_properties_without_names_are_taken_in_order_with_a_note(tmp_path):
    text = re.sub(r"\$HMNAME.*\n", "", nastran(coarse_walls()))
    (tmp_path / "head.bdf").write_text(text)
    with pytest.warns(MeshWarning, match="1 as face, 2 as crown"):
        head = read(tmp_path / "head.bdf")
    assert [part.elements for part in head.parts] == [part.elements for part in coarse_head().parts]
    with pytest.raises(FileError, match=r"belongs to no group|unknown group"):
        read(tmp_path / "head.bdf", GROUPS[:3])


@pytest.mark.parametrize(
    "comment",
    [
        '$HMNAME COMP       {0}"{1}"',
        "$ANSA_NAME_COMMENT;{0};PSHELL;{1};;NO;NO;NO;NO;",
        "$ Femap with NX Nastran Property {0} : {1}",
    ],
)
def test_names_of_properties_are_read_from_comments(tmp_path, comment):
    text = re.sub(r"\$HMNAME.*\n", "", nastran(coarse_walls()))
    named = "\n".join(comment.format(place, name) for place, name in enumerate(reversed(PARTS), 1))
    walls = coarse_walls()
    turned = walls._replace(parts={name: walls.parts[name] for name in reversed(PARTS)})
    text = (
        named + "\n" + comment.format("9" * 5000, "no property") + "\n" + re.sub(r"\$HMNAME.*\n", "", nastran(turned))
    )
    (tmp_path / "head.bdf").write_text(text)
    head = read(tmp_path / "head.bdf")
    assert [part.elements for part in head.parts] == [part.elements for part in coarse_head().parts]


WITH_CARDS = ["abaqus.inp", "free.bdf", "small.nas", "large.fem", "dyna.k"]


@pytest.mark.parametrize("name", WITH_CARDS)
def test_thickness_and_metal_come_from_cards_where_the_file_of_the_head_gives_none(tmp_path, name):
    walls = coarse_walls()._replace(cards={each: (wall, *TITANIUM) for each, wall in WALLS.items()})
    groups = tuple(Group(name=each, face=each == "face") for each in PARTS)
    head = read(write_walls(tmp_path, walls, name), groups)
    for place, part in enumerate(head.parts):
        assert (part.metal.youngs, part.metal.density) == pytest.approx((114e9, 4430.0), rel=1e-6)
        assert head.thickness[head.part_of_elements() == place] == pytest.approx(1e-3 * WALLS[part.name])


@pytest.mark.parametrize(
    ("unit", "scale", "metal"),
    [
        ("mm", 1.0, (114.0, 0.34, 4.43e-6)),  # kg, mm, ms
        ("mm", 1.0, (114e3, 0.34, 4.43e-3)),  # g, mm, ms
        ("mm", 1.0, (114e9, 0.34, 4430.0)),  # lengths in mm, metals in SI
        ("m", 1e-3, (114e9, 0.34, 4430.0)),
        ("in", 1 / 25.4, (16.534e6, 0.34, 4.1453e-4)),  # psi, lbf s2/in4
        ("cm", 0.1, (1.14, 0.34, 4.43)),  # Mbar, g/cm3
    ],
)
def test_the_metals_of_cards_give_the_system_of_units(tmp_path, unit, scale, metal):
    walls = coarse_walls()
    walls = walls._replace(
        nodes=walls.nodes * scale, cards={each: (scale * wall, *metal) for each, wall in WALLS.items()}
    )
    path = tmp_path / "head.inp"
    path.write_text(abaqus(walls))
    head = read(path, tuple(Group(name=each, face=each == "face") for each in PARTS), unit=unit)
    assert head.parts[0].metal.youngs == pytest.approx(114e9, rel=1e-3)
    assert head.parts[0].metal.density == pytest.approx(4430.0, rel=1e-3)
    assert head.thickness[0] == pytest.approx(2.8e-3, rel=1e-6)


def test_a_card_of_no_metal_is_refused(tmp_path):
    walls = coarse_walls()._replace(cards={each: (wall, 1.14, 0.34, 4.43e-9) for each, wall in WALLS.items()})
    with pytest.raises(FileError, match=r"M-face: E 1.14 and density 4.43e-09"):
        read(write_walls(tmp_path, walls), tuple(Group(name=each, face=each == "face") for each in PARTS))


def test_cards_that_differ_are_noted_and_the_file_of_the_head_counts(tmp_path):
    walls = coarse_walls()._replace(cards=dict.fromkeys(PARTS, (1.0, *TITANIUM)))
    groups = (Group(name="face", thickness="2 mm", face=True, metal={"youngs": "200 GPa"}), *GROUPS[1:])
    with pytest.warns(MeshWarning, match=r"face 1 mm in the mesh, 2 mm .*youngs of face: 114 GPa in the mesh, 200 GPa"):
        head = read(write_walls(tmp_path, walls), groups)
    assert head.thickness[0] == 2e-3
    assert head.parts[0].metal.youngs == 200e9
    assert head.parts[0].metal.density == pytest.approx(4430.0)


def test_a_thickness_that_nothing_gives_is_asked_for(tmp_path, write):
    write_walls(tmp_path, coarse_walls())
    path = write(HEAD.replace("head.msh", "abaqus.inp").replace('thickness = "1.3 mm"\n', ""), "own.toml")
    with pytest.raises(FileError, match="thickness of crown"):
        fem.head(path)


def test_thickness_at_the_corners_of_nastran_elements_is_used(tmp_path):
    text = nastran(coarse_walls())
    lines = [line + ",,,\n,,,2.,2.,3.,3." if line.startswith("CQUAD4") else line for line in text.splitlines()]
    (tmp_path / "head.bdf").write_text("\n".join(lines))
    head = read(tmp_path / "head.bdf", tuple(Group(name=each, face=each == "face") for each in PARTS))
    assert head.thickness == pytest.approx(2.5e-3)


@pytest.mark.parametrize("form", ["nastran", "lsdyna"])
def test_point_masses_of_a_mesh_are_added(tmp_path, form):
    walls = coarse_walls()
    at = int(np.argmin(np.linalg.norm(walls.nodes - [-40.0, -22.0, 0.0], axis=1)))
    if form == "nastran":
        text, card = nastran(walls), f"CONM2,9001,{at + 1},,2.5-5\nENDDATA"
        (tmp_path / "head.bdf").write_text(text.replace("ENDDATA", card))
        path = tmp_path / "head.bdf"
    else:
        path = tmp_path / "head.k"
        path.write_text(lsdyna(walls).replace("*END\n", f"*ELEMENT_MASS\n{9001:8d}{at + 1:8d}{2.5e-5:16.8e}\n*END\n"))
    with pytest.warns(MeshWarning, match="1 point masses, 25 g in all"):
        head = read(path)
    bare = read(write_walls(tmp_path, walls))
    assert head.club.mass - bare.club.mass == pytest.approx(0.025, rel=1e-6)
    point = walls.nodes[at] * 1e-3
    cg = (bare.club.mass * -np.array(bare.club.cg) + 0.025 * point) / head.club.mass
    assert np.abs(-np.array(head.club.cg) - cg).max() < 1e-8


def test_a_deck_that_clubface_writes_is_read_back(tmp_path):
    case, path = shells_case(), tmp_path / "own.k"
    fem.keyword.write(case, path)
    groups = tuple(Group(name=part.name, face=part.face) for part in case.club.parts)
    with pytest.warns(MeshWarning, match="left out, .* hexahedra"):
        head = read(path, groups, unit="m", loft=0.0)
    assert head.elements == case.club.elements
    assert head.club.mass == pytest.approx(case.club.club.mass, rel=1e-6)
    assert np.linalg.eigvalsh(head.club.inertia) == pytest.approx(np.linalg.eigvalsh(case.club.club.inertia), rel=2e-3)


def test_a_deck_of_a_head_with_added_masses_is_read_back_with_them(tmp_path, write):
    from clubface.fem.case import case

    write_walls(tmp_path, coarse_walls())
    path = write(HEAD.replace("head.msh", "abaqus.inp"), "own.toml")
    head = fem.head(path)
    deck = tmp_path / "own.k"
    fem.keyword.write(case("paper").replace(ball=shells_case().ball, club=head), deck)
    groups = tuple(Group(name=part.name, face=part.face) for part in head.parts)
    again = read(deck, groups, unit="m", loft=0.0)
    assert again.club.mass == pytest.approx(head.club.mass, rel=1e-6)
    assert np.linalg.eigvalsh(again.club.inertia) == pytest.approx(np.linalg.eigvalsh(head.club.inertia), rel=1e-4)


PART = """\
*Part, name=Head
{mesh}*End Part
*Assembly, name=Assembly
*Instance, name=Head-1, part=Head
 {shift}, 0., 0.
*End Instance
*End Assembly
"""


def test_parts_of_abaqus_stand_where_their_instances_put_them(tmp_path):
    (tmp_path / "head.inp").write_text("*Heading\n" + PART.format(mesh=abaqus(coarse_walls()), shift=5.0))
    head = read(tmp_path / "head.inp", face_centre=(5.0, 0.0, 0.0))
    assert head.nodes[:, 0].max() == pytest.approx(coarse_head().nodes[:, 0].max(), abs=1e-8)
    with pytest.raises(ClubfaceError, match="face_centre"):
        read(tmp_path / "head.inp")


def test_parts_of_abaqus_are_turned_as_their_instances_say(tmp_path):
    walls = coarse_walls()
    # A quarter about a line upwards through (-50, 0, 7), by hand: x and z of the file, seen from there, are -z and x.
    away = walls.nodes - [-50.0, 0.0, 7.0]
    drawn = walls._replace(nodes=away @ np.array([[0, 0, 1], [0, 1, 0], [-1, 0, 0]]) + [-50.0, 0.0, 7.0])
    text = "*Heading\n" + PART.format(mesh=abaqus(drawn), shift=0.0)
    turn = " -50., 0., 7., -50., 9., 7., 90."
    (tmp_path / "head.inp").write_text(text.replace("*End Instance", turn + "\n*End Instance"))
    assert read(tmp_path / "head.inp").nodes == pytest.approx(read(write_walls(tmp_path, walls)).nodes, abs=1e-9)


def test_a_point_mass_of_nastran_stands_at_its_offset_from_a_node(tmp_path):
    walls = coarse_walls()
    one, other = (
        int(np.argmin(np.linalg.norm(walls.nodes - place, axis=1))) for place in ([-40, -22, 0], [-70, 0, 40])
    )
    offset = ",".join(f"{each:.9f}" for each in walls.nodes[other] - walls.nodes[one])
    heads = []
    for card in (f"CONM2,9001,{one + 1},,2.5-5,{offset}", f"CONM2,9001,{other + 1},,2.5-5"):
        (tmp_path / "head.bdf").write_text(nastran(walls).replace("ENDDATA", card + "\nENDDATA"))
        heads.append(read(tmp_path / "head.bdf"))
    assert heads[0].added == pytest.approx(heads[1].added, abs=1e-12)
    assert heads[0].added.sum() == pytest.approx(0.025)


def test_a_point_mass_in_a_mesh_in_inches_is_in_its_unit_of_mass(tmp_path):
    walls = coarse_walls()
    text = nastran(walls._replace(nodes=walls.nodes / 25.4)).replace("ENDDATA", "CONM2,9001,7,,1.42754-4\nENDDATA")
    (tmp_path / "head.bdf").write_text(text)
    # lbf s2/in, of which one weighs 386.09 lb.
    assert read(tmp_path / "head.bdf", unit="in").added.sum() == pytest.approx(0.025, rel=1e-4)


def test_walls_with_an_offset_from_their_nodes_are_noted(tmp_path):
    text = re.sub(r"(?m)^(CQUAD4,1,.*)$", r"\1,,1.4", nastran(coarse_walls()))
    (tmp_path / "head.bdf").write_text(text)
    with pytest.warns(MeshWarning, match="1 elements have an offset from the nodes"):
        read(tmp_path / "head.bdf")


def test_nodes_of_gmsh_may_have_parameters_of_their_surface(tmp_path):
    walls = coarse_walls()
    text = gmsh_4(walls).decode().replace("2 1 0 ", "2 1 1 ", 1)
    start = text.index("$Nodes\n")
    first, rest = text[:start], text[start:]
    rows = rest.split("\n")
    last = rows.index("$EndNodes")
    rows[last - len(walls.nodes) : last] = [row + "0.5 0.25" for row in rows[last - len(walls.nodes) : last]]
    (tmp_path / "head.msh").write_text(first + "\n".join(rows))
    assert read(tmp_path / "head.msh").nodes == pytest.approx(read(write_walls(tmp_path, walls)).nodes, abs=1e-9)


@pytest.mark.parametrize("form", ["abaqus", "nastran", "lsdyna"])
def test_an_included_file_is_not_left_out_without_a_word(tmp_path, form):
    text = {"abaqus": abaqus, "nastran": nastran, "lsdyna": lsdyna}[form](coarse_walls())
    line = {"abaqus": "*INCLUDE, INPUT=more.inp\n", "nastran": "INCLUDE 'more.bdf'\n", "lsdyna": "*INCLUDE\nmore.k\n"}[
        form
    ]
    text = text.replace("*NODE", line + "*NODE", 1) if form != "nastran" else text.replace("GRID", line + "GRID", 1)
    (tmp_path / "head.dat").write_text(text)
    with pytest.raises(FileError, match="includes another"):
        read(tmp_path / "head.dat")


@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        ("abaqus.inp", "*ELEMENT, TYPE=S4R", "*ELEMENT, TYPE=C3D4", "the elements of this mesh are solid"),
        ("abaqus.inp", "*ELEMENT, TYPE=S4R", "*ELEMENT, TYPE=XYZ9", "the type XYZ9"),
        ("free.bdf", "GRID,7,,", "GRID,7,3,", "node 7 is in coordinate system 3"),
        ("dyna.k", "*KEYWORD", "*KEYWORD LONG=Y", "long or i10 format"),
        ("dyna.k", "*KEYWORD", "*KEYWORD I10=Y", "long or i10 format"),
        ("abaqus.inp", "*NODE,", "*SYSTEM\n0, 0, 10\n*NODE,", "*SYSTEM is not"),
        ("abaqus.inp", "*ELSET, ELSET=nothing", "*ELGEN\n1, 2, 1, 1", "*ELGEN is not"),
        ("abaqus.inp", "NSET=ALLNODES", "INPUT=nodes.txt", "includes another one"),
        ("free.bdf", "BEGIN BULK", "BEGIN BULK\nGRDSET,,3", "coordinate system 3"),
        ("free.bdf", "CQUAD4,1,1,142,144,145,143", "CQUAD4,1,1,142,144,145,143,,,\n,,1,.5,.5,.5,.5", "TFLAG"),
    ],
)  # fmt: skip
def test_what_is_not_read_is_refused_in_one_line(tmp_path, name, old, new, message):
    path = write_walls(tmp_path, coarse_walls(), name)
    path.write_text(path.read_text().replace(old, new))
    with pytest.raises(ClubfaceError, match=re.escape(message)) as error:
        read(path)
    assert "\n" not in str(error.value)


# What programs write -------------------------------------------------------------------------------------------------


def with_cards():
    """Walls whose parts differ in thickness, and the face in its metal: what goes to another part is seen."""
    steel = (200e3, 0.3, 7.85e-9)
    return coarse_walls()._replace(
        cards={each: (WALLS[each], *(TITANIUM if each == "face" else steel)) for each in PARTS}
    )


def lsdyna_blocks(walls):
    """Sections and materials of all parts under one keyword each, without titles of sections but with their lines."""
    text = lsdyna(walls)
    cards = list(walls.cards.values())
    lines = ["*PART"]
    for number, name in enumerate(walls.parts, 1):
        lines += [name, f"{number:10d}" * 3]
    lines += ["*SECTION_SHELL_TITLE"]
    for number, (thickness, *_) in enumerate(cards, 1):
        lines += ["", f"{number:10d}{2:10d}", f"{thickness:10.4f}" * 4]
    lines += ["*MAT_ELASTIC_TITLE"]
    for number, (_, youngs, poisson, density) in enumerate(cards, 1):
        lines += ["", f"{number:10d}{density:10.3e}{youngs:10.1f}{poisson:10.3f}"]
    return text[: text.index("*PART")] + "\n".join([*lines, "", "*END"]) + "\n"


def hypermesh(walls, form):
    """Names of components, whose numbers are not those of the properties."""
    text = nastran(walls, 8)
    if form == "names of both":
        names = [f'$HMNAME COMP                   {5 - place}"{each}"' for place, each in enumerate(PARTS, 1)]
    else:
        text = re.sub(r"\$HMNAME.*\n", "", text)
        names = [
            f'$HMNAME COMP                   {5 - place}"{each}" {place} "p_{each}" 4'
            for place, each in enumerate(PARTS, 1)
        ]
    if form == "lists of elements":
        text = text.replace("BEGIN BULK\n", '$HMNAME PROP                   1"p_face" 4\nBEGIN BULK\n')
        names, last = [], 0
        for place, each in enumerate(PARTS, 1):
            count = len(walls.parts[each])
            names += [f'$HMNAME COMP                   {5 - place}"{each}"', f"$HMMOVE {5 - place:8d}"]
            names += [f"${'':7}{last + 1:8d}THRU    {last + count - 1:8d}", f"${'':7}{last + count:8d}", "$"]
            last += count
    return text.replace("BEGIN BULK\n", "\n".join(["BEGIN BULK", *names, ""]))


def ansa(walls):
    names = "\n".join(f"$ANSA_NAME;{place};PSHELL;~\n${each}" for place, each in enumerate(PARTS, 1))
    return re.sub(r"\$HMNAME.*\n", "", nastran(walls, 8)).replace("BEGIN BULK", "BEGIN BULK\n" + names)


def abaqus_cae(walls):
    """One part for each wall, each with a section of the set "Set-1", as its program names them."""
    walls, lines, instances = walls.apart(), ["*Heading"], ["*Assembly, name=Assembly"]
    for name, rows in walls.parts.items():
        used = sorted({each for row in rows for each in row})
        to = {each: number for number, each in enumerate(used, 1)}
        lines += [f"*Part, name={name.title()}", "*Node"]
        lines += ["{}, {:.9g}, {:.9g}, {:.9g}".format(to[each], *walls.nodes[each]) for each in used]
        lines += ["*Element, type=S4R"]
        lines += [", ".join(map(str, (number, *(to[each] for each in row)))) for number, row in enumerate(rows, 1)]
        lines += ["*Elset, elset=Set-1, generate", f" 1, {len(rows)}, 1", "** Section: Section-1"]
        lines += [f"*Shell Section, elset=SET-1, material=M-{name}", f"{walls.cards[name][0]}, 5", "*End Part"]
        instances += [f"*Instance, name={name}-1, part={name}", "*End Instance"]
    lines += [*instances, "*End Assembly"]
    for name, (_, youngs, poisson, density) in walls.cards.items():
        lines += [f"*Material, name=M-{name}", "*Density", f" {density},", "*Elastic", f"{youngs}, {poisson}"]
    return "\n".join(lines) + "\n"


PROGRAMS = {
    "blocks.k": lsdyna_blocks,
    "components and properties.bdf": lambda walls: hypermesh(walls, "names of both"),
    "components with properties.bdf": lambda walls: hypermesh(walls, "properties"),
    "components with elements.bdf": lambda walls: hypermesh(walls, "lists of elements"),
    "ansa.nas": ansa,
    "sections in capitals.inp": lambda walls: re.sub(
        r"(?<=SHELL SECTION, ELSET=)\w+", lambda name: name[0].upper(), abaqus(walls)
    ),
    "parts of cae.inp": abaqus_cae,
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_each_part_has_its_own_wall_and_metal_whatever_program_wrote_the_mesh(tmp_path, name):
    walls = with_cards()
    (tmp_path / name).write_text(PROGRAMS[name](walls))
    head = read(tmp_path / name, tuple(Group(name=each, face=each == "face") for each in PARTS))
    assert [part.name for part in head.parts] == list(PARTS)
    for place, part in enumerate(head.parts):
        assert part.elements == len(walls.parts[part.name])
        assert head.thickness[head.part_of_elements() == place] == pytest.approx(1e-3 * WALLS[part.name])
        assert part.metal.youngs == pytest.approx(114e9 if part.name == "face" else 200e9)


def test_parts_of_lsdyna_without_titles_go_by_their_numbers(tmp_path):
    text = lsdyna(with_cards())
    for each in PARTS:
        text = text.replace(f"*PART\n{each}\n", "*PART\n\n")
    (tmp_path / "head.k").write_text(text)
    head = read(tmp_path / "head.k", tuple(Group(name=str(number), face=number == 1) for number in range(1, 5)))
    assert head.thickness[0] == pytest.approx(2.8e-3)
    assert head.parts[3].metal.youngs == pytest.approx(200e9)


@pytest.mark.parametrize(
    ("name", "old", "new", "note"),
    [
        ("dyna.k", r"MAT_ELASTIC", "MAT_JOHNSON_COOK", r"\*MAT 1 of face; .* titanium"),
        ("small.nas", r"MAT1    1 ", "MAT8    1 ", "MAT 1 of face; .*titanium"),
        ("abaqus.inp", r"ELASTIC\n", "ELASTIC, TYPE=LAMINA\n", "no card gives youngs or poisson of face; .*titanium"),
        ("abaqus.inp", r"SECTION,", "SECTION, OFFSET=SPOS,", "4 sections have an offset"),
        ("dyna.k", r"(    1.6000){4}", r"\1\1\1\1      -1.0", "1 sections have an offset"),
        ("small.nas", r"(PSHELL  1 .*)\n", r"\g<1>                        1.0-8\n", "spread over the wall"),
        ("abaqus.inp", r"\Z", "*NONSTRUCTURAL MASS, ELSET=sole, UNITS=TOTAL MASS\n 3e-5,\n", "spread over walls"),
    ],
)
def test_cards_that_the_head_does_not_use_are_noted(tmp_path, name, old, new, note):
    path = write_walls(tmp_path, with_cards(), name)
    text, count = re.subn(old, new, path.read_text())
    assert count
    path.write_text(text)
    with pytest.warns(MeshWarning, match=note):
        read(path, tuple(Group(name=each, face=each == "face") for each in PARTS))


def test_point_masses_of_abaqus_are_added(tmp_path):
    walls = with_cards()
    path = write_walls(tmp_path, walls)
    bare = read(path)
    at = int(np.argmin(np.linalg.norm(walls.nodes - [-40.0, -22.0, 0.0], axis=1)))
    mass = f"*ELEMENT, TYPE=MASS, ELSET=screw\n9001, {at + 1}\n*MASS, ELSET=SCREW\n 2.5e-5\n"
    path.write_text(path.read_text() + mass)
    with pytest.warns(MeshWarning, match="1 point masses, 25 g in all"):
        assert read(path).club.mass - bare.club.mass == pytest.approx(0.025, rel=1e-6)


def test_a_solid_or_a_cad_file_says_what_to_do(tmp_path):
    path = tmp_path / "head.step"
    path.write_text("ISO-10303-21;\n")
    with pytest.raises(FileError, match="a CAD file without a mesh"):
        read(path)


def test_a_point_mass_on_the_wall_leaves_mass_cg_and_inertia_of_the_head_exact_and_the_face_as_it_is():
    head = coarse_head()
    quad = head.quads[int(np.argmin(head.nodes[head.quads].mean(axis=1)[:, 0]))]  # the rearmost
    point, mass = head.nodes[quad].mean(axis=0), 0.012
    metal = np.full(len(head.nodes), 0.18 / len(head.nodes))
    face = np.unique(head.quads[: head.parts[0].elements])
    added = spread({"weight": (*point, mass)}, head.nodes, metal, face).added
    places, masses = np.vstack([head.nodes, point]), np.append(metal, mass)

    def body(masses, places):
        cg = masses @ places / masses.sum()
        return masses.sum(), cg, (masses[:, None] * (places - cg)).T @ (places - cg)

    for one, other in zip(body(metal + added, head.nodes), body(masses, places), strict=True):
        np.testing.assert_allclose(one, other, atol=1e-9)  # kg, m and kg m2: rounding
    assert not added[face].any()
