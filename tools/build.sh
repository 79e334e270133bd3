#!/usr/bin/env bash
# Configures and builds one preset of CMakePresets.json; programs land in build/PRESET/bin.
# Usage: tools/build.sh [PRESET] [CMAKE_CONFIGURE_ARGUMENT...] [-- CMAKE_BUILD_ARGUMENT...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=release
if (($#)) && [[ $1 != -* ]]; then
    preset=$1
    shift
fi
configure_arguments=()
while (($#)) && [[ $1 != -- ]]; do
    configure_arguments+=("$1")
    shift
done
if (($#)); then shift; fi # the --

if command -v ccache >/dev/null; then
    # In the environment it applies to a fresh build folder only, so a choice made there by hand stays.
    export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
    # Paths relative to the checkout, so that checkouts share results.
    export CCACHE_BASEDIR=${CCACHE_BASEDIR-$PWD}
    # Without these, ccache passes over every file that uses a precompiled header.
    export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS-pch_defines,time_macros}
fi

cmake --preset "$preset" "${configure_arguments[@]}"
cmake --build --preset "$preset" "$@"
