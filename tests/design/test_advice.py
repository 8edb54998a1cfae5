"""Advice: what is worth a change, what is not ranked, and that no command contradicts another."""

import json
import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import clubface
from clubface import club, units
from clubface.design.golfer import golfer
from clubface.design.loft_fit import LoftFit, fit_loft, steady_golfer
from clubface.design.optimisation.advice import (
    ALIKE,
    BETTER,
    OPEN,
    WORSE,
    WORTH,
    Advice,
    advice_lead,
    advice_tables,
    judge_sets,
    worth_of,
)
from clubface.design.optimisation.landings import DEFAULT_SETTING, OBJECTIVES, Landings, strokes
from clubface.design.optimisation.run import optimise
from clubface.design.optimisation.study import from_text
from clubface.design.strokes import Hole
from clubface.errors import ClubfaceError, InputError
from clubface.present.document import Bullets, Paragraph
from clubface.present.report import report_blocks
from clubface.results.result import Result

YARD, DEG = 0.9144, math.radians(1.0)
HOLE = Hole(length="400 yd")
CARRY, STROKES = OBJECTIVES["carry"], strokes(HOLE)


def advice(carries, stroke_counts=None, noise=0.0, **more):
    """Return advice on alternatives with these carries [yd] and strokes; sets differ by ``noise`` [yd of carry]."""
    stroke_counts = [3.0] * len(carries) if stroke_counts is None else stroke_counts
    values = np.column_stack([np.array(carries) * YARD, stroke_counts])
    sets = np.repeat(values[:, None], 16, axis=1)
    sets[1:, :, 0] += noise * YARD * np.where(np.arange(16) % 2, 1.0, -1.0)
    return Advice(
        purpose="carry", golfer="a golfer", objectives=(CARRY, STROKES), names=tuple("abcdefgh"[: len(carries)]),
        values=values, sets=sets, worth=WORTH, **more,
    )  # fmt: skip


def opening(one):
    return next(advice_lead(one)).code


def test_a_certain_but_negligible_difference_is_not_ranked():
    """0.05 yd with a standard error of 0 is below 2 yd: nothing is ranked, and the present club stays."""
    one = advice([200.0, 200.05])
    assert one.error("carry", 1) == 0.0
    assert one.state("carry", 1) == ALIKE
    assert one.recommended() == 0
    assert one.ranks([0, 1]) == {0: 1, 1: 1}
    assert opening(one) == "advice-keep-all"
    assert opening(replace(one, worth=worth_of({"carry": "0.04 yd"}))) == "advice-change"


def test_a_difference_is_worth_a_change_where_it_is_large_and_certain():
    """Alternating sets of 16 by +-1 have a standard error of sqrt(16 / 15) / 4 = 0.258."""
    assert advice([200.0, 203.0], noise=1.0).error("carry", 1) == pytest.approx(math.sqrt(16 / 15) / 4 * YARD)
    assert advice([200.0, 203.0], noise=1.0).state("carry", 1) == BETTER
    assert advice([200.0, 197.0], noise=1.0).state("carry", 1) == WORSE
    assert advice([200.0, 203.0], noise=8.0).state("carry", 1) == OPEN
    assert advice([200.0, 201.9], noise=1.0).state("carry", 1) == OPEN
    assert opening(advice([200.0, 203.0], noise=8.0)) == "advice-not-certain"


def test_alternatives_that_do_not_differ_share_a_rank_and_the_next_starts_after_them():
    ranks = advice([200.0, 207.0, 206.0, 201.0, 190.0]).ranks(range(5))
    assert ranks == {1: 1, 2: 1, 3: 3, 0: 3, 4: 5}


def test_among_equals_the_one_with_the_least_cost_elsewhere_is_recommended():
    one = advice([200.0, 207.0, 206.0], [3.0, 3.05, 3.0])
    assert one.recommended() == 2
    assert replace(one, choices=(1,)).recommended() == 1
    codes = [each.code for each in advice_lead(one)]
    assert codes[0] == "advice-change"
    assert "advice-as-good" in codes
    assert "advice-holds" in codes
    assert "advice-costs" in [each.code for each in advice_lead(replace(one, choices=(1,)))]


def test_a_smaller_certain_gain_beats_a_larger_uncertain_one():
    """7 yd that may be chance and 3 yd that are none: sentence and table both choose the 3 yd."""
    one = advice([200.0, 207.0, 203.0])
    one.sets[1, :, 0] += 32.0 * YARD * np.where(np.arange(16) % 2, 1.0, -1.0)
    assert [one.state("carry", place) for place in (1, 2)] == [OPEN, BETTER]
    assert one.recommended() == one.best("carry") == 2
    by_objective = advice_tables(one)[0]
    assert (by_objective["advice"].values[0], by_objective["best"].values[0]) == ("change", "c")


