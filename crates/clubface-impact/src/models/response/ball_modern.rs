// The model's parameters with the values of the ball `modern`: written by `make response-fit`, names and terms by hand.
response_functions! {
    /// Parameters of the response functions.
    Response {
        friction ["1"] = 0.35 in 0.0 ..= 2.0, "coefficient of Coulomb friction between ball and face", "the middle of 0.3 to 0.4, as measured between covers and clubfaces";
        time ["s"] = 0.000477983 in 1e-05 ..= 0.005, "contact time at 40 m/s against a plate", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        time_speed ["1"] = -0.22329 in -2.0 ..= 2.0, "power of the contact time in the normal approach speed", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        time_mobility ["1"] = 0.299126 in -2.0 ..= 2.0, "power of the contact time in the mass of ball and head together over that of the ball", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        time_face ["1"] = 0.0605705 in -2.0 ..= 2.0, "growth of the contact time with the compliance of the face", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        half_slip ["1"] = 0.498092 in 0.01 ..= 20.0, "need of friction over its limit at which the slip feature is a half", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        sharpness ["1"] = 17.8025 in 1.0 ..= 100.0, "how suddenly sliding throughout sets in", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_turn ["1"] = 0.516633 in -2.0 ..= 2.0, "share of the contact time by which the head's spin before impact turns the place of the impulse", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_turned ["1"] = 0.136574 in -2.0 ..= 2.0, "the same for the change of the head's spin", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_shift ["1"] = 0.46277 in -2.0 ..= 2.0, "the same for the approach before impact and the ball's place", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        middle_pushed ["1"] = 0.446746 in -2.0 ..= 2.0, "the same for its change", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_turn ["1"] = 0.211076 in -2.0 ..= 2.0, "share of the contact time by which the head's spin before impact turns the place of separation", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_turned ["1"] = -0.0377805 in -2.0 ..= 2.0, "the same for the change of the head's spin", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_shift ["1"] = 0.655778 in -2.0 ..= 2.0, "the same for the approach before impact and the ball's place", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        end_pushed ["1"] = 0.0314439 in -2.0 ..= 2.0, "the same for its change", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        twist_before ["1"] = 0.808265 in -5.0 ..= 5.0, "weight of the head's spin before impact beside its change, in the ball's spin about the normal", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
        twist_arm ["1"] = 0.0301666 in 0.0 ..= 1.0, "arm of friction against twisting over the radius of the ball", "fitted to runs of the finite element ball modern, see studies/response_fit.py";
    }
    restitution ("term of the normal restitution", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        restitution_middle = 0.82413;
        restitution_speed = -0.072711 * speed;
        restitution_friction = 0.013356 * friction;
        restitution_mobility = 0.011504 * mobility;
        restitution_ratio = -0.0082622 * ratio;
        restitution_coupling = 0.026698 * coupling;
        restitution_face = 0.032771 * face;
        restitution_speed_friction = 0.0086387 * speed * friction;
        restitution_speed_mobility = 0.010821 * speed * mobility;
        restitution_speed_face = 0.035122 * speed * face;
        restitution_slip2 = -0.043582 * slip * slip;
        restitution_coupling2 = 0.047553 * coupling * coupling;
        restitution_face2 = -0.0046154 * face * face;
        restitution_speed3 = -0.022791 * speed * speed * speed;
        restitution_speed2_coupling = 0.15624 * speed * speed * coupling;
        restitution_speed2_face = 0.012197 * speed * speed * face;
        restitution_speed_slip2 = -0.054532 * speed * slip * slip;
        restitution_speed_slip_coupling = 0.30128 * speed * slip * coupling;
        restitution_friction_slip2 = -0.05387 * friction * slip * slip;
        restitution_slip3 = -0.031831 * slip * slip * slip;
        restitution_slip2_coupling = 0.16068 * slip * slip * coupling;
        restitution_slip_coupling_face = -0.072615 * slip * coupling * face;
    }
    tangential ("term of the tangential restitution", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        tangential_middle = 0.30864;
        tangential_speed = -0.11751 * speed;
        tangential_slip = -0.17861 * slip;
        tangential_coupling = -0.27556 * coupling;
        tangential_face = -0.043617 * face;
        tangential_speed_slip = -0.36105 * speed * slip;
        tangential_speed_mobility = -0.040648 * speed * mobility;
        tangential_friction_slip = 0.11372 * friction * slip;
        tangential_slip2 = -1.6886 * slip * slip;
        tangential_slip_coupling = 2.2099 * slip * coupling;
        tangential_slip_face = 0.22146 * slip * face;
        tangential_mobility2 = -0.035649 * mobility * mobility;
        tangential_ratio2 = 0.030479 * ratio * ratio;
        tangential_coupling2 = -0.57638 * coupling * coupling;
        tangential_coupling_face = -0.12883 * coupling * face;
        tangential_speed2_slip = 0.25004 * speed * speed * slip;
        tangential_speed_friction2 = -0.065115 * speed * friction * friction;
        tangential_speed_slip2 = 0.43373 * speed * slip * slip;
        tangential_speed_slip_coupling = -0.46644 * speed * slip * coupling;
        tangential_speed_slip_face = 0.074803 * speed * slip * face;
        tangential_friction3 = -0.037124 * friction * friction * friction;
        tangential_friction2_slip = -0.23015 * friction * friction * slip;
        tangential_friction_slip2 = -0.52934 * friction * slip * slip;
        tangential_friction_slip_coupling = -1.0839 * friction * slip * coupling;
        tangential_friction_ratio_coupling = 0.16862 * friction * ratio * coupling;
        tangential_friction_coupling2 = 0.44245 * friction * coupling * coupling;
        tangential_friction_coupling_face = 0.12556 * friction * coupling * face;
        tangential_slip3 = -0.66504 * slip * slip * slip;
        tangential_slip2_ratio = -0.73889 * slip * slip * ratio;
        tangential_slip2_coupling = -1.737 * slip * slip * coupling;
        tangential_slip_mobility2 = 0.13321 * slip * mobility * mobility;
        tangential_slip_ratio2 = -0.13341 * slip * ratio * ratio;
        tangential_slip_coupling2 = 1.9697 * slip * coupling * coupling;
        tangential_slip_coupling_face = 0.33329 * slip * coupling * face;
        tangential_ratio_coupling2 = 0.36228 * ratio * coupling * coupling;
    }
    tangential_mobility ("term of the tangential restitution times the mobility along the face", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        tangential_mobility_middle = -0.09307;
        tangential_mobility_speed = 0.080203 * speed;
        tangential_mobility_slip = 0.37613 * slip;
        tangential_mobility_slip2 = 0.64119 * slip * slip;
        tangential_mobility_speed2_slip = -0.21666 * speed * speed * slip;
        tangential_mobility_slip2_mobility = 0.27777 * slip * slip * mobility;
    }
    drive ("term of how far the normal impulse drives the contact along the face", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        drive_middle = -0.10857;
        drive_speed = 0.087799 * speed;
        drive_face = -0.028246 * face;
        drive_speed_friction = 0.091113 * speed * friction;
        drive_speed_slip = 0.16342 * speed * slip;
        drive_friction2 = 0.094548 * friction * friction;
        drive_friction_mobility = 0.13699 * friction * mobility;
        drive_slip2 = 1.5015 * slip * slip;
        drive_speed_slip2 = 0.45086 * speed * slip * slip;
        drive_speed_coupling2 = -0.52298 * speed * coupling * coupling;
        drive_friction3 = -0.11864 * friction * friction * friction;
        drive_friction2_mobility = -0.18582 * friction * friction * mobility;
        drive_slip3 = 3.1743 * slip * slip * slip;
        drive_mobility2_coupling = -0.28653 * mobility * mobility * coupling;
    }
    lever ("term of the lever of friction over the radius", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        lever_middle = 0.91994;
        lever_speed = -0.07167 * speed;
        lever_slip = -0.030483 * slip;
        lever_speed_slip = -0.06562 * speed * slip;
        lever_mobility3 = -0.020825 * mobility * mobility * mobility;
    }
    torsion ("term of the ball's spin about the normal over the face's", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        torsion_middle = 0.13008;
        torsion_slip = -0.34205 * slip;
        torsion_speed_slip = -0.36261 * speed * slip;
        torsion_speed3 = 0.32221 * speed * speed * speed;
    }
    peak ("term of the largest normal force over the mean one", "fitted to runs of the finite element ball modern, see studies/response_fit.py") {
        peak_middle = 1.7908;
        peak_speed = -0.05297 * speed;
        peak_coupling = -0.24086 * coupling;
        peak_ratio_coupling = 0.23392 * ratio * coupling;
        peak_speed2_face = 0.08995 * speed * speed * face;
    }
}
