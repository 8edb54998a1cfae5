"""Shapes for ParaView and keyword decks: read back, and the same as what was run."""

import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest

from clubface import fem
from clubface.errors import InputError
from clubface.fem import files, keyword
from clubface.fem.case import case
from clubface.fem.materials import laws
from fem_runs import coarse_drive, coarse_head, coarse_shells, coarse_throw, drive_case, shells_case, throw_case


def volumes(points, cells):
    """Volumes of hexahedra, as six tetrahedra each."""
    split = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))
    total = np.zeros(len(cells))
    for a, b, c, d in split:
        p = [points[cells[:, corner]] for corner in (a, b, c, d)]
        total += np.einsum("ij,ij->i", np.cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) / 6.0
    return total


@pytest.mark.parametrize("run", [coarse_throw, coarse_drive, coarse_shells])
def test_shapes_read_back_as_they_were(tmp_path, run):
    meshlane = pytest.importorskip("meshlane")
    result = run()
    *shapes, collection = files.write_series(result, tmp_path, "an impact: first")
    assert 4 <= len(shapes) == len(result.frames) <= 5  # the last step ends a little before the simulated time
    places = result.world_positions()
    nodes = places.shape[1]
    for path, place in zip(shapes, places, strict=True):
        mesh = meshlane.read(path)
        cells = mesh.cells_dict["hexahedron"]
        assert len(cells) == result.ball.elements
        moved = mesh.points + mesh.point_data["displacement"]
        # Displacements of up to 3 cm in numbers of 24 bits.
        assert moved[:nodes] == pytest.approx(place, abs=2e-9)
        assert set(mesh.cell_data["piece"][0]) == {0, 1}
        if result.head is not None:
            assert len(mesh.cells_dict["quad"]) == result.head.elements
            assert set(mesh.cell_data["piece"][1]) == {2, 3, 4, 5}
            assert len(moved) == nodes + len(result.head.nodes)
        assert (volumes(mesh.points, cells) > 0.0).all()
        assert (volumes(place, cells) > 0.0).all()
    entries = ET.parse(collection).getroot().findall("./Collection/DataSet")
    assert [tmp_path / entry.attrib["file"] for entry in entries] == shapes
    assert [float(entry.attrib["timestep"]) for entry in entries] == result.frame_times.tolist()


def test_the_ball_of_a_drive_flies_to_the_target_and_up():
    result = coarse_drive()
    first, last = result.world_positions()[[0, -1]].mean(axis=1)
    assert last[0] - first[0] > 0.01
    assert last[1] - first[1] > 0.001


@pytest.mark.parametrize("frames", [1, 2, 6, 11])
def test_as_many_shapes_are_kept_as_are_asked_for(frames):
    result = throw_case(duration="601 us", frames=frames).run()
    wanted = np.linspace(0.0, 601e-6, frames) if frames > 1 else [0.0]
    # To half an interval of the records, and a step.
    assert result.frame_times == pytest.approx(wanted, abs=3.5e-6)
    assert len(result.frames) == frames


def test_shapes_are_spread_over_the_duration_however_long_the_run():
    short = throw_case(duration="301 us", frames=7).run()
    assert short.unfinished
    assert len(short.frames) == 7
    progress = []
    longer = throw_case(duration="301 us", frames=7, until_separation=True).run(lambda *times: progress.append(times))
    assert longer.contact["time"][-1] > 600e-6
    assert (longer.frames == short.frames)[:-1].all()
    assert len(longer.frames) == 7
    assert progress
    assert all(time <= whole for time, whole in progress)


def test_a_run_without_shapes_is_refused(tmp_path):
    with pytest.raises(InputError, match="frames"):
        files.write_series(throw_case(duration="20 us").run(), tmp_path, "none")


class Deck:
    """A deck read by its rules: a line beginning with $ is a comment, * a keyword, fields have fixed widths."""

    def __init__(self, path):
        self.keywords = []
        text = path.read_text(encoding="ascii")
        assert all(len(line) <= 80 for line in text.splitlines())
        for line in text.splitlines():
            if line.startswith("*"):
                self.keywords.append((line[1:], []))
            elif not line.startswith("$"):
                self.keywords[-1][1].append(line)

    def all(self, name):
        return [cards for keyword, cards in self.keywords if keyword == name]

    def one(self, name):
        (cards,) = self.all(name)
        return cards

    def nodes(self):
        rows = [line for cards in self.all("NODE") for line in cards]
        assert [int(line[:8]) for line in rows] == list(range(1, len(rows) + 1))
        return np.array([[float(line[start : start + 16]) for start in (8, 24, 40)] for line in rows])

    def elements(self, name):
        return np.array([[int(line[at : at + 8]) for at in range(0, len(line), 8)] for line in self.one(name)])


