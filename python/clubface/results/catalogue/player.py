"""Sentences of the report for a player."""

SENTENCES = {
    "player-all-alike": "No club stands out in these shots: gaps, direction and spread are even.",
    "player-buy-gap": (
        "There are {gap_carry:0} between {longer} and {shorter}. If your bag has no club for it, one that carries "
        "{carry:0} would fill the gap."
    ),
    "player-buy-nothing": "The gaps in your bag call for no other club.",
    "player-buy-one-of-two": (
        "{longer} and {shorter} carry nearly the same distance, {gap_carry:0} apart: one of them could make room for a "
        "club that you lack."
    ),
    "player-carry": "It carries {carry:0}; two of three shots lie between {low_carry:0} and {high_carry:0}.",
    "player-carry-alone": "It carries {carry:0}.",
    "player-carry-computed": "Carry and side were not measured: they are computed from the launch, in still air.",
    "player-carry-few": "It carries {carry:0}, with a standard deviation of {spread_carry:0}.",
    "player-carry-margin": (
        "From {shots:n shot} we know your median carry to about {margin_carry:0} either way (19 times out of 20)."
    ),
    "player-carry-margins": (
        "We know the carries of your clubs to {least_carry:0} at best and {most_carry:0} at worst, either way (19 "
        "times out of 20)."
    ),
    "player-change-attack": (
        "Hit {step_attack:0} more upwards: {effects:changes}, finishing "
        "{side:further right/further left/on the same line 0}."
    ),
    "player-change-face": (
        "Turn the face {step_face:0} more to the right: {effects:changes}, finishing "
        "{side:further right/further left/on the same line 0}."
    ),
    "player-change-high": (
        "Strike {step_high:0} higher on the face: {effects:changes}, finishing "
        "{side:further right/further left/on the same line 0}."
    ),
    "player-change-loft": (
        "Deliver {step_loft:0} more loft: {effects:changes}, finishing "
        "{side:further right/further left/on the same line 0}."
    ),
    "player-change-path": (
        "Swing {step_path:0} more to the right: {effects:changes}, finishing "
        "{side:further right/further left/on the same line 0}."
    ),
    "player-change-speed": (
        "Swing {step_speed:0} faster: {effects:changes}, finishing "
        "{side:further right/further left/on the same line 0}."
    ),
    "player-change-toe": (
        "Strike {step_toe:0} closer to the toe: {effects:changes}, finishing "
        "{side:further right/further left/on the same line 0}."
    ),
    "player-changes-alone": "Each of these alone, with everything else unchanged:",
    "player-closing": (
        "The face also closes while it meets the ball, as measured: that alone starts the ball "
        "{azimuth:further right/further left 1}, with sidespin of {sidespin:to the right/to the left 0}."
    ),
    "player-closing-usual": (
        "The face also closes while it meets the ball, at the usual rate for golfers with your speed: that alone "
        "starts the ball {azimuth:further right/further left 1}, with sidespin of {sidespin:to the right/to the left "
        "0}."
    ),
    "player-delivery-of-some": ("The club delivery was computed for {shots:n shot}, spread evenly over all."),
    "player-face-and-path": (
        "As measured, your club face points {face:to the right/to the left/straight 1} at impact, and your club moves "
        "{path:to the right/to the left/straight 1}."
    ),
    "player-face-and-path-at-contact": (
        "As measured, your club face points {face:to the right/to the left/straight 1} at the point of contact, and "
        "your club moves {path:to the right/to the left/straight 1}."
    ),
    "player-face-and-path-estimated": (
        "Judging by the flight of the ball, your club face points {face:to the right/to the left/straight 1} at "
        "impact, and your club moves {path:to the right/to the left/straight 1}. This is an estimate, to within "
        "{margins:and} either way (19 times out of 20)."
    ),
    "player-face-to-path": (
        "The face points {face:further right/further left 1} than the club moves, which by itself curves a ball struck "
        "in the middle to that side."
    ),
    "player-few-shots": "{shots:n shot} {shots:?is/are} few: {more} more could change every figure here.",
    "player-finding-gap-overlap": (
        "{longer} and {shorter} carry nearly the same distance: {carry:0} and {shorter_carry:0}, a gap of "
        "{gap_carry:0}."
    ),
    "player-finding-gap-wide": (
        "The widest gap is between {longer} and {shorter}: {gap_carry:0}, where {usual_carry:0} is usual in your bag."
    ),
    "player-finding-mishits": (
        "{club}: {mishits:n mishit} in {shots:n shot} {mishits:?costs/cost} {lost_carry:0} per shot on average."
    ),
    "player-finding-side": (
        "{club} finishes {side:to the right/to the left 0} of the line, between {low_side:sides 0} and "
        "{high_side:sides 0} in 19 of 20 cases."
    ),
    "player-finding-side-spread": (
        "{club} scatters most for its length: two of three shots finish between {low_side:sides 0} and "
        "{high_side:sides 0}."
    ),
    "player-finding-carry-spread": (
        "{club} varies most in carry: two of three shots lie between {low_carry:0} and {high_carry:0}."
    ),
    "player-finding-strike-high": "{club} meets the ball {high:high/low 0} on the face.",
    "player-finding-strike-toe": "{club} meets the ball {toe:towards the toe/towards the heel 0}.",
    "player-heads-not-judged": (
        "No other head, shaft or ball was tried, and total distance and strokes may favour another club than carry "
        "does. `clubface golfer estimate` makes a golfer from these shots; for this golfer `clubface best-loft "
        "--golfer` compares lofts, and `clubface optimise` heads, balls and settings, by carry, total distance and "
        "strokes."
    ),
    "player-loft-change": (
        "Judged by carry with this head, another loft of {club} is worth a try: with "
        "{change_loft:more/less 1} it would carry {gain_carry:1} farther."
    ),
    "player-loft-keep": (
        "Judged by carry with this head, another loft of {club} is not worth a change: the best, "
        "{change_loft:more/less 1}, would carry {gain_carry:1} farther, less than the {worth_carry:0} that make a "
        "change worthwhile."
    ),
    "player-loft-other": (
        "By {label} alone, {change_loft:more/less 1} would be better by {gain}, at no cost in anything else."
    ),
    "player-loft-other-costs": (
        "By {label} alone, {change_loft:more/less 1} would be better by {gain}, at the cost of {losses:and}."
    ),
    "player-lofts-not-judged": (
        "With {players:n player} in the file their driver lofts are not judged: give one player's shots, or use "
        "`clubface best-loft --golfer`."
    ),
    "player-loft-best": ("Judged by carry with this head, the loft of {club} is the best for your shots."),
    "player-inconsistent-rows": (
        "The figures in these lines of the file are inconsistent, so one of them may be wrong: {rows:10}."
    ),
    "player-impossible-shots": (
        "{shots:n shot}, as measured, cannot come from this club, and {shots:?is/are} left out of all estimates."
    ),
    "player-mishit": (
        "The shot in {place} {row} is a mishit and is not counted: {figures:and}. Your medians are {usual:and}."
    ),
    "player-mishits-left-out": (
        "{mishits:n mishit} {mishits:?is/are} left out of all figures and listed in the club's section."
    ),
    "player-model-standard": (
        "The effects of changes, and the club data that was not measured, come from an impact model with a standard "
        "club and average golfers, not from your own club: trust the direction and the rough size, not the last "
        "digit."
    ),
    "player-more-shots": "With {more} more shots we would know the medians about twice as well.",
    "player-no-carry": "The file has neither carry nor the complete launch, so the report gives no distances.",
    "player-no-model": (
        "We have no model of {club}, so the report gives face, path and strike only as measured, and no what-if."
    ),
    "player-not-measured": "Not measured, and so not judged: {quantities:and}.",
    "player-pictures-of-some": (
        "Pictures are drawn for the first {drawn} of {clubs} clubs; a report on some of the players draws them all "
        "(--where)."
    ),
    "player-practise-carry": (
        "{club}: the {quantity}. It varies by {spread:values} (one standard deviation), which by itself "
        "would spread the carry by {part_carry:0}; everything together spreads it by {spread_carry:0}."
    ),
    "player-practise-mishits": (
        "{club}: the strike. {mishits:n mishit} in {shots:n shot} {mishits:?costs/cost} {lost_carry:0} per shot on "
        "average."
    ),
    "player-practise-nothing": "No single part of the swing stands out in the measurements.",
    "player-practise-side": (
        "{club}: the {quantity}. It varies by {spread:values} (one standard deviation), which by itself "
        "would spread the shots by {part_side:0} to either side; everything together spreads them by {spread_side:0}."
    ),
    "player-practise-start": (
        "{club}: the start direction. It varies by {spread_azimuth:1} (one standard deviation), which by itself "
        "would spread the shots by {part_side:0} to either side; everything together, curve included, spreads them by "
        "{spread_side:0}."
    ),
    "player-practise-unknown": (
        "No club data was measured, so this report cannot say which part of the swing causes the spread."
    ),
    "player-report-by": "This report is about {shots:n shot} by {player} from {file}: {clubs}.",
    "player-report-of": "This report is about {shots:n shot} from {file}: {clubs}.",
    "player-session-changed": "{change:changes}, give or take {margin:values}.",
    "player-session-no-sure-change": "No certain change: {change:changes}, give or take {margin:values}.",
    "player-sessions-compared": "From {first} to {last}, with margins that hold 19 times out of 20:",
    "player-sessions-of-one-shot": "One shot per session is too few to tell a change from chance.",
    "player-sessions-spread": "± is the spread of the shots in a session (one standard deviation, without mishits).",
    "player-side": (
        "It finishes {side:to the right/to the left/on the line 0}; two of three shots lie between "
        "{low_side:sides 0} and {high_side:sides 0}."
    ),
    "player-side-alone": "It finishes {side:to the right/to the left/on the line 0}.",
    "player-side-few": (
        "It finishes {side:to the right/to the left/on the line 0}, with a standard deviation of {spread_side:0}."
    ),
    "player-start": "Your ball starts {azimuth:to the right/to the left/straight 1}.",
    "player-start-and-curve": (
        "Your ball starts {azimuth:to the right/to the left/straight 1} and "
        "{curve:curves # to the right/curves # to the left/flies straight 0}: a {shape}."
    ),
    "player-start-and-spin-axis": (
        "Your ball starts {azimuth:to the right/to the left/straight 1} and curves to the side to which its spin axis "
        "is tilted: {spin_axis:to the right/to the left/to neither 0}."
    ),
    "player-start-causes": (
        "With this club, one degree of face turns the start of the ball by {by_face:.1f} deg, one degree of path by "
        "{by_path:.1f} deg."
    ),
    "player-strike": (
        "The ball meets the face {toe:towards the toe/towards the heel/in the middle 0} and "
        "{high:high/low/at the middle height 0}."
    ),
    "player-strike-estimated": (
        "Your monitor does not see where the ball meets the face. From its flight we estimate "
        "{toe:towards the toe/towards the heel/the middle 0}, anywhere from {low_toe:towards the toe/towards the "
        "heel/the middle 0} to {high_toe:towards the toe/towards the heel/the middle 0} (19 times out of 20). Spray or "
        "impact tape would show it far better."
    ),
    "player-strike-high": "The ball meets the face {high:high/low/at the middle height 0}.",
    "player-strike-high-range": (
        "Up and down, two of three shots lie between {low_high:high/low/the middle 0} and {high_high:high/low/the "
        "middle 0}."
    ),
    "player-strike-toe": "The ball meets the face {toe:towards the toe/towards the heel/in the middle 0}.",
    "player-strike-toe-range": (
        "Sideways, two of three shots lie between {low_toe:towards the toe/towards the heel/the middle 0} and "
        "{high_toe:towards the toe/towards the heel/the middle 0}."
    ),
    "player-too-few-shots": "Hit at least {least} shots with a club: fewer allow no conclusion.",
    "player-typical-shot": "Your typical shot, the median of {shots:n shot}: {figures:and}.",
}
