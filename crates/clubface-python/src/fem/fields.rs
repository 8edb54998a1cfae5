//! Stress and strain in the elements of both bodies at the times of the frames.

use clubface_fem::element::ElementOutput;
use clubface_fem::solve::Impact;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::Range;

/// What the elements of a body felt, frame after frame, in single precision.
#[derive(Default)]
struct Body {
    stress: Vec<f32>,
    strain: Vec<f32>,
    plastic_strain: Vec<f32>,
}

impl Body {
    fn add(&mut self, now: &mut Impact<f64>, nodes: Range<usize>) {
        let mut all: Vec<ElementOutput> = Vec::new();
        now.structure.feel(nodes, &mut |number, felt| {
            if all.len() <= number {
                all.resize(number + 1, ElementOutput::default());
            }
            all[number] = *felt;
        });
        self.stress.extend(all.iter().flat_map(|felt| felt.stress.as_flattened().iter().map(|&v| v as f32)));
        self.strain.extend(all.iter().flat_map(|felt| felt.strain.as_flattened().iter().map(|&v| v as f32)));
        self.plastic_strain.extend(all.iter().map(|felt| felt.plastic_strain as f32));
    }

    /// {stress [Pa], strain: frames by elements by side by component (xx, yy, zz, xy, xz, yz), `plastic_strain`: frames by elements}, all flat.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("stress", PyArray1::from_slice(py, &self.stress))?;
        dict.set_item("strain", PyArray1::from_slice(py, &self.strain))?;
        dict.set_item("plastic_strain", PyArray1::from_slice(py, &self.plastic_strain))?;
        Ok(dict)
    }
}

/// Ball and head.
#[derive(Default)]
pub(super) struct Fields([Body; 2]);

impl Fields {
    /// Adds a frame.
    pub(super) fn add(&mut self, now: &mut Impact<f64>) {
        let (ball, all) = (now.ball_nodes, now.structure.translations);
        for (body, nodes) in self.0.iter_mut().zip([0..ball, ball..all]) {
            body.add(now, nodes);
        }
    }

    /// Keeps the first of all frames.
    pub(super) fn keep(&mut self, kept: usize, all: usize) {
        for Body { stress, strain, plastic_strain } in &mut self.0 {
            for numbers in [stress, strain, plastic_strain] {
                numbers.truncate(numbers.len() / all.max(1) * kept);
            }
        }
    }

    /// Both bodies.
    pub(super) fn to_list<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        self.0.iter().map(|body| body.to_dict(py)).collect()
    }
}
