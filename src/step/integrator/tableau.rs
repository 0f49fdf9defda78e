//! Coefficients of Cash & Karp (1990, ACM Trans. Math. Softw. 16, 201, table II): six stages, fifth order, with an embedded fourth.
//!
//! Positions follow from accelerations alone: with v_j = v_0 + dt sum_l a_jl k_l,
//!
//! ```text
//! x_i = x_0 + dt sum_j a_ij v_j = x_0 + c_i dt v_0 + dt^2 sum_l (A A)_il k_l
//! ```
//! so that no stage's velocity is kept beside its acceleration.

/// Stages.
pub const STAGES: usize = 6;
/// Rates of stages that later ones read; the last one's is used at once.
pub const KEPT: usize = STAGES - 1;

/// One weight for the rate of each stage.
pub type Weights = [f64; STAGES];

/// The moment of each stage as a share of the step.
pub const MOMENTS: Weights = [0.0, 1.0 / 5.0, 3.0 / 10.0, 3.0 / 5.0, 1.0, 7.0 / 8.0];

/// a_ij: rates of the stages before, for the state of stage i.
pub const STAGE: [Weights; STAGES] = [
    [0.0; STAGES],
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 10.0, -9.0 / 10.0, 6.0 / 5.0, 0.0, 0.0, 0.0],
    [-11.0 / 54.0, 5.0 / 2.0, -70.0 / 27.0, 35.0 / 27.0, 0.0, 0.0],
    [1631.0 / 55296.0, 175.0 / 512.0, 575.0 / 13824.0, 44275.0 / 110592.0, 253.0 / 4096.0, 0.0],
];

/// Of fifth order.
pub const END: Weights = [37.0 / 378.0, 0.0, 250.0 / 621.0, 125.0 / 594.0, 0.0, 512.0 / 1771.0];

/// Of fourth order.
const EMBEDDED: Weights = [2825.0 / 27648.0, 0.0, 18575.0 / 48384.0, 13525.0 / 55296.0, 277.0 / 14336.0, 1.0 / 4.0];

/// Fifth order less fourth.
pub const ERROR: Weights = less(END, EMBEDDED);

/// Weights of accelerations in positions, for the sums over velocities with the weights of the same name.
pub const PLACE_STAGE: [Weights; STAGES] = {
    let mut all = [[0.0; STAGES]; STAGES];
    let mut i = 0;
    while i < STAGES {
        all[i] = twice(STAGE[i]);
        i += 1;
    }
    all
};
pub const PLACE_END: Weights = twice(END);
pub const PLACE_ERROR: Weights = twice(ERROR);

const fn less(mut a: Weights, b: Weights) -> Weights {
    let mut i = 0;
    while i < STAGES {
        a[i] -= b[i];
        i += 1;
    }
    a
}

/// sum_j w_j a_jl.
const fn twice(weights: Weights) -> Weights {
    let mut sums = [0.0; STAGES];
    let mut j = 0;
    while j < STAGES {
        let mut l = 0;
        while l < STAGES {
            sums[l] += weights[j] * STAGE[j][l];
            l += 1;
        }
        j += 1;
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(a: &Weights, b: &Weights) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    fn times(a: &Weights, b: &Weights) -> Weights {
        std::array::from_fn(|i| a[i] * b[i])
    }

    /// A v.
    fn before(v: &Weights) -> Weights {
        STAGE.map(|row| dot(&row, v))
    }

    /// The conditions for the 17 rooted trees of up to five nodes (Hairer, Norsett & Wanner 1993, II.2): what a scheme sums over each,
    /// and one over the tree's density. Five are of the fourth order or less.
    fn conditions(b: &Weights) -> Vec<(usize, f64, f64)> {
        let (one, c) = ([1.0; STAGES], MOMENTS);
        let c2 = times(&c, &c);
        let (c3, ac, ac2) = (times(&c2, &c), before(&c), before(&c2));
        let aac = before(&ac);
        [
            (1, one, 1.0),
            (2, c, 2.0),
            (3, c2, 3.0),
            (3, ac, 6.0),
            (4, c3, 4.0),
            (4, times(&c, &ac), 8.0),
            (4, ac2, 12.0),
            (4, aac, 24.0),
            (5, times(&c3, &c), 5.0),
            (5, times(&c2, &ac), 10.0),
            (5, times(&c, &ac2), 15.0),
            (5, times(&c, &aac), 30.0),
            (5, times(&ac, &ac), 20.0),
            (5, before(&c3), 20.0),
            (5, before(&times(&c, &ac)), 40.0),
            (5, before(&ac2), 60.0),
            (5, before(&aac), 120.0),
        ]
        .map(|(order, sum, density)| (order, dot(b, &sum), 1.0 / density))
        .to_vec()
    }

    #[test]
    fn rows_sum_to_the_moments() {
        for (row, moment) in STAGE.iter().zip(MOMENTS) {
            assert!((row.iter().sum::<f64>() - moment).abs() < 1e-15, "{row:?}");
        }
    }

    #[test]
    fn the_step_is_of_fifth_order_and_the_embedded_one_of_fourth() {
        for (order, sum, exact) in conditions(&END) {
            assert!((sum - exact).abs() < 1e-15, "order {order}: {sum} is not {exact}");
        }
        for (order, sum, exact) in conditions(&EMBEDDED) {
            assert!(order == 5 || (sum - exact).abs() < 1e-15, "order {order}: {sum} is not {exact}");
        }
        let missed = conditions(&EMBEDDED).iter().filter(|(_, sum, exact)| (sum - exact).abs() > 1e-6).count();
        assert!(missed > 0, "an embedded scheme of the same order shows no error");
    }

    /// What positions are moved by is what stage velocities would have moved them by.
    #[test]
    fn positions_need_no_stage_velocities() {
        let k = [0.3, -1.1, 0.7, 2.0, -0.4, 0.9];
        let (velocity, dt) = (0.8, 0.5);
        let velocities = before(&k).map(|sum| velocity + dt * sum);
        for (weights, place) in STAGE.iter().zip(&PLACE_STAGE).chain([(&END, &PLACE_END), (&ERROR, &PLACE_ERROR)]) {
            let moved = dt * dot(weights, &velocities);
            let share: f64 = weights.iter().sum();
            let found = dt * share * velocity + dt * dt * dot(place, &k);
            assert!((moved - found).abs() < 1e-15, "{moved} is not {found}");
        }
        assert_eq!(PLACE_END[KEPT], 0.0);
        assert!(ERROR.iter().sum::<f64>().abs() < 1e-15);
    }
}
