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
        time ["s"] = 0.00047806 in 1e-05 ..= 0.005,
            "contact time at 40 m/s against a plate",
            FITTED;
        time_speed ["1"] = -0.223183 in -2.0 ..= 2.0,
            "power of the contact time in the normal approach speed",
            FITTED;
        time_mobility ["1"] = 0.300583 in -2.0 ..= 2.0,
            "power of the contact time in the mass of ball and head together over that of the ball",
            FITTED;
        time_face ["1"] = 0.0609473 in -2.0 ..= 2.0,
            "growth of the contact time with the compliance of the face",
            FITTED;
        half_slip ["1"] = 0.496185 in 0.01 ..= 20.0,
            "need of friction over its limit at which the slip feature is a half",
            FITTED;
        sharpness ["1"] = 17.7262 in 1.0 ..= 100.0,
            "how suddenly sliding throughout sets in",
            FITTED;
        middle_turn ["1"] = 0.517038 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of the impulse",
            FITTED;
        middle_turned ["1"] = 0.136966 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        middle_shift ["1"] = 0.443416 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        middle_pushed ["1"] = 0.414722 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        end_turn ["1"] = 0.216331 in -2.0 ..= 2.0,
            "share of the contact time by which the head's spin before impact turns the place of separation",
            FITTED;
        end_turned ["1"] = -0.0368622 in -2.0 ..= 2.0,
            "the same for the change of the head's spin",
            FITTED;
        end_shift ["1"] = 0.685142 in -2.0 ..= 2.0,
            "the same for the approach before impact and the ball's place",
            FITTED;
        end_pushed ["1"] = 0.0893025 in -2.0 ..= 2.0,
            "the same for its change",
            FITTED;
        twist_before ["1"] = 0.85388 in -5.0 ..= 5.0,
            "weight of the head's spin before impact beside its change, in the ball's spin about the normal",
            FITTED;
        twist_arm ["1"] = 0.0338642 in 0.0 ..= 1.0,
            "arm of friction against twisting over the radius of the ball",
            FITTED;
    }
    restitution (
        "term of the normal restitution",
        FITTED
    ) {
        restitution_middle = 0.824099;
        restitution_speed = -0.071986 * speed;
        restitution_friction = 0.0131582 * friction;
        restitution_mobility = 0.0109805 * mobility;
        restitution_ratio = -0.00792251 * ratio;
        restitution_coupling = 0.0256724 * coupling;
        restitution_face = 0.0324117 * face;
        restitution_speed_friction = 0.00876987 * speed * friction;
        restitution_speed_mobility = 0.0101003 * speed * mobility;
        restitution_speed_face = 0.0350379 * speed * face;
        restitution_slip2 = -0.0430336 * slip * slip;
        restitution_coupling2 = 0.0546446 * coupling * coupling;
        restitution_face2 = -0.00444243 * face * face;
        restitution_speed3 = -0.0249624 * speed * speed * speed;
        restitution_speed2_coupling = 0.164476 * speed * speed * coupling;
        restitution_speed2_face = 0.01307 * speed * speed * face;
        restitution_speed_slip2 = -0.0565151 * speed * slip * slip;
        restitution_speed_slip_coupling = 0.320343 * speed * slip * coupling;
        restitution_friction_slip2 = -0.0531174 * friction * slip * slip;
        restitution_slip3 = -0.0331043 * slip * slip * slip;
        restitution_slip2_coupling = 0.182005 * slip * slip * coupling;
        restitution_slip_coupling_face = -0.075409 * slip * coupling * face;
    }
    tangential (
        "term of the tangential restitution",
        FITTED
    ) {
        tangential_middle = 0.308796;
        tangential_speed = -0.11697 * speed;
        tangential_slip = -0.172409 * slip;
        tangential_coupling = -0.28271 * coupling;
        tangential_face = -0.0438872 * face;
        tangential_speed_slip = -0.360561 * speed * slip;
        tangential_speed_mobility = -0.0404339 * speed * mobility;
        tangential_friction_slip = 0.122097 * friction * slip;
        tangential_slip2 = -1.67993 * slip * slip;
        tangential_slip_coupling = 2.22172 * slip * coupling;
        tangential_slip_face = 0.221075 * slip * face;
        tangential_mobility2 = -0.0325557 * mobility * mobility;
        tangential_ratio2 = 0.0272205 * ratio * ratio;
        tangential_coupling2 = -0.586555 * coupling * coupling;
        tangential_coupling_face = -0.127245 * coupling * face;
        tangential_speed2_slip = 0.250166 * speed * speed * slip;
        tangential_speed_friction2 = -0.0652231 * speed * friction * friction;
        tangential_speed_slip2 = 0.437135 * speed * slip * slip;
        tangential_speed_slip_coupling = -0.444634 * speed * slip * coupling;
        tangential_speed_slip_face = 0.0760881 * speed * slip * face;
        tangential_friction3 = -0.0367114 * friction * friction * friction;
        tangential_friction2_slip = -0.230455 * friction * friction * slip;
        tangential_friction_slip2 = -0.512387 * friction * slip * slip;
        tangential_friction_slip_coupling = -1.06663 * friction * slip * coupling;
        tangential_friction_ratio_coupling = 0.170013 * friction * ratio * coupling;
        tangential_friction_coupling2 = 0.441202 * friction * coupling * coupling;
        tangential_friction_coupling_face = 0.125355 * friction * coupling * face;
        tangential_slip3 = -0.674682 * slip * slip * slip;
        tangential_slip2_ratio = -0.724525 * slip * slip * ratio;
        tangential_slip2_coupling = -1.69718 * slip * slip * coupling;
        tangential_slip_mobility2 = 0.13696 * slip * mobility * mobility;
        tangential_slip_ratio2 = -0.132369 * slip * ratio * ratio;
        tangential_slip_coupling2 = 1.96354 * slip * coupling * coupling;
        tangential_slip_coupling_face = 0.328944 * slip * coupling * face;
        tangential_ratio_coupling2 = 0.353048 * ratio * coupling * coupling;
    }
    tangential_mobility (
        "term of the tangential restitution times the mobility along the face",
        FITTED
    ) {
        tangential_mobility_middle = -0.0947651;
        tangential_mobility_speed = 0.0791953 * speed;
        tangential_mobility_slip = 0.375494 * slip;
        tangential_mobility_slip2 = 0.628233 * slip * slip;
        tangential_mobility_speed2_slip = -0.203666 * speed * speed * slip;
        tangential_mobility_slip2_mobility = 0.288014 * slip * slip * mobility;
    }
    drive (
        "term of how far the normal impulse drives the contact along the face",
        FITTED
    ) {
        drive_middle = -0.110878;
        drive_speed = 0.085598 * speed;
        drive_face = -0.0278287 * face;
        drive_speed_friction = 0.08711 * speed * friction;
        drive_speed_slip = 0.167651 * speed * slip;
        drive_friction2 = 0.092947 * friction * friction;
        drive_friction_mobility = 0.138632 * friction * mobility;
        drive_slip2 = 1.49491 * slip * slip;
        drive_speed_slip2 = 0.461905 * speed * slip * slip;
        drive_speed_coupling2 = -0.54903 * speed * coupling * coupling;
        drive_friction3 = -0.126309 * friction * friction * friction;
        drive_friction2_mobility = -0.181719 * friction * friction * mobility;
        drive_slip3 = 3.14137 * slip * slip * slip;
        drive_mobility2_coupling = -0.285968 * mobility * mobility * coupling;
    }
    lever (
        "term of the lever of friction over the radius",
        FITTED
    ) {
        lever_middle = 0.920324;
        lever_speed = -0.071764 * speed;
        lever_slip = -0.0311422 * slip;
        lever_speed_slip = -0.0652901 * speed * slip;
        lever_mobility3 = -0.0198395 * mobility * mobility * mobility;
    }
    torsion (
        "term of the ball's spin about the normal over the face's",
        FITTED
    ) {
        torsion_middle = 0.128142;
        torsion_slip = -0.341596 * slip;
        torsion_speed_slip = -0.359962 * speed * slip;
        torsion_speed3 = 0.305518 * speed * speed * speed;
    }
    peak (
        "term of the largest normal force over the mean one",
        FITTED
    ) {
        peak_middle = 1.79086;
        peak_speed = -0.0529225 * speed;
        peak_coupling = -0.243649 * coupling;
        peak_ratio_coupling = 0.236935 * ratio * coupling;
        peak_speed2_face = 0.0916081 * speed * speed * face;
    }
}
