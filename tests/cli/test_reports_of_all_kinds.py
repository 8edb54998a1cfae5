"""Every command's report: hostile names stay text, nothing is loaded, all can be saved, sides are those of the shot."""

import base64
import csv
import html
import io
import re
from html.parser import HTMLParser
from itertools import pairwise

import numpy as np
import pytest

import clubface
from clubface.design.golfer_estimate import COUNT
from clubface.support.files import builtin_path
from fem_runs import write_case
from study_files import shots

pytest.importorskip("matplotlib")

HOSTILE = "<script>alert(1)</script> $x^{$ & [y](javascript:z) | `w`"
"""A name that runs in a page, is no formula, and would be a link, a cell or code in Markdown."""
SPEED = ("--speed", "95 mph")
LOFT = ("--loft", "14 deg")
VOID = {"meta", "img", "source", "br", "hr"}


def toml(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


@pytest.fixture
def files(tmp_path):
    """A club, a golfer, a fitting, a study, a case, a head and a player's shots, all of the hostile name."""
    head = clubface.club("driver").replace(name=HOSTILE, description=HOSTILE, sources={"mass": HOSTILE})
    (tmp_path / "club.toml").write_text(head.to_toml())
    player = builtin_path("golfer", "bogey-driver", "golfers").read_text()
    for line in ("title = .*", 'face = "assumed.*'):
        player = re.sub(f"^{line}$", lambda result: f"{result[0][:5].strip()} = {toml(HOSTILE)}", player, flags=re.M)
    (tmp_path / "golfer.toml").write_text(player)
    common = f'title = {toml(HOSTILE)}\ngolfer = "{tmp_path}/golfer.toml"\nobjective = "carry"\nshots = 64\n'
    (tmp_path / "fit.toml").write_text(common + f'[fit]\nclubs = ["{tmp_path}/club.toml", "driver"]\n')
    (tmp_path / "best.toml").write_text(
        common + f'club = "{tmp_path}/club.toml"\nstarts = 2\n[variables]\nloft = ["8 deg", "16 deg"]\n'
    )
    case = write_case(tmp_path, duration=1000, old='kind = "plane"', new='kind = "rigid"\nclub = "driver"')
    text = case.read_text().replace("angle =", "loft =")
    named = f'name = "case"\ndescription = {toml(HOSTILE)}'
    case.write_text(re.sub(r"^name = .*$", lambda _: named, text, count=1, flags=re.M))
    text = builtin_path("head", "7-iron", "fem_heads").read_text().replace("[32, 20, 2]", "[16, 10, 2]")
    text = re.sub(r"^description = .*$", lambda _: f"description = {toml(HOSTILE)}", text, flags=re.M)
    text += '\n[metal]\nyoungs = "200 GPa"\npoisson = 0.3\ndensity = "7800 kg/m3"\nyield = "300 MPa"\n'
    (tmp_path / "iron.toml").write_text(text)
    rows = ["club,player,ball_speed_mph,launch_deg,azimuth_deg,backspin_rpm,sidespin_rpm"]
    rows += [f'"{HOSTILE}","{HOSTILE}",{150 + i},13,1,2600,{100 - i}' for i in range(6)]
    (tmp_path / "session.csv").write_text("\n".join(rows) + "\n")
    delivered = clubface.golfer("bogey-driver").sample(60, seed=3)
    units = dict.fromkeys(("attack", "path", "loft", "face", "lie"), "rad") | {"speed": "mps"}
    lines = [",".join(f"{name}_{unit}" for name, unit in units.items())]
    lines += [",".join(f"{delivered[name][shot]:.9g}" for name in units) for shot in range(60)]
    (tmp_path / "shots.csv").write_text("\n".join(lines) + "\n")
    shots(tmp_path, name="sweep.toml")
    return tmp_path


COMMANDS = {
    "shot": ("shot", "club.toml", *SPEED, *LOFT, "--face", "2 deg"),
    "compare": ("compare", "club.toml", "3-wood", *SPEED, "--no-split"),
    "map": ("map", "club.toml", *SPEED, "--grid", "5x5"),
    "dispersion": ("dispersion", "golfer.toml", "--club", "club.toml", "--count", "64", "--no-shares"),
    "show": ("golfer", "show", "golfer.toml"),
    "estimate": ("golfer", "estimate", "shots.csv", "--club", "driver"),
    "best-loft": ("best-loft", "--club", "club.toml", *SPEED),
    "fit": ("optimise", "fit.toml"),
    "optimise": ("optimise", "best.toml"),
    "fem run": ("fem", "run", "case.toml"),
    "fem head": ("fem", "head", "iron.toml", "--ball", "ball.toml", "--meshes", "1", "--impact-speed", "38 m/s"),
    "study": ("study", "summary", "sweep.toml"),
    "monitor": ("monitor", "report", "session.csv"),
}
FLOWN = set(COMMANDS) - {"fem head"}
PAGE_ONLY = {"fem run", "fem head", "study", "estimate"}


class Page(HTMLParser):
    """What a page is made of."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.open, self.levels, self.alts, self.pictures = set(), [], [], [], []
        self.loaded, self.links, self.saved = [], [], {}
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.tags.add(tag)
        if tag not in VOID:
            self.open.append(tag)
        if re.fullmatch("h[1-6]", tag):
            self.levels.append(int(tag[1]))
        if tag == "img":
            self.alts.append(attributes["alt"])
            self.pictures.append(attributes["src"])
        self.loaded += [value for name, value in attrs if name in ("src", "srcset", "poster", "data")]
        if tag == "a":
            self.links.append(attributes["href"])
            if "download" in attributes:
                self.saved[attributes["download"]] = attributes["href"]
        assert not [name for name, _ in attrs if name.startswith("on")]

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


@pytest.fixture(params=COMMANDS)
def reported(request, clubface_, files, monkeypatch):
    """A command and its reports, page and Markdown; the latter not of what names nothing or takes long once more."""
    monkeypatch.chdir(files)
    if request.param == "study":
        assert clubface_("study", "run", "sweep.toml", "--workers", "1").status == 0
    option = "-o" if request.param == "monitor" else "--report"
    result = []
    for name in ("report.html", "report.md")[: 1 if request.param in PAGE_ONLY else 2]:
        ran = clubface_(*COMMANDS[request.param], option, name)
        assert ran.status == 0, ran.err
        assert f"wrote {name}" in ran.err
        result.append((files / name).read_text())
    return request.param, result[0], result[-1] if len(result) == 2 else ""


def test_a_report_is_safe_whole_offline_and_repeatable(reported):
    name, text, markdown = reported
    check_page(name, text, markdown)
    check_what_can_be_saved(text)
    check_inputs(name, text)
    if name == "estimate":
        words = first_paragraph(text)
        assert "60 shots of the session" in words[:60]
        assert "The swing-to-swing spread was measured or published for club speed" in words


def first_paragraph(text):
    return html.unescape(re.search(r"<p>(.*?)</p>", text)[1])


def check_page(name, text, markdown):
    """A whole page of text and pictures that loads nothing, whatever things are called."""
    page = Page(text)
    assert page.open == []
    assert "script" not in page.tags
    assert page.loaded == [each for each in page.loaded if each.startswith("data:image/svg+xml;base64,")]
    assert all(each.startswith(("data:", "https://")) for each in page.links)
    # One title, and no level of heading that is left out.
    assert page.levels[0] == 1
    assert page.levels.count(1) == 1
    assert all(later - before <= 1 for before, later in pairwise(page.levels))
    assert all(len(alt) > 20 for alt in page.alts)
    assert '<html lang="en">' in text
    if name not in ("study", "estimate"):
        assert "&lt;script&gt;alert(1)" in text
        plain = re.sub(r"(`{3,}).*?\n\1", "", markdown, flags=re.S)
        assert "<script" not in plain
        assert "](javascript" not in plain.replace("\\](javascript", "")


def check_what_can_be_saved(text):
    """The picture as SVG, its data as CSV, and every table."""
    page = Page(text)
    pictures = [each for name, each in page.saved.items() if name.endswith(".svg")]
    assert len(pictures) == len(page.alts) >= 1
    assert pictures == page.pictures
    for each in pictures:
        drawn = base64.b64decode(each.partition(",")[2]).decode()
        assert "<svg" in drawn
        assert "<script" not in drawn
    tables = {name: each for name, each in page.saved.items() if name.endswith(".csv")}
    assert {name.partition(".")[0] for name in page.saved if name.endswith(".svg")} <= {
        name.partition(".")[0] for name in tables
    }
    for each in tables.values():
        heads, *rows = csv.reader(io.StringIO(base64.b64decode(each.partition(",")[2]).decode()))
        assert rows
        assert all(len(row) == len(heads) for row in rows)


def check_inputs(name, text):
    """The command, the files that it read, and the conditions of flight."""
    words = html.unescape(re.sub(r"<[^>]+>", " ", text))
    assert f"Computed by clubface {clubface.__version__}" in words
    command = COMMANDS[name]
    assert re.search(rf"clubface {re.escape(' '.join(command[:2]))} ", words)
    for each in command:
        if each.endswith(".toml"):
            assert page_has_file(text, each)
    if name == "fit":
        assert page_has_file(text, "club.toml")
        assert page_has_file(text, "golfer.toml")
    for what in ("air", "wind", "ground"):
        assert (f"<td>{what}</td>" in text or f'<td class="text">{what}</td>' in text) == (name in FLOWN)


def page_has_file(text, name):
    import pathlib

    saved = Page(text).saved.get(name)
    return saved is not None and base64.b64decode(saved.partition(",")[2]).decode() == pathlib.Path(name).read_text()


def words_of(clubface_, target, *command):
    """The first paragraph of a report."""
    ran = clubface_(*command, "--report", str(target))
    assert ran.status == 0, ran.err
    return first_paragraph(target.read_text())


SWAPPED = {"right": "left", "left": "right"}


@pytest.mark.usefixtures("without_pictures")
@pytest.mark.parametrize(
    ("right", "left"),
    [
        (("shot", "driver", *SPEED, *LOFT, "--face", "2 deg", "--path", "-1 deg", "--toe", "9 mm"),
         ("shot", "driver", *SPEED, *LOFT, "--face", "-2 deg", "--path", "1 deg", "--toe", "9 mm", "--hand", "left")),
        (("map", "driver", *SPEED, *LOFT, "--grid", "5x5"),
         ("map", "driver", *SPEED, *LOFT, "--grid", "5x5", "--hand", "left")),
    ],
)  # fmt: skip
def test_the_words_of_a_left_handed_shot_swap_left_and_right(clubface_, tmp_path, right, left):
    one, other = (words_of(clubface_, tmp_path / "report.html", *command) for command in (right, left))
    assert re.search(r"\b(right|left)\b", one)
    assert "Club driver, left-handed, and ball modern" in (tmp_path / "report.html").read_text()
    assert other == re.sub(r"\b(right|left)\b", lambda each: SWAPPED[each[0]], one)


def test_the_report_of_a_golfer_says_what_is_assumed_and_what_rests_on_it(clubface_, tmp_path):
    """Face angles 30% wider: the shots that are hit with them spread as far as the report's data say."""
    words = words_of(clubface_, tmp_path / "report.html", "golfer", "show", "bogey-driver")
    assert "assumed for every part of the delivery" in words
    assert "depends most on the spread of face (assumed)" in words
    page = Page((tmp_path / "report.html").read_text())
    data = next(each for name, each in page.saved.items() if name == "doubts.csv")
    rows = {
        row["figure"]: row for row in csv.DictReader(io.StringIO(base64.b64decode(data.partition(",")[2]).decode()))
    }
    player = clubface.golfer("bogey-driver")
    wider = np.where(np.array(player.variables) == "face", 1.3, 1.0)
    wide = player.replace(covariance=player.covariance * np.outer(wider, wider))
    result = clubface.dispersion(wide, count=COUNT)
    assert float(rows["spread of face"]["side_spread_larger_m"]) == pytest.approx(result.spread("side"), rel=1e-12)
    now = clubface.dispersion(player, count=COUNT).spread("side")
    assert float(rows["spread of face"]["side_spread_m"]) == pytest.approx(now, rel=1e-12)


@pytest.mark.parametrize(
    ("text", "pictures"),
    [
        ('club = "my own"\n[mean]\nspeed = "95 mph"\n[spread]\nface = "2 deg"\n', 0),
        ('club = "driver"\n[mean]\nspeed = "95 mph"\n[spread]\n', 0),
        ('club = "driver"\n[mean]\nspeed = "95 mph"\n[spread]\nspeed = "1 mph"\n', 1),
    ],
)
def test_a_golfer_with_few_figures_has_a_report(clubface_, tmp_path, text, pictures):
    """A club that is not known, shots that are all alike, and shots that all fly straight."""
    (tmp_path / "mine.toml").write_text(f'title = "Me"\n{text}')
    assert "95 mph" in words_of(clubface_, tmp_path / "report.html", "golfer", "show", str(tmp_path / "mine.toml"))
    assert len(Page((tmp_path / "report.html").read_text()).alts) == pictures


@pytest.mark.usefixtures("without_pictures")
def test_a_part_that_yields_is_called_too_weak(clubface_, files, monkeypatch):
    monkeypatch.chdir(files)
    run = ("fem", "head", "iron.toml", "--ball", "ball.toml", "--meshes", "1", "--impact-speed")
    assert "no part yields" in words_of(clubface_, files / "slow.html", *run, "20 m/s")
    soft = files / "iron.toml"
    soft.write_text(soft.read_text().replace('"300 MPa"', '"30 MPa"'))
    assert "is too weak: the stress there reaches" in words_of(clubface_, files / "soft.html", *run, "20 m/s")
