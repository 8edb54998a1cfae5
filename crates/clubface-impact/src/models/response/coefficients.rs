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
        time ["s"] = 0.000478318 in 1e-05 ..= 0.005,
            "contact time at 40 m/s against a plate",
            FITTED;
        time_speed ["1"] = -0.221122 in -2.0 ..= 2.0,
            "power of the contact time in the normal approach speed",
            FITTED;
        time_mobility ["1"] = 0.29603 in -2.0 ..= 2.0,
            "power of the contact time in the mass of ball and head together over that of the ball",
            FITTED;
        time_face ["1"] = 0.0599917 in -2.0 ..= 2.0,
            "growth of the contact time with the compliance of the face",
            FITTED;
        half_slip ["1"] = 0.48122 in 0.01 ..= 20.0,
            "need of friction over its limit at which the slip feature is a half",
            FITTED;
        sharpness ["1"] = 13.8556 in 1.0 ..= 100.0,
            "how suddenly sliding throughout sets in",
            FITTED;
        middle_turn ["1"] = 0.492367 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of the impulse",
            FITTED;
        middle_turned ["1"] = 0.111622 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        middle_shift ["1"] = 0.440878 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        middle_pushed ["1"] = 0.262554 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        end_turn ["1"] = 0.352129 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of separation",
            FITTED;
        end_turned ["1"] = 0.0584471 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        end_shift ["1"] = 0.609269 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        end_pushed ["1"] = 0.280327 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        twist_before ["1"] = 0.88665 in -5.0 ..= 5.0,
            "weight of the head's spin before impact beside its change, in the ball's spin about the normal",
            FITTED;
        twist_spin ["1"] = 2.67314 in -5.0 ..= 5.0,
            "the same for the ball's spin before impact",
            FITTED;
        rolling_gained ["1"] = 1.06093 in -5.0 ..= 5.0,
            "weight of the change of the spins beside the spins before impact, in the rolling of the ball",
            FITTED;
        twist_arm ["1"] = 0.254546 in 0.0 ..= 1.0,
            "arm of friction against twisting over the radius of the ball",
            FITTED;
    }
    restitution (
        "term of the normal restitution",
        FITTED
    ) {
        restitution_middle = 0.822102;
        restitution_speed = -0.0747627 * speed;
        restitution_friction = 0.0128728 * friction;
        restitution_mobility = 0.00993148 * mobility;
        restitution_ratio = -0.00825691 * ratio;
        restitution_coupling = 0.0461298 * coupling;
        restitution_face = 0.0336467 * face;
        restitution_speed_friction = 0.00705296 * speed * friction;
        restitution_speed_mobility = 0.0109791 * speed * mobility;
        restitution_speed_face = 0.0491016 * speed * face;
        restitution_slip2 = -0.0308827 * slip * slip;
        restitution_coupling2 = 0.0508181 * coupling * coupling;
        restitution_face2 = -0.00521468 * face * face;
        restitution_speed3 = -0.0229931 * speed * speed * speed;
        restitution_speed2_coupling = 0.107384 * speed * speed * coupling;
        restitution_speed2_face = 0.0122986 * speed * speed * face;
        restitution_speed_slip2 = -0.0466305 * speed * slip * slip;
        restitution_speed_slip_coupling = 0.275371 * speed * slip * coupling;
        restitution_friction_slip2 = -0.0520027 * friction * slip * slip;
        restitution_slip3 = -0.0284636 * slip * slip * slip;
        restitution_slip2_coupling = 0.109421 * slip * slip * coupling;
        restitution_slip_coupling_face = -0.0729615 * slip * coupling * face;
        restitution_bend = 0.110869 * bend;
        restitution_speed_face2 = -0.00937111 * speed * face * face;
        restitution_speed2_mobility = 0.0277098 * speed * speed * mobility;
        restitution_speed2_slip = 0.0224539 * speed * speed * slip;
    }
    tangential (
        "term of the tangential restitution",
        FITTED
    ) {
        tangential_middle = 0.383742;
        tangential_slip = -0.0996685 * slip;
        tangential_coupling = -0.347555 * coupling;
        tangential_face = -0.0465461 * face;
        tangential_speed_slip = -0.332115 * speed * slip;
        tangential_friction_slip = 0.185863 * friction * slip;
        tangential_slip2 = -1.32484 * slip * slip;
        tangential_slip_coupling = 2.6929 * slip * coupling;
        tangential_slip_face = 0.236826 * slip * face;
        tangential_mobility2 = -0.0122045 * mobility * mobility;
        tangential_ratio2 = 0.020281 * ratio * ratio;
        tangential_coupling2 = -0.532531 * coupling * coupling;
        tangential_coupling_face = -0.0879292 * coupling * face;
        tangential_speed2_slip = 0.191882 * speed * speed * slip;
        tangential_speed_friction2 = -0.0562768 * speed * friction * friction;
        tangential_speed_slip2 = 0.415868 * speed * slip * slip;
        tangential_speed_slip_coupling = -0.386611 * speed * slip * coupling;
        tangential_speed_slip_face = 0.104501 * speed * slip * face;
        tangential_friction3 = -0.0342328 * friction * friction * friction;
        tangential_friction2_slip = -0.257261 * friction * friction * slip;
        tangential_friction_slip2 = -0.231815 * friction * slip * slip;
        tangential_friction_slip_coupling = -1.80002 * friction * slip * coupling;
        tangential_friction_ratio_coupling = 0.116783 * friction * ratio * coupling;
        tangential_friction_coupling2 = 0.453536 * friction * coupling * coupling;
        tangential_slip3 = -0.33889 * slip * slip * slip;
        tangential_slip2_ratio = -0.545124 * slip * slip * ratio;
        tangential_slip2_coupling = -2.73201 * slip * slip * coupling;
        tangential_slip_ratio2 = -0.289133 * slip * ratio * ratio;
        tangential_slip_coupling2 = 1.4329 * slip * coupling * coupling;
        tangential_slip_coupling_face = 0.174867 * slip * coupling * face;
        tangential_ratio_coupling2 = 0.330726 * ratio * coupling * coupling;
        tangential_slip_offset = 0.442559 * slip * offset;
        tangential_offset = -0.0454712 * offset;
        tangential_mobility_face = -0.0279228 * mobility * face;
        tangential_friction_coupling = 0.17484 * friction * coupling;
        tangential_friction_slip_offset = -0.501921 * friction * slip * offset;
        tangential_slip2_offset = -0.850729 * slip * slip * offset;
        tangential_speed_mobility_face = -0.058273 * speed * mobility * face;
        tangential_slip_mobility_ratio = 0.402351 * slip * mobility * ratio;
        tangential_slip_ratio_coupling = -0.512644 * slip * ratio * coupling;
    }
    tangential_mobility (
        "term of the tangential restitution times the mobility along the face",
        FITTED
    ) {
        tangential_mobility_middle = -0.0933655;
        tangential_mobility_speed = 0.074115 * speed;
        tangential_mobility_slip = 0.385701 * slip;
        tangential_mobility_slip2 = 0.495047 * slip * slip;
        tangential_mobility_speed2_slip = -0.232635 * speed * speed * slip;
        tangential_mobility_slip2_mobility = 0.336116 * slip * slip * mobility;
    }
    drive (
        "term of how far the normal impulse drives the contact along the face",
        FITTED
    ) {
        drive_middle = -0.157245;
        drive_speed = -0.0262481 * speed;
        drive_face = -0.0237386 * face;
        drive_speed_friction = 0.101314 * speed * friction;
        drive_speed_slip = 0.11979 * speed * slip;
        drive_friction2 = 0.10554 * friction * friction;
        drive_friction_mobility = 0.105148 * friction * mobility;
        drive_slip2 = 0.855898 * slip * slip;
        drive_speed_slip2 = 0.278142 * speed * slip * slip;
        drive_speed_coupling2 = -0.45892 * speed * coupling * coupling;
        drive_friction3 = -0.0732706 * friction * friction * friction;
        drive_friction2_mobility = -0.146288 * friction * friction * mobility;
        drive_slip3 = 2.35632 * slip * slip * slip;
        drive_mobility2_coupling = -0.188456 * mobility * mobility * coupling;
        drive_slip2_coupling = -1.4507 * slip * slip * coupling;
        drive_friction_slip2 = -0.637901 * friction * slip * slip;
    }
    swerve (
        "term of how far a ball that turns about the normal pushes across its sliding",
        FITTED
    ) {
        swerve_middle = -0.213677;
        swerve_slip = 0.615245 * slip;
        swerve_speed2 = 0.279033 * speed * speed;
        swerve_speed_slip = 0.701452 * speed * slip;
        swerve_coupling = -0.306518 * coupling;
    }
    lever (
        "term of the lever of friction over the radius",
        FITTED
    ) {
        lever_middle = 0.958222;
        lever_slip = -0.0300408 * slip;
        lever_speed_slip = -0.0503247 * speed * slip;
        lever_mobility3 = -0.00923508 * mobility * mobility * mobility;
        lever_slip_coupling = -0.0907387 * slip * coupling;
        lever_friction_slip2 = 0.123787 * friction * slip * slip;
        lever_slip2 = 0.0782185 * slip * slip;
        lever_slip_bend = -0.0805147 * slip * bend;
        lever_speed3 = -0.0395887 * speed * speed * speed;
    }
    rolling (
        "term of the couple by which the pressure brakes the rolling of the ball, over its spin",
        FITTED
    ) {
        rolling_middle = 0.0425816;
        rolling_speed = 0.073199 * speed;
        rolling_slip2 = 0.0929551 * slip * slip;
        rolling_friction_slip2 = 0.12416 * friction * slip * slip;
        rolling_friction2_mobility = 0.0220043 * friction * friction * mobility;
    }
    torsion (
        "term of the ball's spin about the normal over the face's",
        FITTED
    ) {
        torsion_middle = 0.13568;
        torsion_slip = -0.352666 * slip;
        torsion_speed_slip = -0.356343 * speed * slip;
        torsion_speed3 = -0.114765 * speed * speed * speed;
        torsion_speed = 0.137067 * speed;
        torsion_slip2 = 0.11024 * slip * slip;
        torsion_coupling = 0.214632 * coupling;
        torsion_slip_coupling = -0.576741 * slip * coupling;
        torsion_speed2 = -0.0945411 * speed * speed;
        torsion_speed_coupling = 0.27099 * speed * coupling;
        torsion_speed_slip_coupling = -0.836738 * speed * slip * coupling;
    }
    peak (
        "term of the largest normal force over the mean one",
        FITTED
    ) {
        peak_middle = 1.78922;
        peak_speed = -0.0797567 * speed;
        peak_coupling = -0.30341 * coupling;
        peak_ratio_coupling = 0.340653 * ratio * coupling;
        peak_speed2_face = 0.0856186 * speed * speed * face;
        peak_mobility2_coupling = 0.371717 * mobility * mobility * coupling;
        peak_speed3 = 0.138994 * speed * speed * speed;
    }
}
