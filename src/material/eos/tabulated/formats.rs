//! Text tables of equations of state, as planetary codes exchange them, read into rows: of each density pressure over energy, with the
//! temperature where the table has it.
//!
//! ```text
//! swift      lines that begin with #; a date; numbers of densities and temperatures; densities, kg/m^3; temperatures, K; then of each
//!            temperature and in it of each density u (J/kg), P (Pa), c (m/s), s (J/kg/K)                 SWIFT, WoMa
//! sesame     six lines of head; from then on fields of 16 characters: numbers of densities and temperatures; densities, g/cm^3;
//!            temperatures, K; of each temperature and in it of each density P, GPa; then u, MJ/kg        M-ANEOS, NEW-SESAME-STD.TXT
//!            and, in NEW-SESAME-EXT.TXT, which of these phases: S, c and c_v, and then a number of each state's phase
//! columns    on each line a density, kg/m^3, an energy, J/kg, a pressure, Pa, and, if there is one, a temperature, K
//! ```

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a table is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Format {
    /// As SWIFT and WoMa have them: over density and temperature, in SI.
    Swift,
    /// As M-ANEOS writes them: SESAME's tables 201 and 301 (`NEW-SESAME-STD.TXT`).
    Sesame,
    /// Columns of density (kg/m^3), energy (J/kg), pressure (Pa) and, if there is one, temperature (K).
    Columns,
}

/// What a table knows of one density, from the coldest on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// kg/m^3.
    pub density: f64,
    /// J/kg.
    pub energy: Vec<f64>,
    /// Pa.
    pub pressure: Vec<f64>,
    /// K; empty where the table has none.
    pub temperature: Vec<f64>,
    /// What M-ANEOS calls KPA, the number of a phase; empty where nobody says it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub phase: Vec<f64>,
}

/// Characters of a field of SESAME's tables, and lines before the first.
const FIELD: usize = 16;
const HEAD: usize = 6;

/// The rows of a table; or what is wrong with it.
pub fn read(format: Format, text: &str) -> Result<Vec<Row>, String> {
    match format {
        Format::Swift => swift(text),
        Format::Sesame => sesame(text),
        Format::Columns => columns(text),
    }
}

fn swift(text: &str) -> Result<Vec<Row>, String> {
    // Lines with words belong to the head; the first of numbers holds the date.
    let lines = text.lines().filter_map(|line| {
        let numbers: Option<Vec<f64>> = line.split_whitespace().map(|word| word.parse().ok()).collect();
        numbers.filter(|numbers| !line.trim_start().starts_with('#') && !numbers.is_empty())
    });
    let numbers: Vec<f64> = lines.skip(1).flatten().collect();
    let mut rest = Numbers(&numbers);
    let [densities, temperatures] = rest.grid()?;
    let (density, temperature) = (rest.take(densities)?, rest.take(temperatures)?);
    let states = rest.take(4 * densities * temperatures)?;
    let state = |what: usize, i: usize, k: usize| states[4 * (k * densities + i) + what];
    Ok(rows(density, temperature, |i, k| [state(0, i, k), state(1, i, k)]))
}

/// Puts the phases of M-ANEOS's extended table beside the rows of its standard one; or says what is wrong.
pub fn add_phases(rows: &mut [Row], text: &str) -> Result<(), String> {
    let numbers = fields(text)?;
    let mut rest = Numbers(&numbers);
    let [densities, temperatures] = rest.grid()?;
    if densities != rows.len() || rows.iter().any(|row| row.temperature.len() != temperatures) {
        return Err(format!(
            "{densities} densities and {temperatures} temperatures, other than the table of pressures"
        ));
    }
    // Densities, temperatures, entropy, speed of sound, heat capacity.
    rest.take(densities + temperatures + 3 * densities * temperatures)?;
    let phase = rest.take(densities * temperatures)?;
    for (i, row) in rows.iter_mut().enumerate() {
        row.phase = (0..temperatures).map(|k| phase[k * densities + i]).collect();
    }
    Ok(())
}

