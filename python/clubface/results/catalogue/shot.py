"""Sentences about shots, launches and flights."""

SENTENCES = {
    "all-models": "--model all shows every model side by side.",
    "caveat-of-model": "{model}: {caveat}",
    "caveats-listed": "Caveats: clubface models {model}",
    "coefficients-hidden": "{hidden:n coefficient} of {model} are left out; --by NAME and --json have them.",
    "held-as-delivered": (
        "Moving the CG changes the impact alone: dynamic loft, face angle and lie are held as delivered. On a shaft a "
        "CG farther from its axis also adds loft and closes the face before impact; give the delivery that you expect."
    ),
    "outside-aerodynamic-data": "Spin leaves the aerodynamic data in flight: {models}.",
    "run-not-measured": (
        "no measured run of so low or slow a ball is published; the total is {soft_total:bare 0} to {firm_total:0} "
        "from a soft to a firm fairway"
    ),
    "shot-carry": "It carries {carry:0}, rises to {apex:0} and comes down at {landing_angle:0}.",
    "shot-delivery": "The {club} meets the ball {ball} at {speed}, with {loft} of dynamic loft.",
    "shot-launch": "The ball leaves at {ball_speed}, {launch} upwards, and spins with {total_spin}.",
    "shot-of-first-model": "These are the figures of the model {model}; the table has those of the others.",
    "shot-shape": (
        "The ball starts {azimuth:right/left/on the target line}, curves {curve:right/left/not at all 0} and lands "
        "{side:right/left/on the target line 0}: a {shape}."
    ),
    "shot-shape-by-model": (
        "By {model} the ball starts {azimuth:right/left/on the target line}, curves {curve:right/left/not at all 0} "
        "and lands {side:right/left/on the target line 0}: a {shape}."
    ),
    "shot-too-low": "The ball does not leave the ground: it has neither carry nor curve.",
    "shot-too-low-by-model": "By {model} the ball does not leave the ground: it has neither carry nor curve.",
    "shot-without-result": "shot {row} has no result: {reason}",
    "spin-outside-aerodynamic-data": "the spin leaves the range to which the aerodynamics were fitted",
    "static-loft": ("Assumed, since no dynamic loft is given: the static loft ({clubs}), which few golfers deliver."),
}
