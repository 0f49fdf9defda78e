//! The neighbourhood of particles between two list builds: their owners, the ghosts, the lists, and the
//! watch that determines when all of it must be made anew. Everything is based on the positions of the last build, so that a
//! resumed run has the same lists.

use super::integrator::AT_START;
use super::phases::{Phase, Phases};
use super::settings::StepSettings;
use super::skin::Skin;
use crate::domain::comm::Comm;
use crate::domain::{Basis, Closing, Decomposition, Displacements, Handles, Moving, SomeGhosts, Space, Watch};
use crate::gravity::ROUNDS;
use crate::kernel::SUPPORT;
use crate::material::{Core, ParticleView};
use crate::math::Vec3;
use crate::neighbours::NeighbourList;
use crate::pair::Layout;
use crate::particles::{Column, Columns, Lattice, Local, ParticleId, Registry};

/// Planes are moved when the largest load of a rank exceeds the mean by more than this share.
const TOLERATED_IMBALANCE: f64 = 0.05;

/// Cost of a particle's own update in list entries, until it is measured.
const FIRST_UPDATE_COST: f64 = 30.0;

/// Steps before times give the cost of a particle.
const STEPS_TO_MEASURE: u64 = 10;

/// Measurements from which the loads of ranks are estimated.
pub struct Load<'a> {
    pub phases: &'a Phases,
    /// Steps so far, that in progress among them.
    pub steps: u64,
    /// How often fast particles are evaluated in a step, where there are any.
    pub small_steps: f64,
}

/// How much a neighbour list of this rank holds.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ListSize {
    pub entries: f64,
    /// Those that have a row in it.
    pub particles: f64,
}

pub struct Neighbourhood<const D: usize> {
    decomposition: Option<Decomposition<D>>,
    pub list: NeighbourList<D>,
    /// Imbalance of each list so far times the evaluations made with it, and these evaluations.
    imbalance_so_far: (f64, u64),
    /// Evaluations with the present list.
    evaluations: u64,
    handles: Handles,
    core: Core,
    /// Column of crossings of the periods, where they count.
    rounds: Option<Column<Vec3>>,
    /// Copies of positions and of crossings at the beginning of the step, where an integrator has them.
    at_start: [Option<Column<Vec3>>; 2],
    space: Space,
    words: usize,
    costs: Vec<u32>,
    /// Size of the present list.
    list_size: ListSize,
    /// Messages of the ghosts that change within a step, where some particles take smaller ones.
    chosen: Option<SomeGhosts>,
    /// What of the present list belongs to fast particles.
    fast_size: ListSize,
    /// Column of those that are fast.
    fast: Option<Column<f64>>,
    /// The scene's body of each slot, where rigid bodies are touched.
    owners: Option<Vec<u16>>,
    /// Most bytes that a list has held.
    list_bytes: usize,
}

impl<const D: usize> Neighbourhood<D> {
    pub fn new(registry: &Registry, settings: &StepSettings) -> Self {
        let core = settings.view.core;
        let reach = SUPPORT * (1.0 + settings.skin.of_cells());
        Self {
            decomposition: None,
            list: NeighbourList::new(&settings.view.rigid),
            imbalance_so_far: (0.0, 0),
            evaluations: 0,
            handles: Handles { id: core.id, position: core.position, build_position: core.build_position },
            core,
            rounds: registry.find(ROUNDS),
            at_start: ["position", ROUNDS].map(|name| registry.find(&format!("{name}{AT_START}"))),
            space: Space { lattice: lattice(reach, settings), periods: settings.periods },
            words: settings.pair_loop.layout().words(),
            costs: Vec::new(),
            list_size: ListSize::default(),
            chosen: None,
            fast_size: ListSize::default(),
            fast: settings.two_rates.as_ref().map(|rates| rates.columns.fast),
            owners: settings.contact.map(|_| Vec::new()),
            list_bytes: 0,
        }
    }

    /// Owned particles and ghosts.
    pub fn local(&self) -> &Local<D> {
        &self.parts().local
    }

    /// Particles that left this rank at the last build.
    pub fn migrated(&self) -> usize {
        self.parts().migrated
    }

