//! Between two list builds a step allocates nothing.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use sph_mpi::domain::comm::Comm;
use sph_mpi::scene::Scene;
use sph_mpi::simulation::setup;
use sph_mpi::step::{Stepper, workers};

use crate::common::{IMPACT, ranks};

/// Counts for each thread: others of the test harness may allocate as they like.
struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

fn count() {
    // A thread that is about to end has no counter any more.
    let _ = ALLOCATIONS.try_with(|n| n.set(n.get() + 1));
}

// SAFETY: hands everything on to the system's allocator.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: as promised by the caller.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: as promised by the caller.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: as promised by the caller.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// Steps the impact, and reports steps with their allocations, those apart in which lists were built.
fn allocations_of_steps(comm: &Comm) -> Vec<(u64, u64)> {
    workers::start_threads(1).expect("one thread");
    let scene = Scene::parse("impact.toml", IMPACT, &[]).expect("a scene");
    let counts = setup::count_particles(&scene, comm).expect("particles");
    let plan = setup::plan(&scene, counts).expect("a plan");
    let (columns, settings) = plan.populate(&scene, comm).expect("a scene without modes");
    let mut stepper = Stepper::<3>::new(comm, columns, settings);
    stepper.start().expect("a first evaluation");
    let mut dt = stepper.state.next;
    let mut found = Vec::new();
    for step in 0..100 {
        let (builds, before) = (stepper.counters.list_builds, ALLOCATIONS.get());
        dt = stepper.step(dt, stepper.state.time + dt, 0).expect("a step").dt;
        let allocated = ALLOCATIONS.get() - before;
        if stepper.counters.list_builds == builds {
            found.push((step, allocated));
        } else {
            assert!(allocated > 0, "a list build allocates, and is not seen to");
        }
    }
    found
}

#[test]
fn steps_between_list_builds_allocate_nothing() {
    ranks(2, "allocations::steps_between_list_builds_allocate_nothing", |comm| {
        let found = allocations_of_steps(comm);
        assert!((50..100).contains(&found.len()), "{} of 100 steps kept their lists", found.len());
        let guilty: Vec<_> = found.iter().filter(|(_, allocations)| *allocations > 0).collect();
        assert!(guilty.is_empty(), "(step, allocations): {guilty:?}");
    });
}
