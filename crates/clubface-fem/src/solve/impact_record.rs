//! What is known of an impact after its run, in one struct that all bindings share: summary, launch, histories, deformed
//! shapes, stress and strain.

use super::{Options, Progress, Records, Simulation, Snapshot, Summary};
use crate::element::ElementOutput;
use crate::error::FemError;
use clubface_impact::first_touch::{FirstTouch, Motion};
use clubface_impact::launch::OUTPUT_COUNT;
use clubface_impact::series::Series;
use clubface_math::{Mat3, Vec3};
use std::ops::Range;

/// What a run keeps besides its records.
#[derive(Clone, Copy, Debug, Default)]
pub struct Recording {
    /// Number of deformed shapes, evenly over the duration.
    pub frames: usize,
    /// Whether stress and strain in the elements are kept with every shape.
    pub fields: bool,
}

/// A node of the ball in contact, at one motion record.
#[derive(Clone, Copy, Debug)]
pub struct ContactPoint {
    /// Time since first touch, s.
    pub time: f64,
    /// Position relative to the ball's mass centre, up the face of first touch, m.
    pub up: f64,
    /// The same towards the toe, m.
    pub toe: f64,
    /// Force along the normal, N.
    pub normal: f64,
    /// Force down the face, N: positive where it makes backspin.
    pub tangential: f64,
    /// Part of the undeformed surface that belongs to the node, m2.
    pub area: f64,
}

/// Stress and strain in the elements of a body, frame after frame, in single precision.
#[derive(Clone, Debug, Default)]
pub struct ElementHistory {
    /// Cauchy stress (Pa) by frame, element, side and component (xx, yy, zz, xy, xz, yz).
    pub stress: Vec<f32>,
    /// Logarithmic strain, likewise.
    pub strain: Vec<f32>,
    /// Equivalent plastic strain by frame and element.
    pub plastic_strain: Vec<f32>,
}

impl ElementHistory {
    fn add(&mut self, simulation: &mut Simulation<f64>, nodes: Range<usize>) {
        let mut outputs: Vec<ElementOutput> = Vec::new();
        simulation.structure.element_output(nodes, &mut |number, output| {
            if outputs.len() <= number {
                outputs.resize(number + 1, ElementOutput::default());
            }
            outputs[number] = *output;
        });
        let single =
            |values: &[[f64; 6]; 2]| values.as_flattened().iter().map(|&v| v as f32).collect::<Vec<_>>();
        self.stress.extend(outputs.iter().flat_map(|output| single(&output.stress)));
        self.strain.extend(outputs.iter().flat_map(|output| single(&output.strain)));
        self.plastic_strain.extend(outputs.iter().map(|output| output.plastic_strain as f32));
    }

    /// Keeps the first `kept` of `count` frames.
    fn truncate(&mut self, kept: usize, count: usize) {
        for numbers in [&mut self.stress, &mut self.strain, &mut self.plastic_strain] {
            numbers.truncate(numbers.len() / count.max(1) * kept);
        }
    }
}

/// An impact after its run.
#[derive(Clone, Debug)]
pub struct ImpactRecord {
    /// Quantities that summarise it.
    pub summary: Summary,
    /// Ball after the impact, in the axes of the nodes.
    pub ball: Motion<f64>,
    /// Launch in the order of [`clubface_impact::launch::OUTPUTS`], NaN if there is none; none for a plane.
    pub launch: Option<[f64; OUTPUT_COUNT]>,
    /// Unit vectors at the point of first touch: the face normal, up the face, towards the toe.
    pub axes: [Vec3<f64>; 3],
    /// Rotation from the axes of the nodes to world axes.
    pub attitude: Mat3<f64>,
    /// Velocity of the head at first touch along `axes`, m/s.
    pub frame_velocity: Vec3<f64>,
    /// Histories of contact, motion and energy.
    pub records: Records,
    /// Nodes of the ball in contact at the motion records.
    pub contact_points: Vec<ContactPoint>,
    /// Number of nodes of the ball, the first ones, and of all bodies.
    pub nodes: (usize, usize),
    /// Times of the deformed shapes, s.
    pub frame_times: Vec<f64>,
    /// Positions of all nodes, m, by frame, node and axis.
    pub frames: Vec<f64>,
    /// Stress and strain in ball and head with the frames, empty unless asked for.
    pub fields: [ElementHistory; 2],
    /// Steps taken.
    pub steps: usize,
    /// Time step, s.
    pub step: f64,
    /// Time step over the stable step of the undeformed structure.
    pub safety: f64,
    /// Time that the steps took, s.
    pub wall: f64,
    /// Why there is no launch, if there is none.
    pub stopped: Option<FemError>,
    /// Whether the ball has reached round the edge of the face, where contact ends.
    pub over_edge: bool,
}

