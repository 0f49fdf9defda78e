//! A table on a grid that is quick to read: pressure over the logarithm of density and over
//!
//! ```text
//! y = ln(1 + (u - u_c(rho)) / u_s)
//! ```
//! u specific internal energy, u_c that of the coldest matter of a density, u_s a scale, J/kg. Each row of the table is brought onto
//! the same steps in y along a curve that does not overshoot (`curve`); between rows and steps pressure is a product of such cubics, so
//! that it and its derivatives are continuous. Beyond the table: matter below the coldest is as cold as that; hotter matter is a gas, P ~
//! u - u_c; so is thinner matter, P ~ rho; in denser matter P ~ rho^2.

use serde::{Deserialize, Serialize};

use super::super::slopes::Slopes;
use super::curve;
use super::formats::Row;

/// Steps in y for each temperature of the table, and how many there are at least and at most.
const FINER: usize = 2;
const STEPS: [usize; 2] = [64, 1024];

/// What is known at a node: pressure, and its derivatives by ln rho, by y, and by both.
type Node = [f64; 4];

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "Vec<Row>", into = "Vec<Row>")]
pub struct Grid {
    rows: Vec<Row>,
    /// ln rho of each row.
    places: Vec<f64>,
    densities: [f64; 2],
    /// u_c of each row, J/kg, and its slope over ln rho.
    coldest: Vec<[f64; 2]>,
    scale: f64,
    /// Of y.
    step: f64,
    steps: usize,
    nodes: Vec<Node>,
}

impl PartialEq for Grid {
    fn eq(&self, other: &Self) -> bool {
        self.rows == other.rows
    }
}

impl From<Grid> for Vec<Row> {
    fn from(grid: Grid) -> Self {
        grid.rows
    }
}

impl TryFrom<Vec<Row>> for Grid {
    type Error = String;
    fn try_from(rows: Vec<Row>) -> Result<Self, String> {
        Self::new(rows)
    }
}

/// Where a state lies in the table.
#[derive(Clone, Copy)]
struct Place {
    row: usize,
    /// Share of the way to the next row, and that way in ln rho.
    t: f64,
    width: f64,
    /// u_c there, J/kg, and its slope over ln rho.
    coldest: [f64; 2],
}

impl Grid {
    /// The grid of a table's rows; or what is wrong with them.
    pub fn new(mut rows: Vec<Row>) -> Result<Self, String> {
        rows.iter_mut().for_each(thin_out);
        // Tables often begin with nothing at all.
        rows.retain(|row| row.density != 0.0);
        check(&rows)?;
        let places: Vec<f64> = rows.iter().map(|row| libm::log(row.density)).collect();
        let cold: Vec<f64> = rows.iter().map(|row| row.energy[0]).collect();
        let coldest = cold.iter().copied().zip(curve::slopes(&places, &cold)).map(<[f64; 2]>::from).collect();
        let range = |row: &Row| row.energy[row.energy.len() - 1] - row.energy[0];
        let hottest = rows.iter().map(range).fold(0.0, f64::max);
        let first = rows.iter().map(|row| row.energy[1] - row.energy[0]).fold(f64::INFINITY, f64::min);
        let scale = first.max(1e-6 * hottest);
        let most = rows.iter().map(|row| row.energy.len()).max().unwrap_or(0);
        let steps = (FINER * most).clamp(STEPS[0], STEPS[1]);
        let step = libm::log1p(hottest / scale) / (steps - 1) as f64;
        let densities = [rows[0].density, rows[rows.len() - 1].density];
        let mut grid = Self { rows, places, densities, coldest, scale, step, steps, nodes: Vec::new() };
        grid.nodes = grid.made_nodes();
        Ok(grid)
    }

