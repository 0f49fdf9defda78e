//! The cost of a step on any number of ranks: counts, known from the scene, times their measured times.
//!
//! ```text
//! work    = owned entries pair  +  owned update  +  owned totals / history_every  +  owned gravity evaluations
//!         + ( owned entries list  +  (owned + ghosts) ordering ) / life
//! ghosts  : messages of a step, peers latency + bytes / bandwidth, less the time of the rows that need no ghost;
//!           the watch of the lists, likewise, hidden by nothing; what goes out when lists are built, over their life
//! reduce  : latency ceil(log2 ranks), two times in a step and some more when lists are built
//! uneven  : the load that a rank may have over the mean before planes are moved, half of it on the mean
//! ```
//!
//! Left out: messages of gravity, and the parts of other ranks' branches that a rank opens; network links shared by ranks (lower
//! the bandwidth instead), noise of the system, and the search for ranks nearby, which takes nanoseconds for each rank of the job.

/// Times and rates of one core and the network.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machine {
    /// s for an entry of a neighbour list: its pair, and its share of the rates and the correction that follow.
    pub pair: f64,
    /// s for an owned particle and step: prediction, material, watch of the lists, packing.
    pub update: f64,
    /// s for an entry of a list that is built.
    pub list: f64,
    /// s for a particle, owned or ghost, when lists are built: owners, order, ghosts, cells.
    pub ordering: f64,
    /// s for an owned particle when totals are taken for the history.
    pub totals: f64,
    /// s for an owned particle when the particles' own gravity is evaluated, on one rank; zero without it.
    pub gravity: f64,
    /// s for a short message between two ranks.
    pub latency: f64,
    /// bytes/s of long messages of one rank.
    pub bandwidth: f64,
    /// bytes/s that all ranks together write.
    pub files: f64,
}

/// The work of one rank.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    pub ranks: usize,
    /// Particles.
    pub owned: f64,
    pub ghosts: f64,
    /// Ranks that it exchanges messages with.
    pub peers: f64,
    /// Entries of the list per owned particle.
    pub entries: f64,
    /// Steps that a list lives for.
    pub life: f64,
    /// Bytes that go out: with each step; with each step for the watch; with each list.
    pub ghost_bytes: f64,
    pub watch_bytes: f64,
    pub build_bytes: f64,
    pub history_every: f64,
    /// Evaluations of gravity in a step.
    pub gravity: f64,
}

/// Reductions of each step: how much of the skin is used up, and the time step.
const REDUCTIONS: f64 = 2.0;
/// Rounds with all ranks when lists are built: loads, extents, and the ends of three sparse exchanges.
const ROUNDS_OF_BUILD: f64 = 8.0;
/// Largest share of load over the mean that planes are not moved for, as in the step.
const TOLERATED_IMBALANCE: f64 = 0.05;

/// Parts of a step, s, of the rank with the largest load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Step {
    pub pairs: f64,
    pub update: f64,
    pub lists: f64,
    pub ordering: f64,
    pub totals: f64,
    pub gravity: f64,
    /// Waits for messages that no work hides.
    pub messages: f64,
    pub reductions: f64,
    /// Waits for the rank with the largest load.
    pub uneven: f64,
}

impl Step {
    pub fn new(machine: &Machine, load: &Load) -> Self {
        let pairs = load.owned * load.entries * machine.pair;
        let update = load.owned * machine.update;
        let lists = load.owned * load.entries * machine.list / load.life;
        let ordering = (load.owned + load.ghosts) * machine.ordering / load.life;
        let totals = load.owned * machine.totals / load.history_every;
        let gravity = load.owned * machine.gravity * load.gravity;
        let sent = |bytes: f64| load.peers * machine.latency + bytes / machine.bandwidth;
        // A ghost layer outside has one inside, whose rows come last.
        let interior = (1.0 - load.ghosts / load.owned).max(0.0);
        let exposed = (sent(load.ghost_bytes) - interior * pairs).max(0.0);
        let messages = exposed + sent(load.watch_bytes) + sent(load.build_bytes) / load.life;
        let rounds = (load.ranks as f64).log2().ceil();
        let reductions = rounds * machine.latency * (REDUCTIONS + ROUNDS_OF_BUILD / load.life);
        let work = pairs + update + lists + ordering + totals + gravity;
        let uneven = if load.ranks > 1 { 0.5 * TOLERATED_IMBALANCE * work } else { 0.0 };
        Self { pairs, update, lists, ordering, totals, gravity, messages, reductions, uneven }
    }

    /// s that the core of a rank works.
    pub fn work(&self) -> f64 {
        self.pairs + self.update + self.lists + self.ordering + self.totals + self.gravity
    }

    /// s from one step to the next.
    pub fn wall(&self) -> f64 {
        self.work() + self.messages + self.reductions + self.uneven
    }

    /// Each part with its name.
    pub fn parts(&self) -> [(&'static str, f64); 9] {
        [
            ("pairs, rates, correction", self.pairs),
            ("prediction, material, packing", self.update),
            ("neighbour lists", self.lists),
            ("owners, order, ghosts", self.ordering),
            ("totals", self.totals),
            ("gravity of the particles", self.gravity),
            ("exposed messages", self.messages),
            ("reductions", self.reductions),
            ("uneven loads", self.uneven),
        ]
    }
}

/// Parallel efficiency: time of one rank for the step over the time of all ranks together.
pub fn efficiency(alone: &Step, shared: &Step, ranks: usize) -> f64 {
    alone.work() / (ranks as f64 * shared.wall())
}

#[cfg(test)]
mod tests {
    use super::*;

