"""What a study reads is read when it begins: later edits change nothing, and other contents are another study."""

import csv
import hashlib

import pytest

import clubface
from clubface import studies
from clubface.errors import ClubfaceError, FileError
from clubface.studies.study import read_study
from fem_meshes import HEAD, write_mesh

pytest.importorskip("pyarrow")

DRIVER = clubface.club("driver")
CHUNKED = '[study]\nchunk = 1\nkind = "{kind}"\n[{kind}]\n{table}\n[sweep]\n{sweep}\n'


def described(folder, kind, table, sweep):
    path = folder / "study.toml"
    path.write_text(CHUNKED.format(kind=kind, table=table, sweep=sweep))
    return path


def golfer(path, speed):
    path.parent.mkdir(exist_ok=True)
    path.write_text(f'title = "Anna"\n[mean]\nspeed = "{speed} mph"\nloft = "12 deg"\n[spread]\nface = "2 deg"\n')


def test_another_share_with_a_changed_golfer_is_refused_and_says_what_changed(tmp_path, monkeypatch, in_this_process):
    monkeypatch.chdir(tmp_path)
    golfer(tmp_path / "sub" / "anna", 100)  # neither a point nor an ending
    path = described(tmp_path, "dispersion", 'golfer = "sub/anna"\nshots = 64', "seed = [1, 2]")
    assert studies.run("study.toml", shard="1/2").computed == 1
    golfer(tmp_path / "sub" / "anna", 90)
    for command in (studies.run, studies.status):
        with pytest.raises(FileError, match=r'another file sub/anna \(line 3 was speed = "100 mph" and is .*90 mph'):
            command(path)
    golfer(tmp_path / "sub" / "anna", 100)
    assert studies.run("study.toml", shard="2/2").missing == 0


CASES = {
    "parameters": ("impact", 'club = "driver"\nmodel = "slip"\nparameters = "mine.toml"\noutputs = ["ball_speed"]',
                   'speed = ["100 mph", "110 mph"]'),
    "club": ("impact", 'club = "mine.toml"\noutputs = ["ball_speed"]', 'speed = ["100 mph", "110 mph"]'),
    "golfer": ("dispersion", 'golfer = "mine.toml"\nshots = 64', "seed = [1, 2]"),
    "swept golfer": ("dispersion", "shots = 64", 'golfer = ["mine.toml", "tour-driver"]'),
    "golfer's club": ("dispersion", 'golfer = "golfer.toml"\nshots = 64', "seed = [1, 2]"),
    "swept ball": ("impact", 'club = "driver"\nheld = { speed = "100 mph" }\noutputs = ["ball_speed"]',
                   'ball = ["mine.toml", "modern"]'),
    "capture": ("capture", 'club = "mine.toml"\nnoise = "0.5 mm"', "swing = [0, 1]"),
    "second shot": ("comparison", 'club = "driver"\nother = { club = "mine.toml" }\noutputs = ["ball_speed"]',
                    'speed = ["100 mph", "110 mph"]'),
}  # fmt: skip


def contents(name, changed):
    """Return the text of mine.toml, and one that makes other shots."""
    if name == "parameters":
        result = clubface.ParameterSet.builtin("slip", "driver")
        return result.replace(cor=0.5 if changed else 0.8).to_toml()
    if name.endswith("ball"):
        ball = clubface.Ball.builtin("modern")
        return ball.replace(name="mine", mass=0.044 if changed else 0.0459).to_toml()
    if name in ("golfer", "swept golfer"):
        speed = 80 if changed else 100
        return f'title = "Anna"\n[mean]\nspeed = "{speed} mph"\nloft = "12 deg"\n[spread]\nface = "2 deg"\n'
    return DRIVER.replace(name="mine", mass=0.3 if changed else 0.2).to_toml()


