"""Every number that ``clubface fem`` prints is the run's, in the unit printed beside it."""

import math
import re

import pytest

import clubface
from fem_runs import write_case

pytest.importorskip("typer")

RPM, DEG = math.pi / 30.0, math.pi / 180.0
# What stands in a line, by the key of the JSON document, with the size of the unit and the digits printed.
LAUNCH = {
    "ball speed, mph": ("ball_speed", 0.44704, 1),
    "launch angle, deg": ("launch", DEG, 2),
    "azimuth, deg": ("azimuth", DEG, 2),
    "backspin, rpm": ("backspin", RPM, 0),
    "sidespin, rpm": ("sidespin", RPM, 0),
    "spin axis, deg": ("spin_axis", DEG, 1),
    "carry, yd": ("carry", 0.9144, 1),
    "side, yd": ("side", 0.9144, 1),
    "apex, yd": ("apex", 0.9144, 1),
}
REBOUND = {
    "velocity off the plane, m/s": ("normal_velocity", 1.0, 2),
    "velocity along it, m/s": ("tangential_velocity", 1.0, 2),
    "backspin, rpm": ("backspin", RPM, 0),
}
CONTACT = {
    "peak force, N": ("peak_force", 1.0, 0),
    "at, us": ("peak_force_time", 1e-6, 0),
    "contact, us": ("contact_time", 1e-6, 0),
    "largest tangential force, N": ("tangential_max", 1.0, 0),
    "smallest tangential force, N": ("tangential_min", 1.0, 0),
    "reversal, us": ("reversal_time", 1e-6, 0),
    "largest spin on the way, rpm": ("spin_max", RPM, 0),
    "contraction, %": ("contraction", 0.01, 1),
    "at, us (of the contraction)": ("contraction_time", 1e-6, 0),
    "f'": ("f_prime", 1.0, 4),
    "f": ("f", 1.0, 4),
}
PAPER = {
    "ball speed, m/s": ("ball_speed_mps", 1.0, 1),
    "ball speed, mph": ("ball_speed_mps", 0.44704, 1),
    "launch angle, deg": ("launch_deg", 1.0, 1),
    "club speed after, m/s": ("club_speed_after_mps", 1.0, 1),
    "club speed after, mph": ("club_speed_after_mps", 0.44704, 1),
    "spin of the launch, rpm": ("spin_rpm", 1.0, 0),
    "spin of all nodes at take-off, rpm": ("ball_spin_rpm", 1.0, 0),
    "spin of a section's nodes at take-off, rpm": ("section_spin_rpm", 1.0, 0),
    "spin if it rolled off, rpm": ("rolling_spin_rpm", 1.0, 0),
    "velocity along the face at first, m/s": ("tangential_first_mps", 1.0, 2),
    "least of it, m/s": ("tangential_least_mps", 1.0, 2),
    "at, us": ("tangential_least_time_s", 1e-6, 0),
    "at take-off, m/s": ("tangential_last_mps", 1.0, 2),
    "peak force, N": ("peak_force_n", 1.0, 0),
    "at, us (of the peak)": ("peak_force_time_s", 1e-6, 0),
    "reversal, us": ("reversal_time_s", 1e-6, 0),
    "contraction, %": ("contraction", 0.01, 1),
    "at, us (of the contraction)": ("contraction_time_s", 1e-6, 0),
    "f'": ("f_prime", 1.0, 4),
    "f": ("f", 1.0, 4),
}
REFERENCE = {
    "normal rebound, m/s": ("normal_mps", 1.0, 2),
    "tangential rebound, m/s": ("tangential_mps", 1.0, 2),
    "spin, rpm": ("spin_rpm", 1.0, 0),
    "largest spin, rpm": ("spin_max_rpm", 1.0, 0),
    "peak force, N": ("peak_force_n", 1.0, 0),
    "at, us": ("peak_force_time_s", 1e-6, 0),
    "contact, us": ("contact_time_s", 1e-6, 0),
    "largest tangential force, N": ("tangential_max_n", 1.0, 0),
    "smallest tangential force, N": ("tangential_min_n", 1.0, 0),
    "reversal, us": ("reversal_time_s", 1e-6, 0),
}
REFERENCE_SI = {
    "normal_mps": "normal_velocity", "tangential_mps": "tangential_velocity", "peak_force_n": "peak_force",
    "peak_force_time_s": "peak_force_time", "contact_time_s": "contact_time", "tangential_max_n": "tangential_max",
    "tangential_min_n": "tangential_min", "reversal_time_s": "reversal_time",
}  # fmt: skip
"""Of the attributes of a run, those in SI."""


def assert_printed(out, document, rows, column=-1):
    """The lines below the rule are ``rows``, in that order; the number in ``column`` is that of the document."""
    lines = out.split("─\n")[1].splitlines()[: len(rows)]
    for line, (label, (key, unit, digits)) in zip(lines, rows.items(), strict=True):
        assert line.startswith(label.partition(" (")[0]), line
        # The number is rounded to the digits printed.
        told = float(line.split()[column])
        assert told == pytest.approx(document[key] / unit, abs=0.5001 * 10.0**-digits), line


def test_a_run_prints_its_rebound_and_its_contact(clubface_, tmp_path):
    path = write_case(tmp_path, duration=1000)
    document = clubface_("fem", "run", str(path), "--json").json
    assert_printed(clubface_("fem", "run", str(path)).out, document, REBOUND | CONTACT)


