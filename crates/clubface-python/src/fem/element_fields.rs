//! Stress and strain in the elements of both bodies, frame by frame.

use clubface_fem::element::ElementOutput;
use clubface_fem::solve::Simulation;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::Range;

/// Stress and strain in the elements of a body, frame after frame, in single precision.
#[derive(Default)]
struct Body {
    stress: Vec<f32>,
    strain: Vec<f32>,
    plastic_strain: Vec<f32>,
}

impl Body {
    fn add(&mut self, simulation: &mut Simulation<f64>, nodes: Range<usize>) {
        let mut all: Vec<ElementOutput> = Vec::new();
        simulation.structure.element_output(nodes, &mut |number, output| {
            if all.len() <= number {
                all.resize(number + 1, ElementOutput::default());
            }
            all[number] = *output;
        });
        self.stress
            .extend(all.iter().flat_map(|output| output.stress.as_flattened().iter().map(|&v| v as f32)));
        self.strain
            .extend(all.iter().flat_map(|output| output.strain.as_flattened().iter().map(|&v| v as f32)));
        self.plastic_strain.extend(all.iter().map(|output| output.plastic_strain as f32));
    }

    /// Flat arrays: stress (Pa) and strain by frame, element, side and component (xx, yy, zz, xy, xz, yz);
    /// `plastic_strain` by frame and element.
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
pub(super) struct ElementFields([Body; 2]);

impl ElementFields {
    /// Adds a frame.
    pub(super) fn add(&mut self, simulation: &mut Simulation<f64>) {
        let (ball, all) = (simulation.ball_nodes, simulation.structure.translations);
        for (body, nodes) in self.0.iter_mut().zip([0..ball, ball..all]) {
            body.add(simulation, nodes);
        }
    }

    /// Keeps the first `kept` of `all` frames.
    pub(super) fn truncate(&mut self, kept: usize, all: usize) {
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
