"""Sentences about comparisons, face maps, golfers, dispersions, best lofts and optimisations."""

SENTENCES = {
    "comparison-difference": (
        "Compared with {first}, with {name} the ball leaves {ball_speed:faster/slower}, spins {backspin:more/less 0} "
        "and carries {carry:farther/shorter}."
    ),
    "comparison-main-cause": "What changes the carry most is {change}: {carry:more/less}.",
    "comparison-not-split": "The difference of {name} from {first} cannot be split into contributions: {reason}",
    "comparison-same": "{name} is like {first} in everything that this shot depends on",
    "dispersion-ball-speed": "Half of {shots:n shot} leave at {low_ball_speed:bare 0} to {high_ball_speed:0}.",
    "dispersion-carry": (
        "Half of them carry {low_carry:bare 0} to {high_carry:0}, and nine of ten at least {tenth_carry:0}."
    ),
    "dispersion-carry-cause": (
        "How far the ball goes depends most on the {variable}, which makes {share:.0%} of the differences (of the "
        "variance)."
    ),
    "dispersion-columns": "± is the standard deviation; the percentage columns are quantiles",
    "dispersion-derivatives": "by derivatives: to the second order about the mean delivery",
    "dispersion-lost": "{lost:n shot} ({share:.2%}) have no result and are left out, such as: {reasons}",
    "dispersion-shapley": "the values of the delivery are correlated, so that Shapley's rule shares out the variance",
    "dispersion-side": "Nine of ten land between {left_side:sides 0} and {right_side:sides 0} of the line.",
    "dispersion-side-cause": (
        "How far it is off the line depends most on the {variable}, which makes {share:.0%} of the differences (of the "
        "variance)."
    ),
    "dispersion-stroke-averages": "strokes: averages of the PGA Tour by distance and lie (Broadie, 2011 and 2012)",
    "dispersion-strokes": "On the hole given, the shot leaves {strokes:.2f} strokes to play, as tour players count.",
    "map-centre": (
        "Struck at the centre of the face, {club} sends the ball off at {ball_speed} and carries it {carry:0}."
    ),
    "map-interpolated": "between the points of the grid, values, best points and areas are interpolated",
    "map-missed": "{club}: {missed:.2%} of the scattered impacts miss the face and are not counted",
    "map-off-centre": (
        "Struck {toe:0} towards the {place}, it carries {carry:farther/shorter} and lands {side:sides} of the line."
    ),
    "map-outline": "{club}: outline {outline}",
    "map-spread-option": 'Give --spread "12 mm x 9 mm" to learn what impacts that scatter so much cost.',
    "map-sweet-spot": (
        "The sweet spot of {club} lies {toe:towards the toe/towards the heel} and {high:above the centre/below the "
        "centre}, with a ball speed of {ball_speed}; the longest carry, {carry}, comes from "
        "{carry_toe:towards the toe/towards the heel} and {carry_high:above the centre/below the centre}."
    ),
}
