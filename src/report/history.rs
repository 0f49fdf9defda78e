//! history.csv as the page takes it: columns of numbers, thinned where there are many rows.

use serde_json::{Value as Json, json};

/// Rows at most.
const MOST: usize = 1500;

/// Names, units and columns; columns of words are left out.
pub fn table(text: &str) -> Json {
    let mut lines = text.lines();
    let titles: Vec<(String, String)> = lines.next().unwrap_or_default().split(',').map(title).collect();
    let rows: Vec<Vec<Option<f64>>> = lines
        .map(|line| line.split(',').map(|cell| cell.parse().ok().filter(|x: &f64| x.is_finite())).collect::<Vec<_>>())
        .filter(|row| row.len() == titles.len())
        .collect();
    let stride = rows.len().div_ceil(MOST).max(1);
    // The last row is what the run has come to.
    let kept: Vec<usize> = (0..rows.len()).filter(|row| row % stride == 0 || row + 1 == rows.len()).collect();
    let columns = (0..titles.len()).filter(|k| rows.iter().any(|row| row[*k].is_some()));
    let columns: Vec<usize> = columns.collect();
    let values = |k: usize| kept.iter().map(|row| rows[*row][k].map(short)).collect::<Vec<_>>();
    json!({
        "names": columns.iter().map(|k| &titles[*k].0).collect::<Vec<_>>(),
        "units": columns.iter().map(|k| &titles[*k].1).collect::<Vec<_>>(),
        "columns": columns.iter().map(|k| values(*k)).collect::<Vec<_>>(),
    })
}

/// `time [s]` -> name and unit.
fn title(cell: &str) -> (String, String) {
    let cell = cell.trim().trim_matches('"');
    match cell.split_once(" [") {
        Some((name, unit)) => (name.to_string(), unit.trim_end_matches(']').to_string()),
        None => (cell.to_string(), String::new()),
    }
}

/// Seven digits: more cannot be seen.
fn short(x: f64) -> f64 {
    format!("{x:.6e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_thinned_and_words_left_out() {
        let mut text = "step,time [s],limited_by,kinetic_energy [J]\n".to_string();
        (0..10_000).for_each(|k| text += &format!("{k},{}e-3,CFL,{}\n", k, 1.0 / 3.0));
        text += "10000,10,CFL,nan\nbroken";
        let table = table(&text);
        assert_eq!(table["names"], json!(["step", "time", "kinetic_energy"]));
        assert_eq!(table["units"], json!(["", "s", "J"]));
        let time = table["columns"][1].as_array().unwrap();
        assert!(time.len() <= MOST + 1 && time.last() == Some(&json!(10.0)));
        assert_eq!(table["columns"][2].as_array().unwrap().last(), Some(&Json::Null));
        assert_eq!(table["columns"][2][0], json!(0.3333333));
    }
}
