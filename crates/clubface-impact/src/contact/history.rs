//! The history of a contact, step by step.

use super::dynamics::Contact;
use super::frame::Frame;
use super::law::ContactLaw;
use super::recorder::{Recorder, RingFrame};
use crate::first_touch::FirstTouch;
use crate::series::Series;

/// Every step of a contact, world axes.
#[derive(Clone, Debug)]
pub struct History {
    /// One frame a step, the first at first touch.
    pub frames: Vec<Frame>,
    /// Rings of each frame; empty for models without rings.
    pub rings: Vec<Vec<RingFrame>>,
    touch: FirstTouch<f64>,
}

impl History {
    /// History of a contact that has not begun.
    #[must_use]
    pub fn new(touch: FirstTouch<f64>) -> Self {
        Self { frames: Vec::new(), rings: Vec::new(), touch }
    }

    /// Every quantity of the frames, and of the rings by frame and ring.
    #[must_use]
    pub fn series(&self) -> Vec<Series> {
        macro_rules! frames {
            ($kind:ident: $($name:ident)+) => { [$(Series::$kind(stringify!($name), &self.frames, |f| f.$name)),+] };
        }
        let mut all = Vec::new();
        all.extend(frames! { scalars:
            time normal_force force_y force_z penetration sliding_y sliding_z contact_area face_depth kinetic_energy
            face_energy layer_energy normal_work friction_work layer_work
        });
        all.extend(frames! { vectors:
            ball_position ball_velocity ball_spin cover_spin core_spin club_position club_velocity club_spin
        });
        all.extend(frames! { vectors: club_attitude });
        if let Some(first) = self.rings.first() {
            let shape = vec![self.rings.len(), first.len()];
            let mut rings = |name, value: fn(&RingFrame) -> f64| {
                let values = self.rings.iter().flatten().map(value).collect();
                all.push(Series { name, shape: shape.clone(), values });
            };
            rings("ring_radius", |ring| ring.radius);
            rings("ring_traction_y", |ring| ring.traction[0]);
            rings("ring_traction_z", |ring| ring.traction[1]);
            rings("ring_slip", |ring| f64::from(u8::from(ring.slipping)));
            rings("ring_inside", |ring| f64::from(u8::from(ring.inside)));
        }
        all
    }
}

impl Recorder<f64> for History {
    const ACTIVE: bool = true;
    fn record<L: ContactLaw<f64>, const N: usize>(
        &mut self,
        contact: &Contact<f64, L>,
        time: f64,
        y: &[f64; N],
    ) {
        let frame = Frame::record(&self.touch, contact, time, y, self.frames.last());
        self.frames.push(frame);
    }
    fn record_rings(&mut self, rings: &[RingFrame]) {
        self.rings.push(rings.to_vec());
    }
}
