"""Loft fitting: the best dynamic loft for a golfer by each objective, and the range that makes no difference.

It is an optimisation of the loft alone and gives the same advice; a player's report puts it in sentences.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from clubface import units
from clubface.design.golfer import Golfer, golfer as golfer_of, own_club
from clubface.design.golfer_estimate import estimate_golfer
from clubface.design.optimisation.advice import (
    BETTER,
    WORTHS,
    Advice,
    advice_lead,
    advice_notes,
    advice_tables,
    is_at_an_end,
    losses_in_words,
    short_label,
)
from clubface.design.optimisation.landings import Objective, Setting
from clubface.design.optimisation.result import Optimum, study_provenance
from clubface.design.optimisation.run import REPEATS, judged, optimise
from clubface.design.optimisation.study import DesignStudy
from clubface.design.strokes import Hole
from clubface.equipment.balls import Ball, ball as ball_named
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.errors import ClubfaceError, InputError
from clubface.inference.player_statistics import ClubStatistics
from clubface.quantities import quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, row_names
from clubface.simulation.flight import AirLike, GroundLike, WindLike, check_conditions
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import OF_CLUB
from clubface.support.arrays import Floats

SPAN = units.parse("8 deg", "angle")
"""Range of lofts tried on either side of the present one [rad]."""
STEPS = 33
"""Number of lofts on the curve, half a degree apart."""
SHOTS = 4096
STARTS = 3


@dataclass(frozen=True, kw_only=True, eq=False)
class LoftFit(Described):
    """The result of a loft fitting.

    Attributes
    ----------
    optimum, present
        The optimisation of the loft, and the present mean dynamic loft [rad].
    lofts
        Dynamic lofts of the curve [rad], shape (lofts,).
    values
        Objectives of these lofts [SI], shape (lofts, objectives), in the order of the advice.
    """

    optimum: Optimum
    present: float
    lofts: Floats
    values: Floats

    @property
    def objectives(self) -> tuple[Objective, ...]:
        """Objectives by which lofts are compared, the requested one first."""
        return self.optimum.study.advised

    def loft(self, club: str) -> float:
        """Return the dynamic loft [rad] of a club of the optimisation: "optimum" or the name of an objective."""
        change = self.optimum.fields(club)["loft"] - self.optimum.study.club.loft
        return self.present + change

    def best(self, name: str) -> float:
        """Return the best dynamic loft for an objective [rad]."""
        best = self.optimum.advice.best(name)
        return self.loft(list(self.optimum.compared.values())[best]) if best else self.present

    def flat(self, name: str) -> tuple[float, float]:
        """Return the range of dynamic lofts [rad] whose loss is too small to be worth a change.

        The curve is interpolated linearly. If the range stops at an end of the curve, it may extend farther.
        """
        column = [each.name for each in self.objectives].index(name)
        behind = self.objectives[column].sign * self.values[:, column]
        behind = behind - behind.min() - self.optimum.study.worth[name]
        best = int(np.argmin(behind))
        ends = []
        for side in (slice(best, None, -1), slice(best, None)):
            lofts, losses = self.lofts[side], behind[side]
            beyond = int(np.argmax(losses >= 0.0))  # the first loft worse by a difference worth a change; 0 for none
            pair = slice(beyond - 1, beyond + 1)
            ends.append(float(np.interp(0.0, losses[pair], lofts[pair]) if beyond else lofts[-1]))
        return ends[0], ends[1]

    @cached_property
    def advice(self) -> Advice:
        """Advice on the present loft and the best loft for each objective."""
        names = [f"present {units.fixed(self.present, 'deg', 1)} of dynamic loft"]
        clubs = list(self.optimum.compared.values())
        names += [self._words(club) for club in clubs[1:]]
        study = self.optimum.study
        varies = any(each.spread.any() for each, _ in study.golfers)
        conditions = study.describe_conditions(self.optimum.fresh.shots if varies else 1)
        ends = tuple(place for place, club in enumerate(clubs) if place and self.is_at_an_end(club))
        return replace(self.optimum.advice, names=tuple(names), conditions=conditions, at_an_end=ends)

    def is_at_an_end(self, club: str) -> bool:
        """Return whether a club of the optimisation has the lowest or highest loft tried."""
        return is_at_an_end(self.loft(club), (float(self.lofts[0]), float(self.lofts[-1])))

    def _words(self, club: str) -> str:
        loft = self.loft(club)
        side = "more" if loft > self.present else "less"
        change = units.fixed(abs(loft - self.present), "deg", 1)
        return f"{units.fixed(loft, 'deg', 1)} of dynamic loft, {change} {side}"

    def to_result(self) -> Result:
        """Return lofts, advice and curve as a result."""
        study, advice = self.optimum.study, self.advice
        lofts = [self.present, *(self.loft(club) for club in list(self.optimum.compared.values())[1:])]
        tables = advice_tables(advice, [column("loft", lofts, "loft", label="dynamic loft")])
        return Result(
            kind="loft-fit", title=f"{study.title}, {study.club.name}",
            tables=(_lofts_table(self), *tables, _curve_table(self)),
            lead=(*advice_lead(advice), *_flat_notes(self)), notes=(note("best-loft-delivered"), *advice_notes(advice)),
            provenance=study_provenance(study, [study.club]), draw=lambda: [loft_fit_picture(self)],
        )  # fmt: skip


def fit_loft(
    golfer: str | os.PathLike[str] | Golfer,
    *,
    club: str | os.PathLike[str] | Club | None = None,
    objective: str = "carry",
    worth: Mapping[str, float | str] | None = None,
    hole: Hole | None = None,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    shots: int = SHOTS,
    seed: int = 1,
    progress: Callable[[int, int, str], object] | None = None,
) -> LoftFit:
    """Return the best dynamic loft for a golfer by each objective, and what it gains.

    A degree of static loft changes dynamic loft by a degree, as in an optimisation.

    Parameters
    ----------
    golfer
        A golfer, or a name or file of one; :func:`steady_golfer` for a single delivery.
    club
        The club delivered; default the golfer's own.
    objective
        "carry", "total", "side_spread", "ellipse" or "strokes".
    worth, progress
        As for :func:`clubface.best_loft` and :func:`clubface.optimise`.
    hole
        The hole on which strokes are counted.
    model, parameters, ball, air, wind, ground
        As for :func:`clubface.impact` and :func:`clubface.fly`; the model must have derivatives.
    shots, seed
        Number of shots and seed of their random numbers.

    Raises
    ------
    InputError
        The golfer's shots cannot be computed, or an objective, a model or a condition is unknown.
    """
    player = golfer_of(golfer)
    head = own_club(player) if club is None else club_named(club)
    reduced_model(model, "one with derivatives")
    check_conditions(air=air, wind=wind, ground=ground)
    own_ball = None if ball is None else ball_named(ball)
    setting = Setting(model=model, parameters=parameters, ball=own_ball, air=air, wind=wind, ground=ground)
    least, most = max(head.loft - SPAN, 0.0), head.loft + SPAN
    study = DesignStudy(
        title=f"The loft for {player.title or player.name}", club=head, golfers=((player, 1.0),),
        objectives=(objective,), bounds={"loft": (least, most)}, conform=False, hole=hole, setting=setting,
        shots=shots, seed=seed, starts=STARTS, worth=worth or {},  # pyright: ignore[reportArgumentType]
    )  # fmt: skip
    if not player.spread.any():
        study = replace(study, shots=REPEATS)
    optimum = optimise(study, progress=progress)
    means = dict(zip(player.variables, player.mean, strict=True))
    present = float(means.get("loft", head.loft))
    golfers = study.landings(study.shots, seed=seed)
    places = [[each.name for each in study.known()].index(each.name) for each in study.advised]
    statics = np.linspace(least, most, STEPS)
    values = np.array([judged(study, golfers, {"loft": float(loft)}) for loft in statics])[:, places]
    return LoftFit(optimum=optimum, present=present, lofts=present + statics - head.loft, values=values)


def steady_golfer(club: str = "driver", **delivery: float | str) -> Golfer:
    """Return a golfer whose every delivery is the same.

    ``delivery`` holds values as for :class:`clubface.Delivery`, text with a unit or SI numbers; speed and loft are
    required.
    """
    from clubface.simulation.inputs import DIMENSIONS

    for name in ("speed", "loft"):
        if delivery.get(name) is None:
            raise InputError(name, None, f"give it, as in {name}={'91 mph' if name == 'speed' else '15.5 deg'!r}")
    values = {name: units.parse(value, DIMENSIONS[name], name=name) for name, value in delivery.items()}
    words = [f"{name} {units.show(value, 'mph' if name == 'speed' else 'deg', 3)}" for name, value in values.items()]
    return Golfer(
        name="delivery", title=f"a delivery with {', '.join(words)}", club=club, variables=tuple(values),
        mean=np.array(list(values.values())), covariance=np.zeros((len(values), len(values))),
        sources={f"{part} of {name}": "given" for name in values for part in ("mean", "spread")},
    )  # fmt: skip


def _lofts_table(fitted: LoftFit) -> Table:
    judges = fitted.objectives
    flat = [fitted.flat(each.name) for each in judges]
    columns = (
        *row_names("objective", [each.name for each in judges], [each.quantity.label for each in judges]),
        column("loft", [fitted.best(each.name) for each in judges], "loft", label="best loft"),
        column("flat_from_loft", [low for low, _ in flat], "loft", label="as good from"),
        column("flat_to_loft", [high for _, high in flat], "loft", label="to"),
        Column("worth", [fitted.advice.worth[each.name] for each in judges], [each.quantity for each in judges],
               "within"),
    )  # fmt: skip
    return Table("lofts", columns, "Best dynamic loft by objective")


def _flat_notes(fitted: LoftFit) -> Iterator[Note]:
    judge = fitted.objectives[0]
    low, high = fitted.flat(judge.name)
    yield note(
        "best-loft-flat", label=short_label(judge), best_loft=fitted.best(judge.name), low_loft=low, high_loft=high,
        worth=judge.show(fitted.advice.worth[judge.name]),
    )  # fmt: skip
    advice = fitted.advice
    if beyond := [short_label(each) for each in fitted.objectives if advice.best(each.name) in advice.at_an_end]:
        ends = float(fitted.lofts[0]), float(fitted.lofts[-1])
        yield note("best-loft-at-an-end", labels=beyond, low_loft=ends[0], high_loft=ends[1])


def _curve_table(fitted: LoftFit) -> Table:
    columns = (
        column("loft", fitted.lofts, "loft"),
        *(Column(judge.name, [float(each) for each in fitted.values[:, place]], judge.quantity)
          for place, judge in enumerate(fitted.objectives)),
    )  # fmt: skip
    return Table("curve", columns, "Objectives over dynamic loft", printed=False)


def loft_fit_picture(fitted: LoftFit) -> Picture:
    """Return the gain of each loft over the present one by objective, in multiples of what is worth a change."""
    marks = [Mark("rule", x=fitted.present, style=-2, dash=1), Mark("rule", y=[-1.0, 0.0, 1.0], style=-1)]
    for style, judge in enumerate(fitted.objectives):
        worth = fitted.advice.worth[judge.name]
        behind = judge.sign * fitted.values[:, style]
        gain = (float(np.interp(fitted.present, fitted.lofts, behind)) - behind) / worth
        marks.append(Mark("line", fitted.lofts, gain, style=style, label=f"{short_label(judge)}, {judge.show(worth)}"))
    panel = Panel(
        marks, axis("loft", quantity("loft").label), Axis(WORTHS, limits=(-4.0, 4.0)),
        "Gain over the present loft (dashed); from -1 to 1 it is not worth a change", legend=True,
    )  # fmt: skip
    return Picture("loft-fit", "Gain of each loft over the present one, by objective", [[panel]], height=3.6)


def player_loft_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield what another loft would gain in carry, then in other objectives; nothing if the delivery is unknown.

    They are those of ``clubface best-loft --golfer``. Too few shots for a golfer count as one with the inferred mean
    delivery, and strokes are left out, since they depend on the spread of the shots.
    """
    if club.club is None or club.inferred is None:
        return
    player = _club_golfer(club)
    fitted = fit_loft(player, club=club.club)
    advice = fitted.advice
    changed = advice.recommended()
    best = changed or advice.best("carry")
    data = {
        "club": club.name, "change_loft": fitted.best("carry") - fitted.present,
        "gain_carry": advice.gain("carry", best), "worth_carry": advice.worth["carry"],
    }  # fmt: skip
    yield note("player-loft-change" if changed else "player-loft-keep" if best else "player-loft-best", **data)
    for judge in fitted.objectives:
        other = advice.best(judge.name)
        is_known = judge.name != "strokes" or bool(player.spread.any())
        if (
            judge.name in ("total", "strokes")
            and other != best
            and advice.state(judge.name, other) == BETTER
            and is_known
        ):
            losses = losses_in_words(advice, judge.name, other)
            yield note(
                "player-loft-other-costs" if losses else "player-loft-other", label=short_label(judge), losses=losses,
                change_loft=fitted.best(judge.name) - fitted.present, gain=judge.show(advice.gain(judge.name, other)),
            )  # fmt: skip


def _club_golfer(club: ClubStatistics) -> Golfer:
    """Return the golfer estimated from the shots or, if they are too few, one who always delivers the inferred mean."""
    assert club.club is not None
    assert club.inferred is not None
    try:
        return estimate_golfer(club.shots, club=club.club).golfer
    except ClubfaceError:
        delivery = {name: value for name, value in club.inferred.mean.items() if name in OF_CLUB}
        return steady_golfer(club.club.name, **delivery).replace(hand=club.club.hand)
