//! The bodies of a scene, which depend on each other where there is an impact: the projectile's spacing may follow the target's, the
//! target may be finer where it is hit, and the projectile is placed last.

use super::tables::SceneTables;
use crate::error::Result;
use crate::kernel::SUPPORT;
use crate::particles::Periods;
use crate::scene::document::source::Document;
use crate::scene::tables::body::reader::BodyReader;
use crate::scene::tables::body::validated::Body;
use crate::scene::tables::impacts::impact::ImpactSettings;
use crate::scene::tables::impacts::refine::Hit;

/// What a body is read with: completed tables, and what of them is validated.
pub struct BodyContext<'a> {
    pub document: &'a Document<'a>,
    pub tables: &'a SceneTables,
    pub periods: &'a Periods,
    pub impact: Option<&'a ImpactSettings>,
}

/// The bodies of a scene.
pub struct Bodies {
    /// Those that the scene names.
    pub named: Vec<Body>,
    /// The inner parts of a refined target, the finest first, and further groups of particles of files.
    pub parts: Vec<Body>,
}

impl BodyContext<'_> {
    /// The body of this number. `target_spacing`: what `spacing = "target"` stands for, m.
    pub fn read(&self, number: usize, target_spacing: Option<f64>) -> Result<Body> {
        Ok(self.read_parts(number, target_spacing)?.remove(0))
    }

    /// The body of this number, and further ones where its particles come from a file.
    fn read_parts(&self, number: usize, target_spacing: Option<f64>) -> Result<Vec<Body>> {
        let table = &self.tables.body[number];
        let path = format!("body.{number}");
        // A date is text to one reader of TOML and not to the other.
        let material = self.tables.material.iter().enumerate().find(|(_, (name, _))| **name == table.material);
        let Some((index, (_, material))) = material else {
            let what = format!("{} names no material", table.material);
            return Err(self.document.error(&format!("{path}.material"), what));
        };
        let placed = self.impact.is_some_and(|impact| impact.projectile == number);
        let dimension = self.tables.dimension as usize;
        let reader =
            BodyReader { document: self.document, path, dimension, periods: self.periods, target_spacing, placed };
        match table.from {
            Some(_) => reader.read_given(table, number, &self.tables.material),
            None => Ok(vec![reader.read(table, (index, material))?]),
        }
    }

    /// The spacing of the target where it is hit, m.
    pub fn spacing_at_impact(&self, target: &Body) -> Result<f64> {
        let refine = self.tables.impact.as_ref().and_then(|impact| impact.refinement());
        let given = refine.map(|refine| refine.spacing(self.document, target)).transpose()?.flatten();
        Ok(given.unwrap_or(target.lattice.spacing))
    }

    /// All bodies. `eta`: h over (m / rho)^(1/d).
    pub fn read_all(&self, eta: f64) -> Result<Bodies> {
        let target_spacing = self.impact.map(|impact| self.target_spacing(impact)).transpose()?;
        let read = |number: usize| {
            let is_projectile = self.impact.is_some_and(|impact| impact.projectile == number);
            self.read_parts(number, target_spacing.filter(|_| is_projectile))
        };
        let mut bodies = Bodies { named: Vec::new(), parts: Vec::new() };
        for number in 0..self.tables.body.len() {
            let mut parts = read(number)?.into_iter();
            bodies.named.extend(parts.next());
            bodies.parts.extend(parts);
        }
        if let Some(impact) = self.impact {
            self.refine(&mut bodies, impact)?;
            self.place_projectile(&mut bodies, impact, eta)?;
        }
        Ok(bodies)
    }

    fn target_spacing(&self, impact: &ImpactSettings) -> Result<f64> {
        let target = self.read(impact.target, None)?;
        if target.velocity != [0.0; 3] {
            let place = format!("body.{}.velocity", impact.target);
            let error = self.document.error(&place, "the target of an impact rests at the start");
            return Err(error.allowed("no velocity"));
        }
        self.spacing_at_impact(&target)
    }

    fn refine(&self, bodies: &mut Bodies, impact: &ImpactSettings) -> Result<()> {
        let Some(refine) = self.tables.impact.as_ref().and_then(|impact| impact.refinement()) else { return Ok(()) };
        let ImpactSettings { target, projectile, .. } = *impact;
        let point = impact.point(&bodies.named[target], &bodies.named[projectile]);
        let mut parts = refine.parts(self.document, &bodies.named, Hit { target, projectile, point })?;
        if let Some(outermost) = parts.pop() {
            bodies.named[target] = outermost;
        }
        bodies.parts.splice(0..0, parts);
        Ok(())
    }

    fn place_projectile(&self, bodies: &mut Bodies, impact: &ImpactSettings, eta: f64) -> Result<()> {
        let (target, projectile) = (&bodies.named[impact.target], &bodies.named[impact.projectile]);
        let near = bodies.parts.iter().find(|part| part.cut.is_some()).unwrap_or(target);
        let h = near.expected_smoothing_length(eta).max(projectile.expected_smoothing_length(eta));
        let placed = impact.place(target, projectile, SUPPORT * h);
        let place = || self.document.place(&format!("body.{}.shape", impact.projectile));
        let (centre, velocity) = placed.map_err(|e| e.at(place()))?;
        let of_projectile = |part: &&mut Body| part.given.as_ref().is_some_and(|given| given.body == impact.projectile);
        let parts = bodies.parts.iter_mut().filter(of_projectile);
        for part in parts.chain([&mut bodies.named[impact.projectile]]) {
            (part.centre, part.velocity) = (centre, velocity);
        }
        Ok(())
    }
}
