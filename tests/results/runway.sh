#!/usr/bin/env bash
# Makes runway.png, the picture at the top of the README: the runway's number from orbit, standard beside anchored.
# The shares below the pictures are those that `cdr orbit` measures while it draws them. Needs ffmpeg, node and DejaVu Sans.
# Usage: tests/results/runway.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=${1-build/release/bin/cdr}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

"$program" --quiet orbit --frames 2 --techniques standard,anchored --out "$folder" --json "$folder/orbit.json"

# label TECHNIQUE: writes the line below that technique's picture of the last frame.
label() {
    node -e '
        const [file, technique] = process.argv.slice(1);
        const rows = JSON.parse(require("fs").readFileSync(file)).results;
        const row = rows.filter((each) => each.technique === technique).at(-1);
        console.log(`${technique} depth: ${Number((100 * row.wrong_fraction).toPrecision(3))} % of the pixels wrong`);
    ' "$folder/orbit.json" "$1" >"$folder/$1.txt"
}
label standard
label anchored

# panel INPUT TECHNIQUE: half size, with the line below.
panel() {
    echo "[$1]scale=640:360:flags=area,pad=640:404:0:0:0x101216,drawtext=textfile=$folder/$2.txt:expansion=none:\
font=DejaVu Sans:fontsize=22:fontcolor=white:x=(w-text_w)/2:y=360+(44-text_h)/2[$2]"
}
ffmpeg -v error -y -i "$folder/orbit_standard.png" -i "$folder/orbit_anchored.png" -filter_complex \
    "$(panel 0 standard);$(panel 1 anchored);[standard]pad=644:404:0:0:0x101216[left];[left][anchored]hstack" \
    -frames:v 1 -map_metadata -1 -fflags +bitexact -flags +bitexact tests/results/runway.png
