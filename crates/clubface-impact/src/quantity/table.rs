//! The table of quantities.

use super::Quantity;
use crate::unit::{
    ANGLE, ANGULAR_RATE, AREA, AREA_DAMPING, DENSITY, DIMENSIONLESS, ENERGY, FORCE, INERTIA, INVERSE_SPEED,
    LENGTH, MASS, MASS_MOMENT, PRESSURE, ROTARY_DAMPING, ROTARY_STIFFNESS, SPEED, TEMPERATURE, TIME,
    VOLUMETRIC_STIFFNESS,
};

const fn entry(
    name: &'static str,
    symbol: &'static str,
    dimension: crate::unit::Dimension,
    label: &'static str,
    meaning: &'static str,
) -> Quantity {
    Quantity::new(name, symbol, dimension, label, meaning)
}

/// All quantities: one table, which others point into.
#[rustfmt::skip]
pub static QUANTITIES: &[Quantity] = &[
    // Delivery.
    entry("speed", "v_c", SPEED, "club speed", "speed of the clubhead CG")
        .synonyms(&["club_speed", "clubhead_speed", "club_head_speed", "head_speed", "clubspeed", "swing_speed",
            "club_velocity", "clubhead_velocity", "club_head_velocity"]),
    entry("attack", "alpha", ANGLE, "attack angle", "vertical direction in which the clubhead CG moves")
        .sign("up is positive").sides("down", "up")
        .synonyms(&["attack_angle", "angle_of_attack", "aoa", "club_aoa", "attack_ang", "vert_path", "vertical_path",
            "vertical_club_path", "club_attack_angle"]),
    entry("path", "psi", ANGLE, "club path", "horizontal direction in which the clubhead CG moves")
        .sign("right of the target is positive").sides("left", "right")
        .synonyms(&["club_path", "swing_path", "horiz_path", "horizontal_path", "horizontal_club_path", "path_angle",
            "club_path_angle", "clubhead_path"]),
    entry("loft", "theta", ANGLE, "dynamic loft", "angle of the face normal at the face centre above horizontal")
        .synonyms(&["dynamic_loft", "dyn_loft", "delivered_loft", "loft_at_impact", "impact_loft"]),
    entry("face", "phi", ANGLE, "face angle", "horizontal direction of the face normal at the face centre")
        .sign("right of the target is positive").sides("left", "right")
        .synonyms(&["face_angle", "club_face_angle", "clubface_angle", "face_ang", "club_face", "face_to_target",
            "ftt", "face_to_target_angle", "club_face_to_target"]),
    entry("lie", "lambda", ANGLE, "lie tilt", "tilt of the clubhead about the horizontal axis to the target")
        .sign("toe up is positive").sides("toe down", "toe up").synonyms(&["lie_tilt"]),
    entry("toe", "z_i", LENGTH, "impact towards the toe",
        "impact offset from the face centre along the face, in the plane tangent there")
        .read("mm", 1).sign("towards the toe is positive").sides("heel", "toe")
        .synonyms(&["impact_toe", "toe_offset", "impact_offset", "horiz_impact", "horizontal_impact",
            "impact_horizontal", "horizontal_face_impact", "face_impact_horizontal", "face_impact_lateral",
            "lateral_impact"]),
    entry("high", "y_i", LENGTH, "impact height",
        "impact offset from the face centre up the face, in the plane tangent there")
        .read("mm", 1).sign("towards the crown is positive").sides("low", "high")
        .synonyms(&["impact_high", "high_offset", "impact_height", "vert_impact", "vertical_impact", "impact_vertical",
            "vertical_face_impact", "face_impact_vertical"]),
    entry("closure", "omega_y", ANGULAR_RATE, "closure rate",
        "rate at which the clubhead turns about the world vertical")
        .read("deg/s", 0).sign("closing is positive").sides("opening", "closing")
        .synonyms(&["closure_rate", "face_closure", "face_closure_rate", "rate_of_closure"]),
    entry("pitch_rate", "omega_z", ANGULAR_RATE, "pitch rate",
        "rate at which the dynamic loft grows, about the horizontal to the right")
        .read("deg/s", 0).sign("increasing loft is positive").sides("decreasing", "increasing")
        .synonyms(&["loft_rate"]),
    entry("lie_rate", "omega_x", ANGULAR_RATE, "lie rate", "rate of the lie tilt, about the horizontal to the target")
        .read("deg/s", 0).sign("toe up is positive").sides("toe down", "toe up"),
    entry("ball_backspin", "omega_b0z", ANGULAR_RATE, "backspin before impact",
        "spin of the ball before impact about the horizontal to the right of the target; 0 for a ball at rest")
        .sign("backspin is positive").sides("topspin", "backspin"),
    entry("ball_sidespin", "omega_b0y", ANGULAR_RATE, "sidespin before impact",
        "spin of the ball before impact about the downward vertical; 0 for a ball at rest")
        .sign("curving right is positive").sides("left", "right"),
    entry("ball_riflespin", "omega_b0x", ANGULAR_RATE, "rifle spin before impact",
        "spin of the ball before impact about the horizontal to the target; 0 for a ball at rest")
        .sign("right-handed is positive"),
    // Club and ball.
    entry("club_mass", "m_c", MASS, "clubhead mass", "mass of the clubhead"),
    entry("cg_x", "c_x", LENGTH, "CG to face, forwards", "CG to face centre, along x (to the target) at static loft")
        .read("mm", 1).sign("face in front of the CG is positive"),
    entry("cg_y", "c_y", LENGTH, "CG to face, up", "CG to face centre, along y (up) at static loft")
        .read("mm", 1).sign("face centre above the CG is positive"),
    entry("cg_z", "c_z", LENGTH, "CG to face, towards the toe",
        "CG to face centre, along z (to the toe) at static loft")
        .read("mm", 1).sign("face centre on the toe side of the CG is positive"),
    entry("ixx", "I_xx", INERTIA, "inertia about x", "inertia about the CG at static loft, element xx"),
    entry("iyy", "I_yy", INERTIA, "inertia about y", "inertia about the CG at static loft, element yy"),
    entry("izz", "I_zz", INERTIA, "inertia about z", "inertia about the CG at static loft, element zz"),
    entry("ixy", "I_xy", INERTIA, "product of inertia xy", "inertia about the CG at static loft, element xy")
        .sign("element of the matrix"),
    entry("ixz", "I_xz", INERTIA, "product of inertia xz", "inertia about the CG at static loft, element xz")
        .sign("element of the matrix"),
    entry("iyz", "I_yz", INERTIA, "product of inertia yz", "inertia about the CG at static loft, element yz")
        .sign("element of the matrix"),
    entry("static_loft", "theta_0", ANGLE, "loft", "loft of the club"),
    entry("bulge", "R_b", LENGTH, "bulge", "horizontal radius of the face, infinite if flat").read("mm", 0),
    entry("roll", "R_r", LENGTH, "roll", "vertical radius of the face, infinite if flat").read("mm", 0),
    entry("face_width", "w_f", LENGTH, "face width",
        "width of the face outline, heel to toe, centred on the face centre")
        .read("mm", 1),
    entry("face_height", "h_f", LENGTH, "face height", "height of the face outline, centred on the face centre")
        .read("mm", 1),
    entry("characteristic_time", "t_CT", TIME, "characteristic time",
        "how long the face gives under the rules' pendulum; 0 is rigid").read("us", 0),
    entry("hand", "h", DIMENSIONLESS, "hand", "1 for a right-handed club, -1 for its mirror image")
        .digits(0).sides("left", "right").synonyms(&["handedness"]),
    entry("ball_mass", "m_b", MASS, "ball mass", "mass of the ball").digits(2),
    entry("ball_radius", "R", LENGTH, "ball radius", "radius of the ball").read("mm", 2),
    entry("ball_inertia", "I_b", INERTIA, "ball inertia", "moment of inertia of the ball about any diameter").digits(1),
    entry("included_time", "t_CT0", TIME, "included characteristic time",
        "characteristic time of the face that the parameters include").read("us", 0),
    // What shaft and hands add to the head.
    entry("added_mass_xx", "A_xx", MASS, "added mass xx",
        "mass that shaft and hands add to the head at its CG at static loft: force along x by acceleration along x"),
    entry("added_mass_yy", "A_yy", MASS, "added mass yy",
        "mass that shaft and hands add to the head at its CG at static loft: force along y by acceleration along y"),
    entry("added_mass_zz", "A_zz", MASS, "added mass zz",
        "mass that shaft and hands add to the head at its CG at static loft: force along z by acceleration along z"),
    entry("added_mass_xy", "A_xy", MASS, "added mass xy",
        "mass that shaft and hands add to the head at its CG at static loft: force along x by acceleration along y")
        .sign("element of the matrix"),
    entry("added_mass_xz", "A_xz", MASS, "added mass xz",
        "mass that shaft and hands add to the head at its CG at static loft: force along x by acceleration along z")
        .sign("element of the matrix"),
    entry("added_mass_yz", "A_yz", MASS, "added mass yz",
        "mass that shaft and hands add to the head at its CG at static loft: force along y by acceleration along z")
        .sign("element of the matrix"),
    entry("added_coupling_xx", "B_xx", MASS_MOMENT, "added coupling xx",
        "coupling that shaft and hands add to the head at its CG at static loft: force along x by angular acceleration about x")
        .sign("element of the matrix"),
    entry("added_coupling_xy", "B_xy", MASS_MOMENT, "added coupling xy",
        "coupling that shaft and hands add to the head at its CG at static loft: force along x by angular acceleration about y")
        .sign("element of the matrix"),
    entry("added_coupling_xz", "B_xz", MASS_MOMENT, "added coupling xz",
        "coupling that shaft and hands add to the head at its CG at static loft: force along x by angular acceleration about z")
        .sign("element of the matrix"),
    entry("added_coupling_yx", "B_yx", MASS_MOMENT, "added coupling yx",
        "coupling that shaft and hands add to the head at its CG at static loft: force along y by angular acceleration about x")
        .sign("element of the matrix"),
    entry("added_coupling_yy", "B_yy", MASS_MOMENT, "added coupling yy",
        "coupling that shaft and hands add to the head at its CG at static loft: force along y by angular acceleration about y")
        .sign("element of the matrix"),
    entry("added_coupling_yz", "B_yz", MASS_MOMENT, "added coupling yz",
        "coupling that shaft and hands add to the head at its CG at static loft: force along y by angular acceleration about z")
        .sign("element of the matrix"),
    entry("added_coupling_zx", "B_zx", MASS_MOMENT, "added coupling zx",
        "coupling that shaft and hands add to the head at its CG at static loft: force along z by angular acceleration about x")
        .sign("element of the matrix"),
    entry("added_coupling_zy", "B_zy", MASS_MOMENT, "added coupling zy",
        "coupling that shaft and hands add to the head at its CG at static loft: force along z by angular acceleration about y")
        .sign("element of the matrix"),
    entry("added_coupling_zz", "B_zz", MASS_MOMENT, "added coupling zz",
        "coupling that shaft and hands add to the head at its CG at static loft: force along z by angular acceleration about z")
        .sign("element of the matrix"),
    entry("added_inertia_xx", "D_xx", INERTIA, "added inertia xx",
        "inertia that shaft and hands add to the head at its CG at static loft: moment about x by angular acceleration about x"),
    entry("added_inertia_yy", "D_yy", INERTIA, "added inertia yy",
        "inertia that shaft and hands add to the head at its CG at static loft: moment about y by angular acceleration about y"),
    entry("added_inertia_zz", "D_zz", INERTIA, "added inertia zz",
        "inertia that shaft and hands add to the head at its CG at static loft: moment about z by angular acceleration about z"),
    entry("added_inertia_xy", "D_xy", INERTIA, "added inertia xy",
        "inertia that shaft and hands add to the head at its CG at static loft: moment about x by angular acceleration about y")
        .sign("element of the matrix"),
    entry("added_inertia_xz", "D_xz", INERTIA, "added inertia xz",
        "inertia that shaft and hands add to the head at its CG at static loft: moment about x by angular acceleration about z")
        .sign("element of the matrix"),
    entry("added_inertia_yz", "D_yz", INERTIA, "added inertia yz",
        "inertia that shaft and hands add to the head at its CG at static loft: moment about y by angular acceleration about z")
        .sign("element of the matrix"),
    // Parameters of models.
    entry("friction", "mu", DIMENSIONLESS, "friction", "coefficient of Coulomb friction between ball and face"),
    entry("cor", "e", DIMENSIONLESS, "coefficient of restitution", "coefficient of restitution"),
    entry("restitution", "e", DIMENSIONLESS, "restitution", "coefficient of restitution of ball and head"),
    entry("cor_slope", "e_v", INVERSE_SPEED, "slope of the restitution",
        "change of the restitution per normal approach speed").sign("growing with speed is positive"),
    entry("extra_mass", "m_a", MASS, "added mass", "mass added at the clubhead CG"),
    entry("dcg_x", "d_x", LENGTH, "shift of the ball CG outwards", "displacement of the ball CG along the face normal")
        .read("mm", 2).sign("outwards is positive"),
    entry("dcg_y", "d_y", LENGTH, "shift of the ball CG up", "displacement of the ball CG up the face")
        .read("mm", 2).sign("up is positive").sides("down", "up"),
    entry("dcg_z", "d_z", LENGTH, "shift of the ball CG towards the toe", "displacement of the ball CG along the face")
        .read("mm", 2).sign("towards the toe is positive").sides("heel", "toe"),
    entry("compression_factor", "f", DIMENSIONLESS, "compression factor",
        "share of the rolling velocity that is left when the ball's compression is considered"),
    entry("stiffness", "k_V", VOLUMETRIC_STIFFNESS, "volumetric stiffness", "stiffness per volume of penetration"),
    entry("damping", "d_V", INVERSE_SPEED, "damping", "Hunt-Crossley damping"),
    entry("layer_stiffness", "k_ball", ROTARY_STIFFNESS, "stiffness between layers",
        "rotary stiffness between cover and core"),
    entry("layer_damping", "c_ball", ROTARY_DAMPING, "damping between layers", "rotary damping between cover and core"),
    entry("cover_thickness", "t_cover", LENGTH, "cover thickness", "thickness of the cover").read("mm", 2),
    entry("transition_speed", "v_tr", SPEED, "transition speed",
        "sliding speed at which friction reaches its full size").read("m/s", 3),
    entry("shear_modulus", "G", PRESSURE, "shear modulus", "shear modulus").read("MPa", 2),
    entry("ring_modulus", "G_ring", PRESSURE, "ring modulus", "shear modulus of the tangential compliance of the rings")
        .read("MPa", 2),
    entry("bulk_modulus", "K", PRESSURE, "bulk modulus", "bulk modulus").read("MPa", 0),
    entry("youngs_modulus", "E", PRESSURE, "Young's modulus", "Young's modulus").read("GPa", 1),
    entry("poisson", "nu", DIMENSIONLESS, "Poisson's ratio", "Poisson's ratio"),
    entry("density", "rho", DENSITY, "density", "mass per volume"),
    entry("area_damping", "eta", AREA_DAMPING, "area damping", "damping per contact area"),
    entry("radius", "r", LENGTH, "radius", "radius").read("mm", 2),
    entry("mass", "m", MASS, "mass", "mass"),
    // Launch.
    entry("ball_speed", "v_b", SPEED, "ball speed", "speed of the ball")
        .synonyms(&["ball_velocity", "ballspeed", "initial_ball_speed", "launch_speed"]),
    entry("smash", "s", DIMENSIONLESS, "smash factor", "ball speed over clubhead speed")
        .synonyms(&["smash_factor", "efficiency", "smash_fac"]),
    entry("launch", "theta_l", ANGLE, "launch angle", "angle of the ball velocity above horizontal")
        .sign("up is positive").sides("down", "up")
        .synonyms(&["launch_angle", "vertical_launch_angle", "vertical_launch", "vla", "launch_ang", "launch_v",
            "launch_angle_v", "vert_launch", "vert_launch_angle", "launch_angle_vertical"]),
    entry("azimuth", "phi_l", ANGLE, "launch direction", "horizontal direction of the ball velocity")
        .sign("right of the target is positive").sides("left", "right")
        .synonyms(&["launch_direction", "horizontal_launch_angle", "horizontal_launch", "side_angle", "hla",
            "launch_dir", "launch_h", "launch_angle_h", "horiz_launch", "horiz_launch_angle",
            "launch_angle_horizontal", "push_pull", "launch_azimuth", "start_direction", "start_line"]),
    entry("backspin", "omega_b", ANGULAR_RATE, "backspin",
        "angular velocity about the horizontal axis right of the launch direction")
        .sign("lifting the ball is positive").sides("topspin", "backspin").synonyms(&["back_spin"]),
    entry("sidespin", "omega_s", ANGULAR_RATE, "sidespin", "minus the vertical angular velocity")
        .sign("curving right is positive").sides("left", "right").synonyms(&["side_spin"]),
    entry("total_spin", "omega", ANGULAR_RATE, "total spin", "magnitude of the angular velocity")
        .synonyms(&["spin_rate", "spin", "ball_spin", "total_spin_rate"]),
    entry("spin_axis", "beta", ANGLE, "spin axis", "tilt of the spin axis, atan2(sidespin, backspin)")
        .sign("tilted to the right is positive").sides("left", "right")
        .synonyms(&["spin_axis_tilt", "spin_tilt", "tilt_angle", "spin_tilt_axis", "spin_axis_angle", "axis_tilt",
            "tilt_axis"]),
    entry("velocity_x", "v_x", SPEED, "ball velocity to the target", "ball velocity along the target line")
        .sign("to the target is positive"),
    entry("velocity_y", "v_y", SPEED, "vertical ball velocity", "vertical ball velocity")
        .sign("up is positive").sides("down", "up"),
    entry("velocity_z", "v_z", SPEED, "ball velocity to the right", "ball velocity across the target line")
        .sign("right is positive").sides("left", "right"),
    entry("spin_x", "omega_x", ANGULAR_RATE, "ball spin about x", "ball angular velocity about the target line")
        .sign("right-handed is positive"),
    entry("spin_y", "omega_y", ANGULAR_RATE, "ball spin about y",
        "ball angular velocity about the vertical: minus sidespin").sign("curving left is positive")
        .sides("right", "left"),
    entry("spin_z", "omega_z", ANGULAR_RATE, "ball spin about z",
        "ball angular velocity about the horizontal to the right")
        .sign("backspin of a ball flying to the target is positive"),
    entry("club_velocity_x", "V_x", SPEED, "club velocity to the target",
        "clubhead velocity to the target after impact")
        .sign("to the target is positive"),
    entry("club_velocity_y", "V_y", SPEED, "vertical club velocity", "vertical clubhead velocity after impact")
        .sign("up is positive").sides("down", "up"),
    entry("club_velocity_z", "V_z", SPEED, "club velocity to the right",
        "clubhead velocity across the target line after impact").sign("right is positive").sides("left", "right"),
    entry("club_spin_x", "Omega_x", ANGULAR_RATE, "club spin about x", "clubhead angular velocity about x after impact")
        .sign("right-handed is positive"),
    entry("club_spin_y", "Omega_y", ANGULAR_RATE, "club spin about y", "clubhead angular velocity about y after impact")
        .sign("right-handed is positive"),
    entry("club_spin_z", "Omega_z", ANGULAR_RATE, "club spin about z", "clubhead angular velocity about z after impact")
        .sign("right-handed is positive"),
    entry("contact_time", "t_c", TIME, "contact time", "time from first touch to separation").read("us", 0),
    entry("peak_force", "F_max", FORCE, "peak force", "largest normal force").read("kN", 1),
    // Air, ground and flight.
    entry("temperature", "T", TEMPERATURE, "air temperature",
        "air temperature (default: that of normalised carries, 77 F)")
        .for_golfers("degF", 0),
    entry("pressure", "p", PRESSURE, "air pressure", "air pressure at the course (default: standard sea level)"),
    entry("humidity", "h_r", DIMENSIONLESS, "humidity", "relative humidity over liquid water, 0 to 1").read("%", 0),
    entry("altitude", "z", LENGTH, "altitude", "height of the course above sea level")
        .digits(0)
        .for_golfers("ft", 0),
    entry("air_density", "rho", DENSITY, "air density", "density of moist air by temperature, pressure and humidity")
        .digits(3),
    entry("wind_speed", "w", SPEED, "wind speed", "speed of a level wind, the same at all heights"),
    entry("wind_from", "psi_w", ANGLE, "wind from",
        "direction from which a level wind comes: 0 from the target, a headwind; 180 deg a tailwind")
        .sign("from the right of the target line is positive").sides("left", "right").digits(0),
    entry("wind_x", "w_x", SPEED, "tailwind", "wind velocity along the target line, the same at all heights")
        .sign("tailwind is positive").sides("headwind", "tailwind"),
    entry("wind_y", "w_y", SPEED, "vertical wind", "vertical wind velocity")
        .sign("rising is positive").sides("sinking", "rising"),
    entry("wind_z", "w_z", SPEED, "crosswind", "wind velocity across the target line")
        .sign("blowing to the right is positive").sides("left", "right"),
    entry("restitution_factor", "k_e", DIMENSIONLESS, "firmness of the turf",
        "factor on Penner's coefficient of restitution of ball and turf").sign("firmer is greater").digits(2),
    entry("ground_tilt", "theta_g", ANGLE, "tilt of the bounce",
        "tilt of the effective plane of a bounce at 18.6 m/s, 44.4 deg (Penner, on greens: 15.4 deg)")
        .sign("softer is greater"),
    entry("ground_friction", "mu_g", DIMENSIONLESS, "friction of the turf",
        "sliding friction of ball and turf (Penner: 0.40)").digits(2),
    entry("rolling_friction", "rho_g", DIMENSIONLESS, "rolling friction",
        "rolling friction of a fairway, assumed that of Penner's average green, 6 ft off a Stimpmeter"),
    entry("grass_length", "l_g", LENGTH, "braking length of the grass",
        "way over which grass alone slows a rolling ball to 1/e of its speed"),
    entry("carry", "x_c", LENGTH, "carry",
        "straight level distance from the start to where the ball comes down to its height")
        .in_yards()
        .synonyms(&["carry_distance", "carry_dist", "carry_length", "carry_flat", "carry_flat_length", "flat_carry"]),
    entry("side", "z_c", LENGTH, "side", "distance of the landing from the target line")
        .in_yards().sign("right is positive").sides("left", "right")
        .synonyms(&["carry_side", "side_carry", "offline", "lateral", "lateral_distance", "side_distance",
            "carry_offline", "carry_deviation", "carry_deviation_distance"]),
    entry("apex", "y_max", LENGTH, "apex", "greatest height above the start").in_yards().sign("up is positive")
        .synonyms(&["peak_height", "max_height", "apex_height", "height", "maximum_height", "peak_ht", "max_ht"]),
    entry("landing_angle", "theta_d", ANGLE, "landing angle", "angle of descent below the horizontal at landing")
        .sign("down is positive")
        .synonyms(&["landing", "descent_angle", "desc_angle", "land_angle", "angle_of_descent", "descent",
            "descent_v", "descentv"]),
    entry("flight_time", "t_f", TIME, "flight time", "time from launch to landing")
        .synonyms(&["hang_time", "time_of_flight", "air_time", "hangtime"]),
    entry("landing_speed", "v_d", SPEED, "landing speed", "speed at landing, relative to the ground"),
    entry("landing_spin", "omega_d", ANGULAR_RATE, "landing spin", "magnitude of the angular velocity at landing"),
    entry("total", "x_t", LENGTH, "total",
        "straight distance from the start to rest, after bounces and roll").in_yards()
        .synonyms(&["total_distance", "total_dist", "total_length"]),
    entry("total_side", "z_t", LENGTH, "total side", "distance of the place of rest from the target line")
        .in_yards().sign("right is positive").sides("left", "right")
        .synonyms(&["side_total", "total_offline", "total_deviation", "total_deviation_distance"]),
    entry("curve", "z_k", LENGTH, "curve",
        "distance of the landing from the line on which the ball starts, across that line")
        .in_yards().sign("right is positive").sides("left", "right"),
    entry("outside_fit", "", DIMENSIONLESS, "outside the fit",
        "1 if the spin parameter left 0.02-1, the range of the aerodynamic fit, else 0").digits(0),
    // Histories of contacts and flights.
    entry("time", "t", TIME, "time", "time since first touch, or since launch").digits(6),
    entry("position", "x", LENGTH, "position", "position from the start: to the target, up, to the right").in_yards(),
    entry("velocity", "v", SPEED, "velocity", "velocity"),
    entry("spin", "omega", ANGULAR_RATE, "spin", "angular velocity"),
    entry("normal_force", "F_n", FORCE, "normal force", "force on the ball along the face normal").read("kN", 2),
    entry("force_y", "F_y", FORCE, "friction up the face", "friction on the ball up the face")
        .read("kN", 2).sign("up is positive").sides("down", "up"),
    entry("force_z", "F_z", FORCE, "friction towards the toe", "friction on the ball along the face")
        .read("kN", 2).sign("towards the toe is positive").sides("heel", "toe"),
    entry("penetration", "delta", LENGTH, "compression of the ball",
        "how far the ball is compressed along the face normal")
        .read("mm", 2),
    entry("face_depth", "delta_f", LENGTH, "depth of the face", "how far the face has moved inwards").read("mm", 3),
    entry("sliding_y", "u_y", SPEED, "sliding up the face", "sliding velocity of the ball's surface up the face")
        .read("m/s", 2).sign("up is positive").sides("down", "up"),
    entry("sliding_z", "u_z", SPEED, "sliding towards the toe", "sliding velocity of the ball's surface along the face")
        .read("m/s", 2).sign("towards the toe is positive").sides("heel", "toe"),
    entry("contact_area", "A", AREA, "contact area", "area of the ball in contact with the face").read("mm2", 0),
    entry("kinetic_energy", "E_k", ENERGY, "kinetic energy", "kinetic energy of ball and clubhead"),
    entry("face_energy", "E_f", ENERGY, "energy of the face", "energy stored in the face"),
    entry("layer_energy", "E_l", ENERGY, "energy of the layers", "energy stored between the layers of the ball"),
    entry("normal_work", "W_n", ENERGY, "work of the normal force", "work done against the normal force"),
    entry("friction_work", "W_t", ENERGY, "work of friction", "work turned into heat by friction"),
    entry("layer_work", "W_l", ENERGY, "work of the layers", "work turned into heat between the layers of the ball"),
    entry("ball_position", "x_b", LENGTH, "position of the ball", "position of the ball's centre").read("mm", 2),
    entry("ball_velocity", "v_b", SPEED, "velocity of the ball", "velocity of the ball's centre"),
    entry("ball_spin", "omega_b", ANGULAR_RATE, "spin of the ball", "angular velocity of the ball"),
    entry("cover_spin", "omega_cover", ANGULAR_RATE, "spin of the cover", "angular velocity of the ball's cover"),
    entry("core_spin", "omega_core", ANGULAR_RATE, "spin of the core", "angular velocity of the ball's core"),
    entry("club_position", "x_c", LENGTH, "position of the clubhead", "position of the clubhead CG").read("mm", 2),
    entry("club_velocity", "v_c", SPEED, "velocity of the clubhead", "velocity of the clubhead CG"),
    entry("club_spin", "omega_c", ANGULAR_RATE, "spin of the clubhead", "angular velocity of the clubhead"),
    entry("club_attitude", "q_c", DIMENSIONLESS, "attitude of the clubhead",
        "turn of the clubhead since first touch, in face axes: quaternion w, x, y, z"),
    entry("ring_radius", "r_i", LENGTH, "radius of a ring", "mid-radius of a ring of the contact").read("mm", 2),
    entry("ring_traction_y", "tau_y", PRESSURE, "traction of a ring up the face",
        "friction per area on a ring, up the face")
        .read("MPa", 2).sign("up is positive").sides("down", "up"),
    entry("ring_traction_z", "tau_z", PRESSURE, "traction of a ring towards the toe",
        "friction per area on a ring, along the face").read("MPa", 2).sign("towards the toe is positive")
        .sides("heel", "toe"),
    entry("ring_slip", "", DIMENSIONLESS, "slip of a ring", "1 where a ring slips, 0 where it sticks").digits(0),
    entry("ring_inside", "", DIMENSIONLESS, "ring in contact", "1 where a ring is in contact, else 0").digits(0),
    // Finite elements.
    entry("peak_force_time", "t_F", TIME, "time of the peak force", "time at which the normal force is largest")
        .read("us", 0),
    entry("tangential_max", "F_t,max", FORCE, "largest tangential force", "largest force along the face")
        .read("kN", 2).sign("making backspin is positive"),
    entry("tangential_min", "F_t,min", FORCE, "smallest tangential force", "smallest force along the face")
        .read("kN", 2).sign("making backspin is positive"),
    entry("reversal_time", "t_r", TIME, "reversal of the tangential force",
        "time at which the force along the face turns from making spin to taking it").read("us", 0),
    entry("spin_max", "omega_max", ANGULAR_RATE, "largest backspin", "largest backspin during the impact"),
    entry("contraction", "c", DIMENSIONLESS, "contraction",
        "greatest loss of the distance from mass centre to face, over the radius of the ball"),
    entry("contraction_time", "t_con", TIME, "time of the contraction", "time at which the contraction is greatest")
        .read("us", 0),
    entry("f_prime", "f'", DIMENSIONLESS, "compression factor f'", "compression factor of Roh and Lee, equation 9"),
    entry("f", "f", DIMENSIONLESS, "compression factor f", "compression factor of Roh and Lee, equation 11"),
    entry("energy_error", "", DIMENSIONLESS, "energy balance error",
        "largest error of the energy balance over the initial kinetic energy").read("%", 2),
    entry("steps", "n", DIMENSIONLESS, "steps", "number of time steps").digits(0),
    entry("step", "dt", TIME, "time step", "length of a time step").read("us", 4),
    entry("wall", "", TIME, "computing time", "time that the computation took"),
    entry("normal_velocity", "v_n", SPEED, "normal velocity", "ball velocity along the face normal of first touch")
        .read("m/s", 2).sign("away from the face is positive"),
    entry("tangential_velocity", "v_t", SPEED, "tangential velocity", "ball velocity up the face of first touch")
        .read("m/s", 2).sign("up is positive").sides("down", "up"),
    entry("normal", "F_n", FORCE, "normal force", "force on the ball along the face normal").read("kN", 2),
    entry("tangential", "F_t", FORCE, "tangential force", "force on the ball down the face")
        .read("kN", 2).sign("making backspin is positive"),
    entry("toe_force", "F_z", FORCE, "force towards the toe", "force on the ball along the face")
        .read("kN", 2).sign("towards the toe is positive").sides("heel", "toe"),
    entry("area", "A", AREA, "area", "area").read("mm2", 0),
    entry("kinetic", "E_k", ENERGY, "kinetic energy", "kinetic energy of nodes and rigid head"),
    entry("strain_energy", "E_s", ENERGY, "strain energy", "elastic energy of the elements"),
    entry("hourglass", "E_h", ENERGY, "hourglass energy", "energy of the hourglass modes of one-point elements"),
    entry("viscous", "E_v", ENERGY, "viscous energy",
        "energy stored in viscoelastic branches or turned into heat there"),
    entry("plastic", "E_p", ENERGY, "plastic work", "energy turned into heat by plastic flow"),
    entry("contact", "E_c", ENERGY, "contact energy", "energy stored in the contact"),
    entry("friction_energy", "E_f", ENERGY, "friction", "energy turned into heat by friction"),
    entry("damping_energy", "E_d", ENERGY, "contact damping",
        "energy turned into heat by the damping of nodes that arrive at the face"),
    entry("stress", "sigma", PRESSURE, "stress", "Cauchy stress").read("MPa", 1),
    entry("strain", "epsilon", DIMENSIONLESS, "strain", "logarithmic strain").digits(4),
    entry("plastic_strain", "epsilon_p", DIMENSIONLESS, "plastic strain", "equivalent plastic strain").digits(4),
    entry("margin", "", DIMENSIONLESS, "margin to yield",
        "least share by which the stress of a part may grow before it yields").read("%", 0),
    // Faces.
    entry("face_area", "A_f", AREA, "face area", "area of the face").read("mm2", 0),
    entry("sweet_spot_toe", "z_s", LENGTH, "sweet spot towards the toe", "where on the face the ball speed is greatest")
        .read("mm", 1).sign("towards the toe is positive").sides("heel", "toe"),
    entry("sweet_spot_high", "y_s", LENGTH, "sweet spot height", "where up the face the ball speed is greatest")
        .read("mm", 1).sign("above the face centre is positive").sides("low", "high"),
    entry("best_ball_speed", "v_b,max", SPEED, "best ball speed", "greatest ball speed over the face"),
    entry("longest_toe", "z_l", LENGTH, "longest carry towards the toe", "where on the face the carry is greatest")
        .read("mm", 1).sign("towards the toe is positive").sides("heel", "toe"),
    entry("longest_high", "y_l", LENGTH, "height of the longest carry", "where up the face the carry is greatest")
        .read("mm", 1).sign("above the face centre is positive").sides("low", "high"),
    entry("longest_carry", "x_l", LENGTH, "longest carry", "greatest carry over the face").in_yards(),
    entry("cg_above", "", LENGTH, "CG above face normal",
        "distance of the CG above the face normal through the face centre").read("mm", 2),
    entry("forward", "", LENGTH, "forward", "distance towards the target").read("mm", 1),
    // How a ball rebounds from a plane.
    entry("incidence", "", ANGLE, "angle from normal",
        "between the path of the ball, as the face sees it, and the face normal").read("deg", 0),
    entry("tangential_restitution", "", DIMENSIONLESS, "tangential restitution",
        "of the ball's surface where it touches: 0 rolls, -1 slides without friction"),
    entry("friction_lever", "", DIMENSIONLESS, "lever of friction",
        "angular momentum over that which the change along the face has at one radius"),
    // Motion capture.
    entry("marker_displacement", "", LENGTH, "marker displacement",
        "how far a marker sits from its place on the head").read("mm", 1),
];
