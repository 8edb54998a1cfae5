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
    "fit-at-bound": "{parameter} meets its {side} bound, {bound}: the best value may lie beyond it.",
    "fit-contact-time": "Contact lasts {contact_time:us 0} on average; measured contacts last 400 to 500 us.",
    "fit-contradicted": (
        "Outside their own interval: {names}. Fits to parts of the shots, or the likelihood, lead elsewhere, so "
        "neither value nor interval can be trusted."
    ),
    "fit-copied-shots": "Only {different} of {shots} shots are different: if the others are copies, remove them.",
    "fit-few-shots": "{shots:n shot} are few for {free:n parameter}: the intervals are rough.",
    "fit-likelihood-elsewhere": (
        "The likelihood puts {names} outside the interval: the model does not describe these shots, so its parameters "
        "depend on the cost that is minimised."
    ),
    "fit-not-identified": "Not identified: {direction}.",
    "fit-one-refinement": (
        "Only one of {refinements} refinements reached the least cost, {least:.6g} (the next {next:.6g}): another seed "
        "or more generations may find a better fit."
    ),
    "fit-peak-force": (
        "The normal force peaks at {peak_force:kN 1} on average; measured impacts at this speed peak at "
        "{least_peak_force:kN 0} to {most_peak_force:kN 0}."
    ),
    "fit-same-delivery": (
        "All {shots} shots have the same delivery: how the launch depends on the delivery is not tested."
    ),
    "fit-weak": "Weakly identified: {direction}.",
    "fit-worse": "The fit makes some quantities worse than {before}, with which it began: {names}.",
    "not-in-the-cost": "Not measured, so not in the cost: {names}.",
    "published-caveat": "Published {model}, {club}: {caveat}",
    "rows-left-out": "Left out of {source}: {rows:n row} ({first})",
    "rows-not-used": "{rows:n row} not used; the first is {first}",
    "shots-not-computed": "Left out for all models, since one cannot compute them: {shots:n shot} ({first})",
}
