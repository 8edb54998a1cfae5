"""``--report``: the file has the numbers that the command prints and writes, and says what they are of."""

import html
import re

import pytest

from study_files import shots

pytest.importorskip("matplotlib")

SPEED = ("--speed", "105 mph")
COMMANDS = {
    "compare": ("compare", "driver", "3-wood", *SPEED, "--air", "altitude=1000 m"),
    "map": ("map", "driver", *SPEED, "--grid", "9x7", "--spread", "12 mm x 9 mm", "--altitude", "1000 m"),
    "dispersion": ("dispersion", "tour-driver", "--count", "256", "--hole", "430 yd", "--altitude", "1000 m"),
    "best-loft": ("best-loft", "--speed", "90 mph,110 mph", "--altitude", "1000 m"),
}


@pytest.mark.usefixtures("without_pictures")
@pytest.mark.parametrize("name", COMMANDS)
def test_the_report_has_every_number_that_is_printed_what_went_in_and_where_it_comes_from(clubface_, tmp_path, name):
    ran = clubface_(*COMMANDS[name], "--report", str(tmp_path / "report.html"))
    assert ran.status == 0
    assert f"wrote {tmp_path / 'report.html'}" in ran.err
    text = html.unescape(re.sub(r"<[^>]+>", " ", (tmp_path / "report.html").read_text()))
    numbers = re.findall(r"(?<![\w.])-?\d+\.\d+(?![\w.])", ran.out)
    assert len(numbers) > 40
    assert not {each for each in numbers if each not in text}
    assert "1000 m" in text
    assert "Computed by clubface" in text
    assert "Table 1 of" in text  # the source of the driver's values
    if name == "dispersion":
        assert "256" in text


def test_an_optimum_and_a_study_are_reported_as_they_are_printed(clubface_, tmp_path):
    (tmp_path / "best.toml").write_text(
        'title = "A short study"\nclub = "driver"\ngolfer = "bogey-driver"\nobjective = "carry"\n'
        'shots = 32\nstarts = 2\n[variables]\nloft = ["8 deg", "16 deg"]\n'
    )
    shots(tmp_path, name="sweep.toml")
    assert clubface_("study", "run", str(tmp_path / "sweep.toml"), "--workers", "1").status == 0
    for command in (("optimise", "best.toml"), ("study", "summary", "sweep.toml")):
        target = tmp_path / "report.html"
        ran = clubface_(*command[:-1], str(tmp_path / command[-1]), "--report", str(target))
        assert ran.status == 0, ran.err
        page = target.read_text()
        text = html.unescape(re.sub(r"<[^>]+>", " ", page))
        numbers = re.findall(r"(?<![\w.])-?\d+\.\d+(?![\w.])", ran.out)
        assert len(numbers) > 10
        assert not {each for each in numbers if each not in text}
        assert "Computed by clubface" in text
        assert page.count("<img") == 1
