"""One damaged file read by one reader: the error of the package, success, or a finding."""

from __future__ import annotations

import signal
import time
import tracemalloc
import unicodedata
import warnings
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from random import Random
from types import FrameType

from clubface.errors import ClubfaceError
from fuzz_mutations import mutated
from fuzz_readers import READERS

SECONDS = 10.0
"""For one input, twenty times what the slowest takes on an idle machine."""
BYTES = 300_000_000
"""Memory that Python may ask for while it reads one, some hundred times its size."""
LONGEST = 1000
"""Characters of a message."""
ORDER = [name for name, reader in READERS.items() for _ in range(reader.share)]


class TooLongError(BaseException):
    """Reading takes longer than ``SECONDS``."""


def content(seed: int, number: int) -> tuple[str, bytes]:
    """Return the name of the reader and the content of one input, the same for the same numbers."""
    random = Random(f"{seed}:{number}")
    name = ORDER[number % len(ORDER)]
    reader = READERS[name]
    if reader.make is not None:
        return name, reader.make(random)
    seeds = reader.seeds()
    return name, mutated(random.choice(seeds), random.choice(seeds), random)


def finding(name: str, path: Path, *, measure: bool = False) -> str | None:
    """Read a file; return what is wrong with how it went, or None. ``measure`` looks at memory too, and is slower."""
    before = signal.signal(signal.SIGALRM, _too_long)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    if measure:
        tracemalloc.start()
    began, printed = time.monotonic(), StringIO()
    try:
        with warnings.catch_warnings(), redirect_stderr(printed), redirect_stdout(printed):
            warnings.simplefilter("ignore")
            READERS[name].read(path)
    except ClubfaceError as error:
        text = str(error)
        if any(unicodedata.category(each)[0] == "C" or each in "\u2028\u2029" for each in text) or len(text) > LONGEST:
            return f"message of {len(text)} characters: {text[:200]!r}"
    except TooLongError:
        return f"longer than {SECONDS:g} s"
    except Exception as error:
        place = error.__traceback__
        while place is not None and place.tb_next is not None:
            place = place.tb_next
        where = f"{Path(place.tb_frame.f_code.co_filename).name}:{place.tb_lineno}" if place is not None else ""
        return f"{type(error).__name__} at {where}: {' '.join(str(error).split())[:200]}"
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
        peak = tracemalloc.get_traced_memory()[1] if measure else 0
        if measure:
            tracemalloc.stop()
    if len(printed.getvalue()) > LONGEST:
        return f"prints {len(printed.getvalue())} characters"
    if peak > BYTES:
        return f"{peak / 1e6:.0f} MB after {time.monotonic() - began:.1f} s"
    return None


def _too_long(number: int, frame: FrameType | None) -> None:
    raise TooLongError
