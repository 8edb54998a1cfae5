//! Nodes of the ball against a face of shells or hexahedra, both sides deforming: penalty springs, and Coulomb friction
//! that sticks.
//!
//! The force on a ball node acts at that node on both sides: its opposite is distributed to the corners of the
//! quadrilateral below by their bilinear weights, together with the moment of the distance between the middle surface
//! and the node (as forces along the normal where nodes have no rotations), so that momentum and angular momentum
//! balance to rounding.

use super::search_interval::SearchIntervals;
use super::surface::{Beyond, Normals, Projection, Surface};
use super::{
    Contact, ContactEnergy, ContactMethod, Grooves, NodeState, PenaltyContact, PenaltySprings, Penetration,
    Resultant,
};
use crate::material::{cross, dot};
use clubface_math::{Real, Row, Vec3};

/// A node of the ball that may touch the face.
struct Candidate<R> {
    mass: R,
    area: f64,
    state: NodeState<R>,
    quad: u32,
    at: [R; 2],
    /// Whether it was beyond the edge of the face when last searched.
    beyond: bool,
}

/// The ball's side of a contact.
pub struct BallSide<'a, R> {
    /// Nodes that may touch the face.
    pub nodes: &'a [u32],
    /// Masses of all nodes, kg.
    pub masses: &'a [R],
    /// Parts of the surface that belong to the nodes, all nodes, m2.
    pub areas: &'a [f64],
}

/// The face's side of a contact.
pub struct FaceSide<'a, R> {
    /// Rows of the corners' positions, by quadrilateral, counterclockwise seen from outside.
    pub quads: Vec<[u32; 4]>,
    /// Thickness of each quadrilateral, m.
    pub thickness: Vec<R>,
    /// Row of a node's rotation less the row of its position, if nodes have rotations.
    pub rotations: Option<u32>,
    /// Masses of all rows, kg or kg m2.
    pub masses: &'a [R],
    /// Grooves, and the height of all rows up the undeformed face, m.
    pub grooves: Option<(Grooves, Vec<f64>)>,
}

/// Contact of ball nodes with a deformable face.
pub struct DeformableContact<R: Real> {
    penalty: PenaltyContact<R>,
    /// Ball nodes, face positions, face rotations.
    nodes: Vec<u32>,
    candidates: Vec<Candidate<R>>,
    intervals: SearchIntervals,
    /// Candidates that touched in the last step.
    touching: Vec<u32>,
    surface: Surface<R>,
    normals: Normals<R>,
    /// Inverse masses of the face's nodes.
    mobilities: Vec<R>,
    forces: Vec<Row<R>>,
    /// Quadrilateral from which searches without a guess start.
    centre: u32,
    /// Whether nodes under load have passed the edge, or come back below the surface.
    passed_edge: bool,
}

impl<R: Real> DeformableContact<R> {
    /// Contact of ball and face with a coefficient of friction, for rows at the given positions.
    pub fn new(
        ball: &BallSide<R>,
        face: &FaceSide<R>,
        coefficient: R,
        springs: PenaltySprings,
        positions: &[Row<R>],
    ) -> Self {
        let mut rows: Vec<u32> = face.quads.iter().flatten().copied().collect();
        rows.sort_unstable();
        rows.dedup();
        let quads: Vec<[u32; 4]> =
            face.quads.iter().map(|quad| quad.map(|n| rows.partition_point(|&r| r < n) as u32)).collect();
        let mut surface = Surface::new(quads, &face.thickness, rows.clone());
        surface.grooves = (face.grooves.as_ref())
            .map(|(grooves, heights)| (*grooves, rows.iter().map(|&row| heights[row as usize]).collect()));
        let candidates: Vec<_> = ball
            .nodes
            .iter()
            .map(|&n| Candidate {
                mass: ball.masses[n as usize],
                area: ball.areas[n as usize],
                state: NodeState::free(),
                quad: surface.closest(positions, positions[n as usize].vec()),
                at: [R::zero(); 2],
                beyond: false,
            })
            .collect();
        let mobilities = rows.iter().map(|&n| face.masses[n as usize].recip()).collect();
        let nodes: Vec<u32> = ball
            .nodes
            .iter()
            .copied()
            .chain(rows.iter().copied())
            .chain(face.rotations.into_iter().flat_map(|offset| rows.iter().map(move |n| n + offset)))
            .collect();
        // The ball touches first where a node of it is nearest.
        let gap = |c: &Candidate<R>, n: u32| {
            let projection = surface.projection_from(positions, positions[n as usize].vec(), c.quad);
            projection.map_or(f64::INFINITY, |projection| projection.gap.re())
        };
        let nearest = candidates
            .iter()
            .zip(ball.nodes)
            .map(|(c, &n)| (gap(c, n), c.quad))
            .fold((f64::INFINITY, 0), |best, next| if next.0 < best.0 { next } else { best });
        Self {
            penalty: PenaltyContact::new(coefficient, springs),
            forces: vec![Row::zero(); nodes.len()],
            nodes,
            intervals: SearchIntervals::new(candidates.len()),
            touching: Vec::new(),
            candidates,
            normals: Normals::new(rows.len()),
            surface,
            mobilities,
            centre: nearest.1,
            passed_edge: false,
        }
    }

    /// Distance between ball and face, m.
    #[must_use]
    pub fn clearance(&self, positions: &[Row<R>]) -> R {
        let away = |(c, &n): (&Candidate<R>, &u32)| {
            self.surface.projection_from(positions, positions[n as usize].vec(), c.quad)
        };
        let gaps = self.candidates.iter().zip(&self.nodes).filter_map(away).map(|projection| projection.gap);
        gaps.fold(R::from_f64(f64::INFINITY), |least, gap| if gap.re() < least.re() { gap } else { least })
    }
}