    const MACHINE: Machine = Machine {
        pair: 1e-8,
        update: 1e-7,
        list: 1e-8,
        ordering: 5e-7,
        totals: 1e-7,
        gravity: 2e-6,
        latency: 2e-6,
        bandwidth: 1e10,
        files: 1e9,
    };

    /// A cube of `particles` in `ranks` equal cubes, each with ghosts to a depth of 2.6 spacings.
    fn load(particles: f64, ranks: usize) -> Load {
        let owned = particles / ranks as f64;
        let side = owned.cbrt();
        let ghosts = if ranks > 1 { (side + 5.2).powi(3) - owned } else { 0.0 };
        Load {
            ranks,
            owned,
            ghosts,
            peers: if ranks > 1 { 26.0 } else { 0.0 },
            entries: 75.0,
            life: 3.0,
            ghost_bytes: 160.0 * ghosts,
            watch_bytes: 8.0 * ghosts,
            build_bytes: 40.0 * ghosts,
            history_every: 10.0,
            gravity: 0.0,
        }
    }

    fn step(particles: f64, ranks: usize) -> Step {
        Step::new(&MACHINE, &load(particles, ranks))
    }

    #[test]
    fn a_rank_alone_only_works() {
        let alone = step(1e5, 1);
        assert_eq!((alone.messages, alone.reductions, alone.uneven), (0.0, 0.0, 0.0));
        assert_eq!(alone.wall(), alone.work());
        // 75 pairs, an update, a third of 75 list entries and of an ordering, a tenth of the totals.
        let particle = 75e-8 + 1e-7 + 25e-8 + 5e-7 / 3.0 + 1e-8;
        assert!((alone.work() / (1e5 * particle) - 1.0).abs() < 1e-12);
        assert_eq!(alone.parts().iter().map(|part| part.1).sum::<f64>(), alone.wall());
        // Gravity in every fourth step.
        let pulled = Step::new(&MACHINE, &Load { gravity: 0.25, ..load(1e5, 1) });
        assert!(((pulled.work() - alone.work()) / (1e5 * 5e-7) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn work_follows_the_volume_and_ghosts_the_surface() {
        let (small, large) = (load(8e6, 8), load(64e6, 8));
        assert!((step(64e6, 8).pairs / step(8e6, 8).pairs - 8.0).abs() < 1e-9);
        // Twice the side: four times the faces, and the edges less than that.
        let growth = large.ghosts / small.ghosts;
        assert!(growth > 3.8 && growth < 4.0, "{growth}");
    }

    #[test]
    fn reductions_follow_the_logarithm() {
        let reductions = [2, 4, 64, 1024].map(|ranks| step(1e7, ranks).reductions);
        assert!((reductions[1] / reductions[0] - 2.0).abs() < 1e-12);
        assert!((reductions[3] / reductions[0] - 10.0).abs() < 1e-12);
        assert_eq!(step(1e7, 1000).reductions, reductions[3]);
    }

    #[test]
    fn more_ranks_take_less_time_and_more_cores() {
        let steps = [1, 8, 64, 512, 4096].map(|ranks| (ranks, step(1e8, ranks)));
        for ((fewer, a), (more, b)) in steps.iter().zip(&steps[1..]) {
            assert!(b.wall() < a.wall());
            assert!(*more as f64 * b.work() > *fewer as f64 * a.work());
            assert!(efficiency(&steps[0].1, b, *more) < efficiency(&steps[0].1, a, *fewer));
        }
        assert_eq!(efficiency(&steps[0].1, &steps[0].1, 1), 1.0);
        // A million particles per rank keep it busy. With a hundred it has nine ghosts to each of them to put in order, twenty
        // rounds of reductions, and twice 26 messages: each as long as the work itself, or longer.
        assert!(efficiency(&step(1e8, 1), &step(1e8, 64), 64) > 0.9);
        assert!(efficiency(&step(1e8, 1), &step(1e8, 1 << 20), 1 << 20) < 0.25);
    }

    #[test]
    fn weak_scaling_ends_level() {
        let walls = [64, 512, 4096].map(|ranks| step(1e5 * ranks as f64, ranks).wall());
        assert!(walls[1] / walls[0] < 1.01 && walls[2] / walls[1] < 1.01, "{walls:?}");
    }

    #[test]
    fn interior_rows_hide_messages_until_the_network_is_too_slow() {
        let on = |bandwidth: f64| Step::new(&Machine { bandwidth, ..MACHINE }, &load(1e7, 8)).messages;
        let unhidden = |bandwidth: f64| {
            let load = load(1e7, 8);
            2.0 * (load.peers * MACHINE.latency) + (load.watch_bytes + load.ghost_bytes) / bandwidth
        };
        assert!(on(1e10) < 0.3 * unhidden(1e10));
        assert!(on(1e7) > 0.8 * unhidden(1e7));
    }
}
