#!/usr/bin/env bash
# Measures a graphics card: what each technique draws wrong and costs there, and how recording scales. Takes about five minutes.
# Needs a release build. tests/results/nvidia_h200 has the files of one card.
# Usage: tests/results/graphics_card.sh FOLDER [OTHER_CDR]
#   FOLDER     where times.txt, pixels.txt, rivals.txt and the files of results go
#   OTHER_CDR  another build of cdr, whose frames are timed in turns with these
set -euo pipefail
if (($# == 0)); then
    sed -n 's/^# \(Usage: .*\)/\1/p' "${BASH_SOURCE[0]}" >&2
    exit 2
fi
folder=$(realpath --canonicalize-missing "$1")
other=${2:+$(realpath "$2")}
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

sizes=(480x270 640x360 800x450 1280x720 1366x768 1440x810 1920x1080)
ways=standard/visibility,standard/lit,standard/per-object,standard/push-constants,standard/primaries,standard/gpu-driven
ways+=,standard/in-plane,reversed,anchored,anchored/visibility,anchored/lit,anchored/gpu-driven,anchored/in-plane,cdr-5

cdr() { # ARGUMENT...
    echo "\$ cdr $*"
    build/release/bin/cdr "$@"
    echo
}

# Prints a table and keeps it, without the names of this machine's folders.
keep() { # NAME
    sed -e "s#$scratch#SCRATCH#g" -e "s#$folder#FOLDER#g" -e "s#${other:-OTHER_CDR}#OTHER_CDR#g" | tee "$folder/$1.txt"
}

measure_times() {
    cdr devices
    cdr timing --frames 1000 --csv "$folder/timing.csv"
    for threads in 1 8; do
        cdr timing --frames 500 --threads "$threads" --modes "$ways" --csv "$folder/ways_${threads}_threads.csv"
    done
    cdr timing --stages --modes reversed,anchored,cdr-5,standard/visibility,standard/gpu-driven
    cdr timing --scene city --frames 60 --threads 8 --modes \
        standard/occlusion-culling,standard/gpu-driven,standard/gpu-driven/occlusion-culling,anchored,anchored/occlusion-culling
    cdr scaling --draws 50000 --cascades 4 --threads 1,2,4,8,16 --csv "$folder/scaling.csv"
    build/release/bin/bench_stereo --benchmark_counters_tabular=true 2>/dev/null || echo "bench_stereo is not built"
    if [[ -n $other ]]; then cdr timing --frames 200 --against "$other" --json "$folder/against.json"; fi
}

measure_pixels() {
    for size in "${sizes[@]}"; do
        for snapping in by-device in-plane; do
            cdr pictures "${all[@]}" --scenes mixed --techniques reversed,anchored --frames 1 --size "$size" \
                --snapping "$snapping" --out "$scratch"
        done
    done
    cdr pictures "${all[@]}" --scenes mixed,cubes,afc --frames 1 --out "$scratch"
    cdr orbit "${all[@]}" --out "$scratch"
    cp "$scratch/contact_sheet.png" "$scratch/orbit_sheet.png" "$folder"
    cdr flicker "${all[@]}" --moved --flip-every 10
    cdr probe "${all[@]}"
    for scene in mixed afc orbit; do
        cdr render "${all[@]}" "$scene" --technique anchored --certify "$scratch/$scene.json" -o "$scratch/$scene.png"
    done
}

mkdir -p "$folder"
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
all=(--threads "$(nproc)")
measure_times | keep times
measure_pixels | keep pixels
cdr rivals "${all[@]}" --json "$folder/rivals.json" | keep rivals
