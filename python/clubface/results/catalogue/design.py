"""Sentences about comparisons, face maps, golfers, dispersions, best lofts and optimisations."""

SENTENCES = {
    "advice-as-good": "As good for {label}, since the difference is not worth a change: {others:;}.",
    "advice-by-objective": "What each objective alone would choose: {wishes:;}.",
    "advice-change": (
        "Change from the {present} to {best}. For {golfer}, {label} is {after} instead of {before}: better by {gain} "
        "± {error}."
    ),
    "advice-change-strokes": (
        "Change from the {present} to {best}. For {golfer}, the mean is {after} strokes instead of {before}: better by "
        "{gain} ± {error}, which is {round:.2f} strokes over the {drives} drives of a round."
    ),
    "advice-costs": "The price of {best}: {losses:and}.",
    "advice-errors": (
        "After ± stands the standard error of a difference on the same shots; errors of the model are not in it."
    ),
    "advice-hole-assumed": "Strokes are counted on a hole that is assumed: {hole}. A table [hole] gives another.",
    "advice-holds": (
        "This holds whatever counts, {labels:and}: {best} is better than the {present} or does not differ from it."
    ),
    "advice-keep": (
        "Keep the {present}. For {golfer}, no alternative improves {label} by {worth}, the smallest difference worth a "
        "change; the most to gain is {most}."
    ),
    "advice-keep-all": (
        "Keep the {present}. For {golfer}, none of {alternatives:n alternative} makes a difference worth a change, "
        "whatever counts: {labels:or}."
    ),
    "advice-not-certain": (
        "Keep the {present} for now. For {golfer}, {best} may improve {label} by {gain} ± {error}, which is not "
        "clearly worth a change; more shots would show it."
    ),
    "advice-purpose": "What counts is the {meaning}. Judged on {conditions}.",
    "advice-single-delivery": "This is for one delivery; how a golfer's shots spread is not in it.",
    "advice-worth": (
        "Smaller differences than these are not ranked, since no golfer would notice them: {sizes}. --worth or a table "
        "[worth] sets others."
    ),
    "best-loft-at-an-end": (
        "For {labels:and} the best lies at an end of what was tried, {low_loft} to {high_loft}: it is no optimum."
    ),
    "best-loft-carry": (
        "The best loft here is that of the longest carry of one delivery; --golfer or --loft compare carry, total "
        "distance and strokes with the present loft."
    ),
    "best-loft-flat": (
        "Best for {label} is a dynamic loft of {best_loft}; anything from {low_loft} to {high_loft} is within {worth}."
    ),
    "best-loft-delivered": (
        "This is the loft that the face has when it meets the ball, not the one that is stamped on the club."
    ),
    "best-loft-inclined": (
        "With a club that moves {attack:sides} at {speed:0}, the ball carries farthest with {loft} of loft at impact: "
        "{carry:0}. Up to {less_loft} less or {more_loft} more cost less than {worth_carry:0}."
    ),
    "best-loft-launch-difference": (
        "The best launch here is {loft:higher/lower} than in the chart of {chart} on average."
    ),
    "best-loft-level": (
        "With a club that moves level at {speed:0}, the ball carries farthest with {loft} of loft at impact: "
        "{carry:0}. Up to {less_loft} less or {more_loft} more cost less than {worth_carry:0}."
    ),
    "best-loft-loft-difference": ("The best loft here is {loft:higher/lower} than in the chart of {chart} on average."),
    "best-loft-within": (
        "the last two columns: so much less or more loft costs less than {worth_carry:0} of carry, the smallest "
        "difference worth a change; --worth sets another"
    ),
    "comparison-difference": (
        '"{name}" against "{first}": the ball leaves {ball_speed:faster/slower}, spins {backspin:more/less 0} '
        "and carries {carry:farther/shorter}; it lands {side:# further right/# further left/no further to a side}."
    ),
    "comparison-main-cause": "What changes the carry most is {change}: {carry:more/less}.",
    "comparison-main-cause-side": "What moves the landing to the side most is {change}: {side:right/left}.",
    "comparison-not-split": "The difference of {name} from {first} cannot be split into contributions: {reason}",
    "comparison-same": "{name} is like {first} in everything that this shot depends on",
    "comparison-shape": (
        '"{name}": the ball starts {azimuth:right/left/on the target line}, '
        "{curve:curves # right/curves # left/flies straight 0} and lands {side:right/left/on the target line 0}: a "
        "{shape}."
    ),
    "comparison-too-low": '"{name}": the ball does not leave the ground: it has neither carry nor curve.',
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
        "drift: well above 1, something changed during the session; well below 1, the rows are not in the order of "
        "play; chance alone moves it by {chance:.2f} (standard deviation)"
    ),
    "golfer-drifted": "during the session {names:labels} drifted; the drift is not in the spreads",
    "golfer-error": "error of ± is how well ± is known (standard error)",
    "golfer-face-spread": "Two swings in three bring the face back within {spread_face} of where it points on average.",
    "golfer-few-for-mishits": (
        "{shots:n shot} are too few to tell how often a swing goes badly wrong: that is taken from {like}"
    ),
    "golfer-list": "± is the standard deviation from shot to shot; clubface golfer show NAME gives the sources",
    "golfer-mishit-share": (
        "About {percent:.3g} swings in 100 are mishits, with everything {scale:.3g} times as far off."
    ),
    "golfer-mishits": "{percent:.3g}% of the swings are mishits, with everything {scale:.3g} times as far off",
    "golfer-mishits-left-out": (
        "{mishits} of {shots:n shot} {mishits:?is/are} left out: topped or otherwise missed, far off the rest in ball "
        "speed, carry, launch angle or start direction; fittings leave them out, too"
    ),
    "golfer-monitor-errors": "the spreads include the errors of the monitor",
    "golfer-not-measured": "not measured, and taken from {like}: {names:labels}",
    "golfer-place-of-face-unknown": (
        "where on the face loft and face angle were taken is not known, or not in all shots: what the curved face adds "
        "off its centre may count twice"
    ),
    "golfer-place-of-speed-unknown": (
        "speed, attack angle and path are not all known to be those of the head's centre of gravity"
    ),
    "golfer-rest-assumed": "The rest is assumed.",
    "golfer-same-in-every-shot": "the same in every shot, so that the spread is taken from {like}: {names:labels}",
    "golfer-shots": "This is what {shots:n shot} of the session show.",
    "golfer-shots-left-out": "{left} of {shots:n shot} lack some of the club data and were left out",
    "golfer-shrunk": (
        "much of the correlation in {shots:n shot} is chance, so that it is reduced by {shrinkage:.0%} (Ledoit and "
        "Wolf, 2004)"
    ),
    "golfer-sourced": "How much a swing differs from the next was measured or published for {names:labels}.",
    "golfer-source": "{figures}: {source}",
    "golfer-speed": "The club comes into the ball at {speed:0} on average.",
    "golfer-speed-spread": "Two swings in three are within {spread_speed} of that.",
    "golfer-spread": "± is the standard deviation from shot to shot, mishits left out",
    "golfer-weak-correlations": "{weak:n correlation} below ±{limit:g} {weak:?is/are} not listed",
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
    "advice-mishits": (
        "The shots are those that golfers hit as usual: topped and other failed shots, which a player's report names "
        "as mishits, are not in them, so that the means are better than those of a session."
    ),
    "fitting-at-an-end": ("The best is at an end of the range of {names:and}; a wider range may give a better one."),
    "fitting-not-shown": "{hidden} more are not shown; --output and --json have all.",
    "fitting-parts-idle": "No difference worth a change comes from the {parts:and}, whatever counts.",
    "fitting-parts-matter": "What matters, all else being equal: {effects}.",
    "fitting-shots": (
        "{combinations:n combination}, all judged on the same {shots} shots of {golfers:n golfer}, delivered as with "
        "{club}, with more dynamic loft where the club has more loft."
    ),
    "optimum-angles": "The club has {angles:and}.",
    "optimum-change": "The {meaning} is {after} instead of {before}.",
    "optimum-cg-moved": "Compared with the club at the start, its CG lies {moved:and}.",
    "optimum-ellipsoid": (
        "Mass is placed inside the mesh of {club}: in the largest ellipsoid there, {size} mm from face to back, sole "
        "to crown and heel to toe, about ({centre}) mm from the face centre."
    ),
    "optimum-lie": "The lie is that at impact; a club file has none, so set it when the club is fitted.",
    "optimum-limits-of-shots": (
        "The club that is best for the mean delivery does not know the limits of the shots; the optimum keeps them on "
        "the shots it was solved on."
    ),
    "optimum-loft": "One degree more static loft is taken to be one degree more at impact.",
    "optimum-missed": "{missed:n shot} miss the face of the club and are left out.",
    "optimum-nominal-better": (
        "On fresh shots the club that is best for the mean delivery is better; the shots are too few."
    ),
    "optimum-nominal-like": (
        "On fresh shots the optimum and the club that is best for the mean delivery do not differ clearly."
    ),
    "optimum-nominal-worse": ("On fresh shots the optimum is better than the club that is best for the mean delivery."),
    "optimum-not-placed": (
        "No point masses in the volume were found that have the moments of the discretionary mass: a box refuses no "
        "head that can be built, but not every other one. Try a smaller box, an ellipsoid, or a limit of the CG."
    ),
    "optimum-on-fresh-shots": "This is what the best club does on shots that no solver has seen.",
    "optimum-shots": (
        "Solved on {shots:n shot}; the table is of {fresh} fresh ones, which no solver has seen. After ± stands the "
        "standard error of a difference."
    ),
    "optimum-speed": (
        "Clubhead speed is taken to fall as mass to the power {exponent:g} (MacKenzie, Ryan and Rice, 2015)."
    ),
    "optimum-starts": ("{alike} of {starts:n start} found this optimum of the {meaning} (to 1 part in 10,000)."),
    "optimum-stopped-by": "What stops the optimum: {limits}.",
    "optimum-tolerances": (
        "It makes use of tolerances of the rules, which are there for what a measurement may be off: {rules}. "
        "tolerance = false under [rules] keeps to the limits."
    ),
    "shells-at-an-end": "At an end of what may vary: {names}. Wider bounds may give a better head.",
    "shells-change": "The {meaning} of the best head is {after} instead of {before}.",
    "shells-effort": (
        "{designs:n design} were judged by {runs:n run} of finite elements; the search for the best head ended because "
        "{reason}."
    ),
    "shells-open": "The mesh is open, so that its volume is not known; the rule for it was not looked at.",
    "shells-stress": (
        "The stress is that of von Mises on either side of the face, of a metal that stays elastic, on the mesh of the "
        "head: a finer mesh finds more. It shows yield in one impact and nothing of fatigue."
    ),
}
