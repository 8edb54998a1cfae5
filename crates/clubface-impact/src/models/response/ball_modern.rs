// The model's parameters with the values of the ball `modern`: written by `make response-fit`, names and terms by hand.
response_functions! {
    /// Parameters of the response functions.
    Response {
        friction ["1"] = 0.35 in 0.0 ..= 2.0, "coefficient of Coulomb friction between ball and face", "the middle of 0.3 to 0.4, as measured between covers and clubfaces";
        time ["s"] = 0.000481066 in 1e-05 ..= 0.005, "contact time at 40 m/s against a plate", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        time_speed ["1"] = -0.2297 in -2.0 ..= 2.0, "power of the contact time in the normal approach speed", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        time_mobility ["1"] = 0.3179 in -2.0 ..= 2.0, "power of the contact time in the mass of ball and head together over that of the ball", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        time_face ["1"] = 0.05 in -2.0 ..= 2.0, "growth of the contact time with the compliance of the face", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        half_slip ["1"] = 0.5588 in 0.01 ..= 20.0, "need of friction over its limit at which the slip feature is a half", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        sharpness ["1"] = 13.674 in 1.0 ..= 100.0, "how suddenly sliding throughout sets in", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_turn ["1"] = 0.5276 in -2.0 ..= 2.0, "share of the contact time by which the head's spin before impact turns the place of the impulse", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_turned ["1"] = 0.1433 in -2.0 ..= 2.0, "the same for the change of the head's spin", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_shift ["1"] = 0.4868 in -2.0 ..= 2.0, "the same for the approach before impact and the ball's place", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_pushed ["1"] = 0.4512 in -2.0 ..= 2.0, "the same for its change", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_turn ["1"] = 0.2228 in -2.0 ..= 2.0, "share of the contact time by which the head's spin before impact turns the place of separation", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_turned ["1"] = -0.0227 in -2.0 ..= 2.0, "the same for the change of the head's spin", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_shift ["1"] = 0.6562 in -2.0 ..= 2.0, "the same for the approach before impact and the ball's place", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_pushed ["1"] = 0.0576 in -2.0 ..= 2.0, "the same for its change", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        twist_before ["1"] = 0.8897 in -5.0 ..= 5.0, "weight of the head's spin before impact beside its change, in the ball's spin about the normal", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        twist_arm ["1"] = 0.0607 in 0.0 ..= 1.0, "arm of friction against twisting over the radius of the ball", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
    }
    restitution ("term of the normal restitution", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        restitution_middle = 0.82445;
        restitution_speed = -0.08471 * speed;
        restitution_friction = 0.00771 * friction;
        restitution_mobility = 0.009 * mobility;
        restitution_ratio = -0.00543 * ratio;
        restitution_coupling = 0.00857 * coupling;
        restitution_speed_friction = 0.00743 * speed * friction;
        restitution_speed_mobility = 0.00962 * speed * mobility;
        restitution_speed_coupling = -0.02456 * speed * coupling;
        restitution_friction_mobility = 0.01138 * friction * mobility;
        restitution_friction_ratio = -0.01312 * friction * ratio;
        restitution_slip2 = -0.02613 * slip * slip;
        restitution_slip_mobility = 0.01522 * slip * mobility;
        restitution_slip_ratio = -0.00942 * slip * ratio;
        restitution_slip_coupling = -0.04725 * slip * coupling;
        restitution_ratio2 = 0.00344 * ratio * ratio;
        restitution_face = 0.045 * face;
        restitution_speed_face = 0.0 * speed * face;
        restitution_mobility_face = 0.0 * mobility * face;
        restitution_face2 = 0.0 * face * face;
    }
    tangential ("term of the tangential restitution", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        tangential_middle = 0.29945;
        tangential_speed_slip2 = 0.87304 * speed * slip * slip;
        tangential_slip3 = -0.17773 * slip * slip * slip;
        tangential_slip2_mobility = -0.07452 * slip * slip * mobility;
        tangential_slip2_coupling = 0.10708 * slip * slip * coupling;
        tangential_slip4 = -3.16897 * slip * slip * slip * slip;
        tangential_speed2_slip = 0.26664 * speed * speed * slip;
        tangential_speed = -0.13306 * speed;
        tangential_friction = -0.00694 * friction;
        tangential_slip = -0.23106 * slip;
        tangential_mobility = -0.07416 * mobility;
        tangential_coupling = -0.05827 * coupling;
        tangential_speed_slip = -0.14442 * speed * slip;
        tangential_speed_mobility = -0.09816 * speed * mobility;
        tangential_speed_coupling = 0.17827 * speed * coupling;
        tangential_friction_slip = 0.15477 * friction * slip;
        tangential_slip2 = -0.89334 * slip * slip;
        tangential_slip_mobility = -0.05181 * slip * mobility;
        tangential_slip_coupling = 1.0587 * slip * coupling;
        tangential_mobility2 = -0.02424 * mobility * mobility;
        tangential_coupling2 = -0.14843 * coupling * coupling;
        tangential_face = 0.0 * face;
        tangential_slip_face = 0.0 * slip * face;
    }
    tangential_mobility ("term of the tangential restitution times the mobility along the face", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        tangential_mobility_slip2 = -0.01122 * slip * slip;
        tangential_mobility_speed = 0.11681 * speed;
        tangential_mobility_slip = 0.40526 * slip;
        tangential_mobility_mobility = 0.02639 * mobility;
    }
    drive ("term of how far the normal impulse drives the contact along the face", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        drive_middle = -0.03226;
        drive_speed_slip2 = -0.21555 * speed * slip * slip;
        drive_slip3 = 3.51015 * slip * slip * slip;
        drive_slip2_coupling = -0.41143 * slip * slip * coupling;
        drive_slip4 = 6.12066 * slip * slip * slip * slip;
        drive_friction_slip3 = 2.67657 * friction * slip * slip * slip;
        drive_slip_coupling2 = 0.11878 * slip * coupling * coupling;
        drive_speed = 0.17006 * speed;
        drive_ratio = 0.00908 * ratio;
        drive_speed_friction = 0.09118 * speed * friction;
        drive_speed_slip = 0.00703 * speed * slip;
        drive_friction2 = 0.05519 * friction * friction;
        drive_friction_slip = -0.48827 * friction * slip;
        drive_friction_coupling = 0.13832 * friction * coupling;
        drive_face = 0.0 * face;
    }
    lever ("term of the lever of friction over the radius", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        lever_middle = 0.91697;
        lever_slip = -0.03072 * slip;
        lever_speed = -0.07654 * speed;
        lever_mobility = -0.03618 * mobility;
        lever_ratio = 0.01905 * ratio;
        lever_speed_slip = -0.05213 * speed * slip;
        lever_speed_mobility = -0.03269 * speed * mobility;
        lever_slip_mobility = 0.03415 * slip * mobility;
        lever_slip_ratio = -0.05171 * slip * ratio;
        lever_slip_coupling = -0.16983 * slip * coupling;
        lever_face = 0.0 * face;
    }
    torsion ("term of the ball's spin about the normal over the face's", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        torsion_middle = 0.12452;
        torsion_speed = 0.11919 * speed;
        torsion_friction = -0.01826 * friction;
        torsion_slip = -0.34523 * slip;
        torsion_mobility = 0.06947 * mobility;
        torsion_speed_friction = -0.02038 * speed * friction;
        torsion_speed_slip = -0.36204 * speed * slip;
        torsion_friction_slip = -0.08824 * friction * slip;
    }
    peak ("term of the largest normal force over the mean one", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        peak_middle = 1.8;
        peak_speed = 0.0 * speed;
        peak_mobility = 0.0 * mobility;
        peak_face = 0.0 * face;
    }
}
