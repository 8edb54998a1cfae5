"""``python -m clubface.findings FOLDER [RESULTS]``: run the study, resumed in FOLDER; write RESULTS."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from clubface.errors import ClubfaceError
from clubface.findings.study import run
from clubface.support.whole_file import write_text


def main(arguments: list[str]) -> int:
    """Run the study; return the exit status."""
    if not 1 <= len(arguments) <= 2:
        print("usage: python -m clubface.findings FOLDER [RESULTS]", file=sys.stderr)
        return 2
    folder = Path(arguments[0])
    target = Path(arguments[1]) if len(arguments) == 2 else folder / "findings.json"
    told = ""

    def tell(what: str, part: float) -> None:
        nonlocal told
        line = f"{what}: {part:.0%}"
        if sys.stderr.isatty():
            print(f"\r{line:<79}", end="", file=sys.stderr, flush=True)
        elif what.partition(",")[0] != told:
            told = what.partition(",")[0]
            print(line, file=sys.stderr, flush=True)

    try:
        found = run(folder, progress=tell)
        write_text(target, json.dumps(found, indent=1, allow_nan=False) + "\n")
    except KeyboardInterrupt:
        print(f"\ninterrupted; what is finished is in {folder}, and the next run goes on after it", file=sys.stderr)
        return 130
    except ClubfaceError as error:
        print(f"clubface.findings: {error}", file=sys.stderr)
        return 2
    print(target)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
