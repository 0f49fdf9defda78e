//! `[impact] refine`: a target that is finer where it is hit. A ball around the point of impact gets the finest spacing, shells
//! around it, each twice as coarse and twice as wide, lead to the target's own. Particles of a body have one mass, so each of
//! these parts becomes a body: the target itself is the outermost, the others follow after the bodies of the scene, the finest
//! first. Layers, probes and what is said of the target mean all of them.

use schemars::JsonSchema;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::error::{Error, Result};
use crate::scene::document::source::Document;
use crate::scene::geometry::cut::{Cut, volume_within};
use crate::scene::geometry::lattice::{Faces, Lattice};
use crate::scene::geometry::shape::BodyShape;
use crate::scene::tables::body::validated::Body;
use crate::scene::values::word::{self, word_or, word_schema};
use crate::units::Length;

/// Radius of the finest part, where the scene names none: so many of the projectile's, and so many spacings.
const PROJECTILE_RADII: f64 = 4.0;
const SPACINGS: f64 = 8.0;
/// A finest part narrower than this many spacings would be all seam.
const FEWEST_SPACINGS: f64 = 4.0;
/// A part that would have fewer particles is left to the next finer one.
const FEWEST: f64 = 100.0;

/// A target that is finer where it is hit: the finest within `radius` of the point of impact; shells around, each twice as coarse and
/// twice as wide, lead to the target's own spacing. Masses are exact. For a sphere, box, cylinder or half sphere, no pile of `rubble`.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RefineTable {
    /// Distance of nearest particles at the point of impact: the projectile's, `"projectile"`, or a length, which a projectile without
    /// a spacing of its own follows.
    spacing: FinestSpacing,
    /// Radius of the finest part.
    #[schemars(extend("x-default" = usual_radius()))]
    radius: Option<Length>,
}

/// What the default of the radius follows from.
fn usual_radius() -> String {
    format!("{PROJECTILE_RADII} radii of the projectile, {SPACINGS} spacings at least")
}

/// Distance of nearest particles at the point of impact: the projectile's, or given.
#[derive(Debug, Clone, Copy, Default)]
enum FinestSpacing {
    #[default]
    OfProjectile,
    Given(Length),
}

impl FinestSpacing {
    const WORD: &str = "projectile";
}

impl Serialize for FinestSpacing {
    fn serialize<S: Serializer>(&self, serializer: S) -> std::result::Result<S::Ok, S::Error> {
        let given = match self {
            FinestSpacing::OfProjectile => None,
            FinestSpacing::Given(length) => Some(length),
        };
        word::serialize(given, Self::WORD, serializer)
    }
}

word_schema!(FinestSpacing, Length);

impl<'de> Deserialize<'de> for FinestSpacing {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> std::result::Result<Self, D::Error> {
        word_or(deserializer, Self::WORD).map(|given| given.map_or(FinestSpacing::OfProjectile, FinestSpacing::Given))
    }
}

/// Numbers and parameters of an impact that a target is cut for.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    /// Number of the target.
    pub target: usize,
    /// Number of the projectile.
    pub projectile: usize,
    /// Where the surfaces touch first, from the target's centre, m.
    pub point: [f64; 3],
}

impl RefineTable {
    /// Whether a default is left that follows from the bodies.
    pub fn is_complete(&self) -> bool {
        self.radius.is_some()
    }

    /// The table with the radius that follows from the projectile, in m.
    pub fn complete(&self, projectile: &Body) -> Self {
        let finest = match self.spacing {
            FinestSpacing::OfProjectile => projectile.lattice.spacing,
            FinestSpacing::Given(spacing) => spacing.0,
        };
        let usual = (PROJECTILE_RADII * projectile.shape.outer_radius()).max(SPACINGS * finest);
        Self { radius: Some(self.radius.unwrap_or(Length::new(usual))), ..*self }
    }

    /// The spacing at the point of impact, where it is given, m; the projectile's may follow it.
    pub fn spacing(&self, document: &Document, target: &Body) -> Result<Option<f64>> {
        let FinestSpacing::Given(spacing) = self.spacing else { return Ok(None) };
        let own = target.lattice.spacing;
        if !(spacing.0 > 0.0 && spacing.0 < own) {
            let what = format!("a spacing of {spacing} refines nothing: body \"{}\" has {}", target.name, rounded(own));
            return Err(document.error("impact.refine.spacing", what).allowed("more than 0 and less than that"));
        }
        Ok(Some(spacing.0))
    }

