"""Sentences about models, clubs, balls and parameter sets."""

SENTENCES = {
    "cg-above-normal": "The CG lies {cg_y} above the normal through the face centre.",
    "cg-behind-face": "The CG lies {cg_x} behind the face.",
    "cg-below-normal": "The CG lies {cg_y} below the normal through the face centre.",
    "cg-in-front-of-face": "The CG lies {cg_x} in front of the face.",
    "club-conforms": "{file}: a club that can exist and conforms to the rules above",
    "club-does-not-conform": "{file}: a club that can exist, but does not conform to the rules: {broken:;}",
    "club-partly-judged": (
        "{file}: a club that can exist; as far as is known, it conforms to the rules. Not known: {unknown:;}"
    ),
    "club-possible": "{file}: a club that can exist; none of the rules applies to it",
    "clubs-listed": (
        "MOI is the moment of inertia about the vertical axis; the normal is that through the face centre. A "
        "parametric club is plausible, not measured; clubface clubs NAME shows the source or the assumption of every "
        "value."
    ),
    "coefficients-are-terms": (
        "{coefficients} parameters are the coefficients of {functions} functions; --json lists each with its bounds."
    ),
    "default-model": "{model} is the default model.",
    "default-set": "[{place}] {set}, for {club}, used by default: {source}. {reference}",
    "further-model": '{model}: {summary} "all" does not include it.',
    "mesh-dimensions": "Volume and dimensions are for the whole mesh, including a hosel if it has one.",
    "model-in-full": ("clubface models NAME lists parameters, units, bounds, published values, sources and caveats."),
    "model-laws": "Laws it obeys: {laws}",
    "model-paper": "{short}: {title}",
    "model-range": "Range it is made for: {range}",
    "model-reference": "Reference: {reference}",
    "model-summary": "{summary}",
    "parameters-from": "{parameters}: {source}",
    "published-set": "[{place}] {set}, for {club}: {source}. {reference}",
    "rebound-of-model": (
        "The heads are flat, rigid, struck through the CG and cannot turn; angles are compared at {speed:.0f} m/s, "
        "with iron parameters if a model has published ones. Along the face, 0 means that the ball leaves rolling, -1 "
        "that it slides without friction, and more than 0 that the ball springs back sideways. The lever is the lever "
        "arm of friction about the ball's centre, divided by its radius."
    ),
    "set-caveat": "[{place}] {caveat}",
    "set-range": "[{place}] from shots with {range}",
    "small-ball": (
        "The published models were identified with a ball of 42.60 mm, a little below the 42.67 mm of the rules."
    ),
    "source-of-values": "[{place}] {source}",
    "time-of-cor": (
        "The characteristic time is computed from a restitution of {restitution}. On simulated heads the two tests "
        "disagree by up to {error_restitution} in restitution; if you have both figures, give the time, which was "
        "closer to the mesh of the one head compared."
    ),
    "unmeasured-face": (
        'The file does not say how the face gives; add the pendulum result as in characteristic_time = "250 us".'
    ),
    "unmeasured-mesh": (
        "The file does not say how the face gives: clubface fem head {file} --measure simulates it and prints the line "
        "with the characteristic time to add."
    ),
    "value-caveat": "[{place}] {parameter}: {caveat}",
}
