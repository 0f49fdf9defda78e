#!/bin/bash
# How a scene scales: sbatch [OPTION...] cluster/scaling.sh OUT SCENE [OPTION...], from the folder that holds cluster/. In one
# job, one run after the other: STRONG particles on more and more ranks, WEAK particles on each of them, and STRONG particles in
# other LAYOUTS of ranks x threads on one node. For each run --check predicts first what it will cost.
# What OUT holds already is not run again. `cluster/scaling.py OUT` makes tables and curves of it.
#SBATCH --job-name=sph-mpi-scaling
#SBATCH --nodes=1
#SBATCH --exclusive
#SBATCH --ntasks-per-node=2
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --no-requeue
#SBATCH --output=%x_%j.log
set -u
[ $# -gt 1 ] || { echo "usage: sbatch cluster/scaling.sh OUT SCENE [OPTION...]" >&2; exit 2; }
source cluster/launch
STRONG=${STRONG:-100000}
WEAK=${WEAK:-50000}
STEPS=${STEPS:-100}
PARTICLES=${PARTICLES:-target.particles}     # the key that says how many
LAYOUTS=${LAYOUTS-}                          # for example "1x1 2x1 1x2"
if [ -z "${COUNTS+given}" ]; then
    COUNTS=1
    for ((n = 2; n <= SLURM_NTASKS; n *= 2)); do COUNTS+=" $n"; done
fi
out=$1
shift
set -- "$@" --set run.steps="$STEPS" --set output.snapshots=0 --set output.picture=false

# one NAME RANKS THREADS PARTICLES SCENE [OPTION...]
one() {
    local run=$out/$1
    [ ! -e "$run/summary.json" ] || return 0
    mkdir -p "$run"
    echo "$1: $2 ranks x $3 threads, $4 particles" >&2
    RANKS=$2 THREADS=1 run_once "${@:5}" --set "$PARTICLES=$4" --check >"$run.check" || return
    RANKS=$2 THREADS=$3 run_once "${@:5}" --set "$PARTICLES=$4" --quiet --out "$run"
}

for n in $COUNTS; do
    one "strong_$n" "$n" 1 "$STRONG" "$@" || exit
    one "weak_$n" "$n" 1 $((WEAK * n)) "$@" || exit
done
for layout in $LAYOUTS; do
    one "${LAUNCHER}_$layout" "${layout%x*}" "${layout#*x}" "$STRONG" "$@" || exit
done
