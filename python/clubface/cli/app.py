"""The list of commands, the command line as typed, and how a run ends: with a result, an error or an interruption."""

from __future__ import annotations

import errno
import io
import os
import shlex
import sys
from collections.abc import Sequence
from contextvars import ContextVar
from glob import glob
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from clubface.cli.failures import Interrupted, ReaderGone, as_typed, let_go_of_output, print_note, report, show_warnings
from clubface.cli.output import legible_streams
from clubface.errors import UnknownNameError
from clubface.support.files import InputRecord
from clubface.support.version import __version__

_ARGUMENTS: ContextVar[tuple[str, ...]] = ContextVar("arguments", default=())


def remember(arguments: Sequence[str]) -> None:
    """Keep the arguments of the command that is starting."""
    _ARGUMENTS.set(tuple(arguments))


def command() -> str:
    """Return the command line for repeating the run, with file names without folders."""
    words = ["clubface", *(Path(each).name if _is_path(each) else each for each in _ARGUMENTS.get())]
    if sys.platform == "win32":  # cmd knows double quotes only
        from subprocess import list2cmdline

        return list2cmdline(words)
    return shlex.join(words)


def _is_path(text: str) -> bool:
    folder = os.path.dirname(text)
    return bool(folder) and (os.path.isabs(text) or os.path.exists(text) or os.path.isdir(folder))


COMMANDS = {
    "shot": "shot",
    "predict": "predict",
    "identify": "identify",
    "flight": "flight",
    "sensitivity": "sensitivity",
    "explain": "explain",
    "compare": "compare",
    "map": "map",
    "models": "models",
    "clubs": "clubs",
    "club": "club",
    "tour": "tour",
    "validate": "validate",
    "chart": "chart",
    "monitor": "monitor",
    "golfer": "golfer",
    "dispersion": "dispersion",
    "best-loft": "best_loft",
    "evaluate": "evaluate",
    "infer": "infer",
    "fem": "fem",
    "capture": "capture",
    "optimise": "optimise",
    "study": "study",
    "studio": "studio",
    "export": "export",
    "schema": "schema",
}
"""Module of each command, in the order of the help."""
READER_GONE = 128 + 13
"""Exit status of a program whose output was closed by its reader, as reported by shells (SIGPIPE)."""


class Commands(TyperGroup):
    """A command group that imports the module of a command when it is used."""

    def list_commands(self, ctx: Any) -> list[str]:
        """Return the names of the commands for the help."""
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        """Import and return one command."""
        if cmd_name not in COMMANDS:
            return None
        module = import_module(f"clubface.cli.{COMMANDS[cmd_name]}")
        command = typer.main.get_command(module.app)
        command.name = cmd_name
        return command

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Suggest the nearest commands for one that does not exist."""
        if args and args[0] not in COMMANDS and not args[0].startswith("-"):
            raise UnknownNameError("command", args[0], COMMANDS)
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: Any) -> Any:
        """Distinguish Ctrl-C and a closed output from other reasons to stop."""
        try:
            result = super().invoke(ctx)
            sys.stdout.flush()
            return result
        except OSError as error:
            if _tells_of_no_reader(error):
                raise ReaderGone from None
            raise
        except KeyboardInterrupt as stop:
            raise Interrupted(*stop.args) from None


app = typer.Typer(cls=Commands, help="From delivery to launch: how a golf club meets a ball.", no_args_is_help=True)


def _version(wanted: bool) -> None:
    if wanted:
        print(f"clubface {__version__}")
        raise typer.Exit


@app.callback()
def _root(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """From delivery to launch: how a golf club meets a ball."""


def _options(arguments: Sequence[str]) -> dict[str, str]:
    """Return the options of the command in ``arguments`` as typed, by parameter name."""
    command: Any = typer.main.get_command(app)
    for word in arguments:
        if not isinstance(command, TyperGroup) or (result := command.get_command(typer.Context(command), word)) is None:
            break
        command = result
    result = {str(each.name): max(each.opts, key=len) for each in command.params if each.opts[0].startswith("-")}
    return result | {f"wind_{axis}": result["wind"] for axis in "xyz" if "wind" in result}  # its components


def _prepare_streams() -> bool:
    """Return whether there is an output stream, and provide one for messages if there is none."""
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w")  # noqa: SIM115 - for the rest of the process
    # Rich mistakes other digits, such as superscripts, for a number of columns and fails to convert them.
    for name in ("COLUMNS", "LINES"):
        if not (words := os.environ.get(name, "")).isascii() or not words.isdigit() or not 0 < int(words[:9]) < 10_000:
            os.environ.pop(name, None)
    # A terminal without a letter such as µ still gets its table. What goes to a file or to another program is UTF-8 as
    # all files are, also where Windows would write its code page.
    for stream, errors in ((sys.stdout, "replace"), (sys.stderr, "backslashreplace")):
        if isinstance(stream, io.TextIOWrapper):
            own = stream.isatty() or "PYTHONIOENCODING" in os.environ
            stream.reconfigure(encoding=stream.encoding if own else "utf-8", errors=errors)
    return sys.stdout is not None


def _tells_of_no_reader(error: BaseException) -> bool:
    """Whether whoever read the output is gone, which Windows calls an invalid argument."""
    if sys.platform == "win32" and isinstance(error, OSError) and error.errno == errno.EINVAL:
        return error.filename is None
    return isinstance(error, BrokenPipeError)


def _with_files(arguments: Sequence[str]) -> list[str]:
    """Put files in the place of patterns such as ``swings/*.c3d``, as every shell does but those of Windows."""
    if sys.platform != "win32":
        return [*arguments]
    words: list[str] = []
    for each in arguments:
        files = sorted(glob(each.replace("[", "[[]"))) if set("*?") & set(each) else []
        words += files or [each]
    return words


def run(arguments: Sequence[str]) -> int:
    """Run one command line; return the exit status."""
    arguments = _with_files(arguments)
    show_warnings()
    remember(arguments)
    if not _prepare_streams():
        # The next file opened would take its file descriptor and receive the output of libraries.
        print_note(f"the standard output is closed; send what you do not want to see to {os.devnull}")
        return 2
    try:
        with InputRecord().active(), legible_streams():
            status = typer.main.get_command(app).main(list(arguments), prog_name="clubface", standalone_mode=False)
        sys.stdout.flush()  # text printed by the parser itself, such as help
    except (Exception, Interrupted, ReaderGone, SystemExit) as error:
        # Rich, which prints the help, treats a broken pipe as the end.
        if isinstance(error, (ReaderGone, SystemExit)) or _tells_of_no_reader(error):
            # A pager or head has read enough: nothing is left to report.
            let_go_of_output()
            return READER_GONE
        return report(as_typed(error, _options(arguments)))
    return status if isinstance(status, int) else 0
