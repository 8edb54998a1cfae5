"""Sentences about comparisons, face maps, golfers, dispersions, best lofts, optimisations and studies."""

SENTENCES = {
    "advice-as-good": "Equally good for {label}, since the difference is not worth a change: {others:;}.",
    "advice-by-objective": "What each objective alone would choose: {wishes:;}.",
    "advice-change": (
        "Change from the {present} to {best}. For {golfer}, {label} is {after} instead of {before}: better by {gain} "
        "± {error}."
    ),
    "advice-change-strokes": (
        "Change from the {present} to {best}. For {golfer}, the mean is {after} strokes instead of {before}: better by "
        "{gain} ± {error}, which is {round:.2f} strokes over the {drives} drives of a round."
    ),
    "advice-costs": "What {best} costs: {losses:and}.",
    "advice-errors": (
        "± is the standard error of a difference on the same shots; it does not include errors of the model."
    ),
    "advice-holds": (
        "This holds for every objective, {labels:and}: {best} is better than the {present} or does not differ from it."
    ),
    "advice-hole-assumed": "Strokes are counted on an assumed hole: {hole}. A table [hole] gives another.",
    "advice-keep": (
        "Keep the {present}. For {golfer}, no alternative improves {label} by {worth}, the smallest difference worth a "
        "change; the largest gain is {most}."
    ),
    "advice-keep-all": (
        "Keep the {present}. For {golfer}, none of {alternatives:n alternative} makes a difference worth a change in "
        "{labels:or}."
    ),
    "advice-mishits": (
        "The shots are the golfers' normal ones: topped and other failed shots, which a player's report calls mishits, "
        "are left out, so the means are better than in a session."
    ),
    "advice-not-certain": (
        "Keep the {present} for now. For {golfer}, {best} may improve {label} by {gain} ± {error}, which is not "
        "clearly worth a change; more shots would show it."
    ),
    "advice-purpose": "The objective is the {meaning}. Judged on {conditions}.",
    "advice-single-delivery": "This is for a single delivery; it does not include how a golfer's shots spread.",
    "advice-worth": (
        "Differences smaller than these are not ranked, since no golfer would notice them: {sizes}. --worth or a table "
        "[worth] changes this."
    ),
    "best-loft-at-an-end": (
        "For {labels:and} the best lies at an end of the range, {low_loft} to {high_loft}: it is not an optimum."
    ),
    "best-loft-carry": (
        "The best loft here gives the longest carry for a single delivery; --golfer or --loft compare carry, total "
        "distance and strokes with the present loft."
    ),
    "best-loft-delivered": ("This is the loft of the face when it meets the ball, not the loft stamped on the club."),
    "best-loft-flat": (
        "The best dynamic loft for {label} is {best_loft}; anything from {low_loft} to {high_loft} is within {worth}."
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
        "last two columns: how much less or more loft costs less than {worth_carry:0} of carry, the smallest "
        "difference worth a change; --worth changes it"
    ),
    "comparison-difference": (
        '"{name}" against "{first}": the ball leaves {ball_speed:faster/slower}, spins {backspin:more/less 0} '
        "and carries {carry:farther/shorter}; it lands {side:# further right/# further left/no further to a side}."
    ),
    "comparison-main-cause": "The largest effect on carry comes from {change}: {carry:more/less}.",
    "comparison-main-cause-side": "The largest sideways effect comes from {change}: {side:right/left}.",
    "comparison-not-split": "The difference of {name} from {first} cannot be split into contributions: {reason}",
    "comparison-same": "{name} and {first} are the same in everything that affects this shot",
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
        "The distance depends most on the {variable}, which causes {share:.0%} of the variance."
    ),
    "dispersion-columns": "± is the standard deviation; the percentage columns are quantiles",
    "dispersion-derivatives": "by derivatives: to second order about the mean delivery",
    "dispersion-lost": "{lost:n shot} ({share:.2%}) have no result and are left out, such as: {reasons}",
    "dispersion-shapley": "delivery values are correlated, so the shares of the variance are Shapley effects",
    "dispersion-side": "Nine of ten land between {left_side:sides 0} and {right_side:sides 0} of the line.",
    "dispersion-side-cause": (
        "The distance off the line depends most on the {variable}, which causes {share:.0%} of the variance."
    ),
    "dispersion-stroke-averages": "strokes: averages of the PGA Tour by distance and lie (Broadie, 2011 and 2012)",
    "dispersion-strokes": "On the given hole, the shot leaves {strokes:.2f} strokes to play, by tour averages.",
    "fitting-at-an-end": ("The best is at an end of the range of {names:and}; a wider range may give a better result."),
    "fitting-not-shown": "{hidden} more are not shown; --output and --json have all.",
    "fitting-parts-idle": "The {parts:and} make no difference worth a change, for any objective.",
    "fitting-parts-matter": "What matters, all else being equal: {effects}.",
    "fitting-shots": (
        "{combinations:n combination}, all judged on the same {shots} shots of {golfers:n golfer}, delivered as with "
        "{club}, with the difference in loft added."
    ),
    "golfer-all-assumed": (
        "The shot-to-shot spread has no source and counts as assumed for every part of the delivery: treat it as "
        "typical, not as measured."
    ),
    "golfer-disorder": (
        "{reason}, so they are not in the order of play: spreads are computed about the mean of the session, and "
        "include any drift"
    ),
    "golfer-doubt-carry": (
        "The carry varies by {spread_carry} from shot to shot (standard deviation). It depends most on the {figure} "
        "({state}): if that were {off:.0%} larger, the shots would vary by {more:.0%} more."
    ),
    "golfer-doubt-side": (
        "The side varies by {spread_carry} from shot to shot (standard deviation). It depends most on the {figure} "
        "({state}): if that were {off:.0%} larger, the shots would vary by {more:.0%} more."
    ),
    "golfer-drift": (
        "drift: well above 1, something changed during the session; well below 1, the rows are not in the order of "
        "play; chance alone moves it by {chance:.2f} (standard deviation)"
    ),
    "golfer-drifted": "{names:labels} drifted during the session; the spreads do not include the drift",
    "golfer-error": "error of ± is the standard error of ±",
    "golfer-face-spread": "Two swings in three bring the face back within {spread_face} of its average direction.",
    "golfer-few-for-mishits": (
        "{shots:n shot} are too few to estimate how often a swing goes badly wrong: that is taken from {like}"
    ),
    "golfer-list": "± is the standard deviation from shot to shot; clubface golfer show NAME gives the sources",
    "golfer-mishit-share": (
        "About {percent:.3g} swings in 100 are mishits, with everything {scale:.3g} times as far off."
    ),
    "golfer-mishits": "{percent:.3g}% of the swings are mishits, with everything {scale:.3g} times as far off",
    "golfer-mishits-left-out": (
        "{mishits} of {shots:n shot} {mishits:?is/are} left out: topped or otherwise missed, far from the others in "
        "ball speed, carry, launch angle or start direction; fittings leave them out, too"
    ),
    "golfer-monitor-errors": "the spreads include the monitor's errors",
    "golfer-not-measured": "not measured, and taken from {like}: {names:labels}",
    "golfer-place-of-face-unknown": (
        "the point on the face where loft and face angle were measured is not known, or not for all shots: the "
        "curvature of the face may count twice off centre"
    ),
    "golfer-place-of-speed-unknown": (
        "speed, attack angle and path may not all be measured at the head's centre of gravity"
    ),
    "golfer-rest-assumed": "The rest is assumed.",
    "golfer-same-in-every-shot": "the same in every shot, so the spread is taken from {like}: {names:labels}",
    "golfer-shots": "This is what {shots:n shot} of the session show.",
    "golfer-shots-left-out": "{left} of {shots:n shot} lack some of the club data and were left out",
    "golfer-shrunk": (
        "much of the correlation in {shots:n shot} is chance, so it is reduced by {shrinkage:.0%} (Ledoit and Wolf, "
        "2004)"
    ),
    "golfer-source": "{figures}: {source}",
    "golfer-sourced": "The swing-to-swing spread was measured or published for {names:labels}.",
    "golfer-speed": "The club comes into the ball at {speed:0} on average.",
    "golfer-speed-spread": "Two swings in three are within {spread_speed} of that.",
    "golfer-spread": "± is the standard deviation from shot to shot, mishits left out",
    "golfer-weak-correlations": "{weak:n correlation} below ±{limit:g} {weak:?is/are} not listed",
    "map-centre": (
        "Struck at the centre of the face, {club} sends the ball off at {ball_speed} and carries it {carry:0}."
    ),
    "map-interpolated": "values, best points and areas are interpolated between the grid points",
    "map-missed": "{club}: {missed:.2%} of the scattered impacts miss the face and are not counted",
    "map-off-centre": (
        "Struck {toe:0} towards the {place}, it carries {carry:farther/shorter} and lands {side:sides} of the line."
    ),
    "map-outline": "{club}: outline {outline}",
    "map-spread-option": 'Give --spread "12 mm x 9 mm" to see what such a scatter of impacts costs.',
    "map-sweet-spot": (
        "The sweet spot of {club} lies {toe:towards the toe/towards the heel} and {high:above the centre/below the "
        "centre}, with a ball speed of {ball_speed}; the longest carry, {carry}, comes from "
        "{carry_toe:towards the toe/towards the heel} and {carry_high:above the centre/below the centre}."
    ),
    "optimum-angles": "The club has {angles:and}.",
    "optimum-cg-moved": "Compared with the club at the start, its CG lies {moved:and}.",
    "optimum-change": "The {meaning} is {after} instead of {before}.",
    "optimum-ellipsoid": (
        "Mass is placed inside the mesh of {club}: in the largest ellipsoid there, {size} mm from face to back, sole "
        "to crown and heel to toe, about ({centre}) mm from the face centre."
    ),
    "optimum-lie": "The lie is the lie at impact; a club file has none, so set it when the club is fitted.",
    "optimum-limits-of-shots": (
        "The best club for the mean delivery ignores the limits on the shots; the optimum satisfies them on the shots "
        "used by the solver."
    ),
    "optimum-loft": "One degree more static loft is assumed to give one degree more at impact.",
    "optimum-missed": "{missed:n shot} miss the face of the club and are left out.",
    "optimum-nominal-better": (
        "On fresh shots the best club for the mean delivery is better; there are too few shots."
    ),
    "optimum-nominal-like": (
        "On fresh shots the optimum and the best club for the mean delivery do not differ clearly."
    ),
    "optimum-nominal-worse": ("On fresh shots the optimum is better than the best club for the mean delivery."),
    "optimum-not-placed": (
        "No point masses inside the volume have the moments of the discretionary mass: a box accepts every head that "
        "can be built, and some that cannot. Try a smaller box, an ellipsoid, or a limit on the CG."
    ),
    "optimum-on-fresh-shots": "This is what the best club does on shots that the solver has not seen.",
    "optimum-shots": (
        "Solved on {shots:n shot}; the table shows {fresh} fresh ones, which the solver has not seen. ± is the "
        "standard error of a difference."
    ),
    "optimum-speed": (
        "Clubhead speed is assumed to fall with mass to the power {exponent:g} (MacKenzie, Ryan and Rice, 2015)."
    ),
    "optimum-starts": ("{alike} of {starts:n start} found this optimum of the {meaning} (to 1 part in 10,000)."),
    "optimum-stopped-by": "The optimum is limited by: {limits}.",
    "optimum-tolerances": (
        "It uses the tolerances of the rules, which are meant for measurement errors: {rules}. tolerance = false under "
        "[rules] keeps to the limits."
    ),
    "shells-at-an-end": "At an end of its range: {names}. Wider bounds may give a better head.",
    "shells-change": "The {meaning} of the best head is {after} instead of {before}.",
    "shells-effort": (
        "{designs:n design} were checked with {runs:n run} of finite elements; the search for the best head ended "
        "because {reason}."
    ),
    "shells-open": "The mesh is open, so its volume is not known; the volume rule was not checked.",
    "shells-stress": (
        "The stress is the von Mises stress on either side of the face, for an elastic metal, on the mesh of the head: "
        "a finer mesh gives more. It shows yield under a single impact, but not fatigue."
    ),
    "study-chunks-not-listed": "{left:n chunk} missing or damaged; {chunks} of them not listed",
    "study-complete": "the study is complete in {store}",
    "study-left": "{chunks:n chunk} of the whole study left for other runs; parts in {store}",
    "study-parts-mended": "{parts:n damaged part} recomputed: {shown}",
    "study-processors": "computed on {processors}, which agree to rounding, not in the last digits",
    "study-range": "{quantity} ranges from {least_text} to {most_text}.",
    "study-store": "parts in {store}",
    "study-tasks": "The study has {tasks:n task}, which differ in {inputs:and}.",
    "tasks-without-result": "{tasks:n task} without a result; the first is {first}",
}
