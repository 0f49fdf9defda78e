#!/bin/bash
# A run longer than a job may be: sbatch [OPTION...] cluster/chain.sh OUT SCENE [OPTION...], from the folder that holds cluster/.
# Two minutes before its time is up the run writes a checkpoint into OUT and the job puts itself back into the queue, until the
# run is done. The same for a job that was lost with its machine: it goes on from the newest checkpoint.
#SBATCH --job-name=sph-mpi-chain
#SBATCH --nodes=1
#SBATCH --ntasks-per-node=2
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=%x_%j.log
set -u
[ $# -gt 1 ] || { echo "usage: sbatch cluster/chain.sh OUT SCENE [OPTION...]" >&2; exit 2; }
source cluster/launch

run_or_requeue "$@"
