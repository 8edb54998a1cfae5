//! What happens at the integration points of a pack of one-point hexahedra, however the elements find their nodes.

use super::bulk_viscosity::{BulkViscosity, Drag};
use super::one_point::Hexahedron;
use super::one_point_constants::{Constants, CONSTANTS, SHAPES, SKEW};
use super::{Aligned, Energy, BLOCK, RATIOS};
use crate::material::{Deformation, InelasticLaw, Isochoric, Kinematics, StateVariables, Symmetric};
use clubface_math::{Pack, Real};

/// Constants of the elements of a block.
pub type Block<R> = Aligned<[R; CONSTANTS * BLOCK]>;

/// How far constants may differ that are the same but for the rounding of positions: those of a ball half a metre from the origin have lost 5e-17 m, of edges
/// of a tenth of a millimetre, and differences of differences lose a hundred times that.
const ROUNDING: f64 = 1e-10;

/// Whether constants and their derivatives are the same to rounding.
pub fn alike<R: Real>(a: &[Block<R>], b: &[Block<R>]) -> bool {
    // Beside the largest of its kind: values and derivatives of a constant are kinds of their own. Those of the inverse Jacobian are of one kind.
    let count = numbers(&R::zero()).count();
    let kind = |at: usize| if at < SKEW * BLOCK { 0 } else { at / BLOCK * count };
    let mut largest = vec![0.0_f64; CONSTANTS * count];
    for (at, value) in a.iter().flat_map(|block| block.0.iter().enumerate()) {
        for (largest, number) in largest[kind(at)..].iter_mut().zip(numbers(value)) {
            *largest = largest.max(number.abs());
        }
    }
    a.len() == b.len()
        && a.iter().zip(b).all(|(a, b)| {
            (0..CONSTANTS * BLOCK).all(|at| {
                // Shapes of hourglass patterns are relative to the edges; they may all be zero but for rounding.
                let least = if (SKEW * BLOCK..SHAPES * BLOCK).contains(&at) { 1.0 } else { 0.0 };
                let sizes = &largest[kind(at)..];
                numbers(&(a.0[at] - b.0[at]))
                    .zip(sizes)
                    .all(|(off, size)| off.abs() <= ROUNDING * size.max(least))
            })
        })
}

/// Value and derivatives.
fn numbers<R: Real>(value: &R) -> impl Iterator<Item = f64> + '_ {
    std::iter::once(value.re()).chain(value.derivatives().iter().copied())
}

/// Stress at the points of packs of elements.
pub trait Points<P: Pack> {
    /// Second Piola-Kirchhoff stress (Pa) times minus the reference volume (m3) at the points of lanes `first..` of a block; state variables move on by a step.
    fn stress(&mut self, block: usize, first: usize, volume: P, at: &Deformation<P>) -> Symmetric<P>;
}

/// Smallest and largest ratio of current to reference volume of some elements.
#[derive(Clone, Copy)]
pub struct Ratios<P> {
    least: P,
    most: P,
}

impl<P: Pack> Ratios<P> {
    /// Of undeformed elements.
    #[inline(always)]
    pub fn new() -> Self {
        Self { least: P::one(), most: P::one() }
    }
    /// With those of a pack.
    #[inline(always)]
    pub fn and(self, ratio: P) -> Self {
        Self { least: self.least.min(ratio), most: self.most.max(ratio) }
    }
    /// Whether the laws hold for all of them.
    #[inline(always)]
    pub fn valid(self) -> bool {
        (0..P::LANES).all(|lane| self.least.lane(lane) >= RATIOS.0 && self.most.lane(lane) <= RATIOS.1)
    }
    /// Both, of all lanes.
    #[inline(always)]
    pub fn range(self) -> (f64, f64) {
        (0..P::LANES).fold((1.0, 1.0), |(least, most): (f64, f64), lane| {
            (least.min(self.least.lane(lane)), most.max(self.most.lane(lane)))
        })
    }
}

/// Something that looks at packs of elements.
pub trait Visitor<P: Pack> {
    /// Looks at lanes `first..` of a block.
    fn visit(&mut self, block: usize, first: usize, constants: &Constants<P>, element: &Hexahedron<P>);
}

/// Elements without memory.
pub struct Elastic<'a, P: Pack, L> {
    /// Law of the change of shape.
    pub law: L,
    /// Bulk modulus, Pa.
    pub bulk: P,
    /// Bulk viscosity, if there is any.
    pub drag: Option<Drag<'a, P::Real>>,
}

impl<P: Pack, L: Isochoric<P>> Points<P> for Elastic<'_, P, L> {
    #[inline(always)]
    fn stress(&mut self, block: usize, first: usize, volume: P, at: &Deformation<P>) -> Symmetric<P> {
        let mut pressure = self.bulk * (at.volume - 1.0);
        if let Some(drag) = &mut self.drag {
            pressure += drag.pressure(block, first, at.volume);
        }
        self.law.second_piola(at, pressure, -volume)
    }
}

