#!/usr/bin/env bash
# Renders the pictures of tests/golden/list.txt anew and says how they differ from the golden ones. The renders go to
# build/golden/, and beside each a sheet of old, new and ten times their difference. Nothing is replaced unless asked for.
# Usage: tools/approve_golden.sh [--approve NAME...|--approve-all]
# Exit status: 0 all are the same or were approved, 1 some differ, 2 bad usage.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
    echo "usage: tools/approve_golden.sh [--approve NAME...|--approve-all]" >&2
    exit 2
}

approve_all=false
approved=()
case ${1-} in
    "") ;;
    --approve-all)
        (($# == 1)) || usage
        approve_all=true
        ;;
    --approve)
        shift
        (($#)) || usage
        approved=("$@")
        ;;
    *) usage ;;
esac

golden=tests/golden
for name in "${approved[@]}"; do
    grep -qE "^$name +" "$golden/list.txt" || {
        echo "tools/approve_golden.sh: no picture is called '$name' in $golden/list.txt" >&2
        exit 2
    }
done

bin=build/release/bin
tools/build.sh release -- --target cdr golden_compare >&2 # those that lie there may be older than the sources
out=build/golden
mkdir -p "$out"
assets=${CDR_ASSETS_DIR:-../shared/assets}
differing=0
while read -r name scene arguments; do
    [[ -n $name && $name != \#* ]] || continue
    case $scene in
        ASSETS/*)
            scene=$assets/${scene#ASSETS/}
            if [[ ! -e $scene ]]; then
                echo "$name: skipped, $scene is absent"
                continue
            fi
            ;;
        *.gltf | *.glb) scene=$golden/$scene ;;
    esac
    # The list's arguments are words, on purpose.
    # shellcheck disable=SC2086
    "$bin/cdr" --quiet render "$scene" $arguments --size 320x180 -o "$out/$name.png" </dev/null
    if [[ -e $golden/$name.png ]]; then
        verdict="the same"
        said=$("$bin/golden_compare" "$golden/$name.png" "$out/$name.png" "$out/${name}_sheet.png" 2>&1) || verdict=DIFFERS
        said="$said; see $out/${name}_sheet.png"
    else
        verdict=DIFFERS
        said="there is no golden one yet; see $out/$name.png"
    fi
    if $approve_all || [[ " ${approved[*]-} " == *" $name "* ]]; then
        cp "$out/$name.png" "$golden/.$name.png.new"
        mv "$golden/.$name.png.new" "$golden/$name.png"
        verdict="$verdict, approved"
    elif [[ $verdict == DIFFERS ]]; then
        differing=$((differing + 1))
    fi
    echo "$name: $verdict: $said"
done <"$golden/list.txt"

if ((differing)); then
    echo "$differing differ; look at them, then tools/approve_golden.sh --approve NAME..." >&2
    exit 1
fi