def test_a_disagreement_of_objectives_is_one_note_with_the_numbers():
    one = advice([200.0, 203.0, 197.0], [3.0, 3.03, 2.97])
    (wishes,) = [each.data["wishes"] for each in advice_lead(one) if each.code == "advice-by-objective"]
    assert ["better by 3.00 yd" in each for each in wishes] == [True, False]
    assert ["better by 0.0300" in each for each in wishes] == [False, True]
    by_objective = advice_tables(one)[0]
    assert list(by_objective["best"].values) == ["b", "c"]
    assert list(by_objective["advice"].values) == ["change", "change"]
    assert "advice-by-objective" not in [each.code for each in advice_lead(advice([200.0, 203.0], [3.0, 2.97]))]


def test_the_best_for_each_objective_does_not_depend_on_the_purpose():
    """Sentence and table have the best of each, and a report on strokes has the row of the report on carry."""
    on_carry = advice([200.0, 207.0, 206.0], [3.0, 3.05, 3.0])
    on_strokes = replace(
        on_carry, purpose="strokes", objectives=on_carry.objectives[::-1], values=on_carry.values[:, ::-1],
        sets=on_carry.sets[:, :, ::-1],
    )  # fmt: skip
    rows = []
    for one in (on_carry, on_strokes):
        table = advice_tables(one)[0]
        of_table = {name: (best, gain, price) for name, best, gain, price in zip(
            *(table[name].values for name in ("objective", "best", "gain", "price")), strict=True)}  # fmt: skip
        rows.append(of_table)
        (wishes,) = [each.data["wishes"] for each in advice_lead(one) if each.code == "advice-by-objective"]
        for wish, judge in zip(wishes, one.objectives, strict=True):
            assert of_table[judge.name][0] in (wish.split(", ")[1].split(" ")[0], "a"), wish
    assert rows[0] == rows[1]
    assert rows[0]["carry"][0] == "b"
    assert rows[0]["carry"][1] == pytest.approx(7.0 * YARD)


def test_a_gain_that_costs_something_else_is_shown_with_its_price():
    one = replace(advice([200.0, 150.0], [3.0, 2.9]), at_an_end=(1,))
    (wishes,) = [each.data["wishes"] for each in advice_lead(one) if each.code == "advice-by-objective"]
    assert "50.00 yd" in wishes[1]
    assert "at an end" in wishes[1]
    assert one.losses("strokes", 1) == pytest.approx({"carry": 50.0 * YARD})
    assert "50.00 yd" in advice_tables(one)[0]["price"].values[1]
    free = advice([200.0, 203.0], [3.0, 2.9])
    assert free.losses("strokes", 1) == {}
    assert list(advice_tables(free)[0]["price"].values) == ["", ""]


def test_a_report_has_the_advice_as_one_sentence_and_a_list():
    lead = tuple(advice_lead(advice([200.0, 203.0, 197.0], [3.0, 3.03, 2.97])))
    blocks = list(report_blocks(Result("advice", "Advice", lead=lead)))
    paragraphs = [each.texts for each in blocks if isinstance(each, Paragraph)]
    lists = [list(each.texts) for each in blocks if isinstance(each, Bullets)]
    assert (lead[0].sentence,) in paragraphs
    assert [each.sentence for each in lead[1:]] in lists


def test_strokes_are_counted_on_the_assumed_hole_where_none_is_given():
    """As a column and as the objective alike; an iron, for which no hole is assumed, needs one."""
    words = {"golfer": "bogey-driver", "objective": "strokes", "shots": 64}
    for text in (STUDY, FIT):
        without = text.replace('[hole]\nlength = "400 yd"\n', "").format(**words)
        assert from_text(without).advised[0].name == "strokes"
        with pytest.raises(ClubfaceError, match="hole"):
            from_text(without.replace('"driver"', '"7-iron"'))


def test_the_standard_error_is_that_of_shots_that_pair():
    """Means of n independent differences of deviation s err by s / sqrt(n); 16 sets know that to 18%: 3 of them."""
    shots = Landings(club("driver"), golfer("bogey-driver").sample(1600, seed=4), DEFAULT_SETTING)
    landed = shots.of({})
    random = np.random.default_rng(1)
    other = landed + 3.0 * random.standard_normal(landed.shape)
    sets = [judge_sets([CARRY], [(shots, 1.0, each)])[:, 0] for each in (landed, other)]
    error = np.std(sets[1] - sets[0], ddof=1) / 4.0
    assert error == pytest.approx(3.0 / math.sqrt(shots.count), rel=0.54)


