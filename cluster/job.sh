#!/bin/bash
# One run of sph-mpi: sbatch [OPTION...] cluster/job.sh SCENE [OPTION...], from the folder that holds cluster/.
#SBATCH --job-name=sph-mpi
#SBATCH --nodes=1
#SBATCH --ntasks-per-node=2
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --no-requeue
#SBATCH --output=%x_%j.log
set -u
[ $# -gt 0 ] || { echo "usage: sbatch cluster/job.sh SCENE [OPTION...]" >&2; exit 2; }
source cluster/launch

run_once "$@"
