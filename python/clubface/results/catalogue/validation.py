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
    "published-table": "{title}: {source}.",
}
