#[global_allocator]
static ALLOCATOR: sph_mpi::process::memory::Allocator = sph_mpi::process::memory::Allocator;

fn main() {
    std::process::exit(sph_mpi::program::main());
}