    fn made_nodes(&self) -> Vec<Node> {
        let y: Vec<f64> = (0..self.steps).map(|j| j as f64 * self.step).collect();
        let mut nodes = vec![[0.0; 4]; self.rows.len() * self.steps];
        for (i, row) in self.rows.iter().enumerate() {
            let x: Vec<f64> = row.energy.iter().map(|u| u - row.energy[0]).collect();
            let m = curve::slopes(&x, &row.pressure);
            let p: Vec<f64> =
                y.iter().map(|y| curve::at(&x, &row.pressure, &m, self.scale * libm::expm1(*y))).collect();
            for (j, (p, slope)) in p.iter().zip(curve::slopes(&y, &p)).enumerate() {
                nodes[i * self.steps + j] = [*p, 0.0, slope, 0.0];
            }
        }
        for j in 0..self.steps {
            for (from, to) in [(0, 1), (2, 3)] {
                let along: Vec<f64> = (0..self.rows.len()).map(|i| nodes[i * self.steps + j][from]).collect();
                for (i, slope) in curve::slopes(&self.places, &along).into_iter().enumerate() {
                    nodes[i * self.steps + j][to] = slope;
                }
            }
        }
        nodes
    }

    fn place(&self, rho: f64) -> Place {
        let place = libm::log(rho);
        let row = self.places.partition_point(|&row| row <= place).clamp(1, self.places.len() - 1) - 1;
        let width = self.places[row + 1] - self.places[row];
        let t = ((place - self.places[row]) / width).clamp(0.0, 1.0);
        let ([before, m_before], [after, m_after]) = (self.coldest[row], self.coldest[row + 1]);
        let sum = |w: [f64; 4]| w[0] * before + w[1] * after + width * (w[2] * m_before + w[3] * m_after);
        let coldest = [sum(curve::weights(t)), sum(curve::slope_weights(t)) / width];
        Place { row, t, width, coldest }
    }

    /// Pressure and its derivatives at a density, kg/m^3, and an energy, J/kg.
    pub fn state(&self, rho: f64, u: f64) -> Slopes {
        let [thinnest, densest] = self.densities;
        let inside = if rho < thinnest { thinnest } else { rho.min(densest) };
        let state = self.within(inside, u);
        let power = match () {
            () if rho < thinnest => 1.0,
            () if rho > densest => 2.0,
            () => return state,
        };
        let share = libm::pow(rho / inside, power);
        Slopes { p: share * state.p, by_rho: power * share * state.p / rho, by_u: share * state.by_u }
    }

    fn within(&self, rho: f64, u: f64) -> Slopes {
        let place = self.place(rho);
        let [coldest, its_slope] = place.coldest;
        let x = if u > coldest { u - coldest } else { 0.0 };
        let y = libm::log1p(x / self.scale) / self.step;
        let column = (y as usize).min(self.steps - 2);
        let s = y - column as f64;
        let [p, by_place, by_y] = self.interpolated(&place, column, s.min(1.0));
        let hottest = self.scale * libm::expm1((self.steps - 1) as f64 * self.step);
        let (share, by_x) = if x > hottest { (x / hottest, p / hottest) } else { (1.0, by_y / (self.scale + x)) };
        let by_u = if u < coldest { 0.0 } else { by_x };
        Slopes { p: share * p, by_rho: (share * by_place - by_u * its_slope) / rho, by_u }
    }

    /// Pressure and its derivatives by ln rho and y.
    fn interpolated(&self, place: &Place, column: usize, s: f64) -> [f64; 3] {
        let (along, across) = (curve::weights(place.t), curve::weights(s));
        let (along_slope, across_slope) = (curve::slope_weights(place.t), curve::slope_weights(s));
        let mut sums = [0.0; 3];
        for i in 0..2 {
            for j in 0..2 {
                let [p, by_place, by_y, by_both] = self.nodes[(place.row + i) * self.steps + column + j];
                let (by_place, by_y) = (place.width * by_place, self.step * by_y);
                let by_both = place.width * self.step * by_both;
                let sum = |a: &[f64; 4], b: &[f64; 4]| {
                    a[i] * (b[j] * p + b[2 + j] * by_y) + a[2 + i] * (b[j] * by_place + b[2 + j] * by_both)
                };
                sums[0] += sum(&along, &across);
                sums[1] += sum(&along_slope, &across) / place.width;
                sums[2] += sum(&along, &across_slope) / self.step;
            }
        }
        sums
    }