def test_sets_hold_the_same_deliveries_though_some_miss():
    """Deliveries 0 to 99 with every seventh missing: each of 4 sets has those of its own 25."""
    shots = Landings.__new__(Landings)
    shots.kept = np.array([each for each in range(100) if each % 7])
    shots.count, shots.missed = len(shots.kept), 100 - len(shots.kept)
    parts = shots.split(shots.kept[None].astype(float), 4)
    assert [(part.min() // 25, part.max() // 25) for part in parts] == [(place, place) for place in range(4)]


def test_the_worth_of_a_change_is_read_with_units_and_known_names():
    assert worth_of({"carry": "3 yd", "strokes": "0.02"}) == {**WORTH, "carry": 3 * YARD, "strokes": 0.02}
    with pytest.raises(InputError, match=r"worth\.carry"):
        worth_of({"carry": "-1 yd"})
    with pytest.raises(ValueError, match="carry"):
        worth_of({"cary": "1 yd"})
    study = from_text(STUDY.format(golfer="bogey-driver", objective="carry", shots=64) + '[worth]\ntotal = "4 yd"\n')
    assert study.worth == {**WORTH, "total": 4 * YARD}


def test_the_default_for_strokes_is_about_that_for_distance():
    """The stated reason: a yard costs 0.003 to 0.006 strokes, a yard of spread 0.014 to 0.017."""
    for name in ("tour-driver", "women-15-driver"):
        landed = Landings(club("driver"), golfer(name).sample(8192, seed=1), DEFAULT_SETTING).of({})
        shorter, wider = landed.copy(), landed.copy()
        shorter[2] -= YARD
        ahead = np.sqrt(landed[2] ** 2 - landed[3] ** 2)
        wider[3] *= 1.0 + YARD / landed[1].std()
        wider[2] = np.hypot(ahead, wider[3])
        before = STROKES.judge(landed)[0]
        assert 0.0025 < STROKES.judge(shorter)[0] - before < 0.0065
        assert 0.013 < STROKES.judge(wider)[0] - before < 0.0175


STUDY = """title = "t"
golfer = "{golfer}"
objective = "{objective}"
shots = {shots}
starts = 3
club = "driver"
[hole]
length = "400 yd"
[rules]
conform = false
[variables]
loft = ["1.8 deg", "17.8 deg"]
"""
FIT = """title = "t"
golfer = "{golfer}"
objective = "{objective}"
shots = {shots}
[hole]
length = "400 yd"
[fit]
clubs = ["driver"]
loft = ["-8 deg", "8 deg"]
"""
GOLFERS = (pytest.param("tour-driver", marks=pytest.mark.study), "bogey-driver", "women-15-driver")
SHOTS = 512


@pytest.fixture(scope="module")
def commands():
    """What gives the advice of the three commands on a golfer for an objective."""

    @cache
    def advise(name, objective):
        words = {"golfer": name, "objective": objective, "shots": SHOTS}
        return {
            "optimise": optimise(from_text(STUDY.format(**words))).advice,
            "fit": clubface.fit(from_text(FIT.format(**words))).advice,
            "best-loft": fit_loft(name, objective=objective, hole=HOLE, shots=SHOTS).advice,
        }

    return advise


def slack(one, other, name):
    """Return how far two commands may be apart: what is worth a change, and what their different shots leave open."""
    errors = [each.error(name, each.best(name)) for each in (one, other)]
    return one.worth[name] + 3.0 * math.hypot(*errors)


@pytest.mark.parametrize("name", GOLFERS)
@pytest.mark.parametrize("objective", ["carry", "strokes"])
def test_all_commands_give_one_advice_for_one_objective(commands, name, objective):
    """What the best loft gains is the same in all, within what is worth a change; so is what to do, unless it is near
    that."""
    first, *others = commands(name, objective).values()
    for other in others:
        for judge in first.objectives:
            gains = [each.gain(judge.name, each.best(judge.name)) for each in (first, other)]
            assert abs(gains[0] - gains[1]) < slack(first, other, judge.name), judge.name
            if all(abs(gain - first.worth[judge.name]) > 0.3 * first.worth[judge.name] for gain in gains):
                assert bool(first.recommended(judge.name)) == bool(other.recommended(judge.name)), judge.name


@pytest.mark.parametrize("name", GOLFERS)
def test_a_report_on_one_objective_says_what_the_report_on_another_does(commands, name):
    """The row of strokes in the report on carry is that of carry's in the report on strokes, and the other way."""
    for command, carry in commands(name, "carry").items():
        strokes_ = commands(name, "strokes")[command]
        for objective in ("carry", "strokes", "total"):
            gains = [each.gain(objective, each.best(objective)) for each in (carry, strokes_)]
            assert abs(gains[0] - gains[1]) < slack(carry, strokes_, objective)


def test_every_command_advises_the_bogey_golfer_to_keep_his_loft(commands):
    """Carry asks for about a degree more, strokes for two less, and neither is worth a change."""
    for objective in ("carry", "strokes"):
        for command, one in commands("bogey-driver", objective).items():
            assert one.recommended() == 0, command
            (wishes,) = [each.data["wishes"] for each in advice_lead(one) if each.code == "advice-by-objective"]
            assert len(wishes) == 4


def test_one_delivery_agrees_with_the_table_of_best_lofts():
    """The table turns the head with the loft, the fit leaves it and changes the static loft: within 0.3 degrees."""
    table = clubface.best_loft("91 mph", "-1.6 deg")
    fitted = fit_loft(steady_golfer(speed="91 mph", attack="-1.6 deg", loft="15.5 deg"))
    assert fitted.best("carry") / DEG == pytest.approx(table.loft[0] / DEG, abs=0.3)
    low, high = fitted.flat("carry")
    assert low / DEG == pytest.approx((table.loft[0] - table.within[0, 0]) / DEG, abs=0.5)
    assert high / DEG == pytest.approx((table.loft[0] + table.within[0, 1]) / DEG, abs=0.5)
    assert fitted.advice.recommended() == 0
    assert [fitted.advice.error(each.name, 1) for each in fitted.objectives] == pytest.approx([0.0] * 4, abs=1e-12)


def test_the_flat_range_is_where_a_parabola_has_lost_what_is_worth_a_change():
    """Carry 200 m - (loft / 1 deg)^2 m: 2 yd are lost sqrt(1.8288) = 1.352 degrees away; chords of half a degree err by
    0.25^2 m of height at most, 0.024 degrees there."""
    fitted = fit_loft(steady_golfer(speed="91 mph", loft="15.5 deg"))
    lofts = np.arange(-8.0, 8.01, 0.5) * DEG
    values = np.tile(200.0 - (lofts[:, None] / DEG) ** 2, (1, len(fitted.objectives)))
    curve = LoftFit(optimum=fitted.optimum, present=0.0, lofts=lofts, values=values)
    low, high = curve.flat("carry")
    assert [low / DEG, high / DEG] == pytest.approx([-1.352, 1.352], abs=0.025)


def test_parts_without_effect_are_named():
    """The same ball under another name changes nothing; two degrees of loft change carry and strokes."""
    text = FIT.replace('loft = ["-8 deg", "8 deg"]\n', 'balls = ["modern", "distance"]\n')
    text += '[[fit.setting]]\nname = "as it is"\n[[fit.setting]]\nname = "strong"\nloft = "-4 deg"\n'
    fitted = clubface.fit(from_text(text.format(golfer="bogey-driver", objective="carry", shots=512)))
    by_part = {part: {each.objective: each for each in fitted.effects if each.part == part} for part in
               ("ball", "setting")}  # fmt: skip
    assert not any(each.matters for each in by_part["ball"].values())
    assert by_part["setting"]["carry"].matters
    values = {(each.ball, each.setting): each.value for each in fitted}
    most = max(abs(values["modern", one] - values["distance", one]) for one in ("as it is", "strong"))
    assert by_part["ball"]["carry"].difference == pytest.approx(most, rel=1e-12)
    codes = {each.code: each.data for each in fitted.to_result().lead}
    assert codes["fitting-parts-idle"]["parts"] == ["ball"]


def test_a_steady_golfer_needs_speed_and_loft():
    with pytest.raises(InputError, match="loft"):
        steady_golfer(speed="91 mph")


def test_worth_of_the_command_wins_and_changes_the_advice(clubface_, tmp_path):
    file = tmp_path / "fit.toml"
    file.write_text(FIT.format(golfer="bogey-driver", objective="carry", shots=512) + '[worth]\ncarry = "3 yd"\n')
    codes = {}
    for option in ((), ("--worth", "carry=0.1 yd")):
        document = clubface_("optimise", str(file), *option, "--json").json
        codes[option] = document["summary"][0]["code"]
        worth = {each["objective"]: each for each in document["tables"]["advice"]["rows"]}["carry"]["worth"]
        assert worth == pytest.approx(units.parse("0.1 yd" if option else "3 yd", "length"))
    assert list(codes.values()) == ["advice-keep", "advice-change"]


def test_best_loft_advises_a_golfer_or_one_delivery(clubface_):
    document = clubface_("best-loft", "--speed", "91 mph", "--attack", "-1.6 deg", "--loft", "15.5 deg", "--json").json
    rows = {each["objective"]: each for each in document["tables"]["lofts"]["rows"]}
    assert rows["carry"]["flat_from_loft_deg"] < rows["carry"]["loft_deg"] < rows["carry"]["flat_to_loft_deg"]
    assert document["summary"][0]["code"].startswith("advice-keep")
    assert json.dumps(document).count("NaN") == 0
    ran = clubface_("best-loft", "--speed", "91 mph", "--objective", "strokes")
    assert ran.status == 2
    assert "--golfer" in ran.err
