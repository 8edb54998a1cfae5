"""``clubface map``: launch and flight over the face of a club, or what another club changes there."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import typer

from clubface.cli import options, show
from clubface.cli.output import progress_bar
from clubface.errors import ClubfaceError, InputError
from clubface.support.checks import check_names

app = typer.Typer(add_completion=False)
MAP = options.group(None,
    minus=(str | None, None, "CLUB", "Map the first club minus this one."),
    quantity=(options.Texts, None, "NAME", "A quantity, such as carry. Several: comma-separated or repeated."),
    grid=(str | None, None, "101x101", "Number of points towards the toe and upwards."),
    spread=(str | None, None, '"12 mm x 9 mm"', "Standard deviations of impacts towards the toe and upwards, about "
            "--toe and --high, to compute what they cost."),
    workers=(int | None, None, "N", "With fem: number of points at a time; default: all cores."),
)  # fmt: skip


@app.command()
@options.takes(
    options.DELIVERY, options.EQUIPMENT, options.ONE_MODEL, options.AIR, options.GROUND, MAP, show.UNITS,
    show.table_option("Write the map, one row per point, CSV or Parquet."), show.plot_option("contours on the face"),
    show.REPORT, show.JSON,
)  # fmt: skip
def map_(club: options.ClubArgument, **texts: Any) -> None:
    """Map ball speed, launch, spin and carry over the face, with the sweet spot and what off-centre strikes cost."""
    from clubface.design.face_map import FaceMapDifference, map_face
    from clubface.design.face_map_result import LISTED
    from clubface.design.face_surface import finished
    from clubface.present.report import write_table

    minus, spread, grid = (texts[name] for name in ("minus", "spread", "grid"))
    output = show.Output.check(texts, [club, minus, texts["ball"], texts["parameters"]])
    delivery = options.delivery(texts)
    about = {name: delivery.pop(name) for name in ("toe", "high") if name in delivery}
    deviations = None if spread is None else _spread(spread)
    if about and deviations is None:
        raise ClubfaceError("--toe and --high are the point about which impacts scatter; give --spread too")
    names = _quantities(texts["quantity"])
    listed = {*(names or LISTED), "ball_speed", "carry"}  # the best points refer to the last two
    if hidden := [name for name in output.units if name not in listed]:
        raise InputError("--unit", hidden[0], "a quantity that is listed; name it with --quantity")
    counts = None if grid is None else _grid(grid)
    conditions = options.conditions(texts)
    setups = [options.setup(each, texts) for each in (club, minus) if each is not None]
    if len(setups) == 2 and setups[0]["club"] == setups[1]["club"]:
        raise InputError("--minus", minus, "another club than the first")

    maps = []
    for place, setup in enumerate(setups):
        kept = output.target if place == 0 or output.target is None else _second_store(output.target)
        points = {"grid": counts} if not maps else {"points": (maps[0].toe, maps[0].high)}
        with progress_bar("points") as update:
            how = {**setup, **points, **conditions, "output": kept, "workers": texts["workers"]}
            maps.append(map_face(delivery=delivery, **how, progress=update))
    scatter = [] if deviations is None else [each.forgiveness(deviations, **about) for each in maps]
    mapped = maps[0] if len(maps) == 1 else FaceMapDifference(*maps)
    if output.target is not None:
        write_table(mapped.all_points(), output.target)
        for kept, each in zip((output.target, _second_store(output.target)), maps, strict=False):
            if each.interpolated:  # otherwise nothing was stored, and a folder of that name is unrelated
                finished(kept)
    result = mapped.to_result(names, scatter)
    if output.report is not None:
        result = result.replace(tables=(*result.tables, mapped.all_points()))
    output.show(result, write_table=False)


def _second_store(target: str) -> str:
    """Return the name for storing the second club's points until the file is written."""
    path = Path(target)
    return str(path.with_name(f"{path.stem}.minus{path.suffix}"))


def _quantities(texts: Sequence[str] | None) -> list[str]:
    from clubface.design.contributions import QUANTITIES

    names = options.names(texts)
    if texts and not names:
        raise InputError("--quantity", ",".join(texts), f"a quantity, such as carry: one of {', '.join(QUANTITIES)}")
    check_names("quantity", names, QUANTITIES)
    return names


def _grid(text: str) -> tuple[int, int]:
    result = re.fullmatch(r"\s*(\d{1,12})\s*[x×]\s*(\d{1,12})\s*", text)
    if result is None:
        raise InputError("--grid", text, "two whole numbers, as in 101x101")
    return int(result[1]), int(result[2])


def _spread(text: str) -> tuple[float, float]:
    parts = re.split(r"[x×,]", text)
    if len(parts) != 2 or not all(part.strip() for part in parts):
        raise InputError("--spread", text, 'two standard deviations, towards the toe and upwards, as in "12 mm x 9 mm"')
    across, up = (options.parsed("--spread", part, "length") for part in parts)
    return across, up