impl ImpactRecord {
    /// Forces and area of the contact over the steps: time, normal, tangential, toe (N), area (m2).
    #[must_use]
    pub fn contact_series(&self) -> [Series; 5] {
        let records = &self.records.contact;
        [
            Series::scalars("time", records, |r| r.time),
            Series::scalars("normal", records, |r| r.normal),
            Series::scalars("tangential", records, |r| r.tangential),
            Series::scalars("toe", records, |r| r.toe),
            Series::scalars("area", records, |r| r.area),
        ]
    }

    /// Motion of the ball over the motion records: time, radius (m), velocity (m/s), spin (rad/s).
    #[must_use]
    pub fn motion_series(&self) -> [Series; 4] {
        let records = &self.records.motion;
        [
            Series::scalars("time", records, |r| r.time),
            Series::scalars("radius", records, |r| r.radius),
            Series::vectors("velocity", records, |r| r.velocity),
            Series::vectors("spin", records, |r| r.spin),
        ]
    }

    /// Energies over the energy records, J: time (s), kinetic, contact, friction, damping, strain, hourglass, viscous,
    /// plastic.
    #[must_use]
    pub fn energy_series(&self) -> [Series; 9] {
        let records = &self.records.energy;
        [
            Series::scalars("time", records, |r| r.time),
            Series::scalars("kinetic", records, |r| r.kinetic),
            Series::scalars("contact", records, |r| r.contact),
            Series::scalars("friction", records, |r| r.friction),
            Series::scalars("damping", records, |r| r.damping),
            Series::scalars("strain", records, |r| r.elements.strain),
            Series::scalars("hourglass", records, |r| r.elements.hourglass),
            Series::scalars("viscous", records, |r| r.elements.viscous),
            Series::scalars("plastic", records, |r| r.elements.plastic),
        ]
    }

    /// The nodes of the ball in contact at the motion records: time, up, toe (m), normal, tangential (N), area (m2).
    #[must_use]
    pub fn patch_series(&self) -> [Series; 6] {
        let points = &self.contact_points;
        [
            Series::scalars("time", points, |p| p.time),
            Series::scalars("up", points, |p| p.up),
            Series::scalars("toe", points, |p| p.toe),
            Series::scalars("normal", points, |p| p.normal),
            Series::scalars("tangential", points, |p| p.tangential),
            Series::scalars("area", points, |p| p.area),
        ]
    }

    /// Whether elements failed; only what came before is kept.
    #[must_use]
    pub fn failed(&self) -> bool {
        self.stopped.as_ref().is_some_and(FemError::failed)
    }
    /// Whether the caller stopped the run.
    #[must_use]
    pub fn interrupted(&self) -> bool {
        matches!(self.stopped, Some(FemError::Interrupted { .. }))
    }
    /// Whether the ball was still on the face at the end of the simulated time.
    #[must_use]
    pub fn unfinished(&self) -> bool {
        matches!(self.stopped, Some(FemError::Unfinished { .. }))
    }
}

/// Collects shapes, fields and contact forces while a simulation runs.
#[derive(Default)]
struct Collector {
    times: Vec<f64>,
    positions: Vec<f64>,
    contact_points: Vec<ContactPoint>,
    fields: [ElementHistory; 2],
}

impl Collector {
    fn add_frame(&mut self, simulation: &mut Simulation<f64>, time: f64, fields: bool) {
        self.times.push(time);
        let (ball, all) = (simulation.ball_nodes, simulation.structure.translations);
        let rows = &simulation.structure.positions[..all];
        self.positions.extend(rows.iter().flat_map(|row| [row.0[0], row.0[1], row.0[2]]));
        if fields {
            for (body, nodes) in self.fields.iter_mut().zip([0..ball, ball..all]) {
                body.add(simulation, nodes);
            }
        }
    }

