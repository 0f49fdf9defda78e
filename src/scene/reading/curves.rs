//! Measured curves in files: `measured = { file = "curve.csv" }` is read into the scene when it is read, so that a scene stays one
//! text that any rank can read again.

use toml::{Table, Value};

use crate::error::{Error, Result};
use crate::scene::document::input;
use crate::scene::document::source::{Document, SourceText};

/// Puts the points of every file that a crush curve names over the scene, as `--set` would. Paths start at the scene's folder.
pub fn read_into(source: &mut SourceText) -> Result<()> {
    let mut overrides = Vec::new();
    {
        let document = Document::parse(source)?;
        let materials = document.tree.get("material").and_then(Value::as_table);
        for (name, material) in materials.into_iter().flatten() {
            for law in ["p_alpha", "rho_alpha"] {
                let measured = ["porosity", law, "measured"].iter().try_fold(material, |table, key| table.get(*key));
                let Some(file) = measured.and_then(|table| table.get("file")) else { continue };
                let key = format!("material.{name}.porosity.{law}.measured");
                let wrong = |what: String| document.error(&format!("{key}.file"), what);
                let file = file.as_str().ok_or_else(|| wrong("the file is not a text".into()))?;
                let path = source.folder().join(file);
                let text = input::read(&path).map_err(|e| wrong(format!("cannot read {}: {e}", path.display())))?;
                let points =
                    points(&text).map_err(|(line, what)| Error::new(what).at(format!("{}:{line}", path.display())))?;
                overrides.push(format!("{key}={}", Value::Table(points)));
            }
        }
    }
    source.overrides.extend(overrides);
    Ok(())
}

/// Columns of pressure, Pa, and distention; lines of words and those that begin with # do not count.
fn points(text: &str) -> std::result::Result<Table, (usize, String)> {
    let mut columns = [Vec::new(), Vec::new()];
    for (number, line) in (1..).zip(text.lines()) {
        let cells: Vec<&str> = line.split([',', ';', '\t']).map(str::trim).collect();
        let numbers: Option<Vec<f64>> = cells.iter().map(|cell| cell.parse().ok()).collect();
        match numbers.as_deref() {
            Some([pressure, distention]) => {
                columns[0].push(Value::Float(*pressure));
                columns[1].push(Value::Float(*distention));
            }
            Some(others) => return Err((number, format!("{} numbers, not a pressure and a distention", others.len()))),
            None if line.trim().is_empty() || line.starts_with('#') || columns[0].is_empty() => {}
            None => return Err((number, format!("`{}` is no pressure in Pa and a distention", line.trim()))),
        }
    }
    let named = ["pressure", "distention"].map(String::from).into_iter();
    Ok(named.zip(columns.map(Value::Array)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_read_and_bad_lines_are_named() {
        let table = points("# pumice\npressure,distention\n1e6,4.64\n\n2.13e8, 1\n").unwrap();
        assert_eq!(
            Value::Table(table).to_string(),
            "{ pressure = [1000000.0, 213000000.0], distention = [4.64, 1.0] }"
        );
        assert_eq!(points("1e6,4\n2e6\n").unwrap_err(), (2, "1 numbers, not a pressure and a distention".into()));
        assert_eq!(points("1e6,4\na,b\n").unwrap_err().0, 2);
    }

    #[test]
    fn a_scene_takes_its_curve_from_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let scene = folder.path().join("s.toml");
        std::fs::write(folder.path().join("c.csv"), "1e6,4.64\n1e7,2.2\n2.13e8,1\n").unwrap();
        let text = "[[body]]\nname = \"rock\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"pumice\"\nparticles = 100\n\
            [material.pumice.porosity.p_alpha]\nmeasured = { file = \"c.csv\" }\n[run]\nuntil = 1\n";
        std::fs::write(&scene, text).unwrap();
        let read = crate::scene::read(&scene, &[]).unwrap();
        let porosity = read.materials[0].porosity.clone().unwrap();
        assert_eq!(porosity.p_alpha.unwrap().measured.unwrap().distention.len(), 3);
        // Again, as every rank does, without the file.
        std::fs::remove_file(folder.path().join("c.csv")).unwrap();
        assert!(read.reread(&[]).is_ok());
        let message = crate::scene::read(&scene, &[]).unwrap_err().to_string();
        assert!(message.contains("s.toml:7") && message.contains("c.csv"), "{message}");
        std::fs::write(&scene, text.replace("c.csv", "/dev/zero")).unwrap();
        let message = crate::scene::read(&scene, &[]).unwrap_err().to_string();
        assert!(
            message.contains("s.toml:7") && message.contains("/dev/zero: it is neither a regular file"),
            "{message}"
        );
    }
}
