//! An axis, linear or logarithmic, with ticks at round numbers.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Numbers along an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    pub logarithmic: bool,
}

impl Scale {
    /// Holds all values with a little room; those that a logarithmic axis cannot show are left out.
    pub fn around(values: impl Iterator<Item = f64>, logarithmic: bool) -> Self {
        let shown = values.filter(|x| x.is_finite() && (!logarithmic || *x > 0.0));
        let (low, high) = shown.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
        match (low <= high, logarithmic) {
            (false, _) => Self { low: 0.1, high: 1.0, logarithmic },
            (true, true) => {
                let room = libm::pow(high / low, 0.04).max(1.15);
                Self { low: low / room, high: high * room, logarithmic }
            }
            (true, false) => {
                let room = if high > low { 0.04 * (high - low) } else { (0.1 * high.abs()).max(0.1) };
                Self { low: low - room, high: high + room, logarithmic }
            }
        }
    }

    /// 0 at the low end, 1 at the high one.
    pub fn fraction(&self, x: f64) -> f64 {
        if self.logarithmic {
            let x = x.max(f64::MIN_POSITIVE);
            libm::log(x / self.low) / libm::log(self.high / self.low)
        } else {
            (x - self.low) / (self.high - self.low)
        }
    }

    /// Round numbers on the axis, about `count` of them.
    pub fn ticks(&self, count: usize) -> Vec<f64> {
        let decades = if self.logarithmic { libm::log10(self.high / self.low) } else { 0.0 };
        if decades < 0.7 {
            return self.linear_ticks(count);
        }
        let all: &[f64] = if decades < 2.5 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let stride = (decades / count.max(1) as f64).ceil().max(1.0) as usize;
        let (first, last) = (libm::log10(self.low).floor() as i32, libm::log10(self.high).ceil() as i32);
        let exponents = (first..=last).filter(|e| e.rem_euclid(stride as i32) == 0);
        let ticks = exponents.flat_map(|e| all.iter().map(move |m| m * libm::exp10(e as f64)));
        ticks.filter(|x| *x >= self.low && *x <= self.high).collect()
    }

    fn linear_ticks(&self, count: usize) -> Vec<f64> {
        let rough = (self.high - self.low) / count.max(1) as f64;
        let power = libm::exp10(libm::log10(rough).floor());
        let step =
            [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= 0.7 * rough).unwrap_or(10.0 * power);
        let (first, last) = ((self.low / step).ceil() as i64, (self.high / step + 1e-9).floor() as i64);
        (first..=last).map(|k| k as f64 * step).collect()
    }
}

/// A tick's number in few characters.
pub fn number(x: f64) -> String {
    let size = x.abs();
    if size != 0.0 && !(1e-3..1e4).contains(&size) {
        let text = format!("{x:.2e}");
        let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let digits = digits.trim_end_matches('0').trim_end_matches('.');
        let power = superscript(exponent);
        return if digits == "1" { format!("10{power}") } else { format!("{digits}×10{power}") };
    }
    let text = format!("{x:.6}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

fn superscript(exponent: &str) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    exponent.chars().map(|c| c.to_digit(10).map_or('⁻', |d| DIGITS[d as usize])).collect()
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        // Far points are drawn beyond the edge, where the canvas clips them.
        let fraction = self.fraction(*value).clamp(-5.0, 6.0);
        (limit.0 as f64 + fraction * (limit.1 - limit.0) as f64).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        self.ticks(hint.bold_points().min(8))
    }

    fn range(&self) -> Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, value: &f64) -> String {
        number(*value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let linear = Scale { low: -0.03, high: 1.04, logarithmic: false };
        assert_eq!(
            linear.ticks(5).iter().map(|x| number(*x)).collect::<Vec<_>>(),
            ["0", "0.2", "0.4", "0.6", "0.8", "1"]
        );
        let log = Scale { low: 3e4, high: 2e9, logarithmic: true };
        let labels: Vec<String> = log.ticks(8).iter().map(|x| number(*x)).collect();
        assert_eq!(labels, ["10⁵", "10⁶", "10⁷", "10⁸", "10⁹"]);
    }

    #[test]
    fn a_scale_holds_its_values() {
        for logarithmic in [false, true] {
            let scale = Scale::around([3.0, f64::NAN, 700.0, 20.0].into_iter(), logarithmic);
            assert!(scale.fraction(3.0) > 0.0 && scale.fraction(700.0) < 1.0);
            assert!(scale.fraction(20.0) > scale.fraction(3.0));
        }
        let log = Scale { low: 1.0, high: 100.0, logarithmic: true };
        assert!((log.fraction(10.0) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, -0.25, 100.0, 2.5e7, 1e-9].map(number);
        assert_eq!(texts, ["0", "-0.25", "100", "2.5×10⁷", "10⁻⁹"]);
    }
}
