"""``clubface golfer``: golfers as distributions of deliveries, shipped ones and one's own from a monitor's file.

The reports of ``clubface golfer``: how a golfer delivers the club, what is known of it, and what rests on that.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say
from clubface.cli.output import print_numbers
from clubface.cli.recorded import RECORDED, Files, recorded_shots
from clubface.units import from_si, size

if TYPE_CHECKING:
    from clubface.design.golfer import Golfer
    from clubface.design.golfer_estimate import Doubts, Estimate
    from clubface.equipment.clubs import Club


def figures(of: Golfer) -> list[str]:
    """Return the names of all figures of a golfer, as :meth:`Golfer.source` takes them."""
    found = [f"{part} of {name}" for part in ("mean", "spread") for name in of.variables]
    correlated = int((of.correlation != 0.0).sum()) > len(of.variables)
    more = {"correlation": correlated, "mishits": of.mishit_share > 0.0}
    return [*found, *(name for name, has in more.items() if has)]


def golfer_sources(of: Golfer) -> list[str]:
    """Return where each figure of a golfer comes from, figures of one source together."""
    told: dict[str, list[str]] = {}
    for figure in figures(of):
        told.setdefault(of.source(figure), []).append(figure.replace("_", " "))
    return [f"Golfer {of.title or of.name}, {', '.join(names)}: {source}" for source, names in told.items()]


def write(
    target: str, of: Golfer, club: Club | None, show: Callable[[], None], estimated: Estimate | None = None
) -> None:
    """Write the report of a golfer with a club, None where his is unknown; ``show`` prints the tables."""
    from clubface.design.golfer import to_toml
    from clubface.design.golfer_estimate import COUNT, doubts

    given = {"golfer": of.title or of.name, "hand": "right" if of.hand > 0 else "left"}
    picture, columns, found, launches = None, {}, None, ()
    if club is not None:
        from clubface.simulation.impact import impact

        found = doubts(of, club)
        launches = (impact(club, of.for_hand(club.hand).delivery()),)
    if found is not None and found.figures:
        from clubface.design.pictures import golfer_figure

        shows = f"How much the spread of the landings changes if a figure is {found.off:.0%} smaller or larger"
        picture, columns = (shows, golfer_figure(found)), _columns(found)
        given |= {"shots of each change": str(COUNT), "seed": "0"}

    def tables() -> None:
        show()
        if picture is not None and found is not None:
            print_numbers(*_table(found), title=f"If a figure is {found.off:.0%} smaller or larger")

    reporting.write(
        target, title=f"{of.title or of.name}: how the club is delivered", words=_words(of, found, estimated),
        picture=picture, columns=columns, show=tables, launches=launches, given=given,
        conditions=None if club is None else {}, sources=golfer_sources(of),
        files={f"{reporting.named(of.name)}.toml": to_toml(of)},
    )  # fmt: skip


def _words(of: Golfer, found: Doubts | None, estimated: Estimate | None) -> Iterator[str]:
    """Say how a golfer delivers, what is known of it and what rests on it, in sentences."""
    from clubface.design.golfer_estimate import is_assumed

    spread = dict(zip(of.variables, of.spread, strict=True))
    mean = dict(zip(of.variables, of.mean, strict=True))
    if estimated is not None:
        yield f"These figures come from {output.counted(estimated.shots, 'shot')}, in the order in which they were hit."
    told = [f"reaches the ball at {from_si(mean['speed'], 'mph'):.0f} mph"]
    if spread.get("speed"):
        told.append(f"two shots of three within {from_si(spread['speed'], 'mph'):.1f} mph of that")
    if spread.get("face"):
        told.append(f"with a face angle that differs by {from_si(spread['face'], 'deg'):.1f} degrees from shot to shot")
    yield f"The club {', '.join(told)}."
    if of.mishit_share > 0.0:
        yield f"{of.mishit_share:.0%} of the shots are mishits, {of.mishit_scale:.2g} times as far off in everything."
    spreads = [f"spread of {name}" for name in of.variables if spread[name] > 0.0]
    sourced = [each.removeprefix("spread of ").replace("_", " ") for each in spreads if not is_assumed(of, each)]
    if sourced:
        others = " For the rest it is assumed." if len(sourced) < len(spreads) else ""
        yield f"How much these differ from shot to shot was measured or published: {', '.join(sourced)}.{others}"
    else:
        yield (
            "How much the shots differ from each other has no source, and counts as assumed for every part of the"
            " delivery: take it as typical, not as measured."
        )
    if found is None or not found.figures:
        return
    for name, way in (("carry", "The carry"), ("side", "Where the ball lands to the sides")):
        most = max(found.figures, key=lambda each: each.spread[name][1] - found.spread[name])
        more = 100.0 * found.changes(most, name)[1]
        yield (
            f"{way} differs by {from_si(found.spread[name], 'yd'):.1f} yd from shot to shot (standard deviation). It "
            f"rests most on the {most.figure.replace('_', ' ')}{', which is assumed' * most.assumed}: if that "
            f"were {found.off:.0%} larger, the shots would differ by {more:.0f}% more."
        )


def _table(found: Doubts) -> tuple[list[str], list[list[str]]]:
    heads = ["", "is", *(f"{name} {how}\n%" for name in found.spread for how in ("smaller", "larger"))]
    rows = []
    for each in found.figures:
        changes = [100.0 * change for name in found.spread for change in found.changes(each, name)]
        rows.append([
            each.figure.replace("_", " "), "assumed" if each.assumed else "sourced",
            *(output.number(change, 1) for change in changes),
        ])  # fmt: skip
    return heads, rows


def _columns(found: Doubts) -> dict[str, list[Any]]:
    columns: dict[str, list[Any]] = {
        "figure": [each.figure for each in found.figures], "assumed": [each.assumed for each in found.figures]
    }  # fmt: skip
    for name, now in found.spread.items():
        for place, how in enumerate(("smaller", "larger")):
            values = [from_si(each.spread[name][place], "yd") for each in found.figures]
            columns[f"spread of {name}, figure {how} (yd)"] = [float(value) for value in values]
        columns[f"spread of {name} now (yd)"] = [float(from_si(now, "yd"))] * len(found.figures)
    return columns


app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Golfers: how their deliveries spread from shot to shot."
)
WEAK = 0.2
"""Correlations below this are counted but not listed: in sessions of a few dozen shots chance alone makes them."""
GolferArgument = Annotated[str, typer.Argument(metavar="GOLFER", help="Name of a shipped golfer, or a TOML file.")]


@app.command("list")
def list_golfers(as_json: options.Json = False) -> None:
    """List the golfers that come with the package."""
    from clubface.design.golfer import golfer, golfers

    every = [golfer(name) for name in golfers()]
    if as_json:
        output.print_json([{"name": each.name, "title": each.title, "club": each.club} for each in every])
        return
    print_numbers(
        ("golfer", "speed\nmph", "±", "face ±\ndeg", "mishits\n%"),
        [
            [
                each.name, _value(each, each.mean, "speed", 0), _value(each, each.spread, "speed", 1),
                _value(each, each.spread, "face", 1), f"{100.0 * each.mishit_share:.0f}",
            ]
            for each in every
        ],
    )  # fmt: skip
    output.print_notes(["± is the standard deviation from shot to shot; clubface golfer show NAME tells the sources"])


@app.command("show")
def show(
    golfer: GolferArgument,
    target: Annotated[str | None, options.output("FILE", "Write a TOML file to start one's own golfer from.")] = None,
    report: options.Report = None,
    as_json: options.Json = False,
) -> None:
    """Show means, spreads and correlations of a golfer, and where each figure comes from."""
    from clubface.design.golfer import golfer as golfer_named, to_toml

    output.check_report(report, (golfer,))
    found = golfer_named(golfer)
    if report is not None:
        from clubface.equipment.clubs import CLUB_NAMES, club

        hand = "right" if found.hand > 0 else "left"
        head = club(found.club).replace(hand=hand) if found.club in CLUB_NAMES else None
        write(report, found, head, lambda: _print(found))
        say(f"wrote {report}")
    if target is not None:
        output.write_template(to_toml(found), target, f"clubface dispersion {target} takes it")
        if not as_json:
            return
    if as_json:
        output.print_json(_document(found))
        return
    _print(found)
    told: dict[str, list[str]] = {}
    for figure in figures(found):
        told.setdefault(found.source(figure), []).append(figure.replace("_", " "))
    print()
    print("Sources")
    output.print_notes(f"{', '.join(figures)}: {source}" for source, figures in told.items())


@app.command("estimate")
@options.takes({name: each for name, each in RECORDED.items() if name != "ball"})  # no ball is struck
def estimate(
    files: Files,
    name: Annotated[str, options.option("--name", metavar="NAME", text="What to call the golfer.")] = "my golfer",
    like: Annotated[
        str | None,
        options.option(
            "--like",
            metavar="GOLFER",
            text="The golfer that gives what was not measured; the shipped one of the nearest speed unless given.",
        ),
    ] = None,
    target: Annotated[str | None, options.output("FILE", "Write the golfer to this TOML file.")] = None,
    report: options.Report = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Estimate a golfer from shots in the order in which they were hit."""
    from clubface.design.golfer import to_toml
    from clubface.design.golfer_estimate import estimate_golfer
    from clubface.equipment.clubs import CLUB_NAMES

    output.check_target("--output", target, (".toml",), [*files, texts["mapping"], texts["club"], like])
    output.check_report(report, [*files, texts["mapping"], texts["club"], like])
    shots = recorded_shots(files, texts)
    found = estimate_golfer(shots, name=name, like=like)
    if target is not None:
        from clubface.support.files import write_text

        write_text(target, to_toml(found.golfer))
        own = "" if found.golfer.club in CLUB_NAMES else f" --club {texts['club']}"
        say(f"wrote {target}; clubface dispersion {target}{own} takes it")
    if report is not None:

        def tables() -> None:
            _print(found.golfer, found)
            output.print_notes(found.notes)

        write(report, found.golfer, shots.club, tables, found)
        say(f"wrote {report}")
    if as_json:
        output.print_json(_document(found.golfer) | _estimated(found))
        return
    _print(found.golfer, found)
    output.print_notes(found.notes)


