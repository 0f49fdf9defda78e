//! Tables of equations of state in files: `eos.table = { file = "ANEOS_forsterite.txt" }` is read with the scene, and travels with its
//! text to all ranks.

use std::collections::BTreeMap;
use std::sync::Arc;

use toml::{Table, Value};

use crate::error::{Error, Result};
use crate::material::eos::EosTable;
use crate::material::eos::tabulated::formats::{self, Format};
use crate::material::eos::tabulated::grid::Grid;
use crate::scene::document::input;
use crate::scene::document::source::{Document, SourceText};
use crate::scene::reading::tables::SceneTables;

/// Reads the table of every material that names one. Paths start at the scene's folder; from here on they are whole, so that the scene
/// as it is understood can be read from anywhere.
pub fn read_into(source: &mut SourceText) -> Result<()> {
    let (mut tables, mut overrides) = (BTreeMap::new(), Vec::new());
    {
        let document = Document::parse(source)?;
        let materials = document.tree.get("material").and_then(Value::as_table);
        for (name, material) in materials.into_iter().flatten() {
            let table = ["eos", "table"].iter().try_fold(material, |table, key| table.get(*key));
            let Some((file, format)) = table.and_then(Value::as_table).and_then(file_and_format) else { continue };
            let key = format!("material.{name}.eos.table.file");
            let wrong = |what: String| document.error(&key, what);
            let whole = std::path::absolute(source.folder().join(file)).map_err(|e| wrong(e.to_string()))?;
            let shown = whole.display().to_string();
            let text = input::read_large(&whole).map_err(|e| wrong(format!("cannot read {shown}: {e}")))?;
            let mut rows = formats::read(format, &text);
            if let Some(phases) = table.and_then(|table| table.get("phases")).and_then(Value::as_str) {
                let key = format!("material.{name}.eos.table.phases");
                let wrong = |what: String| document.error(&key, what);
                let whole = std::path::absolute(source.folder().join(phases)).map_err(|e| wrong(e.to_string()))?;
                let shown = whole.display().to_string();
                let text = input::read_large(&whole).map_err(|e| wrong(format!("cannot read {shown}: {e}")))?;
                if let Ok(rows) = &mut rows {
                    formats::add_phases(rows, &text)
                        .map_err(|what| Error::new(what).at(&shown).allowed("phases of the same states"))?;
                }
                overrides.push(format!("{key}={}", Value::String(shown)));
            }
            let rows = rows.and_then(Grid::new);
            let grid =
                rows.map_err(|what| Error::new(what).at(&shown).allowed("a table in the format that is named"))?;
            overrides.push(format!("{key}={}", Value::String(shown.clone())));
            tables.insert(shown, Arc::new(grid));
        }
    }
    source.tables = tables;
    source.overrides.extend(overrides);
    Ok(())
}

/// What is wrong with either is told when the whole scene is read.
fn file_and_format(table: &Table) -> Option<(&str, Format)> {
    Some((table.get("file")?.as_str()?, table.get("format")?.clone().try_into().ok()?))
}

/// Gives materials what has been read of their files.
pub fn give(tables: &mut SceneTables, source: &SourceText) {
    for material in tables.material.values_mut() {
        if let EosTable::Tabulated(table) = &mut material.eos {
            table.grid = source.tables.get(&table.file).cloned();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    #[test]
    fn a_scene_takes_its_equation_of_state_from_a_file() {
        let folder = tempfile::tempdir().unwrap();
        let scene = folder.path().join("s.toml");
        let lines = (0..40).flat_map(|k| {
            let rho = 1000.0 + 100.0 * k as f64;
            (0..10).map(move |j| format!("{rho},{},{}\n", 1e5 * j as f64, 1e7 * (rho - 2700.0) + 2.7e8 * j as f64))
        });
        fs::write(folder.path().join("rock.csv"), lines.collect::<String>()).unwrap();
        let text = "[[body]]\nname = \"ball\"\nshape = { sphere = { radius = 1 } }\nmaterial = \"rock\"\nparticles = 100\n\
            [material.rock.eos.table]\nfile = \"rock.csv\"\nformat = \"columns\"\n[run]\nuntil = 1\n";
        fs::write(&scene, text).unwrap();
        let read = crate::scene::read(&scene, &[]).unwrap();
        let density = read.materials[0].reference_density().unwrap();
        assert!((density - 2700.01).abs() < 0.02 && (read.bodies[0].density - density).abs() < 1e-9, "{density}");
        // Again, as every rank does, without the file; and as it is understood, from elsewhere.
        let sent = serde_json::to_string(&read).unwrap();
        fs::rename(folder.path().join("rock.csv"), folder.path().join("moved.csv")).unwrap();
        let received: crate::scene::Scene = serde_json::from_str(&sent).unwrap();
        assert_eq!(received, read);
        assert_eq!(received.reread(&["ball.particles=200".into()]).unwrap().materials, read.materials);
        let understood = read.to_toml();
        assert!(!understood.contains("pressure = [") && understood.contains("rock.csv"), "{understood}");
        let message = crate::scene::read(&scene, &[]).unwrap_err().to_string();
        assert!(message.contains("s.toml:7") && message.contains("rock.csv"), "{message}");
        fs::write(folder.path().join("rock.csv"), "1 2 3\n4\n").unwrap();
        let message = crate::scene::read(&scene, &[]).unwrap_err().to_string();
        assert!(message.contains("rock.csv: line 2: `4`"), "{message}");
    }
}
