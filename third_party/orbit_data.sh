#!/usr/bin/env bash
# Provides the Earth of the scene `orbit`: NASA's Blue Marble (4096x2048) and its topography (2048x1024, 8 bits of 25 m).
# They are in the npm package three-globe (MIT licence; the pictures themselves are NASA's, free of copyright).
#
# Fetches that one package by name and version through npm, without the packages that it depends on. Keeps two of its files
# in .cache/orbit-data, where the build looks for them. Run again it does nothing. `--present` only tells, by its exit
# status, whether they are there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

package=three-globe@2.45.2
unpacked=.cache/orbit-data

fail() {
    echo "third_party/orbit_data.sh: the Earth of the scene orbit is missing: $1" >&2
    exit 1
}

pinned() { # FOLDER: holds exactly the pinned files
    (cd "$1" 2>/dev/null && sha256sum --check --status) <<SUMS
228deba2e4b600146bdcb6cfa359b8ead6aacc2b1c13550a29cd82824cfa1c01  earth-blue-marble.jpg
839b12da2e4dd346b256cebae72e10c479a102c8980a22084c41275e4b9a0e12  earth-topology.png
SUMS
}

if pinned "$unpacked"; then exit 0; fi
if [[ ${1-} == --present ]]; then exit 1; fi
command -v npm >/dev/null || fail "npm is not installed"

mkdir -p .cache
scratch=$(mktemp -d .cache/orbit-data.XXXXXX)
trap 'rm -rf "$scratch"' EXIT
echo "third_party/orbit_data.sh: fetching $package into $unpacked (13 MB, of which 2 MB stay)"
npm pack "$package" --ignore-scripts --pack-destination "$scratch" --loglevel=error >"$scratch/log" 2>&1 </dev/null ||
    { cat "$scratch/log" >&2 && fail "npm did not deliver $package"; }
tar --extract --gzip --file "$scratch"/three-globe-*.tgz --directory "$scratch" --strip-components=3 \
    package/example/img/earth-blue-marble.jpg package/example/img/earth-topology.png
mkdir "$scratch/files"
mv "$scratch/earth-blue-marble.jpg" "$scratch/earth-topology.png" "$scratch/files"
pinned "$scratch/files" || fail "what npm delivered is not the pinned $package"
rm -rf "$unpacked"
mv "$scratch/files" "$unpacked"
