"""``clubface golfer``: golfers as distributions of deliveries, shipped ones and one's own from a monitor's file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import say
from clubface.cli.golfer_report import figures, write as write_report
from clubface.cli.recorded import RECORDED, Files, recorded_shots
from clubface.cli.tables import print_numbers
from clubface.units import size

if TYPE_CHECKING:
    from clubface.design.golfer.estimate import Estimate
    from clubface.design.golfer.golfer import Golfer

app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Golfers: how their deliveries spread from shot to shot."
)
WEAK = 0.2
"""Correlations below this are counted but not listed: in sessions of a few dozen shots chance alone makes them."""
GolferArgument = Annotated[str, typer.Argument(metavar="GOLFER", help="Name of a shipped golfer, or a TOML file.")]


@app.command("list")
def list_golfers(as_json: options.Json = False) -> None:
    """List the golfers that come with the package."""
    from clubface.design.golfer.golfers import golfer, golfers

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
    from clubface.design.golfer.file import to_toml
    from clubface.design.golfer.golfers import golfer as golfer_named

    output.check_report(report, (golfer,))
    found = golfer_named(golfer)
    if report is not None:
        from clubface.equipment.clubs import CLUB_NAMES, club

        hand = "right" if found.hand > 0 else "left"
        head = club(found.club).replace(hand=hand) if found.club in CLUB_NAMES else None
        write_report(report, found, head, lambda: _print(found))
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
    from clubface.design.golfer.estimate import estimate_golfer
    from clubface.design.golfer.file import to_toml
    from clubface.equipment.clubs import CLUB_NAMES

    output.check_target("--output", target, (".toml",), [*files, texts["mapping"], texts["club"], like])
    output.check_report(report, [*files, texts["mapping"], texts["club"], like])
    shots = recorded_shots(files, texts)
    found = estimate_golfer(shots, name=name, like=like)
    if target is not None:
        from clubface.support.whole_file import write_text

        write_text(target, to_toml(found.golfer))
        own = "" if found.golfer.club in CLUB_NAMES else f" --club {texts['club']}"
        say(f"wrote {target}; clubface dispersion {target}{own} takes it")
    if report is not None:

        def tables() -> None:
            _print(found.golfer, found)
            output.print_notes(found.notes)

        write_report(report, found.golfer, shots.club, tables, found)
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
    from clubface.design.golfer.golfer import UNIT
    from clubface.simulation.delivery import OF_CLUB

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
