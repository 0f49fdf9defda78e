#!/bin/bash
# One run of sph-mpi under Slurm: sbatch cluster/job.sh inputs/qd_star.toml [OPTION...]
# Two minutes before its time is up the run writes a checkpoint and the job puts itself back into the queue.
#SBATCH --job-name=sph-mpi
#SBATCH --nodes=1
#SBATCH --ntasks-per-node=2
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=%x_%j.log
set -uo pipefail

[ $# -gt 0 ] || { echo "usage: sbatch cluster/job.sh SCENE [OPTION...]" >&2; exit 2; }
[ "${SLURM_RESTART_COUNT:-0}" -eq 0 ] || set -- "$@" --resume

# srun where Slurm speaks OpenMPI's pmix, otherwise mpirun, which finds the job's nodes by itself.
if srun --mpi=list 2>&1 | grep -q pmix; then
    srun --mpi=pmix --cpus-per-task="${SLURM_CPUS_PER_TASK:-1}" --kill-on-bad-exit=1 sph-mpi "$@" &
    stop() { scancel --signal=USR1 "$SLURM_JOB_ID.0"; }
else
    mpirun --map-by "slot:PE=${SLURM_CPUS_PER_TASK:-1}" sph-mpi "$@" &
    stop() { kill -USR1 "$run"; }
fi
run=$!
trap stop USR1

# A signal ends the first `wait`, not the run; asked again, `wait` gives the run's own code.
wait "$run"
wait "$run"
code=$?
[ "$code" -ne 75 ] || scontrol requeue "$SLURM_JOB_ID"
exit "$code"
