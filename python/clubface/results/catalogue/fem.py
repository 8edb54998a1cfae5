"""Sentences about finite element impacts and heads."""

_LIMIT = (
    "the rules allow {limit_characteristic_time:us 0}, and {most_characteristic_time:us 0} with the tolerance, which "
    "they pair with a restitution of 0.822 and 0.830."
)
_COST = (
    "{elements:n element}, {steps:n step} of {safety} of the stable one, {wall}; energy balance error: {energy_error}"
)

SENTENCES = {
    "ball-conforms": "Mass and diameter are within The Equipment Rules.",
    "ball-does-not-conform": "Mass or diameter are outside The Equipment Rules.",
    "carry-in-still-air": "In still air the ball would carry {carry:0}.",
    "contact-of-impact": "They touch for {contact_time} and push each other with up to {peak_force}.",
    "cost-of-failed-run": _COST + " until {last_time:us 0}, the last record kept",
    "cost-of-run": _COST,
    "error-bounds": (
        "Accuracy: on the reference case a mesh of {elements} elements changes ball speed by {speed_over_meshes:.1%} "
        "and spin by {spin_over_meshes:.1%}, and other programs differ by up to {speed_over_solvers:.1%} and "
        "{spin_over_solvers:.1%} (clubface fem reference --meshes 3). The energy balance "
        "checks only the time steps. Errors of the material constants come on top."
    ),
    "face-conforms": "The face conforms: " + _LIMIT,
    "face-conforms-within-tolerance": "The face conforms within the tolerance: " + _LIMIT,
    "face-does-not-conform": "The face does not conform: " + _LIMIT,
    "face-gives": (
        "Its restitution is {restitution}. The pendulum of the rules touches it for {characteristic_time}, its "
        "characteristic time."
    ),
    "face-line": (
        'For the other models, add this line at the top of the file of the head: characteristic_time = "'
        '{characteristic_time:us 0}"'
    ),
    "face-test-error": (
        "This is a simulation, not a conformity test: other meshes of one driver change restitution and time by up to "
        "{mesh_restitution} and {mesh_characteristic_time:us 0}, and the mass of the pendulum is assumed."
    ),
    "head-mass": "The head weighs {mass}, with a moment of inertia about the vertical of {iyy}.",
    "inertia-limit": "The rules of golf allow a driver {limit_iyy:0}.",
    "largest-stress": (
        "The largest stress, {stress:0}, is in the {part}. From the face centre it lies "
        "{high:above/below/at the same height 1}, {toe:towards the toe/towards the heel/neither to toe nor heel 1} and "
        "{forward:towards the target/towards the back/as far forward 1}."
    ),
    "launch-of-impact": (
        "The ball {ball} leaves {head} at {ball_speed}, {launch} upwards and {azimuth:sides} of the target, with "
        "{backspin} of backspin."
    ),
    "mesh-dependence": "Meshes of {counts:and} elements change it by {spread:.0%} at most.",
    "mesh-spread": (
        "From {coarse} to {fine} elements the ball speed changes by {speed_over_meshes:.2%}, the spin by "
        "{spin_over_meshes:.1%} and the peak force by {force_over_meshes:.1%}."
    ),
    "mesh-dependence-unknown": (
        "How much the stress depends on the mesh is not known. To find out, mesh the same surfaces with elements of "
        "half the size, name that file in the TOML, and repeat the impact: the difference is about the error of this "
        "mesh."
    ),
    "no-launch": "There is no launch: {reason}.",
    "no-part-yields": "Struck at {blow}, no part yields. The {part} is closest to yielding, with a margin of {margin}.",
    "no-yield-stress": "No yield stress is given for: {parts}.",
    "one-layer-of-hexahedra": (
        "The mesh has one layer of hexahedra, which cannot resolve the bending of the wall: the stress is too small. "
        "Mesh it with two layers or more."
    ),
    "part-yields": (
        "Struck at {blow}, the {part} is too weak: the stress there reaches {stress:0}, and its metal yields at "
        "{yield_stress:0}. The part bears about {bearable_speed:0} there, if its stress is proportional to the "
        "speed; for more, make it thicker or use a stronger metal."
    ),
    "rebound": "The ball {ball} leaves {head} and spins with {backspin}.",
    "strength-not-counted": (
        "Notches, welds and fatigue over many impacts are not included: a real head needs more margin."
    ),
}
