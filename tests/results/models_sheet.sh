#!/usr/bin/env bash
# Makes models_sheet.jpg and models_sheet_more.jpg, and prints the FLIP tables of tests/results/README.md and models.md. It draws
# each model with base colour alone, with all of its materials, and as the float64 reference. FLIP is between the last two.
# Takes a few minutes. Needs ffmpeg. Larger models, of which tests/assets/README.md says where they are, come first. Most of the
# second sheet are of Debian's package assimp-testmodels (BSD-3-Clause). Where it is not installed, apt downloads it (21 MB) into
# a folder that is removed at the end. Without network or apt the sheet is made without them.
# Usage: tests/results/models_sheet.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=${1-build/release/bin/cdr}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

packaged=/usr/share/assimp/models/glTF2
if [[ ! -d $packaged ]]; then
    echo "downloading the package assimp-testmodels, 21 MB, into a folder that is removed at the end" >&2
    mkdir "$folder/package"
    if (cd "$folder/package" && apt-get download -q assimp-testmodels && dpkg-deb -x assimp-testmodels_*.deb .) \
        >"$folder/apt.txt" 2>&1; then
        packaged=$folder/package/usr/share/assimp/models/glTF2
    else
        echo "that failed, so the sheet is without its models: $(tail -n 1 "$folder/apt.txt")" >&2
    fi
fi

# Adds to the list that its first argument names those of the other arguments that are there.
addThere() {
    local -n list=$1
    local model
    for model in "${@:2}"; do
        if [[ -e $model ]]; then
            list+=("$model")
        else
            echo "$model is not there, so the sheet is without it" >&2
        fi
    done
}

# Usage: draw FOLDER MODEL...
draw() {
    "$program" models "${@:2}" --threads 2 --time 0.8 --out "$1" 2>"$folder/notes.txt" || {
        cat "$folder/notes.txt" >&2
        exit 1
    }
}

assets=${CDR_ASSETS_DIR:-../shared/assets}
models=()
addThere models "$assets"/{flight_helmet/flight_helmet.gltf,cesium_man.glb,retro_ufo.glb} \
    tests/assets/{garden.glb,machine.glb,materials.glb,stage.glb,well.gltf}
more=(tests/assets/survey.glb)
addThere more "$packaged"/{2CylinderEngine-glTF-Binary/2CylinderEngine.glb,BoxTextured-glTF-Binary/BoxTextured.glb} \
    "$packaged"/{ClearCoat-glTF/ClearCoatTest,glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube}.gltf \
    "$packaged"/{cameras/Cameras,simple_skin/simple_skin,textureTransform/TextureTransformTest}.gltf
draw "$folder" "${models[@]}"
draw "$folder/more" "${more[@]}"
draw "$folder/lights" tests/assets/stage.glb --camera 0 --light file
exact=(-q:v 4 -map_metadata -1 -fflags +bitexact -flags +bitexact)
ffmpeg -v error -y -i "$folder/models_sheet.png" -i "$folder/lights/models_sheet.png" \
    -filter_complex "[1]crop=iw:ih-52:0:52[lights];[0][lights]vstack" "${exact[@]}" tests/results/models_sheet.jpg
ffmpeg -v error -y -i "$folder/more/models_sheet.png" "${exact[@]}" tests/results/models_sheet_more.jpg
