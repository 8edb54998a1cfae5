"""Sentences about comparisons, face maps, golfers, dispersions, best lofts and optimisations."""

SENTENCES = {
    "comparison-difference": (
        "Compared with {first}, with {name} the ball leaves {ball_speed:faster/slower}, spins {backspin:more/less 0} "
        "and carries {carry:farther/shorter}."
    ),
    "comparison-main-cause": "What changes the carry most is {change}: {carry:more/less}.",
    "comparison-not-split": "The difference of {name} from {first} cannot be split into contributions: {reason}",
    "comparison-same": "{name} is like {first} in everything that this shot depends on",
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
