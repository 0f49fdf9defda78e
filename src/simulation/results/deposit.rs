//! The heap that a body leaves on level ground: figures, table and picture.

use crate::error::Result;
use crate::math::Vec3;
use crate::outcome::Particle;
use crate::outcome::deposit::{Deposit, Question};
use crate::output::figures::curves::{Axis, Figure, Mark, Series};
use crate::output::summary::Figures;
use crate::scene::DepositSettings;
use crate::simulation::run::Run;

impl<const D: usize> Run<'_, D> {
    /// The heap as it is now, where the scene asks for it. Collective.
    pub(in crate::simulation) fn deposit(&self) -> Option<Deposit> {
        let settings = self.scene.deposit?;
        let mut up = Vec3::zeros();
        up[settings.axis] = settings.sign;
        let question = Question {
            origin: settings.origin.into(),
            up,
            out: settings.out,
            spacing: self.scene.bodies[settings.body].lattice.spacing,
        };
        let mine: Vec<Particle> =
            self.particles().into_iter().filter(|particle| particle.body == settings.body).collect();
        Some(Deposit::measure(self.comm, &mine, &question))
    }

    /// deposit.png; for one rank.
    pub(in crate::simulation) fn draw_deposit(&self, deposit: &Deposit) -> Result<()> {
        let axis = |label: &str| Axis { label: label.into(), logarithmic: false };
        let points = deposit.profile.iter().map(|&[out, height]| (out, height)).collect();
        let series = Series { label: String::new(), points, errors: vec![], mark: Mark::Line };
        let (x, y) = (axis("Distance from the middle [m]"), axis("Height [m]"));
        let path = self.options.directory.join("deposit.png");
        Figure { title: self.scene.title.clone(), x, y, series: vec![series] }.draw(&path)
    }
}

/// `deposit` of summary.json.
pub fn figures(deposit: &Deposit, settings: &DepositSettings) -> Figures {
    let DepositSettings { half_width, height, gravity, .. } = *settings;
    let figures = [
        ("foot", deposit.foot),
        ("foot_99", deposit.foot_99),
        ("height", deposit.height),
        ("run_out", deposit.foot / half_width - 1.0),
        ("run_out_99", deposit.foot_99 / half_width - 1.0),
        ("height_over_half_width", deposit.height / half_width),
        ("flank_angle", libm::atan(deposit.flank).to_degrees()),
        ("repose_angle", libm::atan(deposit.height / deposit.foot).to_degrees()),
        ("speed_over_fall", deposit.speed / (gravity * height).sqrt()),
    ];
    Figures(figures.map(|(name, value)| (name.to_string(), value)).to_vec())
}

/// The heap on the terminal, rank 0.
pub fn print(deposit: &Figures) {
    let of = |name: &str| deposit.0.iter().find(|(n, _)| n == name).map_or(f64::NAN, |(_, value)| *value);
    tracing::info!(
        "run out by {:.3} half widths ({:.3} for 99 of 100 particles), height {:.3}, flank {:.1} degrees, from foot to top {:.1}; rms speed \
         {:.1e} of free fall",
        of("run_out"),
        of("run_out_99"),
        of("height_over_half_width"),
        of("flank_angle"),
        of("repose_angle"),
        of("speed_over_fall")
    );
}
