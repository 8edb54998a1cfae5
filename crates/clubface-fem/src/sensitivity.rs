//! Derivatives of the launch with respect to everything that goes into an impact with a head: the same code runs on
//! dual numbers.

use crate::ball::{BallConstruction, BallPiece};
use crate::cases::{deformable_head_in_steps, rigid_head_in_steps};
use crate::element::{Isotropic, Kernels, ShellMaterial};
use crate::environment::Environment;
use crate::error::FemError;
use crate::head::{ShellHead, ShellPart};
use crate::material::{Material, Maxwell, map_law};
use crate::mesh::ShellMesh;
use crate::solve::{Options, Progress, Simulation, Snapshot};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::shot::{INPUT_COUNT, INPUTS, Shot};
use clubface_math::Dual;

/// Number of derivatives in one run.
const WIDTH: usize = 4;

/// A shot whose launch is differentiated.
#[derive(Clone, Debug)]
pub struct ImpactSetup {
    /// The ball.
    pub ball: BallConstruction<f64>,
    /// The head, if it is one of shells: then the clubhead of `inputs` is that of its mesh, and no variable.
    pub head: Option<ShellHead<f64>>,
    /// Delivery, club and ball in the order of [`INPUTS`]; those of the ball are not used, as its pieces say more.
    pub inputs: [f64; INPUT_COUNT],
    /// Coefficient of friction.
    pub friction: f64,
}

/// A direction in which a launch is differentiated: variables, and how much each changes.
pub type Direction = Vec<(String, f64)>;

/// Launch and its derivatives.
#[derive(Clone, Debug)]
pub struct Sensitivity {
    /// Launch, in the order of [`clubface_impact::launch::OUTPUTS`].
    pub values: [f64; OUTPUT_COUNT],
    /// Derivatives by outputs, then by the directions asked for.
    pub jacobian: Vec<Vec<f64>>,
}

impl ImpactSetup {
    /// Names of all variables: inputs that are differentiable, "friction", constants of the pieces such as
    /// "cover.shear", and those of parts of a head such as "head.face.thickness", the mean over the part.
    #[must_use]
    pub fn variables(&self) -> Vec<String> {
        let mut names = Vec::new();
        self.lift(&mut |name, value| {
            names.push(name.to_owned());
            value
        });
        names
    }

    /// The same setting in another number, each variable made by `number` from its name and value.
    fn lift<R: Kernels>(&self, number: &mut dyn FnMut(&str, f64) -> R) -> Lifted<R> {
        let groups = if self.head.is_some() { &["delivery"][..] } else { &["delivery", "club"] };
        let inputs = std::array::from_fn(|i| {
            let input = &INPUTS[i];
            if input.differentiable && groups.contains(&input.group) {
                number(input.quantity.name, self.inputs[i])
            } else {
                R::from_f64(self.inputs[i])
            }
        });
        let friction = number("friction", self.friction);
        let pieces = self.ball.pieces.iter().map(|piece| lift_piece(piece, number)).collect();
        let ball = BallConstruction {
            pieces,
            cube: self.ball.cube,
            element: self.ball.element,
            mass: self.ball.mass,
        };
        let head = self.head.as_ref().map(|head| lift_head(head, number));
        Lifted { ball, head, touch: FirstTouch::from_shot(&Shot::from_inputs(&inputs)), friction }
    }

