"""Every notebook runs in a kernel, prints what it holds, and what it says in words is true of its numbers."""

import base64
import re
from functools import cache
from pathlib import Path

import pytest

from script_files import load_script

nbformat = pytest.importorskip("nbformat")
for needed in ("nbclient", "ipykernel", "matplotlib", "scipy"):
    pytest.importorskip(needed)

ROOT = Path(__file__).parent.parent
FOLDER = ROOT / "notebooks"
NAMES = sorted(path.stem for path in FOLDER.glob("*.ipynb"))
LARGEST = 200_000
"""Bytes of a notebook with its pictures."""


run = load_script("notebooks/run.py")


def stored(name):
    return nbformat.read(FOLDER / f"{name}.ipynb", as_version=4)


@cache
def ran(name):
    if "import jax" in (FOLDER / f"{name}.ipynb").read_text(encoding="utf-8"):
        pytest.importorskip("jax", reason="the extra jax is not installed")
    return run.executed(FOLDER / f"{name}.ipynb")


def printed(name):
    return "".join(run.texts(cell) for cell in ran(name).cells if cell.cell_type == "code")


def numbers(name, pattern):
    """The numbers that the groups of a pattern match in what a notebook prints, row by row."""
    result = re.findall(pattern, printed(name))
    assert result, pattern
    return [tuple(map(float, row if isinstance(row, tuple) else (row,))) for row in result]


LONG = {"from-torques-to-carry"}
"""Notebooks that take a minute of processor time; `make study` runs them."""


@pytest.mark.parametrize("name", [pytest.param(each, marks=[pytest.mark.study] * (each in LONG)) for each in NAMES])
def test_a_notebook_prints_what_it_holds(name):
    assert run.differences(stored(name), ran(name)) == []


def test_gear_effect_turns_the_ball_against_the_head_and_bulge_starts_it_to_the_right():
    ((sidespin,),) = numbers("gear-effect-and-bulge", r"sidespin (-?\d+) rpm")
    ((turn,),) = numbers("gear-effect-and-bulge", r"the head turns by (-?\d+)")
    assert sidespin < 0.0  # to the left from the toe
    assert turn < 0.0  # clockwise from above, while the ball turns the other way
    flat, usual, strong = numbers("gear-effect-and-bulge", r"a toe hit lands ([+-]\d+) yd, a heel hit ([+-]\d+)")
    assert flat[0] < 0.0 < flat[1]
    assert strong[1] < usual[1] < 0.0 < usual[0] < strong[0]
    published, nearer = numbers("gear-effect-and-bulge", r"best bulge (\d+) mm")
    assert nearer > published


def test_friction_turns_round_and_its_impulses_make_the_launch():
    ((most, last),) = numbers("how-spin-is-made", r"backspin (\d+) rpm at most, (\d+) rpm")
    assert last < most
    ((lasts,),) = numbers("how-spin-is-made", r"the contact lasts (\d+) us")
    for (turns,) in numbers("how-spin-is-made", r"friction turns round after (\d+) us\n"):
        assert 0.4 * lasts < turns < 0.8 * lasts
    ((gave, took, part),) = numbers("how-spin-is-made", r"gave ([\d.]+) N s and took back ([\d.]+) N s, (\d+) %")
    assert part == pytest.approx(100.0 * took / gave, abs=0.6)
    ((forces, launch),) = numbers("how-spin-is-made", r"from the forces ([\d.]+) m/s, from the launch ([\d.]+)")
    # The normals of the face under the nodes differ a little: up to 0.9 % on a curved face, less on this flat one.
    assert forces == pytest.approx(launch, rel=0.005)
    ((first, second),) = numbers("how-spin-is-made", r"f' = ([\d.]+), f = ([\d.]+)")
    assert second == pytest.approx(7.0 * first / (5.0 * first + 2.0), abs=1e-3)
    assert numbers("how-spin-is-made", r"f' by hand ([\d.]+)") == [(pytest.approx(first, abs=2e-3),)]
    spins = dict(
        re.findall(r"^(finite elements|response|standard|rings) +(\d+) rpm", printed("how-spin-is-made"), re.M)
    )
    # At the same friction, of which the regression knows the spin to 3%.
    assert float(spins["response"]) == pytest.approx(last, rel=0.03)
    ((own, rolls),) = zip(*numbers("how-spin-is-made", r"(?m)^(?:finite elements|standard) +(-?[\d.]+)$"), strict=True)
    # The standard model rolls; a head that turns by less than a degree leaves a hundredth.
    assert own > 0.0 == pytest.approx(rolls, abs=0.01)
    ratios = numbers("how-spin-is-made", r"friction is ([+-][\d.]+) of the normal force")
    # It slips at first, grips later, and turns round.
    assert 0.095 < ratios[0][0] <= 0.1 > ratios[1][0] > 0.0 > ratios[2][0]


def test_ones_own_law_keeps_momentum_and_energy_and_equals_the_built_in_one():
    text = printed("your-own-contact-law")
    assert "momentum is kept: True" in text
    assert "the account closes: True" in text
    assert text.count("   equal\n") == 4
    assert "DIFFERENT" not in text
    ((lost, normal, friction),) = numbers(
        "your-own-contact-law", r"([\d.]+) J less afterwards:\n([\d.]+) J went into the ball, ([\d.]+) J"
    )
    assert lost == pytest.approx(normal + friction, abs=0.16)
    rows = numbers("your-own-contact-law", r" ([\d.]+) +([\d.]+) mph +(\d+) rpm +(\d+) us +([\d.]+) kN")
    speeds, peaks = [row[1] for row in rows], [row[4] for row in rows]
    assert max(speeds) - min(speeds) < 1.0
    assert peaks == sorted(peaks)


