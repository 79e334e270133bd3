#!/usr/bin/env bash
# Probes one view distance per task of a Slurm array: tasks start as nodes become free, and need no MPI.
# Usage: sbatch --array=0-8 tools/slurm/sweep.sh FOLDER [OPTION_OF_PROBE...]
# Task N probes 10^N units into FOLDER/probe_N.json. A task that failed is run again by its number. CDR names the program.
#SBATCH --job-name=cdr-sweep
#SBATCH --time=01:00:00
set -euo pipefail

if (($# < 1)) || [[ -z ${SLURM_ARRAY_TASK_ID-} ]]; then
    echo "usage: sbatch --array=0-8 tools/slurm/sweep.sh FOLDER [OPTION_OF_PROBE...]" >&2
    exit 2
fi
folder=$1
shift
mkdir --parents "$folder"
exec "${CDR:-build/release/bin/cdr}" probe --distances "1e$SLURM_ARRAY_TASK_ID" \
    --json "$folder/probe_$SLURM_ARRAY_TASK_ID.json" "$@"