    /// Launch and its derivatives in some directions of [`ImpactSetup::variables`]; a run of the impact for every four.
    /// `observer` is called with the number of the run and its progress, and stops everything by returning false.
    ///
    /// # Errors
    /// [`FemError`] of a setting that cannot run, of an unknown variable, or of a run that stopped early.
    pub fn sensitivity(
        &self,
        directions: &[Direction],
        options: &Options,
        environment: &Environment,
        observer: &mut dyn FnMut(usize, &Progress) -> bool,
    ) -> Result<Sensitivity, FemError> {
        let known = self.variables();
        let mut names = directions.iter().flatten().map(|(name, _)| name);
        if let Some(unknown) = names.find(|name| !known.contains(name)) {
            return Err(FemError::unknown("variable", unknown, known.iter().map(String::as_str)));
        }
        let mut computed =
            Sensitivity { values: [f64::NAN; OUTPUT_COUNT], jacobian: vec![Vec::new(); OUTPUT_COUNT] };
        options.check()?;
        // The time step follows from values alone, which plain numbers give sooner.
        let mut plain = self.lift(&mut |_, value| value).simulation(None, environment)?;
        let (stable, step) = (plain.ball_stable_step, plain.choose_step(options));
        for (run, group) in directions.chunks(WIDTH).enumerate() {
            let lifted = self.lift(&mut |name, value| {
                let mut number = Dual::<f64, WIDTH>::constant(value);
                for (direction, tangent) in group.iter().zip(&mut number.tangent) {
                    *tangent =
                        direction.iter().filter(|(each, _)| each == name).map(|(_, change)| change).sum();
                }
                number
            });
            let mut simulation = lifted.simulation(Some(stable), environment)?;
            let mut watch = |snapshot: Snapshot<_>| observer(run, &snapshot.progress);
            let result = simulation.run_in_steps(options, step.clone(), &mut watch)?;
            if let Some(stopped) = result.stopped {
                return Err(stopped);
            }
            for (row, output) in lifted.touch.launch(result.ball, result.head).outputs().iter().enumerate() {
                computed.values[row] = output.value;
                computed.jacobian[row].extend_from_slice(&output.tangent[..group.len()]);
            }
        }
        Ok(computed)
    }
}

/// A setting in numbers with derivatives.
struct Lifted<R> {
    ball: BallConstruction<R>,
    head: Option<ShellHead<R>>,
    touch: FirstTouch<R>,
    friction: R,
}

impl<R: Kernels> Lifted<R> {
    /// The impact, given the stable time step of the ball, s, if it is known.
    fn simulation(&self, stable: Option<f64>, environment: &Environment) -> Result<Simulation<R>, FemError> {
        let Self { ball, head, touch, friction } = self;
        match head {
            Some(head) => deformable_head_in_steps(head, ball, touch, *friction, stable, environment),
            None => rigid_head_in_steps(ball, touch, *friction, stable, environment),
        }
    }
}

fn lift_head<R: Kernels>(head: &ShellHead<f64>, number: &mut dyn FnMut(&str, f64) -> R) -> ShellHead<R> {
    let mut thickness: Vec<R> = head.shells.thickness.iter().map(|&t| R::from_f64(t)).collect();
    let mut parts = Vec::new();
    for part in head.parts.iter().filter(|part| !part.elements.is_empty()) {
        let mut variable =
            |constant: &str, value: f64| number(&format!("head.{}.{constant}", part.name), value);
        let walls = &mut thickness[part.elements.clone()];
        let mean = walls.iter().map(|t| t.re()).sum::<f64>() / walls.len() as f64;
        let factor = variable("thickness", mean) * mean.recip();
        walls.iter_mut().for_each(|t| *t = *t * factor);
        let Isotropic { young, poisson } = part.material.elastic;
        let elastic = Isotropic { young: variable("youngs", young), poisson: variable("poisson", poisson) };
        let ShellMaterial { density, hardening, points, .. } = &part.material;
        let density = variable("density", *density);
        let hardening = hardening.map(|law| law.map(&mut variable));
        let material = ShellMaterial { elastic, density, hardening, points: *points };
        parts.push(ShellPart {
            name: part.name.clone(),
            elements: part.elements.clone(),
            material,
            face: part.face,
        });
    }
    let ShellMesh { nodes, quads, .. } = head.shells.clone();
    let shells = ShellMesh { nodes, quads, thickness };
    ShellHead { shells, parts, added: head.added.clone(), loft: head.loft }
}

fn lift_piece<R: Kernels>(piece: &BallPiece<f64>, number: &mut dyn FnMut(&str, f64) -> R) -> BallPiece<R> {
    let name = &piece.name;
    let BallPiece { radius, layers, material, .. } = piece;
    let mut variable = |constant: &str, value: f64| number(&format!("{name}.{constant}"), value);
    let maxwell = material
        .maxwell
        .iter()
        .enumerate()
        .map(|(i, branch)| Maxwell {
            modulus: variable(&format!("maxwell.{i}.modulus"), branch.modulus),
            time: variable(&format!("maxwell.{i}.time"), branch.time),
        })
        .collect();
    let law = map_law(&*material.law, &mut variable);
    let material = Material {
        law,
        bulk: variable("bulk", material.bulk),
        maxwell,
        density: variable("density", material.density),
    };
    let radius = variable("radius", *radius);
    BallPiece { name: name.clone(), radius, layers: *layers, material }
}
