//! The C interface against the core, its header, and a program in C.

#![allow(clippy::unwrap_used)]

mod answer;

use answer::{c, read};
use clubface::*;
use clubface_impact::batch::Batch;
use clubface_impact::columns::Column;
use clubface_impact::flight;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::multibody::{Body, Head, HeadContact};
use clubface_impact::registry::{self, named};
use clubface_impact::shot::{INPUT_COUNT, INPUTS};
use clubface_impact::{Accuracy, ImpactModel};
use serde_json::{Value, json};
use std::ffi::{c_char, c_void};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::ptr::null_mut;

const HERE: &str = env!("CARGO_MANIFEST_DIR");

/// A drive; the first rows of a batch differ in speed and strike, the last misses the face.
fn shot(row: usize, rows: usize) -> [f64; INPUT_COUNT] {
    let given = [
        ("speed", 40.0 + 0.1 * row as f64),
        ("attack", 0.03),
        ("loft", 0.22),
        ("toe", if row + 1 == rows { 0.4 } else { 1e-4 * row as f64 }),
        ("club_mass", 0.2),
        ("cg_x", 0.0354),
        ("cg_y", 0.0035),
        ("ixx", 2.5e-4),
        ("iyy", 4.7e-4),
        ("izz", 2.7e-4),
        ("static_loft", 0.17),
        ("bulge", 0.305),
        ("roll", 0.305),
        ("face_width", 0.11),
        ("face_height", 0.058),
        ("characteristic_time", 2.4e-4),
        ("hand", 1.0),
        ("ball_mass", 0.0459),
        ("ball_radius", 0.02134),
        ("ball_inertia", 8.2e-6),
    ];
    INPUTS.map(|input| given.iter().find(|(name, _)| *name == input.quantity.name).map_or(0.0, |(_, v)| *v))
}

fn by_columns(rows: usize) -> Vec<f64> {
    (0..INPUT_COUNT).flat_map(|column| (0..rows).map(move |row| shot(row, rows)[column])).collect()
}

/// The same numbers, bit for bit; NaN where the other has NaN.
fn assert_same(one: &[f64], other: &[f64]) {
    assert_eq!(one.len(), other.len());
    for (a, b) in one.iter().zip(other) {
        assert!(a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()), "{a} and {b} differ");
    }
}

fn launches_by_core(model: ImpactModel, inputs: &[f64], rows: usize) -> (Vec<f64>, usize) {
    let inputs: Vec<Column> = inputs.chunks_exact(rows).map(Column::Values).collect();
    let parameters: Vec<Column> = model.info().defaults().into_iter().map(Column::Constant).collect();
    let batch = Batch { model, inputs: &inputs, parameters: &parameters, accuracy: Accuracy::Fast };
    let mut outputs = vec![0.0; OUTPUT_COUNT * rows];
    let rejects = batch.run(0..rows, outputs.chunks_exact_mut(rows).collect());
    (outputs, rejects.len())
}

#[test]
fn launches_of_every_model_are_those_of_the_core_on_any_number_of_threads() {
    let rows = 130;
    let inputs = by_columns(rows);
    for model in registry::ALL {
        let info = model.info();
        let (expected, rejected) = launches_by_core(*model, &inputs, rows);
        assert_eq!(rejected, 1);
        for threads in [0, 1, 3] {
            let mut outputs = vec![0.0; OUTPUT_COUNT * rows];
            let (name, parameters) = (c(info.name), info.defaults());
            let answer = read(unsafe {
                clubface_launches(
                    name.as_ptr(),
                    inputs.as_ptr(),
                    parameters.as_ptr(),
                    rows,
                    0.0,
                    threads,
                    outputs.as_mut_ptr(),
                )
            });
            assert_same(&outputs, &expected);
            let rejects = answer.outcome.unwrap();
            assert_eq!(rejects[0]["row"], rows - 1);
            assert_eq!(rejects[0]["input"], "toe");
        }
    }
}

