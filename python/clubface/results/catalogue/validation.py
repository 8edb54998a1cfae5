"""Sentences about validations, tour averages and the chart of drives."""

SENTENCES = {
    "chart-is-model": "The chart is a model, and judges none.",
    "chart-loft": (
        "I w/(m R v_t) is {ratio:.3f}, with a standard deviation of {deviation:.3f}, so that every dynamic loft is "
        "launch + asin(I w/({ratio:.3f} m R v)) to {error_loft:2}."
    ),
    "chart-spin": (
        "{model} struck {struck} has the spin of these {drives} drives to {mean:+.1%} on average, with a standard "
        "deviation of {deviation:.1%}."
    ),
    "check-reason": "{check}: {reason}",
    "own-monitor-camps": (
        "resembles: the camp of published irons in which the whole interval lies, each camp being wider by half of the "
        "gap between both; undecided if it crosses a border."
    ),
    "own-monitor-index": (
        "index: spin over club speed times the sine of the angle from path to launch; of 7-irons {tours_least:.0f} to "
        "{tours_most:.0f} in the averages of tours, {single_least:.0f} to {single_most:.0f} with robots and single "
        "golfers."
    ),
    "own-monitor-irons": "irons resemble: {camps}",
    "own-monitor-left-out": "{club}: left out ({reason})",
    "own-monitor-share": (
        "measured/model: at the measured launch, with loft and face angle solved, by {model}; the interval is that of "
        "shots drawn again. A head or ball of your own may be some percent away from those computed with."
    ),
    "own-monitor-strike": "drives are taken to be struck {high:0} above the face centre",
    "published-table": "{title}: {source}.",
    "tour-ball": "Ball: {balls}.",
    "tour-heads": (
        "Only driver and 7-iron are measured heads (not those of the tour); the other clubs are a plausible parametric "
        "set. Models with published parameters use those of driver or 7-iron for them."
    ),
    "tour-in-doubt": "{averages} is in doubt: {caveat}",
    "tour-left-out": "{averages}: left out, as there is no head for it: {clubs}.",
    "tour-lofts-published": (
        "{averages}: dynamic loft is published for {clubs:and} only, and used by every model. Elsewhere each model has "
        "the loft with which it launches the ball at the published angle, so that its launch angle is no prediction "
        "there and has no error."
    ),
    "tour-lofts-solved": (
        "{averages}: no dynamic loft is published that belongs to these averages (only to {others:and}): each model "
        "has the loft with which it launches the ball at the published angle, so that its launch angle is no "
        "prediction."
    ),
    "tour-ratio": (
        "I w / (m R v_t) is {rigid:.0f} for a ball that stays round and {flattened:.2f} to 0.95 for one that is "
        "flattened; over the face of first touch, which turns with its head, it is larger. The possible lofts are "
        "those with which the published launch has {rigid:.0f} to {flattened:.2f}. With a loft further outside than "
        "the head turns, half a degree for woods and one for irons, its figures cannot belong to one shot."
    ),
    "tour-strike": (
        "Impact at the face centre, path and face square. Carries of the models are flights of their own launches; "
        "'flight only' is the flight from the published launch."
    ),
    "validation-misses": "{model}: furthest outside the tolerance, with the mean error: {missed:and}.",
    "validation-verdict": (
        "{model}: in {met} of {quantities} measured quantities the mean error is within the tolerance, in {every} "
        "every error is."
    ),
}
