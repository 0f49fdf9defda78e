//! All that changes when lists are built: owners, the order of particles, ghosts, the local set, the watch. Everything follows
//! from `build_position` and the list radii at the build, never from where particles are now: a run that is resumed from
//! them, on any number of ranks, gets the same lists.

use super::bisection::Bisection;
use super::comm::Comm;
use super::ghosts::{Ghosts, Territory};
use super::migration::migrate;
use super::watch::Watch;
use crate::math::Vec3;
use rayon::prelude::*;

use crate::particles::chunk::CHUNK;
use crate::particles::order::Reordering;
use crate::particles::{Column, Columns, Lattice, Local, ParticleId, Periods, Place, Site, large_pages};

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
}

/// List radius of an owned particle, m.
pub type ListRadius<'a> = &'a (dyn Fn(&Columns, usize) -> f64 + Sync);

/// The cells of a run and the periods of its axes.
#[derive(Debug, Clone, Copy)]
pub struct Space {
    pub lattice: Lattice,
    pub periods: Periods,
}

/// What a decomposition rests on, the same for the whole run.
#[derive(Debug, Clone, Copy)]
pub struct Basis {
    pub handles: Handles,
    pub space: Space,
    /// Numbers of a pair record.
    pub words: usize,
}

impl<const D: usize> Decomposition<D> {
    /// Distributes particles that may be on any ranks, and builds on their `build_position`. `space`: the same for the whole
    /// run; `list_radius`: of an owned particle at its list build, m; `words`: numbers of a pair record. Collective.
    pub fn new(columns: &mut Columns, basis: Basis, list_radius: ListRadius, comm: &Comm) -> Self {
        let Basis { handles, space, words } = basis;
        let costs = vec![1; columns.len()];
        let bisection = Bisection::new(columns.numbers(handles.build_position.index), &costs, comm.size(), comm);
        let territories = Territory::all(&[], &space.lattice, comm);
        let mut new = Self {
            bisection,
            local: Local::default(),
            ghosts: Ghosts::build::<D>(&[], &territories, words, &Periods::OPEN, comm).0,
            watch: Watch::build(&space.lattice, &[], &territories, comm),
            migrated: 0,
            space,
            handles,
        };
        new.rebuild_from_build_positions(columns, list_radius, comm);
        new
    }

    /// New planes for the costs of owned particles; they take effect at the next build. Collective.
    pub fn bisect(&mut self, columns: &Columns, costs: &[u32], comm: &Comm) {
        self.bisection = Bisection::new(columns.numbers(self.handles.position.index), costs, comm.size(), comm);
    }

    /// Brings every particle to its owner and finds the ghosts, all on `build_position`: after a restart, the state before
    /// the checkpoint. Neighbour lists are to be made from `local` afterwards. Collective.
    pub fn rebuild_from_build_positions(&mut self, columns: &mut Columns, list_radius: ListRadius, comm: &Comm) {
        self.migrated = migrate(columns, self.handles.build_position, &self.bisection, comm);
        self.watch.forget();
        let places = self.sort(columns, list_radius);
        let mut sites = large_pages::with_capacity(columns.len());
        self.each(columns, list_radius, |site| site).collect_into_vec(&mut sites);
        let territories = Territory::all(&sites, &self.space.lattice, comm);
        let (ghosts, incoming) = Ghosts::build(&sites, &territories, self.ghosts.words, &self.space.periods, comm);
        self.ghosts = ghosts;
        self.local.build_placed(&self.space.lattice, &sites, places, &incoming);
        let radii = sites.iter().map(|site| site.radius).collect();
        drop(sites);
        let places = self.local.slot_of_owned.iter().map(|&slot| self.local.places[slot as usize]);
        self.watch = Watch::build_placed(&self.space.lattice, radii, places, &territories, comm);
    }

    /// Brings columns into canonical order and returns the places of the particles.
    fn sort(&self, columns: &mut Columns, list_radius: ListRadius) -> Vec<Place> {
        let mut places = large_pages::with_capacity(columns.len());
        let lattice = self.space.lattice;
        self.each(columns, list_radius, move |site| lattice.place(&site)).collect_into_vec(&mut places);
        let reordering = Reordering::sorting(&places);
        columns.rearrange(&reordering);
        reordering.apply(&mut places, 1);
        places
    }

    /// Applies a function to each owned particle as the neighbour search sees it.
    fn each<'a, T: Send>(
        &self,
        columns: &'a Columns,
        list_radius: ListRadius<'a>,
        make: impl Fn(Site<D>) -> T + Sync + Send + 'a,
    ) -> impl IndexedParallelIterator<Item = T> + 'a {
        let ids = self.handles.id;
        let positions = columns.numbers(self.handles.build_position.index).as_chunks::<D>().0;
        let site = move |(i, position): (usize, &[f64; D])| Site {
            id: columns.get(ids, i).0,
            position: *position,
            radius: list_radius(columns, i),
        };
        positions.par_iter().with_min_len(CHUNK).enumerate().map(move |numbered| make(site(numbered)))
    }
}
