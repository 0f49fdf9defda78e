//! What a scene has to know of the particles of a file. Sums are exact, so that the order of the particles, which depends on the ranks
//! that wrote them, changes no bit.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::choice::Keep;
use super::file::{Format, Found, Head, MASS, POSITION, ParticleFile, Rows, VELOCITY};
use super::grid::Grid;
use crate::math::ExactSum;

/// Masses that differ by less count as one.
const SAME_MASS: f64 = 1e-6;
/// Groups at most: each is a body of its own.
const MOST_GROUPS: usize = 1000;

/// What the particles that are taken have in common, and their groups.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Gathered {
    /// Rows of the file, of which not all may be taken.
    pub rows: u64,
    /// 2 or 3, where the file says it.
    pub dimension: Option<usize>,
    /// Whether the matter is that of a late stage.
    pub late: bool,
    /// Names of the columns of the file.
    pub columns: Vec<String>,
    /// The heaviest first.
    pub groups: Vec<Group>,
    /// kg.
    pub mass: f64,
    /// Centre of mass, m, and its velocity, m/s.
    pub centre: [f64; 3],
    pub velocity: [f64; 3],
    pub grid: Arc<Grid>,
    keep: Keep,
    /// Kinds that are taken, where they are chosen by kind.
    kinds: Vec<i64>,
}

/// Particles of one mass and one origin.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Group {
    /// Name of the body that they come from, or the word for their material.
    pub origin: String,
    /// What a snapshot calls their material; the word for it elsewhere.
    pub material: String,
    /// Particles.
    pub count: u64,
    /// Of one particle, kg.
    pub particle_mass: f64,
    /// Bulk density, kg/m^3, and distention of their body at its start, where the file says it.
    pub density: Option<f64>,
    pub distention: Option<f64>,
    kind: i64,
    /// Masses that belong to it, kg.
    masses: [f64; 2],
}

impl Gathered {
    /// The group of a particle; none where it is not taken.
    pub fn group_of(&self, rows: &Rows, row: usize) -> Option<usize> {
        if !self.keep.takes(rows, row, &self.kinds) {
            return None;
        }
        let (kind, mass) = (rows.kind(row), rows.column(MASS)?.number(row));
        self.groups.iter().position(|group| group.kind == kind && (group.masses[0]..=group.masses[1]).contains(&mass))
    }

    pub fn particles(&self) -> u64 {
        self.groups.iter().map(|group| group.count).sum()
    }

    pub fn has(&self, column: &str) -> bool {
        self.columns.iter().any(|name| name == column)
    }
}

/// What a file has of the particles that are to be taken.
pub fn gather(file: &ParticleFile, keep: &Keep) -> Found<Gathered> {
    let head = file.head()?;
    if let Some(missing) = [POSITION, MASS].iter().find(|name| !head.columns.iter().any(|column| column == *name)) {
        return Err(format!("it has no column {missing}"));
    }
    if file.format == Format::Snapshot && head.bodies.is_empty() {
        return Err("it does not say of which bodies it is: a version before this could be asked has written it".into());
    }
    let rows = file.read(0..head.rows, &|name| [POSITION, MASS, VELOCITY].contains(&name))?;
    keep.check(&rows)?;
    let names = names_of_kinds(&head, &rows);
    let kinds = match keep {
        Keep::Body(name) => {
            let kinds: Vec<i64> = names.iter().filter(|(_, known)| *known == name).map(|(kind, _)| *kind).collect();
            if kinds.is_empty() {
                let known: Vec<&str> = names.values().map(String::as_str).collect();
                return Err(format!("it has no particle of `{name}`, but of {}", known.join(", ")));
            }
            kinds
        }
        _ => Vec::new(),
    };
    let taken: Vec<usize> = (0..rows.count).filter(|row| keep.takes(&rows, *row, &kinds)).collect();
    if taken.is_empty() {
        return Err("none of its particles is asked for".into());
    }
    let groups = groups(&head, &rows, &taken, &names)?;
    let (mass, centre, velocity) = centre_of_mass(&rows, &taken);
    if !(mass.is_finite() && centre.iter().chain(&velocity).all(|x| x.is_finite())) {
        return Err("its sums are beyond the reach of numbers".into());
    }
    let position = rows.column(POSITION).expect("checked above");
    let positions: Vec<[f64; 3]> = taken.iter().map(|row| position.vector(*row)).collect();
    Ok(Gathered {
        rows: head.rows,
        dimension: head.dimension,
        late: head.late,
        columns: head.columns,
        groups,
        mass,
        centre,
        velocity,
        grid: Arc::new(Grid::of(&positions)),
        keep: keep.clone(),
        kinds,
    })
}

/// What each kind of particle is called.
fn names_of_kinds(head: &Head, rows: &Rows) -> BTreeMap<i64, String> {
    let all = (0..rows.count.max(1)).map(|row| rows.kind(row));
    let name = |kind: i64| match (head.bodies.get(&kind), rows.words.get(kind.max(0) as usize)) {
        (Some(body), _) => body.name.clone(),
        (None, Some(word)) => word.clone(),
        (None, None) => kind.to_string(),
    };
    all.map(|kind| (kind, name(kind))).collect()
}

