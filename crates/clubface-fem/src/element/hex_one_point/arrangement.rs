//! Rows, columns and layers of elements: whether a list of elements makes a lattice, and the order of its nodes and
//! packs.

use crate::block::BLOCK;
use crate::mesh::CORNERS;

/// Number of elements, from the first one on, that make rows, columns and layers, element after element in the order
/// of the corners.
pub fn shape(elements: &[[u32; CORNERS]]) -> [usize; 3] {
    let joined = |a: usize, b: usize, bit: usize| {
        (0..CORNERS)
            .filter(|corner| corner & bit == 0)
            .all(|corner| elements[a][corner | bit] == elements[b][corner])
    };
    let mut shape = [1; 3];
    let mut size = 1;
    for axis in 0..3 {
        let whole = |n: usize| {
            // The next row (or layer) hangs together like the first and joins the last.
            (n + 1) * size <= elements.len()
                && (0..size).all(|e| joined((n - 1) * size + e, n * size + e, 1 << axis))
                && (axis == 0 || {
                    (1..size).all(|e| e % shape[0] == 0 || joined(n * size + e - 1, n * size + e, 1))
                })
                && (axis < 2 || (shape[0]..size).all(|e| joined(n * size + e - shape[0], n * size + e, 2)))
        };
        let mut n = 1;
        while whole(n) {
            n += 1;
        }
        shape[axis] = n;
        size *= n;
    }
    shape
}

/// Most lanes of a quad, which a row's end does not cut in two: rows of a multiple of them leave no lane empty.
pub const QUAD: usize = 4;

/// Lanes that follow each other before the last node of a row is left out: the elements of a row, if they fill whole
/// quads. Otherwise all lanes of a layer: the last node of a row makes an element with the first of the next, which
/// does not exist.
pub fn unbroken(shape: [usize; 3]) -> usize {
    let [ni, nj, _] = shape;
    if ni.is_multiple_of(QUAD) { ni } else { ((ni + 1) * nj).next_multiple_of(BLOCK) }
}

/// Nodes of a lattice of elements, given by their corners, row by row and plane by plane; and the element in every
/// lane of the blocks, column by column up through the layers.
pub fn order(shape: [usize; 3], elements: &[[u32; CORNERS]]) -> (Vec<u32>, Vec<Option<usize>>) {
    let [ni, nj, nk] = shape;
    let mut nodes = Vec::new();
    for k in 0..=nk {
        for j in 0..=nj {
            for i in 0..=ni {
                let (ei, ej, ek) = (i.min(ni - 1), j.min(nj - 1), k.min(nk - 1));
                let corner = (i - ei) + 2 * (j - ej) + 4 * (k - ek);
                nodes.push(elements[(ek * nj + ej) * ni + ei][corner]);
            }
        }
    }
    let row = unbroken(shape).min(ni + 1);
    let mut lanes = Vec::new();
    for column in 0..(row * nj).div_ceil(BLOCK) {
        for k in 0..nk {
            for lane in 0..BLOCK {
                let at = column * BLOCK + lane;
                let (i, j) = (at % row, at / row);
                lanes.push((i < ni && j < nj).then_some((k * nj + j) * ni + i));
            }
        }
    }
    (nodes, lanes)
}
