fn main() {
    std::process::exit(sph_mpi::cli::program::main());
}
