//! Numbers of all rings, padded to blocks of eight, and products with them.

/// Two components along y' and z' for every ring.
pub type Plane = [Vec<f64>; 2];

/// The blocks of eight that hold the first m numbers of a padded row.
#[inline(always)]
pub(super) fn eights<T>(row: &[T], m: usize) -> &[[T; 8]] {
    &row.as_chunks::<8>().0[..m.div_ceil(8)]
}

/// `out` = the leading m x m block of `matrix` times `of`, both components.
#[inline(always)]
pub(super) fn product(matrix: &[f64], stride: usize, m: usize, plane: &Plane, out: &mut Plane) {
    let [of_y, of_z] = [&plane[0][..m], &plane[1][..m]];
    for start in (0..m).step_by(8) {
        let (mut y, mut z) = ([0.0; 8], [0.0; 8]);
        for ((column, of_y), of_z) in matrix.chunks_exact(stride).zip(of_y).zip(of_z) {
            let column = &column[start..start + 8];
            for lane in 0..8 {
                y[lane] += column[lane] * of_y;
                z[lane] += column[lane] * of_z;
            }
        }
        out[0][start..start + 8].copy_from_slice(&y);
        out[1][start..start + 8].copy_from_slice(&z);
    }
}