    fn parts(&self) -> &Decomposition<D> {
        self.decomposition.as_ref().expect("particles are distributed first")
    }

    fn parts_mut(&mut self) -> &mut Decomposition<D> {
        self.decomposition.as_mut().expect("particles are distributed first")
    }

    /// Bases the next build on the present positions and smoothing lengths; the lists before it were used for `age` evaluations. Collective.
    pub fn start_afresh(&self, columns: &mut Columns, settings: &StepSettings, age: u64, comm: &Comm) {
        self.choose_skins(columns, settings, age, comm);
        self.wrap(columns);
        columns.copy(self.core.position.index, self.core.build_position.index);
        if let Some([now, at_build]) = settings.view.varying_smoothing_length() {
            columns.copy(now.index, at_build.index);
        }
    }

    /// Skins of the next lists, by how matter has moved while the last ones were used.
    fn choose_skins(&self, columns: &mut Columns, settings: &StepSettings, age: u64, comm: &Comm) {
        let Skin::Own(own) = settings.skin else { return };
        let Some(Decomposition { watch, .. }) = &self.decomposition else { return own.begin(columns) };
        let view = &settings.view;
        let support =
            |i: usize| SUPPORT * view.smoothing_length_at_build(columns, i, columns.get(view.core.id, i).body());
        let moved: Vec<f64> = (0..).zip(watch.moves_around()).map(|(i, moved)| moved / support(i)).collect();
        own.choose(columns, &moved, age, comm);
    }

    /// Brings positions back into the periods, and with them their copies at the beginning of the step: later stages start from these.
    fn wrap(&self, columns: &mut Columns) {
        let periods = &self.space.periods;
        let [place_at_start, rounds_at_start] = self.at_start;
        for axis in (0..D).filter(|&axis| periods.closed(axis)) {
            for k in (0..columns.len()).map(|i| D * i + axis) {
                let x = columns.numbers(self.core.position.index)[k];
                let mut add = |column: Option<Column<Vec3>>, by: f64| {
                    if let Some(column) = column {
                        columns.numbers_mut(column.index)[k] += by;
                    }
                };
                let (inside, rounds) = (periods.wrapped(axis, x), periods.rounds(axis, x));
                add(self.rounds, rounds);
                add(rounds_at_start, rounds);
                add(place_at_start, inside - x);
                columns.numbers_mut(self.core.position.index)[k] = inside;
            }
        }
    }

    /// Distributes particles over ranks and finds the ghosts, on build positions. Collective.
    pub fn distribute(&mut self, columns: &mut Columns, settings: &StepSettings, comm: &Comm) {
        let (skin, view) = (settings.skin, &settings.view);
        let radius = |columns: &Columns, i: usize| {
            let h = view.smoothing_length_at_build(columns, i, columns.get(view.core.id, i).body());
            SUPPORT * (1.0 + skin.at_build(columns, i)) * h
        };
        match &mut self.decomposition {
            Some(decomposition) => decomposition.rebuild_from_build_positions(columns, &radius, comm),
            None => {
                let basis = Basis { handles: self.handles, space: self.space, words: self.words };
                self.decomposition = Some(Decomposition::new(columns, basis, &radius, comm));
            }
        }
    }