#[test]
fn derivatives_of_one_shot_and_of_a_batch_agree() {
    let (model, inputs) = (c("slip"), shot(3, 100));
    let parameters = named("slip").unwrap().info().defaults();
    let width = INPUT_COUNT + parameters.len();
    let (mut outputs, mut jacobian) = (vec![0.0; OUTPUT_COUNT], vec![0.0; OUTPUT_COUNT * width]);
    let answer = read(unsafe {
        clubface_sensitivity(
            model.as_ptr(),
            inputs.as_ptr(),
            parameters.as_ptr(),
            0.0,
            outputs.as_mut_ptr(),
            jacobian.as_mut_ptr(),
        )
    });
    assert!(answer.outcome.is_ok());
    let (wanted, variables) = ([1, 4], [0, 6, INPUT_COUNT]);
    let mut values = vec![0.0; wanted.len() * (1 + variables.len())];
    let answer = read(unsafe {
        clubface_sensitivities(
            model.as_ptr(),
            inputs.as_ptr(),
            parameters.as_ptr(),
            1,
            wanted.as_ptr(),
            wanted.len(),
            variables.as_ptr(),
            variables.len(),
            0.0,
            1,
            values.as_mut_ptr(),
        )
    });
    assert_eq!(answer.outcome, Ok(json!([])));
    for (row, &output) in values.chunks_exact(1 + variables.len()).zip(&wanted) {
        // One shot and a pack do the same operations, but for products and sums that a CPU fuses.
        assert!((row[0] - outputs[output]).abs() <= 1e-12 * outputs[output].abs());
        for (value, &variable) in row[1..].iter().zip(&variables) {
            let exact = jacobian[output * width + variable];
            assert!((value - exact).abs() <= 1e-9 * exact.abs().max(1e-9), "{value} and {exact} differ");
        }
    }
}

#[test]
fn a_history_ends_in_the_launch() {
    let (model, inputs) = (c("area"), shot(2, 100));
    let defaults = named("area").unwrap().info().defaults();
    let answer = read(unsafe { clubface_history(model.as_ptr(), inputs.as_ptr(), defaults.as_ptr(), 1e-9) });
    let (history, launch) =
        named("area").unwrap().history(&inputs, &defaults, Accuracy::Tolerance(1e-9)).unwrap();
    assert_same(&answer.array("launch").2, &launch);
    assert_eq!(answer.array("ball_velocity").1, [history.frames.len(), 3]);
    let forces: Vec<f64> = history.frames.iter().map(|frame| frame.normal_force).collect();
    assert_same(&answer.array("normal_force").2, &forces);
}

#[test]
fn flights_and_their_paths_end_at_the_same_place() {
    let mut inputs = flight::default_inputs();
    for (name, value) in [("velocity_x", 60.0), ("velocity_y", 15.0), ("velocity_z", 1.0), ("spin_z", 250.0)]
    {
        let place = flight::INPUTS.iter().position(|input| input.quantity.name == name).unwrap();
        inputs[place] = value;
    }
    for name in ["spin_x", "spin_y"] {
        inputs[flight::INPUTS.iter().position(|input| input.quantity.name == name).unwrap()] = 0.0;
    }
    let mut outputs = vec![0.0; flight::OUTPUT_COUNT];
    let answer = read(unsafe { clubface_flights(inputs.as_ptr(), 1, 1, outputs.as_mut_ptr()) });
    assert_eq!(answer.outcome, Ok(json!([])));
    let (mut again, mut jacobian) =
        (vec![0.0; flight::OUTPUT_COUNT], vec![0.0; flight::OUTPUT_COUNT * flight::INPUT_COUNT]);
    let answer = read(unsafe {
        clubface_flight_sensitivity(inputs.as_ptr(), again.as_mut_ptr(), jacobian.as_mut_ptr())
    });
    assert!(answer.outcome.is_ok());
    let exact = flight::sensitivity(&inputs).unwrap();
    assert_same(&again, &exact.values);
    assert_same(&jacobian, exact.jacobian.as_flattened());
    let path = read(unsafe { clubface_trajectory(inputs.as_ptr()) });
    let position = &path.array("position").2;
    let landing = &position[position.len() - 3..];
    // Carry is the distance from the tee over level ground; both integrate to 1e-8 or better.
    assert!((landing[0].hypot(landing[2]) - outputs[0]).abs() < 1e-5);
    assert!((landing[2] - outputs[1]).abs() < 1e-5);
}

