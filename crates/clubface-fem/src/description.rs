//! Cases as plain data: what other languages write down of a ball, a head and a run. All values SI and radians.

use crate::FemError;
use crate::ball::{BallConstruction, BallPiece};
use crate::cases::{ball_against_deformable_head, ball_against_plane, ball_against_rigid_head};
use crate::contact::{ContactMethod, Grooves};
use crate::element::{DEFAULT_POINTS, Element, Isotropic, Rule, ShellMaterial};
use crate::environment::Environment;
use crate::head::{Bond, DeformableHead, Driver, ShellHead, ShellPart, SolidHead, SolidPart};
use crate::material::{
    Energy, Hardening, Hencky, Material, Maxwell, VolumeLaw, Volumetric, VonMises, law_from_name,
};
use crate::mesh::{DriverFineness, DriverShape, DriverThickness, ShellMesh, Target, Trim};
use crate::sensitivity::ImpactSetup;
use crate::solve::{Options, Recording, Simulation};
use clubface_impact::first_touch::FirstTouch;
use clubface_impact::shot::{INPUT_COUNT, Shot};
use clubface_math::Vec3;
use std::sync::Arc;

/// Declares structs that are read from data of other languages; an unknown field is an error.
macro_rules! described {
    ($($(#[$meta:meta])* $name:ident { $($(#[$doc:meta])* $field:ident: $type:ty,)+ })+) => {
        $(
            $(#[$meta])*
            #[derive(Clone, Debug)]
            #[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(deny_unknown_fields))]
            pub struct $name {
                $($(#[$doc])* pub $field: $type,)+
            }
        )+
    };
}

described! {
    /// One piece of a ball.
    PieceDescription {
        /// Its name, such as "core".
        name: String,
        /// Its outer radius, m.
        radius: f64,
        /// Layers of elements.
        layers: usize,
        /// Name of its elastic law.
        law: String,
        /// Constants of the law, in its order.
        constants: Vec<f64>,
        /// The energy whose constants they are, for the law "energy".
        energy: Option<String>,
        /// The energy of the change of volume, if it is not `bulk/2*(J - 1)^2`.
        volumetric: Option<String>,
        /// Bulk modulus, Pa.
        bulk: f64,
        /// Viscoelastic branches: shear modulus over that of the law, relaxation time (s).
        maxwell: Vec<(f64, f64)>,
        /// Density, kg/m3; that of the core follows from the mass of the ball, if this is given.
        density: f64,
    }

    /// A ball.
    BallDescription {
        /// Its pieces, from the core on.
        pieces: Vec<PieceDescription>,
        /// Elements along an edge of the cube in its middle.
        cube: usize,
        /// Name of its kind of element.
        element: String,
        /// Its mass, kg.
        mass: Option<f64>,
    }

    /// When and how a metal yields.
    PlasticDescription {
        /// Yield stress, Pa.
        yield_stress: f64,
        /// Plastic modulus, Pa.
        modulus: f64,
        /// Stress that it gains as it saturates, Pa; 0 for none.
        gain: f64,
        /// Rate of saturation over plastic strain.
        rate: f64,
        /// Plastic strains and yield stresses (Pa); empty where yield stress and modulus say it.
        table: Vec<(f64, f64)>,
    }

    /// Shells of a head that follow each other.
    PartDescription {
        /// Name, such as "crown".
        name: String,
        /// Number of shells.
        elements: usize,
        /// Young's modulus, Pa.
        youngs: f64,
        /// Poisson's ratio.
        poisson: f64,
        /// Density, kg/m3.
        density: f64,
        /// When it yields; never if left out.
        plastic: Option<PlasticDescription>,
        /// Points through the thickness.
        points: Option<usize>,
        /// Rule of these points.
        rule: String,
        /// Whether it meets the ball.
        face: bool,
    }

    /// A head of shells.
    ShellHeadDescription {
        /// Places of the nodes, m, three numbers each: x to the target, y up, z to the toe, from the face centre.
        nodes: Vec<f64>,
        /// Four nodes a shell, counterclockwise seen from outside.
        quads: Vec<u32>,
        /// Thickness of each shell, m.
        thickness: Vec<f64>,
        /// Mass added at each node, kg.
        added: Vec<f64>,
        /// Its parts, in the order of the shells.
        parts: Vec<PartDescription>,
        /// Static loft, rad.
        loft: f64,
    }

    /// Solid elements of a head that follow each other.
    SolidPartDescription {
        /// Name, such as "face".
        name: String,
        /// Number of hexahedra.
        hexahedra: usize,
        /// Name of the kind of hexahedra.
        element: String,
        /// Number of tetrahedra.
        tetrahedra: usize,
        /// Shear modulus, Pa.
        shear: f64,
        /// Bulk modulus, Pa.
        bulk: f64,
        /// Density, kg/m3.
        density: f64,
        /// When it yields; never if left out.
        plastic: Option<PlasticDescription>,
    }

    /// A surface of a part of a head that is bonded to that of another one.
    BondDescription {
        /// Name, such as "face to body".
        name: String,
        /// Number of the part.
        part: usize,
        /// Triangles of its surface.
        surface: Vec<u32>,
        /// Triangles of the other one.
        other: Vec<u32>,
        /// Largest distance between the two, m.
        within: f64,
    }

    /// A head of solid elements.
    SolidHeadDescription {
        /// Places of the nodes, m, as those of shells.
        nodes: Vec<f64>,
        /// Eight nodes a hexahedron, in binary order.
        hexahedra: Vec<u32>,
        /// Ten nodes a tetrahedron: corners, then the middles of the edges (0, 1), (1, 2), (2, 0), (0, 3), (1, 3) and (2, 3).
        tetrahedra: Vec<u32>,
        /// Its parts, in the order of the elements.
        parts: Vec<SolidPartDescription>,
        /// Bonds between parts.
        bonds: Vec<BondDescription>,
        /// Quadrilaterals of the face, counterclockwise seen from outside; a triangle has its last corner twice.
        face: Vec<u32>,
        /// Mass added at each node, kg.
        added: Vec<f64>,
        /// Static loft, rad.
        loft: f64,
        /// Grooves of the face; a plain face if left out.
        grooves: Option<Grooves>,
    }

    /// The design of a driver head of shells.
    DriverDescription {
        /// Its shape.
        shape: DriverShape,
        /// Elements from heel to toe, from sole to crown, and from face to back.
        elements: [usize; 3],
        /// Its walls before tuning, m.
        thickness: DriverThickness,
        /// Young's modulus (Pa), Poisson's ratio, density (kg/m3).
        metal: (f64, f64, f64),
        /// Limits of the factor on the thickness of crown, sole and skirt.
        scales: (f64, f64),
        /// Masses that may be added: name, place (m), most (kg).
        trims: Vec<(String, [f64; 3], f64)>,
        /// Mass properties to reach.
        target: Target,
    }

    /// A case: a ball, what it meets, and how to run it.
    CaseDescription {
        /// The ball.
        ball: BallDescription,
        /// What it meets.
        face: FaceDescription,
        /// Coefficient of Coulomb friction.
        friction: f64,
        /// How to run it.
        run: RunDescription,
    }
}

/// A head that deforms.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum HeadDescription {
    /// A mesh of shells.
    Shells(ShellHeadDescription),
    /// A mesh of hexahedra and tetrahedra.
    Solid(SolidHeadDescription),
    /// A driver that is meshed here.
    Driver(DriverDescription),
}

/// What a ball meets.
#[derive(Clone, Debug)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Deserialize),
    serde(rename_all = "snake_case", deny_unknown_fields)
)]
pub enum FaceDescription {
    /// A rigid plane, at which the ball is thrown.
    Plane {
        /// Speed, m/s.
        speed: f64,
        /// Angle between velocity and normal, rad.
        angle: f64,
    },
    /// A head that hits the ball.
    Head {
        /// The shot, in the order of [`INPUTS`](clubface_impact::shot::INPUTS); mass, radius and inertia of the ball come
        /// from the mesh.
        inputs: Vec<f64>,
        /// The mesh of the head, whose mass properties those of the inputs must be; a rigid head if left out.
        mesh: Option<Box<HeadDescription>>,
    },
}

/// How to run a case; a field that is left out has its default.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize), serde(default, deny_unknown_fields))]
pub struct RunDescription {
    /// Simulated time, s.
    pub duration: f64,
    /// Time step over the stable step of the undeformed structure; what impacts usually allow if left out.
    pub safety: Option<f64>,
    /// Interval of the motion records, s.
    pub interval: f64,
    /// Whether to end soon after the last touch.
    pub until_separation: bool,
    /// Name of the contact method.
    pub contact: String,
    /// Linear bulk viscosity.
    pub bulk_viscosity: f64,
    /// Threads; 0 for one a core.
    pub threads: usize,
    /// Deformed shapes to keep.
    pub frames: usize,
    /// Whether to keep stress and strain with them.
    pub fields: bool,
}

impl Default for RunDescription {
    fn default() -> Self {
        let Options { duration, safety, interval, until_separation, contact, bulk_viscosity, .. } =
            Options::default();
        Self {
            duration,
            safety,
            interval,
            until_separation,
            contact: contact.name().into(),
            bulk_viscosity,
            threads: 0,
            frames: 0,
            fields: false,
        }
    }
}

impl RunDescription {
    /// The options of the run.
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown contact method.
    pub fn options(&self) -> Result<Options, FemError> {
        Ok(Options {
            duration: self.duration,
            safety: self.safety,
            interval: self.interval,
            until_separation: self.until_separation,
            contact: ContactMethod::from_name(&self.contact)?,
            bulk_viscosity: self.bulk_viscosity,
            ..Options::default()
        })
    }

    /// What to keep of it.
    #[must_use]
    pub fn recording(&self) -> Recording {
        Recording { frames: self.frames, fields: self.fields }
    }
}

impl CaseDescription {
    /// The shot whose launch is differentiated.
    ///
    /// # Errors
    /// [`FemError::Input`] that names what cannot be built, and for a face that is neither rigid nor of shells.
    pub fn setup(&self) -> Result<ImpactSetup, FemError> {
        let FaceDescription::Head { inputs, mesh } = &self.face else {
            return Err(FemError::input("face", "a plane", "only shots of a head are differentiated"));
        };
        let head = match mesh.as_deref() {
            None => None,
            Some(HeadDescription::Shells(shells)) => Some(shells.build()?),
            Some(HeadDescription::Driver(driver)) => Some(driver.build().mesh()?.head),
            Some(HeadDescription::Solid(_)) => {
                let allowed = "only shots of a rigid head or of shells are differentiated";
                return Err(FemError::input("face", "a solid head", allowed));
            }
        };
        let inputs = *shot_inputs(inputs)?;
        Ok(ImpactSetup { ball: self.ball.build()?, head, inputs, friction: self.friction })
    }

    /// The simulation, and both bodies at first touch where a head hits the ball.
    ///
    /// # Errors
    /// [`FemError::Input`] that names what cannot be built.
    pub fn simulation(
        &self,
        environment: &Environment,
    ) -> Result<(Simulation<f64>, Option<FirstTouch<f64>>), FemError> {
        let ball = self.ball.build()?;
        match &self.face {
            FaceDescription::Plane { speed, angle } => {
                Ok((ball_against_plane(&ball, *speed, *angle, self.friction, environment)?, None))
            }
            FaceDescription::Head { inputs, mesh } => {
                let touch = first_touch(inputs)?;
                let simulation = match mesh {
                    None => ball_against_rigid_head(&ball, &touch, self.friction, environment)?,
                    Some(mesh) => {
                        let head = mesh.build()?;
                        ball_against_deformable_head(&*head, &ball, &touch, self.friction, environment)?
                    }
                };
                Ok((simulation, Some(touch)))
            }
        }
    }
}

/// Both bodies at first touch, for inputs in the order of [`INPUTS`](clubface_impact::shot::INPUTS).
///
/// # Errors
/// [`FemError::Input`] for inputs that are not allowed.
fn first_touch(inputs: &[f64]) -> Result<FirstTouch<f64>, FemError> {
    Ok(FirstTouch::from_shot(&Shot::from_inputs(shot_inputs(inputs)?)))
}

/// Inputs of a shot, checked.
///
/// # Errors
/// [`FemError::Input`] for inputs that are not allowed.
fn shot_inputs(inputs: &[f64]) -> Result<&[f64; INPUT_COUNT], FemError> {
    let inputs = inputs.try_into().map_err(|_| FemError::input("inputs", "", "all are needed"))?;
    clubface_impact::check::check(inputs).map_err(|e| FemError::input(e.input, "", e.message))?;
    Ok(inputs)
}

impl BallDescription {
    /// The ball.
    ///
    /// # Errors
    /// [`FemError::Input`] for an unknown law or element, or constants that a law does not allow.
    pub fn build(&self) -> Result<BallConstruction<f64>, FemError> {
        let mut pieces = Vec::new();
        for piece in &self.pieces {
            let law = match &piece.energy {
                Some(energy) => Arc::new(Energy::new(energy)?).law(&piece.constants)?,
                None => law_from_name(&piece.law, &piece.constants)?,
            };
            let law = match &piece.volumetric {
                Some(text) => VolumeLaw::over(law, &Arc::new(Volumetric::new(text)?)),
                None => law,
            };
            let maxwell = piece.maxwell.iter().map(|&(modulus, time)| Maxwell { modulus, time }).collect();
            let material = Material { law, bulk: piece.bulk, maxwell, density: piece.density };
            let (radius, layers) = (piece.radius, piece.layers);
            pieces.push(BallPiece { name: piece.name.clone(), radius, layers, material });
        }
        let element = Element::from_name(&self.element)?;
        Ok(BallConstruction { pieces, cube: self.cube, element, mass: self.mass })
    }
}

impl PlasticDescription {
    /// The hardening of a metal; `name` of the part is for errors.
    ///
    /// # Errors
    /// [`FemError::Input`] for a table that is not allowed.
    pub fn build(&self, name: &str) -> Result<Hardening<f64>, FemError> {
        let law = if self.table.is_empty() {
            Hardening::linear(self.yield_stress, self.modulus)
        } else {
            Hardening::table(&self.table, name)?
        };
        Ok(if self.gain > 0.0 { law.saturating(self.gain, self.rate) } else { law })
    }
}

impl HeadDescription {
    /// The head.
    ///
    /// # Errors
    /// [`FemError::Input`] for arrays that do not belong to one mesh, or values that are not allowed.
    pub fn build(&self) -> Result<Box<dyn DeformableHead<f64>>, FemError> {
        Ok(match self {
            Self::Shells(shells) => Box::new(shells.build()?),
            Self::Solid(solid) => Box::new(solid.build()?),
            Self::Driver(driver) => Box::new(driver.build().mesh()?.head),
        })
    }
}

impl ShellHeadDescription {
    /// The head.
    ///
    /// # Errors
    /// As [`HeadDescription::build`].
    pub fn build(&self) -> Result<ShellHead<f64>, FemError> {
        let (nodes, quads) = (places(&self.nodes), groups::<4>(&self.quads));
        let (thickness, added) = (self.thickness.clone(), self.added.clone());
        let (mut parts, mut start) = (Vec::new(), 0);
        for part in &self.parts {
            let elements = start..start + part.elements;
            start = elements.end;
            parts.push(ShellPart {
                name: part.name.clone(),
                elements,
                material: part.material()?,
                face: part.face,
            });
        }
        let count = nodes.len();
        let named = quads.iter().flatten().all(|&n| (n as usize) < count);
        check_one_mesh(start == quads.len() && thickness.len() == start && added.len() == count && named)?;
        Ok(ShellHead { shells: ShellMesh { nodes, quads, thickness }, parts, added, loft: self.loft })
    }
}

impl PartDescription {
    fn material(&self) -> Result<ShellMaterial<f64>, FemError> {
        let elastic = Isotropic { young: self.youngs, poisson: self.poisson };
        let hardening = self.plastic.as_ref().map(|plastic| plastic.build(&self.name)).transpose()?;
        let points = self.points.or(hardening.map(|_| DEFAULT_POINTS));
        let points = points.map(|points| Rule::from_name(&self.rule, points)).transpose()?;
        Ok(ShellMaterial { elastic, density: self.density, hardening, points })
    }
}

impl SolidPartDescription {
    fn material(&self) -> Result<Material<f64>, FemError> {
        let shear = self.shear;
        let law = match &self.plastic {
            None => Hencky { shear }.law(),
            Some(plastic) => VonMises { shear, hardening: plastic.build(&self.name)? }.law(),
        };
        Ok(Material { law, bulk: self.bulk, maxwell: vec![], density: self.density })
    }
}

impl SolidHeadDescription {
    /// The head.
    ///
    /// # Errors
    /// As [`HeadDescription::build`].
    pub fn build(&self) -> Result<SolidHead<f64>, FemError> {
        let (nodes, added) = (places(&self.nodes), self.added.clone());
        let (hexahedra, tetrahedra) = (groups(&self.hexahedra), groups(&self.tetrahedra));
        let (mut parts, mut bonds) = (Vec::new(), Vec::new());
        let (mut hexes, mut tets) = (0, 0);
        for part in &self.parts {
            parts.push(SolidPart {
                name: part.name.clone(),
                hexahedra: hexes..hexes + part.hexahedra,
                element: Element::from_name(&part.element)?,
                tetrahedra: tets..tets + part.tetrahedra,
                material: part.material()?,
            });
            (hexes, tets) = (hexes + part.hexahedra, tets + part.tetrahedra);
        }
        for bond in &self.bonds {
            let (surface, other) = (groups(&bond.surface), groups(&bond.other));
            bonds.push(Bond {
                name: bond.name.clone(),
                part: bond.part,
                surface,
                other,
                within: bond.within,
            });
        }
        let count = nodes.len();
        let of_bonds = self.bonds.iter().flat_map(|bond| bond.surface.iter().chain(&bond.other));
        let mut named = self.hexahedra.iter().chain(&self.tetrahedra).chain(&self.face).chain(of_bonds);
        let whole = hexes == hexahedra.len() && tets == tetrahedra.len() && added.len() == count;
        check_one_mesh(
            whole
                && named.all(|&n| (n as usize) < count)
                && bonds.iter().all(|bond: &Bond| bond.part < parts.len()),
        )?;
        let (face, ties) = (groups(&self.face), Vec::new());
        let (grooves, loft) = (self.grooves, self.loft);
        let mut head = SolidHead { nodes, hexahedra, tetrahedra, parts, face, grooves, added, loft, ties };
        head.bond(&bonds)?;
        Ok(head)
    }
}

impl DriverDescription {
    /// The design.
    #[must_use]
    pub fn build(&self) -> Driver<f64> {
        let (young, poisson, density) = self.metal;
        let trims = self.trims.iter().cloned();
        Driver {
            shape: self.shape,
            fineness: DriverFineness(self.elements),
            thickness: self.thickness,
            metal: ShellMaterial::elastic(Isotropic { young, poisson }, density),
            scales: self.scales,
            trims: trims.map(|(name, at, most)| Trim { name, at: Vec3::from_f64(at), most }).collect(),
            target: self.target,
        }
    }
}

fn places(values: &[f64]) -> Vec<Vec3<f64>> {
    values.chunks_exact(3).map(|p| Vec3::new(p[0], p[1], p[2])).collect()
}

fn groups<const N: usize>(values: &[u32]) -> Vec<[u32; N]> {
    values.chunks_exact(N).map(|group| std::array::from_fn(|i| group[i])).collect()
}

fn check_one_mesh(fits: bool) -> Result<(), FemError> {
    let error = || FemError::input("mesh of the head", "", "its arrays must belong to one mesh");
    if fits { Ok(()) } else { Err(error()) }
}