fn groups(head: &Head, rows: &Rows, taken: &[usize], names: &BTreeMap<i64, String>) -> Found<Vec<Group>> {
    let column = rows.column(MASS).expect("a file with masses");
    let mut masses: Vec<(i64, f64)> = taken.iter().map(|row| (rows.kind(*row), column.number(*row))).collect();
    if let Some((_, bad)) = masses.iter().find(|(_, mass)| *mass <= 0.0) {
        return Err(format!("a particle has a mass of {bad} kg"));
    }
    masses.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut groups: Vec<Group> = Vec::new();
    let mut sum = ExactSum::new();
    for (kind, mass) in masses {
        let joins = |group: &Group| group.kind == kind && mass <= group.masses[0] * (1.0 + SAME_MASS);
        if !groups.last().is_some_and(joins) {
            let body = head.bodies.get(&kind);
            let origin = names.get(&kind).cloned().unwrap_or_default();
            groups.push(Group {
                material: body.map_or(origin.clone(), |body| body.material.clone()),
                origin,
                count: 0,
                particle_mass: mass,
                density: body.map(|body| body.density),
                distention: body.map(|body| body.distention),
                kind,
                masses: [mass; 2],
            });
            sum = ExactSum::new();
        }
        sum.add(mass);
        let group = groups.last_mut().expect("one has been made");
        group.count += 1;
        group.masses[1] = mass;
        if group.masses[0] != mass {
            group.particle_mass = sum.value() / group.count as f64;
        }
    }
    if groups.len() > MOST_GROUPS {
        let what = format!(
            "its particles have {} different masses, and {MOST_GROUPS} at most can be told apart",
            groups.len()
        );
        return Err(what);
    }
    let mass = |group: &Group| group.particle_mass * group.count as f64;
    groups.sort_by(|a, b| mass(b).total_cmp(&mass(a)));
    Ok(groups)
}

fn centre_of_mass(rows: &Rows, taken: &[usize]) -> (f64, [f64; 3], [f64; 3]) {
    let column = |name: &str| rows.column(name);
    let (mass, position, velocity) = (column(MASS).expect("masses"), column(POSITION), column(VELOCITY));
    let mut sums = [const { ExactSum::new() }; 7];
    for &row in taken {
        let m = mass.number(row);
        let [x, v] = [position, velocity].map(|column| column.map_or([0.0; 3], |column| column.vector(row)));
        let values = [m, m * x[0], m * x[1], m * x[2], m * v[0], m * v[1], m * v[2]];
        sums.iter_mut().zip(values).for_each(|(sum, value)| sum.add(value));
    }
    let [m, x, y, z, u, v, w] = sums.map(|sum| sum.value());
    (m, [x / m, y / m, z / m], [u / m, v / m, w / m])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str, keep: Keep) -> Found<(ParticleFile, Gathered)> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.keep().join("p.csv").display().to_string();
        std::fs::write(&path, text).unwrap();
        let file = ParticleFile { path, format: Format::Text, datasets: BTreeMap::new(), units: BTreeMap::new() };
        gather(&file, &keep).map(|gathered| (file, gathered))
    }

    const TWO: &str = "x,y,z,vx,vy,vz,mass,material\n0,0,0,1,0,0,2,rock\n1,0,0,1,0,0,2,rock\n4,0,0,-2,3,0,1,iron\n\
        0,5,0,0,0,0,2.0000001,rock\n";

    #[test]
    fn particles_are_sorted_by_mass_and_origin() {
        let (file, all) = of(TWO, Keep::All).unwrap();
        let names: Vec<_> = all.groups.iter().map(|g| (g.origin.as_str(), g.count)).collect();
        assert_eq!(names, [("rock", 3), ("iron", 1)]);
        assert!((all.groups[0].particle_mass - 2.0 - 1e-7 / 3.0).abs() < 1e-12);
        assert!((all.mass - 7.0000001).abs() < 1e-12 && (all.centre[0] - 6.0 / 7.0).abs() < 1e-7);
        assert!((all.velocity[1] - 3.0 / 7.0).abs() < 1e-7);
        let rows = file.read(2..4, &|_| true).unwrap();
        assert_eq!((all.group_of(&rows, 0), all.group_of(&rows, 1)), (Some(1), Some(0)));
        let (_, iron) = of(TWO, Keep::Body("iron".into())).unwrap();
        assert_eq!((iron.particles(), iron.group_of(&rows, 0), iron.group_of(&rows, 1)), (1, Some(0), None));
    }

    #[test]
    fn what_cannot_be_taken_is_refused() {
        for (text, keep, what) in [
            (TWO, Keep::Body("ice".into()), "no particle of `ice`, but of iron, rock"),
            (TWO, Keep::LargestRemnant, "what the largest remnant is"),
            ("x,y,z\n1,2,3\n", Keep::All, "no column mass"),
            ("x,y,z,mass\n1,2,3,-4\n", Keep::All, "a mass of -4 kg"),
            ("x,y,z,mass\n", Keep::All, "none of its particles"),
        ] {
            let message = of(text, keep).unwrap_err();
            assert!(message.contains(what), "{message}");
        }
        let many: String = (1..2000).map(|k| format!("0,0,0,{k}\n")).collect();
        assert!(of(&format!("x,y,z,mass\n{many}"), Keep::All).unwrap_err().contains("1999 different masses"));
    }
}