    fn add_contact_points(&mut self, snapshot: &Snapshot<f64>) {
        let [normal, up, toe] = snapshot.axes();
        for node in snapshot.contact_forces() {
            let (position, force) = (node.position - snapshot.centre, node.force);
            self.contact_points.push(ContactPoint {
                time: snapshot.progress.time,
                up: position.dot(up),
                toe: position.dot(toe),
                normal: force.dot(normal),
                tangential: -force.dot(up),
                area: node.area,
            });
        }
    }

    /// Drops what came after `last` (s).
    fn truncate(&mut self, last: f64) {
        let (count, kept) = (self.times.len(), self.times.partition_point(|&time| time <= last));
        self.times.truncate(kept);
        self.positions.truncate(self.positions.len() / count.max(1) * kept);
        self.contact_points.retain(|point| point.time <= last);
        self.fields.iter_mut().for_each(|fields| fields.truncate(kept, count));
    }
}

impl Simulation<f64> {
    /// Runs the impact and records it. `touch` is the first touch of a head, none for a plane. `progress` is called at
    /// every motion record, and ends the run by returning false.
    ///
    /// # Errors
    /// As [`Simulation::run`].
    pub fn record(
        &mut self,
        options: &Options,
        recording: Recording,
        touch: Option<&FirstTouch<f64>>,
        progress: &mut dyn FnMut(&Progress) -> bool,
    ) -> Result<ImpactRecord, FemError> {
        let Recording { frames, fields } = recording;
        let gap = if frames > 1 { options.duration / (frames - 1) as f64 } else { f64::INFINITY };
        let mut collector = Collector::default();
        let result = self.run(options, &mut |mut snapshot| {
            let count = collector.times.len();
            let due = if count == 0 { 0.0 } else { count as f64 * gap - 0.5 * options.interval };
            let time = snapshot.progress.time;
            // A run until separation may be longer than its duration.
            if count < frames && time >= due {
                collector.add_frame(snapshot.synchronised(), time, fields);
            }
            collector.add_contact_points(&snapshot);
            progress(&snapshot.progress)
        })?;
        // The last frame is due when the run ends, between two records.
        let (end, count) = (result.steps as f64 * result.step, collector.times.len());
        let failed = result.stopped.as_ref().is_some_and(FemError::failed);
        let interrupted = matches!(result.stopped, Some(FemError::Interrupted { .. }));
        if !failed && !interrupted && count > 0 && count < frames && end > options.duration {
            collector.add_frame(self, end, fields);
        }
        if failed {
            collector.truncate(result.records.energy.last().map_or(0.0, |record| record.time));
        }
        let mut summary = result.records.summary(self.radius);
        // The records fit a rotation to the velocities of the nodes; the ball after the impact turns with its angular
        // momentum over its inertia, which may be a little faster.
        summary.spin_max = summary.spin_max.max(self.axes[2].dot(result.ball.spin));
        let known = if failed || result.records.in_contact() { f64::NAN } else { 1.0 };
        let launch = touch.map(|touch| {
            let mut launch = touch.launch(result.ball, result.head);
            (launch.contact_time, launch.peak_force) = (summary.contact_time, summary.peak_force);
            launch.outputs().map(|output| output * known)
        });
        let [normal, up, toe] = self.axes.map(|axis| axis.dot(self.head_velocity));
        Ok(ImpactRecord {
            summary,
            ball: result.ball,
            launch,
            axes: self.axes,
            attitude: touch.map_or(Mat3::diagonal(1.0), |touch| touch.attitude),
            frame_velocity: Vec3::new(normal, up, toe),
            records: result.records,
            contact_points: collector.contact_points,
            nodes: (self.ball_nodes, self.structure.translations),
            frame_times: collector.times,
            frames: collector.positions,
            fields: collector.fields,
            steps: result.steps,
            step: result.step,
            safety: result.safety,
            wall: result.wall,
            stopped: result.stopped,
            over_edge: result.over_edge,
        })
    }
}
