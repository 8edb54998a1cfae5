//! A unit: its variables by value reference, and the ball behind them.

use clubface_impact::ImpactError;
use clubface_impact::launch::{OUTPUT_COUNT, OUTPUTS};
use clubface_impact::multibody::{BODY, HEAD};
use clubface_impact::registry::named;
use clubface_impact::shot::{INPUT_COUNT, INPUTS};
use clubface_impact::struck_ball::StruckBall;
use clubface_math::{Quat, Vec3};
use serde::Deserialize;
use std::collections::HashMap;
use std::path::Path;

/// What a unit is, as its exporter writes it.
#[derive(Clone, Debug, Deserialize)]
pub struct Setup {
    /// Name of a contact model.
    pub model: String,
    /// Inputs of a shot by name; those that are left out are zero, infinite radii are left out of JSON as null.
    pub inputs: HashMap<String, Option<f64>>,
    /// Parameters of the model by name.
    pub parameters: HashMap<String, f64>,
    /// Names of the variables in the order of their value references.
    pub variables: Vec<String>,
}

/// A variable.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Variable {
    Time,
    /// Of [`Unit::head`].
    Head(usize),
    /// Of [`Unit::start`]: where the ball lies.
    Start(usize),
    GivesWay,
    Input(usize),
    Parameter(usize),
    /// Of [`Unit::loads`].
    Load(usize),
    /// Of [`Unit::ball`].
    Ball(usize),
    Phase,
    Launch(usize),
}

/// Position, velocity and angular velocity of the head after its quaternion, real part first.
const HEAD_NAMES: [&str; 13] = [
    "head_qw", "head_qx", "head_qy", "head_qz", "head_x", "head_y", "head_z", "head_vx", "head_vy",
    "head_vz", "head_wx", "head_wy", "head_wz",
];
const START_NAMES: [&str; BODY] = [
    "ball_start_x",
    "ball_start_y",
    "ball_start_z",
    "ball_start_vx",
    "ball_start_vy",
    "ball_start_vz",
    "ball_start_wx",
    "ball_start_wy",
    "ball_start_wz",
];
const LOAD_NAMES: [&str; 8] =
    ["force_x", "force_y", "force_z", "torque_x", "torque_y", "torque_z", "normal_force", "penetration"];
const BALL_NAMES: [&str; BODY] =
    ["ball_x", "ball_y", "ball_z", "ball_vx", "ball_vy", "ball_vz", "ball_wx", "ball_wy", "ball_wz"];

/// What an operation of a unit returns when it fails: the message for the master's log.
pub type Outcome<T> = Result<T, String>;

/// One instance.
pub struct Unit {
    setup: Setup,
    variables: Vec<Variable>,
    inputs: [f64; INPUT_COUNT],
    parameters: Vec<f64>,
    gives_way: bool,
    head: [f64; 13],
    start: [f64; BODY],
    time: f64,
    struck: Option<StruckBall>,
    loads: [f64; 8],
    ball: [f64; BODY],
}

fn place(names: &[&str], name: &str) -> Option<usize> {
    names.iter().position(|each| *each == name)
}

fn words(error: &ImpactError) -> String {
    format!("{}: {}", error.input, error.message)
}

