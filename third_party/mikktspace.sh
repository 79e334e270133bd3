#!/usr/bin/env bash
# Provides MikkTSpace, the tangents that glTF asks for, as C source. The npm package mikktspace (MIT licence) is a WebAssembly
# module made from the crate of that name. The program wasm2c of the npm package wabt (Apache 2.0) translates it.
#
# Fetches the two packages by name and version through npm, without install scripts. Keeps the C source in .cache/mikktspace,
# where the build looks for it. Run again it does nothing. `--present` only tells, by its exit status, whether it is there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

package=mikktspace@1.1.1
translator=wabt@1.0.39
unpacked=.cache/mikktspace

fail() {
    echo "third_party/mikktspace.sh: MikkTSpace is missing: $1" >&2
    exit 1
}

fetched() { # FOLDER: holds exactly the pinned packages
    (cd "$1" && sha256sum --check --status) <<SUMS
0b44ece7524686fe041358517cebf9f2078b2d270e2c41a6bba2c45b2482f909  mikktspace-1.1.1.tgz
a10d4f4b15b91de8ab2ccb4700ef12185736f0bc96ee809e53ab17f7ea743fd2  wabt-1.0.39.tgz
SUMS
}

translated() { # FOLDER: holds exactly the pinned C source
    (cd "$1" 2>/dev/null && sha256sum --check --status) <<SUMS
1a0c39de150276bc40cb26acdf1c17604d1259b4ecc037231a619948e8301cee  mikktspace.c
01e3dcfe91f1d0747fb123112bb16af82c07d81dd9f9b36cc081c0072a396ade  mikktspace.h
SUMS
}

if translated "$unpacked"; then exit 0; fi
if [[ ${1-} == --present ]]; then exit 1; fi
command -v npm >/dev/null || fail "npm is not installed"
command -v node >/dev/null || fail "node is not installed"

mkdir -p .cache
scratch=$(mktemp -d .cache/mikktspace.XXXXXX)
trap 'rm -rf "$scratch"' EXIT
echo "third_party/mikktspace.sh: fetching $package and $translator into $unpacked (2 MB, of which 1 MB stays)"
npm pack "$package" "$translator" --ignore-scripts --pack-destination "$scratch" --loglevel=error >"$scratch/log" 2>&1 \
    </dev/null || { cat "$scratch/log" >&2 && fail "npm did not deliver $package and $translator"; }
fetched "$scratch" || fail "what npm delivered is not the pinned $package and $translator"
for archive in mikktspace-1.1.1 wabt-1.0.39; do
    mkdir "$scratch/$archive"
    tar --extract --gzip --file "$scratch/$archive.tgz" --directory "$scratch/$archive" --strip-components=1
done
mkdir "$scratch/files"
node "$scratch/wabt-1.0.39/bin/wasm2c" "$scratch/mikktspace-1.1.1/dist/main/mikktspace_main_bg.wasm" \
    --module-name mikktspace --output "$scratch/files/mikktspace.c" || fail "wasm2c did not translate it"
translated "$scratch/files" || fail "what wasm2c made is not the pinned C source"
rm -rf "$unpacked"
mv "$scratch/files" "$unpacked"
