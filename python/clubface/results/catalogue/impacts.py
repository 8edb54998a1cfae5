"""Sentences about models, clubs and balls, and about impacts and flights."""

_LIMIT = (
    "the rules allow {limit_characteristic_time:us 0}, and {most_characteristic_time:us 0} with the tolerance, which "
    "they pair with a restitution of 0.822 and 0.830."
)
_COST = (
    "{elements:n element}, {steps:n step} of {safety} of the stable one, {wall}; energy balance error: {energy_error}"
)

SENTENCES = {
    "all-models": "--model all shows every model side by side; clubface explain says why the ball flies this way.",
    "attached-head": (
        "The head is {how}: along the normal at the face centre it acts like {attached_club_mass}; a free head would "
        "act like {free_club_mass}."
    ),
    "attack-at-held-loft": (
        "Hitting up more steeply lowers the spin, by {backspin:0} per degree, because the dynamic loft is held: the "
        "angle between path and face becomes smaller."
    ),
    "ball-conforms": "Mass and diameter are within The Equipment Rules.",
    "ball-does-not-conform": "Mass or diameter are outside The Equipment Rules.",
    "carry-in-still-air": "In still air the ball would carry {carry:0}.",
    "caveat-of-model": "{model}: {caveat}",
    "caveats-listed": "Caveats: clubface models {model}",
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
    "coefficients-hidden": "{hidden:n coefficient} of {model} are left out; --by NAME and --json have them.",
    "contact-of-impact": "They touch for {contact_time} and push each other with up to {peak_force}.",
    "cost-of-failed-run": _COST + " until {last_time:us 0}, the last record kept",
    "cost-of-run": _COST,
    "default-model": "{model} is the default model.",
    "default-set": "[{place}] {set}, for {club}, used by default: {source}. {reference}",
    "error-bounds": (
        "Accuracy: on the reference case a mesh of {elements} elements changes ball speed by {speed_over_meshes:.1%} "
        "and spin by {spin_over_meshes:.1%}, and other programs differ by up to {speed_over_solvers:.1%} and "
        "{spin_over_solvers:.1%} (clubface fem reference --meshes 3). The energy balance "
        "checks only the time steps. Errors of the material constants come on top."
    ),
    "explain-axis": (
        "{spin_axis:The spin axis is tilted # to the right: the lift leans with it and pulls the ball that way"
        "/The spin axis is tilted # to the left: the lift leans with it and pulls the ball that way"
        "/The spin axis is level: the lift pulls the ball to neither side}."
    ),
    "explain-curve-face": (
        "The face was {open_face:open/closed/square} to the path. With the face square to it the ball would "
        "{square_curve:curve # right/curve # left/fly straight 0} instead of {curve:# right/# left/straight 0}."
    ),
    "explain-curve-square": (
        "The face was square to the path, so the curve ({curve:right/left/none 0}) comes only from the strike and the "
        "head."
    ),
    "explain-curve-strike": (
        "Struck in the middle of the face it would {middle_curve:curve # right/curve # left/fly straight 0} instead of "
        "{curve:# right/# left/straight 0}: a head struck off its centre turns and gears the ball (gear effect)."
    ),
    "explain-launch": (
        "It launches at {launch}, between the loft of {loft} and the attack angle of {attack}: a degree of loft raises "
        "it by {loft_share:.2f} degrees, a degree of attack by {attack_share:.2f}. The angle between them makes the "
        "backspin of {backspin}."
    ),
    "explain-launch-strike": (
        "The strike was {high:high/low}; in the middle of the face it would launch at {middle_launch} with "
        "{middle_backspin} of backspin."
    ),
    "explain-shape-limits": (
        "The names follow from start and curve: straight up to {straight_curve:0} of curve at this carry, a draw or "
        "fade up to {big_curve:0}, a hook or slice beyond; a push or pull starts more than {straight_azimuth:deg 0} "
        "off the line."
    ),
    "explain-speed-strike": (
        "Struck there the ball leaves at {ball_speed} and carries {carry}; from the middle of the face, which is the "
        "centre of its outline, it would leave at {middle_ball_speed} and carry {middle_carry}."
    ),
    "explain-start": (
        "The face pointed {face:right/left/at the target} and the club moved {path:right/left/to the target}: a degree "
        "of face turns the start by {face_share:.2f} degrees, a degree of path by {path_share:.2f}."
    ),
    "explain-start-bulge": (
        "The strike was {toe:towards the toe/towards the heel}, where bulge turns the face {turned_face:right/left}; "
        "from the middle of the face it would start {middle_azimuth:right/left/on the target line}. The rest comes "
        "from the head, which the off-centre strike turns."
    ),
    "explain-start-strike": (
        "The strike was {toe:towards the toe/towards the heel}; from the middle of the face it would start "
        "{middle_azimuth:right/left/on the target line}. The off-centre strike turns the head while they touch."
    ),
    "explain-sweet-spot": (
        "The sweet spot, where this swing gives the most ball speed, is not the centre: it lies {toe:towards the toe/"
        "towards the heel/at its middle 0} and {high:above the centre/below the centre/at the height of the centre 0}. "
        "There it would leave at {ball_speed} and carry {carry}."
    ),
    "explain-worth": (
        "What changes are worth: a degree of face moves the landing {face_side:# to its own side/# to the other "
        "side}, a degree of path {path_side:# to its own side/# to the other side}, and a strike 10 mm nearer the toe "
        "{toe_side:# to the right/# to the left}; a degree of loft carries it {loft_carry:farther/shorter}, 1 mph of "
        "club speed {speed_carry:farther/shorter}. These are slopes at this shot, for small changes."
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
    "friction-lowers-spin": (
        "More friction lowers the spin here, by {backspin:0} for 0.1 more: this ball grips the face anyway, and the "
        "more it grips, the more its sideways deformation springs back against the spin before it leaves. A ball "
        "that slides throughout gains spin from friction."
    ),
    "further-model": '{model}: {summary} "all" does not include it.',
    "head-mass": "The head weighs {mass}, with a moment of inertia about the vertical of {iyy}.",
    "held-as-delivered": (
        "Moving the CG changes only the impact: dynamic loft, face angle and lie are held as delivered. On a shaft a "
        "CG farther from the shaft axis also adds loft and closes the face before impact; give the delivery that you "
        "expect."
    ),
    "high-strike-lowers-spin": (
        "A higher strike lowers the spin, by {backspin:0} per mm, although it launches higher: the impact turns the "
        "head back, and the face rolls the ball forward like a gear."
    ),
    "hosel-energy": (
        "The ball gains {gained:.1f} J and {lost:.1f} J are lost; of this the shaft supplies {carried:.1f} J, the head "
        "the rest."
    ),
    "hosel-force": "Head and shaft act on each other with {force:.0f} N on average over {contact_time}.",
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
    "lie-held": (
        "The lie of {lie} turns the head about the target line but does not change the face angle, which is given. A "
        "club that is simply tilted by this much also points {turned_face:right/left}; add that to the face angle if "
        "you mean it."
    ),
    "mesh-dependence": "Meshes of {counts:and} elements change it by {spread:.0%} at most.",
    "mesh-dependence-unknown": (
        "How much the stress depends on the mesh is not known. To find out, mesh the same surfaces with elements of "
        "half the size, name that file in the TOML, and repeat the impact: the difference is about the error of this "
        "mesh."
    ),
    "mesh-dimensions": "Volume and dimensions are for the whole mesh, including a hosel if it has one.",
    "mesh-spread": (
        "From {coarse} to {fine} elements the ball speed changes by {speed_over_meshes:.2%}, the spin by "
        "{spin_over_meshes:.1%} and the peak force by {force_over_meshes:.1%}."
    ),
    "model-in-full": ("clubface models NAME lists parameters, units, bounds, published values, sources and caveats."),
    "model-laws": "Laws it obeys: {laws}",
    "model-paper": "{short}: {title}",
    "model-range": "Range it is made for: {range}",
    "model-reference": "Reference: {reference}",
    "model-summary": "{summary}",
    "no-launch": "There is no launch: {reason}.",
    "no-part-yields": "Struck at {blow}, no part yields. The {part} is closest to yielding, with a margin of {margin}.",
    "no-yield-stress": "No yield stress is given for: {parts}.",
    "one-layer-of-hexahedra": (
        "The mesh has one layer of hexahedra, which cannot resolve the bending of the wall: the stress is too small. "
        "Mesh it with two layers or more."
    ),
    "outside-aerodynamic-data": "Spin leaves the aerodynamic data in flight: {models}.",
    "parameters-from": "{parameters}: {source}",
    "part-yields": (
        "Struck at {blow}, the {part} is too weak: the stress there reaches {stress:0}, and its metal yields at "
        "{yield_stress:0}. The part bears about {bearable_speed:0} there, if its stress is proportional to the "
        "speed; for more, make it thicker or use a stronger metal."
    ),
    "published-set": "[{place}] {set}, for {club}: {source}. {reference}",
    "rebound": "The ball {ball} leaves {head} and spins with {backspin}.",
    "rebound-of-model": (
        "The heads are flat, rigid, struck through the CG and cannot turn; angles are compared at {speed:.0f} m/s, "
        "with iron parameters if a model has published ones. Along the face, 0 means that the ball leaves rolling, -1 "
        "that it slides without friction, and more than 0 that the ball springs back sideways. The lever is the lever "
        "arm of friction about the ball's centre, divided by its radius."
    ),
    "rigid-faces": (
        "Treated as rigid, since the file does not say how the face gives: {names}; the faces of the others give, "
        "which adds ball speed."
    ),
    "run-not-measured": (
        "no run has been published for a ball this low or slow; the total is {soft_total:bare 0} to {firm_total:0} "
        "from a soft to a firm fairway"
    ),
    "set-caveat": "[{place}] {caveat}",
    "set-range": "[{place}] from shots with {range}",
    "shot-carry": "It carries {carry:0}, rises to {apex:0} and comes down at {landing_angle:0}.",
    "shot-delivery": "The {club} meets the ball {ball} at {speed}, with {loft} of dynamic loft.",
    "shot-launch": "The ball leaves at {ball_speed}, {launch} upwards, and spins with {total_spin}.",
    "shot-of-first-model": "These are the figures of the model {model}; the table also shows the other models.",
    "shot-shape": (
        "The ball starts {azimuth:right/left/on the target line}, "
        "{curve:curves # right/curves # left/flies straight 0} and lands {side:right/left/on the target line 0}: a "
        "{shape}."
    ),
    "shot-shape-by-model": (
        "With {model} the ball starts {azimuth:right/left/on the target line}, "
        "{curve:curves # right/curves # left/flies straight 0} and lands {side:right/left/on the target line 0}: a "
        "{shape}."
    ),
    "shot-too-low": "The ball does not leave the ground: it has neither carry nor curve.",
    "shot-too-low-by-model": "With {model} the ball does not leave the ground: it has neither carry nor curve.",
    "shot-without-result": "shot {row} has no result: {reason}",
    "small-ball": (
        "The published models were identified with a ball of 42.60 mm, a little below the 42.67 mm of the rules."
    ),
    "source-of-values": "[{place}] {source}",
    "spin-outside-aerodynamic-data": "the spin leaves the range to which the aerodynamics were fitted",
    "static-loft": ("No dynamic loft is given: the static loft is assumed ({clubs}), which few golfers deliver."),
    "static-loft-at-held-loft": (
        "More static loft lowers the launch, by {launch} per degree, because the dynamic loft is held: the head is "
        "delivered with its shaft further forward, which moves its CG."
    ),
    "strength-not-counted": (
        "Notches, welds and fatigue over many impacts are not included: a real head needs more margin."
    ),
    "time-of-cor": (
        "The characteristic time is computed from a restitution of {restitution}. On simulated heads the two tests "
        "disagree by up to {error_restitution} in restitution; if you have both figures, give the time, which was "
        "closer to the mesh of the one head compared."
    ),
    "toe-strike-curves-back": (
        "A strike towards the toe gives spin that curves the ball back, {sidespin:0} per mm: the impact turns the "
        "head open, and the face rolls the ball the other way like a gear."
    ),
    "unmeasured-face": (
        'The file does not say how the face gives; add the pendulum result as in characteristic_time = "250 us".'
    ),
    "unmeasured-mesh": (
        "The file does not say how the face gives: clubface fem head {file} --measure simulates it and prints the line "
        "with the characteristic time to add."
    ),
    "value-caveat": "[{place}] {parameter}: {caveat}",
    "variant-caveats": "{model} with {set}: {caveats:;}.",
}
