#!/bin/bash
# One task of a campaign, submitted by cluster/campaign: line N of the TABLE in OUT belongs to task N, and its run to OUT/N.
# A line holds a name and options of sph-mpi, as in a shell: `r10 --set target.radius='10 km'`. Tasks requeue themselves as
# chains do.
#SBATCH --job-name=sph-mpi-task
#SBATCH --nodes=1
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
set -u
[ $# -gt 1 ] || { echo "usage: cluster/campaign TABLE SCENE OUT [OPTION of sbatch...]" >&2; exit 2; }
source cluster/launch

out=$1 scene=$2
line=$(sed -n "${SLURM_ARRAY_TASK_ID}p" "$out/table.txt")
eval "set -- $line"
echo "task $SLURM_ARRAY_TASK_ID: $line"
run_or_requeue "$out/$SLURM_ARRAY_TASK_ID" "$scene" "${@:2}"
