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
        time ["s"] = 0.000490199 in 1e-05 ..= 0.005,
            "contact time at 40 m/s against a plate",
            FITTED;
        time_speed ["1"] = -0.216677 in -2.0 ..= 2.0,
            "power of the contact time in the normal approach speed",
            FITTED;
        time_mobility ["1"] = 0.288615 in -2.0 ..= 2.0,
            "power of the contact time in the mass of ball and head together over that of the ball",
            FITTED;
        time_face ["1"] = 0.0571899 in -2.0 ..= 2.0,
            "growth of the contact time with the compliance of the face",
            FITTED;
        half_slip ["1"] = 0.519171 in 0.01 ..= 20.0,
            "need of friction over its limit at which the slip feature is a half",
            FITTED;
        sharpness ["1"] = 12.9807 in 1.0 ..= 100.0,
            "how suddenly sliding throughout sets in",
            FITTED;
        middle_turn ["1"] = 0.488387 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of the impulse",
            FITTED;
        middle_turned ["1"] = 0.112162 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        middle_shift ["1"] = 0.424792 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        middle_pushed ["1"] = 0.180532 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        end_turn ["1"] = 0.389357 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of separation",
            FITTED;
        end_turned ["1"] = 0.0605866 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        end_shift ["1"] = 0.624161 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        end_pushed ["1"] = 0.327117 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        twist_before ["1"] = 1.03146 in -5.0 ..= 5.0,
            "weight of the head's spin before impact beside its change, in the ball's spin about the normal",
            FITTED;
        twist_spin ["1"] = 2.48682 in -5.0 ..= 5.0,
            "the same for the ball's spin before impact",
            FITTED;
        rolling_gained ["1"] = 1.10383 in -5.0 ..= 5.0,
            "weight of the change of the spins beside the spins before impact, in the rolling of the ball",
            FITTED;
        twist_arm ["1"] = 0.271174 in 0.0 ..= 1.0,
            "arm of friction against twisting over the radius of the ball",
            FITTED;
    }
    restitution (
        "term of the normal restitution",
        FITTED
    ) {
        restitution_middle = 0.823657;
        restitution_speed = -0.0773815 * speed;
        restitution_friction = 0.0109315 * friction;
        restitution_mobility = 0.0112323 * mobility;
        restitution_ratio = -0.0085525 * ratio;
        restitution_coupling = 0.0434572 * coupling;
        restitution_face = 0.0327624 * face;
        restitution_speed_friction = 0.00676188 * speed * friction;
        restitution_speed_mobility = 0.0106659 * speed * mobility;
        restitution_speed_face = 0.0462582 * speed * face;
        restitution_slip2 = -0.0313712 * slip * slip;
        restitution_coupling2 = 0.0503439 * coupling * coupling;
        restitution_face2 = -0.00454513 * face * face;
        restitution_speed3 = -0.0169661 * speed * speed * speed;
        restitution_speed2_coupling = 0.112081 * speed * speed * coupling;
        restitution_speed2_face = 0.00745083 * speed * speed * face;
        restitution_speed_slip2 = -0.0453608 * speed * slip * slip;
        restitution_speed_slip_coupling = 0.288416 * speed * slip * coupling;
        restitution_friction_slip2 = -0.0458446 * friction * slip * slip;
        restitution_slip3 = -0.0242953 * slip * slip * slip;
        restitution_slip2_coupling = 0.138041 * slip * slip * coupling;
        restitution_slip_coupling_face = -0.0758742 * slip * coupling * face;
        restitution_bend = 0.108242 * bend;
        restitution_speed_face2 = -0.00752949 * speed * face * face;
        restitution_speed2_mobility = 0.0252802 * speed * speed * mobility;
        restitution_speed2_slip = 0.0226548 * speed * speed * slip;
    }
    tangential (
        "term of the tangential restitution",
        FITTED
    ) {
        tangential_middle = 0.287712;
        tangential_slip = 0.20956 * slip;
        tangential_coupling = -0.405215 * coupling;
        tangential_face = -0.0298675 * face;
        tangential_speed_slip = -0.283555 * speed * slip;
        tangential_friction_slip = 0.214112 * friction * slip;
        tangential_slip2 = -1.4642 * slip * slip;
        tangential_slip_coupling = 2.62846 * slip * coupling;
        tangential_slip_face = 0.150757 * slip * face;
        tangential_mobility2 = -0.0101169 * mobility * mobility;
        tangential_ratio2 = 0.0160432 * ratio * ratio;
        tangential_coupling2 = -0.385165 * coupling * coupling;
        tangential_coupling_face = -0.0492583 * coupling * face;
        tangential_speed2_slip = 0.0731301 * speed * speed * slip;
        tangential_speed_friction2 = -0.0532301 * speed * friction * friction;
        tangential_speed_slip2 = 0.201454 * speed * slip * slip;
        tangential_speed_slip_coupling = -0.11674 * speed * slip * coupling;
        tangential_speed_slip_face = 0.0798673 * speed * slip * face;
        tangential_friction3 = -0.0372741 * friction * friction * friction;
        tangential_friction2_slip = -0.304402 * friction * friction * slip;
        tangential_friction_slip2 = -0.156645 * friction * slip * slip;
        tangential_friction_slip_coupling = -1.85331 * friction * slip * coupling;
        tangential_friction_ratio_coupling = 0.0882063 * friction * ratio * coupling;
        tangential_friction_coupling2 = 0.422928 * friction * coupling * coupling;
        tangential_slip3 = -1.03082 * slip * slip * slip;
        tangential_slip2_ratio = -0.422544 * slip * slip * ratio;
        tangential_slip2_coupling = -1.28707 * slip * slip * coupling;
        tangential_slip_ratio2 = -0.364364 * slip * ratio * ratio;
        tangential_slip_coupling2 = 1.1385 * slip * coupling * coupling;
        tangential_slip_coupling_face = 0.0230222 * slip * coupling * face;
        tangential_ratio_coupling2 = 0.195823 * ratio * coupling * coupling;
        tangential_slip_offset = 0.45737 * slip * offset;
        tangential_offset = -0.0659961 * offset;
        tangential_mobility_face = -0.012701 * mobility * face;
        tangential_friction_coupling = 0.225079 * friction * coupling;
        tangential_friction_slip_offset = -0.457796 * friction * slip * offset;
        tangential_slip2_offset = -0.262008 * slip * slip * offset;
        tangential_speed_mobility_face = -0.0207218 * speed * mobility * face;
        tangential_slip_mobility_ratio = 0.436251 * slip * mobility * ratio;
        tangential_slip_ratio_coupling = -0.589936 * slip * ratio * coupling;
    }
    tangential_mobility (
        "term of the tangential restitution times the mobility along the face",
        FITTED
    ) {
        tangential_mobility_middle = -0.0831305;
        tangential_mobility_speed = 0.0362759 * speed;
        tangential_mobility_slip = 0.357876 * slip;
        tangential_mobility_slip2 = 0.643192 * slip * slip;
        tangential_mobility_speed2_slip = -0.355341 * speed * speed * slip;
        tangential_mobility_slip2_mobility = 0.504943 * slip * slip * mobility;
    }
    drive (
        "term of how far the normal impulse drives the contact along the face",
        FITTED
    ) {
        drive_middle = -0.170156;
        drive_speed = -0.0412881 * speed;
        drive_face = -0.0323791 * face;
        drive_speed_friction = 0.0886626 * speed * friction;
        drive_speed_slip = 0.100224 * speed * slip;
        drive_friction2 = 0.141992 * friction * friction;
        drive_friction_mobility = 0.0935867 * friction * mobility;
        drive_slip2 = 1.04886 * slip * slip;
        drive_speed_slip2 = 0.303934 * speed * slip * slip;
        drive_speed_coupling2 = -0.255923 * speed * coupling * coupling;
        drive_friction3 = -0.134142 * friction * friction * friction;
        drive_friction2_mobility = -0.143785 * friction * friction * mobility;
        drive_slip3 = 2.80533 * slip * slip * slip;
        drive_mobility2_coupling = -0.153995 * mobility * mobility * coupling;
        drive_slip2_coupling = -1.5137 * slip * slip * coupling;
        drive_friction_slip2 = -0.323939 * friction * slip * slip;
    }
    swerve (
        "term of how far a ball that turns about the normal pushes across its sliding",
        FITTED
    ) {
        swerve_middle = -0.183824;
        swerve_slip = 0.621485 * slip;
        swerve_speed2 = 0.216414 * speed * speed;
        swerve_speed_slip = 0.739525 * speed * slip;
        swerve_coupling = -0.294964 * coupling;
    }
    lever (
        "term of the lever of friction over the radius",
        FITTED
    ) {
        lever_middle = 0.954377;
        lever_slip = -0.0230132 * slip;
        lever_speed_slip = -0.0496645 * speed * slip;
        lever_mobility3 = -0.0106509 * mobility * mobility * mobility;
        lever_slip_coupling = -0.0992148 * slip * coupling;
        lever_friction_slip2 = 0.162519 * friction * slip * slip;
        lever_slip2 = 0.0982897 * slip * slip;
        lever_slip_bend = -0.0695389 * slip * bend;
        lever_speed3 = -0.0144073 * speed * speed * speed;
    }
    rolling (
        "term of the couple by which the pressure brakes the rolling of the ball, over its spin",
        FITTED
    ) {
        rolling_middle = 0.0427156;
        rolling_speed = 0.077404 * speed;
        rolling_slip2 = 0.0938466 * slip * slip;
        rolling_friction_slip2 = 0.114562 * friction * slip * slip;
        rolling_friction2_mobility = 0.0191231 * friction * friction * mobility;
    }
    torsion (
        "term of the ball's spin about the normal over the face's",
        FITTED
    ) {
        torsion_middle = 0.14616;
        torsion_slip = -0.427731 * slip;
        torsion_speed_slip = -0.451517 * speed * slip;
        torsion_speed3 = -0.100775 * speed * speed * speed;
        torsion_speed = 0.148133 * speed;
        torsion_slip2 = 0.180857 * slip * slip;
        torsion_coupling = 0.248225 * coupling;
        torsion_slip_coupling = -0.783046 * slip * coupling;
        torsion_speed2 = -0.111152 * speed * speed;
        torsion_speed_coupling = 0.328949 * speed * coupling;
        torsion_speed_slip_coupling = -1.20807 * speed * slip * coupling;
    }
    peak (
        "term of the largest normal force over the mean one",
        FITTED
    ) {
        peak_middle = 1.78776;
        peak_speed = -0.0539642 * speed;
        peak_coupling = -0.305116 * coupling;
        peak_ratio_coupling = 0.356135 * ratio * coupling;
        peak_speed2_face = 0.0716926 * speed * speed * face;
        peak_mobility2_coupling = 0.397243 * mobility * mobility * coupling;
        peak_speed3 = 0.120751 * speed * speed * speed;
    }
}
