"""Sentences about validations, tour averages and the chart of drives."""

SENTENCES = {
    "chart-is-model": "The chart is itself a model, so it cannot test one.",
    "chart-loft": (
        "I w/(m R v_t) is {ratio:.3f}, with a standard deviation of {deviation:.3f}, so every dynamic loft is "
        "launch + asin(I w/({ratio:.3f} m R v)) to {error_loft:2}."
    ),
    "chart-spin": (
        "{model} struck {struck} has the spin of these {drives} drives to {mean:+.1%} on average, with a standard "
        "deviation of {deviation:.1%}."
    ),
    "check-reason": "{check}: {reason}",
    "own-monitor-camps": (
        "resembles: the camp of published irons that contains the whole interval, each camp being widened by half of "
        "the gap between them; undecided if it crosses a border."
    ),
    "own-monitor-index": (
        "index: spin over club speed times the sine of the angle from path to launch; for 7-irons {tours_least:.0f} to "
        "{tours_most:.0f} in tour averages, {single_least:.0f} to {single_most:.0f} with robots and single golfers."
    ),
    "own-monitor-irons": "irons resemble: {camps}",
    "own-monitor-left-out": "{club}: left out ({reason})",
    "own-monitor-share": (
        "measured/model: at the measured launch, with loft and face angle solved, for {model}; the interval is from "
        "a bootstrap. Your own head or ball may differ by some percent from those in the model."
    ),
    "own-monitor-strike": "drives are assumed to be struck {high:0} above the face centre",
    "published-table": "{title}: {source}.",
    "tour-ball": "Ball: {balls}.",
    "tour-heads": (
        "Only driver and 7-iron are measured heads (not those of the tour); the other clubs are a plausible parametric "
        "set. Models with published parameters use those of driver or 7-iron for them."
    ),
    "tour-in-doubt": "{averages} is in doubt: {caveat}",
    "tour-left-out": "{averages}: left out, since there is no head for it: {clubs}.",
    "tour-lofts-published": (
        "{averages}: dynamic loft is published only for {clubs:and}, and used by every model. Elsewhere each model has "
        "the loft at which it launches the ball at the published angle, so its launch angle is not a prediction there "
        "and has no error."
    ),
    "tour-lofts-solved": (
        "{averages}: no dynamic loft is published for these averages (only for {others:and}): each model has the loft "
        "at which it launches the ball at the published angle, so its launch angle is not a prediction."
    ),
    "tour-ratio": (
        "I w / (m R v_t) is {rigid:.0f} for a ball that stays round and {flattened:.2f} to 0.95 for a flattened one; "
        "relative to the face at first touch, which turns with its head, it is larger. The possible lofts are those "
        "for which the published launch has {rigid:.0f} to {flattened:.2f}. With a loft outside this range by more "
        "than the head turns, half a degree for woods and one for irons, the figures cannot belong to one shot."
    ),
    "tour-strike": (
        "Impact at the face centre, path and face square. The models' carries come from their own launches; 'flight "
        "only' starts from the published launch."
    ),
    "validation-misses": "{model}: furthest outside the tolerance, with the mean error: {missed:and}.",
    "validation-verdict": (
        "{model}: in {met} of {quantities} measured quantities the mean error is within the tolerance, in {every} "
        "every error is."
    ),
}
