"""Sentences about comparisons, face maps, golfers, dispersions, best lofts and optimisations."""

SENTENCES = {
    "comparison-difference": (
        "Compared with {first}, with {name} the ball leaves {ball_speed:faster/slower}, spins {backspin:more/less 0} "
        "and carries {carry:farther/shorter}."
    ),
    "comparison-main-cause": "What changes the carry most is {change}: {carry:more/less}.",
    "comparison-not-split": "The difference of {name} from {first} cannot be split into contributions: {reason}",
    "comparison-same": "{name} is like {first} in everything that this shot depends on",
}