/// Elements that remember: with viscoelastic branches, or of metal that yields.
pub struct Inelastic<'a, P: Pack, M> {
    /// Law of the change of shape.
    pub law: M,
    /// Bulk modulus, Pa.
    pub bulk: P,
    /// StateVariables of all blocks.
    pub state: &'a mut StateVariables<P::Real>,
    /// Bulk viscosity, if there is any.
    pub drag: Option<Drag<'a, P::Real>>,
}

impl<P: Pack, M: InelasticLaw<P>> Points<P> for Inelastic<'_, P, M> {
    #[inline(always)]
    fn stress(&mut self, block: usize, first: usize, volume: P, at: &Deformation<P>) -> Symmetric<P> {
        let kinematics = Kinematics::of(*at);
        let stress = self.law.advance(&kinematics, &mut self.state.of(block, first));
        let mut pressure = self.bulk * (at.volume - 1.0);
        if let Some(drag) = &mut self.drag {
            pressure += drag.pressure(block, first, at.volume);
        }
        kinematics.second_piola(&stress, pressure, -volume)
    }
}

/// Energies and volumes of elements.
pub struct EnergyVisitor<'a, P: Pack, M> {
    /// Law of the change of shape.
    pub law: M,
    /// Bulk modulus, Pa.
    pub bulk: P,
    /// StateVariables of all blocks.
    pub state: &'a mut StateVariables<P::Real>,
    /// Bulk viscosity, if there is any.
    pub viscosity: Option<&'a BulkViscosity<P::Real>>,
    /// Sums by lane, J: strain, hourglass, viscous and plastic energy.
    pub energies: [P; 4],
    /// Smallest and largest ratio of current to reference volume, by lane.
    pub ratios: Ratios<P>,
}

impl<P: Pack, M> EnergyVisitor<'_, P, M> {
    /// Energies, J, and the smallest and largest ratio.
    #[inline(always)]
    pub fn total(self) -> (Energy, (f64, f64)) {
        let [strain, hourglass, viscous, plastic] =
            self.energies.map(|sum| (0..P::LANES).map(|lane| sum.lane(lane)).sum());
        (Energy { strain, hourglass, viscous, plastic }, self.ratios.range())
    }
}

impl<P: Pack, M: InelasticLaw<P>> Visitor<P> for EnergyVisitor<'_, P, M> {
    #[inline(always)]
    fn visit(&mut self, block: usize, first: usize, constants: &Constants<P>, element: &Hexahedron<P>) {
        let kinematics = Kinematics::new(element.gradient(constants));
        let (reference, ratio) = (constants.volume(), kinematics.deformation.volume);
        let dilation = ratio - 1.0;
        let found = self.law.energy(&kinematics.c, &self.state.of(block, first));
        let strain = found.strain + self.bulk * dilation * dilation * 0.5;
        let damped = self.viscosity.map_or(P::zero(), |viscosity| viscosity.work(block, first));
        // Lanes without an element have no volume and no stiffness, and keep their shape.
        self.energies[0] += strain * reference;
        self.energies[1] += element.hourglass_energy(constants);
        self.energies[2] += (found.viscous + damped) * reference;
        self.energies[3] += found.plastic * reference;
        self.ratios = self.ratios.and(ratio);
    }
}

#[cfg(test)]
mod tests {
    use crate::ball::{Ball, Piece};
    use crate::element::{solid_patches, Element};
    use crate::material::{Material, NeoHookean, Shape};
    use clubface_math::{Mat3, Vec3};

    #[test]
    fn sides_of_a_ball_share_their_constants() {
        let shape = Shape::NeoHookean(NeoHookean { shear: 1e7 });
        let material = Material { shape, bulk: 5e8, maxwell: vec![], density: 1150.0 };
        let piece = |name: &str, radius: f64, layers: usize| {
            let (name, material) = (name.into(), material.clone());
            Piece { name, radius, layers, material }
        };
        // Turned, and away from the origin: positions are rounded.
        let ((a, b), (c, d)) = (0.3_f64.sin_cos(), 0.7_f64.sin_cos());
        let turn = Mat3::from_columns(
            Vec3::new(b, a * d, a * c),
            Vec3::new(-a, b * d, b * c),
            Vec3::new(0.0, -c, d),
        );
        for fine in [1, 2] {
            let (cube, layers) = (12 * fine, [6 * fine, 3 * fine]);
            let pieces = vec![piece("core", 0.0196, layers[0]), piece("cover", 0.0214, layers[1])];
            let ball = Ball { pieces, cube, element: Element::OnePoint, mass: None };
            let mesh = ball.mesh(&turn, Vec3::new(0.4, -0.3, 0.2)).expect("a ball").mesh;
            let mut from = cube.pow(3);
            for layers in layers {
                let to = from + 6 * cube * cube * layers;
                let patches = solid_patches(&mesh, from..to, &material);
                let mut kinds: Vec<_> = patches.iter().map(|patch| patch.constants.as_ptr()).collect();
                // Those that share follow each other.
                kinds.dedup();
                assert_eq!((patches.len() % 6, kinds.len()), (0, patches.len() / 6), "{fine} times as fine");
                from = to;
            }
        }
    }
}
