#[global_allocator]
static ALLOCATOR: sph_mpi::simulation::memory::Allocator = sph_mpi::simulation::memory::Allocator;

fn main() {
    std::process::exit(sph_mpi::program::main());
}