impl<R: Real> Contact<R> for DeformableContact<R> {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }
    fn area(&self, index: usize) -> f64 {
        self.candidates.get(index).map_or(0.0, |candidate| candidate.area)
    }
    fn set_method(&mut self, method: ContactMethod) {
        self.penalty.springs.multiplier = method.multiplier();
    }
    fn assemble(&mut self, positions: &[Row<R>], velocities: &[Row<R>], dt: f64) {
        let balls = self.candidates.len();
        let count = self.mobilities.len();
        let (face, rotations) = self.nodes[balls..].split_at(count);
        self.normals.begin_step();
        let (on_ball, on_face) = self.forces.split_at_mut(balls);
        let (on_nodes, moments) = on_face.split_at_mut(count);
        // Write only where something acts or has acted: all other forces stay in the caches of the workers that add
        // them up.
        for touching in self.touching.drain(..) {
            on_ball[touching as usize] = Row::zero();
            for corner in self.surface.quads[self.candidates[touching as usize].quad as usize] {
                on_nodes[corner as usize] = Row::zero();
                if let Some(moment) = moments.get_mut(corner as usize) {
                    *moment = Row::zero();
                }
            }
        }
        self.penalty.begin_step();
        for (index, candidate) in self.candidates.iter_mut().enumerate() {
            if !self.intervals.due(index) {
                continue;
            }
            let node = self.nodes[index];
            let x = positions[node as usize].vec();
            let (quad, at) = (candidate.quad, candidate.at);
            let projection = match self.surface.projection(&mut self.normals, positions, x, quad, at) {
                Ok(projection) => projection,
                Err(Beyond { quad, distance }) => {
                    self.passed_edge |= candidate.state.in_contact();
                    (candidate.state, candidate.beyond) = (NodeState::free(), true);
                    (candidate.quad, candidate.at) = (quad, [R::zero(); 2]);
                    let corner = face[self.surface.quads[quad as usize][0] as usize];
                    let velocity = velocities[node as usize].vec() - velocities[corner as usize].vec();
                    self.intervals.skip_gap(index, distance, velocity.norm_squared().re(), dt);
                    continue;
                }
            };
            (candidate.quad, candidate.at) = (projection.quad, projection.at);
            let returned = std::mem::take(&mut candidate.beyond);
            // Sideways, the floor of a groove may rise to the lands at once.
            let land = projection;
            let projection = self.surface.in_grooves(positions, land);
            let corners = self.surface.quads[projection.quad as usize].map(|n| n as usize);
            let mut velocity = velocities[node as usize].vec();
            let (mut mobility, mut spin, mut arm) = (R::zero(), Vec3::zero(), x);
            for (&corner, &weight) in corners.iter().zip(&projection.weights) {
                velocity += velocities[face[corner] as usize].vec() * -weight;
                if let Some(&row) = rotations.get(corner) {
                    spin += velocities[row as usize].vec() * weight;
                }
                mobility += weight * weight * self.mobilities[corner];
                arm += positions[face[corner] as usize].vec() * -weight;
            }
            velocity += cross(arm, spin);
            // The reduced mass of node and face gives the stability that the node's mass gives against a rigid face.
            let mass = (candidate.mass.recip() + mobility).recip();
            let Projection { gap, normal, .. } = projection;
            if !self.penalty.touches(&candidate.state, mass, gap, normal, dt) {
                self.penalty.release(&mut candidate.state);
                self.intervals.skip_gap(index, land.gap.re(), velocity.norm_squared().re(), dt);
                continue;
            }
            self.passed_edge |= returned;
            // Where nodes have no rotations, the surface has: the tip of its normal moves with the slope of the
            // velocity along the normal.
            let height = dot(arm, land.normal);
            let slopes = rotations.is_empty().then(|| self.surface.slopes(positions, &land));
            for (slope, &corner) in slopes.iter().flatten().zip(&corners) {
                let along = dot(velocities[face[corner] as usize].vec(), land.normal);
                velocity += *slope * (along * height);
            }
            let penetration = Penetration { mass, area: candidate.area, gap, normal, velocity };
            let total = penetration.force(&mut self.penalty, &mut candidate.state, dt);
            self.touching.push(index as u32);
            on_ball[index] = Row::from_vec(total);
            distribute(&projection, &corners, total, on_nodes);
            match slopes {
                None => distribute(&projection, &corners, cross(arm, total), moments),
                Some(slopes) => {
                    for (slope, &corner) in slopes.iter().zip(&corners) {
                        on_nodes[corner].add(land.normal * (dot(*slope, total) * height));
                    }
                }
            }
        }
    }
    fn forces(&self) -> &[Row<R>] {
        &self.forces
    }
    fn resultant(&self) -> Resultant<R> {
        self.penalty.resultant
    }
    fn energy(&self) -> ContactEnergy {
        self.penalty.energy
    }
    fn nearest(&self, positions: &[Row<R>], point: Vec3<R>) -> (R, Vec3<R>) {
        self.surface
            .projection_from(positions, point, self.centre)
            .map_or((R::from_f64(f64::NAN), Vec3::zero()), |projection| (projection.gap, projection.normal))
    }
    fn passed_edge(&self) -> bool {
        self.passed_edge
    }
}

/// Subtracts a vector from the rows of a quadrilateral's corners, by their weights.
#[inline(always)]
fn distribute<R: Real>(
    projection: &Projection<R>,
    corners: &[usize; 4],
    value: Vec3<R>,
    rows: &mut [Row<R>],
) {
    for (&corner, &weight) in corners.iter().zip(&projection.weights) {
        rows[corner].add(value * -weight);
    }
}