def _print(of: Golfer, estimated: Estimate | None = None) -> None:
    heads = ["", "unit", "mean", "±"]
    if estimated is not None:
        heads += ["error\nof ±", "drift"]
    rows = []
    for name in of.variables:
        unit, digits = _unit(name)
        row = [name.replace("_", " "), unit, _value(of, of.mean, name, digits), _value(of, of.spread, name, digits)]
        if estimated is not None:
            row += _told(estimated, name)
        rows.append(row)
    shots = "" if estimated is None else f", {output.counted(estimated.shots, 'shot')}"
    print_numbers(heads, rows, title=f"{of.title or of.name} ({of.club}){shots}")
    notes = ["± is the standard deviation from shot to shot, mishits left out"]
    if estimated is not None:
        notes.append("error of ± is how well that is known, as a standard error")
        notes.append(
            "drift compares the whole session with shots that follow each other: well above 1, something was changed"
            " on the way; well below 1, the rows do not stand in the order of play; chance alone moves it by"
            f" {0.5 / estimated.shots**0.5:.2f} (standard deviation)"
        )
    pairs, fewer = _pairs(of)
    if pairs:
        weaker = f"; {fewer} are weaker than ±{WEAK:g}" * (fewer > 0)
        notes.append(f"correlations: {', '.join(pairs)}{weaker}")
    if of.mishit_share > 0.0:
        notes.append(
            f"{100.0 * of.mishit_share:.3g} % of the shots are mishits, {of.mishit_scale:.3g} times as far off"
        )
    output.print_notes(notes)


