"""``clubface dispersion``: where a golfer's shots go, by sampling and by derivatives, and causes of the spread."""

from __future__ import annotations

from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

import typer

from clubface.cli import options, show
from clubface.cli.failures import print_note
from clubface.cli.golfer import GolferArgument
from clubface.cli.output import progress_bar
from clubface.equipment.models import models
from clubface.errors import ClubfaceError, InputError
from clubface.units import from_si

if TYPE_CHECKING:
    from clubface.design.golfer import Golfer
    from clubface.design.strokes import Hole


app = typer.Typer(add_completion=False)

LOFT_THAT_COUNTS = 0.05
"""Difference in static loft [deg] above which a note says that the dynamic loft belongs to another club."""
HOLE = options.group(
    "Hole",
    hole=(str | None, None, '"430 yd"', "Length of a hole, to count strokes."),
    fairway=(str | None, None, '"32 yd"', "Width of the fairway."),
    rough=(str | None, None, '"20 yd"', "Width of the rough on either side; beyond it are trees."),
    lie=(str | None, None, "NAME", "Where the shot is played from; default tee."),
)


@app.command()
@options.takes(
    options.EQUIPMENT, options.ONE_MODEL, options.AIR, options.GROUND, HOLE, show.UNITS,
    show.table_option("Write every shot to this file, CSV or Parquet."),
    show.plot_option("where the balls land and what spreads them"), show.REPORT, show.JSON,
    options.group("Club and ball",
        club=(options.Text, None, "CLUB", "Name or TOML file; default: the golfer's club."),
    ),
    options.group(None, count=(int | None, None, "N", "Number of shots; default 16384.")), options.SEED,
    options.group(None,
        no_flight=(bool, False, None, "Compute only launches, not flights."),
        no_shares=(bool, False, None, "Do not compute what spreads the shots."),
    ),
)  # fmt: skip
def dispersion(golfer: GolferArgument, **texts: Any) -> None:
    """Simulate many shots of a golfer and sum up where they go."""
    from clubface.design.dispersion import COUNT, ImpactSetup, dispersion as compute, shots_file
    from clubface.design.dispersion_result import dispersion_result
    from clubface.design.golfer import club_of, golfer as golfer_named
    from clubface.design.variance import by_derivatives, indices
    from clubface.shots.tables.writer import KINDS

    output = show.Output.check(texts, kinds=KINDS)
    club, count, seed, no_flight = (texts[name] for name in ("club", "count", "seed", "no_flight"))
    for name, value in {name: texts[name] for name in ("hole", *options.AIR)}.items():
        if no_flight and value is not None:
            raise ClubfaceError(f"--{name} has no effect with --no-flight; leave out one of them")
    player = golfer_named(golfer)
    own = None if club is not None else "right" if player.hand > 0 else "left"
    hand = own if texts["hand"] is None else texts["hand"]
    setup = options.setup(club_of(player) if club is None else club, texts | {"hand": hand})
    setup |= {"flight": not no_flight, **options.conditions(texts)}
    head = setup.pop("club")
    _check(player, head, texts["model"], count)
    played = _hole(**{name: texts[name] for name in HOLE})
    file = nullcontext() if output.target is None else shots_file(output.target, seed=seed)
    with progress_bar("shots") as progress, file as each:
        shots = compute(
            player, head, count=COUNT if count is None else count, seed=seed, hole=played, each=each, progress=progress,
            **setup,
        )  # fmt: skip
    impact_setup = ImpactSetup(head, **setup)
    slopes = by_derivatives(shots.golfer, impact_setup) if shots.model in models() else None
    shares = None
    if not (texts["no_shares"] or no_flight) and shots.golfer.spread.any():
        with progress_bar("orders of what varies") as progress:
            shares = indices(shots.golfer, impact_setup, seed=seed, progress=progress)
    output.show(dispersion_result(shots, slopes, shares), write_table=False)


def _check(player: Golfer, head: Any, model: str, count: int | None) -> None:
    """Require a number of shots if they take long, and print a note if golfer and club do not match."""
    from clubface.equipment.clubs import CLUB_NAMES, club

    if count is None and model not in models():
        raise ClubfaceError(f"--count is missing; give it, as in --count 64: each shot with {model} takes long")
    if player.club not in CLUB_NAMES:
        return
    usual = club(player.club)
    more = from_si(head.loft - usual.loft, "deg")
    if usual.parameters != head.parameters:
        print_note(f"note: {player.name} delivers a {player.club}, not a {head.name}")
    elif "loft" in player.variables and abs(more) >= LOFT_THAT_COUNTS:
        print_note(
            f"note: {head.name} has {abs(more):.1f} deg {'more' if more > 0.0 else 'less'} loft than {player.club}, and"
            f" {player.name} hits it with the dynamic loft of {player.club}; clubface optimise with [fit] adds the"
            " difference at impact"
        )


def _hole(hole: str | None, lie: str | None, **widths: str | None) -> Hole | None:
    given: dict[str, Any] = {name: text for name, text in {**widths, "lie": lie}.items() if text is not None}
    if hole is None:
        for name in given:
            raise ClubfaceError(f'--{name} describes a hole; give its length as well, as in --hole "430 yd"')
        return None
    from clubface.design.strokes import Hole

    given |= {name: options.parsed(f"--{name}", given[name], "length") for name in widths if name in given}
    try:
        return Hole(length=options.parsed("--hole", hole, "length"), **given)
    except InputError as error:
        error.parameter = "--hole" if error.parameter == "length" else error.parameter
        raise
