"""Sentences of the report for a player."""

SENTENCES = {
    "player-all-alike": "No club stands out in these shots: gaps, direction and spread are even.",
    "player-buy-gap": (
        "Between {longer} and {shorter} lie {gap_carry:0}. If your bag has no club for it, one that carries "
        "{carry:0} would fill the gap."
    ),
    "player-buy-nothing": "The gaps of your bag ask for no other club.",
    "player-buy-one-of-two": (
        "{longer} and {shorter} carry nearly as far, {gap_carry:0} apart: one of them could make room for a club that "
        "you lack."
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
    "player-changes-alone": "Each of these alone, with all else as it is:",
    "player-closing": (
        "The face also closes while it meets the ball, as measured: that alone starts the ball "
        "{azimuth:further right/further left 1}, with sidespin of {sidespin:to the right/to the left 0}."
    ),
    "player-closing-usual": (
        "The face also closes while it meets the ball, at the rate that is usual for golfers of your speed: that alone "
        "starts the ball {azimuth:further right/further left 1}, with sidespin of {sidespin:to the right/to the left "
        "0}."
    ),
    "player-delivery-of-some": ("The delivery of the club was computed for {shots:n shot}, spread evenly over all."),
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
        "impact, and your club moves {path:to the right/to the left/straight 1}. This is an estimate, which gives "
        "{margins:and} either way (19 times out of 20)."
    ),
    "player-face-to-path": (
        "The face looks {face:further right/further left 1} than the club moves, which by itself bends a ball struck "
        "in the middle to that side."
    ),
    "player-few-shots": "{shots:n shot} {shots:?is/are} few: {more} more could change every figure here.",
    "player-finding-gap-overlap": (
        "{longer} and {shorter} carry nearly as far: {carry:0} and {shorter_carry:0}, a gap of {gap_carry:0}."
    ),
    "player-finding-gap-wide": (
        "The widest gap is between {longer} and {shorter}: {gap_carry:0}, where {usual_carry:0} is usual in your bag."
    ),
    "player-finding-mishits": (
        "{club}: {mishits:n mishit} in {shots:n shot} {mishits:?costs/cost} {lost_carry:0} a shot in the mean."
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
        "{club} differs most in carry: two of three shots lie between {low_carry:0} and {high_carry:0}."
    ),
    "player-finding-strike-high": "{club} meets the ball {high:high/low 0} on the face.",
    "player-finding-strike-toe": "{club} meets the ball {toe:towards the toe/towards the heel 0}.",
    "player-heads-not-judged": (
        "No other head, shaft or ball was tried, and total distance and strokes may ask for another club than carry "
        "does. `clubface golfer estimate` makes a golfer of these shots; `clubface best-loft --golfer` compares lofts "
        "for this golfer, and `clubface optimise` heads, balls and settings, by carry, total distance and strokes."
    ),
    "player-loft-change": (
        "Judged by carry with this head, another loft of {club} is worth a try: with "
        "{change_loft:more/less 1} it would carry {gain_carry:1} farther."
    ),
    "player-loft-keep": (
        "Judged by carry with this head, another loft of {club} is not worth its price: the "
        "best, {change_loft:more/less 1}, would carry {gain_carry:1} farther, less than the {worth_carry:0} that are "
        "worth a change."
    ),
    "player-loft-other": (
        "By {label} alone, {change_loft:more/less 1} would be better by {gain}, without a price in what else counts."
    ),
    "player-loft-other-costs": (
        "By {label} alone, {change_loft:more/less 1} would be better by {gain}, at the price of {losses:and}."
    ),
    "player-lofts-not-judged": (
        "With {players:n player} in the file the lofts of their drivers are not judged: give the shots of one player, "
        "or use `clubface best-loft --golfer`."
    ),
    "player-loft-best": ("Judged by carry with this head, the loft of {club} is the best for your shots."),
    "player-inconsistent-rows": (
        "The figures in these lines of the file are inconsistent, so that one of them may be wrong: {rows:10}."
    ),
    "player-impossible-shots": (
        "{shots:n shot}, as measured, cannot come from this club, and {shots:?is/are} left out of all estimates."
    ),
    "player-mishit": (
        "The shot in {place} {row} is a mishit and is not counted: {figures:and}. Your medians are {usual:and}."
    ),
    "player-mishits-left-out": (
        "{mishits:n mishit} {mishits:?is/are} left out of all figures and named in the section of the club."
    ),
    "player-model-standard": (
        "What a change would do, and what was not measured of the club, come from a model of impact with a standard "
        "club and average golfers, not from your own club: trust the direction and the rough size, not the last "
        "digit."
    ),
    "player-more-shots": "With {more} more shots we would know the medians about twice as well.",
    "player-no-carry": "The file has neither carry nor the whole launch, so that the report gives no distances.",
    "player-no-model": (
        "We have no model of {club}, so that the report gives face, path and strike only as measured, and no what-if."
    ),
    "player-not-measured": "Not measured, and so not judged: {quantities:and}.",
    "player-pictures-of-some": (
        "Pictures are drawn for the first {drawn} of {clubs} clubs; a report on some of the players draws them all "
        "(--where)."
    ),
    "player-practise-carry": (
        "{club}: the {quantity}. It differs by {spread:values} (one standard deviation), which by itself "
        "would spread the carry by {part_carry:0}; everything together spreads it by {spread_carry:0}."
    ),
    "player-practise-mishits": (
        "{club}: the strike. {mishits:n mishit} in {shots:n shot} {mishits:?costs/cost} {lost_carry:0} a shot in the "
        "mean."
    ),
    "player-practise-nothing": "No single part of the swing stands out in what was measured.",
    "player-practise-side": (
        "{club}: the {quantity}. It differs by {spread:values} (one standard deviation), which by itself "
        "would spread the shots by {part_side:0} to either side; everything together spreads them by {spread_side:0}."
    ),
    "player-practise-start": (
        "{club}: the start direction. It differs by {spread_azimuth:1} (one standard deviation), which by itself "
        "would spread the shots by {part_side:0} to either side; everything together, curve included, spreads them by "
        "{spread_side:0}."
    ),
    "player-practise-unknown": (
        "No club data was measured, so that this report cannot say which part of the swing causes the spread."
    ),
    "player-report-by": "This report is about {shots:n shot} by {player} of {file}: {clubs}.",
    "player-report-of": "This report is about {shots:n shot} of {file}: {clubs}.",
    "player-session-changed": "{change:changes}, give or take {margin:values}.",
    "player-session-no-sure-change": "No sure change: {change:changes}, give or take {margin:values}.",
    "player-sessions-compared": "From {first} to {last}, with margins that hold 19 times out of 20:",
    "player-sessions-of-one-shot": "One shot a session is too few to tell a change from chance.",
    "player-sessions-spread": "± is how much the shots of a session differ (one standard deviation, without mishits).",
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
        "Your ball starts {azimuth:to the right/to the left/straight 1} and bends to the side to which its spin axis "
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