/// The numbers of a table in fields of fixed width.
fn fields(text: &str) -> Result<Vec<f64>, String> {
    let mut numbers = Vec::new();
    for (number, line) in (1..).zip(text.lines()).skip(HEAD) {
        let fields = line.as_bytes().chunks(FIELD).map(|field| std::str::from_utf8(field).unwrap_or("?").trim());
        for field in fields.filter(|field| !field.is_empty()) {
            numbers.push(field.parse().map_err(|_| format!("line {number}: `{field}` is no number"))?);
        }
    }
    Ok(numbers)
}

fn sesame(text: &str) -> Result<Vec<Row>, String> {
    let numbers = fields(text)?;
    let mut rest = Numbers(&numbers);
    let [densities, temperatures] = rest.grid()?;
    let density: Vec<f64> = rest.take(densities)?.iter().map(|rho| 1e3 * rho).collect();
    let temperature = rest.take(temperatures)?;
    let (pressure, energy) = (rest.take(densities * temperatures)?, rest.take(densities * temperatures)?);
    let place = |i: usize, k: usize| k * densities + i;
    Ok(rows(&density, temperature, |i, k| [1e6 * energy[place(i, k)], 1e9 * pressure[place(i, k)]]))
}

fn columns(text: &str) -> Result<Vec<Row>, String> {
    let mut rows: Vec<Row> = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let cells = line.split([',', ';', '\t', ' ']).map(str::trim).filter(|cell| !cell.is_empty());
        let numbers: Option<Vec<f64>> = cells.map(|cell| cell.parse().ok()).collect();
        let (density, energy, pressure, temperature) = match numbers.as_deref() {
            Some([density, energy, pressure]) => (*density, *energy, *pressure, None),
            Some([density, energy, pressure, temperature]) => (*density, *energy, *pressure, Some(*temperature)),
            Some([]) => continue,
            None if line.starts_with('#') || rows.is_empty() => continue,
            _ => return Err(format!("line {number}: `{}` is no density, energy and pressure", line.trim())),
        };
        if rows.last().is_none_or(|row| row.density != density) {
            let [energy, pressure, temperature] = [const { Vec::new() }; 3];
            rows.push(Row { density, energy, pressure, temperature, phase: Vec::new() });
        }
        let row = rows.last_mut().expect("just made");
        row.energy.push(energy);
        row.pressure.push(pressure);
        row.temperature.extend(temperature);
    }
    Ok(rows)
}

/// Rows of a table over density and temperature: energy and pressure of each of both.
fn rows(density: &[f64], temperature: &[f64], state: impl Fn(usize, usize) -> [f64; 2]) -> Vec<Row> {
    let row = |(i, &density): (usize, &f64)| {
        let states = (0..temperature.len()).map(|k| state(i, k));
        let (energy, pressure) = states.map(|[energy, pressure]| (energy, pressure)).unzip();
        Row { density, energy, pressure, temperature: temperature.to_vec(), phase: Vec::new() }
    };
    density.iter().enumerate().map(row).collect()
}

/// Numbers of a table that are yet to be read.
struct Numbers<'a>(&'a [f64]);

/// Densities and temperatures that nobody tabulates.
const MOST: f64 = 1e5;