@pytest.mark.parametrize("name", CASES)
def test_a_file_that_is_edited_during_a_run_changes_nothing(name, tmp_path, in_this_process):
    mine, path = tmp_path / "mine.toml", described(tmp_path, *CASES[name])
    text = contents("golfer", False).replace("[mean]", 'club = "mine.toml"\n[mean]')
    (tmp_path / "golfer.toml").write_text(text)
    mine.write_text(contents(name, False))
    studies.run(path)
    undisturbed = studies.join(path).sums
    mine.write_text(contents(name, True))
    studies.run(path, store=tmp_path / "changed")
    assert studies.join(path, store=tmp_path / "changed").sums != undisturbed  # the file counts
    mine.write_text(contents(name, False))

    def edit(done, whole):
        mine.write_text(contents(name, True))

    studies.run(path, store=tmp_path / "disturbed", progress=edit)
    mine.write_text(contents(name, False))
    assert studies.join(path, store=tmp_path / "disturbed").sums == undisturbed


def test_texts_that_quote_a_file_are_no_files_of_a_study(tmp_path):
    (tmp_path / "private.toml").write_text("x = 1")
    long = "x" * 900 + ".toml"
    club = DRIVER.replace(name="mine", description=f"see private.toml and 'private.toml' {long}")
    (tmp_path / "mine.toml").write_text(club.to_toml() + '\n# "private.toml"\n')
    path = described(tmp_path, "impact", 'club = "mine.toml"', 'speed = ["100 mph"]')
    assert list(read_study(path).files()) == ["mine.toml"]


def test_a_report_of_a_store_lists_what_the_study_has_read(tmp_path, clubface_, in_this_process):
    pytest.importorskip("matplotlib")
    mine = tmp_path / "mine.toml"
    mine.write_text(DRIVER.replace(name="mine").to_toml())
    studies.run(described(tmp_path, "impact", 'club = "mine.toml"', 'speed = ["100 mph", "110 mph"]'))
    sum_ = hashlib.sha256(mine.read_bytes()).hexdigest()
    mine.unlink()
    ran = clubface_("study", "summary", str(tmp_path / "study.store"), "--report", str(tmp_path / "report.html"))
    assert ran.status == 0, ran.err
    assert sum_ in (tmp_path / "report.html").read_text()


def test_an_impact_speed_by_its_old_name_is_swept_and_not_beside_the_new_one(tmp_path, in_this_process):
    table, sweep = 'head = "paper"\nball = "reference"\noutputs = ["mass"]', 'blow = ["50 m/s", "51 m/s"]'
    path = described(tmp_path, "head", table, sweep)
    with pytest.warns(DeprecationWarning, match="blow of .head. is called impact_speed now"):
        studies.run(path)
    studies.join(path, tmp_path / "out.csv")
    assert len((tmp_path / "out.csv").read_text().splitlines()) == 1 + 2
    both = described(tmp_path, "head", f'{table}\nimpact_speed = "40 m/s"', sweep)
    with pytest.raises(ClubfaceError, match=r"blow is given twice.*left out: it is the old name of impact_speed"):
        studies.run(both, store=tmp_path / "other.store")


def test_the_mesh_of_a_head_counts_and_may_be_edited_during_a_run(tmp_path, in_this_process):
    (tmp_path / "heads").mkdir()
    write_mesh(tmp_path / "heads")
    (tmp_path / "heads" / "own.toml").write_text(HEAD)
    path = described(
        tmp_path, "head", 'outputs = ["mass"]', 'head = ["heads/own.toml"]\nimpact_speed = ["50 m/s", "51 m/s"]'
    )
    assert list(read_study(path).files()) == ["heads/head.msh", "heads/own.toml"]
    studies.run(path, progress=lambda *_: write_mesh(tmp_path / "heads", scale=1.1))
    write_mesh(tmp_path / "heads")
    studies.join(path, tmp_path / "out.csv")
    first, second = csv.DictReader((tmp_path / "out.csv").read_text().splitlines())
    assert [first[name] for name in first if name.startswith("mass")] == [
        second[name] for name in second if name.startswith("mass")
    ]