#[test]
fn shots_are_named_by_the_limits_of_the_description() {
    let description = read(clubface_describe()).outcome.unwrap();
    let shapes = &description["shot_shapes"];
    let (start, curve) =
        (shapes["straight_start"].as_f64().unwrap(), shapes["straight_curve"].as_f64().unwrap());
    let (azimuth, curves) = ([0.0, 2.0 * start, 0.0], [0.0, -200.0 * 1.5 * curve, 1.0]);
    let carry = [200.0, 200.0, f64::NAN];
    let names = |hand| {
        read(unsafe { clubface_shot_shapes(azimuth.as_ptr(), curves.as_ptr(), carry.as_ptr(), 3, hand) })
    };
    assert_eq!(names(1.0).outcome, Ok(json!(["straight shot", shapes["names"][2][1], ""])));
    assert_eq!(names(-1.0).outcome, Ok(json!(["straight shot", "pull fade", ""])));
    let missing = read(unsafe { clubface_shot_shapes(null_mut(), curves.as_ptr(), carry.as_ptr(), 3, 1.0) });
    assert_eq!(missing.outcome.unwrap_err()["input"], "azimuth");
}

#[test]
fn a_map_of_a_face_is_the_launches_at_its_points() {
    let model = named("slip").unwrap();
    let inputs = shot(0, 9);
    let mut case = json!({
        "model": "slip", "parameters": model.info().defaults(), "inputs": inputs.to_vec(),
        "flight": flight::default_inputs().map(|value| (!value.is_nan()).then_some(value)).to_vec(),
        "outline": [[-0.04, -0.02], [0.04, -0.02], [0.03, 0.02], [-0.03, 0.02]], "grid": [5, 3],
        "best": ["ball_speed", "carry"], "share": 0.98, "scatter": {"deviations": [0.01, 0.006]},
    });
    let map = |case: &Value| {
        let text = c(&case.to_string());
        read(unsafe { clubface_face_map(text.as_ptr(), 1) })
    };
    let answer = map(&case);
    let text = answer.outcome.as_ref().unwrap();
    let quantities: Vec<&str> =
        text["quantities"].as_array().unwrap().iter().map(|v| v.as_str().unwrap()).collect();
    let (_, shape, values) = answer.array("values");
    assert_eq!(shape, &[quantities.len(), 3, 5]);
    assert_eq!(answer.array("inside").2, [1, 1, 1, 1, 1, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0].map(f64::from));
    let (toe, high) = (&answer.array("toe").2, &answer.array("high").2);
    assert_eq!((toe.len(), high.len(), toe[0], high[2]), (5, 3, -0.04, 0.02));
    let mut point = inputs;
    for (name, value) in [("toe", toe[3]), ("high", high[1])] {
        point[INPUTS.iter().position(|input| input.quantity.name == name).unwrap()] = value;
    }
    let (launch, _) = launches_by_core(model, &point, 1);
    for (place, output) in clubface_impact::launch::OUTPUTS.iter().enumerate() {
        if let Some(quantity) = quantities.iter().position(|name| *name == output.name) {
            assert_eq!(values[quantity * 15 + 5 + 3].to_bits(), launch[place].to_bits(), "{}", output.name);
        }
    }
    assert!(text["best"]["ball_speed"]["value"].as_f64() >= text["centre"]["ball_speed"].as_f64());
    assert!((text["face_area"].as_f64().unwrap() - 0.0028).abs() < 1e-15);
    assert!(text["effective_area"].as_f64().unwrap() > 1e-4);
    assert!(text["forgiveness"]["loss"]["ball_speed"].as_f64().unwrap() > 0.0);

    let mut refused = |key: &str, value: Value| {
        let before = std::mem::replace(&mut case[key], value);
        let error = map(&case).outcome.unwrap_err();
        case[key] = before;
        error["input"].as_str().unwrap().to_owned()
    };
    assert_eq!(refused("best", json!(["cary"])), "best");
    assert_eq!(refused("share", json!(1.5)), "share");
    assert_eq!(refused("tolerance", json!(0.5)), "tolerance");
    assert_eq!(refused("grid", json!([2, 9])), "grid");
    assert_eq!(refused("points", json!([[0.0], [0.0]])), "grid");
    assert_eq!(refused("outline", json!([[0.0, 0.0]])), "outline");
    assert_eq!(refused("scatter", json!({"deviations": [0.0, 0.01]})), "spread");
    assert_eq!(refused("parameters", json!([])), "parameters");
    assert_eq!(refused("colour", json!("red")), "text");
}

