#!/usr/bin/env bash
# Starts a Slurm of one node for the caller alone, and runs both jobs of this folder on it. Compares what they write with what
# one process writes, byte for byte. It needs no root and leaves no processes; its files lie in one temporary folder.
# Usage: tools/slurm/try.sh
# Needs slurm-wlm and munge; where they are missing or do not start it says so and ends with 77. CDR names the program.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly cannot=77
PATH=$PATH:/usr/sbin # daemons of a distribution are there
program=$(realpath "${CDR:-build/release/bin/cdr}")
jobs=$PWD/tools/slurm
folder=$(mktemp --directory "${TMPDIR:-/tmp}/cdr-slurm.XXXXXX")
export SLURM_CONF=$folder/slurm.conf

give_up() { # WHY
    echo "tools/slurm/try.sh: the jobs were not run: $1" >&2
    exit "$cannot"
}

fail() { # WHY
    echo "tools/slurm/try.sh: $1" >&2
    tail --lines=20 "$folder"/*.out "$folder"/*.log >&2 || true
    exit 1
}

daemons=()
# The daemons stay in the foreground as children of this shell, so that ending and waiting need no files of numbers.
stop() {
    local status=$?
    if ((status != 0 && status != cannot)); then # a job that was given up may still run: the last one runs alone
        timeout 60 scancel --user="$(id --user --name)" || true
        timeout 60 sbatch --quiet --wait --exclusive --output=/dev/null --wrap true || true
    fi
    if ((${#daemons[@]})); then
        kill "${daemons[@]}" 2>/dev/null || true
        wait "${daemons[@]}" 2>/dev/null || true
    fi
    rm --recursive --force "$folder"
    exit "$status"
}
trap stop EXIT
trap "exit 1" INT TERM HUP

start() { # NAME COMMAND...
    "${@:2}" >"$folder/$1.log" 2>&1 &
    daemons+=($!)
}

free_ports() { # COUNT
    awk -v count="$1" 'NR > 1 { split($2, at, ":"); taken[at[2]] = 1 }
        END { for (port = 27000; count > 0; ++port)
                  if (!(sprintf("%04X", port) in taken)) { print port; --count } }' /proc/net/tcp
}

write_configuration() {
    local host user ports
    host=$(hostname --short)
    user=$(id --user --name)
    mapfile -t ports < <(free_ports 2)
    cat >"$SLURM_CONF" <<END
ClusterName=cdr
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
}

start_slurm() {
    local each
    for each in munged slurmctld slurmd sbatch; do
        command -v "$each" >/dev/null || give_up "$each is missing (apt: slurm-wlm munge)"
    done
    mkdir "$folder/state" "$folder/spool"
    (umask 077 && head --bytes=1024 /dev/urandom >"$folder/munge.key")
    start munged munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
        --pid-file="$folder/munged.pid" --seed-file="$folder/munge.seed" --log-file="$folder/munged.log"
    write_configuration
    start slurmctld slurmctld -D
    start slurmd slurmd -D -N "$(hostname --short)"
    # Clients wait for the controller, and a job waits for its node.
    timeout 60 sbatch --quiet --wait --output="$folder/first.out" --wrap true 2>"$folder/sbatch.log" ||
        give_up "Slurm does not start here: $(tail --quiet --lines=1 "$folder"/{sbatch,munged,slurmctld,slurmd}.log |
            paste --serial --delimiters='|')"
}

submit() { # OPTION_OF_SBATCH... SCRIPT ARGUMENT...
    timeout 600 sbatch --quiet --wait --output="$folder/job_%j.out" "$@" || fail "a job failed: $*"
}

# Of JSON all but the times.
expect_same() { # FOLDER FOLDER
    find "$1" "$2" -name '*.json' -exec sed --in-place --regexp-extended '/^ *"[a-z_]+_ms": /d' {} +
    diff --recursive --brief "$1" "$2" || fail "a job's files are not those of one process"
}

start_slurm
mkdir "$folder/jobs" "$folder/alone"
export CDR=$program OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

probe=(--size 64x36 --techniques reversed,anchored)
submit --chdir="$folder/jobs" --array=0-3 "$jobs/sweep.sh" sweep "${probe[@]}"
for power in 0 1 2 3; do
    (cd "$folder/alone" && SLURM_ARRAY_TASK_ID=$power "$jobs/sweep.sh" sweep "${probe[@]}") >/dev/null
done
expect_same "$folder/jobs/sweep" "$folder/alone/sweep"

render=(--size 64x36 --frames 8 --technique anchored --json frames/all.json)
submit --chdir="$folder/jobs" --ntasks-per-node=2 "$jobs/frames.sh" afc frames/%02d.png "${render[@]}"
grep --quiet '^2 ranks, 2 of them on this machine' "$folder/job_"*.out || fail "the job did not run as two ranks"
mkdir "$folder/alone/frames"
(cd "$folder/alone" && "$program" --device each render afc -o frames/%02d.png "${render[@]}") >/dev/null
expect_same "$folder/jobs/frames" "$folder/alone/frames"

echo "Slurm $(sbatch --version | cut --delimiter=' ' --fields=2): $(find "$folder/jobs" -type f | wc --lines) files" \
    "of an array job and of a job of two ranks are those of one process"
