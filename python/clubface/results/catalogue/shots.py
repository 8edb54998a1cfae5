"""Sentences about measured shots and swings, and of the report for a player."""

SENTENCES = {
    "brackets-without-unit": "not used, since the text in brackets is not a unit: {columns:10}",
    "capture-address": "address taken from frames {first_frame} to {last_frame}",
    "capture-address-of-file": "address taken from frames {first_frame} to {last_frame} of {file}",
    "capture-attitude-contradicted": (
        "the positions of the markers contradict the assumed attitude of the club, most of all in its {measured} "
        "(assumed: {assumed}): check them, or allow a larger deviation under [assumed]"
    ),
    "capture-ball-not-seen": "the ball is not seen after impact; the loss of the head's speed shows that they met",
    "capture-ball-place-alone": (
        "no impact can be read from the head's path, so everything depends on the given position of the ball: {reason}"
    ),
    "capture-ball-start": (
        "the ball starts {late_time:ms 2} after the face touches it, not the 0.2 ms of a real impact: a wrong club, "
        "mapping or calibration"
    ),
    "capture-ball-starts-late": (
        "the ball starts {late_time:ms 2} after the face touches it, {times:.1f} times the 0.2 ms of a real impact: "
        "the file may state a frame rate that is too low, which makes all speeds too low by the same factor; "
        "otherwise a wrong club, mapping or calibration"
    ),
    "capture-contradicts-ball": (
        "the clubhead loses speed {surprise:.1f} standard deviations from where ball, club and markers should be: "
        "check their positions, or give them a larger accuracy"
    ),
    "capture-ends-after-impact": (
        "the recording ends {later:n frame} after the impact, which is assumed to follow frame {frame}; record at "
        "least {fewest} more frames to see the loss of speed itself"
    ),
    "capture-ends-with-impact": (
        "the recording ends with the impact, which is assumed to follow frame {frame}; record at least {fewest} more "
        "frames to see the loss of speed itself"
    ),
    "capture-face-opens": (
        "the face opens through impact, with a closure rate of {closure}: the hand of the club may be wrong (--hand)"
    ),
    "capture-few-degrees-of-freedom": ("the marker noise is estimated from only {freedom:n degree} of freedom"),
    "capture-filled": (
        "{markers}: {frames:?frame/frames} {frames:ranges} not seen but filled by the capture program (a line or a "
        "spline): left out"
    ),
    "capture-filtered": (
        "the markers move more smoothly than noise allows (correlation of successive steps of their residuals "
        "{correlation:.2f}, -0.50 for white noise): the trajectories were filtered, or markers swing on their mounts. "
        "A filter that ran across the impact slows the clubhead before it, beyond the stated uncertainty, and nothing "
        "can undo that: export raw trajectories"
    ),
    "capture-flight-contradicts": (
        "the ball leaves with {seen}, but this delivery of {club} gives {expected}: a wrong club, mapping or "
        "calibration"
    ),
    "capture-head-lost": "the clubhead is lost from sight before it meets the ball",
    "capture-impact": "impact is where the head loses {lost:.0%} of its speed",
    "capture-impact-again": (
        "it loses speed in frame {again} as well as in frame {frame} of the recording: trim the recording to read that "
        "one"
    ),
    "capture-lie": "a lie of {lie} is impossible for a club: the axis that points up may be wrong",
    "capture-loft": (
        "the dynamic loft of {loft} is far from the {static_loft} of {club}: a wrong club, mapping or calibration"
    ),
    "capture-loft-uncertain": (
        "the dynamic loft is not known to 2 deg: too few markers, too near together, or gaps before impact"
    ),
    "capture-marker-moved": (
        "{marker} sits {marker_displacement} from its place in the mapping or calibration: has it moved?"
    ),
    "capture-marker-not-seen": "{marker} is never seen",
    "capture-marker-strays": "{marker} is out of place in {frames:?frame/frames} {frames:ranges}: left out there",
    "capture-markers-do-not-fit": (
        "the markers of the clubhead do not fit in {frames:?frame/frames} {frames:ranges}: left out"
    ),
    "capture-markers-exchanged": "{markers:and} swapped in {frames:?frame/frames} {frames:ranges}: corrected",
    "capture-markers-look-alike": ("the cluster looks the same with {markers:and} swapped: a swap would go unnoticed"),
    "capture-markers-not-calibrated": "{markers} not seen in the calibration: left out",
    "capture-not-plausible": (
        "not plausible: {values}. Do not use these figures: see which markers are hidden or out of place in which "
        "frames (capture markers, --plot), trim the recording to the swing, and check frames under [calibration], "
        "target and up under [laboratory], and the club"
    ),
    "capture-nothing-seen-after-impact": (
        "neither ball nor clubhead is seen after impact: that they met is inferred from where they were before"
    ),
    "capture-off-face": (
        "the impact lies {toe} towards the toe and {high} high, outside the face of {club} ({face_width:bare} x "
        "{face_height}): a wrong club, mapping or calibration"
    ),
    "capture-path": (
        "the club goes {path} to the right of the target: the axis that points to the target may be wrong (target "
        "under [laboratory], or --target)"
    ),
    "capture-path-extended": (
        "the last {missing} frames before impact do not show the clubhead's pose: extrapolated across them"
    ),
    "capture-path-misfit": (
        "the path differs from the estimator's by {misfit:.1f} times the expected variance: its uncertainty is too "
        "small (trajectories filtered across the impact do that: export them raw; otherwise give a larger roughness "
        "or the marker noise)"
    ),
    "capture-speed": "a clubhead of {speed}: the unit of length or the frame rate may be wrong",
    "capture-speed-uncertain": (
        "the speed is hardly known, {values}: too few frames before impact show the clubhead, or markers are out of "
        "place there; remove such markers from [cluster], or trim the recording"
    ),
    "cells-without-number": "{column}: {cells:n cell} without a number, such as {example}: not measured",
    "club-column": "the column {column} was read as club names",
    "club-may-be-other": "the shots name {names}, not {club}: is this the right club?",
    "column-misspelled": "the column {column} is not used; did you mean {near}?",
    "column-values": "{column}: {counts:10}",
    "columns-not-read": ("columns of numbers that were not read, since they are not known quantities: {columns:10}"),
    "compared-at-launch": "compared at the measured {met:and}: {solved:and} are solved for each shot and model",
    "condition-fulfilled": "{fulfil} of {shots:n shot} meet {condition}",
    "condition-undecided": "{undecided} of {shots:n shot} lack a value that {condition} needs",
    "date-read": "the date {date} was read as {day}, with the {first} first",
    "decimals-or-thousands": (
        "it is not clear whether the {mark} in numbers such as {example} separates thousands or decimals: write them "
        "without thousands separators, or give the decimal sign in a mapping"
    ),
    "face-and-path-contradict": (
        "face angle, path and face to path contradict each other in {wrong} of {shots:n shot}, such as line {line}: "
        "{values}; face to path is not used there"
    ),
    "faster-than-club": (
        "the ball is faster than the club can make it in {wrong} of {shots:n shot} (line {lines:3}; first {example}): "
        "neither speed counts as measured there"
    ),
    "file-lofts-not-used": "the dynamic lofts of the file were computed from the ball, and are not used",
    "hand-assumed": (
        "the file does not give the hand: right-handed is assumed; give the hand, left, if the player is left-handed"
    ),
    "impossible-values": "impossible values count as not measured: {example} in {wrong} of {shots:n shot}",
    "irons-hit-upwards": (
        "the median attack angle of irons and wedges is {attack} upwards, but players hit them down: is the sign of "
        "attack reversed in this file?"
    ),
    "launch-from-club-data": (
        "the ball was not measured in {made} of {shots:n shot}: its launch is computed from the club data with the "
        "model {model}, and typical values for what the monitor does not measure"
    ),
    "launch-refused": ("the model cannot compute a launch from the club data of {refused:n shot}"),
    "launches-of-captured": "{quantities} of the launches taken from {captured}: the other table has none",
    "loft-and-face-computed": (
        "dynamic loft and face angle were computed from the ball, not measured: I w / (m R v_t) is one number from "
        "shot to shot, {ratio:.3f} ± {ratio_scatter:.3f} in {shots:n shot} of {club}"
    ),
    "loft-computed": (
        "dynamic loft was computed from the ball, not measured: I w / (m R v_t) is one number from shot to shot, "
        "{ratio:.3f} ± {ratio_scatter:.3f} in {shots:n shot} of {club}"
    ),
    "loft-computed-advice": (
        "if you fit or judge spin with such a loft, you only recover the monitor's own impact model; "
        'evaluate and identify with --at-launch (compared_at="launch" in Python) solve loft and face angle '
        "to match the measured launch, and compare spin and ball speed there"
    ),
    "marks-read": "numbers of {column} marked with a sign such as *, as for estimates, were read",
    "measured-face-angles-at-contact": "dynamic loft and face angle were measured at the point of contact",
    "measured-face-angles-at-different-places": (
        "the files measure dynamic loft and face angle at different places ({places}), so they cannot be compared"
    ),
    "measured-face-angles-at-face": "dynamic loft and face angle were measured at the face centre",
    "measured-face-angles-at-unknown": "dynamic loft and face angle were measured at a point that is not published",
    "measured-motion-at-cg": "club speed, attack angle and path were measured at the centre of gravity",
    "measured-motion-at-different-places": (
        "the files measure club speed, attack angle and path at different places ({places}), so they cannot be compared"
    ),
    "measured-motion-at-face": "club speed, attack angle and path were measured at the face centre",
    "measured-motion-at-unknown": "club speed, attack angle and path were measured at a point that is not published",
    "median-loft-of-other-club": (
        "the median dynamic loft is {delivered_loft}, the static loft of {club} {static_loft}: is this the right club?"
    ),
    "message-field-no-number": "{field} is {value}, which is not a number: treated as not measured",
    "message-field-no-unit": "{field} is {value}, which is not a number with a unit: treated as not measured",
    "message-part-missing": "{part} is missing",
    "message-speed-negative": "ClubData.Speed is {value:g}, which is below 0: treated as not measured",
    "message-units": "Units is {value} and must be Yards or Meters: the carry is treated as not measured",
    "messages-more": "and {more} more such notes",
    "monitor-any-other-file": "clubface monitor formats NAME shows the columns; any other file is read with --mapping.",
    "monitor-closure-about-shaft": (
        "Foresight measures the closure rate about the shaft; it is used as the rate about the vertical"
    ),
    "monitor-maximum-compression": (
        "TrackMan measures attack angle, path, dynamic loft and face angle at maximum compression, about a quarter of "
        "a millisecond after first touch"
    ),
    "monitor-sidespin-turned": "Garmin's sidespin is positive to the left: its sign was reversed",
    "monitor-toe-unsigned": (
        "FlightScope does not publish the sign of its lateral impact: the toe is assumed to be positive"
    ),
    "not-referred-contact-face": (
        "dynamic loft and face angle stay as measured in {lacking} of {shots:n shot}, which lack the point of contact"
    ),
    "not-referred-motion": (
        "the club's motion stays as measured in {lacking} of {shots:n shot}, which lack the closure rate"
    ),
    "not-utf-8": "the file is not UTF-8: read as {encoding}",
    "paired-by-order": "paired by order alone: the two tables have no common quantity to match shots by",
    "paired-by-values": "paired in order by {quantities}",
    "paths-in-still-air": ("flight paths and computed flight values are for still air of 25 °C at sea level"),
    "paths-of-first-shots": "the flight paths of the first {drawn} of {shots:n shot} are drawn",
    "placeholders-for-nothing": (
        "placeholder numbers count as not measured: {column} in {wrong} of {shots:n shot}, such as {value:.10g} {unit}"
    ),
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
    "player-finding-carry-spread": (
        "{club} varies most in carry: two of three shots lie between {low_carry:0} and {high_carry:0}."
    ),
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
    "player-finding-strike-high": "{club} meets the ball {high:high/low 0} on the face.",
    "player-finding-strike-toe": "{club} meets the ball {toe:towards the toe/towards the heel 0}.",
    "player-heads-not-judged": (
        "No other head, shaft or ball was tried, and total distance and strokes may favour another club than carry "
        "does. `clubface golfer estimate` makes a golfer from these shots; for this golfer `clubface best-loft "
        "--golfer` compares lofts, and `clubface optimise` heads, balls and settings, by carry, total distance and "
        "strokes."
    ),
    "player-impossible-shots": (
        "{shots:n shot}, as measured, cannot come from this club, and {shots:?is/are} left out of all estimates."
    ),
    "player-inconsistent-rows": (
        "The figures in these lines of the file are inconsistent, so one of them may be wrong: {rows:10}."
    ),
    "player-loft-best": ("Judged by carry with this head, the loft of {club} is the best for your shots."),
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
    "read-as-asked": "read as {format}, as requested, although the columns match {formats:and}",
    "referred-contact-face": (
        "dynamic loft and face angle converted to the face centre of {club} in {referred} of {shots:n shot}"
    ),
    "referred-motion": "the club's motion converted to the centre of gravity of {club} in {referred} of {shots:n shot}",
    "session-gap-not-sure": (
        "the gap between {longer} and {shorter} is uncertain: {gap_carry:1} with a standard error of {error_carry:1}"
    ),
    "session-gap-of-a-single-shot": (
        "the gap between {longer} and {shorter} is uncertain: {gap_carry:1} with a single shot, so its error is not "
        "known"
    ),
    "session-median": ("medians, with ± the standard deviation from shot to shot, both without the listed mishits"),
    "session-median-of-all": "medians, with ± the standard deviation from shot to shot",
    "session-partly-measured": "{quantity} was not measured in every shot: {counts}",
    "sheet-read": "the sheet {sheet} was read, but {others} not: save each sheet as a separate file",
    "shots-in-earlier-file": "{left} of {shots:n shot} are also in an earlier file and were left out",
    "shots-without-path": (
        "{without} of {shots:n shot} have no flight path, which needs ball speed, both angles and the spin"
    ),
    "sign-one-turned": (
        "the sign of {quantity} disagrees with {others:and} from shot to shot: is one of them reversed in this file?"
    ),
    "sign-turned": "the sign of {quantity} disagrees with {others:and} from shot to shot: is it reversed in this file?",
    "speed-of-club-or-ball": (
        "the column {column} may be the speed of the club or of the ball and is not read: call it club_speed or "
        "ball_speed, or name it in a mapping"
    ),
    "spin-direction-unknown": (
        "total spin measured without its axis, alone or with backspin, does not say to which side the ball curves: "
        "sidespin and spin axis stay unknown there"
    ),
    "spin-not-topped": (
        "where only total spin and sidespin are known, backspin is computed for a ball that was not topped"
    ),
    "spins-contradict": "{spins:and} contradict each other; kept: {kept:and}",
    "spins-contradict-more": "spins contradict each other in {more:n more shot}",
    "spins-contradict-none-kept": "{spins:and} contradict each other; none of them is kept",
    "static-loft-stands-in": (
        "dynamic loft was not measured; the static loft of {club}, {static_loft}, is used in every shot"
    ),
    "summary-rows": "{rows:n row} of averages and deviations, which {rows:?is/are} not shots, left out",
    "taken-as-zero": "not measured and assumed to be zero: {quantities}",
    "target-lines-differ": (
        "the azimuths of {measured} differ from those of {captured} by {azimuth:sides 2} (median): if that is more "
        "than noise, the target lines differ"
    ),
    "toe-unsigned": "the file does not give the sign of {column}: the toe is assumed to be positive",
    "units-assumed": "the file does not name these units, which were assumed: {columns}",
    "value-stated": ("{quantity} was not measured in {lacking} of {shots:n shot}; {stated} is assumed there, as given"),
    "value-stated-not-used": "{quantity} was measured in every shot: the assumed {stated} is not used",
    "without-club-data": "no club data, since the file has no possible club speed: {without} of {shots:n shot}",
}
