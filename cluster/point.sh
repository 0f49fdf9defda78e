#!/bin/bash
# One point of a study, submitted by cluster/study: point N is task N, and its run goes to OUT/point_N. Tasks requeue themselves
# as chains do.
#SBATCH --job-name=sph-mpi-point
#SBATCH --nodes=1
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
[ $# -gt 1 ] || { echo "usage: cluster/study STUDY OUT [OPTION of sbatch...]" >&2; exit 2; }
source cluster/launch

run_or_requeue "$1" "$2" --task "$SLURM_ARRAY_TASK_ID"
