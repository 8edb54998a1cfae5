"""The loft of a player's driver, in sentences of his report: judged as every other command that advises on loft."""

from __future__ import annotations

from collections.abc import Iterator

from clubface.design.golfer import Golfer
from clubface.design.golfer_estimate import estimate_golfer
from clubface.design.loft_fit import fit_loft, steady_golfer
from clubface.design.optimisation.advice import BETTER, losses_in_words, short_label
from clubface.errors import ClubfaceError
from clubface.inference.player_statistics import ClubStatistics
from clubface.results.notes import Note, note
from clubface.simulation.inputs import OF_CLUB

__all__ = ["player_loft_notes"]


def player_loft_notes(club: ClubStatistics) -> Iterator[Note]:
    """Yield what another loft of a club is worth by carry, then by what else counts; nothing without its delivery.

    It is :func:`clubface.design.fit_loft` for the golfer of the shots, so that the report says what ``clubface
    best-loft --golfer`` does. Where they are too few for a golfer, it is that of the mean delivery that was inferred,
    without strokes, which depend on how the shots spread.
    """
    if club.club is None or club.inferred is None:
        return
    player = _golfer(club)
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


def _golfer(club: ClubStatistics) -> Golfer:
    """Return the golfer of the shots, or one who always delivers the inferred mean where they are too few for one."""
    assert club.club is not None
    assert club.inferred is not None
    try:
        return estimate_golfer(club.shots, club=club.club).golfer
    except ClubfaceError:
        delivery = {name: value for name, value in club.inferred.mean.items() if name in OF_CLUB}
        return steady_golfer(club.club.name, **delivery).replace(hand=club.club.hand)
