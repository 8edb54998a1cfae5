//! Symmetric tensors of the second order.

use clubface_math::{Mat3, Scalar, Vec3};

/// Six components of a symmetric tensor: xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy, Debug)]
pub struct Symmetric<S>(pub [S; 6]);

impl<S: Scalar> Symmetric<S> {
    /// `value` times the identity.
    #[inline(always)]
    pub fn diagonal(value: S) -> Self {
        let o = S::zero();
        Self([value, value, value, o, o, o])
    }
    /// `A^T A`.
    #[inline(always)]
    pub fn gram(a: &Mat3<S>) -> Self {
        let [r, s, t] = a.rows;
        let (x, y, z) = (Vec3::new(r.x, s.x, t.x), Vec3::new(r.y, s.y, t.y), Vec3::new(r.z, s.z, t.z));
        Self([dot(x, x), dot(y, y), dot(z, z), dot(x, y), dot(x, z), dot(y, z)])
    }
    /// Sum of the diagonal.
    #[inline(always)]
    pub fn trace(&self) -> S {
        self.0[0] + self.0[1] + self.0[2]
    }
    /// Double contraction `A : B`.
    #[inline(always)]
    pub fn contract(&self, o: &Self) -> S {
        let (a, b) = (&self.0, &o.0);
        let diagonal = a[2].mul_add(b[2], a[1].mul_add(b[1], a[0].product(b[0])));
        let shear = a[5].mul_add(b[5], a[4].mul_add(b[4], a[3].product(b[3])));
        diagonal + (shear + shear)
    }
    /// `A + s B`.
    #[inline(always)]
    #[must_use]
    pub fn plus(&self, s: S, o: &Self) -> Self {
        let mut sum = self.0;
        for i in 0..6 {
            sum[i] = o.0[i].mul_add(s, sum[i]);
        }
        Self(sum)
    }
    /// `A + s I`.
    #[inline(always)]
    #[must_use]
    pub fn plus_diagonal(&self, s: S) -> Self {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        Self([xx + s, yy + s, zz + s, xy, xz, yz])
    }
    /// `s A`.
    #[inline(always)]
    #[must_use]
    pub fn scale(&self, s: S) -> Self {
        let mut product = self.0;
        for i in 0..6 {
            product[i] = product[i].product(s);
        }
        Self(product)
    }
    /// As a matrix.
    #[inline(always)]
    pub fn matrix(&self) -> Mat3<S> {
        Mat3::symmetric(self.0)
    }
    /// `B A B` for symmetric A and B.
    #[inline(always)]
    #[must_use]
    pub fn sandwich(&self, b: &Self) -> Self {
        let product = times(&b.matrix(), self);
        let rows = times(&product, b).rows;
        Self([rows[0].x, rows[1].y, rows[2].z, rows[0].y, rows[0].z, rows[1].z])
    }
    /// `F A F^T`.
    #[inline(always)]
    #[must_use]
    pub fn seen_through(&self, f: &Mat3<S>) -> Self {
        let [r, s, t] = times(f, self).rows;
        let [x, y, z] = f.rows;
        Self([dot(r, x), dot(s, y), dot(t, z), dot(r, y), dot(r, z), dot(s, z)])
    }
    /// Cofactors: the inverse times the determinant.
    #[inline(always)]
    #[must_use]
    pub fn cofactors(&self) -> Self {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        Self([
            yy.mul_add(zz, -yz.product(yz)),
            xx.mul_add(zz, -xz.product(xz)),
            xx.mul_add(yy, -xy.product(xy)),
            xz.mul_add(yz, -xy.product(zz)),
            xy.mul_add(yz, -xz.product(yy)),
            xy.mul_add(xz, -xx.product(yz)),
        ])
    }
    /// Sum of the minors of the diagonal: the second invariant.
    #[inline(always)]
    pub fn second(&self) -> S {
        let [xx, yy, zz, xy, xz, yz] = self.0;
        let shear = yz.mul_add(yz, xz.mul_add(xz, xy.product(xy)));
        xx.mul_add(yy + zz, yy.mul_add(zz, -shear))
    }
}

/// `A B` for symmetric B.
#[inline(always)]
pub fn times<S: Scalar>(a: &Mat3<S>, b: &Symmetric<S>) -> Mat3<S> {
    let [x, y, z] = b.matrix().rows;
    let [r, s, t] = a.rows;
    Mat3::from_rows(
        Vec3::new(dot(r, x), dot(r, y), dot(r, z)),
        Vec3::new(dot(s, x), dot(s, y), dot(s, z)),
        Vec3::new(dot(t, x), dot(t, y), dot(t, z)),
    )
}

#[inline(always)]
pub(crate) fn cross<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Vec3<S> {
    Vec3::new(
        a.y.mul_add(b.z, -a.z.product(b.y)),
        a.z.mul_add(b.x, -a.x.product(b.z)),
        a.x.mul_add(b.y, -a.y.product(b.x)),
    )
}
#[inline(always)]
pub(crate) fn dot<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> S {
    a.z.mul_add(b.z, a.y.mul_add(b.y, a.x.product(b.x)))
}