def fields(line, width=10):
    return [float(text) if (text := line[at : at + width].strip()) else None for at in range(0, len(line), width)]


@pytest.fixture(scope="module")
def reference_deck(tmp_path_factory):
    ball = fem.ball("reference")
    given = throw_case().replace(ball=ball, settings={"duration": "1000 us", "bulk_viscosity": 0.06})
    return given, Deck(keyword.write(given, tmp_path_factory.mktemp("deck") / "reference.k"))


def test_the_reference_deck_holds_the_mesh_and_the_mass(reference_deck):
    given, deck = reference_deck
    properties = given.ball.properties()
    nodes, solids = deck.nodes(), deck.elements("ELEMENT_SOLID")
    assert (len(nodes), len(solids)) == (properties["nodes"], properties["elements"])
    assert solids[:, 0].tolist() == list(range(1, 9505))
    density = {int(fields(cards[0])[0]): fields(cards[0])[1] for name, cards in deck.keywords if name[:4] == "MAT_"}
    volume = volumes(nodes, solids[:, 2:] - 1)
    assert (volume > 0.0).all()
    mass = sum(density[part] * volume[solids[:, 1] == part].sum() for part in (1, 2))
    assert mass == pytest.approx(0.046, rel=2e-3)
    assert nodes[:, 0].min() == pytest.approx(0.0, abs=1e-9)
    assert np.linalg.norm(nodes - [0.0214, 0.0, 0.0], axis=1).max() == pytest.approx(0.0214, rel=1e-6)


def test_the_reference_deck_holds_laws_velocity_and_wall(reference_deck):
    _, deck = reference_deck
    assert fields(deck.one("MAT_MOONEY-RIVLIN_RUBBER")[0])[2:] == [0.49, 4e6, 1e6]
    assert fields(deck.one("MAT_ELASTIC")[0]) == [2, 950.0, 350e6, 0.4]
    velocity = fields(deck.one("INITIAL_VELOCITY_GENERATION")[0])
    assert velocity[:3] == [1, 1, 0.0]
    assert velocity[3:] == pytest.approx([-35 * np.cos(np.radians(11.5)), 35 * np.sin(np.radians(11.5)), 0], rel=1e-7)
    assert fields(deck.one("RIGIDWALL_PLANAR")[1]) == [0, 0, 0, 1, 0, 0, 0.35]
    assert fields(deck.one("CONTROL_TERMINATION")[0]) == [1e-3]
    assert fields(deck.one("CONTROL_BULK_VISCOSITY")[0])[1] == 0.06
    assert [fields(cards[1])[:5] for cards in deck.all("PART")] == [[1, 1, 1, 0, 1], [2, 1, 2, 0, 1]]
    assert fields(deck.one("SECTION_SOLID")[0]) == [1, 1]
    assert fields(deck.one("HOURGLASS")[0])[1] == 6
    assert deck.keywords[0][0] == "KEYWORD"
    assert deck.keywords[-1] == ("END", [])


def test_the_deck_of_a_drive_holds_the_head(tmp_path):
    given = drive_case().replace(toe="8 mm", high="-3 mm", closure="2400 deg/s", attack="-2 deg", face="1 deg")
    # A moment that is the same about every axis shows in any axes.
    moments = {**dict.fromkeys(("ixx", "iyy", "izz"), 1526e-7), **dict.fromkeys(("ixy", "ixz", "iyz"), 0.0)}
    given = given.replace(club=replace(given.club, mass=0.21, **moments))
    deck = Deck(keyword.write(given, tmp_path / "drive.k"))
    title, _, place, inertia, motion = deck.one("PART_INERTIA")
    assert title == "Roh and Lee head of shells: rigid"
    cg, mass = np.array(fields(place)[:3]), fields(place)[3]
    assert mass == 0.210
    spherical = [1526e-7, 0, 0, 1526e-7, 0, 1526e-7]
    assert fields(inertia) == pytest.approx(spherical, rel=1e-6, abs=1e-12)
    velocity, spin = np.array(fields(motion)[:3]), np.array(fields(motion)[3:])
    assert np.linalg.norm(velocity) == pytest.approx(35.0, rel=1e-6)
    assert np.linalg.norm(spin) == pytest.approx(np.radians(2400), rel=1e-6)
    # The face meets the ball at the origin, with its normal along x, and moves towards it.
    nodes, quads = deck.nodes(), deck.elements("ELEMENT_SHELL")
    corners = nodes[quads[:, 2:] - 1]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0])
    nearest = np.argmin(np.linalg.norm(corners.mean(axis=1), axis=1))
    assert abs(normals[nearest, 0]) / np.linalg.norm(normals[nearest]) == pytest.approx(1.0, abs=1e-3)
    assert corners[nearest].mean(axis=0) == pytest.approx([-0.5 * keyword.SHELL, 0, 0], abs=2e-3)
    assert (velocity + np.cross(spin, -cg))[0] > 30.0
    assert (normals @ normals[nearest] > 0.0).all()
    # Viscous rubber and cover.
    core = deck.one("MAT_HYPERELASTIC_RUBBER")
    rubber = given.ball.pieces[0].material
    (branch,) = rubber.maxwell
    assert fields(core[1]) == [rubber.constants["c10"], rubber.constants["c01"]]
    assert fields(core[2]) == pytest.approx([branch.modulus * rubber.shear, 1 / branch.time], rel=1e-6)
    cover = fields(deck.one("MAT_VISCOELASTIC")[0])
    plastic = given.ball.pieces[1].material
    assert cover[3] == pytest.approx((1 + plastic.maxwell[0].modulus) * cover[4], rel=1e-6)
    assert fields(deck.one("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE")[1]) == [given.friction, given.friction]


