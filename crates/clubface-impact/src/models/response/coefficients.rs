//! The model's parameters, with the values for the ball `modern` that `make response-fit` finds.

use crate::response_functions;

/// Where the values come from.
const FITTED: &str = "fitted to strikes by the finite element ball modern: studies/response/modern.toml";

response_functions! {
    /// The model and its parameters: of the contact, then the coefficients of the terms of each response function.
    Response {
        friction ["1"] = 0.35 in 0.0 ..= 2.0,
            "coefficient of Coulomb friction between ball and face",
            "the middle of 0.3 to 0.4, as measured between covers and clubfaces";
        time ["s"] = 0.000488488 in 1e-05 ..= 0.005,
            "contact time at 40 m/s against a plate",
            FITTED;
        time_speed ["1"] = -0.217831 in -2.0 ..= 2.0,
            "power of the contact time in the normal approach speed",
            FITTED;
        time_mobility ["1"] = 0.291971 in -2.0 ..= 2.0,
            "power of the contact time in the mass of ball and head together over that of the ball",
            FITTED;
        time_face ["1"] = 0.0578417 in -2.0 ..= 2.0,
            "growth of the contact time with the compliance of the face",
            FITTED;
        half_slip ["1"] = 0.513364 in 0.01 ..= 20.0,
            "need of friction over its limit at which the slip feature is a half",
            FITTED;
        sharpness ["1"] = 13.0976 in 1.0 ..= 100.0,
            "how suddenly sliding throughout sets in",
            FITTED;
        middle_turn ["1"] = 0.488268 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of the impulse",
            FITTED;
        middle_turned ["1"] = 0.11213 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        middle_shift ["1"] = 0.425642 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        middle_pushed ["1"] = 0.187347 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        end_turn ["1"] = 0.398876 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of separation",
            FITTED;
        end_turned ["1"] = 0.0624895 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        end_shift ["1"] = 0.625668 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        end_pushed ["1"] = 0.335259 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        twist_before ["1"] = 1.03389 in -5.0 ..= 5.0,
            "weight of the head's spin before impact over that of its change, in the ball's spin about the normal",
            FITTED;
        twist_spin ["1"] = 2.49753 in -5.0 ..= 5.0,
            "the same for the ball's spin before impact",
            FITTED;
        rolling_gained ["1"] = 1.0771 in -5.0 ..= 5.0,
            "weight of the change of the spins over that of the spins before impact, in the rolling of the ball",
            FITTED;
        twist_arm ["1"] = 0.270366 in 0.0 ..= 1.0,
            "arm of friction against twisting over the radius of the ball",
            FITTED;
    }
    restitution (
        "term of the normal restitution",
        FITTED
    ) {
        restitution_middle = 0.822508;
        restitution_speed = -0.078601 * speed;
        restitution_friction = 0.0101362 * friction;
        restitution_mobility = 0.0113029 * mobility;
        restitution_ratio = -0.00813644 * ratio;
        restitution_coupling = 0.0433378 * coupling;
        restitution_face = 0.0334212 * face;
        restitution_speed_friction = 0.00623162 * speed * friction;
        restitution_speed_mobility = 0.0100739 * speed * mobility;
        restitution_speed_face = 0.0470355 * speed * face;
        restitution_slip2 = -0.0295429 * slip * slip;
        restitution_coupling2 = 0.0496198 * coupling * coupling;
        restitution_face2 = -0.00463411 * face * face;
        restitution_speed3 = -0.0170045 * speed * speed * speed;
        restitution_speed2_coupling = 0.112436 * speed * speed * coupling;
        restitution_speed2_face = 0.00762731 * speed * speed * face;
        restitution_speed_slip2 = -0.0406226 * speed * slip * slip;
        restitution_speed_slip_coupling = 0.281114 * speed * slip * coupling;
        restitution_friction_slip2 = -0.0444677 * friction * slip * slip;
        restitution_slip3 = -0.0243152 * slip * slip * slip;
        restitution_slip2_coupling = 0.124024 * slip * slip * coupling;
        restitution_slip_coupling_face = -0.0740516 * slip * coupling * face;
        restitution_bend = 0.107825 * bend;
        restitution_speed_face2 = -0.00784341 * speed * face * face;
        restitution_speed2_mobility = 0.0255744 * speed * speed * mobility;
        restitution_speed2_slip = 0.0217169 * speed * speed * slip;
    }
    tangential (
        "term of the tangential restitution",
        FITTED
    ) {
        tangential_middle = 0.298778;
        tangential_slip = 0.198799 * slip;
        tangential_coupling = -0.396359 * coupling;
        tangential_face = -0.0308081 * face;
        tangential_speed_slip = -0.254712 * speed * slip;
        tangential_friction_slip = 0.208407 * friction * slip;
        tangential_slip2 = -1.42449 * slip * slip;
        tangential_slip_coupling = 2.53908 * slip * coupling;
        tangential_slip_face = 0.14365 * slip * face;
        tangential_mobility2 = -0.0101227 * mobility * mobility;
        tangential_ratio2 = 0.0169352 * ratio * ratio;
        tangential_coupling2 = -0.386287 * coupling * coupling;
        tangential_coupling_face = -0.0484915 * coupling * face;
        tangential_speed2_slip = 0.0776227 * speed * speed * slip;
        tangential_speed_friction2 = -0.0576996 * speed * friction * friction;
        tangential_speed_slip2 = 0.157297 * speed * slip * slip;
        tangential_speed_slip_coupling = -0.0768683 * speed * slip * coupling;
        tangential_speed_slip_face = 0.0666079 * speed * slip * face;
        tangential_friction3 = -0.0408597 * friction * friction * friction;
        tangential_friction2_slip = -0.29475 * friction * friction * slip;
        tangential_friction_slip2 = -0.129225 * friction * slip * slip;
        tangential_friction_slip_coupling = -1.75089 * friction * slip * coupling;
        tangential_friction_ratio_coupling = 0.0861568 * friction * ratio * coupling;
        tangential_friction_coupling2 = 0.415772 * friction * coupling * coupling;
        tangential_slip3 = -1.1439 * slip * slip * slip;
        tangential_slip2_ratio = -0.416213 * slip * slip * ratio;
        tangential_slip2_coupling = -1.05553 * slip * slip * coupling;
        tangential_slip_ratio2 = -0.342063 * slip * ratio * ratio;
        tangential_slip_coupling2 = 1.11334 * slip * coupling * coupling;
        tangential_slip_coupling_face = 0.0172851 * slip * coupling * face;
        tangential_ratio_coupling2 = 0.19892 * ratio * coupling * coupling;
        tangential_slip_offset = 0.427411 * slip * offset;
        tangential_offset = -0.0633107 * offset;
        tangential_mobility_face = -0.0142481 * mobility * face;
        tangential_friction_coupling = 0.2145 * friction * coupling;
        tangential_friction_slip_offset = -0.440171 * friction * slip * offset;
        tangential_slip2_offset = -0.245687 * slip * slip * offset;
        tangential_speed_mobility_face = -0.0237399 * speed * mobility * face;
        tangential_slip_mobility_ratio = 0.411941 * slip * mobility * ratio;
        tangential_slip_ratio_coupling = -0.556471 * slip * ratio * coupling;
    }
    tangential_mobility (
        "term of the tangential restitution times the mobility along the face",
        FITTED
    ) {
        tangential_mobility_middle = -0.0840099;
        tangential_mobility_speed = 0.0401163 * speed;
        tangential_mobility_slip = 0.350869 * slip;
        tangential_mobility_slip2 = 0.646285 * slip * slip;
        tangential_mobility_speed2_slip = -0.335797 * speed * speed * slip;
        tangential_mobility_slip2_mobility = 0.472502 * slip * slip * mobility;
    }
    drive (
        "term of how far the normal impulse drives the contact along the face",
        FITTED
    ) {
        drive_middle = -0.167589;
        drive_speed = -0.0415222 * speed;
        drive_face = -0.032358 * face;
        drive_speed_friction = 0.0837581 * speed * friction;
        drive_speed_slip = 0.0927535 * speed * slip;
        drive_friction2 = 0.135132 * friction * friction;
        drive_friction_mobility = 0.09244 * friction * mobility;
        drive_slip2 = 1.04406 * slip * slip;
        drive_speed_slip2 = 0.314297 * speed * slip * slip;
        drive_speed_coupling2 = -0.260971 * speed * coupling * coupling;
        drive_friction3 = -0.12615 * friction * friction * friction;
        drive_friction2_mobility = -0.146997 * friction * friction * mobility;
        drive_slip3 = 2.76271 * slip * slip * slip;
        drive_mobility2_coupling = -0.153957 * mobility * mobility * coupling;
        drive_slip2_coupling = -1.53169 * slip * slip * coupling;
        drive_friction_slip2 = -0.338922 * friction * slip * slip;
    }
    swerve (
        "term of how far a ball that turns about the normal pushes across its sliding",
        FITTED
    ) {
        swerve_middle = -0.185486;
        swerve_slip = 0.581244 * slip;
        swerve_speed2 = 0.214219 * speed * speed;
        swerve_speed_slip = 0.660862 * speed * slip;
        swerve_coupling = -0.291796 * coupling;
    }
    lever (
        "term of the lever of friction over the radius",
        FITTED
    ) {
        lever_middle = 0.955222;
        lever_slip = -0.0249974 * slip;
        lever_speed_slip = -0.0504325 * speed * slip;
        lever_mobility3 = -0.0101048 * mobility * mobility * mobility;
        lever_slip_coupling = -0.0951739 * slip * coupling;
        lever_friction_slip2 = 0.148954 * friction * slip * slip;
        lever_slip2 = 0.094575 * slip * slip;
        lever_slip_bend = -0.0701698 * slip * bend;
        lever_speed3 = -0.0156633 * speed * speed * speed;
    }
    rolling (
        "term of the couple by which the pressure brakes the rolling of the ball, over its spin",
        FITTED
    ) {
        rolling_middle = 0.0429591;
        rolling_speed = 0.0772097 * speed;
        rolling_slip2 = 0.0916168 * slip * slip;
        rolling_friction_slip2 = 0.106441 * friction * slip * slip;
        rolling_friction2_mobility = 0.0191836 * friction * friction * mobility;
    }
    torsion (
        "term of the ball's spin about the normal over the face's",
        FITTED
    ) {
        torsion_middle = 0.146136;
        torsion_slip = -0.418419 * slip;
        torsion_speed_slip = -0.437716 * speed * slip;
        torsion_speed3 = -0.103471 * speed * speed * speed;
        torsion_speed = 0.147694 * speed;
        torsion_slip2 = 0.167862 * slip * slip;
        torsion_coupling = 0.246083 * coupling;
        torsion_slip_coupling = -0.752189 * slip * coupling;
        torsion_speed2 = -0.108208 * speed * speed;
        torsion_speed_coupling = 0.325348 * speed * coupling;
        torsion_speed_slip_coupling = -1.15383 * speed * slip * coupling;
    }
    peak (
        "term of the largest normal force over the mean one",
        FITTED
    ) {
        peak_middle = 1.78873;
        peak_speed = -0.0566084 * speed;
        peak_coupling = -0.310761 * coupling;
        peak_ratio_coupling = 0.36269 * ratio * coupling;
        peak_speed2_face = 0.0731251 * speed * speed * face;
        peak_mobility2_coupling = 0.406627 * mobility * mobility * coupling;
        peak_speed3 = 0.122274 * speed * speed * speed;
    }
}
