//! Mass, momentum and their like, summed over nodes.

use crate::block::BLOCK;
use clubface_math::{Pack, PackKernel, Real, Row, Scalar, Vec3};

/// What positions (m) and velocities (m/s) are counted from. Near those of the mass centre little is lost when moments
/// about it follow.
#[derive(Clone, Copy, Debug)]
pub struct Origin<P> {
    /// Position, m.
    pub position: Vec3<P>,
    /// Velocity, m/s.
    pub velocity: Vec3<P>,
}

impl<R: Real> Origin<R> {
    /// The same in every lane.
    #[inline(always)]
    pub fn splat<P: Pack<Real = R>>(&self) -> Origin<P> {
        let splat = |v: Vec3<R>| Vec3::new(P::splat(v.x), P::splat(v.y), P::splat(v.z));
        Origin { position: splat(self.position), velocity: splat(self.velocity) }
    }
}

/// Sums over nodes.
#[derive(Clone, Copy, Debug)]
pub struct Moments<P> {
    /// Mass, kg.
    pub mass: P,
    /// Mass times position, kg m.
    pub first: Vec3<P>,
    /// Mass times velocity, kg m/s.
    pub momentum: Vec3<P>,
    /// Moment of momentum, kg m2/s.
    pub angular: Vec3<P>,
    /// Mass times products of positions (xx, yy, zz, xy, xz, yz), kg m2.
    pub second: [P; 6],
    /// Mass times the square of velocity, J.
    pub square: P,
}

impl<P: Scalar> Moments<P> {
    /// Moments of no nodes.
    #[inline(always)]
    pub fn zero() -> Self {
        let o = Vec3::zero();
        Self { mass: P::zero(), first: o, momentum: o, angular: o, second: [P::zero(); 6], square: P::zero() }
    }
    /// Adds a node of a mass (kg) at a position (m) with a velocity (m/s).
    #[inline(always)]
    pub fn add(&mut self, origin: &Origin<P>, mass: P, position: Vec3<P>, velocity: Vec3<P>) {
        let (x, v) = (position - origin.position, velocity - origin.velocity);
        let (y, p) = (x * mass, v * mass);
        self.mass += mass;
        self.first += y;
        self.momentum += p;
        self.angular += x.cross(p);
        self.square += v.dot(p);
        let products = [x.x * y.x, x.y * y.y, x.z * y.z, x.x * y.y, x.x * y.z, x.y * y.z];
        for (sum, product) in self.second.iter_mut().zip(products) {
            *sum += product;
        }
    }
    /// The sum with the moments of other nodes about the same origin.
    #[must_use]
    pub fn plus(mut self, more: &Self) -> Self {
        self.mass += more.mass;
        self.first += more.first;
        self.momentum += more.momentum;
        self.angular += more.angular;
        for (sum, more) in self.second.iter_mut().zip(more.second) {
            *sum += more;
        }
        self.square += more.square;
        self
    }
}

impl<P: Pack> Moments<P> {
    /// The sum over all lanes.
    #[inline(always)]
    pub fn total(&self) -> Moments<P::Real> {
        #[inline(always)]
        fn sum<P: Pack>(pack: P) -> P::Real {
            let mut sum = P::Real::zero();
            for lane in 0..P::LANES {
                sum += pack.real(lane);
            }
            sum
        }
        let each = |v: Vec3<P>| Vec3::new(sum(v.x), sum(v.y), sum(v.z));
        let mut second = [P::Real::zero(); 6];
        for (total, pack) in second.iter_mut().zip(self.second) {
            *total = sum(pack);
        }
        Moments {
            mass: sum(self.mass),
            first: each(self.first),
            momentum: each(self.momentum),
            angular: each(self.angular),
            second,
            square: sum(self.square),
        }
    }
}

/// All nodes: positions (m), velocities (m/s) and masses (kg).
#[derive(Clone, Copy)]
pub struct Nodes<'a, R: Real> {
    /// Positions, m.
    pub positions: &'a [Row<R>],
    /// Velocities, m/s.
    pub velocities: &'a [Row<R>],
    /// Masses, kg.
    pub masses: &'a [R],
}

impl<R: Real> Nodes<'_, R> {
    /// Moments of some of them.
    pub fn moments(self, pack: &[u32], origin: Origin<R>) -> Moments<R> {
        let count = self.masses.len();
        assert!(self.positions.len() == count && self.velocities.len() == count);
        assert!(pack.iter().all(|&node| (node as usize) < count), "a list of other nodes");
        R::dispatch(Sum { nodes: self, pack, origin })
    }
}

struct Sum<'a, R: Real> {
    nodes: Nodes<'a, R>,
    pack: &'a [u32],
    origin: Origin<R>,
}

impl<R: Real> PackKernel<R> for Sum<'_, R> {
    type Output = Moments<R>;
    #[inline(always)]
    fn run<P: Pack<Real = R>>(self) -> Moments<R> {
        let Self { nodes, pack, origin } = self;
        let origin = origin.splat::<P>();
        let mut sum = Moments::zero();
        for some in pack.chunks(P::LANES) {
            // Lanes behind the last node repeat it without mass.
            let (mut index, mut masses) = ([some[some.len() - 1]; BLOCK], [R::zero(); BLOCK]);
            for (lane, &node) in some.iter().enumerate() {
                index[lane] = node;
                masses[lane] = nodes.masses[node as usize];
            }
            // SAFETY: `moments` has checked the nodes.
            let (x, v) = unsafe { (P::gather(nodes.positions, &index), P::gather(nodes.velocities, &index)) };
            sum.add(&origin, P::load(&masses), x, v);
        }
        sum.total()
    }
}