    /// The parts that a target is cut into, the finest first; the last is what lies outside all shells.
    pub fn parts(&self, document: &Document, bodies: &[Body], hit: Hit) -> Result<Vec<Body>> {
        let (target, projectile) = (&bodies[hit.target], &bodies[hit.projectile]);
        check_target(document, target, hit.target)?;
        let finest = self.spacing(document, target)?.unwrap_or(projectile.lattice.spacing);
        let radius = self.radius.map_or(f64::NAN, |radius| radius.0);
        if !(radius >= FEWEST_SPACINGS * finest && radius.is_finite()) {
            let what = format!("a radius of {} with particles {} apart", Length::new(radius), rounded(finest));
            let allowed = format!("{} and more, {FEWEST_SPACINGS} spacings", rounded(FEWEST_SPACINGS * finest));
            return Err(document.error("impact.refine.radius", what).allowed(allowed));
        }
        let parts = divide(target, &Fine { body: hit.target, point: hit.point, spacing: finest, radius });
        parts.map_err(|e| e.at(document.place("impact.refine.spacing")))
    }
}

/// Refuses what has no exact parts.
fn check_target(document: &Document, target: &Body, number: usize) -> Result<()> {
    let refused = match target.shape {
        _ if target.given.is_some() => Some(("from", "particles of a file are not made finer", "a body with a shape")),
        _ if target.rubble.is_some() => Some(("rubble", "the blocks of a pile are not cut", "a body without `rubble`")),
        _ if target.blast.is_some() => Some(("blast", "a blast heats one body", "a body without `blast`")),
        BodyShape::Heap { .. } => Some(("shape", "a heap is not refined", "sphere, box, cylinder, half_sphere")),
        BodyShape::Ellipsoid { .. } | BodyShape::Mesh(_) | BodyShape::Compound(_) | BodyShape::Voxels(_) => {
            Some(("shape", "a shape like this is not refined", "sphere, box, cylinder, half_sphere"))
        }
        BodyShape::HalfSphere { inner, .. } if inner > 0.0 => Some((
            "shape",
            "the point of impact lies in the hollow of the half sphere",
            "a half sphere without `inner`",
        )),
        _ => None,
    };
    match refused {
        None => Ok(()),
        Some((key, what, allowed)) => {
            let what = format!("{what}, and [impact] has a key `refine`");
            Err(document.error(&format!("body.{number}.{key}"), what).allowed(allowed))
        }
    }
}

/// Where a target is to be finest.
struct Fine {
    /// Number of the target.
    body: usize,
    /// The point of impact, m.
    point: [f64; 3],
    /// m.
    spacing: f64,
    /// How far from the point, m.
    radius: f64,
}

/// All parts of a target, from the inside; one that is the target where nothing is to be refined.
fn divide(target: &Body, fine: &Fine) -> Result<Vec<Body>> {
    let &Fine { body: number, point, spacing: finest, radius } = fine;
    let (dimension, own) = (target.dimension, target.lattice.spacing);
    let whole = target.shape.volume(dimension);
    let (mut inner, mut outer, mut inside, mut spacing) = (0.0, radius, 0.0, finest.min(own));
    let mut parts = Vec::new();
    while spacing < own {
        let volume = volume_within(&target.shape, outer, dimension).unwrap_or(whole);
        let coarser = (2.0 * spacing).min(own);
        if whole - volume < FEWEST * target.lattice.kind.cell_volume(coarser, dimension) {
            break;
        }
        parts.push(part(target, Cut { body: number, point, inner, outer, volume: volume - inside }, spacing)?);
        (inner, outer, inside, spacing) = (outer, 2.0 * outer, volume, coarser);
    }
    let rest = Cut { body: number, point, inner, outer: f64::MAX, volume: whole - inside };
    parts.push(part(target, rest, spacing)?);
    Ok(parts)
}

