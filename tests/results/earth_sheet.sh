#!/usr/bin/env bash
# Makes earth_sheet.jpg: three pictures of the way from the station down to the airport, in the scene `earth`. Needs ffmpeg.
# Usage: tests/results/earth_sheet.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

program=${1-build/release/bin/cdr}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

for frame in 0 92 134; do
    "$program" --quiet render earth --technique anchored --shadows anchored --frame "$frame" -o "$folder/$frame.png"
done
small=scale=640:360:flags=area
ffmpeg -v error -y -i "$folder/0.png" -i "$folder/92.png" -i "$folder/134.png" -filter_complex \
    "[0]$small,pad=644:360:0:0[a];[1]$small,pad=644:360:0:0[b];[2]$small[c];[a][b][c]hstack=3" \
    -frames:v 1 -q:v 4 -map_metadata -1 -fflags +bitexact -flags +bitexact tests/results/earth_sheet.jpg
