"""What is wrong with a head: told with the file, the line, the key, the value and what is allowed."""

import os
import signal

import pytest

from clubface import fem
from clubface.errors import FileError
from clubface.fem import head_tests
from clubface.fem.case import case
from clubface.support.files import builtin_path
from fem_meshes import HEAD, write_mesh
from fem_runs import coarse


def head_file(folder, name, old, new):
    """Write a built-in head with one thing changed; return its path."""
    text = builtin_path("head", name, "fem_heads").read_text()
    assert old in text
    path = folder / "head.toml"
    path.write_text(text.replace(old, new, 1))
    return path


BLADE = "[shape]\n"
GROOVED = '[grooves]\nwidth = "0.9 mm"\ndepth = "1.5 mm"\npitch = "3.6 mm"\nwall = "0.3 mm"\n\n[shape]\n'
THIN = {'face = "4 mm"': 'face = "1.5 mm"', 'top = "9 mm"': 'top = "1.2 mm"'}


@pytest.mark.parametrize(
    ("name", "old", "new", "message"),
    [
        ("paper", '"1.85 mm"', '"0 mm"', ":22: thickness.face_centre: 0 mm; it must be 0.2 to 20 mm"),
        ("paper", 'crown = "1.3 mm"', 'crown = "1 kg"', ":24: thickness.crown is '1 kg'; it must be in m or mm"),
        ("paper", 'crown = "25 mm"', 'crown = "1 mm"', ":17: shape.crown is '1 mm'; it must be 8 to 60 mm"),
        ("paper", 'mass = "210 g"', "mass = 210", ":34: target.mass is '210000 g'; it must be 50 to 500 g"),
        ("paper", 'x = "-8 mm"', "x = -8", ":48: x of trim sole front is '-8000 mm'; it must be within 300 mm"),
        ("paper", 'most = "60 g"', "most = 0", ":44: most of trim sole is '0 g'; it must be 0.01 to 500 g"),
        ("paper", "elements = [36, 12, 25]", "elements = 36", ":9: elements is 36; it must be a list of three numbers"),
        ("paper", 'kind = "driver"', "kind = []", ":7: unknown kind []; it must be one of driver, iron, mesh"),
        (
            "paper",
            "[metal]",
            '[metal]\nyield = "900 MPa"\nhardening = "1 mm"',
            ":30: metal.hardening is '1 mm'; it must be in Pa",
        ),
        (
            "paper",
            "[metal]",
            '[metal]\nyield = "900 MPa"\nhardening = { gain = -1, rate = 2 }',
            ":30: metal.hardening.gain is '-1e-06 MPa'; it must be zero or above",
        ),
        ("paper", 'name = "sole front"\n', "", ":46: these keys of [trims] are missing: name"),
        ("7-iron", 'face = "4 mm"', 'face = "0 mm"', ":13: shape.face is '0 mm'; it must be 1 to 20 mm"),
        ("7-iron", 'mass = "64 g"', "mass = 64", ":24: mass of mass hosel is '64000 g'; it must be 0 to 500 g"),
    ],
)
def test_an_error_in_a_head_names_line_and_key(tmp_path, name, old, new, message):
    path = head_file(tmp_path, name, old, new)
    with pytest.raises(FileError) as caught:
        fem.head(path)
    assert str(caught.value).startswith(f"{path}{message}")


@pytest.mark.parametrize(("wall", "message"), [("face", "shape.face is 1.5 mm"), ("top", "shape.top is 1.2 mm")])
def test_grooves_deeper_than_the_blade_is_thick_are_refused(tmp_path, wall, message):
    path = head_file(tmp_path, "7-iron", BLADE, GROOVED)
    old, new = next((old, new) for old, new in THIN.items() if old.startswith(wall))
    fem.head(path)
    path.write_text(path.read_text().replace(old, new))
    with pytest.raises(FileError) as caught:
        fem.head(path)
    message = f"{path}:10: grooves.depth is '1.5 mm'; it must be less than the blade's thickness; {message}"
    assert str(caught.value) == message


@pytest.mark.parametrize(
    ("unit", "scale", "message"),
    [
        ('unit = "mm"\n', 1.0, ":4: unit is 'mm'"),
        ("", 1.0, ": unit is 'mm'"),
        ('unit = "m"\n', 1e3, ":4: unit is 'm'"),
    ],
)
def test_a_mesh_in_another_unit_is_refused_with_its_size_and_the_unit_to_set(tmp_path, write, unit, scale, message):
    write_mesh(tmp_path, scale=1e-3 * scale)
    path = write(HEAD.replace('unit = "mm"\n', unit), "own.toml")
    with pytest.raises(FileError) as caught:
        fem.head(path)
    assert str(caught.value).startswith(f"{path}{message}")
    size = "0.102493 mm" if scale == 1.0 else "102493 mm"
    assert all(part in str(caught.value) for part in (str(tmp_path / "head.msh"), size, "60 mm to 200 mm"))
    fitting = 'unit = "m"' if scale == 1.0 else 'unit = "mm"'
    assert str(caught.value).endswith(f"try {fitting}")


def test_bad_elements_are_named_with_their_mesh_and_head(tmp_path):
    mesh = write_mesh(tmp_path, change=lambda quad: [quad[each] for each in (0, 2, 1, 3)])
    (tmp_path / "own.toml").write_text(HEAD)
    text = 'name = "x"\nball = "reference"\n[head]\nkind = "meshed"\nclub = "./own.toml"\n[delivery]\nspeed = 35\n'
    (tmp_path / "case.toml").write_text(text)
    with pytest.raises(FileError) as caught:
        case(tmp_path / "case.toml")
    assert str(caught.value).startswith(f"{tmp_path / 'own.toml'}:3: {mesh}: element 1 is inverted or degenerate")


@pytest.mark.parametrize("content", ["nonsense", "", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\nfoo\n"])
def test_a_broken_mesh_gives_no_message_of_a_library(tmp_path, capfd, content):
    mesh, path = tmp_path / "head.msh", tmp_path / "own.toml"
    mesh.write_text(content)
    path.write_text(HEAD)
    with pytest.raises(FileError) as caught:
        fem.head(path)
    assert str(caught.value).startswith(f"{path}:3: {mesh}: this mesh cannot be read: ")
    assert len(str(caught.value).splitlines()) == 1
    assert not str(caught.value).endswith((": 1", ": "))
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("measure", [head_tests.restitution, head_tests.characteristic_time])
def test_ctrl_c_while_a_head_is_measured_is_no_mistake(tmp_path, measure):
    path = head_file(tmp_path, "paper", "[36, 12, 25]", "[14, 8, 10]")
    how = {"ball": coarse("modern")} if measure is head_tests.restitution else {}
    pressed = []

    def press(time, whole):
        if not pressed:
            pressed.append(time)
            os.kill(os.getpid(), signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        measure(fem.head(path), progress=press, **how)
    assert pressed
