//! All that changes when lists are built: owners, the order of particles, ghosts, the local set, the watch. Everything stands
//! on `build_position` and the list radii at the build, never on where particles are now: a run that is resumed from
//! them, on any number of ranks, gets the same lists.

use super::bisection::Bisection;
use super::comm::Comm;
use super::ghosts::{Extent, Ghosts};
use super::migration::migrate;
use super::order::sort_nearly_sorted;
use super::watch::Watch;
use crate::math::Vec3;
use crate::particles::{Column, Columns, Lattice, Local, ParticleId, Periods, Place, Site};

/// The columns that a decomposition needs.
#[derive(Debug, Clone, Copy)]
pub struct Handles {
    pub id: Column<ParticleId>,
    pub position: Column<Vec3>,
    /// Position at the last list build.
    pub build_position: Column<Vec3>,
}

/// One rank's part of the particles, between two list builds.
pub struct Decomposition<const D: usize> {
    pub bisection: Bisection<D>,
    /// Owned particles and ghosts: what neighbour lists are made of.
    pub local: Local<D>,
    pub ghosts: Ghosts,
    pub watch: Watch<D>,
    /// Particles that left this rank at the last build.
    pub migrated: usize,
    space: Space,
    handles: Handles,
    sites: Vec<Site<D>>,
}

/// The cells of a run and the periods of its axes.
#[derive(Debug, Clone, Copy)]
pub struct Space {
    pub lattice: Lattice,
    pub periods: Periods,
}

impl<const D: usize> Decomposition<D> {
    /// Distributes particles that stand on any ranks, and builds on their `build_position`. `space`: the same for the whole
    /// run; `list_radius`: of an owned particle at its list build, m; `words`: numbers of a pair record. Collective.
    pub fn new(
        columns: &mut Columns,
        (handles, space, words): (Handles, Space, usize),
        list_radius: &dyn Fn(&Columns, usize) -> f64,
        comm: &Comm,
    ) -> Self {
        let costs = vec![1; columns.len()];
        let bisection = Bisection::new(columns.numbers(handles.build_position.index), &costs, comm.size(), comm);
        let extents = Extent::all(&[], comm);
        let mut new = Self {
            bisection,
            local: Local::default(),
            ghosts: Ghosts::build::<D>(&[], &extents, (words, &Periods::OPEN), comm).0,
            watch: Watch::build(&space.lattice, &[], &extents, comm),
            migrated: 0,
            space,
            handles,
            sites: Vec::new(),
        };
        new.rebuild_from_build_positions(columns, list_radius, comm);
        new
    }

    /// New planes for the costs of owned particles; they take effect at the next build. Collective.
    pub fn bisect(&mut self, columns: &Columns, costs: &[u32], comm: &Comm) {
        self.bisection = Bisection::new(columns.numbers(self.handles.position.index), costs, comm.size(), comm);
    }

    /// Brings every particle to its owner and finds the ghosts, all on `build_position`: after a restart, what stood before
    /// the checkpoint. Neighbour lists are to be made from `local` afterwards. Collective.
    pub fn rebuild_from_build_positions(
        &mut self,
        columns: &mut Columns,
        list_radius: &dyn Fn(&Columns, usize) -> f64,
        comm: &Comm,
    ) {
        self.migrated = migrate(columns, self.handles.build_position, &self.bisection, comm);
        self.sort(columns, list_radius);
        let extents = Extent::all(&self.sites, comm);
        let (ghosts, incoming) = Ghosts::build(&self.sites, &extents, (self.ghosts.words, &self.space.periods), comm);
        self.ghosts = ghosts;
        self.local.build(&self.space.lattice, &self.sites, &incoming);
        self.watch = Watch::build(&self.space.lattice, &self.sites, &extents, comm);
        self.sites = Vec::new();
    }

    /// Brings columns and sites into canonical order.
    fn sort(&mut self, columns: &mut Columns, list_radius: &dyn Fn(&Columns, usize) -> f64) {
        let positions = columns.numbers(self.handles.build_position.index).as_chunks::<D>().0;
        let site = |i: usize| {
            let id = columns.get(self.handles.id, i).0;
            Site { id, position: positions[i], radius: list_radius(columns, i) }
        };
        let mut order: Vec<(Place, u32)> =
            (0..columns.len()).map(|i| (self.space.lattice.place(&site(i)), i as u32)).collect();
        sort_nearly_sorted(&mut order, |(place, _)| *place);
        self.sites.reserve_exact(order.len());
        self.sites.extend(order.iter().map(|(_, i)| site(*i as usize)));
        let order: Vec<u32> = order.iter().map(|(_, i)| *i).collect();
        columns.reorder(&order, &mut Vec::new());
    }
}