def test_a_run_with_a_head_prints_its_launch_with_the_signs_of_a_golfer(clubface_, tmp_path):
    path = write_case(tmp_path, duration=1000, old='kind = "plane"', new='kind = "rigid"\nclub = "driver"')
    path.write_text(path.read_text().replace("angle =", 'toe = "12 mm"\nloft ='))
    document = clubface_("fem", "run", str(path), "--json").json
    assert_printed(clubface_("fem", "run", str(path)).out, document, LAUNCH | CONTACT)
    # A ball hit towards the toe of a driver starts to the right and turns to the left.
    assert document["azimuth"] > 0.0 > document["sidespin"]
    terms = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")
    flown = clubface.fly({**{name: document[name] for name in terms}, "ball_mass": 0.046, "ball_radius": 0.0214})
    # A monitor's terms leave out the spin about the direction of launch, some per cent of it here.
    assert document["carry"] == pytest.approx(flown.carry, rel=5e-3)
    assert document["side"] == pytest.approx(flown.side, rel=0.1)
    assert document["apex"] == pytest.approx(flown.apex, rel=5e-3)


def test_the_paper_prints_a_column_a_method_and_the_reference_one(clubface_, tmp_path):
    path = write_case(tmp_path, duration=1000, old='kind = "plane"', new='kind = "rigid"\nclub = "driver"')
    path.write_text(path.read_text().replace("angle =", "loft ="))
    document = clubface_("fem", "paper", "--case", str(path), "--json").json
    out = clubface_("fem", "paper", "--case", str(path)).out
    for column, method in ((-2, "penalty"), (-1, "augmented-lagrange")):
        assert_printed(out, document["by_contact"][method], PAPER, column)
    ball = str(tmp_path / "ball.toml")
    document = clubface_("fem", "reference", "--ball", ball, "--json").json
    assert_printed(clubface_("fem", "reference", "--ball", ball).out, document, REFERENCE)


def test_the_document_of_the_reference_case_is_that_of_its_run(clubface_, tmp_path):
    from clubface import fem

    write_case(tmp_path)
    ball = str(tmp_path / "ball.toml")
    document = clubface_("fem", "reference", "--ball", ball, "--json").json
    run = fem.reference(which=ball)
    assert {key: document[key] for key in REFERENCE_SI} == {
        key: getattr(run, name) for key, name in REFERENCE_SI.items()
    }
    for key, spin in (("spin_rpm", run.backspin), ("spin_max_rpm", run.spin_max)):
        assert document[key] == pytest.approx(spin / RPM, rel=1e-12), key  # a conversion rounds two or three times


SWEEP = (
    ("speed_mps", 1.0, 1), ("speed_mps", 0.44704, 1), ("loft_deg", 1.0, 1), ("ball_speed_mps", 1.0, 1),
    ("ball_speed_mps", 0.44704, 1), ("launch_deg", 1.0, 2), ("spin_rpm", 1.0, 0), ("club_speed_after_mps", 1.0, 1),
    ("club_speed_after_mps", 0.44704, 1), ("peak_force_n", 1.0, 0), ("f", 1.0, 4),
)  # fmt: skip


def test_a_sweep_prints_a_line_a_run(clubface_, tmp_path):
    path = write_case(tmp_path, duration=1000, old='kind = "plane"', new='kind = "rigid"\nclub = "driver"')
    path.write_text(path.read_text().replace("angle =", "loft ="))
    arguments = ("fem", "sweep", "--case", str(path), "--speed", "30,40", "--loft", "9")
    rows = clubface_(*arguments, "--json").json
    lines = clubface_(*arguments).out.split("─\n")[1].splitlines()
    for line, row in zip(lines, rows, strict=True):
        for cell, (key, unit, digits) in zip(line.split(), SWEEP, strict=True):
            assert float(cell) == pytest.approx(row[key] / unit, abs=0.5001 * 10.0**-digits), key
            assert len(cell.partition(".")[2]) == digits, key


def test_a_head_is_printed_in_grams_millimetres_and_gram_centimetres_squared(clubface_):
    document = clubface_("fem", "head", "paper", "--json").json
    lines = clubface_("fem", "head", "paper").out.split("─\n")[1].partition("* ")[0].splitlines()
    told = {re.split(r"  +", line)[0]: [float(each) for each in re.split(r"  +", line)[1:]] for line in lines}
    assert told["mass, g"] == pytest.approx([document["mass_kg"] * 1e3, 210.0], abs=0.005001)
    for axis, value in zip("xyz", document["cg_m"], strict=True):
        assert told[f"CG to face centre, {axis}, mm"][0] == pytest.approx(value * 1e3, abs=0.005001)
    for place, axis in enumerate("xyz"):
        moment = document["inertia_kgm2"][place][place] * 1e7
        assert told[f"I{axis}{axis}, g cm2"][0] == pytest.approx(moment, abs=0.5001)
    for name, mass in document["tuning"].items():
        if name != "scale":
            assert told[f"added mass {name}, g"] == pytest.approx([mass * 1e3], abs=0.05001)
    assert told["walls over design"] == pytest.approx([document["tuning"]["scale"]], abs=0.0005001)
