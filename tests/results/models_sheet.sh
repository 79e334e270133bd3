#!/usr/bin/env bash
# Makes models_sheet.jpg and prints the FLIP table of tests/results/README.md. It draws each model with base colour alone, with
# all of its materials, and as the float64 reference. FLIP is between the last two. Takes a few minutes. Needs ffmpeg.
# Larger models, of which tests/assets/README.md says where they are, come first.
# Usage: tests/results/models_sheet.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=${1-build/release/bin/cdr}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

assets=${CDR_ASSETS_DIR:-../shared/assets}
models=()
for model in "$assets"/{flight_helmet/flight_helmet.gltf,cesium_man.glb,retro_ufo.glb} \
    tests/assets/{garden.glb,machine.glb,materials.glb,stage.glb,well.gltf}; do
    if [[ -e $model ]]; then
        models+=("$model")
    else
        echo "$model is not there, so the sheet is without it" >&2
    fi
done
"$program" models "${models[@]}" --threads 2 --time 0.8 --out "$folder" 2>"$folder/notes.txt" || {
    cat "$folder/notes.txt" >&2
    exit 1
}
"$program" models tests/assets/stage.glb --camera 0 --light file --time 0.8 --threads 2 --out "$folder/lights" 2>"$folder/notes.txt" || {
    cat "$folder/notes.txt" >&2
    exit 1
}
ffmpeg -v error -y -i "$folder/models_sheet.png" -i "$folder/lights/models_sheet.png" \
    -filter_complex "[1]crop=iw:ih-52:0:52[lights];[0][lights]vstack" -q:v 4 -map_metadata -1 \
    -fflags +bitexact -flags +bitexact tests/results/models_sheet.jpg