@pytest.mark.study
def test_timing_gains_carry_and_stiffness_changes_loft_more_than_speed():
    text = printed("from-torques-to-carry")
    assert text.count("agrees to a part in 10,000: True") == 3
    ((before, after),) = numbers("from-torques-to-carry", r"carry from ([\d.]+) to ([\d.]+) m")
    assert after > before + 1.0
    rows = numbers(
        "from-torques-to-carry",
        r"stiffness +(\d+) %: ([\d.]+) m/s, loft +([\d.]+), attack +([+-][\d.]+) deg, carry ([\d.]+)",
    )
    for golfer in (rows[:4], rows[4:8], rows[8:]):
        assert len(golfer) == 4
        speeds, lofts = [row[1] for row in golfer], [row[2] for row in golfer]
        assert speeds == sorted(speeds, reverse=True)
        assert speeds[0] - speeds[-1] < 0.04 * speeds[0]
        assert lofts[0] > lofts[-1]
    ((attached, free),) = numbers("from-torques-to-carry", r"([\d.]+) m/s on the shaft, ([\d.]+) m/s with a free head")
    assert 0.0 < attached - free < 0.02 * free


def test_a_design_stays_within_the_rules_and_its_parts_add_up():
    text = printed("a-design")
    assert "there and back: True" in text
    assert "TOO MUCH" not in text
    ((whole,),) = numbers("a-design", r"it lands ([+-][\d.]+) yd")
    ((together,),) = numbers("a-design", r"all parts together ([+-][\d.]+) yd")
    assert together == pytest.approx(whole, abs=0.011)
    parts = dict(re.findall(r"^(cg_x|iyy) +([+-][\d.]+) yd", text, re.M))
    assert float(parts["cg_x"]) < 0.0 < float(parts["iyy"])
    spots = dict(re.findall(r"^(toe|heel) +([+-][\d.]+) toe", text, re.M))
    assert float(spots["heel"]) < float(spots["toe"])


def test_a_fitting_finds_the_golfer_and_the_loft():
    errors = numbers("a-fitting", r": ([+-][\d.]+) standard errors")
    assert len(errors) == 7
    assert all(abs(error) < 3.0 for (error,) in errors)
    for measured, spread, model, other in numbers(
        "a-fitting", r"measured +(-?[\d.]+) ± +([\d.]+) yd, model +(-?[\d.]+) ± +([\d.]+)"
    ):
        assert model == pytest.approx(measured, abs=3.0 * spread / 60**0.5)
        assert other == pytest.approx(spread, rel=0.3)  # three standard errors of a spread of 60 shots
    carries = [carry for carry, _ in numbers("a-fitting", r"deg +([\d.]+) yd +([\d.]+) yd")]
    best = carries.index(max(carries))
    assert carries[: best + 1] == sorted(carries[: best + 1])
    assert carries[best] - carries[best - 1] < 1.0 < carries[1] - carries[0]  # flat where it is best


def test_the_session_of_the_fitting_is_that_of_its_golfer(tmp_path):
    load_script("notebooks/session.py").main(tmp_path / "session.csv")
    again, kept = (path.read_text().splitlines() for path in (tmp_path / "session.csv", FOLDER / "session.csv"))
    assert len(again) == len(kept)
    assert all(map(run.agree, again, kept))


@pytest.mark.parametrize("name", NAMES)
def test_a_notebook_is_small_and_tells_nothing_of_the_machine(name):
    text = (FOLDER / f"{name}.ipynb").read_text(encoding="utf-8")
    assert len(text) < LARGEST
    assert not re.search(r"/(?:home|tmp|work|root|Users)/|ipykernel_|\"execution\"|<Figure|Warning", text)
    pictures = run.pictures(stored(name))
    assert pictures
    assert all(base64.b64decode(each).startswith(b"\x89PNG") for each in pictures)
    assert all(output.output_type != "error" for cell in stored(name).cells for output in cell.get("outputs", ()))


def test_every_notebook_has_a_page_that_the_index_names():
    index = (ROOT / "docs" / "notebooks.md").read_text(encoding="utf-8")
    for name in NAMES:
        assert (ROOT / "docs" / "notebooks" / f"{name}.md").exists()
        assert index.count(f"notebooks/{name}") == 2  # the list and the table of contents


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("5971 rpm", "5972 rpm", True),
        ("0.934", "0.935", True),
        ("0.934", "0.944", False),
        ("-31 yd", "+31 yd", False),
        ("equal", "DIFFERENT", False),
        ("1.0 2.0", "1.0", False),
        ("5971 rpm", "6071 rpm", False),
    ],
)
def test_another_number_or_word_is_seen(one, other, same):
    assert run.agree(one, other) is same


def test_a_cell_that_prints_something_else_or_draws_nothing_is_found():
    name = "gear-effect-and-bulge"
    changed = ran(name).copy()
    changed = nbformat.from_dict(changed)
    place = next(i for i, cell in enumerate(changed.cells) if cell.get("outputs"))
    drawn = next(i for i, cell in enumerate(changed.cells) if run.pictures(nbformat.v4.new_notebook(cells=[cell])))
    changed.cells[place].outputs[0].text = changed.cells[place].outputs[0].text.replace("-", "+")
    changed.cells[drawn].outputs = [each for each in changed.cells[drawn].outputs if each.output_type == "stream"]
    assert len(run.differences(stored(name), changed)) == 2
