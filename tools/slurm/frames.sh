#!/usr/bin/env bash
# Renders frames on several nodes: one job of Slurm, whose ranks share the frames.
# Usage: sbatch --nodes=4 --ntasks-per-node=1 tools/slurm/frames.sh SCENE OUTPUT [OPTION_OF_RENDER...]
# such as: sbatch --nodes=4 tools/slurm/frames.sh afc frames/%04d.png --frames 360 --technique anchored
# All nodes see the same files. Where a node has several graphics cards, give it as many tasks: each takes one. CDR names
# the program, MPIRUN the launcher.
#SBATCH --job-name=cdr-frames
#SBATCH --ntasks-per-node=1
#SBATCH --exclusive
#SBATCH --time=04:00:00
set -euo pipefail

if (($# < 2)); then
    echo "usage: tools/slurm/frames.sh SCENE OUTPUT [OPTION_OF_RENDER...]" >&2
    exit 2
fi
scene=$1
output=$2
shift 2
mkdir --parents "$(dirname "$output")"
# The launcher reads from Slurm which nodes the job has.
exec "${MPIRUN:-mpirun}" "${CDR:-build/release/bin/cdr}" --device each render "$scene" -o "$output" "$@"
