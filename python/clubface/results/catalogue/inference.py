"""Sentences about evaluations of models, identified parameters, inferred deliveries and validations."""

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
    "club-data-used": (
        "Measured club data counted as well: {names}. Standard deviations of their measurement: {noise} "
        "(--delivery-noise changes them)."
    ),
    "contradicts-prior": (
        "The measured values contradict the prior ({prior}), which with {model} expects {expected}; check units and "
        "club, or give a prior that suits the golfer."
    ),
    "contradicts-prior-together": (
        "The measured values contradict the prior ({prior}), which with {model} hardly ever gives these values "
        "together; check units and club, or give a prior that suits the golfer."
    ),
    "evaluation-best": "{model} has the smallest mean absolute error in {names:and}.",
    "evaluation-errors": (
        "Errors are model minus measured; percentages refer to the mean magnitude of the measured values. STD is the "
        "standard deviation of the error about its mean (n - 1)."
    ),
    "evaluation-intervals": (
        "Intervals hold 95% of {resamples} bootstrap resamples of the {drawn} (seed {seed}). All models are compared "
        "on the same resamples; p is two-sided, after Holm's correction for the number of rivals, and with fewer than "
        "{least} {unit} differences between {models:n model} are never significant. The best model was chosen on these "
        "same shots, and parameters identified from them favour the model with more of them: only held-out shots can "
        "decide."
    ),
    "evaluation-no-intervals": (
        "A single shot, or identical shots, give no intervals and cannot show which model is better: that takes shots "
        "with different deliveries."
    ),
    "evaluation-published": (
        "Published figures are those of the paper's own shots and golfers, with parameters identified on those same "
        "shots; they are given for scale. The figures for standard are from the thesis on which the paper is based. "
        "Printed times are totals for ten shots. The paper does not say whether its means of azimuth and sidespin, and "
        "its STDs, use magnitudes."
    ),
    "far-from-prior": "A delivery far from the prior: {quantities}.",
    "fit-at-bound": "{parameter} meets its {side} bound, {bound}: the best value may lie beyond it.",
    "fit-contact-time": "Contact lasts {contact_time:us 0} on average; measured contacts last 400 to 500 us.",
    "fit-contradicted": (
        "Outside their own interval: {names}. Fits to subsets of the shots, or the likelihood, give other values, so "
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
    "fit-worse": "The fit makes some quantities worse than {before}, where it started: {names}.",
    "launch-says-nothing": "The launch says nothing about {names:and}: for these the sample repeats the prior.",
    "model-taken-as-exact": "{model} with {parameters} is treated as exact; add its errors to the noise.",
    "not-in-the-cost": "Not measured, so not in the cost: {names}.",
    "not-reproduced": "Not reproduced by these deliveries: {quantities}.",
    "one-draw-dominates": "A single draw has {weight:.0%} of the weight.",
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
    "published-caveat": "Published {model}, {club}: {caveat}",
    "published-table": "{title}: {source}.",
    "rows-left-out": "Left out of {source}: {rows:n row} ({first})",
    "rows-not-used": "{rows:n row} not used; the first is {first}",
    "rows-with-remarks": "{rows:n row} with a remark in the last column.",
    "sample-too-small": "Only {effective} draws are effective (of {draws}): the sample is too small to be trusted.",
    "shot-says-nothing": "The measured values say nothing about {names:and}: for these the sample repeats the prior.",
    "shots-not-computed": "Left out for all models, since one of them cannot compute these: {shots:n shot} ({first})",
    "taken-as-exact": "Measured, and treated as exact because the prior leaves it out: {quantities}.",
    "tied": (
        "{first} and {second} are tied together (correlation {correlation:+.2f}): {step} more {first} with {change} "
        "{direction} {second} gives about the same launch."
    ),
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