    /// Neighbours of every owned particle, and what follows from which they are.
    pub fn build_list(&mut self, columns: &mut Columns, settings: &StepSettings) {
        let view = &settings.view;
        let Decomposition { local, .. } = self.decomposition.as_mut().expect("particles are distributed first");
        self.list.build(local);
        if let Some(column) = view.contact_alpha() {
            let alpha_of = |slot: u32| local.places.get(slot as usize).map(|place| alpha(view, place.id));
            for (i, ends) in self.list.offsets.windows(2).enumerate() {
                let neighbours = self.list.entries[ends[0]..ends[1]].iter().filter_map(|&slot| alpha_of(slot));
                let own = alpha(view, columns.get(self.core.id, i).0);
                columns.set(column, i, neighbours.fold(own, f64::max));
            }
        }
        if let Some(rates) = &settings.two_rates {
            let is_fast = |slot: u32| {
                let place = local.places.get(slot as usize);
                place.is_some_and(|place| rates.bodies[ParticleId(place.id).body()])
            };
            for (i, ends) in self.list.offsets.windows(2).enumerate() {
                let near = is_fast(local.slot_of_owned[i])
                    || self.list.entries[ends[0]..ends[1]].iter().any(|&slot| is_fast(slot));
                columns.set(rates.columns.near, i, f64::from(near));
            }
        }
        if let Some(owners) = &mut self.owners {
            owners.clear();
            owners.extend(local.places.iter().map(|place| ParticleId(place.id).body() as u16));
        }
        local.forget_places();
        self.list_size = ListSize {
            entries: *self.list.offsets.last().unwrap_or(&0) as f64,
            particles: (self.list.offsets.len() - 1) as f64,
        };
        self.list_bytes = self.list_bytes.max(self.list.bytes());
    }

    /// The scene's body of each slot, where rigid bodies are touched; empty elsewhere.
    pub fn owners(&self) -> &[u16] {
        self.owners.as_deref().unwrap_or(&[])
    }

    /// Releases the list's memory.
    pub fn forget_list(&mut self) {
        self.list.forget();
    }

    /// Most bytes that a list has held.
    pub fn list_bytes(&self) -> usize {
        self.list_bytes
    }

    /// How much of the skin is used up, as far as this rank sees; lists hold while no rank finds more than 1. Collective.
    pub fn skin_used(&mut self, columns: &Columns, settings: &StepSettings, comm: &Comm) -> f64 {
        self.with_motion(columns, settings, |watch, motion| watch.skin_used(motion, comm))
    }

    /// The longest step in which no two particles meet undetected; `all`: the largest relative velocity anywhere, m/s. Collective.
    pub fn closing(&mut self, columns: &Columns, settings: &StepSettings, all: f64, comm: &Comm) -> Closing {
        let (velocity, id) = (columns.numbers(self.core.velocity.index), self.core.id);
        let moving = Moving { velocity, relative: all, id: &|i| columns.get(id, i).0 };
        self.with_motion(columns, settings, |watch, motion| watch.closing(motion, &moving, settings.cfl, comm))
    }

