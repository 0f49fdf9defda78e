//! Multi-indices (a, b, c) of Cartesian expansions, by degree n = a + b + c: all numbers of a table come from here.

/// The highest order of an expansion.
pub const HIGHEST: usize = 5;
/// Multi-indices up to that order.
pub const MOST: usize = count(HIGHEST);
/// Multi-indices up to the degree above it, to which derivatives are needed.
pub const ALL: usize = count(HIGHEST + 1);

/// Multi-indices of degree `order` and below.
pub const fn count(order: usize) -> usize {
    (order + 1) * (order + 2) * (order + 3) / 6
}

/// Number of a multi-index.
pub const fn index(a: usize, b: usize, c: usize) -> usize {
    let n = a + b + c;
    n * (n + 1) * (n + 2) / 6 + (n - a) * (n - a + 1) / 2 + c
}

/// The multi-indices in their order.
pub const POWERS: [[usize; 3]; ALL] = {
    let mut all = [[0; 3]; ALL];
    let mut n = 0;
    while n <= HIGHEST + 1 {
        let mut a = 0;
        while a <= n {
            let mut c = 0;
            while c <= n - a {
                all[index(a, n - a - c, c)] = [a, n - a - c, c];
                c += 1;
            }
            a += 1;
        }
        n += 1;
    }
    all
};

/// a + b + c.
pub const fn degree(index: usize) -> usize {
    let [a, b, c] = POWERS[index];
    a + b + c
}

/// Number of the sum of two multi-indices; 0 where its degree is too high.
pub static SUM: [[u8; MOST]; ALL] = {
    let mut sums = [[0; MOST]; ALL];
    let mut i = 0;
    while i < ALL {
        let mut j = 0;
        while j < MOST {
            if degree(i) + degree(j) <= HIGHEST + 1 {
                let (p, q) = (POWERS[i], POWERS[j]);
                sums[i][j] = index(p[0] + q[0], p[1] + q[1], p[2] + q[2]) as u8;
            }
            j += 1;
        }
        i += 1;
    }
    sums
};

/// x^a y^b z^c / (a! b! c!) for all multi-indices of `order` and below.
pub fn monomials(order: usize, x: &[f64; 3]) -> [f64; MOST] {
    let mut powers = [[1.0; HIGHEST + 1]; 3];
    for (powers, x) in powers.iter_mut().zip(x) {
        for n in 1..=order {
            powers[n] = powers[n - 1] * x / n as f64;
        }
    }
    let mut all = [0.0; MOST];
    for (value, [a, b, c]) in all[..count(order)].iter_mut().zip(POWERS) {
        *value = powers[0][a] * powers[1][b] * powers[2][c];
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_go_on_without_gaps_and_sums_add_powers() {
        for (number, [a, b, c]) in POWERS.into_iter().enumerate() {
            assert_eq!(index(a, b, c), number);
            assert!(number < count(a + b + c) && (a + b + c == 0 || number >= count(a + b + c - 1)));
        }
        for (i, p) in POWERS.iter().enumerate() {
            for (j, q) in POWERS[..MOST].iter().enumerate().filter(|(j, _)| degree(i) + degree(*j) <= HIGHEST + 1) {
                assert_eq!(POWERS[SUM[i][j] as usize], [p[0] + q[0], p[1] + q[1], p[2] + q[2]]);
            }
        }
    }

    #[test]
    fn monomials_are_divided_by_factorials() {
        let values = monomials(4, &[2.0, -3.0, 5.0]);
        assert_eq!(values[index(2, 1, 1)], 4.0 * -3.0 * 5.0 / 2.0);
        assert!((values[index(0, 4, 0)] - 81.0 / 24.0).abs() < 1e-14);
    }
}
