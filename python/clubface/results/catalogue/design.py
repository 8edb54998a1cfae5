"""Sentences about comparisons, face maps, golfers, dispersions, best lofts and optimisations."""

SENTENCES = {
    "best-loft-delivered": (
        "This is the loft that the face has when it meets the ball, not the one that is stamped on the club."
    ),
    "best-loft-inclined": (
        "With a club that moves {attack:sides} at {speed:0}, the ball carries farthest with {loft} of loft at impact: "
        "{carry:0}. Up to {less_loft} less or {more_loft} more cost less than a yard."
    ),
    "best-loft-launch-difference": (
        "The best launch here is {loft:higher/lower} than in the chart of {chart} on average."
    ),
    "best-loft-level": (
        "With a club that moves level at {speed:0}, the ball carries farthest with {loft} of loft at impact: "
        "{carry:0}. Up to {less_loft} less or {more_loft} more cost less than a yard."
    ),
    "best-loft-loft-difference": ("The best loft here is {loft:higher/lower} than in the chart of {chart} on average."),
    "best-loft-within": "the last two columns: with so much less or more loft a yard of carry is lost",
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
    "golfer-all-assumed": (
        "How much the shots differ from each other has no source, and counts as assumed for every part of the "
        "delivery: take it as typical, not as measured."
    ),
    "golfer-disorder": (
        "{reason}, so that they do not stand in the order of play: spreads are taken about the mean of the session, "
        "and a drift would be in them"
    ),
    "golfer-doubt-carry": (
        "The carry differs by {spread_carry} from shot to shot (standard deviation). It rests most on the {figure} "
        "({state}): if that were {off:.0%} larger, the shots would differ by {more:.0%} more."
    ),
    "golfer-doubt-side": (
        "Where the ball lands to the sides differs by {spread_carry} from shot to shot (standard deviation). It rests "
        "most on the {figure} ({state}): if that were {off:.0%} larger, the shots would differ by {more:.0%} more."
    ),
    "golfer-drift": (
        "drift compares the whole session with shots that follow each other: well above 1, something was changed on "
        "the way; well below 1, the rows do not stand in the order of play; chance alone moves it by {chance:.2f} "
        "(standard deviation)"
    ),
    "golfer-drifted": "the session drifted in {names}; the drift is not in the spreads",
    "golfer-error": "error of ± is how well that is known, as a standard error",
    "golfer-face-spread": "The face angle differs by {spread_face} from shot to shot.",
    "golfer-few-for-mishits": "{shots:n shot} show nothing of mishits: they are taken as of {like}",
    "golfer-list": "± is the standard deviation from shot to shot; clubface golfer show NAME gives the sources",
    "golfer-mishits": "{percent:.3g} % of the shots are mishits, {scale:.3g} times as far off in everything",
    "golfer-monitor-errors": "the errors of the monitor are in the spreads",
    "golfer-not-measured": "not measured, and therefore as of {like}: {names}",
    "golfer-place-of-face-unknown": (
        "where on the face loft and face angle were taken is not known, or not in all shots: what the curved face adds "
        "off its centre may count twice"
    ),
    "golfer-place-of-speed-unknown": (
        "speed, attack angle and path are not all known to be those of the head's centre of gravity"
    ),
    "golfer-rest-assumed": "For the rest it is assumed.",
    "golfer-same-in-every-shot": "the same in every shot, and therefore spread as of {like}: {names}",
    "golfer-shots": "These figures come from {shots:n shot}, in the order in which they were hit.",
    "golfer-shots-left-out": "{left} of {shots:n shot} lack some of the club data and were left out",
    "golfer-shrunk": (
        "correlations from {shots:n shot} are drawn towards 0 by {shrinkage:.0%} (Ledoit and Wolf, 2004): the fewer "
        "the shots, the more of them is chance"
    ),
    "golfer-sourced": "How much these differ from shot to shot was measured or published: {names}.",
    "golfer-source": "{figures}: {source}",
    "golfer-speed": "The club reaches the ball at {speed:0}.",
    "golfer-speed-spread": "Two shots of three are within {spread_speed} of that.",
    "golfer-spread": "± is the standard deviation from shot to shot, mishits left out",
    "golfer-weak-correlations": "{weak:n correlation} below ±{limit:g} are not listed",
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