def test_the_deck_of_ogdens_rubber_holds_its_terms(tmp_path):
    given = throw_case()
    core, cover = given.ball.pieces
    terms = {"mu1": 8e6, "alpha1": 2.0, "mu2": -2e6, "alpha2": -2.0}
    branch = fem.Maxwell(modulus=0.5, time=1e-5)
    rubber = fem.Material(law="ogden", constants=terms, poisson=0.49, density=1150.0, maxwell=(branch,))
    ball = replace(given.ball, pieces=(replace(core, material=rubber), cover))
    deck = Deck(keyword.write(given.replace(ball=ball), tmp_path / "ogden.k"))
    head, mus, alphas, viscous = deck.one("MAT_OGDEN_RUBBER")
    assert fields(head)[2:] == [0.49, 0, 1]
    assert (fields(mus), fields(alphas)) == ([8e6, -2e6], [2.0, -2.0])
    # Half the sum of mu alpha is 10 MPa.
    assert fields(viscous) == pytest.approx([5e6, 1e5])


def test_the_deck_of_neo_hookean_rubber_holds_half_its_shear_modulus_as_c10(tmp_path):
    """The card's energy is C10 (I1 - 3) + C01 (I2 - 3), so its shear modulus 2 (C10 + C01) is that of the law."""
    given = throw_case()
    core, cover = given.ball.pieces
    rubber = fem.Material(law="neo-hookean", constants={"shear": 9e6}, poisson=0.49, density=1150.0)
    ball = replace(given.ball, pieces=(replace(core, material=rubber), cover))
    deck = Deck(keyword.write(given.replace(ball=ball), tmp_path / "neo.k"))
    head, constants = deck.one("MAT_HYPERELASTIC_RUBBER")
    assert fields(head)[2:] == [0.49, 0, 0]
    assert fields(constants) == [4.5e6, 0.0]
    assert 2.0 * sum(fields(constants)) == rubber.shear


def test_the_deck_of_a_head_of_shells_holds_its_mass_and_motion(tmp_path):
    given, head = shells_case().replace(toe="8 mm", closure="2400 deg/s"), coarse_head()
    deck = Deck(keyword.write(given, tmp_path / "shells.k"))
    lines = deck.one("ELEMENT_SHELL_THICKNESS")
    quads = np.array([[int(line[at : at + 8]) for at in range(0, 48, 8)] for line in lines[::2]])
    walls = np.array([[float(line[at : at + 16]) for at in range(0, 64, 16)] for line in lines[1::2]])
    nodes = deck.nodes()
    a, b, c, d = (nodes[quads[:, corner] - 1] for corner in (2, 3, 4, 5))
    areas = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)
    masses = np.zeros(len(nodes))
    for corner in range(2, 6):
        np.add.at(masses, quads[:, corner] - 1, 0.25 * 4430.0 * areas * walls[:, 0])
    for line in deck.one("ELEMENT_MASS"):
        masses[int(line[8:16]) - 1] += float(line[16:32])
    # Nine digits of every coordinate.
    assert masses.sum() == pytest.approx(head.club.mass, rel=1e-6)
    velocities = np.array([fields(line) for line in deck.one("INITIAL_VELOCITY_NODE")])
    on_head = velocities[:, 0].astype(int) - 1
    mean = masses[on_head] @ velocities[:, 1:4] / masses.sum()
    # The speed is that of the CG.
    assert np.linalg.norm(mean) == pytest.approx(35.0, rel=1e-5)
    assert np.linalg.norm(velocities[0, 4:]) == pytest.approx(np.radians(2400), rel=1e-6)
    first = int(quads[:, 2:].min()) - 1
    assert (nodes[:first, 0] > -1e-9).all()
    assert (nodes[first:, 0] < 2e-3).all()


