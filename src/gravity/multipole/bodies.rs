//! Bodies on bodies: the spline-softened attraction, as in [`direct`](mod@super::direct), eight sources at a time.

use crate::math::lanes::{LANES, Lanes};

/// Bodies as the loops read them, one array for each quantity; in units of the root cube's side, but for masses.
#[derive(Debug, Clone, Default)]
pub struct Bodies {
    pub position: [Vec<f64>; 3],
    pub mass: Vec<f64>,
    pub softening: Vec<f64>,
    pub inverse_softening: Vec<f64>,
}

/// Nearer than this, in sides of the root cube, bodies count as coincident: the square is still above the smallest number of single
/// precision.
const NEAREST2: f64 = 1e-36;

impl Bodies {
    pub fn count(&self) -> usize {
        self.mass.len()
    }

    pub fn clear(&mut self) {
        self.position.iter_mut().for_each(|x| x.clear());
        self.mass.clear();
        self.softening.clear();
        self.inverse_softening.clear();
    }

    pub fn push(&mut self, position: &[f64; 3], mass: f64, softening: f64) {
        self.position.iter_mut().zip(position).for_each(|(all, x)| all.push(*x));
        self.mass.push(mass);
        self.softening.push(softening);
        self.inverse_softening.push(1.0 / softening);
    }

    pub fn extend(&mut self, other: &Bodies, range: std::ops::Range<usize>) {
        for (mine, theirs) in self.position.iter_mut().zip(&other.position) {
            mine.extend_from_slice(&theirs[range.clone()]);
        }
        self.mass.extend_from_slice(&other.mass[range.clone()]);
        self.softening.extend_from_slice(&other.softening[range.clone()]);
        self.inverse_softening.extend_from_slice(&other.inverse_softening[range]);
    }

    /// Bodies without mass, far away, up to whole vectors of lanes.
    pub fn pad(&mut self) {
        while self.count() % LANES != 0 {
            self.push(&[4.0; 3], 0.0, 1e-3);
        }
    }
}

/// A body that is attracted.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    pub position: [f64; 3],
    pub softening: f64,
}

/// Sums of -m x / r^3 (three) and m / r over all sources, none of which is softened.
///
/// # Safety
/// As for [`Lanes`]; sources come in whole vectors of lanes.
#[inline(always)]
pub unsafe fn add_distant<L: Lanes>(sources: &Bodies, place: &Place, sums: &mut [L; 4]) {
    // SAFETY: the caller's.
    unsafe {
        for at in (0..sources.count()).step_by(LANES) {
            let (x, mass) = read::<L>(sources, place, at);
            let inverse = r2(&x).max(L::splat(NEAREST2)).inverse_root();
            add(&x, mass.mul(inverse), inverse.mul(inverse), sums);
        }
    }
}

/// [`add_distant`] for sources that may be softened; the place itself may be among them and does not attract itself, but its own
/// potential is counted, see [`own`].
///
/// # Safety
/// As for [`add_distant`].
#[inline(always)]
pub unsafe fn add_near<L: Lanes>(sources: &Bodies, place: &Place, sums: &mut [L; 4]) {
    // SAFETY: the caller's.
    unsafe {
        let (own, own_inverse) = (L::splat(place.softening), L::splat(1.0 / place.softening));
        for at in (0..sources.count()).step_by(LANES) {
            let (x, mass) = read::<L>(sources, place, at);
            let r2 = r2(&x).max(L::splat(NEAREST2));
            let inverse = r2.inverse_root();
            let h_inverse = own_inverse.min(L::read(sources.inverse_softening.as_ptr().add(at)));
            let q = r2.mul(inverse).mul(h_inverse);
            let inside = q.less(L::splat(1.0));
            let softened = q.less(L::splat(2.0));
            let q2 = q.mul(q);
            let (c, s) = (L::splat, h_inverse);
            // Inverse q, for the outer part only.
            let p = inverse.mul(own.max(L::read(sources.softening.as_ptr().add(at))));
            let inner = q2.fma(q2.fma(q.fma(c(-0.1), c(0.3)), c(-2.0 / 3.0)), c(1.4));
            let outer =
                q2.fma(q2.fma(q.fma(c(1.0 / 30.0), c(-0.3)), q.add(c(-4.0 / 3.0))), p.fma(c(-1.0 / 15.0), c(1.6)));
            let potential = inner.or(inside, outer).mul(s).or(softened, inverse);
            let inner = q2.fma(q.fma(c(0.5), c(-1.2)), c(4.0 / 3.0));
            let outer = q2
                .fma(q.fma(c(-1.0 / 6.0), c(1.2)), q.fma(c(-3.0), c(8.0 / 3.0)))
                .add(p.mul(p).mul(p).mul(c(-1.0 / 15.0)));
            let force = inner.or(inside, outer).mul(s.mul(s).mul(s)).or(softened, inverse.mul(inverse).mul(inverse));
            let weight = mass.mul(force);
            for k in 0..3 {
                sums[k] = weight.fnma(x[k], sums[k]);
            }
            sums[3] = mass.fma(potential, sums[3]);
        }
    }
}

/// Contribution of a body of this softening to its own sum of m / r, over its mass.
pub fn own(softening: f64) -> f64 {
    1.4 / softening
}

#[inline(always)]
unsafe fn read<L: Lanes>(sources: &Bodies, place: &Place, at: usize) -> ([L; 3], L) {
    // SAFETY: the caller reads whole vectors.
    unsafe {
        let p = &sources.position;
        let x = L::splat(place.position[0]).sub(L::read(p[0].as_ptr().add(at)));
        let y = L::splat(place.position[1]).sub(L::read(p[1].as_ptr().add(at)));
        let z = L::splat(place.position[2]).sub(L::read(p[2].as_ptr().add(at)));
        ([x, y, z], L::read(sources.mass.as_ptr().add(at)))
    }
}

#[inline(always)]
unsafe fn r2<L: Lanes>(x: &[L; 3]) -> L {
    // SAFETY: the caller's.
    unsafe { x[2].fma(x[2], x[1].fma(x[1], x[0].mul(x[0]))) }
}

#[inline(always)]
unsafe fn add<L: Lanes>(x: &[L; 3], potential: L, inverse2: L, sums: &mut [L; 4]) {
    // SAFETY: the caller's.
    unsafe {
        let weight = potential.mul(inverse2);
        for k in 0..3 {
            sums[k] = weight.fnma(x[k], sums[k]);
        }
        sums[3] = sums[3].add(potential);
    }
}
