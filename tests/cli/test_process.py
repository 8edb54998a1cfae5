"""The command line as a process: what it loads, closed pipes, Ctrl-C."""

import errno
import io
import json
import os
import subprocess
import sys
import time

import pytest

import clubface
from command_line import MAIN, assert_mistake, interruptible, press_ctrl_c, process

pytest.importorskip("typer")
pytest.importorskip("rich")


def test_the_installed_entry_point_is_this_function():
    ran = process("--version")
    assert ran.stdout == f"clubface {clubface.__version__}\n"
    assert ran.returncode == 0


def test_a_shot_loads_nothing_slow_that_it_does_not_need():
    code = (
        "import sys; from clubface.cli import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "slow = {'pandas', 'xarray', 'matplotlib', 'pyarrow', 'rich', 'scipy'}\n"
        "print(sorted(slow & set(sys.modules)), file=sys.stderr)"
    )
    command = [sys.executable, "-c", code, "shot", "driver", "--speed", "113 mph"]
    for option in ([], ["--json"]):
        ran = subprocess.run([*command, *option], capture_output=True, text=True, check=True)
        assert ran.stderr == "[]\n"


def test_a_rule_warning_is_one_note(write):
    file = write(clubface.Club.template("big").replace("5679 g cm2", "6400 g cm2"), "big.toml")
    ran = process("shot", str(file), "--speed", "50 m/s", "--json")
    assert ran.stderr.count("\n") == 1
    assert ran.stderr.startswith("clubface: note: big: moment of inertia")
    assert len(json.loads(ran.stdout)["tables"]["shots"]["rows"]) == 1


def test_a_reader_that_goes_away_is_no_error():
    for arguments in (["models", "--json"], ["models"], ["shot", "driver", "--speed", "50 m/s"]):
        command = [sys.executable, "-c", MAIN, *arguments]
        with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as child:
            assert child.stdout is not None
            assert child.stderr is not None
            child.stdout.close()
            assert child.stderr.read() == ""
        assert child.returncode == 141


@pytest.mark.parametrize("arguments", [["models"], ["models", "--json"], ["--version"]])
def test_a_reader_whose_going_windows_calls_an_invalid_argument_is_no_error(monkeypatch, capsys, arguments):
    from clubface.cli import app

    class Gone(io.StringIO):
        def write(self, text):
            raise OSError(errno.EINVAL, "Invalid argument")

    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(sys, "stdout", Gone())
    monkeypatch.setattr(app, "let_go_of_output", lambda: None)
    assert app.run(arguments) == 141
    assert capsys.readouterr().err == ""


def test_a_reader_that_leaves_before_the_help_is_no_error_either():
    reading, writing = os.pipe()
    os.close(reading)
    with open(writing, "w") as nobody:
        ran = subprocess.run([sys.executable, "-c", MAIN, "map", "--help"], stdout=nobody, stderr=subprocess.PIPE)
    assert (ran.returncode, ran.stderr) == (141, b"")


def test_a_terminal_without_greek_letters_gets_its_table():
    ran = process(
        "shot", "driver", "--speed", "50 m/s", "--model", "all", env={**os.environ, "PYTHONIOENCODING": "ascii"}
    )
    assert ran.returncode == 0
    assert "volumetric" in ran.stdout
    assert "-----" in ran.stdout


def test_what_goes_to_a_file_is_utf_8_whatever_the_system_takes_for_usual(write, tmp_path):
    """Windows takes its code page, and systems without a language take ASCII, which have no such letters."""
    name = "Größe 東京"
    club = write(clubface.Club.template(name).replace("5679 g cm2", "6400 g cm2"), "big.toml")
    usual = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    command = [sys.executable, "-c", MAIN, "shot", str(club), "--speed", "113 mph", "--json"]
    ran = subprocess.run(command, env=os.environ | usual, capture_output=True, check=True)
    assert name in json.loads(ran.stdout.decode("utf-8"))["title"]
    assert f"note: {name}: moment of inertia" in ran.stderr.decode("utf-8")


def test_a_command_is_told_as_the_shell_of_the_system_takes_it(monkeypatch, tmp_path):
    from clubface.cli import app

    app.remember(["shot", str(tmp_path / "my club.toml"), "--speed", "113 mph", "--toe", "5mm"])
    monkeypatch.setattr(sys, "platform", "win32")
    assert app.command() == 'clubface shot "my club.toml" --speed "113 mph" --toe 5mm'
    monkeypatch.setattr(sys, "platform", "linux")
    assert app.command() == "clubface shot 'my club.toml' --speed '113 mph' --toe 5mm"


