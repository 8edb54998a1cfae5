"""How errors are reported: one message on the error stream and exit status 2. Notes do not stop the run."""

from __future__ import annotations

import os
import sys
import traceback
import warnings
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import Any

from clubface.errors import ClubfaceError, InputError, RuleWarning, UnknownNameError, in_a_line, missing_extra
from clubface.support.renamed import RENAMED


class Interrupted(BaseException):
    """The user pressed Ctrl-C."""


class ReaderGone(BaseException):
    """The reader of standard output has closed it."""


def print_note(message: str) -> None:
    """Write one message on one line of the error stream; a failure to write it is ignored.

    Standard output is flushed first, so that the order is kept if both streams go to one file.
    """
    with suppress(OSError, AttributeError):  # closed or missing; the next print reports it
        sys.stdout.flush()
    with suppress(OSError):
        print(f"clubface: {in_a_line(message)}", file=sys.stderr)


def print_written(files: Sequence[object]) -> None:
    """Print the names of the files written, if any."""
    if files:
        print_note(f"wrote {', '.join(map(str, files))}")


def as_typed(error: BaseException, options: Mapping[str, str]) -> BaseException:
    """Name the option as typed in an error about its value; ``options`` are keyed by parameter name."""
    if isinstance(error, InputError) and not isinstance(error, UnknownNameError):
        first, rest = error.parameter.partition(" ")[::2]
        error.parameter = " ".join([options.get(first, first), *([rest] if rest else [])])
    return error


def report(error: BaseException) -> int:
    """Report an error; return the exit status."""
    if isinstance(error.__cause__, KeyboardInterrupt):  # Python replaces one that is raised while a class is created
        error = error.__cause__
    if isinstance(error, (Interrupted, KeyboardInterrupt)):
        sentences = str(error)
        print_note(
            sentences if sentences.startswith("interrupted") else f"interrupted{': ' if sentences else ''}{sentences}"
        )
        return 130
    if isinstance(error, ClubfaceError):
        print_note(str(error))
        return 2
    if isinstance(error, ModuleNotFoundError) and missing_extra(error) is not None:
        return missing_library(error)
    if isinstance(error, OSError):
        if error.filename is None:  # errors of files carry a file name
            let_go_of_output()
        print_note(f"{error.filename or 'standard output'}: {error.strerror or error}")
        return 2
    if isinstance(error, MemoryError):
        print_note("not enough memory for this request; give fewer shots at a time")
        return 2
    if hasattr(error, "format_message"):
        return _report_misuse(error)
    if type(error).__name__ == "Abort":
        print_note("interrupted")
        return 130
    traceback.print_exception(error)
    print_note("this is a bug in clubface, not your mistake; please report it with the lines above")
    return 1


def let_go_of_output() -> None:
    """Discard the remaining standard output, so that Python does not try to write it at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def missing_library(error: ModuleNotFoundError) -> int:
    """Report which extra installs a missing library; return the exit status."""
    message = missing_extra(error)
    if message is None:
        raise error
    print_note(message)
    return 2


def _report_misuse(error: Any) -> int:
    """Report a missing, unknown or malformed option or argument (an exception of Typer)."""
    context = getattr(error, "ctx", None)
    message = error.format_message()
    if type(error).__name__ == "NoArgsIsHelpError":
        print(message)
        return 2
    hint = f" ({context.command_path} --help lists the options)" if context and context.parent else ""
    print_note(message[:1].lower() + message[1:].rstrip(".") + hint)
    return 2


def show_warnings() -> None:
    """Show warnings as one-line notes.

    ``clubface clubs`` notes that the ball `published` is slightly below the limit of the rules; this is not repeated.
    """
    warnings.filterwarnings("ignore", message="published: ball diameter", category=RuleWarning)
    warnings.filterwarnings("default", message=RENAMED, category=DeprecationWarning)

    def note(message: Warning | str, *rest: object) -> None:
        print_note(f"note: {message}")

    warnings.showwarning = note  # pyright: ignore[reportAttributeAccessIssue]