fn coarse_case() -> Value {
    json!({
        "ball": {
            "pieces": [
                {"name": "core", "radius": 0.0196, "layers": 2, "law": "mooney-rivlin", "constants": [4e6, 1e6],
                 "bulk": 5e8, "maxwell": [], "density": 1150.0},
                {"name": "cover", "radius": 0.0214, "layers": 1, "law": "linear", "constants": [1.25e8],
                 "bulk": 5.8e8, "maxwell": [], "density": 950.0},
            ],
            "cube": 4, "element": "one-point", "mass": 0.046,
        },
        "face": {"plane": {"speed": 35.0, "angle": 0.2}},
        "friction": 0.35,
        "run": {"duration": 1e-3, "threads": 2, "frames": 3, "fields": true},
    })
}

extern "C" fn stop_halfway(context: *mut c_void, time: f64, duration: f64) -> bool {
    unsafe { *context.cast::<usize>() += 1 };
    time < 0.5 * duration
}

#[test]
fn a_described_ball_rebounds_as_momentum_has_it_and_a_caller_can_stop_it() {
    let case = c(&coarse_case().to_string());
    let answer = read(unsafe { clubface_fem(case.as_ptr(), None, null_mut()) });
    let summary = answer.outcome.as_ref().unwrap();
    assert_eq!(summary["stopped"], Value::Null);
    let velocity: Vec<f64> =
        summary["ball_velocity"].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect();
    let (time, normal) = (&answer.array("contact.time").2, &answer.array("contact.normal").2);
    let impulse: f64 = time.windows(2).zip(normal).map(|(pair, force)| (pair[1] - pair[0]) * force).sum();
    // The impulse of the normal force is the change of the ball's momentum. The sum over the steps takes each force over
    // its step; a record every step makes that good to a few 1e-4.
    let change = 0.046 * (velocity[0] + 35.0 * 0.2_f64.cos());
    assert!((impulse / change - 1.0).abs() < 2e-3, "{impulse} N s for {change} N s");
    let nodes = summary["nodes"][1].as_u64().unwrap() as usize;
    assert_eq!(answer.array("frames").1, [3, nodes, 3]);
    assert_eq!(answer.array("ball.stress").1[2..], [2, 6]);

    let mut calls = 0_usize;
    let answer = read(unsafe { clubface_fem(case.as_ptr(), Some(stop_halfway), (&raw mut calls).cast()) });
    assert!(calls > 10);
    assert!(answer.outcome.unwrap()["stopped"].as_str().unwrap().contains("by request"));
}

