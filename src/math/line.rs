//! Straight lines through points.

/// A straight line by least squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    pub slope: f64,
    /// Standard error of the slope, for three points and more.
    pub standard_error: Option<f64>,
    pub intercept: f64,
    /// Root of the mean square by which points are off in y.
    pub scatter: f64,
}

impl Line {
    /// The line through points (x, y); none through fewer than two x.
    pub fn through(points: &[(f64, f64)]) -> Option<Self> {
        let n = points.len() as f64;
        let mean = |get: fn(&(f64, f64)) -> f64| points.iter().map(get).sum::<f64>() / n;
        let (x_mean, y_mean) = (mean(|p| p.0), mean(|p| p.1));
        let sxx: f64 = points.iter().map(|p| (p.0 - x_mean) * (p.0 - x_mean)).sum();
        if points.len() < 2 || sxx <= 0.0 {
            return None;
        }
        let slope = points.iter().map(|p| (p.0 - x_mean) * (p.1 - y_mean)).sum::<f64>() / sxx;
        let intercept = y_mean - slope * x_mean;
        let residual: f64 = points.iter().map(|p| p.1 - intercept - slope * p.0).map(|r| r * r).sum();
        let standard_error = (points.len() > 2).then(|| (residual / (n - 2.0) / sxx).sqrt());
        Some(Self { slope, standard_error, intercept, scatter: (residual / n).sqrt() })
    }

    pub fn at(&self, x: f64) -> f64 {
        self.intercept + self.slope * x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_off_is_known() {
        let line = Line::through(&[(0.0, 2.0), (1.0, 3.0), (2.0, 2.0), (3.0, 3.0)]).expect("four points");
        // sxx = 5, sxy = 1; residuals -0.2, 0.6, -0.6, 0.2.
        assert!((line.slope - 0.2).abs() < 1e-15 && (line.at(1.5) - 2.5).abs() < 1e-15);
        assert!((line.scatter - f64::sqrt(0.2)).abs() < 1e-15);
        assert!((line.standard_error.expect("more than two") - f64::sqrt(0.08)).abs() < 1e-15);
        assert!(Line::through(&[(1.0, 2.0), (1.0, 3.0)]).is_none() && Line::through(&[]).is_none());
    }
}
