"""A process that computes chunks of a study: what it is and then numbers come in, a line each; answers go out as JSON.

It ends with its input, so that no worker outlives the command that started it by more than the chunk it computes.
"""

from __future__ import annotations

import json
import os
import sys
import traceback
from contextlib import suppress
from typing import Any


def main() -> None:
    """Answer until the input ends, whose first line names the study; what libraries print goes to the error stream."""
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    # Loaded while the command prepares the study.
    from clubface.errors import ClubfaceError
    from clubface.shots.tables.parquet import pyarrow_for
    from clubface.studies.chunks import ensure

    with suppress(ClubfaceError):
        pyarrow_for("")
    given: Any = json.loads(sys.stdin.readline() or "[]")
    for line in sys.stdin:
        answer: dict[str, Any] = {"chunk": int(line)}
        try:
            answer |= ensure(*given, chunk=int(line))
        except ClubfaceError as error:
            answer["mistake"] = str(error)
        except MemoryError:
            answer["mistake"] = "not enough memory for a chunk; give a smaller one, or fewer workers"
        except Exception:
            answer["error"] = traceback.format_exc()
        answers.write(json.dumps(answer) + "\n")


if __name__ == "__main__":
    main()