fn part(target: &Body, cut: Cut, spacing: f64) -> Result<Body> {
    let is_all = cut.inner == 0.0 && cut.outer == f64::MAX;
    let mut part = Body { cut: (!is_all).then_some(cut), ..target.clone() };
    if cut.outer < f64::MAX {
        part.name = format!("{} within {}", target.name, rounded(cut.outer));
    }
    if spacing < target.lattice.spacing {
        let Lattice { kind, rotation, .. } = target.lattice;
        // Rows fit between an upper face and the depth of the part: a row that comes or goes would be a good part of its mass.
        let faces = Faces { flat: target.shape.has_upper_face(), ..Faces::default() };
        part.lattice = Lattice::covering(kind, spacing, rotation, cut.bounds(&target.shape, target.dimension), faces)?;
    }
    if part.has_no_site() {
        let what = format!("no particle fits into body \"{}\" at a spacing of {}", part.name, rounded(spacing));
        return Err(Error::new(what).allowed("a smaller spacing, or another radius"));
    }
    Ok(part)
}

/// To four digits, for people.
fn rounded(length: f64) -> Length {
    Length::new(format!("{length:.3e}").parse().unwrap_or(length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    const SCENE: &str = r#"
[[body]]
name = "target"
shape = { sphere = { radius = "10 m" } }
material = "basalt"
spacing = "2 m"
[[body]]
name = "projectile"
shape = { sphere = { radius = "60 cm" } }
material = "basalt"
[impact]
speed = "5 km/s"
angle = "30 deg"
refine = true
[run]
until = 1
"#;

    fn parse(changes: &[&str]) -> Result<Scene> {
        let changes: Vec<String> = changes.iter().map(|change| change.to_string()).collect();
        Scene::parse("s.toml", SCENE, &changes)
    }

    /// The target's parts from the inside.
    fn parts(scene: &Scene) -> Vec<&Body> {
        let is_target = |(number, body): (usize, &'_ Body)| body.whole(number) == 0;
        let mut all: Vec<&Body> =
            scene.bodies.iter().enumerate().filter(|(n, body)| is_target((*n, body))).map(|(_, body)| body).collect();
        all.rotate_left(1);
        all
    }

    const TARGETS: [&[&str]; 7] = [
        &[],
        &["impact.angle_at=centre", "target.orientation.seed=3"],
        &["dimension=2", "target.spacing=1 m"],
        &["target.shape={ half_sphere = { radius = 10 } }"],
        &["target.shape={ box = { size = [20, 16, 3] } }", "target.spacing=1 m", "target.lattice=cubic"],
        &["target.shape={ cylinder = { radius = 6, height = 20 } }", "target.spacing=1 m"],
        &["target.shape={ box = { size = [20, 16] } }", "dimension=2", "target.spacing=1 m"],
    ];

    /// Masses add up to the target's; every site lies in its part, as the first of all parts that a point belongs to; particles
    /// are as heavy as the volume that they have on their lattice, to a few per cent.
    #[test]
    fn parts_make_up_the_target() {
        for changes in TARGETS {
            let scene = parse(changes).unwrap();
            let plain = parse(&[changes, &["impact.refine=false"]].concat()).unwrap();
            let all = parts(&scene);
            assert!(all.len() > 2, "{changes:?}: {} parts", all.len());
            let mass: f64 = all.iter().map(|part| part.mass()).sum();
            assert!((mass / plain.bodies[0].mass() - 1.0).abs() < 1e-14, "{changes:?}: {mass}");
            assert_eq!(scene.bodies[0].whole_mass(), plain.bodies[0].mass());
            for (number, part) in all.iter().enumerate() {
                let cut = part.cut.unwrap();
                let sites: Vec<_> = part.sites(0..part.lattice_sites()).collect();
                for (_, point) in &sites {
                    let distance = (0..3).map(|k| point[k] - part.centre[k] - cut.point[k]).map(|x| x * x).sum::<f64>();
                    assert!((cut.inner..=cut.outer).contains(&distance.sqrt()), "{changes:?}");
                    assert!(plain.bodies[0].contains(*point));
                    assert_eq!(all.iter().position(|part| part.contains(*point)), Some(number));
                }
                let heavy = part.constants(sites.len() as u64, 1.2).particle_mass;
                let even = part.density * part.lattice.cell_volume();
                assert!((heavy / even - 1.0).abs() < 0.04, "{changes:?}, {}: {}", part.name, heavy / even);
            }
        }
    }

    /// The projectile's spacing, four of its radii; then twice as coarse and wide each time.
    #[test]
    fn shells_lead_from_the_projectile_to_the_target() {
        let scene = parse(&["target.spacing=1.5 m"]).unwrap();
        let finest = scene.bodies[1].lattice.spacing;
        let all = parts(&scene);
        assert_eq!(all[0].name, "target within 2.4 m");
        assert_eq!(scene.at_impact(), Some(2));
        assert_eq!((all.last().unwrap().lattice.spacing, all.last().unwrap().name.as_str()), (1.5, "target"));
        for (k, part) in all[..all.len() - 1].iter().enumerate() {
            let factor = f64::powi(2.0, k as i32);
            assert_eq!((part.lattice.spacing, part.cut.unwrap().outer), (finest * factor, 2.4 * factor));
        }
        // The point of impact lies where the spheres touch once the projectile has flown on.
        let [x, y, _] = all[0].cut.unwrap().point;
        assert!((y - 5.0).abs() < 1e-12 && (x - 75f64.sqrt()).abs() < 1e-12);
        // It starts a support of the finest particles away.
        let r = scene.bodies[1].centre.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((r - 10.6 - 2.0 * all[0].expected_smoothing_length(1.2)).abs() < 1e-9, "{r}");
        // A given spacing is the projectile's, too, where that is not too coarse for it.
        let given = parse(&["impact.refine.spacing=10 cm", "impact.refine.radius=1 m"]).unwrap();
        assert_eq!(given.bodies[1].lattice.spacing, 0.1);
        assert_eq!((parts(&given)[0].lattice.spacing, parts(&given)[0].cut.unwrap().outer), (0.1, 1.0));
    }

    /// Where the projectile is as coarse as the target nothing changes; where shells reach the far side there is no rest.
    #[test]
    fn large_projectiles_refine_nothing() {
        let large = parse(&["projectile.radius=8 m"]).unwrap();
        assert_eq!(large.bodies, parse(&["projectile.radius=8 m", "impact.refine=false"]).unwrap().bodies);
        let wide = parse(&["impact.refine.radius=19.9 m"]).unwrap();
        assert_eq!((wide.bodies.len(), wide.bodies[0].cut), (2, None));
        assert_eq!(wide.bodies[0].lattice.spacing, wide.bodies[1].lattice.spacing);
    }

    #[test]
    fn a_refined_scene_reads_back() {
        for changes in [&[][..], &["impact.refine={ spacing = \"10 cm\", radius = 1 }"], TARGETS[4]] {
            let scene = parse(changes).unwrap();
            let again = Scene::parse("t.toml", &scene.to_toml(), &[]).unwrap();
            assert_eq!((&again.bodies, again.to_toml()), (&scene.bodies, scene.to_toml()));
            let sent = serde_json::to_vec(&scene).unwrap();
            assert_eq!(serde_json::from_slice::<Scene>(&sent).unwrap(), scene);
        }
    }

    #[test]
    fn what_cannot_be_refined_is_refused() {
        let rubble = "target.rubble={ radius = [2, 3], voids = 0.8 }";
        for (changes, expected) in [
            (&["impact.refine.spacing=2 m"][..], "impact.refine.spacing=2 m: a spacing of 2 m refines nothing"),
            (&["impact.refine.spacing=-1 cm"], "more than 0 and less than that"),
            (&["impact.refine.spacing=target"], "(allowed: \"projectile\", "),
            (&["impact.refine.spacing=10 cm", "impact.refine.radius=30 cm"], "(allowed: 0.4 m and more, 4 spacings)"),
            (&["impact.refine.raduis=3"], "did you mean `radius`?"),
            (&[rubble], "the blocks of a pile are not cut, and [impact] has a key `refine` (allowed: a body without"),
            (&["target.shape={ heap = { radius = 9, top = 4, height = 8 } }"], "a heap is not refined"),
            (&["target.shape={ half_sphere = { radius = 9, inner = 4 } }"], "lies in the hollow of the half sphere"),
            (&["target.blast={ energy = 1, radius = 1 }"], "a blast heats one body"),
        ] {
            let text = parse(changes).expect_err(changes[0]).to_string();
            assert!(text.contains(expected) && !text.contains('\n'), "{changes:?}: {text}");
        }
    }
}
