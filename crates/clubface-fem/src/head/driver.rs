//! A driver head of shells: shape, thickness and metal, brought to its mass and inertia.

use super::{ShellHead, ShellPart, face_axes};
use crate::element::{Isotropic, ShellMaterial};
use crate::error::FemError;
use crate::mesh::{
    DriverFineness, DriverShape, DriverThickness, Region, Target, Trim, Tuned, check_wall, tune,
};
use clubface_math::{Real, Vec3};

/// The design of a driver head.
#[derive(Clone, Debug)]
pub struct Driver<R> {
    /// Shape.
    pub shape: DriverShape,
    /// Elements.
    pub fineness: DriverFineness,
    /// Thickness before tuning.
    pub thickness: DriverThickness,
    /// Metal.
    pub metal: ShellMaterial<R>,
    /// Limits of the factor on the thickness of crown, sole and skirt; that of the face stays.
    pub scales: (f64, f64),
    /// Masses that may be added.
    pub trims: Vec<Trim>,
    /// Mass properties to reach.
    pub target: Target,
}

/// A driver head, meshed and tuned.
#[derive(Clone, Debug)]
pub struct MeshedDriver<R> {
    /// The head, with one part for each region.
    pub head: ShellHead<R>,
    /// Result of the tuning.
    pub tuned: Tuned,
}

impl<R: Real> Driver<R> {
    /// The head of Roh and Lee as far as they describe it: 210 g, loft 11.5 deg, 3264 shells, moment of inertia 1526 g
    /// cm2. They do not say about which axis. About the vertical no head of a driver's size has so little, but about
    /// the axis from heel to toe drivers of that time have, so this axis is assumed. The rest is chosen here: titanium,
    /// a shape of about 240 cm3, usual walls, and the mass centre on the face normal through the face centre.
    #[must_use]
    pub fn roh_and_lee() -> Self {
        let shape = DriverShape {
            loft: 11.5_f64.to_radians(),
            bulge: 0.305,
            roll: 0.305,
            width: 0.1025,
            depth: 0.074,
            crown: 0.025,
            sole: 0.023,
            rounding: 0.008,
        };
        let trim = |name: &str, at: [f64; 3]| Trim { name: name.into(), at: Vec3::from_f64(at), most: 0.06 };
        Self {
            shape,
            fineness: DriverFineness::default(),
            thickness: DriverThickness {
                face_centre: 3.2e-3,
                face_edge: 2.4e-3,
                crown: 1.3e-3,
                sole: 1.6e-3,
                skirt: 1.4e-3,
            },
            metal: ShellMaterial::elastic(
                Isotropic { young: R::from_f64(114e9), poisson: R::from_f64(0.34) },
                R::from_f64(4430.0),
            ),
            scales: (0.5, 2.0),
            trims: vec![
                trim("sole", [-0.033, -0.023, 0.0]),
                trim("sole front", [-0.008, -0.021, 0.0]),
                trim("back", [-0.074, 0.0, 0.0]),
                trim("heel", [-0.015, 0.008, -0.051]),
                trim("toe", [-0.022, 0.0, 0.051]),
            ],
            target: Target {
                mass: 0.210,
                centre: [None, None, Some(0.0)],
                above: Some(0.0),
                inertia: [None, None, Some(1526e-7)],
            },
        }
    }

    /// Checks that the head can be meshed.
    ///
    /// # Errors
    /// [`FemError::Input`] that names the first value that is not allowed.
    pub fn check(&self) -> Result<(), FemError> {
        let t = &self.thickness;
        let walls = [
            ("thickness.face_centre", t.face_centre),
            ("thickness.face_edge", t.face_edge),
            ("thickness.crown", t.crown),
            ("thickness.sole", t.sole),
            ("thickness.skirt", t.skirt),
        ];
        for (name, value) in walls {
            check_wall(name, value, "")?;
        }
        self.metal.check("metal")?;
        if self.fineness.0.iter().any(|n| !(4..=400).contains(n)) {
            let value = format!("{:?}", self.fineness.0);
            let allowed = "each of the three numbers must be from 4 to 400";
            return Err(FemError::input("elements", value, allowed));
        }
        Ok(())
    }

    /// Meshes and tunes the head.
    ///
    /// # Errors
    /// As [`Driver::check`].
    pub fn mesh(&self) -> Result<MeshedDriver<R>, FemError> {
        self.check()?;
        let mut mesh = self.shape.mesh::<R>(self.fineness, &self.thickness);
        let body = |element: usize| mesh.regions[element] != Region::Face;
        let body: Vec<bool> = (0..mesh.regions.len()).map(body).collect();
        let [_, up, _] = face_axes(self.shape.loft);
        let density = self.metal.density.re();
        let tuned = tune(&mut mesh.shells, &body, density, self.scales, &self.trims, &self.target, up);
        let (mut parts, mut start) = (Vec::new(), 0);
        for region in Region::ALL {
            let end = start + mesh.regions.iter().filter(|&&r| r == region).count();
            let (name, face) = (region.name().to_owned(), region == Region::Face);
            parts.push(ShellPart { name, elements: start..end, material: self.metal.clone(), face });
            start = end;
        }
        let added = tuned.added.clone();
        Ok(MeshedDriver {
            head: ShellHead { shells: mesh.shells, parts, added, loft: self.shape.loft },
            tuned,
        })
    }
}