    fn with_motion<T>(
        &mut self,
        columns: &Columns,
        settings: &StepSettings,
        act: impl FnOnce(&mut Watch<D>, &Displacements<'_, &(dyn Fn(usize) -> f64 + Sync)>) -> T,
    ) -> T {
        let view = &settings.view;
        let support = |i: usize| SUPPORT * view.smoothing_length(columns, i, columns.get(view.core.id, i).body());
        let motion = Displacements {
            position: columns.numbers(self.core.position.index),
            build_position: columns.numbers(self.core.build_position.index),
            support: &support as &(dyn Fn(usize) -> f64 + Sync),
        };
        act(&mut self.parts_mut().watch, &motion)
    }

    /// Moves the planes of the bisection if the loads of ranks differ too much; the next [`Neighbourhood::distribute`]
    /// follows them. A particle costs its list entries and its own update, in the proportion measured so far. Collective.
    pub fn balance(&mut self, columns: &Columns, load: &Load, comm: &Comm) -> bool {
        if comm.size() == 1 || self.decomposition.is_none() {
            return false;
        }
        let own = self.update_cost(load, comm);
        let imbalance = self.imbalance_of_list(own, load.small_steps, comm);
        self.imbalance_so_far.0 += imbalance * self.evaluations as f64;
        self.imbalance_so_far.1 += self.evaluations;
        self.evaluations = 0;
        let unbalanced = imbalance > 1.0 + TOLERATED_IMBALANCE;
        if unbalanced {
            let mut costs = std::mem::take(&mut self.costs);
            costs.clear();
            let is_fast = |i: usize| self.fast.is_some_and(|fast| columns.get(fast, i) != 0.0);
            let times = |i: usize| if is_fast(i) { load.small_steps } else { 1.0 };
            let rows = self.list.offsets.windows(2).enumerate();
            costs.extend(rows.map(|(i, row)| (((row[1] - row[0]) as f64 + own) * times(i)) as u32));
            self.parts_mut().bisect(columns, &costs, comm);
            self.costs = costs;
        }
        unbalanced
    }

    /// Largest load of a rank over the mean load: the mean over all evaluations so far, each with the planes that it was
    /// made with. Collective.
    pub fn imbalance(&self, load: &Load, comm: &Comm) -> f64 {
        let now = self.imbalance_of_list(self.update_cost(load, comm), load.small_steps, comm);
        let (sum, evaluations) = self.imbalance_so_far;
        (sum + now * self.evaluations as f64) / (evaluations + self.evaluations).max(1) as f64
    }

    /// Imbalance of the present list, where the update of a particle costs `own` entries. Collective.
    fn imbalance_of_list(&self, own: f64, small_steps: f64, comm: &Comm) -> f64 {
        let cost = |size: &ListSize| size.entries + own * size.particles;
        let mine = cost(&self.list_size) + (small_steps - 1.0) * cost(&self.fast_size);
        let (mut most, mut total) = ([mine], [mine as i64]);
        comm.all_max(&mut most);
        comm.all_sum(&mut total);
        most[0] * comm.size() as f64 / total[0].max(1) as f64
    }

    /// Says what of the present list belongs to fast particles.
    pub fn note_fast(&mut self, size: ListSize) {
        self.fast_size = size;
    }

    /// Size of the present list.
    pub fn list_size(&self) -> ListSize {
        self.list_size
    }

    /// Cost of a particle's own update in list entries, from the time of all ranks so far: a disturbance of one of them
    /// must not count as load. Collective.
    fn update_cost(&self, load: &Load, comm: &Comm) -> f64 {
        let seconds = |phase: Phase| load.phases.seconds[phase as usize];
        let update = seconds(Phase::Predict) + seconds(Phase::Pack) + seconds(Phase::Watch) + seconds(Phase::Gravity);
        let ListSize { entries, particles } = self.list_size;
        let mut sums = [1e6 * update, 1e6 * seconds(Phase::Pairs), entries, particles].map(|x| x as i64);
        comm.all_sum(&mut sums);
        let [update, pairs, entries, particles] = sums.map(|x| x as f64);
        if load.steps < STEPS_TO_MEASURE || pairs <= 0.0 || entries == 0.0 {
            return FIRST_UPDATE_COST;
        }
        ((update / particles) / (pairs / entries)).clamp(1.0, 200.0)
    }

    /// Starts sending the records of boundary particles.
    pub fn send(&mut self, records: &[f64], stride: usize, comm: &Comm) {
        self.evaluations += 1;
        let words = self.words;
        let Decomposition { ghosts, local, .. } = self.parts_mut();
        let outgoing = ghosts.exchange.outgoing().chunks_exact_mut(words);
        for (&i, to) in ghosts.send_indices.iter().zip(outgoing) {
            let slot = local.slot_of_owned[i as usize] as usize;
            to.copy_from_slice(&records[slot * stride..slot * stride + words]);
        }
        if !ghosts.send_shifts.is_empty() {
            let outgoing = ghosts.exchange.outgoing().chunks_exact_mut(words);
            for (shift, to) in ghosts.send_shifts.as_chunks::<D>().0.iter().zip(outgoing) {
                (0..D).for_each(|k| to[Layout::POSITION + k] += shift[k]);
            }
        }
        ghosts.exchange.start(comm);
    }

    pub fn poll(&mut self) {
        self.parts_mut().ghosts.exchange.poll();
    }

    pub fn wait(&mut self, comm: &Comm) {
        self.parts_mut().ghosts.exchange.wait(comm);
    }

    /// Puts the received records into their slots.
    pub fn receive(&self, records: &mut [f64], stride: usize) {
        let Decomposition { ghosts, local, .. } = self.parts();
        let incoming = ghosts.exchange.incoming().chunks_exact(self.words);
        for (&slot, from) in local.slot_of_incoming.iter().zip(incoming) {
            records[slot as usize * stride..slot as usize * stride + self.words].copy_from_slice(from);
        }
    }

    /// Brings the records of chosen ghosts alone. Collective.
    pub fn exchange_chosen(&mut self, records: &mut [f64], stride: usize, comm: &Comm) {
        let words = self.words;
        let Some(SomeGhosts { sent, received, exchange }) = &mut self.chosen else { return };
        let Decomposition { ghosts, local, .. } = self.decomposition.as_ref().expect("particles are distributed first");
        for (&k, to) in sent.iter().zip(exchange.outgoing().chunks_exact_mut(words)) {
            let slot = local.slot_of_owned[ghosts.send_indices[k as usize] as usize] as usize;
            to.copy_from_slice(&records[slot * stride..slot * stride + words]);
            if let Some(shift) = ghosts.send_shifts.as_chunks::<D>().0.get(k as usize) {
                (0..D).for_each(|axis| to[Layout::POSITION + axis] += shift[axis]);
            }
        }
        exchange.start(comm);
        exchange.wait(comm);
        for (&k, from) in received.iter().zip(exchange.incoming().chunks_exact(words)) {
            let slot = local.slot_of_incoming[k as usize] as usize;
            records[slot * stride..slot * stride + words].copy_from_slice(from);
        }
    }

    /// Chooses the ghosts whose slots have a number in `marks` that is not zero. Collective.
    pub fn choose(&mut self, marks: &[f64], comm: &Comm) {
        let Decomposition { ghosts, local, .. } = self.parts();
        let is_marked = |slot: u32| marks[slot as usize] != 0.0;
        let is_sent = |k: usize| is_marked(local.slot_of_owned[ghosts.send_indices[k] as usize]);
        let is_received = |k: usize| is_marked(local.slot_of_incoming[k]);
        self.chosen = Some(ghosts.some(is_sent, is_received, comm));
    }

    /// A number of the particle in every slot, ghosts too, and zero for the record that pads rows. Collective.
    pub fn in_slots(&mut self, number: impl Fn(usize) -> f64, comm: &Comm) -> Vec<f64> {
        let words = self.words;
        let Decomposition { ghosts, local, .. } = self.parts_mut();
        let outgoing = ghosts.exchange.outgoing().chunks_exact_mut(words);
        ghosts.send_indices.iter().zip(outgoing).for_each(|(&i, to)| to[0] = number(i as usize));
        ghosts.exchange.start(comm);
        ghosts.exchange.wait(comm);
        let mut numbers = vec![0.0; local.count + 1];
        (0..).zip(&local.slot_of_owned).for_each(|(i, &slot)| numbers[slot as usize] = number(i));
        let incoming = ghosts.exchange.incoming().chunks_exact(words);
        local.slot_of_incoming.iter().zip(incoming).for_each(|(&slot, from)| numbers[slot as usize] = from[0]);
        numbers
    }

    /// Ghosts held by this rank.
    pub fn ghosts(&self) -> usize {
        self.local().ghosts()
    }
}

/// alpha of the material of a particle.
fn alpha(view: &ParticleView, id: u64) -> f64 {
    view.material_viscosity(ParticleId(id).body()).alpha
}

/// Cells of one level are just as wide as the list radius of the body with the most particles: a level that missed it by
/// little would hold its particles in cells twice as wide, with eight times the candidates. The smallest body begins at
/// level 0. Where smoothing lengths vary, a little expansion must not lift particles to the next level either.
fn lattice(reach: f64, settings: &StepSettings) -> Lattice {
    let constants = &settings.view.constants;
    let smallest = constants.iter().map(|body| body.smoothing_length).fold(f64::INFINITY, f64::min);
    let largest = constants.iter().map(|body| body.smoothing_length).fold(0.0, f64::max);
    let largest_body = constants.iter().max_by_key(|body| body.particles).expect("a scene has bodies");
    let room = if settings.view.varying_smoothing_length().is_some() { 1.05 } else { 1.0 };
    let mut side = largest_body.smoothing_length * room;
    while side > smallest {
        side *= 0.5;
    }
    Lattice::periodic(reach * side, reach * room * largest, &settings.periods)
}