/// Rubber of the core of [`coarse_case`] as a caller writes it.
unsafe extern "C" fn rivlin(
    count: usize,
    shapes: *const f64,
    constants: *const f64,
    _step: f64,
    _states: *mut f64,
    results: *mut f64,
) {
    let (shapes, constants, results) = unsafe {
        (
            std::slice::from_raw_parts(shapes, 6 * count),
            std::slice::from_raw_parts(constants, 2),
            std::slice::from_raw_parts_mut(results, 8 * count),
        )
    };
    for i in 0..count {
        let c = |row: usize| shapes[row * count + i];
        let first = c(0) + c(1) + c(2);
        let square: f64 =
            (0..6).map(|row| if row < 3 { c(row) * c(row) } else { 2.0 * c(row) * c(row) }).sum();
        for row in 0..6 {
            let one = if row < 3 { 2.0 * (constants[0] + constants[1] * first) } else { 0.0 };
            results[row * count + i] = one - 2.0 * constants[1] * c(row);
        }
        results[6 * count + i] =
            constants[0] * (first - 3.0) + constants[1] * (0.5 * (first * first - square) - 3.0);
    }
}

#[test]
fn a_law_of_the_caller_is_the_same_law_in_the_core() {
    let description = json!({"constants": ["c10", "c01"], "values": [4e6, 1e6]}).to_string();
    let registered = |name: &str, function, description: &str| {
        read(unsafe { clubface_fem_law(c(name).as_ptr(), function, c(description).as_ptr()) }).outcome
    };
    let shear = registered("mine", Some(rivlin), &description).unwrap()["shear"].as_f64().unwrap();
    // Twice the sum of both constants, by differences of the fourth order.
    assert!((shear / 10e6 - 1.0).abs() < 1e-11, "{shear}");
    let mut case = coarse_case();
    let peak = |case: &Value| {
        let case = c(&case.to_string());
        let answer = read(unsafe { clubface_fem(case.as_ptr(), None, null_mut()) });
        answer.outcome.unwrap()["peak_force"].as_f64().unwrap()
    };
    let built_in = peak(&case);
    case["ball"]["pieces"][0]["law"] = json!("mine");
    // The shear modulus is that of differences; rounding grows over the contact.
    assert!((peak(&case) / built_in - 1.0).abs() < 1e-9);

    let refused = |name, function, description: &str| {
        registered(name, function, description).unwrap_err()["input"].as_str().unwrap().to_owned()
    };
    assert_eq!(refused("linear", Some(rivlin), &description), "name");
    assert_eq!(refused("mine", None, &description), "function");
    assert_eq!(refused("mine", Some(rivlin), "{}"), "description");
    let soft = json!({"constants": ["c10", "c01"], "values": [-4e6, 1e6]}).to_string();
    assert_eq!(refused("mine", Some(rivlin), &soft), "law of mine");
}

#[test]
fn what_cannot_be_computed_names_the_input() {
    let (known, unknown) = (c("standard"), c("no such model"));
    let (inputs, parameters) = (shot(0, 9), named("standard").unwrap().info().defaults());
    let mut outputs = vec![0.0; OUTPUT_COUNT];
    let mut launch = |model: *const c_char, inputs: *const f64, rows, tolerance| {
        let (parameters, outputs) = (parameters.as_ptr(), outputs.as_mut_ptr());
        let answer =
            read(unsafe { clubface_launches(model, inputs, parameters, rows, tolerance, 1, outputs) });
        answer.outcome.unwrap_err()["input"].as_str().unwrap().to_owned()
    };
    assert_eq!(launch(unknown.as_ptr(), inputs.as_ptr(), 1, 0.0), "model");
    assert_eq!(launch(std::ptr::null(), inputs.as_ptr(), 1, 0.0), "model");
    assert_eq!(launch(known.as_ptr(), std::ptr::null(), 1, 0.0), "inputs");
    assert_eq!(launch(known.as_ptr(), inputs.as_ptr(), 0, 0.0), "rows");
    for tolerance in [0.5, -1e-6, f64::NAN] {
        assert_eq!(launch(known.as_ptr(), inputs.as_ptr(), 1, tolerance), "tolerance");
    }
    let mut case = coarse_case();
    case["ball"]["pieces"][0]["law"] = json!("rubber");
    let wrong = c(&case.to_string());
    let error = read(unsafe { clubface_fem(wrong.as_ptr(), None, null_mut()) }).outcome.unwrap_err();
    assert!(error["message"].as_str().unwrap().contains("mooney-rivlin"), "{error}");
    case["run"]["durations"] = json!(1.0);
    let wrong = c(&case.to_string());
    let error = read(unsafe { clubface_fem(wrong.as_ptr(), None, null_mut()) }).outcome.unwrap_err();
    assert!(error["message"].as_str().unwrap().contains("durations"), "{error}");
    let name = c("speed");
    assert_eq!(unsafe { clubface_column(ClubfaceColumns::Inputs as u32, name.as_ptr()) }, 0);
    assert_eq!(unsafe { clubface_column(ClubfaceColumns::Outputs as u32, name.as_ptr()) }, -1);
    assert_eq!(unsafe { clubface_column(7, name.as_ptr()) }, -1);
    unsafe { clubface_free(null_mut()) };
}