def test_shells_of_a_deck_have_the_points_of_their_metal(tmp_path):
    part = replace(coarse_head().parts[0], metal=fem.Metal(yield_stress="900 MPa", points=7, rule="lobatto"))
    head = replace(coarse_head(), parts=(part, *coarse_head().parts[1:]))
    deck = Deck(keyword.write(shells_case().replace(club=head), tmp_path / "points.k"))
    rule, *points = map(fields, deck.one("INTEGRATION_SHELL"))
    assert rule[:2] == [2, 7]
    places, weights = np.array(points).T
    assert (places[0], places[-1]) == (-1.0, 1.0)
    for power in (0, 2, 4, 10):
        # Lobatto's rule is exact for these; a card has eight digits.
        assert weights @ places**power == pytest.approx(1.0 / (power + 1.0), abs=1e-7)
    sections = [fields(cards[0]) for cards in deck.all("SECTION_SHELL")]
    assert [(section[0], section[3], section[5]) for section in sections][:2] == [(2, 7, -2), (3, 5, 0)]
    parts = [fields(cards[1]) for cards in deck.all("PART")]
    assert [each[1] for each in parts if each[0] >= keyword.HEAD_PART] == [section[0] for section in sections]


def test_a_head_that_moves_away_gives_no_deck(tmp_path):
    given = case("paper").replace(attack="89 deg", face="80 deg")
    with pytest.raises(InputError):
        keyword.write(given.replace(path="-89 deg", attack="0 deg"), tmp_path / "away.k")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("value", [0.0, 1.0, -1.0, 1e-300, -1.2345678901e-5, 123456789.123, -0.000123456789, 7e22, 3])
def test_a_field_is_ten_characters_and_close(value):
    text = keyword.field(value)
    assert len(text) == 10
    assert float(text) == pytest.approx(value, rel=1e-4)


def test_every_piece_of_the_ball_is_a_part_of_its_own_set_with_its_section_and_material(reference_deck):
    given, deck = reference_deck
    parts = [fields(cards[1]) for cards in deck.all("PART")]
    # Part, section, material, equation of state, hourglass control.
    assert parts == [[number, 1, number, 0, 1] for number in range(1, len(given.ball.pieces) + 1)]
    identifier, members = deck.one("SET_PART_LIST")
    assert fields(identifier) == [keyword.BALL_SET]
    assert fields(members) == [part[0] for part in parts]


def test_a_deck_of_a_grooved_head_notes_what_it_leaves_out(tmp_path):
    grooves = {"width": 0.9e-3, "depth": 0.4e-3, "pitch": 3.6e-3, "wall": 0.2e-3}
    head = replace(fem.head("7-iron"), grooves=grooves)
    message = "grooves act in the contact only"
    for name, made in (("grooved", head), ("plain", replace(head, grooves=None))):
        text = keyword.write(shells_case().replace(club=made), tmp_path / f"{name}.k").read_text()
        assert (message in " ".join(line[2:] for line in text.splitlines() if line.startswith("$ "))) == (
            name == "grooved"
        )


CONSTANTS = {
    "mooney-rivlin": {"c10": 4e6, "c01": 1e6}, "neo-hookean": {"shear": 9e6}, "linear": {"shear": 1e8},
    "ogden": {"mu1": 8e6, "alpha1": 2.0},
}  # fmt: skip


@pytest.mark.parametrize("law", list(laws()))
def test_every_law_has_one_card_for_any_number_of_branches(law, tmp_path):
    given = throw_case()
    for count in range(5):
        branches = tuple(fem.Maxwell(modulus=0.1 * number, time=1e-5 * number) for number in range(1, count + 1))
        made = fem.Material(law=law, constants=CONSTANTS[law], poisson=0.49, density=1150.0, maxwell=branches)
        ball = replace(given.ball, pieces=(replace(given.ball.pieces[0], material=made), given.ball.pieces[1]))
        text = keyword.write(given.replace(ball=ball), tmp_path / f"{count}.k").read_text()
        card = text.partition("\n*MAT_")[2].partition("\n*")[0]
        lines = [line for line in card.splitlines()[1:] if not line.startswith("$")]
        values = [value for line in lines for value in fields(line) if value is not None]
        for each in branches:
            assert 1.0 / each.time == pytest.approx(
                min(values, key=lambda value: abs(value * each.time - 1.0)), rel=1e-6
            )
