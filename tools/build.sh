#!/usr/bin/env bash
# Configures and builds one preset of CMakePresets.json; programs land in build/PRESET/bin.
# Usage: tools/build.sh [--in-batches] [PRESET] [CMAKE_CONFIGURE_ARGUMENT...] [-- CMAKE_BUILD_ARGUMENT...]
# --in-batches compiles many sources at once in a new build folder. A whole build is then fastest, but a build after an edit
# is slow. A build folder that is there keeps what it was configured with.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

configure_arguments=()
in_batches=false
if [[ ${1-} == --in-batches ]]; then
    in_batches=true
    shift
fi
preset=release
if (($#)) && [[ $1 != -* ]]; then
    preset=$1
    shift
fi
if [[ $preset == asan && $PWD == *[[:space:]:]* ]]; then
    echo "tools/build.sh: asan's tests preload a library, which LD_PRELOAD cannot name in a folder with a blank or colon: $PWD" >&2
    exit 2
fi
if $in_batches && [[ ! -e build/$preset/CMakeCache.txt ]]; then configure_arguments+=(-DCDR_UNITY_BUILD=ON); fi
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
    # By preprocessed text, ccache takes headers that differ in comments alone for equal. A precompiled header is not: GCC knows
    # by its bytes that a file is in there already (#pragma once), and includes it again. Hence by files alone, and without the
    # results of before.
    export CCACHE_DEPEND=${CCACHE_DEPEND-true}
    export CCACHE_NAMESPACE=${CCACHE_NAMESPACE-cdr-by-files}
fi

cmake --preset "$preset" "${configure_arguments[@]}"
cmake --build --preset "$preset" "$@"
