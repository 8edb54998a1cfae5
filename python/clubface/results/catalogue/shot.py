"""Sentences about shots, launches and flights."""

SENTENCES = {
    "all-models": "--model all shows every model side by side; clubface explain says why the ball flies this way.",
    "attack-at-held-loft": (
        "Hitting up more steeply lowers the spin, by {backspin:0} per degree, because the dynamic loft is held: the "
        "angle between path and face becomes smaller."
    ),
    "attached-head": (
        "The head is {how}: along the normal at the face centre it acts like {attached_club_mass}; a free head would "
        "act like {free_club_mass}."
    ),
    "caveat-of-model": "{model}: {caveat}",
    "caveats-listed": "Caveats: clubface models {model}",
    "coefficients-hidden": "{hidden:n coefficient} of {model} are left out; --by NAME and --json have them.",
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
    "explain-start": (
        "The face pointed {face:right/left/at the target} and the club moved {path:right/left/to the target}: a degree "
        "of face turns the start by {face_share:.2f} degrees, a degree of path by {path_share:.2f}."
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
    "friction-lowers-spin": (
        "More friction lowers the spin here, by {backspin:0} for 0.1 more: this ball grips the face anyway, and the "
        "more it grips, the more its sideways deformation springs back against the spin before it leaves. A ball "
        "that slides throughout gains spin from friction."
    ),
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
    "lie-held": (
        "The lie of {lie} turns the head about the target line but does not change the face angle, which is given. A "
        "club that is simply tilted by this much also points {turned_face:right/left}; add that to the face angle if "
        "you mean it."
    ),
    "outside-aerodynamic-data": "Spin leaves the aerodynamic data in flight: {models}.",
    "run-not-measured": (
        "no run has been published for a ball this low or slow; the total is {soft_total:bare 0} to {firm_total:0} "
        "from a soft to a firm fairway"
    ),
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
    "spin-outside-aerodynamic-data": "the spin leaves the range to which the aerodynamics were fitted",
    "rigid-faces": (
        "Treated as rigid, since the file does not say how the face gives: {names}; the faces of the others give, "
        "which adds ball speed."
    ),
    "static-loft": ("No dynamic loft is given: the static loft is assumed ({clubs}), which few golfers deliver."),
    "static-loft-at-held-loft": (
        "More static loft lowers the launch, by {launch} per degree, because the dynamic loft is held: the head is "
        "delivered with its shaft further forward, which moves its CG."
    ),
    "toe-strike-curves-back": (
        "A strike towards the toe gives spin that curves the ball back, {sidespin:0} per mm: the impact turns the "
        "head open, and the face rolls the ball the other way like a gear."
    ),
    "variant-caveats": "{model} with {set}: {caveats:;}.",
}
