"""Sentences about evaluations of models, identified parameters and inferred deliveries."""

SENTENCES = {
    "evaluation-best": "{model} has the smallest mean absolute error in {names:and}.",
    "evaluation-errors": (
        "Errors are model less measured; percentages are of the mean magnitude of the measured values. STD is the "
        "standard deviation of the error about its mean (n - 1)."
    ),
    "evaluation-intervals": (
        "Intervals hold 95% of {resamples} bootstrap resamples of the {drawn} (seed {seed}). All models are compared "
        "on the same resamples; p is two-sided, after Holm's correction for the number of rivals, and differences over "
        "fewer than {least} {unit} are never significant between {models:n model}. The best model was chosen on these "
        "same shots, and parameters identified on them favour the model with more of them: only shots held out can "
        "tell."
    ),
    "evaluation-no-intervals": (
        "One shot, or shots all alike, give no intervals and cannot show which model is better: that takes shots with "
        "different deliveries."
    ),
    "evaluation-published": (
        "Published figures are those of the paper's own shots and golfers, with parameters identified on those same "
        "shots; they are given for scale. Those of standard are from the thesis on which the paper is based. Printed "
        "times are totals of ten shots. The paper does not say whether a mean of azimuth and sidespin, or an STD, is "
        "of magnitudes."
    ),
    "published-caveat": "Published {model}, {club}: {caveat}",
    "rows-left-out": "Left out of {source}: {rows:n row} ({first})",
    "shots-not-computed": "Left out for all models, since one cannot compute them: {shots:n shot} ({first})",
}
