"""Sentences about recorded, measured and predicted shots."""

SENTENCES = {
    "brackets-without-unit": "not used, since the text in brackets is not a unit: {columns:10}",
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
    "paths-in-still-air": ("flight paths and computed flight values are for still air of 25 °C at sea level"),
    "paths-of-first-shots": "the flight paths of the first {drawn} of {shots:n shot} are drawn",
    "placeholders-for-nothing": (
        "placeholder numbers count as not measured: {column} in {wrong} of {shots:n shot}, such as {value:.10g} {unit}"
    ),
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
    "spins-contradict-none-kept": "{spins:and} contradict each other; none of them is kept",
    "spins-contradict-more": "spins contradict each other in {more:n more shot}",
    "static-loft-stands-in": (
        "dynamic loft was not measured; the static loft of {club}, {static_loft}, is used in every shot"
    ),
    "summary-rows": "{rows:n row} of averages and deviations, which {rows:?is/are} not shots, left out",
    "taken-as-zero": "not measured and assumed to be zero: {quantities}",
    "toe-unsigned": "the file does not give the sign of {column}: the toe is assumed to be positive",
    "units-assumed": "the file does not name these units, which were assumed: {columns}",
    "value-stated": ("{quantity} was not measured in {lacking} of {shots:n shot}; {stated} is assumed there, as given"),
    "value-stated-not-used": "{quantity} was measured in every shot: the assumed {stated} is not used",
    "without-club-data": "no club data, since the file has no possible club speed: {without} of {shots:n shot}",
}