def test_windows_whose_shells_leave_patterns_alone_gets_the_files_that_they_stand_for(monkeypatch, tmp_path, clubface_):
    for name in ("b[1].toml", "a[1].toml", "c.toml"):
        (tmp_path / name).write_text(clubface.club("driver").replace(name=name[0]).to_toml(), encoding="utf-8")
    monkeypatch.setattr(sys, "platform", "win32")
    ran = clubface_("compare", str(tmp_path / "?[1].toml"), "--speed", "113 mph", "--json")
    assert [row["club"] for row in ran.rows()] == ["a", "b"]
    assert_mistake(clubface_("compare", str(tmp_path / "?.csv"), "--speed", "113 mph"), "?.csv")


def test_ctrl_c_ends_with_one_line_and_status_130(tmp_path):
    source, target = tmp_path / "in.csv", tmp_path / "out.csv"
    source.write_text("club_speed_mph\n" + "113\n" * 300_000)
    command = [sys.executable, "-c", MAIN, "predict", str(source), "--club", "driver", "--model", "rings"]
    with interruptible([*command, "-o", str(target)]) as child:
        started = time.monotonic()
        while (
            not (tmp_path / "out.csv.unfinished" / "values.jsonl").exists()
            and child.poll() is None
            and time.monotonic() - started < 30
        ):
            time.sleep(0.02)
        press_ctrl_c(child)
        assert child.stderr is not None
        message = child.stderr.read()
    assert child.returncode == 130
    assert message.startswith("clubface: interrupted")
    assert message.count("\n") == 1
    assert not target.exists()


def test_ctrl_c_while_modules_are_loaded_is_reported_as_any_other(monkeypatch, capsys):
    from clubface import cli
    from clubface.cli import app

    def interrupted(arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr(app, "run", interrupted)
    monkeypatch.setattr(os, "_exit", sys.exit)  # the command does not wait for libraries to end
    with pytest.raises((SystemExit, KeyboardInterrupt)) as left:
        cli.main()
    assert getattr(left.value, "code", None) == 130
    assert capsys.readouterr().err == "clubface: interrupted\n"


def without_stream(number, *arguments):
    """Run a command line in a process that starts with a stream closed, as by ``>&-``."""
    command = [sys.executable, "-c", MAIN, *arguments]
    closing = f"import os; os.close({number}); os.execv({sys.executable!r}, {command!r})"
    return subprocess.run([sys.executable, "-c", closing], capture_output=True, text=True, timeout=50)


closes_streams = pytest.mark.skipif(sys.platform == "win32", reason="no shell of Windows starts with a stream closed")


@closes_streams
@pytest.mark.parametrize("arguments", [["shot", "driver", "--speed", "113 mph"], ["--version"], ["clubs"]])
def test_a_closed_standard_output_is_reported_at_once(arguments):
    ran = without_stream(1, *arguments)
    assert ran.returncode == 2
    assert ran.stderr.startswith("clubface: the standard output is closed")
    assert ran.stderr.count("\n") == 1


@closes_streams
def test_a_closed_error_stream_does_not_send_messages_to_the_output():
    ran = without_stream(2, "shot", "drivr")
    assert ran.returncode == 2
    assert ran.stdout == ""


def test_messages_stand_in_the_order_of_a_run_where_both_streams_go_to_one_file():
    code = "from clubface.cli.failures import print_note; print('a table'); print_note('wrote a file')"
    buffered = {name: value for name, value in os.environ.items() if name != "PYTHONUNBUFFERED"}
    ran = subprocess.run(
        [sys.executable, "-c", code], env=buffered, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        check=True,
    )  # fmt: skip
    assert ran.stdout == "a table\nclubface: wrote a file\n"


WITHOUT_COLUMNS = {name: value for name, value in os.environ.items() if name != "COLUMNS"}


@pytest.fixture(scope="module")
def printed():
    """What a shot prints where the environment gives no width."""
    return process("shot", "driver", "--speed", "113 mph", env=WITHOUT_COLUMNS).stdout


@pytest.mark.parametrize("columns", ["²", "٣", "0", "-5", "9" * 5000, "wide"])
def test_columns_in_the_environment_that_are_no_number_are_passed_over(columns, printed):
    ran = process("shot", "driver", "--speed", "113 mph", env=WITHOUT_COLUMNS | {"COLUMNS": columns})
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, printed, "")