impl<'a> Numbers<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [f64], String> {
        let (first, rest) = self
            .0
            .split_at_checked(count)
            .ok_or_else(|| format!("it ends {} numbers too early", count - self.0.len()))?;
        self.0 = rest;
        Ok(first)
    }

    /// Numbers of densities and temperatures.
    fn grid(&mut self) -> Result<[usize; 2], String> {
        let sizes = self.take(2)?;
        match sizes.iter().find(|size| !(2.0..MOST).contains(*size) || size.fract() != 0.0) {
            Some(size) => Err(format!("{size} where the numbers of densities and temperatures should be")),
            None => Ok([sizes[0] as usize, sizes[1] as usize]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn expected() -> Vec<Row> {
        let row = |density: f64, energy: [f64; 2], pressure: [f64; 2]| Row {
            density,
            energy: energy.into(),
            pressure: pressure.into(),
            temperature: vec![0.0, 300.0],
            phase: Vec::new(),
        };
        vec![
            row(1000.0, [0.0, 3e5], [-1e9, 2e9]),
            row(2000.0, [1e6, 1.5e6], [4e9, 5e9]),
            row(3000.0, [2e6, 3e6], [6e9, 7e9]),
        ]
    }

    #[test]
    fn all_formats_give_the_same_rows() {
        let swift = "# Material rock\n# more\n20220714\n3 2\n1000 2000 3000\n0 300\n\
            0 -1e9 1 0\n1e6 4e9 1 0\n2e6 6e9 1 0\n3e5 2e9 1 0\n1.5e6 5e9 1 0\n3e6 7e9 1 0\n";
        assert_eq!(read(Format::Swift, swift).unwrap(), expected());
        // The older head is made of words.
        let older = swift.replace("# Material rock\n# more\n", " file version date\n u/(J/kg) inner loop\n");
        assert_eq!(read(Format::Swift, &older).unwrap(), expected());
        let field = |numbers: &[f64]| numbers.iter().map(|x| format!("{x:16.8E}")).collect::<String>();
        let numbers = [
            3.0, 2.0, 1.0, 2.0, 3.0, 0.0, 300.0, -1.0, 4.0, 6.0, 2.0, 5.0, 7.0, 0.0, 1.0, 2.0, 0.3, 1.5, 3.0, 0.0, 0.0,
        ];
        let lines: Vec<String> = numbers.chunks(5).map(field).collect();
        let sesame = format!("{}{}\n", "head\n".repeat(6), lines.join("\n"));
        let read_back = read(Format::Sesame, &sesame).unwrap();
        for (row, expected) in read_back.iter().zip(expected()) {
            assert!((row.density - expected.density).abs() < 1e-9 && row.temperature == expected.temperature);
            let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6 * b.abs().max(1.0));
            assert!(close(&row.energy, &expected.energy) && close(&row.pressure, &expected.pressure), "{row:?}");
        }
        let columns = "rho,u,P,T\n1000,0,-1e9,0\n1000,3e5,2e9,300\n2000,1e6,4e9,0\n2000,1.5e6,5e9,300\n\n\
            3000 2e6 6e9 0\n3000 3e6 7e9 300\n";
        assert_eq!(read(Format::Columns, columns).unwrap(), expected());
    }

    #[test]
    fn phases_stand_beside_the_states() {
        let mut numbers = vec![3.0, 2.0, 1.0, 2.0, 3.0, 0.0, 300.0];
        numbers.extend([7.0; 18]);
        numbers.extend([4.0, 4.0, 4.0, 1.0, 2.0, 6.0]);
        let lines: Vec<String> =
            numbers.chunks(5).map(|line| line.iter().map(|x| format!("{x:16.8E}")).collect::<String>()).collect();
        let text = format!("{}{}\n", "head\n".repeat(6), lines.join("\n"));
        let mut rows = expected();
        add_phases(&mut rows, &text).unwrap();
        assert_eq!([0, 1, 2].map(|i| rows[i].phase.clone()), [vec![4.0, 1.0], vec![4.0, 2.0], vec![4.0, 6.0]]);
        assert!(add_phases(&mut rows[..2], &text).unwrap_err().contains("other than the table of pressures"));
    }

    #[test]
    fn what_is_wrong_is_said() {
        let wrong = |format, text: &str| read(format, text).unwrap_err();
        assert!(wrong(Format::Swift, "# a\n20220714\n3 2\n1 2 3\n0 300\n1 2 3 4\n").contains("20 numbers too early"));
        assert!(wrong(Format::Swift, "# a\n20220714\n3.5 2\n").contains("3.5 where"));
        assert!(wrong(Format::Columns, "1 2 3\n1 2\n").starts_with("line 2"));
        assert!(wrong(Format::Sesame, &format!("{}abc\n", "h\n".repeat(6))).starts_with("line 7: `abc`"));
    }
}
