//! Colours: a map from numbers that is perceptually uniform and readable in grey, and hues that distinguish curves.

use plotters::style::RGBColor;

/// Control points at equal distances, dark blue to yellow, of rising lightness (in the manner of Smith and van der Walt's
/// viridis, 2015).
const MAP: [[f64; 3]; 9] = [
    [68.0, 1.0, 84.0],
    [71.0, 44.0, 122.0],
    [59.0, 81.0, 139.0],
    [44.0, 113.0, 142.0],
    [33.0, 144.0, 141.0],
    [39.0, 173.0, 129.0],
    [92.0, 200.0, 99.0],
    [170.0, 220.0, 50.0],
    [253.0, 231.0, 37.0],
];

/// Distinct for colour-blind readers too (Okabe and Ito 2008).
pub const HUES: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(60, 60, 60),
];

/// The colour of a fraction from 0 to 1; beyond, that of the nearer end.
pub fn colour(fraction: f64) -> RGBColor {
    let at = fraction.clamp(0.0, 1.0) * (MAP.len() - 1) as f64;
    let k = (at as usize).min(MAP.len() - 2);
    let mix = |c: usize| (MAP[k][c] + (at - k as f64) * (MAP[k + 1][c] - MAP[k][c])).round() as u8;
    RGBColor(mix(0), mix(1), mix(2))
}

/// How numbers become colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shades {
    /// [`colour`].
    Colours,
    /// White at the low end, black at the high one.
    Greys,
    /// Light below the middle, dark above.
    LightAndDark,
}

/// The colour of a fraction from 0 to 1; beyond, that of the nearer end.
pub fn shade(shades: Shades, fraction: f64) -> RGBColor {
    let grey = |light: f64| RGBColor(light as u8, light as u8, light as u8);
    match shades {
        Shades::Colours => colour(fraction),
        Shades::Greys => grey((255.0 * (1.0 - fraction.clamp(0.0, 1.0))).round()),
        Shades::LightAndDark => grey(if fraction > 0.5 { 30.0 } else { 205.0 }),
    }
}

/// The colour of curve number `k`.
pub fn hue(k: usize) -> RGBColor {
    HUES[k % HUES.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lightness_rises_all_the_way() {
        let luminance = |c: RGBColor| 0.2126 * c.0 as f64 + 0.7152 * c.1 as f64 + 0.0722 * c.2 as f64;
        let values: Vec<f64> = (0..=32).map(|k| luminance(colour(k as f64 / 32.0))).collect();
        assert!(values.windows(2).all(|w| w[1] > w[0]), "{values:?}");
    }

    #[test]
    fn greys_fall_from_white_to_black() {
        let greys = [0.0, 0.5, 1.0, 7.0].map(|fraction| shade(Shades::Greys, fraction).0);
        assert_eq!(greys, [255, 128, 0, 0]);
    }

    #[test]
    fn ends_are_held() {
        assert_eq!(colour(-1.0), colour(0.0));
        assert_eq!(colour(f64::INFINITY), colour(1.0));
    }
}