    /// Energy of a temperature at a density, J/kg; none where the table has no temperatures.
    pub fn energy_at(&self, rho: f64, temperature: f64) -> Option<f64> {
        let place = self.place(rho);
        let of_row = |row: &Row| {
            let (t, u) = (&row.temperature, &row.energy);
            let k = t.partition_point(|&t| t <= temperature).clamp(1, t.len().max(2) - 1);
            let share = (temperature - t.get(k - 1)?) / (t.get(k)? - t[k - 1]);
            Some(u[k - 1] + share.clamp(0.0, 1.0) * (u[k] - u[k - 1]))
        };
        let (before, after) = (of_row(&self.rows[place.row])?, of_row(&self.rows[place.row + 1])?);
        Some(before + place.t * (after - before))
    }

    /// Temperature at a density, kg/m^3, and an energy, J/kg, in K; none where the table has no temperatures.
    pub fn temperature(&self, rho: f64, u: f64) -> Option<f64> {
        let (place, x) = self.above_coldest(rho, u);
        let of_row = |row: &Row| {
            let (k, share) = before(row, x);
            Some(row.temperature.get(k)? + share * (row.temperature.get(k + 1)? - row.temperature[k]))
        };
        let (before, after) = (of_row(&self.rows[place.row])?, of_row(&self.rows[place.row + 1])?);
        Some(before + place.t * (after - before))
    }

    /// The number of the phase of the state of the table next to a density, kg/m^3, and an energy, J/kg; none where it has no phases.
    pub fn phase(&self, rho: f64, u: f64) -> Option<f64> {
        let (place, x) = self.above_coldest(rho, u);
        let row = &self.rows[if place.t < 0.5 { place.row } else { place.row + 1 }];
        let (k, share) = before(row, x);
        row.phase.get(if share < 0.5 { k } else { k + 1 }).copied()
    }

    /// A place, and how much energy matter there has above the coldest, J/kg.
    fn above_coldest(&self, rho: f64, u: f64) -> (Place, f64) {
        let [thinnest, densest] = self.densities;
        let place = self.place(if rho > thinnest { rho.min(densest) } else { thinnest });
        (place, (u - place.coldest[0]).max(0.0))
    }

    /// Least and largest density, kg/m^3.
    pub fn densities(&self) -> [f64; 2] {
        self.densities
    }
}

/// The point of a row before an energy above its coldest, J/kg, and the share of the way to the next; within the row.
fn before(row: &Row, x: f64) -> (usize, f64) {
    let energy = |k: usize| row.energy[k] - row.energy[0];
    let k = row.energy.partition_point(|u| u - row.energy[0] <= x).clamp(1, row.energy.len() - 1) - 1;
    (k, ((x - energy(k)) / (energy(k + 1) - energy(k))).clamp(0.0, 1.0))
}

/// Leaves out points that are no hotter than those before them.
fn thin_out(row: &mut Row) {
    let mut last = f64::NEG_INFINITY;
    let kept: Vec<bool> = row
        .energy
        .iter()
        .map(|&u| {
            u > last && {
                last = u;
                true
            }
        })
        .collect();
    for numbers in [&mut row.energy, &mut row.pressure, &mut row.temperature, &mut row.phase] {
        let mut kept = kept.iter();
        numbers.retain(|_| *kept.next().unwrap_or(&true));
    }
}

/// Rows of which a grid can be made.
const FEWEST_ROWS: usize = 3;

fn check(rows: &[Row]) -> Result<(), String> {
    if rows.len() < FEWEST_ROWS {
        return Err(format!("{} densities, where {FEWEST_ROWS} are the least", rows.len()));
    }
    if let Some(row) = rows.iter().find(|row| row.energy.len() < 2) {
        return Err(format!("at {} kg/m^3 energy does not rise", row.density));
    }
    let numbers = |row: &Row| row.energy.iter().chain(&row.pressure).chain(&row.temperature).all(|x| x.is_finite());
    if let Some(row) = rows.iter().find(|row| !(row.density > 0.0 && row.density.is_finite() && numbers(row))) {
        return Err(format!("at {} kg/m^3 not all numbers are finite", row.density));
    }
    if let Some(row) = rows.iter().find(|row| ![0, row.energy.len()].contains(&row.temperature.len())) {
        return Err(format!("at {} kg/m^3 only some states have a temperature", row.density));
    }
    match rows.windows(2).find(|pair| pair[0].density >= pair[1].density) {
        Some(pair) => Err(format!("a density of {} kg/m^3 follows {}", pair[1].density, pair[0].density)),
        None => Ok(()),
    }
}
