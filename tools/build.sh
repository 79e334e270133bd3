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

# The environment sets the launcher of a fresh build folder only, so a choice made there by hand stays.
if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER-ccache}
fi

cmake --preset "$preset" "${configure_arguments[@]}"
cmake --build --preset "$preset" "$@"