#[test]
fn a_contact_that_is_stepped_is_that_of_the_core() {
    let model = named("volumetric").unwrap();
    let (inputs, parameters) = (shot(0, 2), model.info().defaults());
    let normal = [inputs[24].cos(), inputs[24].sin(), 0.0];
    // The head stands at its loft, the ball lies at its face centre and 0.1 mm in it.
    let mut head = [0.0; CLUBFACE_HEAD];
    (0..3).for_each(|i| head[4 * i] = 1.0);
    (head[12], head[17]) = (45.0, 20.0);
    let mut ball = [0.0; CLUBFACE_BALL];
    (0..3).for_each(|i| ball[i] = inputs[15 + i] + normal[i] * (inputs[32] - 1e-4));
    let mut contact = null_mut();
    // SAFETY: arrays of the sizes that the interface asks for.
    unsafe {
        let begun = clubface_contact_begin(
            c("volumetric").as_ptr(),
            inputs.as_ptr(),
            parameters.as_ptr(),
            head.as_ptr(),
            ball.as_ptr(),
            &raw mut contact,
        );
        let begun = read(begun);
        let internal = begun.array("internal").2.clone();
        assert_eq!(begun.outcome.unwrap().as_array().unwrap().len(), internal.len());
        let core = HeadContact::<f64>::begin(model, &inputs, &parameters, &head, &ball).unwrap();
        assert_same(&internal, core.initial());
        let (mut wrench, mut rates) = ([f64::NAN; CLUBFACE_WRENCH], vec![f64::NAN; internal.len()]);
        clubface_contact_evaluate(
            contact,
            head.as_ptr(),
            ball.as_ptr(),
            internal.as_ptr(),
            wrench.as_mut_ptr(),
            rates.as_mut_ptr(),
        );
        let mut expected = vec![0.0; internal.len()];
        let acting =
            core.evaluate(&Head::from_values(&head), &Body::from_values(&ball), &internal, &mut expected);
        assert_same(&wrench, &acting.values());
        assert_same(&rates, &expected);
        assert!(wrench[0] > 1.0 && wrench[12] > 1.0, "{wrench:?}");
        let columns = 1 + CLUBFACE_MOTION + internal.len();
        let mut rows = vec![f64::NAN; (CLUBFACE_WRENCH + internal.len()) * columns];
        clubface_contact_jacobian(
            contact,
            head.as_ptr(),
            ball.as_ptr(),
            internal.as_ptr(),
            rows.as_mut_ptr(),
        );
        assert!((rows[0] - wrench[0]).abs() < 1e-9 * wrench[0] && rows.iter().all(|value| value.is_finite()));
        clubface_contact_end(contact);

        // The same head strikes the ball, from 20 us before.
        let mut struck = null_mut();
        let (name, start) = (c("volumetric"), ball.as_ptr());
        let placed = clubface_ball_place(
            name.as_ptr(),
            inputs.as_ptr(),
            parameters.as_ptr(),
            start,
            true,
            &raw mut struck,
        );
        assert!(read(placed).outcome.is_ok() && clubface_ball_phase(struck) == 0);
        head[9] -= 45.0 * 20e-6;
        let (mut loads, mut moved, mut launch) = ([0.0; CLUBFACE_STEP], ball, [0.0; OUTPUT_COUNT]);
        let (loads_at, moved_at) = (loads.as_mut_ptr(), moved.as_mut_ptr());
        assert!(!clubface_ball_launch(struck, launch.as_mut_ptr()));
        assert!(read(clubface_ball_advance(struck, head.as_ptr(), 1e-3, loads_at, moved_at)).outcome.is_ok());
        assert!(clubface_ball_launch(struck, launch.as_mut_ptr()) && clubface_ball_phase(struck) == 2);
        assert_eq!(launch[8], moved[3]);
        assert!((loads[0] * 1e-3 + inputs[31] * moved[3]).abs() < 1e-9, "momentum along x");
        head[0] = 2.0;
        let refused =
            read(clubface_ball_advance(struck, head.as_ptr(), 1e-6, loads_at, moved_at)).outcome.unwrap_err();
        assert_eq!(refused["input"], "head");
        clubface_ball_end(struck);
    }
}

