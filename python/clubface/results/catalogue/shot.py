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
    "shot-delivery": "The {club} meets the ball {ball} at {speed}, with {loft} of dynamic loft.",
    "shot-launch": "The ball leaves at {ball_speed}, {launch} upwards, and spins with {total_spin}.",
    "shot-of-first-model": "These are the figures of the model {model}; the table has those of the others.",
    "shot-off-line": (
        "It carries {carry:0} and lands {side:sides 0} of the line, after it has risen to {apex:0}; it comes down at "
        "{landing_angle:0}."
    ),
    "shot-on-line": (
        "It carries {carry:0} and lands on the line to the target, after it has risen to {apex:0}; it comes down at "
        "{landing_angle:0}."
    ),
    "shot-without-result": "shot {row} has no result: {reason}",
    "spin-outside-aerodynamic-data": "the spin leaves the range to which the aerodynamics were fitted",
    "static-loft": "--loft is not given: delivered with the static loft ({clubs}), which few golfers do.",
}
