#!/bin/bash
# Builds sph-mpi where software comes as environment modules, and puts it into ~/.cargo/bin (or below ROOT): cluster/build.sh [MODULE...],
# from the project's folder, for example `cluster/build.sh gcc/13 openmpi/4.1 hdf5/1.14-parallel llvm/17`. Needed are a C compiler, an MPI
# with mpicc, the HDF5 that was built with that same MPI (h5pcc or HDF5_DIR names it), libclang (LIBCLANG_PATH, where it is not found) and a Rust
# toolchain of 1.89 or later; a login node with a network, or `cargo vendor` before. Batch jobs must load the same modules.
set -euo pipefail

fail() {
    echo "build: $*" >&2
    exit 2
}

if [ $# -gt 0 ]; then
    command -v module >/dev/null || type module >/dev/null 2>&1 || fail "there is no command \`module\` here (allowed: no arguments, and what is needed in PATH)"
    module load "$@"
fi
command -v cargo >/dev/null || fail "cargo is not there (allowed: a Rust toolchain from https://rustup.rs, or a module of it)"
command -v mpicc >/dev/null || fail "mpicc is not there (allowed: the module of an MPI)"
# The wrapper of a parallel HDF5 knows where it lies, and that it is parallel.
if [ -z "${HDF5_DIR:-}" ]; then
    command -v h5pcc >/dev/null || fail "there is no parallel HDF5: no h5pcc, no HDF5_DIR (allowed: the module of an HDF5 built with this MPI)"
    HDF5_DIR=$(h5pcc -showconfig | sed -n 's/.*Installation point: *//p')
fi
[ -f "$HDF5_DIR/include/H5pubconf.h" ] || fail "HDF5_DIR is $HDF5_DIR, where there is no include/H5pubconf.h (allowed: the folder that holds include/ and lib/ of HDF5)"
grep -q 'define H5_HAVE_PARALLEL 1' "$HDF5_DIR/include/H5pubconf.h" || fail "the HDF5 in $HDF5_DIR was built without MPI (allowed: one with --enable-parallel)"
export HDF5_DIR
cargo install --locked --path . ${ROOT:+--root "$ROOT"}
echo "build: installed; its MPI is $(command -v mpicc), its HDF5 $HDF5_DIR"