#[test]
fn air_is_that_of_the_core() {
    assert_eq!(clubface_pressure_at_altitude(1600.0), flight::air::pressure_at_altitude(1600.0));
    assert_eq!(clubface_air_density(300.0, 9e4, 0.4), flight::air::density(300.0, 9e4, 0.4));
}

#[test]
fn the_header_is_that_of_the_crate() {
    let config = cbindgen::Config::from_file(Path::new(HERE).join("cbindgen.toml")).unwrap();
    let mut made = Vec::new();
    cbindgen::Builder::new().with_crate(HERE).with_config(config).generate().unwrap().write(&mut made);
    let made = String::from_utf8(made).unwrap();
    let path = Path::new(HERE).join("include/clubface.h");
    if std::env::var_os("CLUBFACE_WRITE_HEADER").is_some() {
        std::fs::write(&path, &made).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(kept == made, "write it anew: CLUBFACE_WRITE_HEADER=1 cargo test -p clubface-c");
}

/// The folder with the library that cargo built for this test.
fn library() -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let folders = test.ancestors().skip(1).take(2);
    let holds = |folder: &&Path| folder.join("libclubface.a").exists();
    folders.into_iter().find(holds).expect("cargo builds the library before its tests").to_owned()
}

#[test]
fn a_program_in_c_computes_the_same() {
    let (folder, program) = (library(), std::env::temp_dir().join(format!("drive-{}", std::process::id())));
    let compiled = Command::new("cc")
        .args(["-std=c11", "-Wall", "-Wextra", "-Werror", "-I"])
        .arg(Path::new(HERE).join("include"))
        .arg(Path::new(HERE).join("examples/drive.c"))
        .arg(folder.join("libclubface.a"))
        .args(["-lm", "-lpthread", "-ldl", "-o"])
        .arg(&program)
        .output()
        .expect("a C compiler is needed, which Rust links by as well");
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    let ran = Command::new(&program).output().unwrap();
    std::fs::remove_file(&program).ok();
    let printed = String::from_utf8(ran.stdout).unwrap();
    assert!(ran.status.success(), "{printed}{}", String::from_utf8_lossy(&ran.stderr));
    let mut inputs = shot(0, 9);
    for (name, value) in [("speed", 46.9392), ("toe", 0.005)] {
        inputs[INPUTS.iter().position(|input| input.quantity.name == name).unwrap()] = value;
    }
    let (outputs, _) = launches_by_core(named("response").unwrap(), &inputs, 1);
    let at = |name: &str| {
        let places = clubface_impact::launch::OUTPUTS.iter();
        outputs[places.into_iter().position(|each| each.name == name).unwrap()]
    };
    let rpm = at("backspin") * 60.0 / std::f64::consts::TAU;
    let expected = format!("ball speed {:.2} m/s, backspin {rpm:.0} rpm", at("ball_speed"));
    assert!(printed.contains(&expected), "{printed} instead of {expected}");
    assert!(printed.contains(r#"refused: {"input":"speed""#), "{printed}");
}
