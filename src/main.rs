fn main() {
    std::process::exit(sph_mpi::program::main());
}