impl Unit {
    /// The unit that the folder of its resources describes.
    ///
    /// # Errors
    /// A folder without `impact.json`, or one that does not describe a unit.
    pub fn from_resources(folder: &Path) -> Outcome<Self> {
        let path = folder.join("impact.json");
        let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        let setup = serde_json::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))?;
        Self::new(setup)
    }

    /// The unit of this description.
    ///
    /// # Errors
    /// An unknown model or variable, or a parameter that is missing.
    pub fn new(setup: Setup) -> Outcome<Self> {
        let model = named(&setup.model).map_err(|e| words(&e))?;
        let parameters = model.info().parameters;
        let given = parameters.iter().map(|each| {
            let value = setup.parameters.get(each.name).copied();
            value.ok_or_else(|| format!("{}: missing", each.name))
        });
        let known = |name: &str| {
            let input = || INPUTS.iter().position(|input| input.quantity.name == name).map(Variable::Input);
            let parameter = || parameters.iter().position(|each| each.name == name).map(Variable::Parameter);
            let launch = || {
                let output = name.strip_prefix("launched_")?;
                OUTPUTS.iter().position(|each| each.name == output).map(Variable::Launch)
            };
            let found = match name {
                "time" => Some(Variable::Time),
                "phase" => Some(Variable::Phase),
                "head_gives_way" => Some(Variable::GivesWay),
                _ => place(&HEAD_NAMES, name).map(Variable::Head),
            };
            found
                .or_else(|| place(&START_NAMES, name).map(Variable::Start))
                .or_else(|| place(&LOAD_NAMES, name).map(Variable::Load))
                .or_else(|| place(&BALL_NAMES, name).map(Variable::Ball))
                .or_else(launch)
                .or_else(input)
                .or_else(parameter)
                .ok_or_else(|| format!("{name}: no variable of this unit"))
        };
        let mut unit = Self {
            variables: setup.variables.iter().map(|name| known(name)).collect::<Outcome<_>>()?,
            inputs: INPUTS.map(|input| {
                setup.inputs.get(input.quantity.name).map_or(0.0, |value| value.unwrap_or(f64::INFINITY))
            }),
            parameters: given.collect::<Outcome<_>>()?,
            gives_way: true,
            head: [0.0; 13],
            start: [0.0; BODY],
            time: 0.0,
            struck: None,
            loads: [0.0; 8],
            ball: [0.0; BODY],
            setup,
        };
        unit.head[0] = 1.0;
        Ok(unit)
    }

    /// The unit as it was when it was made.
    ///
    /// # Errors
    /// None that making it did not have.
    pub fn reset(&mut self) -> Outcome<()> {
        *self = Self::new(self.setup.clone())?;
        Ok(())
    }

    fn variable(&self, reference: u32) -> Outcome<Variable> {
        self.variables
            .get(reference as usize)
            .copied()
            .ok_or_else(|| format!("there is no variable {reference}"))
    }

    /// The value of a variable; before the ball has left the face, its launch is zero.
    ///
    /// # Errors
    /// A reference to no variable.
    pub fn get(&self, reference: u32) -> Outcome<f64> {
        Ok(match self.variable(reference)? {
            Variable::Time => self.time,
            Variable::Head(i) => self.head[i],
            Variable::Start(i) => self.start[i],
            Variable::GivesWay => f64::from(u8::from(self.gives_way)),
            Variable::Input(i) => self.inputs[i],
            Variable::Parameter(i) => self.parameters[i],
            Variable::Load(i) => self.loads[i],
            Variable::Ball(i) if self.struck.is_none() => self.start[i],
            Variable::Ball(i) => self.ball[i],
            Variable::Phase => self.struck.as_ref().map_or(0.0, |struck| f64::from(struck.phase() as i32)),
            Variable::Launch(i) => {
                let launch: Option<&[f64; OUTPUT_COUNT]> = self.struck.as_ref().and_then(StruckBall::launch);
                launch.map_or(0.0, |launch| launch[i])
            }
        })
    }

    /// Sets a variable: what describes club, ball and model before the first step, the head at any time.
    ///
    /// # Errors
    /// A variable that cannot be set, or not any more.
    pub fn set(&mut self, reference: u32, value: f64) -> Outcome<()> {
        let variable = self.variable(reference)?;
        if let Variable::Head(i) = variable {
            self.head[i] = value;
            return Ok(());
        }
        let name = &self.setup.variables[reference as usize];
        if self.struck.is_some() {
            return Err(format!("{name}: club, ball and model are fixed once the simulation has begun"));
        }
        match variable {
            Variable::Start(i) => self.start[i] = value,
            Variable::GivesWay => self.gives_way = value != 0.0,
            Variable::Input(i) => self.inputs[i] = value,
            Variable::Parameter(i) => self.parameters[i] = value,
            _ => return Err(format!("{name}: an output cannot be set")),
        }
        Ok(())
    }

    /// Places the ball: the simulation begins.
    ///
    /// # Errors
    /// A club, ball or parameter that cannot be.
    pub fn begin(&mut self, time: f64) -> Outcome<()> {
        let model = named(&self.setup.model).map_err(|e| words(&e))?;
        let struck = StruckBall::new(model, &self.inputs, &self.parameters, &self.start, self.gives_way);
        let struck = struck.map_err(|e| words(&e))?;
        self.ball = struck.ball().values();
        self.struck = Some(struck);
        self.time = time;
        Ok(())
    }

    /// Time of the master, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Moves the ball on by `duration` seconds with the head that was set.
    ///
    /// # Errors
    /// A head that is none, a step that is not allowed, or a simulation that has not begun.
    pub fn step(&mut self, duration: f64) -> Outcome<()> {
        let Some(struck) = &mut self.struck else { return Err("the simulation has not begun".into()) };
        let mut head = [0.0; HEAD];
        let turn = Quat { w: self.head[0], v: Vec3::from_slice(&self.head, 1) };
        if turn.w * turn.w + turn.v.norm_squared() <= 0.0 {
            return Err("head_qw: a quaternion of length 0; give one of any other length".into());
        }
        turn.matrix().rows.iter().enumerate().for_each(|(i, row)| row.put(&mut head, 3 * i));
        head[9..].copy_from_slice(&self.head[4..]);
        let step = struck.advance(&head, duration).map_err(|e| words(&e))?;
        step.force.put(&mut self.loads, 0);
        step.torque.put(&mut self.loads, 3);
        self.loads[6..].copy_from_slice(&[step.normal_force, step.depth]);
        self.ball = struck.ball().values();
        self.time += duration;
        Ok(())
    }
}
