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
    "validation-verdict": (
        "{model}: in {met} of {quantities} measured quantities the mean error is within the tolerance, in {every} "
        "every error is."
    ),
}