def _pairs(of: Golfer) -> tuple[list[str], int]:
    """Return the correlations that count, the strongest first, and how many are weaker."""
    names, every = of.variables, of.correlation
    found = {(one, other): float(every[one, other]) for one in range(len(names)) for other in range(one)}
    strong = sorted((pair for pair in found if abs(found[pair]) >= WEAK), key=lambda pair: -abs(found[pair]))
    told = [f"{names[one]} with {names[other]} {found[one, other]:+.2f}" for one, other in strong]
    return told, sum(0.005 <= abs(value) < WEAK for value in found.values())


def _told(of: Estimate, name: str) -> list[str]:
    if name not in of.measured:
        return ["", ""]
    unit, digits = _unit(name)
    at = of.measured.index(name)
    return [output.number(float(of.error[at]) / size(unit), digits), output.number(float(of.drift[at]), 2)]


def _unit(name: str) -> tuple[str, int]:
    from clubface.design.golfer import UNIT
    from clubface.simulation.inputs import OF_CLUB

    unit = UNIT[OF_CLUB[name]]
    return unit, {"deg/s": 0, "mm": 1}.get(unit, 2)


def _value(of: Golfer, values: Any, name: str, digits: int) -> str:
    if name not in of.variables:
        return ""
    return output.number(float(values[of.variables.index(name)]) / size(_unit(name)[0]), digits)


def _document(of: Golfer) -> dict[str, Any]:
    return {
        "name": of.name, "title": of.title, "club": of.club, "hand": "right" if of.hand > 0 else "left",
        "variables": of.variables, "mean": of.mean.tolist(), "spread": of.spread.tolist(),
        "covariance": of.covariance.tolist(), "mishit_share": of.mishit_share, "mishit_scale": of.mishit_scale,
        "sources": dict(of.sources),
    }  # fmt: skip


def _estimated(of: Estimate) -> dict[str, Any]:
    return {
        "shots": of.shots, "measured": of.measured, "error_of_spread": of.error.tolist(), "drift": of.drift.tolist(),
        "shrinkage": of.shrinkage, "like": of.like, "notes": of.notes,
    }  # fmt: skip
